//! The hash of everything that was read.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::read::add_to_digest;
use super::report::Report;
use super::{Class, ModelSource};
use crate::document::Fault;

/// Adds the model files of all classes, sorted by class id, with the buffers and images that `.gltf`
/// files refer to. Only names and bytes count, not where the folders stand.
pub(super) fn finish_digest(mut hasher: Sha256, classes: &[Class], report: &mut Report<'_>) -> [u8; 32] {
    let mut seen = BTreeSet::new();
    for class in classes {
        let ModelSource::File { path, .. } = &class.model else { continue };
        add_to_digest(&mut hasher, class.id.as_bytes());
        for file in std::iter::once(path.clone()).chain(list_companions(path)) {
            let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            add_to_digest(&mut hasher, name.as_bytes());
            match std::fs::read(&file) {
                Ok(bytes) => add_to_digest(&mut hasher, &bytes),
                // A file that is not there at all is reported at its name.
                Err(error) if seen.insert(file.clone()) && file.exists() => {
                    report.error_of_all(Fault::of_file(&file, format!("cannot be read: {error}")));
                }
                Err(_) => add_to_digest(&mut hasher, b""),
            }
        }
    }
    hasher.finalize().into()
}

/// The files that a `.gltf` refers to by relative path, in its order.
fn list_companions(path: &Path) -> Vec<PathBuf> {
    let is_text = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gltf"));
    let text = if is_text { std::fs::read(path).unwrap_or_default() } else { Vec::new() };
    let document: serde_json::Value = serde_json::from_slice(&text).unwrap_or_default();
    let folder = path.parent().unwrap_or(Path::new(""));
    ["buffers", "images"]
        .iter()
        .filter_map(|key| document.get(key)?.as_array())
        .flatten()
        .filter_map(|entry| entry.get("uri")?.as_str())
        .filter(|uri| !uri.starts_with("data:"))
        .map(|uri| folder.join(uri))
        .collect()
}
