//! Collects the faults of one file by document path.

use crate::document::{Fault, FaultSeverity, Faults, PathStep, Source, did_you_mean, first_of_each_kind};

/// Faults up to which a similar name is looked for, because each is compared with all names.
const HINTED: usize = 200;

/// The faults found so far, and where places are looked up.
pub(crate) struct Report<'a> {
    source: &'a Source,
    faults: Faults,
    is_useless: bool,
}

impl<'a> Report<'a> {
    /// Nothing found yet.
    pub(crate) fn new(source: &'a Source) -> Self {
        Self { source, faults: Faults::default(), is_useless: false }
    }

    /// The file.
    pub(crate) fn source(&self) -> &'a Source {
        self.source
    }

    /// Something that makes the file useless.
    pub(crate) fn error(&mut self, path: &[PathStep], message: impl Into<String>, hint: Option<String>) {
        self.lost(path, message, hint);
        self.is_useless = true;
    }

    /// An error that leaves the rest of the file as it is: what it is about was left out.
    pub(crate) fn lost(&mut self, path: &[PathStep], message: impl Into<String>, hint: Option<String>) {
        self.faults.push(self.source.fault(path, message, hint, FaultSeverity::Error));
    }

    /// Something to look at.
    pub(crate) fn warning(&mut self, path: &[PathStep], message: impl Into<String>, hint: Option<String>) {
        self.faults.push(self.source.fault(path, message, hint, FaultSeverity::Warning));
    }

    /// A hint for an unknown name, while there are few faults.
    pub(crate) fn did_you_mean<I>(&self, name: &str, candidates: I) -> Option<String>
    where
        I: IntoIterator + Clone,
        I::Item: AsRef<str>,
    {
        if self.faults.0.len() < HINTED { did_you_mean(name, candidates) } else { None }
    }

    /// Whether the file is of no use.
    pub(crate) fn is_useless(&self) -> bool {
        self.is_useless
    }

    /// Adds a fault as it is.
    pub(crate) fn push(&mut self, fault: Fault) {
        self.faults.push(fault);
    }

    /// The line in which a document path stands, from 1.
    pub(crate) fn line_of(&self, path: &[PathStep]) -> Option<usize> {
        let fault = self.source.fault(path, "", None, FaultSeverity::Error);
        fault.position.map(|(line, _)| line)
    }

    /// What was found, by place, equal faults once: a prototype's fault shows once however often it is placed. Of many faults of a
    /// kind the first are listed and the others counted.
    pub(crate) fn finish(mut self) -> Faults {
        self.faults.sort();
        first_of_each_kind(self.faults)
    }
}

/// A path one step further.
pub(crate) fn step(path: &[PathStep], next: impl Into<PathStep>) -> Vec<PathStep> {
    let mut path = path.to_vec();
    path.push(next.into());
    path
}

/// A path two steps further: an item of a list.
pub(crate) fn item(path: &[PathStep], list: &str, index: usize) -> Vec<PathStep> {
    step(&step(path, list), index)
}
