//! Files that the floors of a building share: each is written once, when the first floor refers to it.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use super::fault::OutputFault;
use super::folder::OutputFolder;
use super::record::FileRecord;

/// The shared files that are in place, by their path in the output folder.
#[derive(Debug, Default)]
pub(crate) struct SharedFiles {
    placed: Mutex<BTreeSet<String>>,
}

impl SharedFiles {
    /// Puts a file into place unless it is. What it holds depends on its path alone, so that processes and shards agree.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn put(
        &self,
        path: &str,
        bytes: impl FnOnce() -> Vec<u8>,
        folder: &OutputFolder,
    ) -> Result<(), OutputFault> {
        // Held while writing, so that no level is recorded before its files are there.
        let mut placed = self.placed.lock().unwrap_or_else(PoisonError::into_inner);
        if placed.contains(path) {
            return Ok(());
        }
        let (file, bytes) = FileRecord::with_bytes(path.to_owned(), bytes());
        folder.announce(std::slice::from_ref(&file))?;
        folder.place(&file, &bytes)?;
        folder.record_library_file(&file)?;
        placed.insert(path.to_owned());
        Ok(())
    }
}
