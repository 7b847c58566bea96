//! One part of a manifest, as a file among others: its share, and its levels by their place in the text.

use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use serde_json::value::RawValue;
use sha2::{Digest, Sha256};

use super::claim::{FalseClaim, check_level, check_shared};
use super::fault::OutputFault;
use super::manifest::{LARGEST_RECORDS, is_part_name, parse_manifest, part_numbers};
use super::record::{FileRecord, LevelKey, LevelRecord, has_index};
use crate::disk::{open_regular, read_plain};

/// A part's file, by the share that its name says.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PartFile {
    /// Of how many shares.
    pub(super) count: u32,
    /// Which, from 1.
    pub(super) index: u32,
    /// The file.
    pub(super) path: PathBuf,
}

/// The content of a part.
pub(super) struct Part {
    /// The program that wrote it.
    pub(super) program: String,
    /// Its levels, or why one is none.
    pub(super) levels: Vec<Result<PartLevel, FalseClaim>>,
    /// Shared files, or why one is none.
    pub(super) library: Vec<Result<FileRecord, FalseClaim>>,
}

/// A level of a part.
pub(super) struct PartLevel {
    pub(super) key: LevelKey,
    /// Hash of all that it was made from.
    pub(super) inputs: String,
    /// The program that wrote it, where it is not that of the part.
    pub(super) program: Option<String>,
    /// SHA-256 of the record's text.
    pub(super) content: [u8; 32],
    pub(super) span: Span,
    /// Whether it needs files over all levels.
    pub(super) has_index: bool,
}

/// The place of a record in its file. A city's records do not fit into memory; their places do.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    start: u64,
    length: usize,
}

impl PartFile {
    /// The parts in a folder and in the folders in it, sorted.
    ///
    /// # Errors
    /// If a folder cannot be read.
    pub(super) fn all_in(folder: &Path) -> Result<Vec<Self>, OutputFault> {
        let (mut parts, mut folders) = (Vec::new(), Vec::new());
        for path in list(folder)? {
            if path.is_dir() {
                folders.push(path);
            } else {
                parts.extend(Self::named(path));
            }
        }
        for folder in folders {
            parts.extend(list(&folder)?.into_iter().filter_map(Self::named));
        }
        parts.sort();
        Ok(parts)
    }

    /// The part of a file with the name of one.
    pub(super) fn named(path: PathBuf) -> Option<Self> {
        let name = path.file_name()?.to_str().filter(|name| is_part_name(name))?;
        let (index, count) = part_numbers(name).filter(|(index, count)| (1..=*count).contains(index))?;
        Some(Self { count, index, path })
    }

    /// Reads the part; its text is not kept.
    ///
    /// # Errors
    /// If the file cannot be read, or is no manifest.
    pub(super) fn read(&self) -> Result<Part, String> {
        let text = read_plain(&self.path, LARGEST_RECORDS).map_err(|error| error.to_string())?;
        let found = parse_manifest(&text)?;
        let levels = found.levels.into_iter().map(|level| read_level(level, &text)).collect();
        let checked = |file: FileRecord| check_shared(&file).map(|()| file);
        let library = found.library.into_iter().map(checked).collect();
        Ok(Part { program: found.program, levels, library })
    }

    /// Reads one record again.
    ///
    /// # Errors
    /// If the file can no longer be read.
    pub(super) fn record_at(&self, span: Span) -> io::Result<LevelRecord> {
        let (mut file, _): (File, _) = open_regular(&self.path)?;
        file.seek(SeekFrom::Start(span.start))?;
        let mut text = vec![0; span.length];
        file.read_exact(&mut text)?;
        Ok(serde_json::from_slice(&text)?)
    }
}

fn list(folder: &Path) -> Result<Vec<PathBuf>, OutputFault> {
    let entries: io::Result<Vec<_>> = fs::read_dir(folder).and_then(Iterator::collect);
    let entries = entries.map_err(|error| OutputFault::of(folder, "list the folder", &error))?;
    Ok(entries.into_iter().map(|entry| entry.path()).collect())
}

fn read_level(level: &RawValue, text: &[u8]) -> Result<PartLevel, FalseClaim> {
    let own = level.get().as_bytes();
    let record: LevelRecord = serde_json::from_slice(own).map_err(|error| FalseClaim::unreadable(&error))?;
    check_level(&record)?;
    // The record is a slice of the text: the distance of both is its place.
    let start = own.as_ptr().addr() - text.as_ptr().addr();
    let span = Span { start: start as u64, length: own.len() };
    let content = Sha256::digest(own).into();
    let has_index = has_index(&record.files);
    Ok(PartLevel {
        key: record.key(),
        inputs: record.inputs,
        program: record.program,
        content,
        span,
        has_index,
    })
}
