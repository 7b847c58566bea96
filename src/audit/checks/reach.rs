//! `unreachable`: a door, or a side of an object that is used, that people cannot walk to; and the walkable
//! rate of every door.
//!
//! Widths are known to a cell of the floor: 5 cm, in rooms whose box has more than 28,000 m² 10, above 112,000 m² 15.

use std::rc::Rc;

use crate::walk::{CELL, Floor, Goal};

use crate::audit::evidence::Evidence;
use crate::audit::fault::{Fault, FloorRegion, Named};
use crate::audit::possible::Held;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::Subject;
use crate::audit::taking::clearance_regions;
use crate::audit::zone::{Purpose, Zone};

/// A goal of the people in a room.
#[derive(Clone, Copy)]
pub(crate) enum Target<'z> {
    /// A door, by index into the level's openings.
    Door(usize),
    /// The space before a side of an object, and the object's index.
    Side(&'z Zone, usize),
}

impl<'z> Target<'z> {
    pub(crate) fn goal(self) -> Goal<'z> {
        match self {
            Self::Door(door) => Goal::Door(door),
            Self::Side(zone, _) => Goal::Area(&zone.base),
        }
    }
}

/// The share of the floor that people reach from a door, by index into the level's openings.
pub(crate) type Rates = Vec<(usize, f64)>;

/// The floor that people walk on; `None` without doors or without bodies in the way, where there is nothing to
/// judge.
pub(crate) fn floor(subject: &Subject<'_>) -> Option<Rc<Floor>> {
    let rules = &subject.rules().walking;
    let has_bodies = subject.bodies.iter().any(|body| body.low() < rules.body_height);
    has_bodies.then(|| subject.empty_floors.walking_among(subject.obstacles())).flatten()
}

/// The walkable rates of the doors.
pub(crate) fn rates(subject: &Subject<'_>, floor: &Floor) -> Rates {
    let robot = floor.walk(subject.rules().walking.robot);
    robot.doors().map(|(door, group)| (door, robot.rate(group))).collect()
}

/// Judges the ways from every door to every other and to all furniture.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, floor, zones, .. } = *evidence;
    let Some(floor) = floor else { return Vec::new() };
    let walk = floor.walk(subject.rules().walking.person);
    // The door from which the others are reached, in whatever room they are compared with.
    let home = walk.main_door();
    let goals = goals(subject, zones, floor);
    let missed: Vec<Target<'_>> = goals.into_iter().filter(|goal| !walk.reaches(home, goal.goal())).collect();
    if missed.is_empty() { Vec::new() } else { explain(subject, floor, home, &missed) }
}

/// Every door and every side with room for somebody. Narrower strips (beside a toilet) are elbow room.
pub(crate) fn goals<'z>(subject: &Subject<'_>, zones: &'z [Zone], floor: &Floor) -> Vec<Target<'z>> {
    let rules = subject.rules().walking;
    let sides = zones.iter().filter_map(|zone| {
        let Purpose::Using(owner, number) = zone.purpose else { return None };
        // One of several sides is enough, and a bed is got into by its foot as well.
        let clearance = subject.bodies[owner].class.clearances.get(number)?;
        let is_stood_in = clearance.minimum >= rules.narrow_person && zone.heights.0 < rules.body_height;
        is_stood_in.then_some(Target::Side(zone, owner))
    });
    floor.doors().map(Target::Door).chain(sides).collect()
}

/// The faults of goals that are not reached. What the empty room allows is asked of the furnished one: the
/// full width, else the narrow one; what it does not allow is the plan's fault.
fn explain(subject: &Subject<'_>, floor: &Floor, home: usize, missed: &[Target<'_>]) -> Vec<Fault> {
    let rules = subject.rules().walking;
    let empty = subject.empty_floors.walking().expect("furniture closes no door");
    let (wide, narrow) = (empty.walk(rules.person), empty.walk(rules.narrow_person));
    let widths = widest(floor, home, missed, rules.person);
    let mut faults: Vec<Fault> = Vec::new();
    for (&goal, width) in missed.iter().zip(widths) {
        // A way that the plan itself makes narrow is asked for at the width of a narrow person.
        let required = if wide.reaches(home, goal.goal()) { rules.person } else { rules.narrow_person };
        if width < required - ROUNDING {
            let fault = Fault::new(Quantity::Width, vec![named(subject, goal)], width, required);
            let is_possible = required == rules.person || narrow.reaches(home, goal.goal());
            let is_possible = if is_possible { Held::Yes } else { Held::No };
            faults.push(fault.about(region(subject, goal)).if_possible(is_possible));
        }
    }
    // An object with several sides makes one fault.
    faults.dedup_by(|a, b| a.subjects == b.subjects);
    faults
}

/// The floor that people need at an object; a door has none of its own.
pub(crate) fn region(subject: &Subject<'_>, target: Target<'_>) -> Vec<FloorRegion> {
    match target {
        Target::Door(_) => Vec::new(),
        Target::Side(_, owner) => {
            clearance_regions(&subject.bodies[owner], false, |clearance| clearance.minimum > 0.0)
        }
    }
}

