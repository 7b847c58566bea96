//! The events that a bake reports while it runs, and its report at the end.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::fault::{FaultCode, OutputFault};
use super::join::Joined;
use super::record::Totals;
use super::unplanned::Leftovers;
use crate::edits::Misfit;

/// One step of a bake. Steps of different levels come in any order, from any thread.
#[derive(Clone, Debug)]
pub enum Event<'a> {
    /// Before the first level.
    Started {
        /// Levels to bake.
        levels: usize,
        /// Rooms in them.
        rooms: usize,
        /// Levels that are up to date.
        kept: usize,
    },
    /// A level is in place.
    Baked {
        /// Building id.
        building: &'a str,
        /// Level id.
        level: &'a str,
        /// Its sums.
        totals: &'a Totals,
    },
    /// A level, or one room of it, failed.
    Failed(&'a LevelFailure),
}

/// Takes the steps; called from many threads at once.
pub type Observer<'a> = dyn Fn(&Event<'_>) + Sync + 'a;

/// Why a level is not in place, or why one of its rooms is empty.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LevelFailure {
    /// Building id.
    pub building: String,
    /// Level id.
    pub level: String,
    /// Room id, if the fault is in one room: the level is written all the same.
    pub room: Option<String>,
    /// The kind.
    pub code: FaultCode,
    /// The fact.
    pub message: String,
    /// Advice for the user.
    pub hint: Option<String>,
    /// Seed of the run, with which the fault can be repeated.
    pub seed: u64,
}

/// An edit that does not fit a level that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelMisfit {
    /// Building id.
    pub building: String,
    /// Level id.
    pub level: String,
    /// Room id.
    pub room: String,
    /// Which edit, and why.
    pub misfit: Misfit,
}

/// How a bake went.
#[derive(Clone, Debug)]
pub struct BakeReport {
    /// Levels written.
    pub baked: usize,
    /// Levels that were up to date.
    pub kept: usize,
    /// Levels that were not tried because the run stopped early.
    pub skipped: usize,
    /// The failures, sorted by building, level and room.
    pub failures: Vec<LevelFailure>,
    /// Edits that do not fit the levels written, sorted by building, level and room; those of levels that were kept are
    /// counted in `in_place`.
    pub misfits: Vec<LevelMisfit>,
    /// Sums over the levels written.
    pub written: Totals,
    /// Sums over all levels in place, written or kept.
    pub in_place: Totals,
    /// Bytes written.
    pub bytes: u64,
    /// Where the time went.
    pub timings: Timings,
    /// Where the records are, or why they could not be joined.
    pub joined: Result<Joined, OutputFault>,
    /// The leftovers of earlier bakes in the folder.
    pub leftovers: Leftovers,
}

/// The stages that are timed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Furnishing rooms.
    Layout,
    /// Judging rooms.
    Audit,
    /// Models and the tree of nodes.
    Scene,
    /// The tree to bytes, and their hash.
    Encoding,
    /// Files and journal.
    Writing,
}

impl Stage {
    /// All stages, in the order of the work.
    pub const ALL: [Self; 5] = [Self::Layout, Self::Audit, Self::Scene, Self::Encoding, Self::Writing];

    /// The word in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["layout", "audit", "scene", "encoding", "writing"][self as usize]
    }
}

/// Time by stage, summed over threads. For reports only; nothing in a file depends on it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Timings([Duration; Stage::ALL.len()]);

impl Timings {
    /// Time of one stage.
    #[must_use]
    pub fn of(&self, stage: Stage) -> Duration {
        self.0[stage as usize]
    }
}

/// Collects [`Timings`] from many threads.
#[derive(Debug, Default)]
pub(crate) struct Stopwatch([AtomicU64; Stage::ALL.len()]);

impl Stopwatch {
    /// Runs `work` and adds its time to a stage.
    pub(crate) fn measure<T>(&self, stage: Stage, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        let nanoseconds = u64::try_from(start.elapsed().as_nanos()).unwrap_or(u64::MAX);
        self.0[stage as usize].fetch_add(nanoseconds, Ordering::Relaxed);
        result
    }

    /// The sums so far.
    pub(crate) fn timings(&self) -> Timings {
        Timings(std::array::from_fn(|stage| Duration::from_nanos(self.0[stage].load(Ordering::Relaxed))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stage_gets_its_share_of_the_time() {
        let watch = Stopwatch::default();
        assert_eq!(watch.measure(Stage::Scene, || 5), 5);
        assert_eq!(watch.timings().of(Stage::Layout), Duration::ZERO);
    }

    #[test]
    fn names_follow_the_order() {
        let names: Vec<_> = Stage::ALL.iter().map(|stage| stage.name()).collect();
        assert_eq!(names, ["layout", "audit", "scene", "encoding", "writing"]);
    }
}
