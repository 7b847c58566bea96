//! Collects the faults of a file at their places in its text.

use crate::document::{FaultSeverity, Faults, PathStep, Source};
use crate::plan::read::told::ToldFaults;

/// The format's word in `room_words.yaml`.
pub(super) const NAME: &str = "resplan";

/// A place in the document.
pub(super) type Place = Vec<PathStep>;

/// The faults so far.
pub(super) struct Notes {
    source: Source,
    faults: ToldFaults,
}

impl Notes {
    pub(super) fn new(source: Source) -> Self {
        Self { source, faults: ToldFaults::default() }
    }

    /// A part that is left out.
    pub(super) fn error(&mut self, place: &Place, message: impl Into<String>, hint: &str) {
        self.push(place, message.into(), hint, FaultSeverity::Error);
    }

    /// A part that is read otherwise than it is written.
    pub(super) fn warn(&mut self, place: &Place, message: impl Into<String>, hint: &str) {
        self.push(place, message.into(), hint, FaultSeverity::Warning);
    }

    fn push(&mut self, place: &Place, message: String, hint: &str, severity: FaultSeverity) {
        self.faults.push(|| self.source.fault(place, message, Some(hint.to_owned()), severity));
    }

    pub(super) fn finish(self) -> Faults {
        self.faults.finish(|message| self.source.fault_at(None, message))
    }
}

/// A place below another.
pub(super) fn below(place: &Place, step: impl Into<PathStep>) -> Place {
    let mut longer = place.clone();
    longer.push(step.into());
    longer
}
