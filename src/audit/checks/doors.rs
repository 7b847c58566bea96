//! `door_blocked`: a body in a door's swing or approach.

use std::collections::BTreeMap;

use crate::catalog::DoorRules;
use crate::geometry::{Point, Segment, direction};
use crate::plan::{Leaf, Opening, OpeningKind, RoomOpening, RoomRef, Wall};

use crate::audit::evidence::Evidence;
use crate::audit::fault::{Fault, FloorRegion};
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::zone::{Purpose, Zone};

/// Corners of the arc of each eighth of a turn; the chords then stay within 1.1 mm of a 0.9 m leaf's arc.
const ARC_CORNERS: u32 = 8;
/// Corners of the box before an opening.
const APPROACH_CORNERS: usize = 4;

/// The zones of all openings that people walk through, on the room's side.
pub(crate) fn zones(at: RoomRef<'_>, rules: DoorRules) -> Vec<Zone> {
    let RoomRef { level, room, .. } = at;
    let mut zones = Vec::new();
    for place in &room.openings {
        let opening = &level.openings[place.opening];
        if opening.kind.is_walkable() {
            let wall = &room.walls[place.wall];
            zones.push(approach(wall, place, opening, rules));
            let opens_here = |leaf: &&Leaf| (middle_of_swing(leaf) - wall.start).dot(wall.normal()) > 0.0;
            for leaf in opening.leaves.iter().filter(opens_here) {
                zones.extend(swing(place.opening, opening, leaf));
            }
        }
    }
    zones
}

/// The sectors that the leaves of a room's doors sweep inside it, in convex pieces.
pub(crate) fn swings(at: RoomRef<'_>, rules: DoorRules) -> impl Iterator<Item = Vec<Point>> {
    // An approach has four corners; the pieces of a swing have those of an arc.
    let is_swing = |zone: &Zone| zone.base.len() > APPROACH_CORNERS;
    zones(at, rules).into_iter().filter(is_swing).map(|zone| zone.base)
}

/// The box before an opening: as deep as the opening is wide, at most the rule's depth.
fn approach(wall: &Wall, place: &RoomOpening, opening: &Opening, rules: DoorRules) -> Zone {
    let is_open = opening.kind == OpeningKind::OpenBoundary;
    let (most, ends) = if is_open {
        (rules.open_boundary_depth, rules.free_ends(place.to - place.from))
    } else {
        (rules.approach_depth, 0.0)
    };
    // A hatch of half a metre needs half a metre before it; people who carry things need no more before wide doors.
    let inward = wall.normal() * opening.width.min(most);
    let face = wall.stretch(place.from + ends, place.to - ends);
    Zone {
        purpose: Purpose::Passing(place.opening),
        base: vec![face.start, face.end, face.end + inward, face.start + inward],
        heights: (opening.bottom, opening.top),
        face,
    }
}

/// The sector that a leaf sweeps, in convex pieces of at most an eighth of a turn.
fn swing(index: usize, opening: &Opening, leaf: &Leaf) -> Vec<Zone> {
    let radius = leaf.hinge.distance(leaf.closed_tip);
    let sweep = swept_angle(leaf);
    let first = leaf.closed_tip - leaf.hinge;
    let start = libm::atan2(first.y, first.x);
    // An eighth of a turn at most (radians): the questions of `convex` are about convex polygons, which a sector of more than half a
    // turn is not, and short pieces have small boxes, which most bodies miss.
    let piece_count = (sweep.abs() / core::f64::consts::FRAC_PI_4).ceil().max(1.0);
    let step = sweep / piece_count;
    let arc_point = |angle: f64| leaf.hinge + direction(angle) * radius;
    let piece = |number: f64| {
        let from = start + number * step;
        let arc = (0..=ARC_CORNERS).map(|i| arc_point(from + step * f64::from(i) / f64::from(ARC_CORNERS)));
        let mut base: Vec<Point> = core::iter::once(leaf.hinge).chain(arc).collect();
        // A leaf that opens clockwise runs the arc the other way; corners are counter-clockwise everywhere.
        if sweep < 0.0 {
            base.reverse();
        }
        let half_width = opening.along * (opening.width / 2.0);
        Zone {
            purpose: Purpose::Passing(index),
            base,
            heights: (opening.bottom, opening.top),
            face: Segment::new(opening.center - half_width, opening.center + half_width),
        }
    };
    (0..piece_count as u32).map(|number| piece(f64::from(number))).collect()
}

