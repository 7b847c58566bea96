//! Collects the faults of a home at their places in its text.

use std::collections::BTreeMap;

use crate::document::{Faults, Source};
use crate::plan::read::foreign::unknown_words;

/// Faults that are reported one by one; a text of which each element is damaged would fill the screen.
const MOST_FAULTS: usize = 200;

/// The faults so far.
pub(super) struct Notes {
    source: Source,
    /// The byte at which each line but the first begins.
    lines: Vec<usize>,
    faults: Faults,
    /// How many more there are.
    untold: usize,
}

impl Notes {
    pub(super) fn new(source: Source) -> Self {
        let lines = memchr::memchr_iter(b'\n', source.text().as_bytes()).map(|at| at + 1).collect();
        Self { source, lines, faults: Faults::default(), untold: 0 }
    }

    pub(super) fn text(&self) -> &str {
        self.source.text()
    }

    /// A part that is left out.
    pub(super) fn error(&mut self, place: usize, message: impl Into<String>, hint: &str) {
        self.push(place, message.into(), hint, false);
    }

    /// A part that is read otherwise than it is drawn.
    pub(super) fn warn(&mut self, place: usize, message: impl Into<String>, hint: &str) {
        self.push(place, message.into(), hint, true);
    }

    fn push(&mut self, place: usize, message: String, hint: &str, is_warning: bool) {
        if self.faults.0.len() >= MOST_FAULTS {
            self.untold += 1;
            return;
        }
        let fault = self.source.fault_at(Some(self.position(place)), message).with_hint(hint);
        self.faults.push(if is_warning { fault.as_warning() } else { fault });
    }

    /// Line and column of a byte, counted from 1.
    fn position(&self, place: usize) -> (usize, usize) {
        let text = self.source.text();
        let mut place = place.min(text.len());
        while !text.is_char_boundary(place) {
            place -= 1;
        }
        let line = self.lines.partition_point(|start| *start <= place);
        let start = if line == 0 { 0 } else { self.lines[line - 1] };
        (line + 1, text[start..place].chars().count() + 1)
    }

    /// Warnings for words that the table of a format lacks.
    pub(super) fn unknown_words(&mut self, format: &str, unknown: &BTreeMap<String, (usize, usize)>) {
        for (place, message, hint) in unknown_words(format, unknown) {
            self.warn(*place, message, &hint);
        }
    }

    pub(super) fn finish(mut self) -> Faults {
        if self.untold > 0 {
            let message = format!("{} more faults of this file are not listed", self.untold);
            self.faults
                .push(self.source.fault_at(None, message).with_hint("mend the first ones").as_warning());
        }
        self.faults
    }
}
