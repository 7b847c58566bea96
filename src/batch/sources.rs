//! Reads all records of an output folder: the manifest, the parts of shards, and the journals of runs that are running or
//! were killed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use serde_json::value::RawValue;

use super::claim::{FalseClaim, check_file, check_index, check_level, check_shared};
use super::fault::{FaultCode, OutputFault};
use super::in_place::is_in_place;
use super::journal::{JournalText, journal_lines};
use super::manifest::{LARGEST_RECORDS, MANIFEST_NAME, ManifestText, is_part_name, parse_manifest};
use super::program::PROGRAM;
use super::record::{FileRecord, LevelKey, LevelRecord, SiteRecord, Totals};
use crate::disk::read_plain;
use crate::document::{Fault, Faults, PathStep, Source};
use crate::output::IndexedLevel;
use crate::scene::LevelBounds;

/// The texts, in a fixed order: manifest, parts by name, journals by name. Later ones are newer.
#[derive(Default)]
pub(crate) struct Sources {
    manifests: Vec<(PathBuf, ManifestBytes)>,
    journals: Vec<(PathBuf, Vec<u8>)>,
}

/// The bytes of a manifest, or why something else of that name can be none.
type ManifestBytes = Result<Vec<u8>, String>;

/// The content of the texts, borrowed from them.
#[derive(Default)]
pub(crate) struct Contents<'a> {
    /// The records of each level, oldest first, each with the program that wrote it; never none.
    pub(crate) levels: BTreeMap<LevelKey, Vec<FoundRecord<'a>>>,
    /// Every content that this program wrote or was about to write, by path.
    pub(crate) written: Written,
    /// Shared geometry by path.
    pub(crate) library: BTreeMap<String, FileRecord>,
    /// Files over all levels.
    pub(crate) index: Vec<FileRecord>,
    /// Levels that no plan had when they were last listed.
    pub(crate) former: BTreeSet<LevelKey>,
    /// Shared files that no level used when they were last listed.
    pub(crate) former_files: Vec<FileRecord>,
    /// The parts of manifests that all this comes from.
    pub(crate) parts: Vec<PathBuf>,
    /// Records that were left out, because they claim what this program does not write.
    pub(crate) faults: Faults,
}

/// Contents by path.
pub(crate) type Written = BTreeMap<String, BTreeSet<Content>>;

/// The fingerprint of a file's content.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Content {
    /// Its length.
    pub(crate) bytes: u64,
    /// Its SHA-256.
    pub(crate) sha256: String,
}

/// A record as text.
pub(crate) struct FoundRecord<'a> {
    /// The run or shard that wrote it.
    pub(crate) program: String,
    /// Its deciding part.
    pub(crate) head: RecordHead,
    /// A [`super::record::LevelRecord`].
    pub(crate) text: &'a RawValue,
}

/// The part of a record that decides whether a level is up to date, and what an index says of it.
#[derive(Clone, Debug)]
pub(crate) struct RecordHead {
    /// Hash of all that it was made from.
    pub(crate) inputs: String,
    /// Its files.
    pub(crate) files: Vec<FileRecord>,
    /// Shared geometry that it needs.
    pub(crate) library: Vec<String>,
    /// Its sums.
    pub(crate) totals: Totals,
    /// Where its building stands.
    pub(crate) site: SiteRecord,
    /// The box around it.
    pub(crate) bounds: Option<LevelBounds>,
    /// The text by which the source of its plan asks to be named.
    pub(crate) attribution: Option<String>,
}

impl RecordHead {
    /// What an index says of a level.
    pub(crate) fn indexed(&self, key: &LevelKey) -> IndexedLevel {
        IndexedLevel {
            building: key.building.clone(),
            level: key.level.clone(),
            position: self.site.position,
            turn: self.site.turn,
            bounds: self.bounds,
            attribution: self.attribution.clone(),
            paths: self.files.iter().map(|file| file.path.clone()).collect(),
        }
    }
}

