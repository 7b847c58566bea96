//! The hash of everything that was read.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::read::add_to_digest;
use super::report::Report;
use super::{Class, ModelSource};
use crate::document::Fault;
use crate::model::companion_files;

/// Adds the model files of all classes, sorted by class id, with the buffers and images that they refer to.
/// Only names and bytes count, not where the folders stand.
pub(super) fn finish_digest(mut hasher: Sha256, classes: &[Class], report: &mut Report<'_>) -> [u8; 32] {
    let mut unreadable = BTreeSet::new();
    for class in classes {
        let ModelSource::File { path, .. } = &class.model else { continue };
        add_to_digest(&mut hasher, class.id.as_bytes());
        let bytes = add_file(&mut hasher, path, &mut unreadable, report);
        for companion in companion_files(path, &bytes) {
            add_file(&mut hasher, &companion, &mut unreadable, report);
        }
    }
    hasher.finalize().into()
}

/// Adds a file's name and bytes; the bytes are none where it cannot be read.
fn add_file(
    hasher: &mut Sha256,
    file: &Path,
    unreadable: &mut BTreeSet<PathBuf>,
    report: &mut Report<'_>,
) -> Vec<u8> {
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    add_to_digest(hasher, name.as_bytes());
    let bytes = std::fs::read(file).unwrap_or_else(|error| {
        // A file that is not there at all is reported at its name.
        if file.exists() && unreadable.insert(file.to_owned()) {
            report.error_of_all(Fault::of_file(file, format!("cannot be read: {error}")));
        }
        Vec::new()
    });
    add_to_digest(hasher, &bytes);
    bytes
}
