//! Beside an object or a column: the touching sides meet, the position along them is free (section 3.2).

use crate::catalog::{Along, Side, Turn};
use crate::geometry::Point;
use crate::layout::agent::Agent;
use crate::layout::body::{Pose, outward};
use crate::layout::constants::{CONTACT_TOLERANCE, TRIALS_PER_SIDE};
use crate::layout::place::{AgentIndex, ParentPart};
use crate::layout::seed::Stream;
use crate::plan::Wall;

use super::View;
use super::turn::{self, Bearing};

/// A side of a parent as a line that children touch.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// Middle of the side.
    center: Point,
    /// Unit vector away from the parent.
    outward: Point,
    /// Metres along the side.
    length: f64,
    /// Metres of the parent's underside above the floor.
    base: f64,
    /// The parent's middle.
    parent_center: Point,
    /// The parent's angle.
    parent_angle: f64,
    /// Places on the side, and how many are taken.
    places: (u32, u32),
}

/// Poses at a side of a resting agent.
pub(super) fn propose_at_agent(
    view: &View<'_>,
    parent: AgentIndex,
    stream: &mut Stream,
    poses: &mut Vec<Pose>,
) {
    let agent = &view.environment.agents[parent];
    let Some(rest) = agent.rest() else { return };
    let (width, depth) = (agent.size.width, agent.size.depth);
    let (reach, length) = match view.side {
        Side::Left | Side::Right => (width / 2.0, depth),
        _ => (depth / 2.0, width),
    };
    let out = rest.pose.turn(outward(view.side));
    let offer = view.environment.class(parent).offer(view.side);
    let face = Face {
        center: rest.pose.position + out * reach,
        outward: out,
        length,
        base: rest.pose.elevation,
        parent_center: rest.pose.position,
        parent_angle: rest.pose.angle,
        places: (offer.places, agent.taken[view.side.index()]),
    };
    let mut found = Vec::new();
    propose(view, &face, stream, &mut found);
    if let Some(wall) = run_along(view, parent) {
        let ends = ends_of_wall(view, wall);
        found.retain(|pose| is_within(view, pose, ends, wall));
    }
    poses.append(&mut found);
}

/// The wall along which an agent and its parent would make a run: both of one kind, with their backs to it.
fn run_along(view: &View<'_>, mut parent: AgentIndex) -> Option<usize> {
    let environment = view.environment;
    let own = environment.agents[view.agent].piece.class;
    let is_run = environment.agents[parent].piece.class == own
        && view.rule.orientation.turn == Turn::Parallel
        && matches!(view.side, Side::Left | Side::Right);
    loop {
        match environment.agents[parent].rest().filter(|_| is_run)?.parent {
            ParentPart::Wall(wall) => return Some(wall),
            ParentPart::Agent(next) if environment.agents[next].piece.class == own => parent = next,
            _ => return None,
        }
    }
}

/// Where a wall begins and ends, in metres from its start, with the walls that go on in the same line.
fn ends_of_wall(view: &View<'_>, wall: usize) -> (f64, f64) {
    let walls = &view.environment.brief.surroundings.room.walls;
    let (start, along) = (walls[wall].start, walls[wall].direction());
    let goes_on = |other: &&Wall| {
        let off = |point: Point| (point - start).perp_dot(along).abs();
        off(other.start).max(off(other.end)) < CONTACT_TOLERANCE && other.direction().dot(along) > 0.0
    };
    let reach = |wall: &Wall| [(wall.start - start).dot(along), (wall.end - start).dot(along)];
    let mut ends = (0.0, walls[wall].length());
    // Each pass adds the walls that touch what is known so far; a line has few.
    for _ in 0..walls.len() {
        let known = ends;
        for [from, to] in walls.iter().filter(goes_on).map(reach) {
            if from <= ends.1 + CONTACT_TOLERANCE && to >= ends.0 - CONTACT_TOLERANCE {
                ends = (ends.0.min(from), ends.1.max(to));
            }
        }
        if ends == known {
            break;
        }
    }
    ends
}

/// Whether a piece at a pose has its wall behind it from end to end.
fn is_within(view: &View<'_>, pose: &Pose, (from, to): (f64, f64), wall: usize) -> bool {
    let wall = &view.environment.brief.surroundings.room.walls[wall];
    let along = wall.direction();
    let at = (pose.position - wall.start).dot(along);
    let half = Agent::half_extent(view.size, pose.right, along) - CONTACT_TOLERANCE;
    at - half >= from && at + half <= to
}

/// Poses at a side of the box around a column.
pub(super) fn propose_at_column(view: &View<'_>, column: usize, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let bounds = view.environment.brief.surroundings.room.obstacles[column].outline.bounds();
    let (center, half) = (bounds.center(), bounds.size() / 2.0);
    let out = outward(view.side);
    let face = Face {
        center: center + out * half,
        outward: out,
        length: 2.0 * half.dot(out.perp().abs()),
        base: 0.0,
        parent_center: center,
        // A column has no front: children turn to it as to a piece whose front is on their side.
        parent_angle: turn::angle_of_front(out),
        places: (1, 0),
    };
    propose(view, &face, stream, poses);
}

