//! Joins the records of all runs into the manifest, with the same bytes for any number of processes.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::fault::{FaultCode, OutputFault};
use super::folder::OutputFolder;
use super::manifest::{Listed, MANIFEST_NAME, without_own_program, write_manifest};
use super::options::Shard;
use super::options::Unplanned;
use super::part_file::PartFile;
use super::parts::missing_parts;
use super::record::{FileRecord, LevelKey, LevelRecord, Totals, has_index};
use super::sources::{Contents, FoundRecord, Sources, manifest_paths};
use super::state::{
    JOINING_PREFIX, Runs, check_state, create_state, find_runs, lock_state, remove_runs, state_folder,
};
use super::unplanned::{Apart, Leftovers, is_there};
use crate::disk::new_temporary;
use crate::document::{Fault, FaultSeverity, Faults};
use crate::output::{INDEX_NAME, IndexFiles, IndexedLevel};

/// The state of the records after a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Joined {
    /// The manifest is complete: its path.
    Whole(PathBuf),
    /// Other shards are missing; the records wait in this file.
    Part(PathBuf),
}

/// The report of a merge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MergeReport {
    /// The manifest.
    pub manifest: PathBuf,
    /// Sums over its levels.
    pub totals: Totals,
    /// Runs that are still writing into the folder; their records so far are included.
    pub living_runs: usize,
    /// Records that were left out, because they name what no bake writes.
    pub faults: Faults,
}

/// Joins the records of an output folder into its manifest.
///
/// # Errors
/// If there is no such folder, no bake has written into it, it cannot be written, or it holds a manifest that is not ours.
pub fn merge(root: &Path) -> Result<MergeReport, OutputFault> {
    fs::read_dir(root).map_err(|error| OutputFault {
        hint: Some("name the folder that `roomwright bake --out` wrote into".to_owned()),
        ..OutputFault::of(root, "open the output folder", &error)
    })?;
    check_state(root)?;
    let is_new = fs::symlink_metadata(state_folder(root)).is_err();
    if is_new && manifest_paths(root)?.is_empty() {
        return Err(nothing_to_join(root));
    }
    let state = create_state(root)?;
    let _lock = lock_state(&state)?;
    let runs = find_runs(&state, None)?;
    let manifests = manifest_paths(root)?;
    // Looked up once: those of abandoned runs go as soon as they are joined.
    let journals = runs.journals();
    if manifests.is_empty() && journals.is_empty() {
        return Err(nothing_to_join(root));
    }
    let sources = Sources::read(&manifests, &journals)?;
    let mut contents = sources.contents(false)?;
    contents.settle(root);
    let manifest = root.join(MANIFEST_NAME);
    let apart = Apart::of_records(root, &contents, |_| false);
    let missing = missing_levels(root, &contents);
    let current = contents.levels.len() - contents.former.len();
    if current > 0 && missing.0.len() == current {
        return Err(nothing_in_place(root, &contents));
    }
    let totals = write_joined(root, &contents, &apart, &manifest)?;
    // The files may still come; without the parts nobody would know of them.
    let parts: &[PathBuf] = if missing.is_empty() { &contents.parts } else { &[] };
    clear(parts, &runs.abandoned)?;
    // Nobody bakes their levels again now: they are missing.
    let as_error = |fault: Fault| Fault { severity: FaultSeverity::Error, ..fault };
    let mut faults = Faults(std::mem::take(&mut contents.faults).0.into_iter().map(as_error).collect());
    faults.merge(missing);
    // The records of another run may be those of a missing share.
    if journals.is_empty() {
        faults.0.extend(missing_shares(root, &manifests));
    }
    faults.0.extend(missing_index(&manifest, &contents));
    Ok(MergeReport { manifest, totals, living_runs: runs.living.len(), faults })
}

/// A fault if nothing but some parts of a division were there: nobody knows the levels of the others.
fn missing_shares(root: &Path, manifests: &[PathBuf]) -> Vec<Fault> {
    let mut parts: Vec<PartFile> = manifests.iter().cloned().filter_map(PartFile::named).collect();
    parts.sort();
    let are_all_there_is = !parts.is_empty() && parts.len() == manifests.len();
    if are_all_there_is { missing_parts(root, &parts) } else { Vec::new() }
}

