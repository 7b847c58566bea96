//! Furnishes a room: of level, room, catalogue and seed it makes a [`Furnished`] room, by the agent system of the paper.
//! `ARCHITECTURE.md` follows one room through these files.
//!
//! T. Germer, M. Schwarz, "Procedural Arrangement of Furniture for Real-Time Walkthroughs", Computer
//! Graphics Forum, 2009, section 3. Pure: no files, no threads, no clock. Departures from the paper:
//! - the parent's true shape takes part in the collision test (`environment`), so that a chair slides under a
//!   table without meeting a leg;
//! - along walls, positions are drawn from the stretches that are really free (`rules`);
//! - clearances, door swings and approaches are regions that bodies keep out of;
//! - agents that close the only way to a door or to a used side search again (`ways`);
//! - a room that lacks a required piece, a way, or many pieces is furnished again from a derived seed, a few
//!   times at most; the agents that were missing search first;
//! - the units of a kitchen do not search one by one: their row is planned as a whole (`fitted`), and the fixtures of a
//!   bathroom look for their places together (`jointly`);
//! - an agent with wishes about other objects compares a few free places instead of taking the first.

mod agent;
mod arrange;
mod arrangement;
mod at_wall;
mod attempt;
mod body;
mod brief;
mod choice;
mod constants;
mod covering;
mod environment;
mod explain;
mod first_search;
mod fitted;
mod fitted_row;
mod furnished;
mod ids;
mod jointly;
mod known;
mod lattice;
mod lock;
mod locked;
mod movement;
mod options;
mod place;
mod programme;
mod push;
mod refused_slots;
mod result;
mod rules;
mod search;
pub(crate) mod seed;
mod shortcomings;
mod spot;
mod suggested;
mod suggestion;
mod surroundings;
#[cfg(test)]
mod tests;
mod trace;
mod turning;
mod untidy;
mod useless;
mod variant;
mod wanted;
mod ways;

pub use body::{clearance_solids, solids};
pub use choice::room_style;
pub use explain::{Explanation, MissingStory, ObjectStory, Refusal, SearchStory, Wish};
pub use furnished::{Furnished, Parent, Placement, Removal, RemovalReason};
pub(crate) use ids::{object_id, opening_id, parent_id};
pub use lock::{Lock, LockSupport};
pub use options::FurnishOptions;
pub use rules::PoorPlaces;
pub use shortcomings::Shortcomings;
pub use suggestion::{Alternative, Suggestion};
pub use wanted::StandIns;

use crate::catalog::Catalog;
use crate::plan::RoomRef;

use attempt::{Kept, Recording, best_attempt};
use brief::RoomBrief;

/// Furnishes one room of a level.
///
/// The answer depends on the arguments only. Rooms whose type is not
/// furnished come back empty.
#[must_use]
pub fn furnish(at: RoomRef<'_>, catalog: &Catalog, options: &FurnishOptions<'_>) -> Furnished {
    RoomLayout::new(at, catalog, options).furnish(&Alternative::default()).furnished
}

/// A room to be furnished in one or several alternatives; what they have in common is worked out once.
pub struct RoomLayout<'a> {
    /// The empty room where its type is not furnished.
    brief: Result<RoomBrief<'a>, Furnished>,
}

/// A furnished room, and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Counted {
    /// The room.
    pub furnished: Furnished,
    /// Work of all attempts, in steps of about a tenth of a microsecond: the same on every machine.
    pub steps: u64,
    /// What it lacks, beside the removals.
    pub shortcomings: Shortcomings,
    /// Whether it was given up before it was finished ([`Alternative::gives_up_at`]): the room holds what had found a place by then.
    pub is_given_up: bool,
}

impl<'a> RoomLayout<'a> {
    /// The data that the alternatives of a room share.
    #[must_use]
    pub fn new(at: RoomRef<'a>, catalog: &'a Catalog, options: &FurnishOptions<'a>) -> Self {
        Self { brief: RoomBrief::new(at, catalog, options) }
    }

    /// Furnishes the room with the same pieces in another arrangement for each `alternative`; the default one is that
    /// of [`furnish`]. No answer depends on those before it.
    #[must_use]
    pub fn furnish(&self, alternative: &Alternative) -> Counted {
        match &self.brief {
            Ok(brief) => {
                let kept = best_attempt(&brief.alternative(alternative), Recording::Off, |_, _| ());
                let Kept { furnished, steps, shortcomings, is_given_up, .. } = kept;
                Counted { furnished, steps, shortcomings, is_given_up }
            }
            Err(furnished) => Counted {
                furnished: furnished.clone(),
                steps: 0,
                shortcomings: Shortcomings::default(),
                is_given_up: false,
            },
        }
    }

    /// Furnishes the room exactly as [`RoomLayout::furnish`] does, and explains what came of it.
    #[must_use]
    pub fn explain(&self, alternative: &Alternative) -> (Furnished, Explanation) {
        match &self.brief {
            Ok(brief) => explain::explain(&brief.alternative(alternative)),
            Err(furnished) => (furnished.clone(), Explanation::default()),
        }
    }
}
