//! Makes a drawing of the selected elements: rings of nodes become rings of places.

use std::collections::BTreeMap;

use super::rings::rings_of;
use super::selection::{Multipolygon, Places, Selection, Way};
use crate::geometry::{Bounds, Point};
use crate::plan::assemble::BoxIndex;
use crate::plan::read::footprint::drawn::{Drawing, Drawn, Rings};
use crate::plan::read::footprint::facts::Facts;
use crate::plan::read::footprint::notes::{Joined, SiteNotes};

/// The reason for an element some of whose nodes or ways are beyond the edge of the extract.
const INCOMPLETE: &str = "the file has not all of its corners";
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
        match areas_of(&polygon, &ways, &places) {
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

/// The areas of a multipolygon: each outer ring with the inner rings that lie in it.
fn areas_of(
    polygon: &Multipolygon,
    ways: &BTreeMap<i64, Way>,
    places: &Places,
) -> Result<Vec<Rings>, &'static str> {
    let rings = |members: &[i64]| {
        let nodes = members.iter().map(|id| Some((*id, ways.get(id)?.nodes.as_slice())));
        let (rings, is_left_over) = rings_of(&nodes.collect::<Option<BTreeMap<_, _>>>().ok_or(INCOMPLETE)?);
        if is_left_over {
            return Err("its outline is open");
        }
        rings.iter().map(|ring| places.of(ring).ok_or(INCOMPLETE)).collect::<Result<Vec<_>, _>>()
    };
    let outer = rings(&polygon.outer)?;
    if outer.is_empty() {
        return Err("it has no outline");
    }
    // Without its courtyards, a building is better than none.
    let inner = rings(&polygon.inner).unwrap_or_default();
    let mut areas: Vec<Rings> = outer.into_iter().map(|outer| Rings { outer, holes: Vec::new() }).collect();
    let boxes = areas.iter().map(|area| Bounds::around(area.outer.iter().copied()));
    let index = BoxIndex::of(boxes.zip(0..));
    for hole in inner {
        let Some(&corner) = hole.first() else { continue };
        let around = index.near(Bounds::around_point(corner, 0.0));
        let holder = around.into_iter().find(|area: &usize| is_inside(&areas[*area].outer, &hole));
        if let Some(holder) = holder {
            areas[holder].holes.push(hole);
        }
    }
    Ok(areas)
}

/// Whether the middle of the first edge of a hole lies in a ring: corners may be common to both.
fn is_inside(ring: &[Point], hole: &[Point]) -> bool {
    let place = hole[0].midpoint(hole[1 % hole.len()]);
    let count = ring.len();
    let crosses = |index: &usize| {
        let (a, b) = (ring[*index], ring[(index + 1) % count]);
        (a.y > place.y) != (b.y > place.y) && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)
    };
    (0..count).filter(crosses).count() % 2 == 1
}
