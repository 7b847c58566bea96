//! Collects the faults of a table at their lines.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::columns::{Column, name};
use crate::document::{Fault, Faults};
use crate::plan::read::foreign::unknown_words;
use crate::plan::read::told::ToldFaults;

/// The faults so far.
pub(super) struct Notes {
    path: PathBuf,
    faults: ToldFaults,
    /// Word for a kind of element that is not known → the line of the first, and how many.
    unknown_kinds: BTreeMap<String, (usize, usize)>,
}

impl Notes {
    pub(super) fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), faults: ToldFaults::default(), unknown_kinds: BTreeMap::new() }
    }

    /// A row that is left out, for what stands in a column.
    pub(super) fn error(&mut self, line: usize, column: Column, message: &str, hint: &str) {
        let fault = || at(&self.path, line, message).with_hint(hint);
        self.faults.push(|| Fault { path: vec![name(column).into()], ..fault() });
    }

    /// A row that is left out as a whole.
    pub(super) fn error_of_row(&mut self, line: usize, message: &str, hint: &str) {
        self.faults.push(|| at(&self.path, line, message).with_hint(hint));
    }

    /// Something that is read otherwise than it is drawn.
    pub(super) fn warn(&mut self, line: usize, message: &str, hint: &str) {
        self.faults.push(|| at(&self.path, line, message).with_hint(hint).as_warning());
    }

    /// What ends the reading.
    pub(super) fn fatal(&mut self, fault: Fault) {
        self.faults.push_always(fault);
    }

    /// One more element of a kind that is not known.
    pub(super) fn unknown_kind(&mut self, line: usize, word: &str) {
        self.unknown_kinds.entry(word.to_owned()).or_insert((line, 0)).1 += 1;
    }

    /// Warnings for room words that the table of words lacks.
    pub(super) fn unknown_words(&mut self, format: &str, unknown: &BTreeMap<String, (usize, usize)>) {
        for (line, message, hint) in unknown_words(format, unknown) {
            self.warn(*line, &message, &hint);
        }
    }

    pub(super) fn finish(mut self) -> Faults {
        for (word, (line, count)) in std::mem::take(&mut self.unknown_kinds) {
            let message = format!("unknown kind of element \"{word}\", left out: {count} of them");
            self.warn(
                line,
                &message,
                "known are area, separator, opening and feature, with the data set's subtypes",
            );
        }
        self.faults.finish(|message| Fault::of_file(&self.path, message))
    }
}

fn at(path: &Path, line: usize, message: &str) -> Fault {
    Fault { position: Some((line, 1)), ..Fault::of_file(path, message) }
}
