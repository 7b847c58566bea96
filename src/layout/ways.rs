//! Keeps ways through the room: an agent that stands in the only way to a door, or to a side that people use, looks for another
//! place (the paper keeps nothing accessible, section 6.1).

use core::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use crate::catalog::{Access, WalkingRules};
use crate::geometry::{Convex, Point, Solid, distance_to_convex};
use crate::walk::{Floor, Goal, Way, blocked_ways, is_in_the_way};

use super::agent::State;
use super::arrange::arrange;
use super::constants::{CELLS_A_STEP, CELLS_OF_WAYS_A_STEP, CONTACT_TOLERANCE, FIXTURE_GROUP, WAY_ROUNDS};
use super::environment::Environment;
use super::furnished::RemovalReason;
use super::locked::is_locked;
use super::movement::send_away;
use super::place::AgentIndex;
use super::seed::RoomKey;
use super::suggested::follows_suggestion;

/// Clears the ways that resting agents close, and keeps them free from then on. Returns how many stay closed, or do not
/// only because pieces were left out.
///
/// For a way past a leaf, pieces that the room cannot do without go in the first attempt alone: should one find no other place, further
/// attempts follow, in which they stay.
pub(crate) fn clear_ways(environment: &mut Environment<'_>, key: &RoomKey, is_first_attempt: bool) -> usize {
    let mut kept = BTreeSet::new();
    for _ in 0..WAY_ROUNDS {
        let ways = all_closed_ways(environment);
        let in_the_way = who_goes(environment, &ways, is_first_attempt);
        if in_the_way.is_empty() {
            return count_musts(&ways);
        }
        for ClosedWay { way, .. } in &ways {
            let half = Point::splat(way.width / 2.0);
            let height = environment.brief.catalog.audit.walking.body_height;
            // Many ways lead through one gap.
            let bits = |place: &Point| [place.x, place.y, way.width].map(f64::to_bits);
            for &place in way.narrows.iter().filter(|place| kept.insert(bits(place))) {
                environment.keep_way(Solid::new(Convex::disc(place, half, Point::X), 0.0, height));
            }
        }
        for agent in in_the_way {
            send_away(environment, agent);
        }
        arrange(environment, key);
    }
    let closed_ways = all_closed_ways(environment);
    let alternative = environment.brief.alternative;
    if alternative.takes_substitutes || !alternative.suggestions.is_empty() {
        leave_out(environment, &closed_ways, key);
    }
    count_musts(&closed_ways)
}

/// Closed ways that somebody must be able to go.
fn count_musts(ways: &[ClosedWay]) -> usize {
    ways.iter().filter(|closed| !closed.is_past_leaf).count()
}

/// Leaves out who is asked to go, where pieces stand at suggested places or others may stand in for them, and the ways to all others
/// cannot be cleared by moving. The suggested places leave all ways open by themselves: a room that cannot do without these pieces
/// does without a cupboard behind them.
fn leave_out(environment: &mut Environment<'_>, closed_ways: &[ClosedWay], key: &RoomKey) {
    let mut going = who_can_be_missed(environment, closed_ways);
    // Ends, for each round leaves somebody out for good.
    while !going.is_empty() {
        for &agent in &going {
            send_away(environment, agent);
        }
        for agent in going {
            environment.agents[agent].state = State::Removed(RemovalReason::Repair);
        }
        // Who stood on them may hang or lie elsewhere.
        arrange(environment, key);
        let closed_ways = all_closed_ways(environment);
        going = who_can_be_missed(environment, &closed_ways);
    }
}

/// The agents that should leave the ways, without those that the room cannot do without.
fn who_can_be_missed(environment: &Environment<'_>, ways: &[ClosedWay]) -> Vec<AgentIndex> {
    let mut going = who_goes(environment, ways.iter().filter(|closed| !closed.is_past_leaf), false);
    going.retain(|&agent| !environment.has_required(agent));
    going
}

/// A way that resting agents close.
struct ClosedWay {
    way: Way,
    /// The agent to whose side it leads; none if it leads to a door.
    owner: Option<AgentIndex>,
    /// Whether it is open as soon as somebody shuts a door.
    is_past_leaf: bool,
}

