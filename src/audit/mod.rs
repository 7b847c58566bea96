//! Building and placements to findings; never changes a layout.
//!
//! The audit has its own geometry (`convex`): of the layout's it uses only the statement of what is solid
//! ([`crate::layout::solids`]). Where people walk, `walk` tells both. What each code means stands at the
//! head of the file that judges it, the figures and where they come from in `configs/audit.yaml`.

mod access;
mod bare;
mod bedside;
mod bounds;
mod budget;
mod clearances;
mod collision;
mod containment;
mod convex;
mod crooked;
mod doors;
mod facing;
mod finding;
mod fit;
mod groups;
mod halves;
mod known;
mod measure;
mod near;
mod programme;
mod reach;
mod relations;
mod score;
mod screens;
mod sparse;
mod subject;
mod summary;
mod support;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;
mod thresholds;
mod tight;
mod together;
mod verdict;
mod wet_room;
mod windows;
mod zone;

pub use finding::{Code, Finding, Grade, Severity};
pub use measure::Measure;
pub use score::Score;
pub use summary::{AuditSummary, GradeCounts, ScoreSum};
pub use verdict::{DoorRate, Verdict};

use std::rc::Rc;

use crate::catalog::Catalog;
use crate::layout::{Furnished, Suggestion};
use crate::plan::Level;

use known::RoomKnowledge;
use near::MOST_NEAR;
use subject::Subject;
use zone::{NearPair, Zone};

/// The findings of [`judge_room`].
///
/// # Panics
/// As [`judge_room`].
#[must_use]
pub fn audit_room(level: &Level, room: usize, furnished: &Furnished, catalog: &Catalog) -> Vec<Finding> {
    judge_room(level, room, furnished, catalog).findings
}

/// Judges one furnished room.
///
/// `room` is an index into `level.rooms`, `furnished` what the layout made of it.
///
/// # Panics
/// If `furnished` names a class, parent, wall or opening that does not exist.
#[must_use]
pub fn judge_room(level: &Level, room: usize, furnished: &Furnished, catalog: &Catalog) -> Verdict {
    RoomAudit::new(level, room, catalog).judge(furnished)
}

/// Judges several arrangements of one room; what it finds out about the empty room for one of them it knows for the others.
/// No answer depends on what was asked before.
#[derive(Debug)]
pub struct RoomAudit<'a> {
    level: &'a Level,
    room: usize,
    catalog: &'a Catalog,
    known: Rc<RoomKnowledge>,
}

impl<'a> RoomAudit<'a> {
    /// `room` is an index into `level.rooms`.
    #[must_use]
    pub fn new(level: &'a Level, room: usize, catalog: &'a Catalog) -> Self {
        Self { level, room, catalog, known: Rc::default() }
    }

    /// Judges one arrangement.
    ///
    /// # Panics
    /// As [`judge_room`].
    #[must_use]
    pub fn judge(&self, furnished: &Furnished) -> Verdict {
        let subject = self.subject(furnished);
        let verdict = judge(&subject);
        self.count(&subject);
        verdict
    }

    /// Where the pieces could stand that the room misses and cannot do without, beside whatever else it cannot do without:
    /// places found in the empty room, for [`crate::layout::furnish_alternative`]. Empty where nothing is missing or no
    /// such places were found.
    ///
    /// # Panics
    /// As [`judge_room`].
    #[must_use]
    pub fn suggest_places(&self, furnished: &Furnished) -> Vec<Suggestion> {
        let subject = self.subject(furnished);
        let suggestions = programme::suggest(&subject);
        self.count(&subject);
        suggestions
    }

    /// Steps that were made so far to find out what the empty room could hold, the same on every machine.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.known.steps.get()
    }

    fn count(&self, subject: &Subject<'_>) {
        self.known.steps.set(self.known.steps.get() + subject.budget.made());
    }

    fn subject<'s>(&self, furnished: &'s Furnished) -> Subject<'s>
    where
        'a: 's,
    {
        Subject::new(self.level, self.room, furnished, self.catalog).knowing(&self.known)
    }
}

fn judge(subject: &Subject<'_>) -> Verdict {
    let mut findings = Vec::new();
    // The physical faults that one body can have by itself.
    containment::judge(subject, &mut findings);
    support::judge(subject, &mut findings);
    // What two bodies, or a body and a zone that people need, do to each other.
    let zones = all_zones(subject);
    let (collisions, hits) = near_pairs(subject, &zones);
    collision::judge(subject, &collisions, &mut findings);
    doors::judge(subject, &hits, &mut findings);
    clearances::judge(subject, &zones, &hits, &mut findings);
    let comfort = tight::takings(subject, &zones, &hits);
    tight::judge(subject, &comfort, &mut findings);
    windows::judge(subject, &hits, &mut findings);
    screens::judge(subject, &hits, &mut findings);
    wet_room::judge(subject, &hits, &mut findings);
    // Ways through the room.
    let floor = reach::floor(subject);
    let rates = floor.map_or_else(Vec::new, |floor| {
        bedside::judge(subject, &floor, &mut findings);
        reach::judge(subject, &floor, &zones, &mut findings)
    });
    access::judge(subject, &zones, &mut findings);
    // How things stand to each other and in the whole.
    facing::judge(subject, &mut findings);
    crooked::judge(subject, &mut findings);
    halves::judge(subject, &mut findings);
    // What should be there and is not.
    programme::judge(subject, &mut findings);
    sparse::judge(subject, &mut findings);
    bare::judge(subject, &mut findings);
    findings.sort_by(|a, b| a.code.cmp(&b.code).then_with(|| a.objects.cmp(&b.objects)));
    // Two pieces in each other's way are one finding.
    findings.dedup_by(|a, b| a.code == b.code && !a.objects.is_empty() && a.objects == b.objects);
    finding::bound(&mut findings);
    let score = score::score(
        subject,
        &score::Measured { zones: &zones, hits: &hits, comfort: &comfort, rates: &rates },
    );
    let door = |(door, rate): (usize, f64)| DoorRate {
        door: format!("door:{}", subject.level.openings[door].id),
        rate,
    };
    Verdict { findings, score, walkable: rates.into_iter().map(door).collect() }
}

/// Whatever people need to be free.
fn all_zones(subject: &Subject<'_>) -> Vec<Zone> {
    let mut zones = doors::zones(subject);
    zones.extend(clearances::zones(subject));
    zones.extend(windows::zones(subject));
    zones.extend(wet_room::zones(subject));
    zones
}

/// Pairs of bodies whose boxes touch, and pairs of a zone and a body whose boxes touch. A rug is floor for all but other
/// rugs.
fn near_pairs<'z>(subject: &Subject<'_>, zones: &'z [Zone]) -> (Vec<(usize, usize)>, Vec<NearPair<'z>>) {
    let boxes = || subject.bodies.iter().map(|body| body.bounds);
    let near = subject.near_boxes();
    let is_covering = |body: usize| subject.bodies[body].placement.is_covering();
    let mut collisions = near.touching_pairs(boxes());
    collisions.retain(|&(a, b)| is_covering(a) == is_covering(b));
    let mut hits: Vec<(usize, usize)> = Vec::new();
    for (number, zone) in zones.iter().enumerate() {
        let bodies = near.touching(&zone.bounds()).take(MOST_NEAR);
        hits.extend(bodies.filter(|&body| !is_covering(body)).map(|body| (body, number)));
    }
    // By body, whatever order they were found in.
    hits.sort_unstable();
    (collisions, hits.into_iter().map(|(body, zone)| (&zones[zone], body)).collect())
}
