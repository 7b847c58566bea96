//! The solid parts and the clearances of an object where it stands.

use crate::catalog::{Class, Clearance, PrismRule, Shape, Side, Size};
use crate::geometry::{Convex, Point, Solid, direction};

use super::constants::SEAT_DEPTH;
use super::furnished::Placement;

/// Where an object stands.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pose {
    /// Middle of the underside.
    pub(crate) position: Point,
    /// Metres of the underside above the floor.
    pub(crate) elevation: f64,
    /// Radians counter-clockwise; at zero the front faces −y.
    pub(crate) angle: f64,
    /// Unit vector of the class's +x (to its right), which is `direction(angle)`.
    pub(crate) right: Point,
}

impl Pose {
    /// A pose with its direction worked out.
    pub(crate) fn new(position: Point, elevation: f64, angle: f64) -> Self {
        Self { position, elevation, angle, right: direction(angle) }
    }

    /// A direction of the class's frame in the plan frame.
    pub(crate) fn turn(&self, local: Point) -> Point {
        self.right * local.x + self.right.perp() * local.y
    }

    /// A point of the class's frame in the plan frame.
    pub(crate) fn place(&self, local: Point) -> Point {
        self.position + self.turn(local)
    }

    /// Unit vector of the front.
    pub(crate) fn front(&self) -> Point {
        -self.right.perp()
    }
}

/// Unit vector out of a horizontal side in the class's frame.
pub(crate) fn outward(side: Side) -> Point {
    match side {
        Side::Front => Point::NEG_Y,
        Side::Back => Point::Y,
        Side::Left => Point::NEG_X,
        Side::Right => Point::X,
        Side::Above | Side::Below => Point::ZERO,
    }
}

/// The solid parts of a placed object: true shapes in the level's plan frame, elevations above the floor of
/// its room.
#[must_use]
pub fn solids(class: &Class, placement: &Placement) -> Vec<Solid> {
    let pose = Pose::new(placement.position, placement.elevation, placement.angle);
    let mut parts = Vec::new();
    append_solids(&mut parts, &class.shape, placement.size, &pose);
    parts
}

/// The regions before an object's sides that people need, as deep as the minimum or the good figure.
#[must_use]
pub fn clearance_solids(class: &Class, placement: &Placement, is_good: bool) -> Vec<(Clearance, Solid)> {
    let pose = Pose::new(placement.position, placement.elevation, placement.angle);
    let depth = |clearance: &Clearance| if is_good { clearance.good } else { clearance.minimum };
    class.clearances.iter().map(|c| (*c, clearance_solid(c, placement.size, &pose, depth(c)))).collect()
}

/// The whole box.
pub(crate) fn box_solid(size: Size, pose: &Pose) -> Solid {
    let half = Point::new(size.width, size.depth) / 2.0;
    let base = Convex::rectangle(pose.position, half, pose.right);
    Solid::new(base, pose.elevation, pose.elevation + size.height)
}

/// Appends the solid parts of a shape.
pub(crate) fn append_solids(parts: &mut Vec<Solid>, shape: &Shape, size: Size, pose: &Pose) {
    match shape {
        Shape::Box => parts.push(box_solid(size, pose)),
        Shape::Disc => {
            let half = Point::new(size.width, size.depth) / 2.0;
            let base = Convex::disc(pose.position, half, pose.right);
            parts.push(Solid::new(base, pose.elevation, pose.elevation + size.height));
        }
        Shape::Prisms(rules) => parts.extend(rules.iter().map(|rule| prism(rule, size, pose))),
    }
}

fn prism(rule: &PrismRule, size: Size, pose: &Pose) -> Solid {
    let lengths = [size.width, size.depth, size.height];
    let at = |extents: &[crate::catalog::Extent; 3], axis: usize| {
        extents[axis].share * lengths[axis] + extents[axis].offset
    };
    let low = Point::new(at(&rule.low, 0) - size.width / 2.0, at(&rule.low, 1) - size.depth / 2.0);
    let high = Point::new(at(&rule.high, 0) - size.width / 2.0, at(&rule.high, 1) - size.depth / 2.0);
    let (center, half) = (pose.place((low + high) / 2.0), (high - low) / 2.0);
    let base = if rule.is_disc {
        Convex::disc(center, half, pose.right)
    } else {
        Convex::rectangle(center, half, pose.right)
    };
    Solid::new(base, pose.elevation + at(&rule.low, 2), pose.elevation + at(&rule.high, 2))
}

/// The region before one side, `depth` metres deep.
pub(crate) fn clearance_solid(clearance: &Clearance, size: Size, pose: &Pose, depth: f64) -> Solid {
    clearance_between(clearance, size, pose, (0.0, depth))
}

/// The region before one side that begins and ends so many metres before it; less than zero is inside the object.
pub(crate) fn clearance_between(
    clearance: &Clearance,
    size: Size,
    pose: &Pose,
    (near, far): (f64, f64),
) -> Solid {
    let out = outward(clearance.side);
    let half = Point::new(size.width, size.depth) / 2.0;
    let reach = half.dot(out.abs());
    let width = half.dot(out.perp().abs()) + clearance.margin;
    let center = pose.place(out * (reach + f64::midpoint(near, far)));
    let along = out.perp().abs() * width + out.abs() * ((far - near) / 2.0);
    let base = Convex::rectangle(center, along, pose.right);
    Solid::new(base, pose.elevation, pose.elevation + clearance.height)
}

/// Where a child's seat stands in a clearance that allows one.
pub(crate) fn seat(clearance: &Clearance, size: Size, pose: &Pose) -> Option<Solid> {
    // Never deeper than the clearance: behind it others may stand.
    let depth = clearance.minimum.min(SEAT_DEPTH);
    clearance.allows_children.then(|| clearance_solid(clearance, size, pose, depth))
}
