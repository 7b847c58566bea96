//! A room, the catalogue and a seed to a [`Furnished`] room: the agent system.
//!
//! T. Germer, M. Schwarz, "Procedural Arrangement of Furniture for Real-Time Walkthroughs", Computer
//! Graphics Forum, 2009, section 3. Pure: no files, no threads, no clock. Departures from the paper:
//! - the parent's true shape takes part in the collision test (`environment`), so that a chair slides under a
//!   table without meeting a leg;
//! - along walls, positions are drawn from the stretches that are really free (`rules`);
//! - clearances, door swings and approaches are regions that bodies keep out of;
//! - who closes the only way to a door or to a side that people use is sent away to search again (`ways`);
//! - a room that lacks a required piece, a way, or many pieces is furnished again from a derived seed, a few
//!   times at most, with those served first that were missed;
//! - an agent with wishes about other objects compares a few free places instead of taking the first.

mod agent;
mod arrange;
mod body;
mod choice;
mod constants;
mod covering;
mod environment;
mod explain;
mod furnished;
mod lock;
mod movement;
mod programme;
mod push;
mod result;
mod rules;
mod search;
mod seed;
mod suggestion;
mod surroundings;
#[cfg(test)]
mod tests;
mod trace;
mod turning;
mod untidy;
mod variant;
mod ways;

pub use body::{clearance_solids, solids};
pub use choice::room_style;
pub use explain::{
    Explanation, MissingStory, ObjectStory, ObstacleStory, ParentStory, Refusal, SearchStory, WallStory,
    Wish, explain, explain_alternative,
};
pub use furnished::{Furnished, Parent, Placement, Removal, RemovalReason};
pub use lock::{Lock, LockSupport};
pub use suggestion::{Alternative, Suggestion};

use std::collections::BTreeSet;

use crate::catalog::{Access, Catalog, ClassIndex, ParentName, Untidiness};
use crate::plan::{Level, OpeningKind, Room};

use agent::{Agent, AgentIndex, State};
use choice::Series;
use constants::{
    ALTERNATIVES_WITH_TAGS, ATTEMPTS, ATTEMPTS_IN_NEED, MISSING_SHARE, MOST_STEPS, MOST_STEPS_FOR_WAYS,
};
use environment::Environment;
use programme::Site;
use seed::RoomKey;
use surroundings::{Surroundings, Swings};
use variant::Variants;

/// What furnishing a room depends on besides plan and catalogue.
#[derive(Clone, Copy, Debug)]
pub struct FurnishOptions<'a> {
    /// The seed of the whole run.
    pub seed: u64,
    /// Id of the building, part of the room's seed.
    pub building: &'a str,
    /// Style or building style for rooms whose plan names none, where it suits their type; else
    /// [`crate::catalog::DEFAULT_STYLE`].
    pub style: Option<&'a str>,
    /// The seed of this room's furniture, in place of that of the run; the style is still drawn by that one.
    pub pinned: Option<u64>,
    /// Objects that stand before the others search.
    pub locks: &'a [Lock],
}

impl<'a> FurnishOptions<'a> {
    /// Nothing but a seed and a building.
    #[must_use]
    pub fn new(seed: u64, building: &'a str) -> Self {
        Self { seed, building, style: None, pinned: None, locks: &[] }
    }

    /// The same in a style.
    #[must_use]
    pub fn with_style(self, style: Option<&'a str>) -> Self {
        Self { style, ..self }
    }
}

/// Furnishes one room of a level.
///
/// `room` is an index into `level.rooms`. The answer depends on the arguments only. Rooms whose type is not
/// furnished come back empty.
#[must_use]
pub fn furnish(level: &Level, room: usize, catalog: &Catalog, options: &FurnishOptions<'_>) -> Furnished {
    furnish_alternative(level, room, catalog, options, &Alternative::default())
}

/// Furnishes one room as [`furnish`] does, with the same pieces in another arrangement for each `alternative`;
/// the default one is that of [`furnish`].
#[must_use]
pub fn furnish_alternative(
    level: &Level,
    room: usize,
    catalog: &Catalog,
    options: &FurnishOptions<'_>,
    alternative: &Alternative,
) -> Furnished {
    furnish_counted(level, room, catalog, options, alternative).furnished
}

