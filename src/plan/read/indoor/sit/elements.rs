//! The elements of a file of OpenStreetMap that plans are made of.

use std::collections::{BTreeMap, BTreeSet};

use super::mapped::{Mapped, Shape, Tags, is_wanted};
use crate::document::Faults;
use crate::geometry::Point;
use crate::plan::read::indoor::remarks::Remarks;
use crate::plan::read::osm::{Body, Element, ElementKind, Elements, INCOMPLETE, Places, areas_of};

/// How often the nodes of all ways may be corners of multipolygons: a way bounds one or two rooms.
const MOST_SHARED: usize = 8;

/// An element before its nodes have places.
struct Head {
    id: i64,
    offset: u64,
    tags: Tags,
}

/// Elements of one file, by kind, in its order.
#[derive(Default)]
struct Collected {
    multipolygons: Vec<(Head, [Vec<i64>; 2])>,
    ways: Vec<(Head, Vec<i64>)>,
    /// Nodes of all ways that are wanted or that multipolygons are made of.
    nodes: BTreeMap<i64, Vec<i64>>,
    points: Vec<(Head, Point)>,
    places: Places,
}

/// The elements with tags that plans are made of; those without all of their corners are left out with a remark.
///
/// # Errors
/// Faults of the file.
pub(super) fn mapped(file: &dyn Elements, remarks: &mut Remarks) -> Result<Vec<Mapped>, Faults> {
    let collected = Collected::of(file)?;
    let mut mapped = Vec::new();
    collected.add_multipolygons(&mut mapped, remarks);
    for (Head { id, offset, tags }, nodes) in collected.ways {
        let id = format!("w{id}");
        match collected.places.of(&nodes) {
            Some(line) => mapped.push(Mapped { id, place: offset, tags, shape: Shape::Line(line) }),
            None => remarks.leave_out(offset, format!("way {}: {INCOMPLETE}", &id[1..])),
        }
    }
    let point = |(head, place): (Head, Point)| Mapped {
        id: format!("n{}", head.id),
        place: head.offset,
        tags: head.tags,
        shape: Shape::Point(place),
    };
    mapped.extend(collected.points.into_iter().map(point));
    Ok(mapped)
}

impl Collected {
    fn of(file: &dyn Elements) -> Result<Self, Faults> {
        let mut found = Self::default();
        file.each(ElementKind::Relation, &mut |element| found.add_relation(element))?;
        let polygons = found.multipolygons.iter().flat_map(|(_, rings)| rings.iter().flatten());
        let members: BTreeSet<i64> = polygons.copied().collect();
        file.each(ElementKind::Way, &mut |element| found.add_way(element, &members))?;
        found.places = Places::of_nodes(found.nodes.values().flatten().copied().collect());
        file.each(ElementKind::Node, &mut |element| found.add_node(element))?;
        Ok(found)
    }

    fn add_relation(&mut self, element: Element<'_>) {
        let is_area = element.tags.iter().any(|(key, value)| key == "type" && value == "multipolygon");
        if !is_area || !is_marked(&element) {
            return;
        }
        let (head, body) = split(element);
        let Body::Relation(members) = body else { return };
        let mut rings = [Vec::new(), Vec::new()];
        for member in members.iter().filter(|member| member.kind == ElementKind::Way) {
            match member.role.as_ref() {
                "outer" | "" => rings[0].push(member.id),
                "inner" => rings[1].push(member.id),
                _ => {}
            }
        }
        self.multipolygons.push((head, rings));
    }

    fn add_way(&mut self, element: Element<'_>, members: &BTreeSet<i64>) {
        let (is_marked, is_member) = (is_marked(&element), members.contains(&element.id));
        if !is_marked && !is_member {
            return;
        }
        let (head, body) = split(element);
        let Body::Way(nodes) = body else { return };
        self.nodes.insert(head.id, nodes.clone());
        if is_marked {
            self.ways.push((head, nodes));
        }
    }

    fn add_node(&mut self, element: Element<'_>) {
        let Body::Node(place) = element.body else { return };
        self.places.note(element.id, place);
        if is_marked(&element) {
            let (head, _) = split(element);
            self.points.push((head, place));
        }
    }

    fn add_multipolygons(&self, mapped: &mut Vec<Mapped>, remarks: &mut Remarks) {
        // A way of a thousand nodes in each of a million multipolygons would fill the memory.
        let mut corners_left = MOST_SHARED * self.nodes.values().map(Vec::len).sum::<usize>();
        for (Head { id, offset, tags }, [outer, inner]) in &self.multipolygons {
            let members = outer.iter().chain(inner);
            let corners: usize = members.filter_map(|way| self.nodes.get(way)).map(Vec::len).sum();
            let Some(left) = corners_left.checked_sub(corners) else {
                remarks.leave_out(*offset, format!("relation {id}: its ways are those of many others"));
                continue;
            };
            corners_left = left;
            let nodes_of = |way: i64| self.nodes.get(&way).map(Vec::as_slice);
            match areas_of([outer, inner], nodes_of, &self.places) {
                Ok(areas) => mapped.push(Mapped {
                    id: format!("r{id}"),
                    place: *offset,
                    tags: tags.clone(),
                    shape: Shape::Areas(areas),
                }),
                Err(reason) => remarks.leave_out(*offset, format!("relation {id}: {reason}")),
            }
        }
    }
}

fn is_marked(element: &Element<'_>) -> bool {
    element.tags.iter().any(|(key, _)| is_wanted(key))
}

fn split(element: Element<'_>) -> (Head, Body<'_>) {
    let Element { id, offset, tags, body } = element;
    let tags = tags.into_iter().map(|(key, value)| (key.into_owned(), value.into_owned())).collect();
    (Head { id, offset, tags }, body)
}
