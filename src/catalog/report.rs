//! The place of a value in its file, and the faults found so far.

use std::collections::BTreeSet;

use crate::document::{Fault, FaultSeverity, Faults, PathStep, Source, did_you_mean};

/// A place in one of the files that were read.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Spot {
    /// Index of the file.
    pub(crate) source: usize,
    /// The path inside the document.
    pub(crate) path: Vec<PathStep>,
}

impl Spot {
    /// A definition: `classes.desk`.
    pub(crate) fn definition(source: usize, table: &str, id: &str) -> Self {
        Self { source, path: vec![table.into(), id.into()] }
    }

    /// The value of a key.
    pub(crate) fn key(&self, key: &str) -> Self {
        self.step(Some(key.into()))
    }

    /// An item of a list.
    pub(crate) fn index(&self, index: usize) -> Self {
        self.step(Some(index.into()))
    }

    /// An item of a list, or the value that stands alone instead of one.
    pub(crate) fn item(&self, index: Option<usize>) -> Self {
        self.step(index.map(PathStep::Index))
    }

    fn step(&self, step: Option<PathStep>) -> Self {
        Self { source: self.source, path: self.path.iter().cloned().chain(step).collect() }
    }
}

/// Names that faulty files may define; they are not reported as unknown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Promised {
    /// These names; none where all files are sound.
    Words(BTreeSet<String>),
    /// Any name: the text of a file could not be read, or is no YAML.
    Everything,
}

impl Promised {
    /// Adds what a file with faults may define.
    pub(crate) fn add(&mut self, words: Option<Vec<String>>) {
        match (self, words) {
            (Self::Words(known), Some(words)) => known.extend(words),
            (promised, _) => *promised = Self::Everything,
        }
    }

    fn has(&self, word: &str) -> bool {
        match self {
            Self::Words(words) => words.contains(word),
            Self::Everything => true,
        }
    }

    fn is_nothing(&self) -> bool {
        matches!(self, Self::Words(words) if words.is_empty())
    }
}

/// Collects the faults of all files.
pub(crate) struct Report<'a> {
    sources: &'a [Source],
    /// Everything found so far.
    pub(crate) faults: Faults,
    /// Names that faulty files may define.
    pub(crate) promised: Promised,
}

impl<'a> Report<'a> {
    /// Goes on from the faults of reading.
    pub(crate) fn new(sources: &'a [Source], faults: Faults, promised: Promised) -> Self {
        Self { sources, faults, promised }
    }

    /// Something is wrong.
    pub(crate) fn error(&mut self, spot: &Spot, message: impl Into<String>) {
        self.add(spot, message.into(), None, FaultSeverity::Error);
    }

    /// Something is wrong, and this helps.
    pub(crate) fn error_with_hint(&mut self, spot: &Spot, message: impl Into<String>, hint: &str) {
        self.add(spot, message.into(), Some(hint.to_owned()), FaultSeverity::Error);
    }

    /// Something is doubtful.
    pub(crate) fn warning(&mut self, spot: &Spot, message: impl Into<String>, hint: &str) {
        self.add(spot, message.into(), Some(hint.to_owned()), FaultSeverity::Warning);
    }

    /// A word that names nothing; `what` it should name.
    pub(crate) fn unknown<'c>(
        &mut self,
        spot: &Spot,
        what: &str,
        word: &str,
        candidates: impl IntoIterator<Item = &'c str> + Clone,
    ) {
        if !self.promised.has(word) {
            let hint = did_you_mean(word, candidates);
            self.add(spot, format!("unknown {what} \"{word}\""), hint, FaultSeverity::Error);
        }
    }

    /// Something is wrong with a definition as a whole; shown at its key.
    pub(crate) fn error_at_key(&mut self, spot: &Spot, message: impl Into<String>, hint: &str) {
        self.faults.push(self.sources[spot.source].fault_of_key(&spot.path, message, Some(hint.to_owned())));
    }

    /// Something is wrong with the configuration as a whole.
    pub(crate) fn error_of_all(&mut self, fault: Fault) {
        if self.promised.is_nothing() {
            self.faults.push(fault);
        }
    }

    /// The name of a file.
    pub(crate) fn file(&self, spot: &Spot) -> String {
        self.sources[spot.source].file().display().to_string()
    }

    fn add(&mut self, spot: &Spot, message: String, hint: Option<String>, severity: FaultSeverity) {
        self.faults.push(self.sources[spot.source].fault(&spot.path, message, hint, severity));
    }
}
