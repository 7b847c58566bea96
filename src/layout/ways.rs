//! Ways through the room: who stands in the only way to a door or to a side that people use looks for another
//! place (the paper keeps nothing accessible, section 6.1).

use core::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use crate::catalog::{Access, WalkingRules};
use crate::geometry::{Convex, Point, Solid, distance_to_convex};
use crate::walk::{Floor, Goal, Way, blocked_ways, is_in_the_way};

use super::agent::AgentIndex;
use super::arrange::arrange;
use super::constants::{CONTACT_TOLERANCE, WAY_ROUNDS};
use super::environment::Environment;
use super::lock::is_locked;
use super::movement::send_away;
use super::seed::RoomKey;
use super::suggestion::follows_suggestion;
use super::turning::has_required;

/// Clears the ways that resting agents close, and keeps them free from then on. Returns how many stay closed.
pub(crate) fn clear_ways(environment: &mut Environment<'_>, key: &RoomKey) -> usize {
    for _ in 0..WAY_ROUNDS {
        let ways = all_closed_ways(environment);
        let in_the_way = who_goes(environment, &ways);
        if in_the_way.is_empty() {
            return ways.len();
        }
        for ClosedWay { way, .. } in &ways {
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
    all_closed_ways(environment).len()
}

/// A way that resting agents close.
struct ClosedWay {
    way: Way,
    /// Whose side it leads to; nobody's if it leads to a door.
    owner: Option<AgentIndex>,
}

/// The closed ways of people who walk, and of wheelchairs where the style asks for these.
fn all_closed_ways(environment: &Environment<'_>) -> Vec<ClosedWay> {
    let rules = &environment.catalog.audit;
    let place = (environment.surroundings.level, environment.surroundings.room);
    let floor = Floor::new(place, &rules.walking, environment.solids());
    let empty = || Floor::new(place, &rules.walking, core::iter::empty());
    let mut ways = closed_ways(environment, &rules.walking, floor, empty);
    if environment.access == Access::Wheelchair {
        let wheelchair = WalkingRules {
            person: rules.access.walkway,
            narrow_person: rules.walking.person,
            ..rules.walking
        };
        let floor = Floor::for_wheelchair(place, rules, environment.solids());
        let empty = || Floor::for_wheelchair(place, rules, core::iter::empty());
        ways.extend(closed_ways(environment, &wheelchair, floor, empty));
    }
    ways
}

/// The ways to doors, and to sides that people stand at, that resting agents close.
fn closed_ways(
    environment: &Environment<'_>,
    rules: &WalkingRules,
    floor: Option<Floor>,
    empty: impl FnOnce() -> Option<Floor>,
) -> Vec<ClosedWay> {
    let Some(floor) = floor else { return Vec::new() };
    let walking = &environment.catalog.audit.walking;
    let areas = environment.used_areas(walking.narrow_person, walking.body_height);
    let areas = areas.map(|(owner, solid)| (Some(owner), Goal::Area(solid.footprint())));
    let doors = floor.doors().map(|door| (None, Goal::Door(door)));
    let (owners, goals): (Vec<Option<AgentIndex>>, Vec<Goal<'_>>) = doors.chain(areas).unzip();
    let empty = || empty().expect("a door of the furnished room is one of the empty room");
    let ways = blocked_ways(&floor, empty, rules, &goals);
    ways.into_iter().map(|way| ClosedWay { owner: owners[way.goal], way }).collect()
}

/// Whom the ways ask to go: at each narrow place the agent that reaches farthest into it, unless one that goes
/// already was in its way. Where only pieces at suggested places are in the way to somebody's side, that one goes: they
/// leave all ways open that the room cannot do without.
fn who_goes(environment: &Environment<'_>, ways: &[ClosedWay]) -> Vec<AgentIndex> {
    let mut going: BTreeSet<AgentIndex> = BTreeSet::new();
    let places = ways.iter().flat_map(|closed| closed.way.narrows.iter().map(move |&place| (closed, place)));
    for (ClosedWay { way, owner }, place) in places {
        let mut near = who_is_near(environment, place, way.width / 2.0 - CONTACT_TOLERANCE);
        near.retain(|&agent, _| !is_locked(environment, agent));
        if way.width > environment.catalog.audit.walking.person {
            // A wide way is a wish: nobody goes for it whom the room cannot do without.
            near.retain(|&agent, _| !has_required(environment, agent));
        }
        if near.keys().any(|agent| going.contains(agent)) {
            continue;
        }
        // Required pieces stay where another can go; of equals the later one, which fewer rely on.
        let rank = |&(&agent, &distance): &(&AgentIndex, &f64)| {
            let piece = &environment.agents[agent].piece;
            (
                follows_suggestion(environment, agent),
                distance > 0.0,
                piece.is_required,
                !piece.is_fill,
                Reverse(agent),
            )
        };
        let first = near.iter().min_by_key(rank).map(|(&agent, _)| agent);
        let owner = owner.filter(|&owner| !has_required(environment, owner));
        going.extend(first.map(|agent| match owner {
            Some(owner) if follows_suggestion(environment, agent) => owner,
            _ => agent,
        }));
    }
    going.into_iter().collect()
}

/// Agents in the way of people at a place, with their distances.
pub(crate) fn who_is_near(
    environment: &Environment<'_>,
    place: Point,
    reach: f64,
) -> BTreeMap<AgentIndex, f64> {
    let rules = &environment.catalog.audit.walking;
    let mut near: BTreeMap<AgentIndex, f64> = BTreeMap::new();
    environment.each_part_near(place, reach, |agent, solid| {
        let distance = distance_to_convex(solid.footprint(), place);
        if is_in_the_way(rules, solid) && distance < reach {
            let known = near.entry(agent).or_insert(distance);
            *known = known.min(distance);
        }
    });
    near
}
