//! Areas of the floor: shrinking, growing and cutting them is the work of the crate `geo`.

use core::f64::consts::FRAC_PI_4;

use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::{BooleanOps, Buffer, ConvexHull, MultiPoint, MultiPolygon, Polygon, unary_union};

use crate::geometry::{Point, Region};
use crate::plan::to_surface;

/// An area of the floor; parts may have holes.
pub(super) type Area = MultiPolygon<f64>;

/// The angle of the pieces of an arc: around a corner they cut 7.6 % of the radius off, 11 mm of that of a robot. Finer arcs cut floors
/// into needles.
const ARC: f64 = FRAC_PI_4;

/// The floor of a room.
pub(super) fn of_region(region: &Region) -> Area {
    to_surface(&region.outline, &region.holes).into()
}

/// The convex area around some places.
pub(super) fn around(places: &[Point]) -> Polygon<f64> {
    places.iter().map(|place| geo::Point::new(place.x, place.y)).collect::<MultiPoint<f64>>().convex_hull()
}

/// Areas as one.
pub(super) fn union<'a>(areas: impl IntoIterator<Item = &'a Polygon<f64>>) -> Area {
    let areas: Vec<&Polygon<f64>> = areas.into_iter().collect();
    unary_union(areas)
}

/// An area grown by some metres, or shrunk if below zero, with round corners.
pub(super) fn grown(area: &Area, by: f64) -> Area {
    if by == 0.0 || area.0.is_empty() {
        return area.clone();
    }
    area.buffer_with_style(BufferStyle::new(by).line_join(LineJoin::Round(ARC)))
}

/// What of an area is not in another.
pub(super) fn without(area: &Area, other: &Area) -> Area {
    if other.0.is_empty() { area.clone() } else { area.difference(other) }
}

/// What two areas share.
pub(super) fn common(area: &Area, other: &Area) -> Area {
    area.intersection(other)
}
