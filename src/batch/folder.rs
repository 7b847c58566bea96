//! The output folder: opened before any work begins, and safely shared with other processes.
//!
//! ```text
//! out/manifest.json               every file, written whole at the end
//! out/manifest.2-of-4.json        the records of shard 2, until the last shard or `merge` joins the parts
//! out/<building>/<level>.glb      the results
//! out/.roomwright/lock            held for moments, while records are joined
//! out/.roomwright/run-…/alive     locked for as long as the run's process lives
//! out/.roomwright/run-…/journal   the levels that the run has written so far
//! out/.roomwright/run-…/…         its temporary files
//! ```
//!
//! A run folder whose `alive` is not locked was left by a killed run. The next run takes over its records, and deletes
//! the folder with the temporary files in it. On file systems without locks, the last line of the journal tells whether
//! the run ended.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::SystemTime;

use super::fault::{FaultCode, OutputFault};
use super::journal::{Journal, JournalLine};
use super::record::{FileRecord, LevelKey, LevelRecord};
use super::sources::{FoundRecord, RecordHead, Sources, Written, manifest_paths};
use super::state::{
    JOURNAL_NAME, Runs, check_state, create_state, drop_temporary_files, find_runs, lock_state, start_run,
};
use crate::document::Faults;

/// An output folder that this process writes into.
pub struct OutputFolder {
    pub(crate) root: PathBuf,
    pub(crate) run: PathBuf,
    pub(crate) is_forced: bool,
    journal: Journal,
    _alive: File,
    pub(crate) known: Known,
    has_news: AtomicBool,
}

/// The content of the folder when it was opened.
#[derive(Default)]
pub(crate) struct Known {
    /// The newest record of each level, with the program that wrote it.
    pub(crate) levels: BTreeMap<LevelKey, (String, RecordHead)>,
    /// Every content that this program wrote, by path.
    pub(crate) written: Written,
    /// Shared geometry by path.
    pub(crate) library: BTreeMap<String, FileRecord>,
    /// When the oldest manifest was written: after the files that it lists.
    pub(crate) recorded: Option<SystemTime>,
    /// Records that were left out.
    faults: Faults,
}

impl OutputFolder {
    /// Looks, without writing anything, whether `root` can be an output folder.
    ///
    /// # Errors
    /// If it, or a folder above it, is a file, or its corner for our own records is a link.
    pub fn check(root: &Path) -> Result<(), OutputFault> {
        let nearest = root.ancestors().find_map(|path| fs::metadata(path).ok().map(|found| (path, found)));
        match nearest {
            Some((path, found)) if !found.is_dir() => Err(OutputFault {
                code: FaultCode::WrongKind,
                path: path.to_owned(),
                message: "is a file, not a folder".to_owned(),
                hint: Some("choose another folder with --out".to_owned()),
            }),
            _ => check_state(root),
        }
    }

    /// Creates the folder if need be, takes over what killed runs left, and starts a journal.
    ///
    /// `is_forced` allows files of other origin to be overwritten.
    ///
    /// # Errors
    /// If the folder cannot be written or holds a manifest that is not ours.
    pub fn open(root: &Path, is_forced: bool) -> Result<Self, OutputFault> {
        Self::check(root)?;
        let state = create_state(root)?;
        let _lock = lock_state(&state)?;
        let runs = find_runs(&state, None)?;
        let known = Known::read(root, &runs, is_forced)?;
        for run in &runs.abandoned {
            drop_temporary_files(run);
        }
        let fault = |error| OutputFault::of(&state, "start a run", &error);
        let (run, alive) = start_run(&state).map_err(fault)?;
        let journal = Journal::create(&run.join(JOURNAL_NAME)).map_err(fault)?;
        let root = root.to_owned();
        Ok(Self { root, run, is_forced, journal, _alive: alive, known, has_news: AtomicBool::new(false) })
    }

    /// Where the folder is.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Records in the folder that were left out, because they name what no bake writes; their levels are baked again.
    #[must_use]
    pub fn faults(&self) -> &Faults {
        &self.known.faults
    }

    /// Says what is about to be written.
    pub(crate) fn announce(&self, files: &[FileRecord]) -> Result<(), OutputFault> {
        self.append(&JournalLine::Writing(files))
    }

    /// Records a level whose files are in place.
    pub(crate) fn record(&self, record: &LevelRecord) -> Result<(), OutputFault> {
        self.has_news.store(true, Ordering::Relaxed);
        self.append(&JournalLine::Level(record))
    }

    /// Whether this run recorded a level.
    pub(crate) fn has_news(&self) -> bool {
        self.has_news.load(Ordering::Relaxed)
    }

    /// Records a shared file that is in place.
    pub(crate) fn record_library_file(&self, file: &FileRecord) -> Result<(), OutputFault> {
        self.append(&JournalLine::Library(file))
    }

    fn append(&self, line: &JournalLine<'_>) -> Result<(), OutputFault> {
        let fault = |error| OutputFault::of(&self.run.join(JOURNAL_NAME), "write the journal", &error);
        self.journal.append(line).map_err(fault)
    }
}

impl Known {
    fn read(root: &Path, runs: &Runs, is_forced: bool) -> Result<Self, OutputFault> {
        let manifests = manifest_paths(root)?;
        let written_at = |path: &PathBuf| fs::symlink_metadata(path).and_then(|found| found.modified()).ok();
        let recorded = manifests.iter().filter_map(written_at).min();
        let sources = Sources::read(&manifests, &runs.journals())?;
        let contents = sources.contents(is_forced)?;
        let newest = |(key, mut found): (LevelKey, Vec<FoundRecord<'_>>)| {
            let last = found.pop()?;
            Some((key, (last.program, last.head)))
        };
        let levels = contents.levels.into_iter().filter_map(newest).collect();
        let (written, library, faults) = (contents.written, contents.library, contents.faults);
        Ok(Self { levels, written, library, recorded, faults })
    }
}
