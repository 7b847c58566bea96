//! Makes the outlines of rooms straight where an opening lies in a round wall: no frame is bent.

use super::level::Storey;
use crate::geometry::{Bounds, Point};
use crate::plan::OpeningPlace;
use crate::plan::limits::OUTLINE_CORNERS;
use crate::plan::read::straight::straightened;

/// Cosine of the largest turn of a flattened arc at one corner, an eighth of half a turn; corners of rooms turn further.
const SMOOTH: f64 = 0.91;
/// Cosine of the smallest turn that is one.
const STRAIGHT: f64 = 0.999_999;
/// Corners at one place that are passed over: closed rings repeat their first.
const MOST_REPEATS: usize = 4;
/// Metres around the middle of an opening, beyond half its width, in which rooms are looked for.
const REACH: f64 = 0.6;

/// Straightens the outlines of a storey beside its openings, where all corners beside an opening are those of an arc.
pub(super) fn straighten(storey: &mut Storey) {
    let places = storey.rooms_by_place();
    for opening in &storey.draft.openings {
        let OpeningPlace::Points { center, along: Some(along) } = opening.place else { continue };
        let near = places.near(Bounds::around_point(center, opening.width / 2.0 + REACH));
        for room in near {
            let room = &mut storey.draft.rooms[room];
            for ring in std::iter::once(&mut room.outline).chain(&mut room.holes) {
                let beside = Beside { center, along, reach: opening.width / 2.0 + REACH };
                // Longer ones are refused later.
                if ring.len() <= OUTLINE_CORNERS && beside.is_bend(ring) {
                    let straight = straightened(ring, center, along, opening.width);
                    *ring = straight.unwrap_or_else(|| std::mem::take(ring));
                }
            }
        }
    }
}

/// A stretch of wall with an opening.
struct Beside {
    center: Point,
    along: Point,
    reach: f64,
}

impl Beside {
    /// Whether a ring bends there, and turns nowhere as at a corner.
    fn is_bend(&self, ring: &[Point]) -> bool {
        let mut has_bend = false;
        for (index, corner) in ring.iter().enumerate() {
            let off = *corner - self.center;
            if off.dot(self.along).abs() > self.reach || off.perp_dot(self.along).abs() > REACH {
                continue;
            }
            let next = ring.iter().cycle().skip(index + 1).take(MOST_REPEATS).find(|next| *next != corner);
            let former = ring.iter().rev().cycle().skip(ring.len() - index).take(MOST_REPEATS);
            let former = former.into_iter().find(|former| *former != corner);
            let (Some(former), Some(next)) = (former, next) else { return false };
            let turn = (*corner - *former).normalize_or_zero().dot((*next - *corner).normalize_or_zero());
            if turn < SMOOTH {
                return false;
            }
            has_bend |= turn < STRAIGHT;
        }
        has_bend
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(radius: f64) -> Vec<Point> {
        let corner = |index: u32| Point::from_angle(f64::from(index) * std::f64::consts::PI / 24.0) * radius;
        (0..48).map(corner).collect()
    }

    #[test]
    fn arcs_bend_and_corners_do_not() {
        let beside = Beside { center: Point::new(3.0, 0.0), along: Point::Y, reach: 0.8 };
        assert!(beside.is_bend(&circle(3.0)));
        let square = [(-3.0, -0.5), (3.0, -0.5), (3.0, 2.0), (-3.0, 2.0)].map(Point::from);
        assert!(!beside.is_bend(&square));
        let long = [(-3.0, -5.0), (3.0, -5.0), (3.0, 0.2), (3.0, 5.0), (-3.0, 5.0)].map(Point::from);
        assert!(!beside.is_bend(&long), "a corner on a straight wall is no bend");
    }
}
