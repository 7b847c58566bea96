//! The output folder: opened before the first second of work, shared with other processes without harm.
//!
//! ```text
//! out/manifest.json               every file, written whole at the end
//! out/manifest.2-of-4.json        what shard 2 did, until the last shard or `merge` joins the parts
//! out/<building>/<level>.glb      the results
//! out/.roomwright/lock            held for moments, while records are joined
//! out/.roomwright/run-…/alive     locked for as long as the run's process lives
//! out/.roomwright/run-…/journal   what it has done so far
//! out/.roomwright/run-…/…         its temporary files
//! ```
//!
//! A run folder whose `alive` nobody locks was left by a killed run: its records are taken over, and the
//! folder is deleted with the temporary files in it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::SystemTime;

use super::fault::{FaultCode, OutputFault};
use super::join::JOINING_PREFIX;
use super::journal::{Journal, JournalLine};
use super::lock::{ignore_unsupported, is_abandoned};
use super::record::{FileRecord, LevelKey, LevelRecord};
use super::sources::{Found, RecordHead, Sources, manifest_paths};

/// Our own corner of the output folder.
const STATE_FOLDER: &str = ".roomwright";

/// How run folders begin.
const RUN_PREFIX: &str = "run-";

/// The journal in a run folder.
const JOURNAL_NAME: &str = "journal";

/// The locked file in a run folder. Not the journal itself: some systems let nobody read a locked file.
const ALIVE_NAME: &str = "alive";

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

/// What the folder held when it was opened.
#[derive(Default)]
pub(crate) struct Known {
    /// The newest record of each level, with the program that wrote it.
    pub(crate) levels: BTreeMap<LevelKey, (String, RecordHead)>,
    /// Every content of ours by path: SHA-256.
    pub(crate) written: BTreeMap<String, BTreeSet<String>>,
    /// Shared geometry by path.
    pub(crate) library: BTreeMap<String, FileRecord>,
    /// When the oldest manifest was written: after the files that it lists.
    pub(crate) recorded: Option<SystemTime>,
}

/// Run folders, by whether their process lives.
pub(crate) struct Runs {
    pub(crate) living: Vec<PathBuf>,
    pub(crate) abandoned: Vec<PathBuf>,
}

impl OutputFolder {
    /// Looks, without writing anything, whether `root` can be an output folder.
    ///
    /// # Errors
    /// If it, or a folder above it, is a file.
    pub fn check(root: &Path) -> Result<(), OutputFault> {
        let nearest = root.ancestors().find_map(|path| fs::metadata(path).ok().map(|found| (path, found)));
        match nearest {
            Some((path, found)) if !found.is_dir() => Err(OutputFault {
                code: FaultCode::WrongKind,
                path: path.to_owned(),
                message: "is a file, not a folder".to_owned(),
                hint: Some("choose another folder with --out".to_owned()),
            }),
            _ => Ok(()),
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
        let state = root.join(STATE_FOLDER);
        create_folder(&state)?;
        let _lock = lock_state(&state)?;
        let runs = find_runs(&state)?;
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
        let written_at = |path: &PathBuf| fs::metadata(path).and_then(|found| found.modified()).ok();
        let recorded = manifests.iter().filter_map(written_at).min();
        let sources = Sources::read(&manifests, &runs.journals())?;
        let contents = sources.contents(is_forced)?;
        let newest = |(key, mut found): (LevelKey, Vec<Found<'_>>)| {
            let last = found.pop()?;
            let head = last.head();
            Some((key, (last.program, head)))
        };
        let levels = contents.levels.into_iter().filter_map(newest).collect();
        Ok(Self { levels, written: contents.written, library: contents.library, recorded })
    }
}

impl Runs {
    /// The journals, those of abandoned runs first.
    pub(crate) fn journals(&self) -> Vec<PathBuf> {
        let journals = self.abandoned.iter().chain(&self.living).map(|run| run.join(JOURNAL_NAME));
        journals.filter(|path| path.exists()).collect()
    }
}

/// Takes the short lock of an output folder; it ends when the file is dropped.
pub(crate) fn lock_state(state: &Path) -> Result<File, OutputFault> {
    let path = state.join("lock");
    let fault = |error| OutputFault::of(&path, "lock the output folder", &error);
    let file = File::options().create(true).truncate(false).write(true).open(&path).map_err(fault)?;
    ignore_unsupported(file.lock()).map_err(fault)?;
    Ok(file)
}

/// Our own corner of an output folder.
pub(crate) fn state_folder(root: &Path) -> PathBuf {
    root.join(STATE_FOLDER)
}

/// All run folders, by name. Call with the short lock held.
pub(crate) fn find_runs(state: &Path) -> Result<Runs, OutputFault> {
    let fault = |error| OutputFault::of(state, "list the folder", &error);
    let mut runs = Runs { living: Vec::new(), abandoned: Vec::new() };
    let mut folders: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(state).map_err(fault)? {
        let entry = entry.map_err(fault)?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with(RUN_PREFIX) {
            folders.push(entry.path());
        } else if name.starts_with(JOINING_PREFIX) {
            // Joining needs the lock that we hold: whoever began this file was killed.
            let _ = fs::remove_file(entry.path());
        }
    }
    folders.sort();
    for folder in folders {
        match File::open(folder.join(ALIVE_NAME)) {
            Ok(alive) if !is_abandoned(&alive) => runs.living.push(folder),
            _ => runs.abandoned.push(folder),
        }
    }
    Ok(runs)
}

/// Creates a run folder and takes the lock by which others see that it is in use.
fn start_run(state: &Path) -> io::Result<(PathBuf, File)> {
    let created = tempfile::Builder::new().prefix(RUN_PREFIX).tempdir_in(state)?.keep();
    // Named as `find_runs` names it, whether `state` is absolute or not.
    let run = state.join(created.file_name().expect("a new folder has a name"));
    let alive = File::options().create_new(true).write(true).open(run.join(ALIVE_NAME))?;
    ignore_unsupported(alive.lock())?;
    Ok((run, alive))
}

/// Creates a folder and those above it.
pub(crate) fn create_folder(path: &Path) -> Result<(), OutputFault> {
    fs::create_dir_all(path).map_err(|error| OutputFault::of(path, "create the folder", &error))
}

/// Deletes what a killed run had begun; what cannot be deleted now is deleted with the run folder later.
fn drop_temporary_files(run: &Path) {
    let is_temporary = |entry: &fs::DirEntry| entry.file_name() != JOURNAL_NAME;
    let files = fs::read_dir(run).into_iter().flatten().filter_map(io::Result::ok);
    for file in files.filter(is_temporary) {
        let _ = fs::remove_file(file.path());
    }
}
