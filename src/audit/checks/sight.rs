//! `out_of_sight`: a seat that does not see what its row looks at: the stage, the screen, the altar.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::{Body, Subject};
use crate::catalog::{ParentName, Relation, RelationKind};
use crate::geometry::Segment;

/// Judges the pieces that need to see something, where the room has it: one of them in front, and no wall between.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, .. } = *evidence;
    let needs = |relation: &&Relation| relation.kind == RelationKind::Sees && relation.is_needed;
    let faults = subject.bodies.iter().enumerate().flat_map(|(index, body)| {
        body.class.relations.iter().filter(needs).filter_map(move |wish| fault(subject, index, wish))
    });
    faults.collect()
}

/// By how much a piece looks past what it needs to see, or that it is behind a wall; `None` where it sees it or nothing is there.
fn fault(subject: &Subject<'_>, index: usize, wish: &Relation) -> Option<Fault> {
    let ParentName::Classes(classes) = &wish.target else { return None };
    let own = &subject.bodies[index];
    let targets =
        classes.iter().flat_map(|&class| subject.nearest_of(class, own.placement.position).into_owned());
    let angles = targets.map(|target| (target, off(own, &subject.bodies[target])));
    let (target, angle) = angles.reduce(|best, next| if next.1 < best.1 { next } else { best })?;
    let objects = || vec![subject.object(index), subject.object(target)];
    if angle > wish.angle + ROUNDING {
        return Some(Fault::new(Quantity::Angle, objects(), angle.to_degrees(), wish.angle.to_degrees()));
    }
    let sight = Segment::new(own.placement.position, subject.bodies[target].placement.position);
    let mut walls = subject.at.room.walls.iter();
    walls.any(|wall| sight.crosses(wall.segment())).then(|| Fault::new(Quantity::Count, objects(), 0.0, 1.0))
}

/// Radians between where a piece looks and another.
fn off(own: &Body<'_>, other: &Body<'_>) -> f64 {
    let towards = (other.placement.position - own.placement.position).normalize_or(own.front());
    own.front().angle_to(towards).abs()
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::{ParentName, Relation, RelationKind};

    /// A hall with a corner to the north-east cut out, where stools need to see a desk.
    fn bent_hall() -> TestRoom {
        let mut room =
            TestRoom::outline(&[(0.0, 0.0), (12.0, 0.0), (12.0, 4.0), (4.0, 4.0), (4.0, 12.0), (0.0, 12.0)]);
        let (stool, desk) =
            (room.catalog.class_index("stool").unwrap(), room.catalog.class_index("desk").unwrap());
        room.catalog.classes[stool].relations = vec![Relation {
            kind: RelationKind::Sees,
            target: ParentName::Classes(vec![desk]),
            distance: (0.5, 50.0),
            angle: 1.0,
            weight: 1.0,
            is_needed: true,
        }];
        room.stand("desk", at(2.0, 11.0));
        room
    }

    #[test]
    fn a_seat_round_the_corner_or_turned_away_does_not_see_the_stage() {
        let seat = |x: f64, y: f64, angle: f64| {
            let mut room = bent_hall();
            let stool = room.stand("stool", at(x, y));
            room.placements[stool].angle = angle;
            room.count(Code::OutOfSight)
        };
        assert_eq!([seat(2.0, 5.0, PI), seat(3.5, 1.0, PI)], [0, 0], "in the wing of the stage");
        assert_eq!(seat(6.0, 2.0, PI), 1, "a wall is between");
        assert_eq!(seat(2.0, 5.0, 0.0), 1, "it looks the other way");
    }

    #[test]
    fn without_a_stage_nobody_misses_the_sight_of_it() {
        let mut room = bent_hall();
        room.placements.clear();
        room.stand("stool", at(6.0, 2.0));
        assert_eq!(room.count(Code::OutOfSight), 0);
    }
}
