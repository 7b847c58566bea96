//! Convex footprints and the separating axis test.
//!
//! S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A Hierarchical Structure for Rapid Interference
//! Detection", SIGGRAPH 1996, section 5 (the test that the paper cites), here in the plane: two convex
//! polygons are apart if and only if the normal of one of their edges separates their projections.

use super::{Bounds, Point, Segment};

/// Corners of a [`Convex`] that stands for a disc; its flats touch the disc, so its extent along the
/// class's axes is the disc's own.
pub const DISC_CORNERS: usize = 12;

/// A convex polygon of at most [`DISC_CORNERS`] corners, counter-clockwise, kept in place (no heap) because
/// the layout makes thousands a millisecond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Convex {
    corners: [Point; DISC_CORNERS],
    count: usize,
    /// Opposite edges are parallel, so that half of the normals suffice.
    is_symmetric: bool,
    /// Metres of the radius of the disc that it stands for, if that is round.
    radius: Option<f64>,
    /// A rectangle along the axes of the plan, as most furniture and walls are: its box is all that it covers.
    fills_its_bounds: bool,
}

/// Metres by which corners of rectangles along the axes may be off their sides: the sine of half a turn is 1e-16, not zero.
const STRAIGHT: f64 = 1e-9;

/// Metres within which the exact test decides instead of a quick one, far more than rounding. Larger only makes the exact test
/// more frequent.
pub(super) const CLOSE: f64 = 1e-7;

impl Convex {
    /// A rectangle around `center`; `axis` is the unit vector along its width.
    #[must_use]
    pub fn rectangle(center: Point, half: Point, axis: Point) -> Self {
        let (along, across) = (axis * half.x, axis.perp() * half.y);
        let mut corners = [Point::ZERO; DISC_CORNERS];
        corners[0] = center - along - across;
        corners[1] = center + along - across;
        corners[2] = center + along + across;
        corners[3] = center - along + across;
        let off_axis = (along.x.abs().min(along.y.abs())).max(across.x.abs().min(across.y.abs()));
        Self { corners, count: 4, is_symmetric: true, radius: None, fills_its_bounds: off_axis < STRAIGHT }
    }

    /// The polygon around an ellipse with half axes `half`, `axis` along the first.
    #[must_use]
    pub fn disc(center: Point, half: Point, axis: Point) -> Self {
        // Circumscribed about the unit circle with flats at 0°, 30°, 60°, ...: corners at odd multiples of 15°.
        const LONG: f64 = 1.0;
        const MIDDLE: f64 = 0.732_050_807_568_877_2; // sin 45° / cos 15°
        const SHORT: f64 = 0.267_949_192_431_122_7; // tan 15°
        const UNIT: [(f64, f64); DISC_CORNERS] = [
            (LONG, SHORT),
            (MIDDLE, MIDDLE),
            (SHORT, LONG),
            (-SHORT, LONG),
            (-MIDDLE, MIDDLE),
            (-LONG, SHORT),
            (-LONG, -SHORT),
            (-MIDDLE, -MIDDLE),
            (-SHORT, -LONG),
            (SHORT, -LONG),
            (MIDDLE, -MIDDLE),
            (LONG, -SHORT),
        ];
        let corners = UNIT.map(|(x, y)| center + axis * (x * half.x) + axis.perp() * (y * half.y));
        let radius = (half.x == half.y).then_some(half.x);
        Self { corners, count: DISC_CORNERS, is_symmetric: true, radius, fills_its_bounds: false }
    }

    /// A convex polygon from its counter-clockwise corners.
    ///
    /// # Panics
    /// If there are fewer than three or more than [`DISC_CORNERS`] corners.
    #[must_use]
    pub fn from_corners(points: &[Point]) -> Self {
        assert!((3..=DISC_CORNERS).contains(&points.len()), "a convex footprint has 3 to 12 corners");
        let mut corners = [Point::ZERO; DISC_CORNERS];
        corners[..points.len()].copy_from_slice(points);
        Self { corners, count: points.len(), is_symmetric: false, radius: None, fills_its_bounds: false }
    }