/// The first missing file of each level that was to be in place.
fn missing_levels(root: &Path, contents: &Contents<'_>) -> Faults {
    let missing = contents.current().filter_map(|(LevelKey { building, level }, found)| {
        let file = found.head.files.iter().find(|file| !is_there(root, file))?;
        let message = format!("is not there: level {level:?} of building {building:?} is left out");
        Some(Fault::of_file(&root.join(&file.path), message).with_hint(ELSEWHERE))
    });
    Faults(missing.collect())
}

/// A fault if the files over all levels are missing, which a bake makes once all shares have ended.
fn missing_index(manifest: &Path, contents: &Contents<'_>) -> Option<Fault> {
    let is_missing =
        contents.index.is_empty() && contents.current().any(|(_, found)| has_index(&found.head.files));
    is_missing.then(|| {
        let message = format!("lists levels for a {INDEX_NAME}, and there is none");
        let hint = "give the command that wrote the levels once more, without --shard: it keeps them and writes the file";
        Fault::of_file(manifest, message).with_hint(hint)
    })
}

/// Advice where files that records name are not there.
const ELSEWHERE: &str = "copy the file to its place and merge again; if the files lie elsewhere, join their records with `roomwright merge --records`";

/// The fault of a folder that has nothing but records.
fn nothing_in_place(root: &Path, contents: &Contents<'_>) -> OutputFault {
    let files = contents.current().filter_map(|(_, found)| found.head.files.first());
    let listed: Vec<&str> = files.map(|file| file.path.as_str()).take(LISTED_FILES).collect();
    OutputFault {
        code: FaultCode::NothingToJoin,
        path: root.to_owned(),
        message: format!("holds no file of the levels in its records, such as {}", listed.join(", ")),
        hint: Some(ELSEWHERE.to_owned()),
    }
}

/// The most missing files that one message lists.
const LISTED_FILES: usize = 3;

fn nothing_to_join(root: &Path) -> OutputFault {
    OutputFault {
        code: FaultCode::NothingToJoin,
        path: root.to_owned(),
        message: "holds no manifest, no part of one and no record of a bake".to_owned(),
        hint: Some("name the folder that `roomwright bake --out` wrote into".to_owned()),
    }
}

/// The levels that were to be baked, as the end of a run needs them.
pub(crate) struct Planned<'a> {
    /// The levels of all shares.
    pub(crate) levels: BTreeSet<LevelKey>,
    /// The share of this run.
    pub(crate) shard: Option<Shard>,
    /// The treatment of other levels.
    pub(crate) unplanned: Unplanned,
    /// The files over all levels, given those that are in place.
    pub(crate) index: &'a dyn Fn(&[IndexedLevel]) -> IndexFiles,
    /// Whether all levels of the plan are in place.
    pub(crate) is_whole: &'a dyn Fn(&Contents<'_>) -> bool,
}

impl OutputFolder {
    /// Ends the run: moves its records into the manifest, or, for a shard while others are missing, into a
    /// part of it.
    ///
    /// # Errors
    /// If the manifest cannot be written; the records stay where the next run or merge finds them.
    pub(crate) fn finish(&self, planned: &Planned<'_>) -> Result<(Joined, Leftovers), OutputFault> {
        let state = state_folder(&self.root);
        let lock = lock_state(&state)?;
        let mut runs = find_runs(&state, Some(&self.run))?;
        let sources = Sources::read(&manifest_paths(&self.root)?, &runs.journals())?;
        let mut contents = sources.contents(self.is_forced)?;
        contents.settle(&self.root);
        let finished = match planned.shard {
            Some(shard) if !(planned.is_whole)(&contents) => {
                let part = self.root.join(shard.part_name());
                let known = part.exists().then(|| part.clone());
                runs.living.retain(|run| *run == self.run);
                let own = Sources::read(known.as_slice(), &runs.journals())?;
                let mut own = own.contents(self.is_forced)?;
                own.settle(&self.root);
                write_joined(&self.root, &own, &Apart::default(), &part)?;
                remove_runs(&runs.abandoned)?;
                (Joined::Part(part), Leftovers::default())
            }
            _ => {
                let manifest = self.root.join(MANIFEST_NAME);
                let index = self.write_index(planned, &contents, &lock)?;
                let mut apart = self.set_apart(planned, &contents, &index, &runs)?;
                let mut leftovers = apart.leftovers();
                if planned.unplanned == Unplanned::Removed {
                    leftovers = apart.remove(&self.root, &contents)?;
                    let removed = std::mem::take(&mut apart).levels;
                    contents.levels.retain(|key, _| !removed.contains(key));
                }
                let is_new = self.has_news()
                    || index != contents.index
                    || !runs.abandoned.is_empty()
                    || !sources.is_one_manifest();
                contents.index = index;
                if is_new || !leftovers.is_nothing_removed() || apart != Apart::as_listed(&contents) {
                    write_joined(&self.root, &contents, &apart, &manifest)?;
                    clear(&contents.parts, &runs.abandoned)?;
                }
                (Joined::Whole(manifest), leftovers)
            }
        };
        remove_runs(std::slice::from_ref(&self.run))?;
        Ok(finished)
    }

