//! Faults of one file, of which so many are reported one by one: a file of which each element is damaged would fill the screen.

use crate::document::{Fault, FaultSeverity, Faults, PathStep, Source};

/// Faults that are reported one by one.
const MOST_FAULTS: usize = 200;

/// The faults of a file so far.
#[derive(Debug, Default)]
pub(super) struct ToldFaults {
    faults: Faults,
    /// How many more there are.
    untold: usize,
}

impl ToldFaults {
    /// One more fault; it is made only if it is reported.
    pub(super) fn push(&mut self, fault: impl FnOnce() -> Fault) {
        if self.faults.0.len() < MOST_FAULTS {
            self.faults.push(fault());
        } else {
            self.untold += 1;
        }
    }

    /// A fault that is reported whatever else is: it says of many parts, or of the whole file.
    pub(super) fn push_always(&mut self, fault: Fault) {
        self.faults.push(fault);
    }

    /// All that are reported, and how many more there are; `of_file` makes a fault of the whole file.
    pub(super) fn finish(mut self, of_file: impl FnOnce(String) -> Fault) -> Faults {
        if self.untold > 0 {
            let fault = of_file(format!("{} more faults of this file are not listed", self.untold));
            self.faults.push(fault.with_hint("mend the first ones").as_warning());
        }
        self.faults
    }
}

/// The faults of a JSON or YAML file so far, at the paths of its parts.
pub(super) struct DocumentFaults {
    source: Source,
    told: ToldFaults,
}

impl DocumentFaults {
    /// Of a file without faults so far.
    pub(super) fn new(source: Source) -> Self {
        Self { source, told: ToldFaults::default() }
    }

    /// A part that is left out.
    pub(super) fn error(&mut self, path: &[PathStep], message: impl Into<String>, hint: &str) {
        self.told.push(|| fault(&self.source, path, (message.into(), hint), FaultSeverity::Error));
    }

    /// A part that is read otherwise than it is written.
    pub(super) fn warn(&mut self, path: &[PathStep], message: impl Into<String>, hint: &str) {
        self.told.push(|| fault(&self.source, path, (message.into(), hint), FaultSeverity::Warning));
    }

    /// As [`Self::warn`], of many parts at once, here at the first of them: it is reported whatever else is.
    pub(super) fn warn_always(&mut self, path: &[PathStep], message: impl Into<String>, hint: &str) {
        self.told.push_always(fault(&self.source, path, (message.into(), hint), FaultSeverity::Warning));
    }

    /// All that are reported, and how many more there are.
    pub(super) fn finish(self) -> Faults {
        self.told.finish(|message| self.source.fault_at(None, message))
    }
}

fn fault(
    source: &Source,
    path: &[PathStep],
    (message, hint): (String, &str),
    severity: FaultSeverity,
) -> Fault {
    source.fault(path, message, (!hint.is_empty()).then(|| hint.to_owned()), severity)
}
