//! Ways through the room: who stands in the only way to a door or to a side that people use looks for another
//! place (the paper keeps nothing accessible, section 6.1).

use crate::geometry::{Convex, Point, Solid, distance_to_convex};
use crate::walk::{Floor, Goal, Way, blocked_ways};

use super::agent::AgentIndex;
use super::arrange::arrange;
use super::constants::{CONTACT_TOLERANCE, WAY_ROUNDS};
use super::environment::Environment;
use super::movement::send_away;
use super::seed::RoomKey;

/// Clears the ways that resting agents close, and keeps them free from then on. Returns how many stay closed.
pub(crate) fn clear_ways(environment: &mut Environment<'_>, key: &RoomKey) -> usize {
    for _ in 0..WAY_ROUNDS {
        let ways = closed_ways(environment);
        let in_the_way = who_goes(environment, &ways);
        if in_the_way.is_empty() {
            return ways.len();
        }
        for way in &ways {
            let half = Point::splat(way.width / 2.0);
            let height = environment.catalog.audit.walking.body_height;
            for &place in &way.narrows {
                environment.keep_free(Solid::new(Convex::disc(place, half, Point::X), 0.0, height));
            }
        }
        for agent in in_the_way {
            send_away(environment, agent);
        }
        arrange(environment, key);
    }
    closed_ways(environment).len()
}

/// The ways to doors, and to sides that people stand at, that resting agents close.
fn closed_ways(environment: &Environment<'_>) -> Vec<Way> {
    let (level, room) = (environment.surroundings.level, environment.surroundings.room);
    let rules = &environment.catalog.audit.walking;
    let Some(floor) = Floor::new((level, room), rules, environment.solids()) else { return Vec::new() };
    let areas = environment.used_areas(rules.narrow_person, rules.body_height);
    let goals: Vec<Goal<'_>> =
        floor.doors().map(Goal::Door).chain(areas.map(|solid| Goal::Area(solid.footprint()))).collect();
    let empty = || {
        let nothing = core::iter::empty();
        Floor::new((level, room), rules, nothing)
            .expect("a door of the furnished room is one of the empty room")
    };
    blocked_ways(&floor, empty, rules, &goals)
}

/// Whom the ways ask to go: at each narrow place the agent that reaches farthest into it, unless one that goes
/// already was in its way.
fn who_goes(environment: &Environment<'_>, ways: &[Way]) -> Vec<AgentIndex> {
    let rules = &environment.catalog.audit.walking;
    let mut going = Vec::new();
    for way in ways {
        for &place in &way.narrows {
            let distance = |agent: AgentIndex| {
                let solids = environment.solids_of(agent);
                let solids = solids.filter(|solid| solid.low < rules.body_height && solid.high > rules.step);
                solids.map(|solid| distance_to_convex(solid.footprint(), place)).fold(f64::INFINITY, f64::min)
            };
            let is_near = |&agent: &AgentIndex| distance(agent) < way.width / 2.0 - CONTACT_TOLERANCE;
            if going.iter().any(is_near) {
                continue;
            }
            // Required pieces stay where another can go; of equals the later one, which fewer rely on.
            let rank = |&agent: &AgentIndex| {
                let piece = &environment.agents[agent].piece;
                let is_inside = distance(agent) == 0.0;
                (!is_inside, piece.is_required, !piece.is_fill, core::cmp::Reverse(agent))
            };
            let near = (0..environment.agents.len()).filter(is_near);
            going.extend(near.min_by_key(rank));
        }
    }
    going
}
