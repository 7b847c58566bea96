//! The folder `.roomwright` in an output folder: a lock that is held briefly, and a folder for each run.
//!
//! Other programs may put files and links there. Only regular files are opened, no link is followed, and only files with
//! names of this program are removed.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use super::fault::{FaultCode, OutputFault};
use crate::disk::{Holder, holder, ignore_unsupported, new_temporary, remove_temporaries};

/// The corner, in the output folder.
const STATE_FOLDER: &str = ".roomwright";

/// How run folders begin.
const RUN_PREFIX: &str = "run-";

/// The file of the short lock.
const LOCK_NAME: &str = "lock";

/// The locked file in a run folder. Not the journal itself: on some systems a locked file cannot be read.
const ALIVE_NAME: &str = "alive";

/// The journal in a run folder.
pub(super) const JOURNAL_NAME: &str = "journal";

/// How results begin that are not yet in place.
pub(super) const RESULT_PREFIX: &str = "result-";

/// How manifests begin that are not yet in place.
pub(super) const JOINING_PREFIX: &str = "joining-";

/// Run folders, by whether their process lives.
#[derive(Debug, Default)]
pub(crate) struct Runs {
    pub(crate) living: Vec<PathBuf>,
    pub(crate) abandoned: Vec<PathBuf>,
}

impl Runs {
    /// The journals, those of abandoned runs first.
    pub(crate) fn journals(&self) -> Vec<PathBuf> {
        let journals = self.abandoned.iter().chain(&self.living).map(|run| run.join(JOURNAL_NAME));
        journals.filter(|path| is_plain_file(path)).collect()
    }
}

/// The corner of an output folder.
pub(crate) fn state_folder(root: &Path) -> PathBuf {
    root.join(STATE_FOLDER)
}

/// Looks, without writing anything, whether the corner is a folder or not there yet.
///
/// # Errors
/// [`FaultCode::WrongKind`] for links and files.
pub(crate) fn check_state(root: &Path) -> Result<(), OutputFault> {
    let state = state_folder(root);
    match fs::symlink_metadata(&state) {
        Ok(found) if !found.is_dir() => Err(OutputFault {
            code: FaultCode::WrongKind,
            path: state,
            message: "is a link or a file; bakes keep their own records in a folder of this name".to_owned(),
            hint: Some("remove it, or choose another folder with --out".to_owned()),
        }),
        _ => Ok(()),
    }
}

/// Creates the output folder and its corner, where they are missing.
///
/// # Errors
/// If they cannot be created; those of [`check_state`].
pub(crate) fn create_state(root: &Path) -> Result<PathBuf, OutputFault> {
    check_state(root)?;
    let state = state_folder(root);
    create_folder(&state)?;
    check_state(root)?;
    Ok(state)
}

/// Creates a folder and those above it.
pub(crate) fn create_folder(path: &Path) -> Result<(), OutputFault> {
    fs::create_dir_all(path).map_err(|error| OutputFault::of(path, "create the folder", &error))
}

/// Takes the short lock of an output folder; it ends when the file is dropped.
///
/// # Errors
/// If it cannot be locked, or something else has the name of its file.
pub(crate) fn lock_state(state: &Path) -> Result<File, OutputFault> {
    let path = state.join(LOCK_NAME);
    let fault = |error| OutputFault::of(&path, "lock the output folder", &error);
    // Opening a pipe to write would wait for a reader.
    if fs::symlink_metadata(&path).is_ok_and(|found| !found.is_file()) {
        return Err(fault(io::Error::new(io::ErrorKind::AlreadyExists, "it is no plain file")));
    }
    let file = File::options().create(true).truncate(false).write(true).open(&path).map_err(fault)?;
    ignore_unsupported(file.lock()).map_err(fault)?;
    Ok(file)
}

