//! `check`: reads plans and configuration, reports faults, writes nothing.

use super::answer::{CheckAnswer, fault_answers};
use super::arguments::CheckArguments;
use super::exit::Outcome;
use super::room_styles::check_room_styles;
use super::screen::Screen;
use super::sources::{run_style, survey_sources};
use crate::document::{Faults, counted};
use crate::project::Project;

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

fn report(sources: Option<&Project>, faults: &Faults) -> CheckAnswer {
    let (buildings, levels, rooms) = counts(sources);
    let errors = error_count(faults);
    CheckAnswer {
        buildings,
        levels,
        rooms,
        errors,
        warnings: faults.0.len() - errors,
        faults: fault_answers(faults),
    }
}

fn conclusion(sources: Option<&Project>, faults: &Faults) -> String {
    let (buildings, levels, rooms) = counts(sources);
    let errors = error_count(faults);
    let warnings = faults.0.len() - errors;
    let [buildings, levels, rooms, errors, warnings] = [
        (buildings, "building"),
        (levels, "level"),
        (rooms, "room"),
        (errors, "error"),
        (warnings, "warning"),
    ]
    .map(|(count, word)| counted(count, word));
    format!("{buildings}, {levels}, {rooms}: {errors}, {warnings}")
}

fn counts(sources: Option<&Project>) -> (usize, usize, usize) {
    let Some(sources) = sources else { return (0, 0, 0) };
    let levels = || sources.plan.buildings.iter().flat_map(|placed| &placed.building.levels);
    (sources.plan.buildings.len(), levels().count(), levels().map(|level| level.rooms.len()).sum())
}