/// Radians from shut to open, above zero counter-clockwise.
fn swept_angle(leaf: &Leaf) -> f64 {
    let (closed, open) = (leaf.closed_tip - leaf.hinge, leaf.open_tip - leaf.hinge);
    libm::atan2(closed.perp_dot(open), closed.dot(open))
}

/// A point well inside the swept sector.
fn middle_of_swing(leaf: &Leaf) -> Point {
    let closed = leaf.closed_tip - leaf.hinge;
    let half = direction(swept_angle(leaf) / 2.0);
    leaf.hinge + half.rotate(closed)
}

/// Judges the pairs of zone and body that the broad phase found; a door and a body make one finding.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, zones, hits, .. } = *evidence;
    let mut deepest: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    for &(zone, body) in hits {
        if let Purpose::Passing(opening) = zone.purpose {
            let depth = zone.intrusion(subject, &subject.bodies[body]);
            // The deepest of approach and sectors: a body in several of them is one fault.
            let known = deepest.entry((opening, body)).or_insert(0.0);
            *known = known.max(depth);
        }
    }
    let limit = subject.rules().doors.intrusion;
    let blocked = deepest.into_iter().filter(|&(_, depth)| depth > limit + ROUNDING);
    let fault = |((opening, body), depth): ((usize, usize), f64)| {
        let subjects = vec![subject.object(body), subject.opening(opening)];
        Fault::new(Quantity::Depth, subjects, depth, limit).about(approaches(zones, opening))
    };
    blocked.map(fault).collect()
}

