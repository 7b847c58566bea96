//! Makes a drawing of the selected elements: rings of nodes become rings of places.

use std::collections::BTreeMap;

use super::selection::{Multipolygon, Selection, Way};
use crate::geometry::Point;
use crate::plan::read::footprint::drawn::{Drawing, Drawn, Rings};
use crate::plan::read::footprint::facts::Facts;
use crate::plan::read::footprint::notes::{Joined, SiteNotes};
use crate::plan::read::osm::{INCOMPLETE, Places, areas_of};

/// How often the nodes of all ways may be corners of multipolygons: a way bounds one or two.
const MOST_SHARED: usize = 8;

/// The drawing of the selected elements.
pub(super) fn drawing_of(selection: Selection, notes: &mut SiteNotes) -> Drawing {
    let Selection { multipolygons, mut ways, streets, parents, entrances, places } = selection;
    let mut drawing = Drawing { is_degrees_unless_said: true, entrances, ..Drawing::default() };
    drawing.streets = streets.iter().map(|nodes| present(nodes, &places)).collect();
    // A way of a thousand nodes in each of a million multipolygons would fill the memory.
    let mut corners_left = MOST_SHARED * ways.values().map(|way| way.nodes.len()).sum::<usize>();
    for (id, mut polygon) in multipolygons {
        let name = format!("r{id}");
        let members = polygon.outer.iter().chain(&polygon.inner);
        let corner_count: usize = members.filter_map(|way| ways.get(way)).map(|way| way.nodes.len()).sum();
        let Some(left) = corners_left.checked_sub(corner_count) else {
            notes.leave_out(name, "its ways are those of many others");
            continue;
        };
        corners_left = left;
        take_outline_facts(&name, &mut polygon, &mut ways, notes);
        let nodes_of = |way: i64| ways.get(&way).map(|way| way.nodes.as_slice());
        match areas_of([&polygon.outer, &polygon.inner], nodes_of, &places) {
            Ok(areas) => drawing.buildings.push(drawn(name, polygon.is_part, polygon.facts, areas, &parents)),
            Err(reason) => notes.leave_out(name, reason),
        }
    }
    for (id, Way { nodes, building }) in ways {
        let Some((is_part, facts)) = building else { continue };
        let name = format!("w{id}");
        let is_closed = nodes.len() > 3 && nodes.first() == nodes.last();
        match places.of(&nodes) {
            _ if !is_closed => notes.leave_out(name, "its outline is open"),
            None => notes.leave_out(name, INCOMPLETE),
            Some(outer) => {
                let areas = vec![Rings { outer, holes: Vec::new() }];
                drawing.buildings.push(drawn(name, is_part, facts, areas, &parents));
            }
        }
    }
    drawing
}

fn drawn(
    id: String,
    is_part: bool,
    facts: Facts,
    areas: Vec<Rings>,
    parents: &BTreeMap<String, String>,
) -> Drawn {
    let parent = parents.get(&id).filter(|_| is_part).cloned();
    Drawn { id: Some(id), is_part, parent, areas, facts }
}

/// The places of those nodes of a street that the file has.
fn present(nodes: &[i64], places: &Places) -> Vec<Point> {
    nodes.iter().filter_map(|node| places.of(&[*node])?.pop()).collect()
}

/// Where the one outer way of a multipolygon has the tags of a building too, the two are one building, with the facts of that which
/// has more.
fn take_outline_facts(
    name: &str,
    polygon: &mut Multipolygon,
    ways: &mut BTreeMap<i64, Way>,
    notes: &mut SiteNotes,
) {
    let [outer] = polygon.outer[..] else { return };
    let building =
        ways.get_mut(&outer).and_then(|way| way.building.take_if(|building| building.0 == polygon.is_part));
    let Some((_, facts)) = building else { return };
    if facts.count() > polygon.facts.count() {
        polygon.facts = facts;
    }
    notes.duplicates.push(Joined { id: format!("w{outer}"), with: name.to_owned() });
}
