//! Rejected edits.

use std::collections::BTreeMap;
use std::fmt;

use crate::document::{Fault, Faults};

/// An edit that does not fit the room as it is arranged now. It stays in its file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// Place, fact and hint.
    pub fault: Fault,
    /// Whether the edit was applied all the same: the object stands at the edited place, and the audit has a finding.
    pub is_made: bool,
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.fault.fmt(f)
    }
}

impl Misfit {
    /// An edit that was rejected.
    pub(super) fn unmade(mark: &Fault, message: impl Into<String>, hint: &str) -> Self {
        let fault = Fault { message: message.into(), ..mark.clone() }.with_hint(hint);
        Self { fault, is_made: false }
    }

    /// An edit that was applied, and leads to a finding.
    pub(super) fn made(mark: &Fault, message: impl Into<String>, hint: &str) -> Self {
        let fault = Fault { message: message.into(), ..mark.clone() }.with_hint(hint).as_warning();
        Self { fault, is_made: true }
    }
}

/// The faults of rejected edits in their order, each once: one line of an edits file may be for the rooms of many buildings.
pub fn distinct_misfits<'m>(misfits: impl IntoIterator<Item = &'m Misfit>) -> Faults {
    let mut counts: Vec<(&Fault, usize)> = Vec::new();
    let mut places: BTreeMap<(String, bool), usize> = BTreeMap::new();
    for Misfit { fault, .. } in misfits {
        let place = *places.entry((fault.to_string(), fault.is_error())).or_insert(counts.len());
        match counts.get_mut(place) {
            Some((_, count)) => *count += 1,
            None => counts.push((fault, 1)),
        }
    }
    let told = counts.into_iter().map(|(fault, count)| match count {
        1 => fault.clone(),
        _ => Fault { message: format!("{} (in {count} rooms)", fault.message), ..fault.clone() },
    });
    Faults(told.collect())
}