/// A furnished room, and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Counted {
    /// The room.
    pub furnished: Furnished,
    /// Work of all attempts, in steps of about a tenth of a microsecond: the same on every machine.
    pub steps: u64,
}

/// Furnishes one room as [`furnish_alternative`] does, and counts its steps.
#[must_use]
pub fn furnish_counted(
    level: &Level,
    room: usize,
    catalog: &Catalog,
    options: &FurnishOptions<'_>,
    alternative: &Alternative,
) -> Counted {
    let task = Task { level, room, catalog, options: *options, alternative };
    let (furnished, told) = task.furnish(false, |_, _| ());
    Counted { furnished, steps: told.map_or(0, |told| told.steps) }
}

/// A room to furnish.
#[derive(Clone, Copy)]
struct Task<'a> {
    level: &'a Level,
    room: usize,
    catalog: &'a Catalog,
    options: FurnishOptions<'a>,
    alternative: &'a Alternative,
}

impl Task<'_> {
    /// Furnishes the room. Each attempt may be traced, and `tell` says something about it; what it says about the
    /// one that is kept comes back, or nothing for a room that is not furnished.
    fn furnish<T>(
        &self,
        is_traced: bool,
        tell: impl Fn(&Environment<'_>, &Furnished) -> T,
    ) -> (Furnished, Option<Told<T>>) {
        let Self { level, room, catalog, options, alternative } = *self;
        let plan = &level.rooms[room];
        let seed = options.pinned.unwrap_or(options.seed);
        let key = RoomKey::new(seed, options.building, level, plan);
        let style = room_style(level, plan, catalog, &options);
        let room_type = catalog.room_types.get(&plan.room_type).filter(|room_type| room_type.is_furnished);
        let (Some(style), Some(room_type)) = (style, room_type) else {
            return (result::empty(room, key.seed(), style), None);
        };

        // The programme is drawn once: another attempt must not ask for other pieces.
        let series = Series::new(level, plan, catalog, &options);
        let variants = Variants { seed, series, key: &key };
        let mut pieces = programme::pieces(catalog, (style, room_type), site(level, plan), &variants);
        lock::add_pieces(&mut pieces, options.locks, catalog);
        let is_suggested = !alternative.suggestions.is_empty();
        let swings = if is_suggested { Swings::Exact } else { Swings::Simple };
        let surroundings = Surroundings::new(level, plan, &catalog.audit, swings);
        let mut urgency = vec![0; pieces.len()];
        let mut attempt = |number: u32| {
            let mut environment = Environment::new(catalog, surroundings.clone(), &pieces);
            for (agent, &urgency) in environment.agents.iter_mut().zip(&urgency) {
                agent.urgency = urgency;
            }
            environment.suggestions.clone_from(&alternative.suggestions);
            environment.locks = options.locks;
            environment.heeds_tags = alternative.number < ALTERNATIVES_WITH_TAGS && number < ATTEMPTS;
            environment.access = style.access;
            environment.trace = is_traced.then(|| trace::Trace::new(&environment));
            let attempt_key = key.attempt(alternative.number * ATTEMPTS_IN_NEED + number);
            let closed_ways = act_all(&mut environment, &style.untidiness, &attempt_key);
            for agent in missed(&environment) {
                urgency[agent] += 1;
            }
            let furnished = result::furnished(&environment, room, key.seed(), style);
            let steps = environment.steps();
            let told =
                Told { words: tell(&environment, &furnished), kept: number + 1, attempts: number + 1, steps };
            Attempt { furnished, closed_ways, told }
        };
        let mut best = attempt(0);
        let (mut number, mut steps) = (1, best.told.steps);
        while number < best.deserved_attempts(alternative.number) && steps < best.most_steps() {
            let next = attempt(number);
            steps += next.told.steps;
            if next.lack() < best.lack() {
                best = next;
            }
            number += 1;
            best.told.attempts = number;
        }
        best.told.steps = steps;
        (best.furnished, Some(best.told))
    }
}