    /// Puts the files over all levels into place; none while a part of the plan is not known.
    fn write_index(
        &self,
        planned: &Planned<'_>,
        contents: &Contents<'_>,
        lock: &File,
    ) -> Result<Vec<FileRecord>, OutputFault> {
        let is_current =
            |key: &LevelKey| planned.unplanned == Unplanned::Listed || planned.levels.contains(key);
        let levels = contents.levels.iter().filter(|(key, _)| is_current(key));
        let levels: Vec<IndexedLevel> =
            levels.filter_map(|(key, found)| Some(found.last()?.head.indexed(key))).collect();
        let files = (planned.index)(&levels);
        let files: Vec<(FileRecord, Vec<u8>)> =
            files.into_iter().map(|(path, bytes)| FileRecord::with_bytes(path, bytes)).collect();
        let records: Vec<FileRecord> = files.iter().map(|(file, _)| file.clone()).collect();
        if records != contents.index || !records.iter().all(|file| is_there(&self.root, file)) {
            self.announce(&records)?;
            self.place_all(&files, lock)?;
        }
        Ok(records)
    }

    /// The levels in the folder that neither this run nor any run beside it was to bake.
    fn set_apart(
        &self,
        planned: &Planned<'_>,
        contents: &Contents<'_>,
        index: &[FileRecord],
        runs: &Runs,
    ) -> Result<Apart, OutputFault> {
        let is_planned = |key: &LevelKey| planned.levels.contains(key);
        if planned.unplanned == Unplanned::Listed {
            return Ok(Apart::of_records(&self.root, contents, is_planned));
        }
        let living = runs.living.iter().filter(|run| **run != self.run).cloned().collect();
        let beside = Runs { living, abandoned: Vec::new() };
        let beside = Sources::read(&[], &beside.journals())?;
        Ok(Apart::of_plan(&self.root, contents, index, &beside.contents(false)?, is_planned))
    }
}

/// Writes the records to `target` in one step. Levels and files that are set apart are listed apart, as far as they are there.
fn write_joined(
    root: &Path,
    contents: &Contents<'_>,
    apart: &Apart,
    target: &Path,
) -> Result<Totals, OutputFault> {
    let fault = |error: io::Error| OutputFault::of(target, "write the manifest", &error);
    let temporary = new_temporary(&state_folder(root), JOINING_PREFIX).map_err(fault)?;
    let (former, current): (Vec<_>, Vec<_>) =
        contents.levels.iter().partition(|(key, _)| apart.levels.contains(*key));
    let read = |found: &[FoundRecord<'_>]| found.iter().map(FoundRecord::read).next_back();
    let former: io::Result<Vec<LevelRecord>> =
        former.into_iter().filter_map(|(_, found)| read(found)).collect();
    let former_levels = former.map_err(fault)?.into_iter().map(without_own_program).collect();
    let listed = Listed {
        library: &contents.library,
        index: &contents.index,
        former_levels,
        former_files: apart.files.iter().collect(),
    };
    let is_whole = |found: &&FoundRecord<'_>| found.head.files.iter().all(|file| is_there(root, file));
    let in_place = current.into_iter().filter_map(|(_, found)| found.last()).filter(is_whole);
    let mut out = BufWriter::new(temporary);
    let totals = write_manifest(&mut out, in_place.map(FoundRecord::read), &listed).map_err(fault)?;
    out.flush().map_err(fault)?;
    let temporary = out.into_inner().map_err(|error| fault(error.into_error()))?;
    temporary.persist(target).map_err(|failed| fault(failed.error))?;
    Ok(totals)
}

/// Deletes the texts that the manifest now contains.
fn clear(parts: &[PathBuf], abandoned: &[PathBuf]) -> Result<(), OutputFault> {
    for part in parts {
        fs::remove_file(part).map_err(|error| OutputFault::of(part, "delete the joined part", &error))?;
    }
    remove_runs(abandoned)
}