    /// The corners, counter-clockwise.
    #[must_use]
    pub fn corners(&self) -> &[Point] {
        &self.corners[..self.count]
    }

    /// Whether it is a rectangle along the axes of the plan, so that its box says all about it.
    #[must_use]
    pub fn fills_its_bounds(&self) -> bool {
        self.fills_its_bounds
    }

    /// The middle of the corners.
    #[must_use]
    pub fn center(&self) -> Point {
        self.corners().iter().sum::<Point>() / self.count as f64
    }

    /// The axis-parallel box around it.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let first = self.corners[0];
        let first = Bounds::new(first, first);
        self.corners()[1..].iter().fold(first, |bounds, &corner| bounds.union(Bounds::new(corner, corner)))
    }

    /// Lowest and highest projection on a direction.
    #[must_use]
    pub fn project(&self, direction: Point) -> (f64, f64) {
        let first = self.corners[0].dot(direction);
        self.corners()[1..].iter().fold((first, first), |(low, high), corner| {
            let value = corner.dot(direction);
            // Comparisons instead of `min` and `max`: corners are finite, and the layout spends a tenth of its time here.
            (if value < low { value } else { low }, if value > high { value } else { high })
        })
    }

    /// Normals of the edges, as long as these, each direction once where opposite edges are parallel. Bringing them to
    /// unit length would take most of the time of a test.
    fn normals(&self) -> impl Iterator<Item = Point> + '_ {
        let used = if self.is_symmetric { self.count / 2 } else { self.count };
        (0..used).filter_map(move |i| {
            let next = if i + 1 == self.count { 0 } else { i + 1 };
            let edge = self.corners[next] - self.corners[i];
            (edge != Point::ZERO).then(|| Point::new(edge.y, -edge.x))
        })
    }

    /// Whether two polygons overlap by more than `tolerance` metres along every separating axis.
    #[must_use]
    pub fn overlaps(&self, other: &Self, tolerance: f64) -> bool {
        let told = self.is_met_by_disc(other, tolerance).or_else(|| other.is_met_by_disc(self, tolerance));
        if let Some(overlaps) = told {
            return overlaps;
        }
        let apart = |normal: Point| {
            let (low, high) = self.project(normal);
            let (other_low, other_high) = other.project(normal);
            is_at_most(high.min(other_high) - low.max(other_low), tolerance, normal)
        };
        !self.normals().any(apart) && (self.is_aligned_with(other) || !other.normals().any(apart))
    }

    /// [`Convex::overlaps`] of a rectangle and a round disc, if the circles in and around its corners decide it: nearly
    /// always, and in a tenth of the time.
    fn is_met_by_disc(&self, disc: &Self, tolerance: f64) -> Option<bool> {
        /// The circle around the corners, by that within: 1 / cos 15°.
        const AROUND: f64 = 1.035_276_180_410_083;
        let radius = disc.radius.filter(|_| self.is_symmetric && self.count == 4)?;
        let from_corner = (disc.corners[0] + disc.corners[DISC_CORNERS / 2]) / 2.0 - self.corners[0];
        let sides = [self.corners[1] - self.corners[0], self.corners[3] - self.corners[0]];
        let lengths = sides.map(Point::length);
        let beyond = |side: usize| {
            let along = from_corner.dot(sides[side]) / lengths[side];
            (-along).max(along - lengths[side]).max(0.0)
        };
        let distance = Point::new(beyond(0), beyond(1)).length();
        if distance > radius * AROUND - tolerance.min(0.0) + CLOSE {
            return Some(false);
        }
        let thinnest = lengths[0].min(lengths[1]).min(radius - distance);
        (thinnest > tolerance + CLOSE).then_some(true)
    }

    /// Whether both are rectangles of the same directions, as most furniture of a room is: one's normals are the other's.
    fn is_aligned_with(&self, other: &Self) -> bool {
        /// Radians by which angles differ that were computed differently.
        const SAME_ANGLE: f64 = 1e-12;
        if !(self.is_symmetric && self.count == 4 && other.is_symmetric && other.count == 4) {
            return false;
        }
        let (a, b) = (self.corners[1] - self.corners[0], other.corners[1] - other.corners[0]);
        let limit = SAME_ANGLE * SAME_ANGLE * a.length_squared() * b.length_squared();
        let (sine, cosine) = (a.perp_dot(b), a.dot(b));
        limit > 0.0 && (sine * sine <= limit || cosine * cosine <= limit)
    }

    /// Whether a segment enters the polygon by more than `tolerance` metres.
    #[must_use]
    pub fn is_entered_by(&self, segment: Segment, tolerance: f64) -> bool {
        let Segment { start, end } = segment;
        if self.normals().any(|normal| {
            let (low, high) = self.project(normal);
            let (a, b) = (start.dot(normal), end.dot(normal));
            // A segment has no width of its own: inside means beyond the faces by the tolerance.
            is_at_most(a.max(b) - low, tolerance, normal) || is_at_most(high - a.min(b), tolerance, normal)
        }) {
            return false;
        }
        let across = segment.normal();
        if across == Point::ZERO {
            return true;
        }
        let (low, high) = self.project(across);
        let level = start.dot(across);
        level > low + tolerance && level < high - tolerance
    }
}

