//! `merge`: joins the records of several bakes.

use std::path::Path;

use super::answer::{MergeAnswer, fault_answers};
use super::arguments::MergeArguments;
use super::bake::{refuse, show_listed};
use super::exit::Outcome;
use super::screen::Screen;
use crate::batch::{ListedInputs, MANIFEST_NAME, MergeReport, PartsReport, merge, merge_parts};
use crate::document::counted;

/// Runs the command.
pub(crate) fn run(arguments: &MergeArguments, screen: Screen) -> Outcome {
    if let Some(records) = &arguments.records {
        return join_parts(records, arguments, screen);
    }
    match merge(&arguments.folder) {
        Ok(report) => show(&report, screen),
        Err(fault) => refuse(screen, &fault),
    }
}

fn show(report: &MergeReport, screen: Screen) -> Outcome {
    let MergeReport { manifest, totals, living_runs, faults } = report;
    show_listed(faults, screen);
    if screen.is_json {
        screen.json(&MergeAnswer {
            manifest: Some(manifest.display().to_string()),
            totals: totals.clone(),
            living_runs: *living_runs,
            rejected_records: fault_answers(faults),
        });
    } else if !screen.is_quiet {
        screen.result(&format!(
            "Joined into {}: {} rooms, {} objects.",
            manifest.display(),
            totals.rooms,
            totals.placed
        ));
    }
    if *living_runs > 0 {
        screen.note(&format!(
            "warning: {living_runs} bakes are still at work in this folder; merge again when they are done"
        ));
    }
    // The levels of records that were left out are missing now.
    Outcome::of_failures(!faults.is_empty())
}

/// Joins parts whose files are elsewhere.
fn join_parts(records: &Path, arguments: &MergeArguments, screen: Screen) -> Outcome {
    let planned = match arguments.levels.as_deref().map(ListedInputs::read).transpose() {
        Ok(planned) => planned,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    let out = arguments.out.clone().unwrap_or_else(|| records.join(MANIFEST_NAME));
    match merge_parts(records, planned.as_ref(), &out) {
        Ok(report) => show_parts(&report, &out, screen),
        Err(fault) => refuse(screen, &fault),
    }
}

fn show_parts(report: &PartsReport, out: &Path, screen: Screen) -> Outcome {
    let PartsReport { is_written, parts, levels, totals, faults } = report;
    show_listed(faults, screen);
    if screen.is_json {
        screen.json(&MergeAnswer {
            manifest: is_written.then(|| out.display().to_string()),
            totals: totals.clone(),
            living_runs: 0,
            rejected_records: fault_answers(faults),
        });
    } else if !screen.is_quiet && *is_written {
        screen.result(&format!(
            "Joined {} into {}: {}, {} rooms, {} objects.",
            counted(*parts, "part"),
            out.display(),
            counted(*levels, "level"),
            totals.rooms,
            totals.placed
        ));
    }
    if *is_written { Outcome::of_failures(!faults.is_empty()) } else { Outcome::NotStarted }
}
