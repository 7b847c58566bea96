//! Compares two bakes, or two files: rooms, furniture, openings, findings.
//!
//! Levels are paired by building and level. Files with equal hashes in both manifests are not opened. The others are read
//! as an inventory (`read_back::Inventory`), which needs no catalogue; the catalogue serves for verdicts on edited files
//! and for pictures only. `read` is the only file that opens any; everything else is pure. The answer does not depend on
//! the number of threads.

mod change;
mod kind;
mod levels;
mod matching;
mod nearest;
mod objects;
mod openings;
mod pairs;
mod picture;
mod read;
mod report;
mod rooms;
mod show;
mod tolerance;

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::catalog::Catalog;
use crate::document::{Fault, Faults};

use levels::compare_levels;
use pairs::{Entry, Pair, lone_buildings, pair_up, shared_files};
use read::{Folder, Side};

pub use change::{Change, Worth};
pub use kind::Kind;
pub use picture::{RoomPictures, draw_rooms};
pub use report::{LevelDiff, Presence, REPORT_VERSION, Report, RoomDiff, Summary, Trouble};
pub use show::{HtmlLimits, html, markdown, shown_rooms, text};
pub use tolerance::Tolerance;

/// How to compare.
#[derive(Clone, Copy)]
pub struct DiffOptions<'a> {
    /// The largest differences that are ignored.
    pub tolerance: Tolerance,
    /// Classes and thresholds for verdicts on edited files.
    pub catalog: &'a Catalog,
    /// Whether every file is read, also those that length and time say are as the manifest has them.
    pub is_thorough: bool,
    /// Told how many of how many levels are compared; called from many threads.
    pub observer: &'a (dyn Fn(usize, usize) + Sync),
}

/// Compares two folders or two files; besides the report, what cannot be read, errors and warnings.
///
/// # Errors
/// If a side cannot be opened, or one is a folder and the other a file.
pub fn compare(old: &Path, new: &Path, options: &DiffOptions<'_>) -> Result<(Report, Faults), Faults> {
    let (before, after) = match (read::open(old, options.is_thorough), read::open(new, options.is_thorough)) {
        (Ok(before), Ok(after)) => (before, after),
        (before, after) => {
            return Err(Faults([before.err(), after.err()].into_iter().flatten().collect()));
        }
    };
    let mut report = Report {
        diff: REPORT_VERSION,
        program: crate::scene::GENERATOR.to_owned(),
        old: shown(old),
        new: shown(new),
        tolerance: options.tolerance,
        summary: Summary::default(),
        buildings: std::collections::BTreeMap::new(),
        levels: Vec::new(),
        shared: std::collections::BTreeMap::new(),
        troubles: Vec::new(),
    };
    let found = match (&before, &after) {
        (Side::Folder(before), Side::Folder(after)) => {
            report.buildings = lone_buildings(&before.levels, &after.levels);
            report.shared = shared_files(&before.shared, &after.shared);
            compare_folders(before, after, options)
        }
        (Side::File(before), Side::File(after)) => vec![compare_files(before, after, options)],
        (Side::Folder(_), Side::File(file)) | (Side::File(file), Side::Folder(_)) => {
            let fault = Fault::of_file(file, "is a file, the other side is a folder");
            return Err(fault.with_hint("compare two folders, or two files").into());
        }
    };
    Ok(finish(report, found))
}

/// The result for one pair of levels; no difference if both are the same.
#[derive(Default)]
struct ComparedLevel {
    diff: Option<LevelDiff>,
    faults: Vec<Fault>,
}

fn finish(mut report: Report, found: Vec<ComparedLevel>) -> (Report, Faults) {
    let identical = found.iter().filter(|level| level.diff.is_none()).count();
    let mut faults = Vec::new();
    for level in found {
        report.levels.extend(level.diff);
        faults.extend(level.faults);
    }
    report.summary = Summary::of(identical as u64, &report.levels, report.shared.len());
    let errors = faults.iter().filter(|fault| fault.is_error());
    report.troubles = errors
        .map(|fault| Trouble {
            file: shown(&fault.file),
            message: fault.message.clone(),
            hint: fault.hint.clone(),
        })
        .collect();
    (report, Faults(faults))
}

/// One pair a thread, collected in the order of building and level.
fn compare_folders(old: &Folder, new: &Folder, options: &DiffOptions<'_>) -> Vec<ComparedLevel> {
    let pairs = pair_up(&old.levels, &new.levels);
    let (done, all) = (AtomicUsize::new(0), pairs.len());
    let compare = |pair: &Pair<'_>| {
        let found = match *pair {
            Pair::Old(entry) => lone_level(entry, Presence::Removed),
            Pair::New(entry) => lone_level(entry, Presence::Added),
            Pair::Both(before, after) => compare_entries(old, before, new, after, options),
        };
        (options.observer)(done.fetch_add(1, Ordering::Relaxed) + 1, all);
        found
    };
    pairs.par_iter().map(compare).collect()
}

