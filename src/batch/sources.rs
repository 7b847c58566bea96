//! Everything that an output folder says about its own content: the manifest, the parts of shards, and the
//! journals of runs that are under way or were killed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::value::RawValue;

use super::fault::{FaultCode, OutputFault};
use super::hash::PROGRAM;
use super::journal::{JournalText, journal_lines};
use super::manifest::{MANIFEST_NAME, is_part_name, parse_manifest};
use super::record::{FileRecord, LevelKey, Totals};

/// The texts, in a fixed order: manifest, parts by name, journals by name. Later ones are newer.
#[derive(Default)]
pub(crate) struct Sources {
    manifests: Vec<(PathBuf, Vec<u8>)>,
    journals: Vec<Vec<u8>>,
}

/// What the texts say, borrowed from them.
#[derive(Default)]
pub(crate) struct Contents<'a> {
    /// The records of each level, oldest first, each with the program that wrote it.
    pub(crate) levels: BTreeMap<LevelKey, Vec<Found<'a>>>,
    /// Every content that we wrote or were about to write, by path: SHA-256.
    pub(crate) written: BTreeMap<String, BTreeSet<String>>,
    /// Shared geometry by path.
    pub(crate) library: BTreeMap<String, FileRecord>,
}

/// A record as text.
pub(crate) struct Found<'a> {
    /// Who wrote it.
    pub(crate) program: String,
    /// A [`super::LevelRecord`].
    pub(crate) text: &'a RawValue,
}

/// The part of a record that decides whether a level is up to date.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct RecordHead {
    /// Building id.
    building: String,
    /// Level id.
    level: String,
    /// Who wrote it, if not the writer of the manifest.
    pub(crate) program: Option<String>,
    /// Hash of all that it was made from.
    pub(crate) inputs: String,
    /// Its files.
    pub(crate) files: Vec<FileRecord>,
    /// Shared geometry that it needs.
    #[serde(default)]
    pub(crate) library: Vec<String>,
    /// Its sums.
    pub(crate) totals: Totals,
}

impl Sources {
    /// Reads the texts.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub(crate) fn read(manifests: &[PathBuf], journals: &[PathBuf]) -> Result<Self, OutputFault> {
        let mut sources = Self::default();
        for path in manifests {
            sources.manifests.push((path.clone(), read(path)?));
        }
        for path in journals {
            sources.journals.push(read(path)?);
        }
        Ok(sources)
    }

    /// Whether there is a manifest and no part of one.
    pub(crate) fn is_one_manifest(&self) -> bool {
        matches!(self.manifests.as_slice(), [(path, _)] if path.ends_with(MANIFEST_NAME))
    }

    /// What the texts say.
    ///
    /// # Errors
    /// [`FaultCode::ForeignFile`] if a manifest is not of our making, unless `is_forced`: then it is passed over.
    pub(crate) fn contents(&self, is_forced: bool) -> Result<Contents<'_>, OutputFault> {
        let mut contents = Contents::default();
        for (path, text) in &self.manifests {
            match parse_manifest(text) {
                Ok(manifest) => {
                    let library = manifest.library.into_iter().map(|file| (file.path.clone(), file));
                    contents.library.extend(library);
                    for level in manifest.levels {
                        contents.add_level(level, &manifest.program);
                    }
                }
                Err(_) if is_forced => {}
                Err(reason) => return Err(no_manifest(path, &reason)),
            }
        }
        for text in &self.journals {
            contents.add_journal(text);
        }
        for file in contents.library.values() {
            contents.written.entry(file.path.clone()).or_default().insert(file.sha256.clone());
        }
        Ok(contents)
    }
}

impl<'a> Contents<'a> {
    fn add_journal(&mut self, text: &'a [u8]) {
        let mut program = PROGRAM.to_owned();
        for line in journal_lines(text) {
            match line {
                JournalText::Program(name) => program = name,
                JournalText::Writing(files) => self.add_files(&files),
                JournalText::Library(file) => {
                    self.library.insert(file.path.clone(), file);
                }
                JournalText::Level(level) => self.add_level(level, &program),
            }
        }
    }

    /// Adds a level; a record that cannot be read counts as absent, so that the level is baked again.
    fn add_level(&mut self, text: &'a RawValue, program: &str) {
        let Ok(head) = serde_json::from_str::<RecordHead>(text.get()) else { return };
        self.add_files(&head.files);
        let program = head.program.unwrap_or_else(|| program.to_owned());
        self.levels.entry((head.building, head.level)).or_default().push(Found { program, text });
    }

    fn add_files(&mut self, files: &[FileRecord]) {
        for file in files {
            self.written.entry(file.path.clone()).or_default().insert(file.sha256.clone());
        }
    }
}

impl Found<'_> {
    /// The deciding part of the record.
    pub(crate) fn head(&self) -> RecordHead {
        serde_json::from_str(self.text.get()).expect("it was read once already")
    }
}

/// The manifest, then the parts of shards by name.
pub(crate) fn manifest_paths(root: &Path) -> Result<Vec<PathBuf>, OutputFault> {
    let list = fs::read_dir(root).map_err(|error| OutputFault::of(root, "list the folder", &error))?;
    let mut parts: Vec<PathBuf> = list
        .filter_map(Result::ok)
        .filter(|entry| entry.file_name().to_str().is_some_and(is_part_name))
        .map(|entry| entry.path())
        .collect();
    parts.sort();
    let whole = root.join(MANIFEST_NAME);
    Ok(whole.exists().then_some(whole).into_iter().chain(parts).collect())
}

fn read(path: &Path) -> Result<Vec<u8>, OutputFault> {
    fs::read(path).map_err(|error| OutputFault::of(path, "read the records", &error))
}

fn no_manifest(path: &Path, reason: &str) -> OutputFault {
    OutputFault {
        code: FaultCode::ForeignFile,
        path: path.to_owned(),
        message: format!("is no manifest of roomwright: {reason}"),
        hint: Some("move it away, choose another --out, or replace it with --force".to_owned()),
    }
}
