//! Regions of a room that must stay free, and how far a body reaches into one.

use crate::geometry::{Point, Segment, Solid};

use super::convex::{intersection, middle, penetration};
use super::subject::{Body, Subject};
use super::upright_box::UprightBox;

/// An upright convex prism that people need.
pub(crate) struct Zone {
    /// Why it must stay free.
    pub(crate) purpose: Purpose,
    /// Corners in the level's frame, counter-clockwise.
    pub(crate) base: Vec<Point>,
    /// Metres of its underside and top above the floor.
    pub(crate) heights: (f64, f64),
    /// Where it is entered from: the opening, or the side of the object.
    pub(crate) face: Segment,
}

/// A zone and the index of a body whose box touches it.
pub(crate) type NearPair<'z> = (&'z Zone, usize);

/// Why a zone must stay free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Purpose {
    /// The swing or approach of an opening, by index into the level's openings.
    Passing(usize),
    /// The use of an object: its index and that of the clearance in its class.
    Using(usize, usize),
    /// The comfortable use of an object, likewise.
    Comfort(usize, usize),
    /// The light of a window, by index into the level's openings.
    Light(usize),
    /// The front of a toilet bowl, by index of the object.
    Bowl(usize),
}

impl Zone {
    /// The box around it.
    pub(crate) fn bounds(&self) -> UprightBox {
        let corners = self.base.iter().map(|corner| UprightBox {
            low: corner.extend(self.heights.0),
            high: corner.extend(self.heights.1),
        });
        corners.fold(UprightBox::EMPTY, UprightBox::union)
    }

    /// How far a body reaches into the zone; zero where it does not, or where a wall stands between
    /// (a zone before a thin wall reaches through it, its user does not).
    pub(crate) fn intrusion(&self, subject: &Subject<'_>, body: &Body<'_>) -> f64 {
        let visible = body.solids.iter().map(|solid| (self.reach(solid), solid));
        let deep = visible.filter(|&(depth, solid)| depth > 0.0 && self.is_in_sight(subject, solid));
        deep.map(|(depth, _)| depth).fold(0.0, f64::max)
    }

    /// Metres that a body leaves free between the zone's face and itself.
    pub(crate) fn free_depth(&self, body: &Body<'_>) -> f64 {
        let parts = body.solids.iter().filter(|solid| self.reach(solid) > 0.0);
        let corners = parts.flat_map(|solid| intersection(&self.base, solid.footprint()));
        // The face is a whole side of the zone: the part of a body inside is nearest to it at one of its corners.
        let depths = corners.map(|corner| self.face.distance(corner));
        depths.fold(f64::INFINITY, f64::min)
    }

    /// Metres between the zone's face and a segment inside the zone.
    pub(crate) fn free_depth_to(&self, segment: Segment) -> f64 {
        let from_ends = |one: Segment, other: Segment| other.distance(one.start).min(other.distance(one.end));
        from_ends(segment, self.face).min(from_ends(self.face, segment))
    }

    fn reach(&self, solid: &Solid) -> f64 {
        let upright = (self.heights.1 - solid.low).min(solid.high - self.heights.0);
        // The shortest way out counts, up and down too: what hangs a centimetre too low is a centimetre in the way.
        if upright <= 0.0 { upright } else { upright.min(penetration(&self.base, solid.footprint())) }
    }

    fn is_in_sight(&self, subject: &Subject<'_>, solid: &Solid) -> bool {
        // One point stands for the whole body: walls are longer than what stands behind them.
        let witness = middle(&intersection(&self.base, solid.footprint()));
        let sight = Segment::new(witness, self.face.nearest(witness));
        !subject.at.room.region.borders().any(|border| cross(sight, border))
    }
}

/// Whether two segments cross in a point inside both.
fn cross(one: Segment, other: Segment) -> bool {
    /// Square metres: a segment that ends on a border does not cross it.
    const TOUCHING: f64 = 1e-9;
    let opposed = |one: f64, other: f64| one.min(other) < -TOUCHING && one.max(other) > TOUCHING;
    opposed(one.side(other.start), one.side(other.end)) && opposed(other.side(one.start), other.side(one.end))
}