/// Whether a difference of projections on a direction is at most so many metres, without its length's square root.
fn is_at_most(difference: f64, metres: f64, direction: Point) -> bool {
    let limit = metres * metres * direction.length_squared();
    if metres < 0.0 {
        difference < 0.0 && difference * difference >= limit
    } else {
        difference <= 0.0 || difference * difference <= limit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, turn: f64) -> Convex {
        let (sin, cos) = libm::sincos(turn);
        Convex::rectangle(Point::new(x, y), Point::splat(0.5), Point::new(cos, sin))
    }

    #[test]
    fn touching_squares_do_not_overlap() {
        assert!(!square(0.0, 0.0, 0.0).overlaps(&square(1.0, 0.0, 0.0), 1e-4));
        assert!(square(0.0, 0.0, 0.0).overlaps(&square(0.999, 0.0, 0.0), 1e-4));
    }

    #[test]
    fn aligned_rectangles_are_distinguished_from_turned_ones() {
        let right = core::f64::consts::FRAC_PI_2;
        for turn in [0.0, 0.3] {
            assert!(square(0.0, 0.0, turn).is_aligned_with(&square(3.0, 1.0, turn + right)));
            assert!(!square(0.0, 0.0, turn).is_aligned_with(&square(3.0, 1.0, turn + 0.001)));
            let thin = Convex::rectangle(Point::ZERO, Point::new(0.0, 0.5), Point::X);
            assert!(!thin.is_aligned_with(&square(0.0, 0.0, turn)), "a side without length has no direction");
        }
    }

    #[test]
    fn polygons_overlap_by_more_than_the_tolerance_in_metres_whatever_their_size() {
        for half in [0.01, 1.0, 100.0] {
            for turn in [0.0, 0.7] {
                let axis = Point::from_angle(turn);
                let at = |along: f64| Convex::rectangle(axis * along, Point::splat(half), axis);
                assert!(!at(0.0).overlaps(&at(2.0 * half - 0.0009), 0.001), "{half} {turn}");
                assert!(at(0.0).overlaps(&at(2.0 * half - 0.0011), 0.001), "{half} {turn}");
                assert!(at(0.0).overlaps(&at(2.0 * half + 0.0009), -0.001), "{half} {turn}");
                assert!(!at(0.0).overlaps(&at(2.0 * half + 0.0011), -0.001), "{half} {turn}");
                let from = |along: f64| Segment::new(axis * along, axis * (half + 5.0));
                assert!(!at(0.0).is_entered_by(from(half - 0.0009), 0.001), "{half} {turn}");
                assert!(at(0.0).is_entered_by(from(half - 0.0011), 0.001), "{half} {turn}");
            }
        }
    }

    #[test]
    fn a_turned_square_reaches_further() {
        let quarter = core::f64::consts::FRAC_PI_4;
        assert!(square(0.0, 0.0, 0.0).overlaps(&square(1.15, 0.0, quarter), 1e-4));
        assert!(!square(0.0, 0.0, 0.0).overlaps(&square(1.21, 0.0, quarter), 1e-4));
    }

    #[test]
    fn boxes_of_squares_meet_but_diagonals_do_not() {
        let quarter = core::f64::consts::FRAC_PI_4;
        assert!(!square(0.0, 0.0, quarter).overlaps(&square(0.9, 0.9, quarter), 1e-4));
    }

    #[test]
    fn a_disc_is_as_wide_as_its_radius_and_lets_corners_pass() {
        let disc = Convex::disc(Point::ZERO, Point::splat(1.0), Point::X);
        let Bounds { low, high } = disc.bounds();
        assert!((low + Point::ONE).length() < 1e-12 && (high - Point::ONE).length() < 1e-12);
        let near_corner = Convex::rectangle(Point::splat(1.3), Point::splat(0.5), Point::X);
        assert!(!disc.overlaps(&near_corner, 1e-4));
    }

    #[test]
    fn a_wall_along_the_back_does_not_enter() {
        let body = square(0.0, 0.0, 0.0);
        let line = |west: f64, y: f64| Segment::new(Point::new(west, y), Point::new(2.0, y));
        assert!(!body.is_entered_by(line(-2.0, 0.5), 1e-3));
        assert!(body.is_entered_by(line(-2.0, 0.4), 1e-3));
        assert!(!body.is_entered_by(line(0.6, 0.0), 1e-3));
    }

    #[test]
    fn circles_and_all_axes_agree_about_discs() {
        let all_axes = |a: &Convex, b: &Convex, tolerance: f64| {
            let plain = |shape: &Convex| Convex { radius: None, ..*shape };
            plain(a).overlaps(&plain(b), tolerance)
        };
        let (mut told, mut met) = (0, 0);
        for number in 0..4000 {
            let at = |step: f64| (f64::from(number) * step).rem_euclid(1.0);
            let place = Point::new(at(0.618_034), at(0.414_214)) * 2.0 - 1.0;
            let half = Point::new(at(0.732_051), at(0.236_068)).max(Point::splat(1e-3));
            let rectangle = Convex::rectangle(place, half, Point::from_angle(at(0.302_776) * 7.0));
            let disc = Convex::disc(Point::ZERO, Point::splat(0.3), Point::from_angle(at(0.162_278)));
            for tolerance in [-0.01, 0.0, 5e-4, 0.01] {
                let expected = all_axes(&rectangle, &disc, tolerance);
                assert_eq!(rectangle.overlaps(&disc, tolerance), expected, "{number} {tolerance}");
                assert_eq!(disc.overlaps(&rectangle, tolerance), expected, "{number} {tolerance}");
                told += usize::from(rectangle.is_met_by_disc(&disc, tolerance).is_some());
                met += usize::from(expected);
            }
        }
        assert!(told > 15_000 && met > 4_000 && met < 12_000, "{told} {met}");
        let flat = Convex::rectangle(Point::ZERO, Point::new(0.5, 0.0), Point::X);
        let disc = Convex::disc(Point::ZERO, Point::splat(0.3), Point::X);
        assert_eq!(flat.overlaps(&disc, 5e-4), all_axes(&flat, &disc, 5e-4));
    }
}
