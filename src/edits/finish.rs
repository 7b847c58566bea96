//! Furnishes a room, applies its edits, and judges it.

use super::apply::{Edited, apply};
use super::book::{LevelEdits, RoomEdits};
use super::misfit::Misfit;
use crate::audit::{Finding, Severity, Verdict};
use crate::best::{Judged, furnish_best};
use crate::catalog::Catalog;
use crate::layout::{FurnishOptions, Furnished, Lock};
use crate::plan::{Level, RoomRef};
use crate::solve::judge_room;

/// A room after its edits.
#[derive(Clone, Debug)]
pub struct Finished {
    /// The room and the verdict on it as it is now.
    pub judged: Judged,
    /// Rejected edits, and edits with findings, by id of the object.
    pub misfits: Vec<Misfit>,
}

impl RoomEdits {
    /// The locked objects, which are placed first.
    #[must_use]
    pub fn locks(&self, at: RoomRef<'_>, catalog: &Catalog) -> Vec<Lock> {
        super::locks::locks(at, self, catalog)
    }

    /// The options of a run for this room.
    #[must_use]
    pub fn options<'a>(&self, run: FurnishOptions<'a>, locks: &'a [Lock]) -> FurnishOptions<'a> {
        FurnishOptions { pinned: self.seed, locks, ..run }
    }
}

/// Furnishes one room as [`furnish_best`] does, with what people changed in it.
#[must_use]
pub fn furnish_edited(
    at: RoomRef<'_>,
    catalog: &Catalog,
    run: &FurnishOptions<'_>,
    effort: u32,
    edits: Option<&LevelEdits>,
) -> Finished {
    let Some(edits) = edits.and_then(|edits| edits.room(&at.room.id)) else {
        let judged = furnish_best(at, catalog, run, effort);
        return Finished { judged, misfits: Vec::new() };
    };
    let locks = edits.locks(at, catalog);
    let judged = furnish_best(at, catalog, &edits.options(*run, &locks), effort);
    finish(at.level, judged, edits, catalog, |furnished| judge_room(at, furnished, catalog))
}

/// Makes the edits of a room that was furnished with [`RoomEdits::options`].
///
/// `judge` returns the findings of the audit in the edited room. An edited object with a finding stays at its place, and the
/// finding is reported.
#[must_use]
pub fn finish(
    level: &Level,
    judged: Judged,
    edits: &RoomEdits,
    catalog: &Catalog,
    judge: impl FnOnce(&Furnished) -> Verdict,
) -> Finished {
    if edits.objects.is_empty() {
        return Finished { judged, misfits: Vec::new() };
    }
    let Edited { furnished, mut misfits, touched } = apply(level, &judged.furnished, edits, catalog);
    let verdict = judge(&furnished);
    let mut told: Vec<&Finding> = Vec::new();
    for (id, edit_id) in &touched {
        // A finding about two edited objects is reported once.
        let is_news = |finding: &&Finding| {
            let is_about = finding.objects.iter().any(|object| object == id);
            finding.severity == Severity::Failed && is_about && !told.contains(finding)
        };
        if let (Some(finding), Some(edit)) =
            (verdict.findings.iter().find(is_news), edits.objects.get(edit_id))
        {
            told.push(finding);
            let Finding { code, objects, measured, threshold, .. } = finding;
            let message = format!(
                "{id} stands where the edit wants it, but the room fails: {} of {}, {}, threshold {threshold}",
                code.name(),
                objects.join(" and "),
                // To a tenth of a millimetre.
                (measured * 1e4).round() / 1e4,
            );
            misfits.push(Misfit::made(&edit.mark, message, "move it, or what it meets"));
        }
    }
    misfits.dedup();
    Finished { judged: Judged { furnished, verdict, ..judged }, misfits }
}
