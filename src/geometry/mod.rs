//! Geometry in two dimensions and of upright boxes: overlap, containment, distance, free area.
//!
//! Everything here is pure, works in plan metres (x east, y north, z up) and knows neither files nor rooms. Angles are
//! radians, counter-clockwise seen from above.

mod bounds;
mod convex;
mod disjoint_sets;
mod extent;
mod grid;
mod interval;
mod long_axis;
mod polygon;
mod rows;
mod segment;
mod solid;

pub use bounds::Bounds;
pub use convex::{Convex, DISC_CORNERS};
pub use disjoint_sets::DisjointSets;
pub use extent::{Side, Size};
pub use grid::Grid;
pub use interval::Intervals;
pub(crate) use long_axis::LONGER;
pub use long_axis::main_axis;
pub use polygon::{CORNER_TOLERANCE, Polygon, PolygonFault, Region, ring_contains, signed_area};
pub(crate) use segment::ray_hit;
pub use segment::{Line, Segment, distance_of_convex, distance_to_convex, edges};
pub use solid::Solid;

/// A point or direction in the plan frame: metres, x east, y north. Scene points are [`glam::Vec3`]
/// and cross over in `scene/` only.
pub type Point = glam::DVec2;

/// The unit vector at an angle from east.
#[must_use]
pub fn direction(angle: f64) -> Point {
    let (sin, cos) = libm::sincos(angle);
    Point::new(cos, sin)
}
