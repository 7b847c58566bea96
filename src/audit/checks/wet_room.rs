//! `wet_room`: a tub or shower directly before the toilet bowl, a toilet that faces an open kitchen.

use crate::audit::evidence::Evidence;
use crate::audit::fault::{Fault, Named};
use crate::audit::groups::{BATHING, COOKING, TOILET};
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::{Body, Subject};
use crate::audit::taking::zone;
use crate::audit::zone::{Purpose, Zone};
use crate::catalog::{Clearance, Side};
use crate::geometry::Point;
use crate::plan::{OpeningKind, RoomOpening};

/// Metres above the floor up to which the front of a bowl is looked at.
const BOWL_HEIGHT: f64 = 1.1;

/// The front of every toilet bowl, over its full width.
pub(crate) fn zones(subject: &Subject<'_>) -> Vec<Zone> {
    let depth = subject.rules().wet_rooms.toilet_front;
    let front = Clearance {
        side: Side::Front,
        minimum: depth,
        good: depth,
        margin: 0.0,
        height: BOWL_HEIGHT,
        allows_children: false,
    };
    let toilets = subject.bodies.iter().enumerate().filter(|(_, body)| body.is_in(TOILET));
    toilets.map(|(index, body)| zone(body, &front, depth, Purpose::Bowl(index))).collect()
}

/// Judges the pairs of zone and body that the broad phase found, then what the toilets look at.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, hits, .. } = *evidence;
    let mut faults = Vec::new();
    // As much as any clearance forgives (metres): a tub that touches the region is no fault.
    let limit = subject.rules().clearances.intrusion + ROUNDING;
    for &(zone, body) in hits {
        let Purpose::Bowl(toilet) = zone.purpose else { continue };
        let other = &subject.bodies[body];
        if other.is_in(BATHING) && zone.intrusion(subject, other) > limit {
            let subjects = vec![subject.object(toilet), subject.object(body)];
            let depth = subject.rules().wet_rooms.toilet_front;
            faults.push(Fault::new(Quantity::FreeDepth, subjects, zone.free_depth(other), depth));
        }
    }
    let bodies = || subject.bodies.iter().enumerate();
    let cookers: Vec<usize> =
        bodies().filter(|(_, body)| body.is_in(COOKING)).map(|(index, _)| index).collect();
    for (index, toilet) in bodies().filter(|(_, body)| body.is_in(TOILET)) {
        if let Some((kitchen, distance)) = kitchen_before(subject, &cookers, toilet) {
            let subjects = vec![subject.object(index), kitchen];
            // No distance would be enough, so that the limit is the measure itself.
            faults.push(Fault::new(Quantity::Distance, subjects, distance, distance));
        }
    }
    faults
}

/// The open kitchen that a toilet faces: a cooker in the same room, or an opening without a door to a room
/// that one cooks in; with the metres up to it.
fn kitchen_before(subject: &Subject<'_>, cookers: &[usize], toilet: &Body<'_>) -> Option<(Named, f64)> {
    let (from, along) = (toilet.placement.position, toilet.front());
    let ahead = |point: Point| {
        let offset = point - from;
        let aside = offset.perp_dot(along).abs();
        // Within an eighth of a turn to either side: what somebody sees who sits there and looks straight ahead.
        (offset.dot(along) > 0.0 && aside <= offset.dot(along)).then_some(offset.length())
    };
    let position = |cooker: usize| subject.bodies[cooker].placement.position;
    let cooker = cookers.iter().find_map(|&cooker| Some((subject.object(cooker), ahead(position(cooker))?)));
    let through = || {
        subject.at.room.openings.iter().find_map(|place| {
            let wall = &subject.at.room.walls[place.wall];
            let middle = wall.after(f64::midpoint(place.from, place.to));
            let distance = ahead(middle).filter(|_| leads_to_kitchen(subject, place))?;
            Some((subject.opening(place.opening), distance))
        })
    };
    // The cooker first: it is nearer than any opening that leads to one, and one finding a toilet is enough.
    cooker.or_else(through)
}

fn leads_to_kitchen(subject: &Subject<'_>, place: &RoomOpening) -> bool {
    let opening = &subject.at.level.openings[place.opening];
    let is_open = matches!(opening.kind, OpeningKind::Passage | OpeningKind::OpenBoundary);
    let cooks = |room: usize| {
        let room_type = subject.catalog.room_types.get(&subject.at.level.rooms[room].room_type);
        let lines = room_type.into_iter().flat_map(|room_type| &room_type.programme);
        // By the programme, not by what stands there: the other room is not furnished yet, or in another file.
        let mut classes = lines.flat_map(|line| &line.classes);
        classes.any(|&class| subject.catalog.classes[class].groups.iter().any(|group| group == COOKING))
    };
    let is_here = |room: usize| core::ptr::eq(&raw const subject.at.level.rooms[room], subject.at.room);
    is_open && opening.sides.iter().any(|side| !is_here(side.room) && cooks(side.room))
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at, required};
    use crate::plan::{OpeningKind, OpeningSide};

    /// A bowl (the stool, 0.4 square) that faces south, its front edge at y = 2.
    fn bathroom() -> TestRoom {
        let mut room = TestRoom::rectangle(4.0, 3.0);
        room.group("stool", "wc");
        room.group("chest", "bathing");
        room.stand("stool", at(2.0, 2.2));
        room
    }

    #[test]
    fn a_tub_right_before_the_bowl_is_wrong_and_one_beside_it_is_not() {
        let mut room = bathroom();
        let tub = room.stand("chest", at(2.0, 1.0));
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::WetRoom, 1));
        assert_eq!(findings[0].objects, ["chest.1", "stool.1"]);
        assert!((findings[0].measured - 0.5).abs() < 1e-9);
        room.placements[tub].position.y = 0.96;
        assert_eq!(room.audit(), []);
        room.placements[tub].position = at(2.0 + 0.2 + 0.5, 1.6);
        assert_eq!(room.audit(), [], "it touches the zone at its side");
    }

    #[test]
    fn a_bowl_does_not_face_a_cooker_or_an_open_kitchen() {
        let mut room = bathroom();
        room.group("table", "cooking");
        let cooker = room.stand("table", at(2.0, 0.5));
        assert_eq!(room.count(Code::WetRoom), 1);
        room.placements[cooker].position = at(3.2, 2.6);
        assert_eq!(room.count(Code::WetRoom), 0);
        let mut room = bathroom();
        room.group("table", "cooking");
        room.open(0, OpeningKind::Passage, (1.5, 2.5), (0.0, 2.0));
        room.ask(required("table"));
        assert_eq!(room.count(Code::WetRoom), 0, "the passage leads into the open");
        let kitchen = room.level.rooms[0].clone();
        room.level.rooms.push(kitchen);
        room.level.openings[0].sides.push(OpeningSide { room: 1, wall: 0, from: 1.5, to: 2.5 });
        assert_eq!(room.count(Code::WetRoom), 1);
        room.level.openings[0].kind = OpeningKind::Door;
        assert_eq!(room.count(Code::WetRoom), 0);
    }
}
