//! The summary of a bake, for people and as JSON.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use indicatif::{HumanBytes, HumanCount};

use super::answer::{BakeAnswer, FailureAnswer, FaultAnswer, MisfitAnswer};
use super::leftovers::leftovers_answer;
use crate::audit::{AuditSummary, Code, GradeCounts};
use crate::batch::{BakeReport, Joined, LevelFailure, LevelMisfit, Stage, Totals};
use crate::document::printable;
use crate::output::{Format, INDEX_NAME, output_format};

/// The summary for people.
pub(crate) fn summary_text(report: &BakeReport, elapsed: Duration) -> String {
    let count = |number: u64| HumanCount(number).to_string();
    let Totals { rooms, placed, .. } = report.written;
    let rate = rooms as f64 / elapsed.as_secs_f64().max(f64::EPSILON);
    let mut lines = vec![format!(
        "Baked {}, {} rooms, {} objects ({}) in {:.2} s ({} rooms/s).",
        levels(report.baked),
        count(rooms),
        count(placed),
        HumanBytes(report.bytes),
        elapsed.as_secs_f64(),
        count(rate as u64),
    )];
    if report.kept > 0 {
        lines.push(format!("Kept {} without changes.", levels(report.kept)));
    }
    let Totals { requested, removed, audit, .. } = &report.in_place;
    let GradeCounts { none, minor, failed } = audit.grades;
    lines.push(format!(
        "Rooms by verdict: {} without findings, {} with minor ones, {} failed. Of {} requested pieces {} found no \
         place.",
        count(none),
        count(minor),
        count(failed),
        count(*requested),
        count(*removed),
    ));
    lines.extend(audit_lines(audit));
    if report.in_place.misfits > 0 {
        let count = count(report.in_place.misfits);
        lines.push(format!("Rejected edits: {count}. The edits files keep them."));
    }
    if report.skipped > 0 {
        lines.push(format!("Stopped early: {} were not tried.", levels(report.skipped)));
    }
    lines.join("\n")
}

/// The counts of findings and the mean score, where there are any.
pub(crate) fn audit_lines(audit: &AuditSummary) -> Vec<String> {
    let counts = |counts: &BTreeMap<Code, u64>| {
        let each = counts.iter().map(|(code, &count)| format!("{} {}", code.name(), HumanCount(count)));
        each.collect::<Vec<_>>().join(", ")
    };
    let mut lines = Vec::new();
    if !audit.findings.is_empty() {
        lines.push(format!("Findings: {}.", counts(&audit.findings)));
    }
    if !audit.given.is_empty() {
        lines.push(format!(
            "Given findings, unavoidable by the plans and not counted: {}.",
            counts(&audit.given)
        ));
    }
    if let Some(mean) = audit.score.mean() {
        lines
            .push(format!("Mean score of {} furnished rooms: {mean}.", HumanCount(audit.score.room_count())));
    }
    lines
}

fn levels(number: usize) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{} level{plural}", HumanCount(number as u64))
}

/// Where the results are.
pub(crate) fn where_to_look(report: &BakeReport, out: &Path, format: Format) -> String {
    match &report.joined {
        Ok(Joined::Whole(manifest)) => match output_format(format).has_index {
            true => {
                let index = out.join(INDEX_NAME);
                format!("Results: {}, all files listed in {}", index.display(), manifest.display())
            }
            false => {
                format!("Results: {}/<building>/<level>, all listed in {}", out.display(), manifest.display())
            }
        },
        Ok(Joined::Part(part)) => format!(
            "Results: {}/<building>/<level>, this share listed in {}; the last share, or `roomwright merge {}`, joins \
             the lists.",
            out.display(),
            part.display(),
            out.display()
        ),
        Err(_) => format!("Results: {}/<building>/<level>", out.display()),
    }
}

/// Where the time went, as shares of the work of all threads.
pub(crate) fn timing_text(report: &BakeReport) -> String {
    let all: f64 = Stage::ALL.iter().map(|stage| report.timings.of(*stage).as_secs_f64()).sum();
    let share = |stage: &Stage| {
        let share = 100.0 * report.timings.of(*stage).as_secs_f64() / all.max(f64::EPSILON);
        format!("{} {share:.0} %", stage.name())
    };
    let shares: Vec<String> = Stage::ALL.iter().map(share).collect();
    format!("Time: {} of {all:.2} s of work", shares.join(", "))
}

/// The summary for machines: no times, so that two runs can be compared.
pub(crate) fn bake_answer(report: &BakeReport, out: &Path) -> BakeAnswer {
    BakeAnswer {
        out: out.display().to_string(),
        manifest: manifest_path(report),
        is_complete: matches!(report.joined, Ok(Joined::Whole(_))),
        baked_levels: report.baked,
        kept_levels: report.kept,
        skipped_levels: report.skipped,
        totals: report.in_place.clone(),
        failures: report.failures.iter().map(failure_answer).collect(),
        misfits: report.misfits.iter().map(misfit_answer).collect(),
        leftovers: leftovers_answer(&report.leftovers),
    }
}

fn manifest_path(report: &BakeReport) -> Option<String> {
    match &report.joined {
        Ok(Joined::Whole(path) | Joined::Part(path)) => Some(path.display().to_string()),
        Err(_) => None,
    }
}

fn misfit_answer(found: &LevelMisfit) -> MisfitAnswer {
    let LevelMisfit { building, level, room, misfit } = found;
    MisfitAnswer {
        building: building.clone(),
        level: level.clone(),
        room: room.clone(),
        is_made: misfit.is_made,
        fault: FaultAnswer::from(&misfit.fault),
    }
}

/// A failure for machines.
pub(crate) fn failure_answer(failure: &LevelFailure) -> FailureAnswer {
    let LevelFailure { building, level, room, code, message, hint, seed } = failure.clone();
    FailureAnswer { code: code.name().to_owned(), building, level, room, message, hint, seed }
}

/// A failure for people.
pub(crate) fn failure_text(failure: &LevelFailure) -> String {
    let LevelFailure { building, level, room, code, message, hint, seed } = failure;
    let room = room.as_ref().map(|room| format!("/{room}")).unwrap_or_default();
    let place = printable(&format!("{building}/{level}{room}"));
    let hint = hint.as_ref().map(|hint| format!("\n  hint: {hint}")).unwrap_or_default();
    format!("error[{}]: {place} (seed {seed}): {}{hint}", code.name(), printable(message))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::FaultCode;

    #[test]
    fn a_failure_has_code_place_seed_and_hint() {
        let failure = LevelFailure {
            building: "tower".to_owned(),
            level: "3".to_owned(),
            room: Some("12".to_owned()),
            code: FaultCode::RoomBroken,
            message: "the program failed: index out of range".to_owned(),
            hint: Some("report it".to_owned()),
            seed: 9,
        };
        assert_eq!(
            failure_text(&failure),
            "error[room_broken]: tower/3/12 (seed 9): the program failed: index out of range\n  hint: report it"
        );
        assert_eq!(failure_answer(&failure).room.as_deref(), Some("12"));
    }
}
