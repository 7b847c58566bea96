//! `merge`: joins the records of several bakes.

use super::answer::{MergeAnswer, fault_answers};
use super::arguments::MergeArguments;
use super::bake::show_listed;
use super::exit::Outcome;
use super::screen::Screen;
use crate::batch::{MANIFEST_NAME, MergeReport, merge, merge_records};

/// Runs the command.
pub(crate) fn run(arguments: &MergeArguments, screen: Screen) -> Outcome {
    if let Some(records) = &arguments.records {
        let out = arguments.out.clone().unwrap_or_else(|| records.join(MANIFEST_NAME));
        return match merge_records(records, &out) {
            Ok(report) => show(&report, screen),
            Err(faults) => {
                show_listed(&faults, screen);
                Outcome::NotStarted
            }
        };
    }
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
    show_listed(faults, screen);
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
