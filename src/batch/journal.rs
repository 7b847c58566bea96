//! The journal of a running bake: one JSON line per event, appended, so that a killed run loses at most its last line.
//! When the run ends, the records move into the manifest.

use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;
use std::sync::Mutex;

use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use super::program::PROGRAM;
use super::record::{FileRecord, LevelRecord};

/// One line of a journal, as written.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum JournalLine<'a> {
    /// The first line: who writes.
    Program(&'a str),
    /// These files are about to get these contents. A run that is killed before the record follows
    /// knows its own work by it.
    Writing(&'a [FileRecord]),
    /// This file of the shared geometry is in place.
    Library(&'a FileRecord),
    /// The level is in place.
    Level(&'a LevelRecord),
}

/// One line of a journal, as read; levels stay text until they are needed.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum JournalText<'a> {
    /// [`JournalLine::Program`].
    Program(String),
    /// [`JournalLine::Writing`].
    Writing(Vec<FileRecord>),
    /// [`JournalLine::Library`].
    Library(FileRecord),
    /// [`JournalLine::Level`].
    Level(#[serde(borrow)] &'a RawValue),
}

/// A journal that is being written.
pub(crate) struct Journal {
    file: Mutex<File>,
}

impl Journal {
    /// Creates the file.
    ///
    /// # Errors
    /// If the file exists or cannot be written.
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        let file = OpenOptions::new().append(true).create_new(true).open(path)?;
        let journal = Self { file: Mutex::new(file) };
        journal.append(&JournalLine::Program(PROGRAM))?;
        Ok(journal)
    }

    /// Appends one line with one write.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn append(&self, line: &JournalLine<'_>) -> io::Result<()> {
        let mut text = serde_json::to_vec(line)?;
        text.push(b'\n');
        let mut file = self.file.lock().expect("no thread panics while it appends");
        file.write_all(&text)
    }
}

/// The lines of a journal with their numbers from 1, without any that was cut off.
pub(crate) fn journal_lines(text: &[u8]) -> impl Iterator<Item = (usize, JournalText<'_>)> + '_ {
    let lines = text.split(|&byte| byte == b'\n').enumerate();
    lines.filter_map(|(index, line)| Some((index + 1, serde_json::from_slice(line).ok()?)))
}

#[cfg(test)]
mod tests {
    use super::super::manifest::tests::record;
    use super::*;

    #[test]
    fn a_line_cut_off_by_a_kill_is_dropped() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal");
        let journal = Journal::create(&path).unwrap();
        journal.append(&JournalLine::Writing(&record("a", "1").files)).unwrap();
        journal.append(&JournalLine::Level(&record("a", "1"))).unwrap();
        let text = std::fs::read(&path).unwrap();
        assert_eq!(journal_lines(&text).count(), 3);
        for cut in 1..30 {
            assert_eq!(journal_lines(&text[..text.len() - 1 - cut]).count(), 2);
        }
    }
}
