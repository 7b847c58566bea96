//! Tells whether a mapping names a key twice.

use std::collections::BTreeSet;

use super::node::Entry;

/// Up to this many keys are compared one by one, which takes less time than keeping a set of them.
const FEW_KEYS: usize = 16;

/// The keys of an object so far, where they are many.
#[derive(Debug, Default)]
pub(super) struct UniqueKeys(BTreeSet<String>);

impl UniqueKeys {
    /// Adds a key to those of the entries; whether it is new.
    pub(super) fn insert(&mut self, entries: &[Entry], key: &str) -> bool {
        if entries.len() < FEW_KEYS {
            return entries.iter().all(|entry| entry.key != key);
        }
        if entries.len() == FEW_KEYS {
            self.0.extend(entries.iter().map(|entry| entry.key.clone()));
        }
        self.0.insert(key.to_owned())
    }
}
