//! `crowded_half`: nearly all furniture in one half of a room while the other has room for some.

use crate::audit::convex::{area, half};
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::possible::{Ask, Held, Question};
use crate::audit::quantity::Quantity;
use crate::audit::subject::{Body, Subject};
use crate::geometry::{Line, Point, Polygon, Region, Segment, Solid};
use crate::layout::Placement;

/// How many of the pieces in a crowded half are asked about, largest first. Larger: more time for rooms that cannot be balanced.
const MOST_ASKED: usize = 3;

/// Steps in which the line between two halves is found: a 4,096th of the room's extent, about a millimetre.
const HALVING_STEPS: u32 = 12;

/// Judges the halves of a room along both of its main axes.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, ask, .. } = *evidence;
    let rules = subject.rules();
    if subject.at.room.region.area() < rules.balance.least_area {
        return Vec::new();
    }
    let bodies = subject.bodies.iter().enumerate();
    let standing: Vec<Standing<'_>> = bodies.filter(|(_, body)| body.is_standing(rules)).collect();
    let along = main_direction(subject);
    let lines = [along, along.perp()].map(|direction| halving_line(&subject.at.room.region, direction));
    let mut crowds: Vec<Crowd> = lines
        .iter()
        .flat_map(|&line| [line, line.reversed()])
        .filter_map(|line| crowd(subject, &standing, line))
        .collect();
    // The greatest share first, for the question about room beside it is the dearest of all; stable: of equals the first direction.
    crowds.sort_by(|a, b| b.share.total_cmp(&a.share));
    let could_move =
        |crowd: &Crowd, &index: &usize| has_room_beside(subject, &subject.bodies[index], crowd.line, ask);
    let worst = crowds.iter().find_map(|crowd| {
        let moved = crowd.pieces.iter().find(|index| could_move(crowd, index))?;
        Some(Fault::new(Quantity::Share, vec![subject.object(*moved)], crowd.share, rules.balance.share))
    });
    worst.into_iter().collect()
}

/// A body that stands on the floor, with its index.
type Standing<'s> = (usize, &'s Body<'s>);

/// A half of a room with too much in it.
struct Crowd {
    /// The half is to the right of it.
    line: Line,
    /// What of the furniture is there, by the area of footprints.
    share: f64,
    /// Indices of pieces there of which each would do better in the other half: the largest first.
    pieces: Vec<usize>,
}

/// The half to the right of a line if too much is in it.
///
/// One piece that outweighs all others cannot be balanced: moving it would crowd the other half.
fn crowd(subject: &Subject<'_>, standing: &[Standing<'_>], line: Line) -> Option<Crowd> {
    let limit = subject.rules().balance.share;
    let all: f64 = standing.iter().map(|(_, body)| box_area(body)).sum();
    // A piece on the line counts in both halves, by its share of each.
    let right: f64 = standing.iter().map(|(_, body)| box_area(body) * share_right_of(body, line)).sum();
    let share = right / all;
    if all == 0.0 || share <= limit {
        return None;
    }
    // Not so much that the other half would be crowded then.
    let balances =
        |body: &Body<'_>| share_right_of(body, line) >= 1.0 && 1.0 - (share - box_area(body) / all) <= limit;
    let mut movable: Vec<&Standing<'_>> = standing.iter().filter(|(_, body)| balances(body)).collect();
    // Of equal areas the first id, whatever the order of the placements.
    movable.sort_by(|(_, a), (_, b)| box_area(b).total_cmp(&box_area(a)).then_with(|| a.id.cmp(&b.id)));
    let pieces = movable.into_iter().take(MOST_ASKED).map(|&(index, _)| index).collect();
    Some(Crowd { line, share, pieces })
}

/// The line in a direction that has half of a region's area on either side.
///
/// Neither the middle of its extent nor its centre: a niche, or an arm of an L, would be a half.
fn halving_line(region: &Region, direction: Point) -> Line {
    let line_at = |right: f64| Line { point: -direction.perp() * right, direction };
    let area_right = |line: Line| {
        let of = |ring: &Polygon| area(&half(ring.corners(), |corner| line.right_of(corner))).abs();
        of(&region.outline) - region.holes.iter().map(of).sum::<f64>()
    };
    let middle = region.area() / 2.0;
    let outermost = line_at(0.0);
    let reach = region.outline.corners().iter().map(|&corner| outermost.right_of(corner));
    let (mut low, mut high) = reach
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), right| (low.min(right), high.max(right)));
    for _ in 0..HALVING_STEPS {
        let between = f64::midpoint(low, high);
        if area_right(line_at(between)) > middle { low = between } else { high = between }
    }
    line_at(f64::midpoint(low, high))
}