/// The closed ways of people who walk, of those who walk past doors that stand open, and of wheelchairs where the style asks for
/// these.
fn all_closed_ways(environment: &Environment<'_>) -> Vec<ClosedWay> {
    let rules = &environment.brief.catalog.audit;
    let floors = environment.brief.empty_floors;
    let mut ways = Vec::new();
    if let (Some(empty), Some(floor)) = (floors.walking(), floors.walking_among(environment.solids())) {
        ways.extend(closed_ways(environment, &rules.walking, [&floor, empty]));
        ways.extend(closed_ways_past_leaves(environment, &floor));
    }
    let asks = environment.brief.style.access == Access::Wheelchair;
    if let Some(empty) = floors.wheelchair().filter(|_| asks)
        && let Some(floor) = floors.wheelchair_among(environment.solids())
    {
        // Where the plan is too narrow for a wheelchair, the width of a person is asked for.
        let wheelchair = WalkingRules {
            person: rules.access.walkway,
            narrow_person: rules.walking.person,
            ..rules.walking
        };
        ways.extend(closed_ways(environment, &wheelchair, [&floor, empty]));
    }
    ways
}

/// The ways that are closed while doors stand open, on a floor on which they are shut, but for those to fixtures of bathrooms. Where the
/// plan leaves no way beside a leaf, none is asked for.
fn closed_ways_past_leaves(environment: &Environment<'_>, shut: &Floor) -> Vec<ClosedWay> {
    let rules = &environment.brief.catalog.audit.walking;
    let Some(leaves) = environment.brief.empty_floors.open_leaves() else { return Vec::new() };
    if !environment.solids().any(|solid| leaves.are_near(solid)) {
        return Vec::new();
    }
    let rules = WalkingRules { narrow_person: rules.person, ..*rules };
    let ways = closed_ways(environment, &rules, [&leaves.opened(shut), leaves.floor()]);
    // Who goes to a toilet or a shower shuts the door first.
    let is_private =
        |closed: &ClosedWay| closed.owner.is_some_and(|owner| environment.is_in(owner, FIXTURE_GROUP));
    ways.into_iter()
        .filter(|closed| !is_private(closed))
        .map(|closed| ClosedWay { is_past_leaf: true, ..closed })
        .collect()
}

