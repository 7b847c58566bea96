//! The loop of section 4: agents act according to their state until all rest or are removed.

use core::cmp::Reverse;
use core::ops::Range;

use crate::catalog::Size;

use super::agent::{Agent, State};
use super::constants::SEARCH_ROUNDS;
use super::environment::Environment;
use super::furnished::RemovalReason;
use super::locked::locked_place;
use super::movement::send_away;
use super::place::{AgentIndex, Place};
use super::search::{Care, Found, search};
use super::seed::RoomKey;
use super::suggested::{self, suggestion};
use super::wanted;

/// Lets all searching agents act until each rests or is removed.
pub(crate) fn arrange(environment: &mut Environment<'_>, key: &RoomKey) {
    let order = service_order(environment);
    for _ in 0..SEARCH_ROUNDS {
        let searching = |agent: &&AgentIndex| environment.agents[**agent].state == State::Search;
        let round: Vec<AgentIndex> = order.iter().filter(searching).copied().collect();
        if round.is_empty() {
            return;
        }
        for agent in round {
            act(environment, agent, key);
            if environment.is_given_up() {
                return;
            }
        }
    }
}

/// One agent's step: a found parent and a free place lead to rest, else it is removed, and what stands in for it searches. What was
/// there to carry it alone leaves first, so that this and all who found no place before may have the space.
fn act(environment: &mut Environment<'_>, agent: AgentIndex, key: &RoomKey) {
    if let Some(place) = locked_place(environment, agent) {
        return environment.settle(agent, &place);
    }
    if wanted::is_waiting(environment, agent) {
        return;
    }
    if wanted::has_stand_in(environment, agent) {
        environment.agents[agent].state = State::Removed(RemovalReason::NoPlace);
        return;
    }
    let found = search_in_any_size(environment, agent, key);
    let reason = match found.or_else(|reason| search_with_carrier(environment, agent, reason, key)) {
        Ok(place) => return environment.settle(agent, &place),
        Err(reason) => reason,
    };
    let has_lost_parent = environment.agents[agent].searches > 0;
    let reason = match environment.agents[agent].is_in_the_way {
        true => RemovalReason::Repair,
        false if has_lost_parent => RemovalReason::LostParent,
        false => reason,
    };
    environment.agents[agent].state = State::Removed(reason);
    environment.is_exhausted[environment.agents[agent].piece.class] = true;
    let idle = wanted::idle_carriers(environment, agent);
    for &carrier in &idle {
        send_away(environment, carrier);
        environment.agents[carrier].state = State::Unasked;
    }
    if let Some(substitute) = wanted::next_substitute(environment, agent) {
        environment.agents[substitute].state = State::Search;
        act(environment, substitute, key);
    }
    // Whoever does not compare it with another room finishes it, however much it lacks.
    if environment.brief.alternative.gives_up_at.is_some() {
        environment.lacking += wanted::lack(environment, agent);
    }
    if !idle.is_empty() {
        wanted::ask_missed(environment);
    }
}

/// Where an agent fits on what is there to carry it but misses what it needs, the two look for a place together: a screen that
/// no seat faces, with its stand.
fn search_with_carrier(
    environment: &mut Environment<'_>,
    agent: AgentIndex,
    reason: RemovalReason,
    key: &RoomKey,
) -> Result<Place, RemovalReason> {
    if reason != RemovalReason::Relation {
        return Err(reason);
    }
    let Some(carrier) = wanted::movable_carrier(environment, agent) else { return Err(reason) };
    send_away(environment, carrier);
    environment.agents[carrier].is_in_the_way = false;
    act(environment, carrier, key);
    search_in_any_size(environment, agent, key)
}

/// Searches in the size that was drawn; where that has no good place, in the smaller sizes of the class, largest
/// first: a narrow wardrobe is better than none, or one in the way. What covers an opening begins with the
/// largest, so that a wide window gets a wide curtain. A piece that cannot be missed and has no place in any size
/// looks everywhere, in its smallest.
fn search_in_any_size(
    environment: &mut Environment<'_>,
    agent: AgentIndex,
    key: &RoomKey,
) -> Result<Place, RemovalReason> {
    if let Some(place) = take_suggestion(environment, agent) {
        return Ok(place);
    }
    if environment.class(agent).parents.iter().any(|rule| rule.above_head.is_some()) {
        let sizes = sizes_by(environment, agent, |size| size.width * size.height);
        return search_in_sizes(environment, agent, key, &sizes).map(|found| found.place);
    }
    let may_scan = !environment.is_exhausted[environment.agents[agent].piece.class];
    let found = search_in_smaller_sizes(environment, agent, key);
    if found.is_ok() || !environment.agents[agent].piece.is_required || !may_scan {
        return found.map(|found| found.place);
    }
    let smallest = sizes_by(environment, agent, area).pop();
    take_size(environment, agent, smallest.expect("a class has a size"));
    search(environment, agent, key, Care::Thorough).map(|found| found.place)
}

