//! Joins the records of all runs into the manifest: the same bytes, however many processes wrote them.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::fault::{FaultCode, OutputFault};
use super::folder::OutputFolder;
use super::hash::file_hash;
use super::job::Shard;
use super::manifest::{MANIFEST_NAME, write_manifest};
use super::record::{FileRecord, LevelRecord, Totals};
use super::sources::{Contents, Found, Sources, manifest_paths};
use super::state::{
    JOINING_PREFIX, check_state, create_state, find_runs, lock_state, remove_runs, state_folder,
};
use crate::disk::{look_inside, new_temporary, open_inside};
use crate::document::{Fault, FaultSeverity, Faults};

/// What became of the records when a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Joined {
    /// The manifest is complete: its path.
    Whole(PathBuf),
    /// Other shards are missing; the records wait in this file.
    Part(PathBuf),
}

/// What a merge did.
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
    fs::read_dir(root).map_err(|error| OutputFault::of(root, "open the output folder", &error))?;
    check_state(root)?;
    let is_new = fs::symlink_metadata(state_folder(root)).is_err();
    if is_new && manifest_paths(root)?.is_empty() {
        return Err(nothing_to_join(root));
    }
    let state = create_state(root)?;
    let _lock = lock_state(&state)?;
    let runs = find_runs(&state, None)?;
    let manifests = manifest_paths(root)?;
    if manifests.is_empty() && runs.journals().is_empty() {
        return Err(nothing_to_join(root));
    }
    let sources = Sources::read(&manifests, &runs.journals())?;
    let mut contents = sources.contents(false)?;
    let manifest = root.join(MANIFEST_NAME);
    let totals = write_joined(root, &contents, &manifest)?;
    clear(&contents.parts, &runs.abandoned)?;
    // Nobody bakes their levels again now: they are missing.
    let as_error = |fault: Fault| Fault { severity: FaultSeverity::Error, ..fault };
    let faults = Faults(std::mem::take(&mut contents.faults).0.into_iter().map(as_error).collect());
    Ok(MergeReport { manifest, totals, living_runs: runs.living.len(), faults })
}

fn nothing_to_join(root: &Path) -> OutputFault {
    OutputFault {
        code: FaultCode::NothingToJoin,
        path: root.to_owned(),
        message: "holds no manifest, no part of one and no record of a bake".to_owned(),
        hint: Some("name the folder that `roomwright bake --out` wrote into".to_owned()),
    }
}

impl OutputFolder {
    /// Ends the run: moves its records into the manifest, or, for a shard while others are missing, into a
    /// part of it. `is_whole` says whether all levels of the plan are in place.
    ///
    /// # Errors
    /// If the manifest cannot be written; the records stay where the next run or merge finds them.
    pub(crate) fn finish(
        &self,
        shard: Option<Shard>,
        is_whole: impl FnOnce(&Contents<'_>) -> bool,
    ) -> Result<Joined, OutputFault> {
        let state = state_folder(&self.root);
        let _lock = lock_state(&state)?;
        let mut runs = find_runs(&state, Some(&self.run))?;
        let sources = Sources::read(&manifest_paths(&self.root)?, &runs.journals())?;
        let contents = sources.contents(self.is_forced)?;
        let joined = match shard {
            Some(shard) if !is_whole(&contents) => {
                let part = self.root.join(shard.part_name());
                let known = part.exists().then(|| part.clone());
                runs.living.retain(|run| *run == self.run);
                let own = Sources::read(known.as_slice(), &runs.journals())?;
                write_joined(&self.root, &own.contents(self.is_forced)?, &part)?;
                remove_runs(&runs.abandoned)?;
                Joined::Part(part)
            }
            _ => {
                let manifest = self.root.join(MANIFEST_NAME);
                if self.has_news() || !runs.abandoned.is_empty() || !sources.is_one_manifest() {
                    write_joined(&self.root, &contents, &manifest)?;
                    clear(&contents.parts, &runs.abandoned)?;
                }
                Joined::Whole(manifest)
            }
        };
        remove_runs(std::slice::from_ref(&self.run))?;
        Ok(joined)
    }
}

/// Writes the records to `target` in one step.
fn write_joined(root: &Path, contents: &Contents<'_>, target: &Path) -> Result<Totals, OutputFault> {
    let fault = |error: io::Error| OutputFault::of(target, "write the manifest", &error);
    let temporary = new_temporary(&state_folder(root), JOINING_PREFIX).map_err(fault)?;
    let records = contents.levels.values().filter_map(|found| choose(root, found).transpose());
    let mut out = BufWriter::new(temporary);
    let totals = write_manifest(&mut out, records, &contents.library).map_err(fault)?;
    out.flush().map_err(fault)?;
    let temporary = out.into_inner().map_err(|error| fault(error.into_error()))?;
    temporary.persist(target).map_err(|failed| fault(failed.error))?;
    Ok(totals)
}

/// The record of what lies on the disk: normally the newest. Where runs with different inputs wrote the
/// same level at the same time, the files say who came last. A level without its file is dropped.
fn choose(root: &Path, found: &[Found<'_>]) -> io::Result<Option<LevelRecord>> {
    let heads: Vec<_> = found.iter().map(Found::head).collect();
    let Some(newest) = heads.last() else { return Ok(None) };
    let agree = heads.iter().all(|head| head.files == newest.files);
    let index = if agree {
        heads.len() - 1
    } else {
        heads.iter().rposition(|head| is_in_place(root, &head.files)).unwrap_or(heads.len() - 1)
    };
    if !heads[index].files.iter().all(|file| is_there(root, file)) {
        return Ok(None);
    }
    let mut record: LevelRecord = serde_json::from_str(found[index].text.get())?;
    record.program = Some(found[index].program.clone());
    Ok(Some(record))
}

fn is_there(root: &Path, file: &FileRecord) -> bool {
    look_inside(root, &file.path).is_ok_and(|found| found.is_some())
}

/// Whether the files have exactly these contents. One of another length is not read.
pub(crate) fn is_in_place(root: &Path, files: &[FileRecord]) -> bool {
    let has_content = |file: &FileRecord| -> io::Result<bool> {
        let Some((opened, found)) = open_inside(root, &file.path)? else { return Ok(false) };
        Ok(found.len() == file.bytes && file_hash(opened)? == file.sha256)
    };
    files.iter().all(|file| has_content(file).unwrap_or(false))
}

/// Deletes the texts that the manifest now contains.
fn clear(parts: &[PathBuf], abandoned: &[PathBuf]) -> Result<(), OutputFault> {
    for part in parts {
        fs::remove_file(part).map_err(|error| OutputFault::of(part, "delete the joined part", &error))?;
    }
    remove_runs(abandoned)
}