/// The ways to doors, and to sides that people stand at, that resting agents close on a floor; the second is that of the empty room.
fn closed_ways(
    environment: &Environment<'_>,
    rules: &WalkingRules,
    [floor, empty]: [&Floor; 2],
) -> Vec<ClosedWay> {
    let cells = floor.cell_count() as u64;
    environment.count_steps(cells / CELLS_A_STEP);
    let walking = &environment.brief.catalog.audit.walking;
    let areas = environment.used_areas(walking.narrow_person, walking.body_height);
    let areas = areas.map(|(owner, solid)| (Some(owner), Goal::Area(solid.footprint())));
    let doors = floor.doors().map(|door| (None, Goal::Door(door)));
    let (owners, goals): (Vec<Option<AgentIndex>>, Vec<Goal<'_>>) = doors.chain(areas).unzip();
    let ways = blocked_ways(floor, empty, rules, &goals);
    if !ways.is_empty() {
        environment.count_steps(cells / CELLS_OF_WAYS_A_STEP);
    }
    ways.into_iter().map(|way| ClosedWay { owner: owners[way.goal], way, is_past_leaf: false }).collect()
}

/// The agents that should leave the ways: at each narrow place the agent that reaches farthest into it, unless one that goes
/// already was in its way. Where only pieces at suggested places are in the way to somebody's side, that one goes: they
/// leave all ways open that the room cannot do without.
fn who_goes<'w>(
    environment: &Environment<'_>,
    ways: impl IntoIterator<Item = &'w ClosedWay>,
    moves_required: bool,
) -> Vec<AgentIndex> {
    let mut going: BTreeSet<AgentIndex> = BTreeSet::new();
    let places =
        ways.into_iter().flat_map(|closed| closed.way.narrows.iter().map(move |&place| (closed, place)));
    for (ClosedWay { way, owner, is_past_leaf }, place) in places {
        let mut near = who_is_near(environment, place, way.width / 2.0 - CONTACT_TOLERANCE);
        near.retain(|&agent, _| !is_locked(environment, agent));
        if (*is_past_leaf && !moves_required) || way.width > environment.brief.catalog.audit.walking.person {
            // A wide way is a wish: nobody goes for it whom the room cannot do without.
            near.retain(|&agent, _| !environment.has_required(agent));
        }
        if near.keys().any(|agent| going.contains(agent)) {
            continue;
        }
        // Required pieces stay where another can go; of equals the later one, which fewer rely on.
        let rank = |&(&agent, &distance): &(&AgentIndex, &f64)| {
            let piece = &environment.agents[agent].piece;
            (
                // Suggested places leave all ways open that the room cannot do without.
                follows_suggestion(environment, agent),
                // An agent on the very cell goes before one that only reaches near it.
                distance > 0.0,
                piece.is_required,
                // Pieces that only fill the room go first.
                !piece.is_fill,
                Reverse(agent),
            )
        };
        let first = near.iter().min_by_key(rank).map(|(&agent, _)| agent);
        let owner = owner.filter(|&owner| !environment.has_required(owner) && !is_locked(environment, owner));
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
    let rules = &environment.brief.catalog.audit.walking;
    let mut near: BTreeMap<AgentIndex, f64> = BTreeMap::new();
    environment.each_part_near(place, reach, |agent, solid| {
        // Zero for an agent that stands on the place.
        let distance = distance_to_convex(solid.footprint(), place);
        if is_in_the_way(rules, solid) && distance < reach {
            let known = near.entry(agent).or_insert(distance);
            *known = known.min(distance);
        }
    });
    near
}

#[cfg(test)]
mod tests {
    use crate::catalog::{Clearance, Count, Untidiness};
    use crate::geometry::Point;
    use crate::layout::tests::{catalog, level};
    use crate::layout::{Alternative, FurnishOptions, RemovalReason, RoomLayout, Suggestion};

    /// What becomes of a shelf that has room only behind a desk, which stands at a suggested place and leaves a gap before
    /// it: how many rest, and why others do not.
    fn shelf_behind_a_desk(gap: f64, is_required: bool) -> (usize, Vec<RemovalReason>) {
        let (desk, shelf, depth) = (1, 4, 0.8 + gap);
        let mut catalog =
            catalog(&[(desk, Count::Fixed(1)), (shelf, Count::Fixed(1))], Untidiness::default());
        catalog.classes[desk].clearances.clear();
        catalog.classes[shelf].clearances = vec![Clearance { minimum: 0.4, good: 0.4, ..Clearance::SEAT }];
        let programme = &mut catalog.room_types.get_mut("office").unwrap().programme;
        programme[0].is_required = true;
        programme[1].is_required = is_required;
        let suggestion = Suggestion {
            class: desk,
            size: catalog.classes[desk].sizes[0],
            position: Point::new(2.3, depth - 0.4),
            angle: 0.0,
            wall: Some(2),
        };
        let level = level(&[(0.0, 0.0), (6.0, 0.0), (6.0, depth), (0.0, depth)]);
        let options = FurnishOptions::new(1, "test");
        let alternative = Alternative { suggestions: vec![suggestion], ..Alternative::numbered(1) };
        let furnished = RoomLayout::new(level.room(0), &catalog, &options).furnish(&alternative).furnished;
        let is_there =
            |class| furnished.placements.iter().filter(|placement| placement.class == class).count();
        assert_eq!(is_there(desk), 1);
        (is_there(shelf), furnished.removals.iter().map(|removal| removal.reason).collect())
    }

    #[test]
    fn who_is_not_reached_past_a_suggested_place_is_left_out() {
        assert_eq!(shelf_behind_a_desk(0.4, false), (0, vec![RemovalReason::Repair]));
        assert_eq!(shelf_behind_a_desk(0.5, false), (1, Vec::new()));
    }

    /// How many of ten shelves stand in the long passage to a desk, where those that stay in the way may be left out or not.
    fn shelves_in_a_passage(takes_substitutes: bool) -> usize {
        let (desk, shelf) = (1, 4);
        let mut catalog =
            catalog(&[(desk, Count::Fixed(1)), (shelf, Count::Fixed(10))], Untidiness::default());
        catalog.room_types.get_mut("office").unwrap().programme[0].is_required = true;
        let level = level(&[
            (0.0, 0.0),
            (65.0, 0.0),
            (65.0, 3.0),
            (62.0, 3.0),
            (62.0, 0.7),
            (2.0, 0.7),
            (2.0, 2.0),
            (0.0, 2.0),
        ]);
        let options = FurnishOptions::new(1, "test");
        let alternative = Alternative { takes_substitutes, ..Alternative::numbered(1) };
        let furnished = RoomLayout::new(level.room(0), &catalog, &options).furnish(&alternative).furnished;
        let is_in_passage = |position: Point| (2.0..62.0).contains(&position.x);
        let shelves = furnished.placements.iter().filter(|placement| placement.class == shelf);
        shelves.filter(|placement| is_in_passage(placement.position)).count()
    }

    #[test]
    fn who_stays_in_the_way_is_left_out_where_nothing_else_has_helped() {
        assert_eq!(shelves_in_a_passage(true), 0);
        assert!(shelves_in_a_passage(false) > 0, "another arrangement may do without");
    }

    #[test]
    fn who_cannot_be_missed_is_not_left_out() {
        assert_eq!(shelf_behind_a_desk(0.4, true), (1, Vec::new()));
    }
}