/// Takes the size and the place that were suggested for an agent.
fn take_suggestion(environment: &mut Environment<'_>, agent: AgentIndex) -> Option<Place> {
    let index = suggestion(environment, agent)?;
    let suggested = environment.brief.alternative.suggestions[index];
    let drawn = environment.agents[agent].piece.variant;
    let class = environment.class(agent);
    let has_size = |&variant: &u32| class.size(variant) == suggested.size;
    let variant = sizes_by(environment, agent, area).into_iter().find(has_size)?;
    take_size(environment, agent, variant);
    let place = suggested::place(environment, agent, &suggested);
    match place {
        Some(_) => environment.agents[agent].suggestion = Some(index),
        None => take_size(environment, agent, drawn),
    }
    place
}

fn search_in_smaller_sizes(
    environment: &mut Environment<'_>,
    agent: AgentIndex,
    key: &RoomKey,
) -> Result<Found, RemovalReason> {
    let drawn = search(environment, agent, key, Care::Usual);
    let (class, piece) = (environment.class(agent), environment.agents[agent].piece);
    let is_good = drawn.as_ref().is_ok_and(|found| !found.is_poor);
    if is_good || class.sizes.len() == 1 || environment.is_exhausted[piece.class] {
        return drawn;
    }
    let mut sizes = sizes_by(environment, agent, area);
    sizes.retain(|&variant| area(class.size(variant)) < area(class.size(piece.variant)));
    let smaller = search_in_sizes(environment, agent, key, &sizes);
    let is_smaller_better = smaller.as_ref().is_ok_and(|found| !found.is_poor || drawn.is_err());
    if !is_smaller_better {
        take_size(environment, agent, piece.variant);
    }
    if is_smaller_better { smaller } else { drawn }
}

pub(crate) fn area(size: Size) -> f64 {
    size.width * size.depth
}

pub(crate) fn take_size(environment: &mut Environment<'_>, agent: AgentIndex, variant: u32) {
    environment.agents[agent].piece.variant = variant;
    environment.agents[agent].size = environment.class(agent).size(variant);
}

/// Searches in one size after the other until one has a good place; where none has, takes the first poor one, or
/// says why the last has none.
fn search_in_sizes(
    environment: &mut Environment<'_>,
    agent: AgentIndex,
    key: &RoomKey,
    variants: &[u32],
) -> Result<Found, RemovalReason> {
    let mut best: Result<(u32, Found), RemovalReason> = Err(RemovalReason::NoPlace);
    for &variant in variants {
        take_size(environment, agent, variant);
        match search(environment, agent, key, Care::Usual) {
            Ok(found) if !found.is_poor => return Ok(found),
            Ok(found) if best.is_err() => best = Ok((variant, found)),
            Err(reason) if best.is_err() => best = Err(reason),
            _ => {}
        }
    }
    let (variant, found) = best?;
    take_size(environment, agent, variant);
    Ok(found)
}

/// The variants of an agent's class in the look that was drawn, those of greatest extent first, without those for niches.
pub(crate) fn sizes_by(
    environment: &Environment<'_>,
    agent: AgentIndex,
    extent: impl Fn(Size) -> f64,
) -> Vec<u32> {
    let class = environment.class(agent);
    let mut variants: Vec<u32> = in_its_look(environment, agent, 0..class.common_variant_count()).collect();
    // Stable: of equal extents the lower variant comes first.
    variants.sort_by(|&a, &b| extent(class.size(b)).total_cmp(&extent(class.size(a))));
    variants
}

/// Those of some variants of an agent's class that have the look that was drawn.
pub(crate) fn in_its_look(
    environment: &Environment<'_>,
    agent: AgentIndex,
    variants: Range<u32>,
) -> impl Iterator<Item = u32> + use<> {
    let (looks, drawn) = (environment.class(agent).looks, environment.agents[agent].piece.variant);
    variants.filter(move |variant| variant % looks == drawn % looks)
}

/// "We prioritize agents according to their expected depth in the hierarchy, so that the arrangement of tables
/// is attempted before chairs search for parents" (section 3.2), but first who has a suggestion. Within a depth: who
/// was missed in earlier attempts; then by priority, the pieces that only fill last, large before small, then as the
/// programme lists them.
fn service_order(environment: &Environment<'_>) -> Vec<AgentIndex> {
    let is_laid_last = |&agent: &AgentIndex| !environment.class(agent).covers.is_empty();
    let mut order: Vec<AgentIndex> =
        (0..environment.agents.len()).filter(|agent| !is_laid_last(agent)).collect();
    let rank = |&agent: &AgentIndex| {
        let (class, size) = (environment.class(agent), environment.agents[agent].size);
        let square_millimetres = (size.width * size.depth * 1e6) as i64;
        let Agent { piece, urgency, .. } = &environment.agents[agent];
        let is_suggested = suggestion(environment, agent).is_some();
        (
            // Parents come before the agents that stand on them or beside them.
            class.depth,
            // Before others of the same depth, which could take the suggested place.
            !is_suggested,
            // Attempts that missed it, 0 to 15: the larger count first.
            Reverse(*urgency),
            // Pieces that only fill take the places that are left.
            piece.is_fill,
            -class.priority,
            // Large pieces have fewer places. Whole square millimetres, so that equal sizes are equal.
            -square_millimetres,
            // The order of the programme decides between equals.
            agent,
        )
    };
    order.sort_by_cached_key(rank);
    order
}
