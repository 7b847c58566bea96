//! The floor that a piece and its clearances take.

use crate::catalog::{Class, Clearance, ParentName, Side, Size};
use crate::geometry::{Bounds, Point, direction, edges};

/// A rectangle on the floor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footprint {
    /// Counter-clockwise.
    pub(crate) corners: [Point; 4],
    /// The box around them.
    pub(crate) bounds: Bounds,
}

impl Footprint {
    pub(super) fn moved(&self, by: Point) -> Self {
        Self { corners: self.corners.map(|corner| corner + by), bounds: self.bounds.moved(by) }
    }
}

/// Metres above the floor of the underside of a piece hung as low as its class allows.
pub(super) fn lowest_underside(class: &Class) -> f64 {
    // On another piece it stands as high as that piece, which the empty room does not have.
    let on_parts = class.parents.iter().filter(|rule| !matches!(rule.parent, ParentName::Classes(_)));
    let lowest = on_parts.map(|rule| rule.elevation.0).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 0.0 }
}

/// The boxes of the piece itself and of its clearances, in the class's frame; one list for each of those of which one is
/// enough.
pub(super) fn needed_boxes(
    class: &Class,
    size: Size,
    depth_of: impl Fn(&Clearance) -> f64,
) -> Vec<Vec<Bounds>> {
    let needed = |one: Option<&Clearance>| boxes_of(class.clearances.iter().chain(one), size, &depth_of);
    if class.either.is_empty() {
        vec![needed(None)]
    } else {
        class.either.iter().map(|one| needed(Some(one))).collect()
    }
}

/// The boxes of a piece of a size and of some clearances.
fn boxes_of<'c>(
    clearances: impl Iterator<Item = &'c Clearance>,
    size: Size,
    depth_of: impl Fn(&Clearance) -> f64,
) -> Vec<Bounds> {
    let half = Point::new(size.width, size.depth) / 2.0;
    let mut boxes = vec![Bounds::new(-half, half)];
    for clearance in clearances {
        let (mut low, mut high, depth) = (-half, half, depth_of(clearance));
        match clearance.side {
            Side::Front => (low.y, high.y) = (-half.y - depth, -half.y),
            Side::Back => (low.y, high.y) = (half.y, half.y + depth),
            Side::Left => (low.x, high.x) = (-half.x - depth, -half.x),
            Side::Right => (low.x, high.x) = (half.x, half.x + depth),
            // What must stay free over or under a piece takes no floor.
            Side::Above | Side::Below => continue,
        }
        match clearance.side {
            Side::Front | Side::Back => {
                (low.x, high.x) = (low.x - clearance.margin, high.x + clearance.margin)
            }
            _ => (low.y, high.y) = (low.y - clearance.margin, high.y + clearance.margin),
        }
        boxes.push(Bounds::new(low, high));
    }
    // A clearance without depth takes none either; what follows counts on boxes with four corners.
    boxes.retain(|one| one.low.cmplt(one.high).all());
    boxes
}

/// A box of a piece turned to an angle, around the piece's middle.
pub(super) struct Part {
    pub(super) footprint: Footprint,
    /// Its own middle.
    pub(super) middle: Point,
    /// Metres from its middle to its nearest edge.
    pub(super) radius: f64,
}

impl Part {
    fn new(local: Bounds, turn: Point) -> Self {
        let corners = local.corners().map(|corner| turn.rotate(corner));
        debug_assert!(edges(&corners).count() == 4, "empty boxes were dropped");
        let footprint = Footprint { corners, bounds: Bounds::around(corners) };
        Self { footprint, middle: turn.rotate(local.center()), radius: local.size().min_element() / 2.0 }
    }
}

/// The boxes of a piece turned to an angle. Places come in long runs of one angle.
pub(super) struct Turned<'b> {
    boxes: &'b [Bounds],
    angle: f64,
    parts: Vec<Part>,
}

impl<'b> Turned<'b> {
    pub(super) fn new(boxes: &'b [Bounds]) -> Self {
        // No angle equals it: the first that is asked for is worked out.
        Self { boxes, angle: f64::NAN, parts: Vec::new() }
    }

    pub(super) fn to(&mut self, angle: f64) -> &[Part] {
        if self.angle.to_bits() != angle.to_bits() {
            self.angle = angle;
            self.parts = self.boxes.iter().map(|&local| Part::new(local, direction(angle))).collect();
        }
        &self.parts
    }
}
