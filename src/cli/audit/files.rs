//! The files that the paths of a command line mean.

use std::fs;
use std::path::{Path, PathBuf};

use crate::document::{Fault, Faults};

/// Folders in folders down to this depth: what is deeper is a loop of links.
const DEEPEST: usize = 32;

/// The named files, and all levels below the named folders, sorted and each once.
///
/// # Errors
/// Paths that do not exist, and folders without a level.
pub(crate) fn level_files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Faults> {
    let (mut files, mut faults) = (Vec::new(), Faults::default());
    for path in paths {
        if !path.is_dir() {
            if path.exists() {
                files.push(path.clone());
            } else {
                faults.push(
                    Fault::of_file(path, "does not exist").with_hint("`roomwright bake` writes into out/"),
                );
            }
            continue;
        }
        let before = files.len();
        if let Err(error) = collect(path, DEEPEST, &mut files) {
            faults.push(Fault::of_file(path, format!("cannot be read: {error}")));
        } else if files.len() == before {
            faults.push(Fault::of_file(path, "holds no .glb or .gltf file"));
        }
    }
    files.sort();
    files.dedup();
    if faults.has_errors() { Err(faults) } else { Ok(files) }
}

fn collect(folder: &Path, depth: usize, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        // Hidden names are files on their way to their place.
        let is_hidden = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
        let is_level = path
            .extension()
            .is_some_and(|kind| ["glb", "gltf"].iter().any(|known| kind.eq_ignore_ascii_case(known)));
        if is_hidden {
            continue;
        }
        if path.is_dir() {
            if depth > 0 {
                collect(&path, depth - 1, files)?;
            }
        } else if is_level {
            files.push(path);
        }
    }
    Ok(())
}