/// Whether a body could stand among the others on the left of a line.
fn has_room_beside(subject: &Subject<'_>, body: &Body<'_>, line: Line, ask: Ask<'_>) -> bool {
    let is_around = |other: &&Body<'_>| other.low() < body.high() && !other.placement.is_covering();
    let around = subject.bodies.iter().filter(is_around);
    let among: Vec<&Solid> = around.flat_map(|other| &other.solids).collect();
    let Placement { class, size, .. } = *body.placement;
    ask(&Question::Beside { class, size, among: &among, line }) == Held::Yes
}

fn box_area(body: &Body<'_>) -> f64 {
    body.placement.size.width * body.placement.size.depth
}

/// The share of a body's box to the right of a line.
fn share_right_of(body: &Body<'_>, line: Line) -> f64 {
    let corners = body.corners();
    let kept = half(&corners, |corner| line.right_of(corner));
    if kept.len() < 3 { 0.0 } else { area(&kept) / area(&corners) }
}

/// The centre of the floor's area.
pub(crate) fn middle_of(subject: &Subject<'_>) -> Point {
    let region = &subject.at.room.region;
    let moment = |polygon: &Polygon| {
        // Relative to a corner: far from the origin the plain sum loses digits.
        let base = polygon.corners()[0];
        let parts = polygon.edges().map(|edge| {
            let Segment { start, end } = edge.moved(-base);
            (start + end) * start.perp_dot(end) / 6.0
        });
        parts.sum::<Point>() + base * polygon.area()
    };
    let holes: Point = region.holes.iter().map(moment).sum();
    (moment(&region.outline) - holes) / region.area()
}

/// The direction of the longest wall.
fn main_direction(subject: &Subject<'_>) -> Point {
    let walls = subject.at.room.region.outline.edges();
    let longest = walls.map(Segment::vector).reduce(|longest, wall| {
        if wall.length_squared() > longest.length_squared() { wall } else { longest }
    });
    longest.map_or(Point::X, Point::normalize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};

    /// A hall of 4 × 2 m that goes on to the east, narrower, between two lines and up to an end.
    fn hall_with_tail(end: f64, (south, north): (f64, f64)) -> TestRoom {
        let hall = [(0.0, 0.0), (4.0, 0.0)];
        let tail = [(4.0, south), (end, south), (end, north), (4.0, north)];
        TestRoom::outline(&[&hall[..], &tail, &[(4.0, 2.0), (0.0, 2.0)]].concat())
    }

    #[test]
    fn two_chests_in_one_half_of_a_hall_are_crowded_and_one_in_each_is_not() {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.stand("chest", at(0.5, 0.5));
        room.stand("chest", at(0.5, 3.5));
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::CrowdedHalf, 1));
        assert!((findings[0].measured - 1.0).abs() < 1e-9);
        room.placements[1].position.x = 5.5;
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn both_axes_count() {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.stand("chest", at(0.5, 0.5));
        room.stand("chest", at(5.5, 0.5));
        assert_eq!(room.count(Code::CrowdedHalf), 1);
        room.placements[1].position.y = 1.9;
        assert_eq!(room.count(Code::CrowdedHalf), 0, "a fifth and more in each half");
    }

    #[test]
    fn where_the_largest_cannot_move_the_next_one_may() {
        // The other half is wide enough for a chest, and too narrow for a desk with a seat before it.
        let mut room = hall_with_tail(8.0, (0.4, 1.45));
        room.stand("desk", at(0.8, 1.6));
        assert_eq!(room.count(Code::CrowdedHalf), 0);
        room.stand("chest", at(2.2, 0.5));
        assert_eq!(room.count(Code::CrowdedHalf), 1);
    }

    #[test]
    fn a_room_is_halved_by_its_area() {
        let of = |corners: &[(f64, f64)], direction: Point| {
            let corners: Vec<Point> = corners.iter().map(|&(x, y)| at(x, y)).collect();
            halving_line(&Region::simple(Polygon::new(&corners).unwrap()), direction).point
        };
        let niche = [(0.0, 0.0), (12.0, 0.0), (12.0, 1.0), (4.0, 1.0), (4.0, 4.0), (0.0, 4.0)];
        // 24 m²: 12 of them before x = 3.
        assert!((of(&niche, Point::Y).x - 3.0).abs() < 2e-3);
        assert!((of(&niche, -Point::Y).x - 3.0).abs() < 2e-3);
        assert!((of(&[(0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0)], Point::X).y - 2.0).abs() < 2e-3);
    }

    #[test]
    fn one_piece_a_small_room_or_a_half_without_space_are_fine() {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.stand("chest", at(0.5, 0.5));
        assert_eq!(room.audit(), []);
        let mut small = TestRoom::rectangle(3.0, 3.0);
        small.stand("chest", at(0.5, 0.5));
        small.stand("chest", at(0.5, 2.5));
        assert_eq!(small.audit(), []);
        // The other half is 0.9 m wide, too narrow for a chest.
        let mut tail = hall_with_tail(12.0, (0.55, 1.45));
        tail.stand("chest", at(0.5, 0.5));
        tail.stand("chest", at(0.5, 1.5));
        assert_eq!(tail.count(Code::CrowdedHalf), 0);
    }
}
