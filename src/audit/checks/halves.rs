//! `crowded_half`: nearly all furniture in one half of a room while the other has room for some.

use crate::audit::convex::{area, half};
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::possible::{Ask, Held, Question};
use crate::audit::quantity::Quantity;
use crate::audit::subject::{Body, Subject};
use crate::geometry::{Line, Point, Polygon, Segment, Solid};
use crate::layout::Placement;

/// Judges the halves of a room along both of its main axes.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, ask, .. } = *evidence;
    let rules = subject.rules();
    if subject.at.room.region.area() < rules.balance.least_area {
        return Vec::new();
    }
    let bodies = subject.bodies.iter().enumerate();
    let standing: Vec<Standing<'_>> = bodies.filter(|(_, body)| body.is_standing(rules)).collect();
    let middle = middle_of(subject);
    let along = main_direction(subject);
    let mut crowds: Vec<(f64, usize, Line)> = [along, along.perp(), -along, -along.perp()]
        .into_iter()
        .filter_map(|direction| {
            let line = Line { point: middle, direction };
            let (share, largest) = crowd(subject, &standing, line)?;
            Some((share, largest, line))
        })
        .collect();
    // The greatest share first, for the question about room beside it is the dearest of all; stable: of equals the first direction.
    crowds.sort_by(|(a, ..), (b, ..)| b.total_cmp(a));
    let worst = crowds
        .into_iter()
        .find(|&(_, largest, line)| has_room_beside(subject, &subject.bodies[largest], line, ask));
    let fault = |(share, largest, _): (f64, usize, Line)| {
        Fault::new(Quantity::Share, vec![subject.object(largest)], share, rules.balance.share)
    };
    worst.map(fault).into_iter().collect()
}

/// A body that stands on the floor, with its index.
type Standing<'s> = (usize, &'s Body<'s>);

/// The share of the footprints to the right of a line if that is too much, with the index of the largest piece there.
///
/// One piece that outweighs all others cannot be balanced: moving it would crowd the other half.
fn crowd(subject: &Subject<'_>, standing: &[Standing<'_>], line: Line) -> Option<(f64, usize)> {
    let limit = subject.rules().balance.share;
    let all: f64 = standing.iter().map(|(_, body)| box_area(body)).sum();
    // A piece on the line counts in both halves, by its share of each.
    let right: f64 = standing.iter().map(|(_, body)| box_area(body) * share_right_of(body, line)).sum();
    let share = right / all;
    if all == 0.0 || share <= limit {
        return None;
    }
    let on_right = standing.iter().filter(|(_, body)| share_right_of(body, line) >= 1.0);
    let by_area = |(_, a): &&Standing<'_>, (_, b): &&Standing<'_>| {
        // Of equal areas the first id, whatever the order of the placements.
        box_area(a).total_cmp(&box_area(b)).then(b.id.cmp(&a.id))
    };
    let &(index, largest) = on_right.max_by(by_area)?;
    let is_better = 1.0 - (share - box_area(largest) / all) <= limit;
    is_better.then_some((share, index))
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
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};

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
    fn one_piece_a_small_room_or_a_half_without_space_are_fine() {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.stand("chest", at(0.5, 0.5));
        assert_eq!(room.audit(), []);
        let mut small = TestRoom::rectangle(3.0, 3.0);
        small.stand("chest", at(0.5, 0.5));
        small.stand("chest", at(0.5, 2.5));
        assert_eq!(small.audit(), []);
        // The other half is 0.9 m wide, too narrow for a chest.
        let corners = [
            (0.0, 0.0),
            (4.0, 0.0),
            (4.0, 0.55),
            (12.0, 0.55),
            (12.0, 1.45),
            (4.0, 1.45),
            (4.0, 2.0),
            (0.0, 2.0),
        ];
        let mut tail = TestRoom::outline(&corners);
        tail.stand("chest", at(0.5, 0.5));
        tail.stand("chest", at(0.5, 1.5));
        assert_eq!(tail.count(Code::CrowdedHalf), 0);
    }
}