/// All run folders, by name; `own` is that of this process. Call with the short lock held.
///
/// # Errors
/// If the corner cannot be listed.
pub(crate) fn find_runs(state: &Path, own: Option<&Path>) -> Result<Runs, OutputFault> {
    let fault = |error| OutputFault::of(state, "list the folder", &error);
    let mut folders: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(state).map_err(fault)? {
        let entry = entry.map_err(fault)?;
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_folder && entry.file_name().to_string_lossy().starts_with(RUN_PREFIX) {
            folders.push(entry.path());
        }
    }
    // Joining needs the lock that this run holds: the run that began such a file was killed.
    remove_temporaries(state, JOINING_PREFIX);
    folders.sort();
    let mut runs = Runs::default();
    for folder in folders {
        let is_own = own.is_some_and(|own| own == folder);
        match is_own || is_alive(state, &folder) {
            true => runs.living.push(folder),
            // Folders without files of this program stay; an empty folder is a run killed at its first step.
            false if is_plain_file(&folder.join(JOURNAL_NAME)) || is_plain_file(&folder.join(ALIVE_NAME)) => {
                runs.abandoned.push(folder);
            }
            false => drop(fs::remove_dir(&folder)),
        }
    }
    Ok(runs)
}

/// Creates a run folder and takes the lock by which others see that it is in use.
///
/// # Errors
/// If they cannot be written.
pub(crate) fn start_run(state: &Path) -> io::Result<(PathBuf, File)> {
    let created = tempfile::Builder::new().prefix(RUN_PREFIX).tempdir_in(state)?.keep();
    // Named as `find_runs` names it, whether `state` is absolute or not.
    let run = state.join(created.file_name().expect("a new folder has a name"));
    let alive = File::options().create_new(true).write(true).open(run.join(ALIVE_NAME))?;
    ignore_unsupported(alive.lock())?;
    Ok((run, alive))
}

/// Deletes what a killed run had begun; what cannot be deleted now is deleted with the run folder later.
pub(crate) fn drop_temporary_files(run: &Path) {
    remove_temporaries(run, RESULT_PREFIX);
}

/// Deletes run folders with all of theirs; one that holds anything else stays, without a journal.
///
/// # Errors
/// If a file of theirs cannot be deleted.
pub(crate) fn remove_runs(runs: &[PathBuf]) -> Result<(), OutputFault> {
    for run in runs {
        drop_temporary_files(run);
        for path in
            [JOURNAL_NAME, ALIVE_NAME].map(|name| run.join(name)).iter().filter(|path| is_plain_file(path))
        {
            fs::remove_file(path).map_err(|error| OutputFault::of(path, "delete the ended run", &error))?;
        }
        // Not empty: it holds files of other origin.
        let _ = fs::remove_dir(run);
    }
    Ok(())
}

/// Whether the process of a run folder is at work.
fn is_alive(state: &Path, run: &Path) -> bool {
    let path = run.join(ALIVE_NAME);
    if !is_plain_file(&path) {
        return false;
    }
    match File::open(&path).map(|file| holder(&file)) {
        Ok(Holder::Living) => true,
        Ok(Holder::Gone) | Err(_) => false,
        Ok(Holder::Unknown) => was_written_lately(state, &run.join(JOURNAL_NAME)),
    }
}

/// Minutes without a line in its journal after which a run is given up where there are no locks; a level takes seconds.
const PATIENCE_MINUTES: u64 = 15;

/// Whether a file was written to shortly before now, by the clock of its file system, which need not be ours.
fn was_written_lately(state: &Path, path: &Path) -> bool {
    let now = new_temporary(state, JOINING_PREFIX).and_then(|probe| probe.as_file().metadata()?.modified());
    let written = fs::symlink_metadata(path).and_then(|found| found.modified());
    let (Ok(now), Ok(written)) = (now, written) else { return false };
    let patience = std::time::Duration::from_secs(PATIENCE_MINUTES * 60);
    now.duration_since(written).unwrap_or_else(|ahead| ahead.duration()) < patience
}

fn is_plain_file(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|found| found.is_file())
}
