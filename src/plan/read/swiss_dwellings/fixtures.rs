//! The furniture of floors: kitchens, baths, washing machines and what is built in.

use super::elements::{Element, Entity, NAME};
use super::storey::Storey;
use crate::geometry::{Bounds, Point, edges};
use crate::plan::assemble::BoxIndex;
use crate::plan::read::drawn::DrawnPiece;
use crate::plan::read::oriented::Oriented;

/// Features that are parts of the building.
const BUILDING_PARTS: [&str; 4] = ["STAIRS", "ELEVATOR", "RAMP", "SHAFT"];
/// What is deeper than wide: its back is a short side.
const DEEP: [&str; 1] = ["TOILET"];
/// Metres around a piece in which walls are looked for.
const REACH: f64 = 1.0;
/// Metres of the units that a kitchen is divided into.
const KITCHEN_UNIT: f64 = 0.6;
/// Metres of the shortest kitchen that is divided.
const LEAST_KITCHEN: f64 = 1.2;
/// Units of the longest kitchen.
const MOST_UNITS: f64 = 40.0;

/// Whether an element is a piece of furniture.
pub(super) fn is_furniture(element: &Element) -> bool {
    element.entity == Entity::Feature && !BUILDING_PARTS.contains(&&*element.subtype)
}

/// The furniture of a floor.
pub(super) fn pieces(storey: &Storey, building: &str) -> Vec<DrawnPiece> {
    let areas = storey.elements.iter().filter(|element| element.entity == Entity::Area);
    let faces = areas.flat_map(|area| &area.outlines).flat_map(|outline| edges(&outline.outer));
    let faces: Vec<_> = faces.collect();
    let index = BoxIndex::of(faces.iter().map(|face| face.bounds()).zip(0..));
    let distance = |place: Point| {
        let near = index.meeting(Bounds::around_point(place, REACH));
        near.map(|number: usize| faces[number].distance(place)).fold(f64::INFINITY, f64::min)
    };
    let level = storey.level_id();
    let mut pieces = Vec::new();
    for element in storey.elements.iter().filter(|element| is_furniture(element)) {
        let Some(around) = Oriented::around(&element.outlines[0].outer) else { continue };
        let placed = facing(around, DEEP.contains(&&*element.subtype), &distance);
        for (kind, center, size) in units(&element.subtype.to_lowercase(), placed) {
            pieces.push(DrawnPiece {
                building: building.to_owned(),
                level: level.clone(),
                format: NAME,
                kind,
                name: String::new(),
                center,
                axis: placed.axis,
                size,
                bottom: 0.0,
            });
        }
    }
    pieces
}

/// A rectangle whose back is known: to the left of `axis`.
#[derive(Clone, Copy)]
struct Placed {
    center: Point,
    axis: Point,
    /// Metres along the back and from back to front.
    size: Point,
}

/// The table says no front: of the two sides that may be the back, that nearer to a wall is.
fn facing(around: Oriented, is_deep: bool, distance: &dyn Fn(Point) -> f64) -> Placed {
    let Oriented { center, axis, size } = around;
    let (axis, size) = if is_deep { (axis.perp(), Point::new(size.y, size.x)) } else { (axis, size) };
    let back = axis.perp() * (size.y / 2.0);
    let is_turned = distance(center - back) < distance(center + back);
    Placed { center, axis: if is_turned { -axis } else { axis }, size }
}

/// A kitchen as a sink, a cooker and worktops along its back; anything else as it is.
fn units(kind: &str, placed: Placed) -> Vec<(String, Point, Point)> {
    let Placed { center, axis, size } = placed;
    if kind != "kitchen" || size.x < LEAST_KITCHEN {
        return vec![(kind.to_owned(), center, size)];
    }
    let count = (size.x / KITCHEN_UNIT + 1e-6).floor().min(MOST_UNITS);
    let sink = (count / 4.0).floor();
    // As far from the sink as a worktop is wide, where there is one.
    let cooker = (sink + 2.0).min(count - 1.0);
    let first = center - axis * (KITCHEN_UNIT * (count - 1.0) / 2.0);
    let unit = |number: usize| {
        let part = match number as f64 {
            number if number == sink => "kitchen sink",
            number if number == cooker => "kitchen cooker",
            _ => "kitchen worktop",
        };
        (part.to_owned(), first + axis * (KITCHEN_UNIT * number as f64), Point::new(KITCHEN_UNIT, size.y))
    };
    (0..count as usize).map(unit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kitchen_is_divided_into_units_side_by_side_with_one_sink_and_one_cooker() {
        for (width, count) in [(1.2, 2), (1.9, 3), (2.66, 4), (6.0, 10)] {
            let placed = Placed { center: Point::ONE, axis: Point::X, size: Point::new(width, 0.6) };
            let units = units("kitchen", placed);
            assert_eq!(units.len(), count, "{width}");
            for part in ["kitchen sink", "kitchen cooker"] {
                assert_eq!(units.iter().filter(|(kind, ..)| kind == part).count(), 1, "{width}: {part}");
            }
            assert!(units.windows(2).all(|pair| (pair[1].1.x - pair[0].1.x - 0.6).abs() < 1e-9));
            let ends = (units[0].1.x + units[count - 1].1.x) / 2.0;
            assert!((ends - 1.0).abs() < 1e-9, "they stand in the middle of what is drawn");
        }
    }

    #[test]
    fn the_back_is_the_side_nearer_to_a_wall() {
        let wall = |place: Point| (place.y - 1.0).abs();
        let around = Oriented { center: Point::new(0.0, 0.7), axis: Point::X, size: Point::new(0.7, 0.4) };
        let basin = facing(around, false, &wall);
        assert_eq!((basin.axis, basin.size), (Point::X, Point::new(0.7, 0.4)));
        let turned = facing(Oriented { center: Point::new(0.0, 1.3), ..around }, false, &wall);
        assert_eq!(turned.axis, -Point::X);
        let toilet = facing(Oriented { axis: Point::Y, ..around }, true, &wall);
        assert_eq!((toilet.axis.y, toilet.size), (0.0, Point::new(0.4, 0.7)));
        assert!(toilet.axis.perp().y > 0.0, "its back is towards the wall");
    }
}