/// What is said about the attempt that is kept.
struct Told<T> {
    words: T,
    /// Which attempt it is, from 1.
    kept: u32,
    /// How many there were.
    attempts: u32,
    /// What they took together.
    steps: u64,
}

/// The steps of section 4: actions until all agents rest or are removed, then the style's untidiness; after that,
/// ways are cleared and rugs laid. Returns how many ways stay closed.
fn act_all(environment: &mut Environment<'_>, untidiness: &Untidiness, key: &RoomKey) -> usize {
    lock::settle_locked(environment);
    arrange::arrange(environment, key);
    push::push_apart(environment);
    if untidy::make_untidy(environment, untidiness, key) {
        arrange::arrange(environment, key);
    }
    let lacks_turn = environment.access == Access::Wheelchair && turning::lacks_turn(environment, key);
    let closed_ways = ways::clear_ways(environment, key);
    covering::lay(environment);
    closed_ways + usize::from(lacks_turn)
}

/// Whom the next attempt should serve first: the required pieces that found no place, and those by which they would
/// stand. What goes wrong first is dealt with first: D. Joslin, D. Clements, "Squeaky Wheel Optimization", 1999.
fn missed(environment: &Environment<'_>) -> BTreeSet<AgentIndex> {
    let is_missed = |agent: &AgentIndex| {
        let Agent { piece, state, .. } = &environment.agents[*agent];
        piece.is_required && matches!(state, State::Removed(_))
    };
    let missed: BTreeSet<AgentIndex> = (0..environment.agents.len()).filter(is_missed).collect();
    let rules = missed.iter().flat_map(|&agent| &environment.class(agent).parents);
    let parents = rules.filter_map(|rule| match &rule.parent {
        ParentName::Classes(classes) => Some(environment.resting_of(classes)),
        _ => None,
    });
    missed.iter().copied().chain(parents.flatten()).collect()
}

/// One of the times that a room is furnished.
struct Attempt<T> {
    furnished: Furnished,
    closed_ways: usize,
    told: Told<T>,
}

impl<T> Attempt<T> {
    /// Classes of which a required piece is missing and none is there, ways that are closed, required pieces that
    /// are missing, all that are missing: what attempts are compared by, in this order.
    fn lack(&self) -> [usize; 4] {
        let required = || self.furnished.removals.iter().filter(|removal| removal.is_required);
        let is_there = |class| self.furnished.placements.iter().any(|placement| placement.class == class);
        let classes: BTreeSet<ClassIndex> = required().map(|removal| removal.class).collect();
        let without_any = classes.into_iter().filter(|&class| !is_there(class)).count();
        [without_any, self.closed_ways, required().count(), self.furnished.removals.len()]
    }

    /// Steps after which no further attempt begins.
    fn most_steps(&self) -> u64 {
        if self.closed_ways > 0 { MOST_STEPS_FOR_WAYS } else { MOST_STEPS }
    }

    /// How many attempts the room deserves.
    fn deserved_attempts(&self, alternative: u32) -> u32 {
        let [without_any, ways, required, all] = self.lack();
        let misses_many = all as f64 > MISSING_SHARE * f64::from(self.furnished.requested);
        let is_in_need = without_any > 0 || ways > 0;
        match (is_in_need, alternative) {
            (true, 0) => ATTEMPTS_IN_NEED,
            (true, _) => ATTEMPTS,
            (false, 0) if required > 0 || misses_many => ATTEMPTS,
            // Who compares alternatives has more of them.
            (false, _) => 1,
        }
    }
}

fn site(level: &Level, room: &Room) -> Site {
    let is_window =
        |side: &crate::plan::RoomOpening| level.openings[side.opening].kind == OpeningKind::Window;
    let windows = room.openings.iter().filter(|side| is_window(side)).count();
    let window_count = u32::try_from(windows).expect("a room has fewer than 2^32 windows");
    Site { area: room.region.area(), window_count }
}
