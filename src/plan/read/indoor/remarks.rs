//! What a reader has to say about parts of a map, each with its place in the file.

use crate::document::{Fault, Faults};

/// Remarks of one file that are reported one by one.
const MOST: usize = 200;

/// Warnings of a map, in the order in which they were found.
#[derive(Debug, Default)]
pub(super) struct Remarks {
    told: Vec<Remark>,
    /// Those beyond the limit.
    untold: usize,
}

/// A warning about a part of a map.
#[derive(Debug, PartialEq)]
pub(super) struct Remark {
    /// Where the part is in the file, in the file's own measure.
    pub(super) place: u64,
    pub(super) message: String,
    pub(super) hint: String,
}

impl Remarks {
    /// Notes that a part is left out.
    pub(super) fn leave_out(&mut self, place: u64, message: String) {
        self.note(place, message, "it was left out");
    }

    /// Notes a fact.
    pub(super) fn note(&mut self, place: u64, message: String, hint: &str) {
        if self.told.len() < MOST {
            self.told.push(Remark { place, message, hint: hint.to_owned() });
        } else {
            self.untold += 1;
        }
    }

    /// All as warnings of the file; `fault` makes one at a place.
    pub(super) fn into_faults(self, fault: &dyn Fn(u64, &str) -> Fault) -> Faults {
        let mut faults = Faults::default();
        for Remark { place, message, hint } in self.told {
            faults.push(fault(place, &message).with_hint(hint).as_warning());
        }
        if self.untold > 0 {
            let message = format!("{} more parts of the map have such faults", self.untold);
            faults.push(fault(0, &message).as_warning());
        }
        faults
    }
}
