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
//!   times at most;
//! - an agent with wishes about other objects compares a few free places instead of taking the first.

mod agent;
mod arrange;
mod body;
mod choice;
mod constants;
mod environment;
mod explain;
mod furnished;
mod movement;
mod programme;
mod push;
mod result;
mod rules;
mod search;
mod seed;
mod surroundings;
#[cfg(test)]
mod tests;
mod trace;
mod untidy;
mod ways;

pub use body::{clearance_solids, solids};
pub use choice::room_style;
pub use explain::{
    Explanation, MissingStory, ObjectStory, ObstacleStory, ParentStory, Refusal, SearchStory, WallStory,
    Wish, explain, explain_alternative,
};
pub use furnished::{Furnished, Parent, Placement, Removal, RemovalReason};

use crate::catalog::{Catalog, Untidiness};
use crate::plan::{Level, OpeningKind, Room};

use constants::{ATTEMPTS, ATTEMPTS_IN_NEED, MISSING_SHARE};
use environment::Environment;
use programme::Site;
use seed::RoomKey;
use surroundings::Surroundings;

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
}

/// Furnishes one room of a level.
///
/// `room` is an index into `level.rooms`. The answer depends on the arguments only. Rooms whose type is not
/// furnished come back empty.
#[must_use]
pub fn furnish(level: &Level, room: usize, catalog: &Catalog, options: &FurnishOptions<'_>) -> Furnished {
    furnish_alternative(level, room, catalog, options, 0)
}

/// Furnishes one room as [`furnish`] does, with the same pieces in another arrangement for each `alternative`;
/// 0 is that of [`furnish`].
#[must_use]
pub fn furnish_alternative(
    level: &Level,
    room: usize,
    catalog: &Catalog,
    options: &FurnishOptions<'_>,
    alternative: u32,
) -> Furnished {
    let task = Task { level, room, catalog, options: *options, alternative };
    task.furnish(false, |_, _| ()).0
}

/// A room to furnish.
#[derive(Clone, Copy)]
struct Task<'a> {
    level: &'a Level,
    room: usize,
    catalog: &'a Catalog,
    options: FurnishOptions<'a>,
    alternative: u32,
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
        let key = RoomKey::new(options.seed, options.building, level, plan);
        let style = room_style(level, plan, catalog, &options);
        let room_type = catalog.room_types.get(&plan.room_type).filter(|room_type| room_type.is_furnished);
        let (Some(style), Some(room_type)) = (style, room_type) else {
            return (result::empty(room, key.seed(), style), None);
        };

        // The programme is drawn once: another attempt must not ask for other pieces.
        let pieces = programme::pieces(catalog, (style, room_type), site(level, plan), &key);
        let surroundings = Surroundings::new(level, plan);
        let attempt = |number: u32| {
            let mut environment = Environment::new(catalog, surroundings.clone(), &pieces);
            environment.trace = is_traced.then(|| trace::Trace::new(&environment));
            let attempt_key = key.attempt(alternative * ATTEMPTS_IN_NEED + number);
            let closed_ways = act_all(&mut environment, &style.untidiness, &attempt_key);
            let furnished = result::furnished(&environment, room, key.seed(), style);
            let told = Told { words: tell(&environment, &furnished), kept: number + 1, attempts: number + 1 };
            Attempt { furnished, closed_ways, told }
        };
        let mut best = attempt(0);
        // Who compares alternatives has many more of them.
        let most = if alternative == 0 { ATTEMPTS_IN_NEED } else { ATTEMPTS };
        for number in 1..most {
            if !best.is_worth_another(number) {
                break;
            }
            let next = attempt(number);
            if next.lack() < best.lack() {
                best = next;
            }
            best.told.attempts = number + 1;
        }
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
}

/// The steps of section 4: actions until all agents rest or are removed, then the style's untidiness; after that,
/// ways are cleared. Returns how many ways stay closed.
fn act_all(environment: &mut Environment<'_>, untidiness: &Untidiness, key: &RoomKey) -> usize {
    arrange::arrange(environment, key);
    push::push_apart(environment);
    if untidy::make_untidy(environment, untidiness, key) {
        arrange::arrange(environment, key);
    }
    ways::clear_ways(environment, key)
}

/// One of the times that a room is furnished.
struct Attempt<T> {
    furnished: Furnished,
    closed_ways: usize,
    told: Told<T>,
}

impl<T> Attempt<T> {
    /// Required pieces that are missing, then ways that are closed, then all pieces that are missing: what
    /// attempts are compared by.
    fn lack(&self) -> (usize, usize, usize) {
        let removals = &self.furnished.removals;
        let required = removals.iter().filter(|removal| removal.is_required).count();
        (required, self.closed_ways, removals.len())
    }

    /// Whether another attempt is worth its time after so many.
    fn is_worth_another(&self, attempts: u32) -> bool {
        let (required, ways, all) = self.lack();
        let misses_many = all as f64 > MISSING_SHARE * f64::from(self.furnished.requested);
        required > 0 || ways > 0 || (misses_many && attempts < ATTEMPTS)
    }
}

fn site(level: &Level, room: &Room) -> Site {
    let is_window =
        |side: &crate::plan::RoomOpening| level.openings[side.opening].kind == OpeningKind::Window;
    let windows = room.openings.iter().filter(|side| is_window(side)).count();
    let window_count = u32::try_from(windows).expect("a room has fewer than 2^32 windows");
    Site { area: room.region.area(), window_count }
}
