//! Best of several: a room is furnished from derived seeds until the audit finds nothing, a few times at most.
//!
//! Outside `layout/`, which knows no audit, and outside `audit/`, which changes no layout. The paper furnishes
//! each room once; that samples are ranked by how good a room they make is the way of P. Merrell et al.,
//! "Interactive Furniture Layout Using Interior Design Guidelines", 2011.

use core::cmp::Ordering;

use crate::audit::{Severity, Verdict, judge_room};
use crate::catalog::Catalog;
use crate::layout::{FurnishOptions, Furnished, furnish_alternative};
use crate::plan::Level;

/// How often a room is furnished at most where nothing else is said. Chosen by measurement: see the README.
pub const DEFAULT_EFFORT: u32 = 8;

/// A furnished room with what the audit says about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The room.
    pub furnished: Furnished,
    /// The verdict on it.
    pub verdict: Verdict,
    /// Which alternative it is, from 0.
    pub alternative: u32,
}

/// Furnishes one room up to `effort` times (at least once) and keeps the best.
///
/// `room` is an index into `level.rooms`. The answer depends on the arguments only; a greater effort never
/// gives a worse room, and with an effort of 1 the room is that of [`crate::layout::furnish`].
#[must_use]
pub fn furnish_best(
    level: &Level,
    room: usize,
    catalog: &Catalog,
    options: &FurnishOptions<'_>,
    effort: u32,
) -> Judged {
    best_of(
        effort,
        |alternative| furnish_alternative(level, room, catalog, options, alternative),
        |furnished| judge_room(level, room, furnished, catalog),
    )
}

/// The loop of [`furnish_best`], for callers that measure its parts: the first alternative without a finding
/// and with all that was asked for, else the best of `effort`; of equals the earlier one.
pub fn best_of(
    effort: u32,
    mut furnish: impl FnMut(u32) -> Furnished,
    mut judge: impl FnMut(&Furnished) -> Verdict,
) -> Judged {
    let mut make = |alternative: u32| {
        let furnished = furnish(alternative);
        let verdict = judge(&furnished);
        Judged { furnished, verdict, alternative }
    };
    let mut best = make(0);
    for alternative in 1..effort {
        if best.is_flawless() {
            break;
        }
        let next = make(alternative);
        if next.is_better_than(&best) {
            best = next;
        }
    }
    best
}

impl Judged {
    /// Whether another alternative cannot be better.
    fn is_flawless(&self) -> bool {
        self.flaws() == (0, 0, 0)
    }

    /// Whether it has fewer flaws, or as few and a higher score.
    fn is_better_than(&self, other: &Self) -> bool {
        let score = |judged: &Self| judged.verdict.score.map_or(0.0, |score| score.value);
        match self.flaws().cmp(&other.flaws()) {
            Ordering::Less => true,
            Ordering::Equal => score(self) > score(other),
            Ordering::Greater => false,
        }
    }

    /// What alternatives are compared by first: findings that fail the room, then the minor ones, then missing pieces.
    fn flaws(&self) -> (usize, usize, usize) {
        let count = |severity: Severity| {
            self.verdict.findings.iter().filter(|finding| finding.severity == severity).count()
        };
        (count(Severity::Failed), count(Severity::Minor), self.furnished.removals.len())
    }
}
