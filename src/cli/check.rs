//! `check`: reads everything, writes nothing.

use serde_json::json;

use super::arguments::CheckArguments;
use super::exit::Outcome;
use super::room_styles::check_room_styles;
use super::screen::{FaultReport, Screen};
use super::sources::{Sources, run_style, survey_sources};
use crate::document::Faults;

/// Runs the command. The report is the result: it goes to stdout.
pub(crate) fn run(arguments: &CheckArguments, screen: Screen) -> Outcome {
    let (read, mut faults) = survey_sources(&arguments.sources);
    if let Some(sources) = &read {
        faults.merge(check_room_styles(&sources.plan, &sources.catalog));
        faults.merge(run_style(arguments.style.as_ref(), sources).err().unwrap_or_default());
    }
    if screen.is_json {
        screen.json(&report(read.as_ref(), &faults));
    } else {
        for fault in &faults {
            screen.result(&fault.report());
        }
        if !screen.is_quiet {
            screen.result(&conclusion(read.as_ref(), &faults));
        }
    }
    Outcome::of_failures(faults.has_errors())
}

fn error_count(faults: &Faults) -> usize {
    faults.0.iter().filter(|fault| fault.is_error()).count()
}

fn report(sources: Option<&Sources>, faults: &Faults) -> serde_json::Value {
    let (buildings, levels, rooms) = counts(sources);
    let errors = error_count(faults);
    json!({
        "buildings": buildings, "levels": levels, "rooms": rooms,
        "errors": errors, "warnings": faults.0.len() - errors,
        "faults": faults.0.iter().map(FaultReport::from).collect::<Vec<_>>(),
    })
}

fn conclusion(sources: Option<&Sources>, faults: &Faults) -> String {
    let (buildings, levels, rooms) = counts(sources);
    let errors = error_count(faults);
    let warnings = faults.0.len() - errors;
    format!("{buildings} buildings, {levels} levels, {rooms} rooms: {errors} errors, {warnings} warnings")
}

fn counts(sources: Option<&Sources>) -> (usize, usize, usize) {
    let Some(sources) = sources else { return (0, 0, 0) };
    let levels = || sources.plan.buildings.iter().flat_map(|placed| &placed.building.levels);
    (sources.plan.buildings.len(), levels().count(), levels().map(|level| level.rooms.len()).sum())
}