/// The floor before an opening, of which the swing of its leaf is a part.
fn approaches(zones: &[Zone], opening: usize) -> Vec<FloorRegion> {
    let is_approach =
        |zone: &&Zone| zone.purpose == Purpose::Passing(opening) && zone.base.len() == APPROACH_CORNERS;
    zones.iter().filter(is_approach).map(|zone| zone.base.clone()).collect()
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::AuditRules;
    use crate::plan::{Leaf, OpeningKind};

    /// A chest of one metre, its near edge `gap` metres from wall 0, before the middle of the door.
    fn chest_before(kind: OpeningKind, gap: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.open(0, kind, (2.0, 2.9), (0.0, 2.0));
        room.stand("chest", at(2.45, gap + 0.5));
        room
    }

    #[test]
    fn the_approach_is_as_deep_as_the_door_is_wide_at_most_eighty_centimetres() {
        for kind in [OpeningKind::Door, OpeningKind::SlidingDoor, OpeningKind::Passage] {
            assert_eq!(chest_before(kind, 0.80).count(Code::DoorBlocked), 0, "{kind:?}");
            let findings = chest_before(kind, 0.75).audit();
            assert_eq!((findings[0].code, findings.len()), (Code::DoorBlocked, 1));
            assert!((findings[0].measured - 0.05).abs() < 1e-9);
            assert_eq!(findings[0].objects, ["chest.1", "door:0"]);
        }
        let mut narrow = chest_before(OpeningKind::Passage, 0.62);
        narrow.level.openings[0].width = 0.6;
        assert_eq!(narrow.count(Code::DoorBlocked), 0);
    }

    #[test]
    fn people_walk_in_over_a_rug() {
        let lying = |height: f64| {
            let mut room = chest_before(OpeningKind::Passage, 0.1);
            room.placements[0].size.height = height;
            room.audit()
        };
        assert_eq!(lying(0.012), []);
        assert_eq!(lying(0.05)[0].code, Code::DoorBlocked);
    }

    #[test]
    fn an_open_boundary_needs_thirty_centimetres_and_a_window_none() {
        assert_eq!(chest_before(OpeningKind::OpenBoundary, 0.31).count(Code::DoorBlocked), 0);
        assert_eq!(chest_before(OpeningKind::OpenBoundary, 0.25).count(Code::DoorBlocked), 1);
        assert_eq!(chest_before(OpeningKind::Window, 0.0).count(Code::DoorBlocked), 0);
    }

    #[test]
    fn the_ends_of_an_open_boundary_need_no_space_if_people_pass_between_them() {
        let rules = AuditRules::default().doors;
        let ends = [3.0, 1.0, 0.9, 0.7].map(|width| (rules.free_ends(width) * 1000.0).round());
        assert_eq!(ends, [150.0, 100.0, 50.0, 0.0]);
    }

    #[test]
    fn a_lamp_over_the_door_is_out_of_its_way() {
        let mut room = chest_before(OpeningKind::Door, 0.0);
        room.placements[0].elevation = 2.0;
        assert_eq!(room.count(Code::DoorBlocked), 0);
        room.placements[0].elevation = 1.9;
        assert_eq!(room.count(Code::DoorBlocked), 1);
    }

    #[test]
    fn the_swing_reaches_past_the_approach() {
        // Hinge at x = 2.9, opening inwards through 90 degrees, 0.9 m long: the arc's top is at y = 0.9.
        let mut room = chest_before(OpeningKind::Door, 0.85);
        assert_eq!(room.count(Code::DoorBlocked), 0);
        let leaf = Leaf { hinge: at(2.9, 0.0), closed_tip: at(2.0, 0.0), open_tip: at(2.9, 0.9) };
        room.level.openings[0].leaves = vec![leaf];
        assert_eq!(room.count(Code::DoorBlocked), 1);
        room.placements[0].position.y = 0.91 + 0.5;
        assert_eq!(room.count(Code::DoorBlocked), 0);
        // Outside the arc, though inside its square.
        room.placements[0].position = at(1.5, 1.3);
        assert_eq!(room.count(Code::DoorBlocked), 0);
    }

    #[test]
    fn a_door_that_opens_the_other_way_needs_its_approach_only() {
        let mut room = chest_before(OpeningKind::Door, 0.85);
        let leaf = Leaf { hinge: at(2.9, -0.1), closed_tip: at(2.0, -0.1), open_tip: at(2.9, -1.0) };
        room.level.openings[0].leaves = vec![leaf];
        assert_eq!(room.count(Code::DoorBlocked), 0);
    }

    #[test]
    fn a_leaf_that_opens_half_a_turn_sweeps_both_quarters() {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.open(0, OpeningKind::Door, (2.0, 2.9), (0.0, 2.0));
        let leaf = Leaf { hinge: at(2.9, 0.0), closed_tip: at(2.0, 0.0), open_tip: at(3.8, 0.001) };
        room.level.openings[0].leaves = vec![leaf];
        room.stand("lamp", at(3.4, 0.4));
        assert_eq!(room.count(Code::DoorBlocked), 1);
        room.placements[0].position = at(3.8, 0.6);
        assert_eq!(room.count(Code::DoorBlocked), 0);
    }

    #[test]
    fn a_wall_between_door_and_body_hides_it() {
        // A room around a thin tongue of wall, 0.5 m before the door.
        let corners =
            [(0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0), (0.0, 0.6), (4.0, 0.6), (4.0, 0.5), (0.0, 0.5)];
        let mut room = TestRoom::outline(&corners);
        room.open(0, OpeningKind::Passage, (1.0, 1.9), (0.0, 2.0));
        room.stand("lamp", at(1.45, 0.7));
        assert_eq!(room.count(Code::DoorBlocked), 0);
        room.placements[0].position.y = 0.3;
        assert_eq!(room.count(Code::DoorBlocked), 1);
    }
}
