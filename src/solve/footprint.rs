//! What a piece and its clearances take of the floor.

use crate::catalog::{Class, Clearance, ParentName, Side, Size};
use crate::geometry::{Point, direction, edges};

/// A rectangle on the floor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footprint {
    /// Counter-clockwise.
    pub(crate) corners: [Point; 4],
    /// The box around them.
    pub(crate) bounds: (Point, Point),
}

impl Footprint {
    pub(super) fn moved(&self, by: Point) -> Self {
        let (low, high) = self.bounds;
        Self { corners: self.corners.map(|corner| corner + by), bounds: (low + by, high + by) }
    }
}

/// The box around corners.
pub(super) fn bounds_of<'p>(corners: impl Iterator<Item = &'p Point>) -> (Point, Point) {
    corners.fold((Point::INFINITY, Point::NEG_INFINITY), |(low, high), &at| (low.min(at), high.max(at)))
}

/// Metres above the floor of the underside of a piece hung as low as its class allows.
pub(super) fn lowest_underside(class: &Class) -> f64 {
    let on_parts = class.parents.iter().filter(|rule| !matches!(rule.parent, ParentName::Classes(_)));
    let lowest = on_parts.map(|rule| rule.elevation.0).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 0.0 }
}

/// A box of a piece or its clearance in the class's frame: lowest and highest corner.
pub(super) type LocalBox = (Point, Point);

/// The piece itself and its clearances.
pub(super) fn needed_boxes(class: &Class, size: Size, depth_of: impl Fn(&Clearance) -> f64) -> Vec<LocalBox> {
    let half = Point::new(size.width, size.depth) / 2.0;
    let mut boxes = vec![(-half, half)];
    for clearance in &class.clearances {
        let (mut low, mut high, depth) = (-half, half, depth_of(clearance));
        match clearance.side {
            Side::Front => (low.y, high.y) = (-half.y - depth, -half.y),
            Side::Back => (low.y, high.y) = (half.y, half.y + depth),
            Side::Left => (low.x, high.x) = (-half.x - depth, -half.x),
            Side::Right => (low.x, high.x) = (half.x, half.x + depth),
            Side::Above | Side::Below => continue,
        }
        match clearance.side {
            Side::Front | Side::Back => {
                (low.x, high.x) = (low.x - clearance.margin, high.x + clearance.margin)
            }
            _ => (low.y, high.y) = (low.y - clearance.margin, high.y + clearance.margin),
        }
        boxes.push((low, high));
    }
    boxes.retain(|(low, high)| low.cmplt(*high).all());
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
    fn new((low, high): LocalBox, turn: Point) -> Self {
        let corners = [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
            .map(|corner| turn.rotate(corner));
        debug_assert!(edges(&corners).count() == 4, "empty boxes were dropped");
        let footprint = Footprint { corners, bounds: bounds_of(corners.iter()) };
        Self { footprint, middle: turn.rotate((low + high) / 2.0), radius: (high - low).min_element() / 2.0 }
    }
}

/// The boxes of a piece turned to an angle. Places come in long runs of one angle.
pub(super) struct Turned<'b> {
    boxes: &'b [LocalBox],
    angle: f64,
    parts: Vec<Part>,
}

impl<'b> Turned<'b> {
    pub(super) fn new(boxes: &'b [LocalBox]) -> Self {
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
