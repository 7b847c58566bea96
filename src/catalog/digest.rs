//! The hash of all configuration that was read.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::read::add_to_digest;
use super::report::Report;
use super::{Class, ModelSource};
use crate::disk::read_regular;
use crate::document::Fault;
use crate::model_file::{MODEL_BYTES_LIMIT, companion_files};

/// Adds the model files of all classes, sorted by class id, with the buffers and images that they refer to.
/// Only names and bytes count, not where the folders stand.
pub(super) fn finish_digest(mut hasher: Sha256, classes: &[Class], report: &mut Report<'_>) -> [u8; 32] {
    let mut files = Files { known: BTreeMap::new(), report };
    for class in classes {
        let ModelSource::File { path, .. } = &class.model else { continue };
        add_to_digest(&mut hasher, class.id.as_bytes());
        for companion in files.add(&mut hasher, path) {
            files.add(&mut hasher, &companion);
        }
    }
    hasher.finalize().into()
}

/// Files by path, each read once, however many classes and models name it, and none kept in memory.
struct Files<'a, 'b> {
    known: BTreeMap<PathBuf, Known>,
    report: &'a mut Report<'b>,
}

/// The record of a file.
struct Known {
    hash: [u8; 32],
    companions: Vec<PathBuf>,
}

impl Files<'_, '_> {
    /// Adds a file's name and hash, that of no bytes where it cannot be read, and gives the files that it refers to.
    fn add(&mut self, hasher: &mut Sha256, file: &Path) -> Vec<PathBuf> {
        let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        add_to_digest(hasher, name.as_bytes());
        if !self.known.contains_key(file) {
            let bytes = self.read(file);
            let known =
                Known { hash: Sha256::digest(&bytes).into(), companions: companion_files(file, &bytes) };
            self.known.insert(file.to_owned(), known);
        }
        let known = &self.known[file];
        hasher.update(known.hash);
        known.companions.clone()
    }

    fn read(&mut self, file: &Path) -> Vec<u8> {
        read_regular(file, MODEL_BYTES_LIMIT).unwrap_or_else(|error| {
            // A file that is not there at all is reported at its name.
            if file.exists() {
                self.report.error_of_all(Fault::of_file(file, format!("cannot be read: {error}")));
            }
            Vec::new()
        })
    }
}