/// A level on one side only: reported from its record, not opened.
fn lone_level(entry: &Entry, state: Presence) -> ComparedLevel {
    let file = entry.files.first().map(|file| file.path.clone());
    let worth = Worth::Numbers(vec![entry.totals.rooms as f64, entry.totals.placed as f64]);
    let (old, new) = if state == Presence::Removed { (Some(worth), None) } else { (None, Some(worth)) };
    let mut changes = vec![Change { old, new, ..Change::of(Kind::Levels, "") }];
    if state == Presence::Added && entry.totals.failed > 0 {
        changes.push(Change::of(Kind::FailedRooms, "").by(entry.totals.failed as f64));
    }
    let (old_file, new_file) = if state == Presence::Removed { (file, None) } else { (None, file) };
    let diff = LevelDiff {
        building: entry.building.clone(),
        level: entry.level.clone(),
        state,
        old_file,
        new_file,
        changes,
        rooms: Vec::new(),
    };
    ComparedLevel { diff: Some(diff), faults: Vec::new() }
}

/// A level of both folders.
fn compare_entries(
    old: &Folder,
    before: &Entry,
    new: &Folder,
    after: &Entry,
    options: &DiffOptions<'_>,
) -> ComparedLevel {
    let frame = LevelDiff {
        building: after.building.clone(),
        level: after.level.clone(),
        state: Presence::Changed,
        old_file: before.files.first().map(|file| file.path.clone()),
        new_file: after.files.first().map(|file| file.path.clone()),
        changes: Vec::new(),
        rooms: Vec::new(),
    };
    let current = match (old.current_files(before), new.current_files(after)) {
        (Ok(before), Ok(after)) => (before, after),
        (before, after) => return unreadable(frame, [before.err(), after.err()]),
    };
    if current.0.hashes == current.1.hashes {
        return ComparedLevel::default();
    }
    match (old.main_file(before), new.main_file(after)) {
        (Ok(before), Ok(after)) => {
            let before = LevelFile { path: &before, is_edited: current.0.is_edited };
            let after = LevelFile { path: &after, is_edited: current.1.is_edited };
            compare_paths(frame, before, after, options)
        }
        (before, after) => unreadable(frame, [before.err(), after.err()]),
    }
}

/// Two single files: nothing says whether they are as they were baked, so both are judged as they are now.
fn compare_files(old: &Path, new: &Path, options: &DiffOptions<'_>) -> ComparedLevel {
    let frame = LevelDiff {
        building: String::new(),
        level: String::new(),
        state: Presence::Changed,
        old_file: Some(shown(old)),
        new_file: Some(shown(new)),
        changes: Vec::new(),
        rooms: Vec::new(),
    };
    let is_same = read::is_same_content(old, new);
    let found = match is_same {
        Ok(true) => ComparedLevel::default(),
        Ok(false) => {
            let [old, new] = [old, new].map(|path| LevelFile { path, is_edited: true });
            compare_paths(frame, old, new, options)
        }
        Err(fault) => unreadable(frame, [Some(fault), None]),
    };
    (options.observer)(1, 1);
    found
}

fn unreadable(frame: LevelDiff, faults: [Option<Fault>; 2]) -> ComparedLevel {
    let diff = LevelDiff { state: Presence::Unreadable, ..frame };
    ComparedLevel { diff: Some(diff), faults: faults.into_iter().flatten().collect() }
}

/// A file to compare.
struct LevelFile<'a> {
    path: &'a Path,
    /// Whether it is not as its bake left it.
    is_edited: bool,
}

/// Reads both files and compares what they hold.
fn compare_paths(
    frame: LevelDiff,
    old: LevelFile<'_>,
    new: LevelFile<'_>,
    options: &DiffOptions<'_>,
) -> ComparedLevel {
    let (before, after) = match [old, new].map(|file| read::read(file.path, file.is_edited, options.catalog))
    {
        [Ok(before), Ok(after)] => (before, after),
        [before, after] => return unreadable(frame, [before.err(), after.err()]),
    };
    let differences = compare_levels(&before.inventory, &after.inventory, &options.tolerance);
    let diff = LevelDiff {
        building: after.inventory.building,
        level: after.inventory.level,
        changes: differences.changes,
        rooms: differences.rooms,
        ..frame
    };
    ComparedLevel { diff: Some(diff), faults: before.faults.into_iter().chain(after.faults).collect() }
}

/// A path as reports show it: with `/` on every system.
fn shown(path: &Path) -> String {
    path.display().to_string().replace('\\', "/")
}

#[cfg(test)]
mod tests;
