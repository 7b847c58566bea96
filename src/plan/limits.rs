//! Limits on the size of plans, for the readers of all formats, for assembled levels and for finished files that are read
//! back.
//!
//! The figures are larger than those of any real building. A plan that exceeds them has a wrong unit or a broken
//! coordinate, or is an attack. The limits bound time and memory: walking is computed on 400 cells a square metre.

use crate::geometry::{Point, Polygon};

/// Metres of the shortest and the longest side of a room along x and y.
pub(crate) const ROOM_SIDE: (f64, f64) = (0.05, 1000.0);
/// Square metres of the largest room: exhibition halls without a column have 40,000.
pub(crate) const ROOM_AREA: f64 = 100_000.0;
/// Square metres of the largest box around a room: a concourse that lies slantwise is narrower than its box.
pub(crate) const ROOM_BOX: f64 = 250_000.0;
/// Metres from floor to ceiling and from floor to floor.
pub(crate) const STOREY_HEIGHT: (f64, f64) = (1.0, 100.0);
/// Metres from the middle of a level's rooms to the farthest of them: the longest terminals measure 3 km from end to end.
pub(crate) const LEVEL_REACH: f64 = 3_000.0;
/// Metres of the farthest coordinate from the origin, and of the highest floor above it.
pub(crate) const COORDINATE: f64 = 100_000.0;
/// Levels of a building.
pub(crate) const BUILDING_LEVELS: usize = 1_000;
/// Rooms of a native building: repetitions must not fill the memory by a slip of the finger.
pub(crate) const BUILDING_ROOMS: usize = 100_000;
/// Rooms of a level.
pub(crate) const LEVEL_ROOMS: usize = 100_000;
/// Openings of a level.
pub(crate) const LEVEL_OPENINGS: usize = 500_000;
/// Openings of a room: galleries of a stadium have some hundred doors.
pub(crate) const ROOM_OPENINGS: usize = 5_000;
/// Corners of an outline: checks for crossings compare all edges with all.
pub(crate) const OUTLINE_CORNERS: usize = 4_096;
/// Metres of the narrowest and the widest door, passage or window.
pub(crate) const OPENING_WIDTH: (f64, f64) = (0.1, 50.0);
/// Metres of the thinnest and the thickest wall.
pub(crate) const WALL_THICKNESS: (f64, f64) = (0.0, 3.0);

/// Metres that a room's longer side usually has, for guessing units.
const USUAL_SIDE: f64 = 4.0;
/// Factors by which units of length that are taken for each other differ, and what a plan in the wrong one needs.
const MISTAKEN_UNITS: [(f64, &str); 3] = [
    (1000.0, "millimetres are read as metres"),
    (100.0, "centimetres are read as metres"),
    (10.0, "millimetres are read as centimetres"),
];

/// Whether a point can be a place of a plan: it is finite, and not beyond [`COORDINATE`].
pub(crate) fn is_place(point: Point) -> bool {
    point.is_finite() && point.abs().max_element() <= COORDINATE
}

/// Why something is larger than it may be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Excess {
    /// The measured size, as "is 5000 m wide".
    pub(crate) fact: String,
    /// The limit.
    pub(crate) allowed: String,
}

/// Why an outline is larger than a room may be; `None` if it is not.
pub(crate) fn room_excess(outline: &Polygon) -> Option<Excess> {
    side_excess(outline.bounds().size()).or_else(|| {
        let area = outline.area();
        let fact = format!("has {area:.0} m²");
        let allowed = format!("a room has at most {ROOM_AREA} m²");
        (area > ROOM_AREA).then_some(Excess { fact, allowed })
    })
}

/// Why the box around a room is larger than it may be; `size` is its width and depth in metres.
pub(crate) fn side_excess(size: Point) -> Option<Excess> {
    let (width, depth) = (shown(size.x), shown(size.y));
    let fact = format!("is {width} m wide and {depth} m deep");
    if size.max_element() > ROOM_SIDE.1 {
        return Some(Excess { fact, allowed: format!("a room is at most {} m long", ROOM_SIDE.1) });
    }
    let allowed = format!("the box around a room has at most {ROOM_BOX} m²");
    (size.element_product() > ROOM_BOX).then_some(Excess { fact, allowed })
}

/// The unit that was mistaken, if one makes sense of a room's longer side in metres.
pub(crate) fn mistaken_unit(side: f64) -> Option<&'static str> {
    let misfit = |factor: f64| libm::log(side / factor / USUAL_SIDE).abs();
    let best = MISTAKEN_UNITS.into_iter().min_by(|a, b| misfit(a.0).total_cmp(&misfit(b.0)))?;
    // A factor of 20 about the usual side covers closets and halls.
    (misfit(best.0) < libm::log(20.0)).then_some(best.1)
}

/// A length in metres without the noise of the last digits.
fn shown(length: f64) -> f64 {
    (length * 1000.0).round() / 1000.0
}

/// The upper median of finite values; zero of none.
pub(crate) fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn excess(width: f64, depth: f64) -> Option<String> {
        let size = Point::new(width, depth);
        room_excess(&Polygon::rectangle(Point::ZERO, size)).map(|excess| excess.fact)
    }

    #[test]
    fn rooms_up_to_the_largest_halls_are_read() {
        for (width, depth) in [(4.0, 3.0), (300.0, 300.0), (1000.0, 100.0)] {
            assert_eq!(excess(width, depth), None);
        }
    }

    #[test]
    fn messages_about_too_large_rooms_have_their_size() {
        assert_eq!(excess(5000.0, 4.0).as_deref(), Some("is 5000 m wide and 4 m deep"));
        assert_eq!(excess(900.0, 900.0).as_deref(), Some("is 900 m wide and 900 m deep"));
        assert_eq!(excess(400.0, 400.0).as_deref(), Some("has 160000 m²"));
    }

    #[test]
    fn the_mistaken_unit_is_named() {
        assert_eq!(mistaken_unit(5000.0), Some("millimetres are read as metres"));
        assert_eq!(mistaken_unit(400.0), Some("centimetres are read as metres"));
        assert_eq!(mistaken_unit(350_000.0), None);
    }
}
