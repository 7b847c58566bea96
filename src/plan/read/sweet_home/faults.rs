//! Collects the faults of a home at their places in its text.

use crate::document::{Faults, Source};
use crate::plan::read::told::ToldFaults;

/// The faults so far.
pub(super) struct Notes {
    source: Source,
    /// The byte at which each line but the first begins.
    lines: Vec<usize>,
    faults: ToldFaults,
}

impl Notes {
    pub(super) fn new(source: Source) -> Self {
        let lines = memchr::memchr_iter(b'\n', source.text().as_bytes()).map(|at| at + 1).collect();
        Self { source, lines, faults: ToldFaults::default() }
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
        let Self { source, lines, faults } = self;
        faults.push(|| {
            let fault = source.fault_at(Some(position(source.text(), lines, place)), message).with_hint(hint);
            if is_warning { fault.as_warning() } else { fault }
        });
    }

    pub(super) fn finish(self) -> Faults {
        self.faults.finish(|message| self.source.fault_at(None, message))
    }
}

/// Line and column of a byte of a text, counted from 1; `lines` are the bytes at which each line but the first begins.
fn position(text: &str, lines: &[usize], place: usize) -> (usize, usize) {
    let mut place = place.min(text.len());
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    let line = lines.partition_point(|start| *start <= place);
    let start = if line == 0 { 0 } else { lines[line - 1] };
    (line + 1, text[start..place].chars().count() + 1)
}