impl FoundRecord<'_> {
    /// The whole record, which names its program.
    ///
    /// # Errors
    /// None that reading it the first time had not.
    pub(crate) fn read(&self) -> io::Result<LevelRecord> {
        let record: LevelRecord = serde_json::from_str(self.text.get())?;
        Ok(LevelRecord { program: Some(self.program.clone()), ..record })
    }
}

impl Content {
    /// The record of a file with this content.
    pub(crate) fn of_file(&self, path: &str) -> FileRecord {
        FileRecord { path: path.to_owned(), sha256: self.sha256.clone(), bytes: self.bytes }
    }
}

impl Sources {
    /// Reads the texts.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub(crate) fn read(manifests: &[PathBuf], journals: &[PathBuf]) -> Result<Self, OutputFault> {
        let mut sources = Self::default();
        for path in manifests {
            sources.manifests.push((path.clone(), read_manifest(path)?));
        }
        for path in journals {
            let text = read_plain(path, LARGEST_RECORDS).map_err(|error| unread(path, &error))?;
            sources.journals.push((path.clone(), text));
        }
        Ok(sources)
    }

    /// Whether there is a manifest and no part of one.
    pub(crate) fn is_one_manifest(&self) -> bool {
        matches!(self.manifests.as_slice(), [(path, _)] if path.ends_with(MANIFEST_NAME))
    }

    /// The content of the texts.
    ///
    /// # Errors
    /// [`FaultCode::ForeignFile`] if a manifest is not of our making, unless `is_forced`: then it is passed over.
    pub(crate) fn contents(&self, is_forced: bool) -> Result<Contents<'_>, OutputFault> {
        let mut contents = Contents::default();
        for (path, text) in &self.manifests {
            let text = text.as_deref().map_err(Clone::clone);
            match text.and_then(|text| Ok((parse_manifest(text)?, text))) {
                Ok((manifest, text)) => contents.add_manifest(path, manifest, text),
                Err(_) if is_forced => {}
                Err(reason) => return Err(no_manifest(path, &reason)),
            }
        }
        for (path, text) in &self.journals {
            contents.add_journal(path, text);
        }
        let library: Vec<FileRecord> = contents.library.values().cloned().collect();
        contents.add_files(&library);
        Ok(contents)
    }
}

impl<'a> Contents<'a> {
    fn add_manifest(&mut self, path: &Path, manifest: ManifestText<'a>, text: &[u8]) {
        let mut claims: Vec<(Vec<PathStep>, FalseClaim)> = Vec::new();
        for (index, file) in manifest.library.into_iter().enumerate() {
            match check_shared(&file) {
                Ok(()) => drop(self.library.insert(file.path.clone(), file)),
                Err(claim) => claims.push((vec!["library".into(), index.into()], claim)),
            }
        }
        for (index, file) in manifest.index.into_iter().enumerate() {
            match check_index(&file) {
                Ok(()) => {
                    self.add_files(std::slice::from_ref(&file));
                    self.index.push(file);
                }
                Err(claim) => claims.push((vec!["index".into(), index.into()], claim)),
            }
        }
        for (index, file) in manifest.former_files.into_iter().enumerate() {
            match check_file(&file) {
                Ok(()) => self.add_former_file(file),
                Err(claim) => claims.push((vec!["former_files".into(), index.into()], claim)),
            }
        }
        let former = manifest.former_levels.into_iter().enumerate().map(|found| ("former_levels", found));
        let levels = manifest.levels.into_iter().enumerate().map(|found| ("levels", found));
        for (list, (index, level)) in former.chain(levels) {
            let added = self.add_level(level, &manifest.program);
            match added {
                Ok(key) if list == "former_levels" => drop(self.former.insert(key)),
                Ok(_) => {}
                Err(claim) => claims.push((vec![list.into(), index.into()], claim)),
            }
        }
        if path.file_name().and_then(|name| name.to_str()).is_some_and(is_part_name) {
            self.parts.push(path.to_owned());
        }
        if !claims.is_empty() {
            // Places are looked up only where there is something to say: it takes longer than to read the records.
            let source = Source::new(path, &String::from_utf8_lossy(text));
            self.faults.0.extend(claims.iter().map(|(before, claim)| claim.fault(&source, before)));
        }
    }