/// For each goal the widest disc that gets there, to a cell and below `missed_by`; zero where none does.
pub(crate) fn widest(floor: &Floor, home: usize, goals: &[Target<'_>], missed_by: f64) -> Vec<f64> {
    let mut widths = vec![0.0; goals.len()];
    let steps = (missed_by / CELL) as u32;
    // From the widest down, a cell at a time: the first disc that gets there is the widest.
    for diameter in (1..steps).map(|step| missed_by - f64::from(step) * CELL) {
        if !widths.contains(&0.0) {
            break;
        }
        let walk = floor.walk(diameter);
        for (width, &goal) in widths.iter_mut().zip(goals) {
            if *width == 0.0 && walk.reaches(home, goal.goal()) {
                *width = diameter;
            }
        }
    }
    widths
}

/// The element that a target is.
pub(crate) fn named(subject: &Subject<'_>, target: Target<'_>) -> Named {
    match target {
        Target::Door(door) => subject.opening(door),
        Target::Side(_, owner) => subject.object(owner),
    }
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::plan::OpeningKind;

    /// A room of 6 × 3 m with doors in its short walls, and a row of chests across its middle that leaves a
    /// gap at the north wall.
    fn divided(gap: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 3.0);
        room.open(1, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
        room.open(3, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
        room.stand("chest", at(3.0, 0.5));
        room.stand("chest", at(3.0, 1.5));
        let last = room.stand("chest", at(3.0, 2.5 - gap / 2.0));
        room.placements[last].size.depth = 1.0 - gap;
        room
    }

    #[test]
    fn a_gap_of_half_a_metre_joins_the_doors_and_a_narrower_one_parts_them() {
        assert_eq!(divided(0.46).count(Code::Unreachable), 0);
        let findings = divided(0.38).audit();
        assert_eq!((findings[0].code, findings.len()), (Code::Unreachable, 1), "{findings:?}");
        assert_eq!(findings[0].objects, ["door:1"]);
        assert_eq!(findings[0].threshold, 0.45);
        assert!((findings[0].measured - 0.4).abs() < 1e-9 || (findings[0].measured - 0.35).abs() < 1e-9);
    }

    #[test]
    fn what_hangs_overhead_or_lies_flat_is_in_nobodys_way() {
        let mut room = divided(0.0);
        assert_eq!(room.count(Code::Unreachable), 1);
        for placement in &mut room.placements {
            placement.size.height = 0.015;
        }
        assert_eq!(room.count(Code::Unreachable), 0);
        for placement in &mut room.placements {
            (placement.size.height, placement.elevation) = (0.5, 1.6);
        }
        assert_eq!(room.count(Code::Unreachable), 0);
    }

    #[test]
    fn a_desk_behind_a_barrier_is_not_reached_and_one_before_it_is() {
        let mut room = TestRoom::rectangle(6.0, 4.0);
        room.open(3, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
        let desk = room.stand("desk", at(5.0, 2.0));
        for number in 0..4 {
            room.stand("chest", at(3.0, 0.5 + f64::from(number)));
        }
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::Unreachable, 1));
        assert_eq!(findings[0].objects, ["desk.1"]);
        room.placements[desk].position.x = 1.2;
        assert_eq!(room.count(Code::Unreachable), 0);
    }

    #[test]
    fn a_room_that_narrows_asks_less_and_one_that_is_too_narrow_is_the_plans_fault() {
        // Two rooms of 2 m joined by a neck of some width, a door in each.
        let joined = |neck: f64| {
            let corners = [
                (0.0, 0.0),
                (5.0, 0.0),
                (5.0, 2.0),
                (3.0, 2.0),
                (3.0, neck),
                (2.0, neck),
                (2.0, 2.0),
                (0.0, 2.0),
            ];
            let mut room = TestRoom::outline(&corners);
            room.open(1, OpeningKind::Door, (0.5, 1.4), (0.0, 2.0));
            room.open(7, OpeningKind::Door, (0.5, 1.4), (0.0, 2.0));
            room.stand("stool", at(4.0, 1.7));
            room.audit()
        };
        assert_eq!(joined(0.5), []);
        assert_eq!(joined(0.36), [], "narrower than a walkway, but the plan leaves no more");
        let findings = joined(0.2);
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].severity, crate::audit::Severity::Given);
    }

    #[test]
    fn an_open_side_leads_round_what_stands_before_it() {
        let mut room = divided(0.0);
        assert_eq!(room.count(Code::Unreachable), 1);
        room.open(2, OpeningKind::OpenBoundary, (0.5, 5.5), (0.0, 2.5));
        assert_eq!(room.count(Code::Unreachable), 0);
    }

    #[test]
    fn the_rate_of_a_door_is_its_share_of_the_floor() {
        let room = divided(0.0);
        let verdict = room.judge();
        let rates: Vec<f64> = verdict.walkable.iter().map(|door| door.rate).collect();
        assert!(rates.iter().all(|rate| (rate - 0.5).abs() < 0.03), "{rates:?}");
        let rates = divided(0.6).judge().walkable;
        assert!(rates.iter().all(|door| door.rate > 0.99), "{rates:?}");
    }
}
