//! `merge`: joins the records of several bakes.

use super::answer::{MergeAnswer, fault_answers};
use super::arguments::MergeArguments;
use super::exit::Outcome;
use super::screen::Screen;
use crate::batch::{MergeReport, merge};

/// Runs the command.
pub(crate) fn run(arguments: &MergeArguments, screen: Screen) -> Outcome {
    match merge(&arguments.folder) {
        Ok(report) => show(&report, screen),
        Err(fault) => {
            let hint = fault.hint.as_ref().map(|hint| format!("\n  hint: {hint}")).unwrap_or_default();
            screen.error(&format!("error[{}]: {fault}{hint}", fault.code.name()));
            Outcome::NotStarted
        }
    }
}

fn show(report: &MergeReport, screen: Screen) -> Outcome {
    let MergeReport { manifest, totals, living_runs, faults } = report;
    screen.faults(faults);
    if screen.is_json {
        screen.json(&MergeAnswer {
            manifest: manifest.display().to_string(),
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
