//! Files that the levels of a building share: each is written once, when the first level refers to it.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use super::fault::OutputFault;
use super::folder::OutputFolder;
use super::record::FileRecord;
use crate::output::SharedFile;

/// The shared files that are in place, by their path in the output folder.
#[derive(Debug, Default)]
pub(crate) struct SharedFiles {
    placed: Mutex<BTreeSet<String>>,
}

impl SharedFiles {
    /// Puts a file into place unless it is, and gives its path. What it holds depends on its path alone, so that processes and
    /// shards agree.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn put(&self, file: SharedFile<'_>, folder: &OutputFolder) -> Result<String, OutputFault> {
        let SharedFile { path, content } = file;
        // Held while writing, so that no level is recorded before its files are there.
        let mut placed = self.placed.lock().unwrap_or_else(PoisonError::into_inner);
        if placed.contains(&path) {
            return Ok(path);
        }
        let (file, bytes) = FileRecord::with_bytes(path.clone(), content());
        folder.announce(std::slice::from_ref(&file))?;
        folder.place(&file, &bytes)?;
        folder.record_library_file(&file)?;
        placed.insert(path.clone());
        Ok(path)
    }
}
