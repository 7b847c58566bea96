//! `bedside`: a double bed that people get into from one side only.

use crate::audit::evidence::Evidence;
use crate::audit::fault::{Fault, FloorRegion};
use crate::audit::groups::BED;
use crate::audit::possible::{Held, Question};
use crate::audit::quantity::Quantity;
use crate::audit::subject::{Body, Subject};
use crate::audit::taking::clearance_regions;
use crate::catalog::{Clearance, Side};
use crate::walk::Walk;

/// Judges the double beds of a room with a floor to walk on.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, floor, ask, .. } = *evidence;
    let mut faults = Vec::new();
    let mut beds = subject.bodies.iter().enumerate().filter(|(_, body)| is_double(body)).peekable();
    let (Some(floor), true) = (floor, beds.peek().is_some()) else { return faults };
    // What is narrower than the disc by a cell still lets somebody in sideways.
    let walk = floor.walk(subject.rules().beds.other_side);
    for (index, bed) in beds {
        let reached =
            [Side::Left, Side::Right].into_iter().filter(|&side| is_reached(subject, &walk, bed, side));
        if reached.count() != 1 {
            continue;
        }
        let is_possible = ask(&Question::Class(bed.placement.class));
        if is_possible != Held::No {
            let fault = Fault::new(Quantity::Count, vec![subject.object(index)], 1.0, 2.0);
            faults.push(fault.about(sides_of(bed)).if_possible(is_possible));
        }
    }
    faults
}

/// The regions that stay free at the two sides of a bed.
fn sides_of(bed: &Body<'_>) -> Vec<FloorRegion> {
    let is_side = |clearance: &Clearance| matches!(clearance.side, Side::Left | Side::Right);
    clearance_regions(bed, false, is_side)
}

/// A bed for two is one whose class asks for space at both sides.
fn is_double(body: &Body<'_>) -> bool {
    let asks = |side: Side| body.class.clearances.iter().any(|clearance| clearance.side == side);
    body.is_in(BED) && asks(Side::Left) && asks(Side::Right)
}

fn is_reached(subject: &Subject<'_>, walk: &Walk<'_>, bed: &Body<'_>, side: Side) -> bool {
    let depth = subject.rules().beds.other_side;
    walk.enters(&bed.strip(side, 0.0, depth))
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::{Clearance, Side};
    use crate::plan::OpeningKind;

    /// A bed of 1.5 × 2.1 m for two, its left side `gap` metres from the west wall.
    fn bed_beside_wall(gap: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(4.0, 4.0);
        room.open(0, OpeningKind::Door, (2.8, 3.7), (0.0, 2.0));
        room.group("desk", "bed");
        let desk = room.catalog.class_index("desk").unwrap();
        let beside = |side| Clearance {
            side,
            minimum: 0.3,
            good: 0.3,
            margin: 0.0,
            height: 1.1,
            allows_children: true,
        };
        room.catalog.classes[desk].clearances = vec![beside(Side::Left), beside(Side::Right)];
        room.catalog.classes[desk].sizes[0].depth = 2.1;
        room.stand("desk", at(gap + 0.75, 2.95));
        room
    }

    #[test]
    fn both_sides_are_reached_or_it_is_pushed_against_the_wall() {
        assert_eq!(bed_beside_wall(0.32).audit(), []);
        let room = bed_beside_wall(0.1);
        assert_eq!(room.count(Code::Bedside), 1);
        assert_eq!(room.audit().iter().find(|one| one.code == Code::Bedside).unwrap().objects, ["desk.1"]);
    }

    #[test]
    fn a_bed_for_one_may_stand_at_the_wall() {
        let mut room = bed_beside_wall(0.1);
        let desk = room.catalog.class_index("desk").unwrap();
        room.catalog.classes[desk].clearances.remove(0);
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn a_room_without_space_at_both_sides_allows_one() {
        let mut room = TestRoom::rectangle(2.05, 4.0);
        let wide = bed_beside_wall(0.05);
        (room.catalog, room.placements) = (wide.catalog, wide.placements);
        room.open(0, OpeningKind::Door, (0.8, 1.7), (0.0, 2.0));
        assert_eq!(room.count(Code::Bedside), 0);
    }
}
