//! The areas of multipolygons.

use std::collections::BTreeMap;

use super::places::Places;
use super::rings::rings_of;
use crate::geometry::{Bounds, Point};
use crate::plan::assemble::BoxIndex;
use crate::plan::read::rings::Rings;

/// The reason for an element some of whose nodes or ways are beyond the edge of the extract.
pub(in crate::plan::read) const INCOMPLETE: &str = "the file has not all of its corners";

/// The areas of a multipolygon of outer and inner ways: each outer ring with the inner rings that lie in it.
///
/// # Errors
/// The reason in words.
pub(in crate::plan::read) fn areas_of<'a>(
    [outer, inner]: [&[i64]; 2],
    nodes_of: impl Fn(i64) -> Option<&'a [i64]>,
    places: &Places,
) -> Result<Vec<Rings>, &'static str> {
    let rings = |members: &[i64]| {
        let nodes = members.iter().map(|id| Some((*id, nodes_of(*id)?)));
        let (rings, is_left_over) = rings_of(&nodes.collect::<Option<BTreeMap<_, _>>>().ok_or(INCOMPLETE)?);
        if is_left_over {
            return Err("its outline is open");
        }
        rings.iter().map(|ring| places.of(ring).ok_or(INCOMPLETE)).collect::<Result<Vec<_>, _>>()
    };
    let outer = rings(outer)?;
    if outer.is_empty() {
        return Err("it has no outline");
    }
    // Without its holes, an area is better than none.
    let inner = rings(inner).unwrap_or_default();
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
    holds(ring, place)
}

/// Whether a place lies in a ring.
pub(in crate::plan::read) fn holds(ring: &[Point], place: Point) -> bool {
    let count = ring.len();
    let crosses = |index: &usize| {
        let (a, b) = (ring[*index], ring[(index + 1) % count]);
        (a.y > place.y) != (b.y > place.y) && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)
    };
    (0..count).filter(crosses).count() % 2 == 1
}