fn propose(view: &View<'_>, face: &Face, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let bearing = Bearing { parent_angle: face.parent_angle, outward: face.outward };
    let (rule, along) = (view.rule, face.outward.perp());
    for trial in 0..trials(rule.along, face) {
        let angle = turn::angle(&rule.orientation, &bearing, stream);
        let right = crate::geometry::direction(angle);
        // Half of what the side leaves free. A child that is longer than the side sits at its middle.
        let room = (face.length / 2.0 - Agent::half_extent(view.size, right, along)).max(0.0);
        let at = match rule.along {
            Along::Center | Along::Axis => 0.0,
            Along::Even => even(face, trial),
            Along::Ends => room * if trial % 2 == 0 { 1.0 } else { -1.0 },
            // Left and right of a parent, "back" is flush with its back, so that cabinets line up.
            // Around a corner the back is at the wall beside the parent.
            Along::Back if rule.orientation.turn == Turn::AroundCorner => room,
            Along::Back => room * towards_back(face, along),
            Along::Front => -room * towards_back(face, along),
            Along::Random => room * stream.signed(),
        };
        // Drawn for each trial, also where the rule leaves no choice: the numbers after it stay the same.
        let gap = stream.between(rule.gap.0, rule.gap.1);
        let reach = Agent::half_extent(view.size, right, face.outward);
        let position = face.center + face.outward * (reach + gap) + along * at;
        let elevation = face.base + stream.between(rule.elevation.0, rule.elevation.1);
        let angle = match rule.orientation.turn {
            Turn::TowardsCenter => turn::towards(&rule.orientation, position, face.parent_center, stream),
            _ => angle,
        };
        poses.push(Pose::new(position, elevation, angle));
    }
}

/// How many positions make sense: one where it is given, one per place where they are spread evenly.
fn trials(along: Along, face: &Face) -> usize {
    match along {
        Along::Center | Along::Axis | Along::Back | Along::Front => 1,
        Along::Ends => 2,
        Along::Even => face.places.0.max(1) as usize,
        Along::Random => TRIALS_PER_SIDE,
    }
}

/// The middle of the side's place number `taken + trial`, cyclically.
fn even(face: &Face, trial: usize) -> f64 {
    let places = face.places.0.max(1) as usize;
    let index = (face.places.1 as usize + trial) % places;
    face.length * ((index as f64 + 0.5) / places as f64 - 0.5)
}

/// Which end of `along` is the parent's back: 1 or −1, and 0 on the front and back themselves.
fn towards_back(face: &Face, along: Point) -> f64 {
    Pose::new(face.parent_center, 0.0, face.parent_angle).turn(Point::Y).dot(along).round()
}

#[cfg(test)]
mod tests {
    use crate::catalog::{Along, Clearance, Count, ParentName, ParentRule, Side, Size, Turn, Untidiness};
    use crate::layout::Parent;
    use crate::layout::tests::{WIDE, catalog, level, rule, run};

    const SHELF: usize = 4;

    #[test]
    fn twins_stand_side_by_side_and_what_belongs_to_one_may_stand_between_them() {
        const BED: usize = 1;
        let mut catalog = catalog(&[(BED, Count::Fixed(2)), (SHELF, Count::Fixed(1))], Untidiness::default());
        let sides = [Side::Left, Side::Right];
        let beside_bed = |metres: f64| {
            let beside = rule(ParentName::Classes(vec![BED]), &sides, Turn::Parallel, Along::Back);
            ParentRule { gap: (metres, metres), ..beside }
        };
        let clearance = |side| Clearance { side, minimum: 0.56, good: 1.07, ..Clearance::SEAT };
        let bed = &mut catalog.classes[BED];
        bed.sizes[0] = Size { width: 1.0, depth: 2.0, height: 0.9 };
        bed.parents.insert(0, beside_bed(1.1));
        for side in sides {
            let offer = &mut bed.sides[side.index()];
            (offer.places, offer.space) = (2, Some(3.0));
        }
        (bed.clearances, bed.either) = (Vec::new(), sides.map(clearance).to_vec());
        let nightstand = &mut catalog.classes[SHELF];
        nightstand.sizes[0] = Size { width: 0.4, depth: 0.4, height: 0.5 };
        (nightstand.parents, nightstand.depth) = (vec![beside_bed(0.03)], 1);
        let (mut twins, mut between) = (0, 0);
        for seed in 0..24 {
            let placements = run(&level(WIDE), &catalog, seed).placements;
            let [one, other, nightstand] = &placements[..] else { panic!("{placements:?}") };
            if other.parent == Parent::Object(0) {
                twins += 1;
                assert!((one.position.distance(other.position) - 2.1).abs() < 1e-6);
                let middle = (one.position + other.position) / 2.0;
                between += usize::from(middle.distance(nightstand.position) < 1.0);
            }
        }
        assert!(twins > 12 && between > 3, "{twins} {between}");
    }

    #[test]
    fn a_run_ends_where_its_wall_does() {
        let mut catalog = catalog(&[(SHELF, Count::Fixed(9))], Untidiness::default());
        let shelf = &mut catalog.classes[SHELF];
        let sides = [Side::Left, Side::Right];
        let own = ParentName::Classes(vec![SHELF]);
        shelf.parents.insert(0, rule(own, &sides, Turn::Parallel, Along::Back));
        for side in sides {
            shelf.sides[side.index()].places = 1;
        }
        // The wall from (6, 2) to (3, 2) ends where the room goes on to the north.
        let level = level(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (3.0, 2.0), (3.0, 5.0), (0.0, 5.0)]);
        let placements = (1..20).flat_map(|seed| run(&level, &catalog, seed).placements);
        let at_wall = placements.filter(|one| (one.position.y - 1.8).abs() < 0.01 && one.angle.abs() < 0.1);
        let ends: Vec<f64> = at_wall.map(|one| one.position.x - one.size.width / 2.0).collect();
        assert!(ends.len() > 9 && ends.iter().all(|&end| end > 3.0 - 1e-3), "{ends:?}");
    }
}
