//! `audit`: judges finished files, edited or not.

mod files;
mod judge;
mod text;

use std::path::Path;

use rayon::prelude::*;

use super::answer::{AuditAnswer, fault_answers};
use super::arguments::AuditArguments;
use super::exit::Outcome;
use super::screen::Screen;
use crate::audit::AuditSummary;
use crate::catalog::{Catalog, load_catalog};
use crate::document::{Faults, Warned};

pub(super) use files::level_files;
pub(super) use judge::JudgedLevel;
use judge::judge_file;

/// Most findings that are listed one by one.
const LISTED_FINDINGS: usize = 40;

/// Runs the command. The report is the result: it goes to stdout, faults of the files to stderr.
pub(crate) fn run(arguments: &AuditArguments, screen: Screen) -> Outcome {
    let (catalog, files, mut faults) = match inputs(arguments) {
        Ok((Warned { value, warnings }, files, faults)) => {
            screen.faults(&warnings);
            (value, files, faults)
        }
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    // One file a thread, collected in the order of their names.
    let judged: Vec<Result<JudgedLevel, Faults>> =
        files.par_iter().map(|file| judge_file(file, &catalog)).collect();
    let mut levels = Vec::new();
    for result in judged {
        match result {
            Ok(mut level) => {
                faults.merge(std::mem::take(&mut level.faults));
                levels.push(level);
            }
            Err(others) => faults.merge(others),
        }
    }
    screen.faults(&faults);
    show(arguments, screen, &levels, &faults);
    outcome(&levels, &faults)
}

/// The catalogue, the files to judge, and what is known to be missing or superfluous.
fn inputs(arguments: &AuditArguments) -> Result<(Warned<Catalog>, Vec<std::path::PathBuf>, Faults), Faults> {
    let (files, faults) = level_files(&arguments.paths)?;
    Ok((load_catalog(&arguments.catalog)?, files, faults))
}

fn totals(levels: &[JudgedLevel]) -> AuditSummary {
    let mut totals = AuditSummary::default();
    levels.iter().for_each(|level| totals.merge(&level.totals));
    totals
}

fn show(arguments: &AuditArguments, screen: Screen, levels: &[JudgedLevel], faults: &Faults) {
    let totals = totals(levels);
    if screen.is_json {
        screen.json(&AuditAnswer { totals, levels, faults: fault_answers(faults) });
    } else if !screen.is_quiet && !levels.is_empty() {
        let most = if arguments.all { usize::MAX } else { LISTED_FINDINGS };
        screen.result(&text::report(levels, &totals, most));
    }
}

fn outcome(levels: &[JudgedLevel], faults: &Faults) -> Outcome {
    if levels.iter().all(|level| level.rooms.is_empty()) && faults.has_errors() {
        return Outcome::NotStarted;
    }
    let has_failed = levels.iter().any(|level| level.totals.grades.failed > 0);
    Outcome::of_failures(has_failed || faults.has_errors())
}

/// A path as reports show it.
fn shown(path: &Path) -> String {
    path.display().to_string()
}
