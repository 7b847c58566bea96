//! The elements of a file that buildings, doors and streets are made of.

use std::collections::{BTreeMap, BTreeSet};

use crate::document::Faults;
use crate::geometry::Point;
use crate::plan::read::footprint::facts::{Facts, TagValue, Tags, facts_of};
use crate::plan::read::footprint::kind::{Kind, kind_of};
use crate::plan::read::footprint::notes::SiteNotes;
use crate::plan::read::footprint::streets::is_street;
use crate::plan::read::osm::{Body, Element, ElementKind, Elements, Places};

/// The elements that are read.
#[derive(Debug, Default)]
pub(super) struct Selection {
    /// Buildings and parts of several ways, by their ids.
    pub(super) multipolygons: BTreeMap<i64, Multipolygon>,
    /// Buildings, parts, and ways that multipolygons are made of, by their ids.
    pub(super) ways: BTreeMap<i64, Way>,
    /// Nodes along streets.
    pub(super) streets: Vec<Vec<i64>>,
    /// The building of each part that a relation of the type `building` names, by their ids with letters.
    pub(super) parents: BTreeMap<String, String>,
    pub(super) entrances: Vec<Point>,
    pub(super) places: Places,
}

/// A building or a part of several ways.
#[derive(Debug)]
pub(super) struct Multipolygon {
    pub(super) is_part: bool,
    pub(super) facts: Facts,
    pub(super) outer: Vec<i64>,
    pub(super) inner: Vec<i64>,
}

/// A way.
#[derive(Debug)]
pub(super) struct Way {
    pub(super) nodes: Vec<i64>,
    /// Whether it is a building (`false`) or a part (`true`), and what is known of it.
    pub(super) building: Option<(bool, Facts)>,
}

impl Selection {
    /// Selects from a file.
    pub(super) fn of(file: &dyn Elements, notes: &mut SiteNotes) -> Result<Self, Faults> {
        let mut selection = Self::default();
        file.each(ElementKind::Relation, &mut |element| selection.add_relation(element, notes))?;
        let polygons = selection.multipolygons.values();
        let members: BTreeSet<i64> =
            polygons.flat_map(|polygon| polygon.outer.iter().chain(&polygon.inner)).copied().collect();
        file.each(ElementKind::Way, &mut |element| selection.add_way(element, &members, notes))?;
        let mut ids: Vec<i64> = selection.ways.values().flat_map(|way| &way.nodes).copied().collect();
        ids.extend(selection.streets.iter().flatten());
        selection.places = Places::of_nodes(ids);
        file.each(ElementKind::Node, &mut |element| selection.add_node(element, notes))?;
        Ok(selection)
    }

    fn add_relation(&mut self, element: Element<'_>, notes: &mut SiteNotes) {
        let kind = |kind: &str| element.tags.iter().any(|(key, value)| key == "type" && value == kind);
        if kind("building") {
            return self.add_parents(&element);
        }
        if !kind("multipolygon") || !is_marked(&element) {
            return;
        }
        let Some((is_part, facts)) = building_of(&tags_of(&element), notes) else { return };
        let Body::Relation(members) = element.body else { return };
        let ways = |inner: bool| {
            let of_role =
                move |role: &str| if inner { role == "inner" } else { matches!(role, "outer" | "") };
            let ways = members.iter().filter(|member| member.kind == ElementKind::Way);
            ways.filter(move |member| of_role(&member.role)).map(|member| member.id).collect::<Vec<i64>>()
        };
        let polygon = Multipolygon { is_part, facts, outer: ways(false), inner: ways(true) };
        self.multipolygons.insert(element.id, polygon);
    }

    /// Of a relation that joins the parts of a building.
    fn add_parents(&mut self, element: &Element<'_>) {
        let Body::Relation(members) = &element.body else { return };
        let name = |kind: ElementKind, id: i64| match kind {
            ElementKind::Node => format!("n{id}"),
            ElementKind::Way => format!("w{id}"),
            ElementKind::Relation => format!("r{id}"),
        };
        let outline = members.iter().find(|member| member.role == "outline");
        let parent =
            outline.map_or_else(|| format!("r{}", element.id), |outline| name(outline.kind, outline.id));
        for part in members.iter().filter(|member| member.role == "part") {
            self.parents.insert(name(part.kind, part.id), parent.clone());
        }
    }

    fn add_way(&mut self, element: Element<'_>, members: &BTreeSet<i64>, notes: &mut SiteNotes) {
        let is_marked = is_marked(&element);
        if !is_marked && !members.contains(&element.id) && !element.has("highway") {
            return;
        }
        let tags = tags_of(&element);
        let Body::Way(nodes) = element.body else { return };
        let building = if is_marked { building_of(&tags, notes) } else { None };
        if building.is_none() && is_street(&tags) {
            self.streets.push(nodes.clone());
        }
        if building.is_some() || members.contains(&element.id) {
            self.ways.insert(element.id, Way { nodes, building });
        }
    }

    fn add_node(&mut self, element: Element<'_>, notes: &mut SiteNotes) {
        let Body::Node(place) = element.body else { return };
        self.places.note(element.id, place);
        if element.tags.iter().any(|(key, value)| key == "entrance" && value != "no") {
            self.entrances.push(place);
        }
        if element.has("building") {
            notes.skip("points");
        }
    }
}

/// The tags of an element by key.
fn tags_of(element: &Element<'_>) -> Tags {
    let mut tags = Tags::default();
    for (key, value) in &element.tags {
        tags.add(key.as_ref(), TagValue::Text(value.clone().into_owned()));
    }
    tags
}

fn is_marked(element: &Element<'_>) -> bool {
    element.has("building") || element.has("building:part")
}

/// Whether it is a part, and what is known of it; `None` of what is no building.
fn building_of(tags: &Tags, notes: &mut SiteNotes) -> Option<(bool, Facts)> {
    match kind_of(tags) {
        Kind::Building => Some((false, facts_of(tags))),
        Kind::Part => Some((true, facts_of(tags))),
        Kind::Unmarked => None,
        Kind::Other(reason) => {
            notes.skip(reason);
            None
        }
    }
}
