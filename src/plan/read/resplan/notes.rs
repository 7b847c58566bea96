//! Collects the faults of a file at their places in its text.

use crate::document::{FaultSeverity, Faults, PathStep, Source};

/// The format's word in `room_words.yaml`.
pub(super) const NAME: &str = "resplan";
/// Faults that are reported one by one.
const MOST_FAULTS: usize = 200;

/// A place in the document.
pub(super) type Place = Vec<PathStep>;

/// The faults so far.
pub(super) struct Notes {
    source: Source,
    faults: Faults,
    untold: usize,
}

impl Notes {
    pub(super) fn new(source: Source) -> Self {
        Self { source, faults: Faults::default(), untold: 0 }
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
        if self.faults.0.len() < MOST_FAULTS {
            self.faults.push(self.source.fault(place, message, Some(hint.to_owned()), severity));
        } else {
            self.untold += 1;
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

/// A place below another.
pub(super) fn below(place: &Place, step: impl Into<PathStep>) -> Place {
    let mut longer = place.clone();
    longer.push(step.into());
    longer
}