    fn add_journal(&mut self, path: &Path, text: &'a [u8]) {
        let mut program = PROGRAM.to_owned();
        for (number, line) in journal_lines(text) {
            let added = match line {
                JournalText::Program(name) => {
                    program = name;
                    Ok(())
                }
                JournalText::Writing(files) => {
                    files.iter().try_for_each(check_file).map(|()| self.add_files(&files))
                }
                JournalText::Library(file) => {
                    check_shared(&file).map(|()| drop(self.library.insert(file.path.clone(), file)))
                }
                JournalText::Level(level) => self.add_level(level, &program).map(drop),
            };
            if let Err(claim) = added {
                let fault = claim.fault(&Source::new(path, ""), &[]);
                self.faults.push(Fault { position: Some((number, 1)), ..fault });
            }
        }
    }

    /// Adds a level; one whose record is refused counts as absent, so that it is baked again.
    fn add_level(&mut self, text: &'a RawValue, program: &str) -> Result<LevelKey, FalseClaim> {
        // The whole record is read, not its head alone: later it must not turn out to be none.
        let record: LevelRecord =
            serde_json::from_str(text.get()).map_err(|error| FalseClaim::unreadable(&error))?;
        check_level(&record)?;
        self.add_files(&record.files);
        let key = record.key();
        self.former.remove(&key);
        let LevelRecord { inputs, files, library, totals, site, bounds, attribution, .. } = record;
        let head = RecordHead { inputs, files, library, totals, site, bounds, attribution };
        let program = record.program.unwrap_or_else(|| program.to_owned());
        self.levels.entry(key.clone()).or_default().push(FoundRecord { program, head, text });
        Ok(key)
    }

    fn add_former_file(&mut self, file: FileRecord) {
        self.add_files(std::slice::from_ref(&file));
        self.former_files.push(file);
    }

    /// The newest record of each level that is not set apart.
    pub(crate) fn current(&self) -> impl Iterator<Item = (&LevelKey, &FoundRecord<'a>)> {
        let current = self.levels.iter().filter(|(key, _)| !self.former.contains(key));
        current.filter_map(|(key, found)| Some((key, found.last()?)))
    }

    /// Leaves one record of each level: that of what lies on the disk.
    pub(crate) fn settle(&mut self, root: &Path) {
        for found in self.levels.values_mut() {
            let chosen = choose(root, found);
            found.swap(0, chosen);
            found.truncate(1);
        }
    }

    fn add_files(&mut self, files: &[FileRecord]) {
        for file in files {
            let content = Content { bytes: file.bytes, sha256: file.sha256.clone() };
            self.written.entry(file.path.clone()).or_default().insert(content);
        }
    }
}

/// The position of the record of what lies on the disk: normally the newest. Where runs with different inputs wrote the same
/// level at the same time, the files say who came last.
fn choose(root: &Path, found: &[FoundRecord<'_>]) -> usize {
    let newest = found.len().saturating_sub(1);
    if found.iter().all(|other| other.head.files == found[newest].head.files) {
        return newest;
    }
    found.iter().rposition(|found| is_in_place(root, &found.head.files)).unwrap_or(newest)
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
    // A link that leads nowhere is there too.
    let is_there = whole.symlink_metadata().is_ok();
    Ok(is_there.then_some(whole).into_iter().chain(parts).collect())
}

fn read_manifest(path: &Path) -> Result<ManifestBytes, OutputFault> {
    match read_plain(path, LARGEST_RECORDS) {
        Ok(text) => Ok(Ok(text)),
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::FileTooLarge) => {
            Ok(Err(error.to_string()))
        }
        Err(error) => Err(unread(path, &error)),
    }
}

fn unread(path: &Path, error: &io::Error) -> OutputFault {
    OutputFault::of(path, "read the records", error)
}

fn no_manifest(path: &Path, reason: &str) -> OutputFault {
    OutputFault {
        code: FaultCode::ForeignFile,
        path: path.to_owned(),
        message: format!("is no manifest of roomwright: {reason}"),
        hint: Some("move it away, choose another --out, or replace it with --force".to_owned()),
    }
}
