//! Turns paths of the command line into input files: folders, patterns, kinds.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::nothing;
use super::reader::ForeignFormat;
use super::readers::FOREIGN_FORMATS;
use crate::document::{Fault, Faults};

/// Deepest folder that is looked into.
const FOLDER_DEPTH: usize = 32;
/// Endings of native plans and projects.
const NATIVE_EXTENSIONS: [&str; 3] = ["yaml", "yml", "json"];

/// One input to read.
#[derive(Clone, Debug)]
pub(super) struct Input {
    /// The file or folder.
    pub(super) path: PathBuf,
    /// The foreign format, if it is of one.
    pub(super) format: Option<&'static ForeignFormat>,
    /// Whether the user named this very file. Others are passed over if they are no plans.
    pub(super) is_named: bool,
}

/// Looks up what paths mean; sorted by path, each file once.
pub(super) fn find_inputs(paths: &[PathBuf]) -> (Vec<Input>, Faults) {
    let (mut inputs, mut faults) = (Vec::new(), Faults::default());
    for path in paths {
        let found = find(path);
        if let Err(fault) = found.map(|found| inputs.extend(found)) {
            faults.merge(fault);
        }
    }
    // Named files first, so that dropping repetitions keeps the name.
    inputs.sort_by(|a, b| a.path.cmp(&b.path).then(b.is_named.cmp(&a.is_named)));
    let mut seen = BTreeSet::new();
    inputs.retain(|input| seen.insert(identity(&input.path)));
    (inputs, faults)
}

/// The same for all ways to write a path.
pub(super) fn identity(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

fn find(path: &Path) -> Result<Vec<Input>, Faults> {
    if path.is_dir() {
        let mut inputs = Vec::new();
        walk(path, 0, &mut inputs)?;
        if inputs.is_empty() {
            return Err(nothing::of_path(path));
        }
        return Ok(inputs);
    }
    if path.symlink_metadata().is_err()
        && let Some(pattern) = path.to_str().filter(|path| path.contains(['*', '?', '[']))
    {
        return match_pattern(path, pattern);
    }
    Ok(vec![Input { path: path.to_owned(), format: foreign(path), is_named: true }])
}

fn match_pattern(path: &Path, pattern: &str) -> Result<Vec<Input>, Faults> {
    let refuse = |reason: String| Faults::from(Fault::of_file(path, reason));
    let matches = glob::glob(pattern).map_err(|error| refuse(format!("is no pattern: {}", error.msg)))?;
    let mut inputs = Vec::new();
    for found in matches {
        let found = found.map_err(|error| refuse(format!("cannot be looked up: {error}")))?;
        if found.is_dir() {
            walk(&found, 0, &mut inputs)?;
        } else {
            let format = foreign(&found);
            inputs.push(Input { path: found, format, is_named: false });
        }
    }
    if inputs.is_empty() { Err(refuse("no file matches".to_owned())) } else { Ok(inputs) }
}

fn foreign(path: &Path) -> Option<&'static ForeignFormat> {
    FOREIGN_FORMATS.iter().find(|format| (format.recognises)(path))
}

fn walk(folder: &Path, depth: usize, inputs: &mut Vec<Input>) -> Result<(), Faults> {
    if let Some(format) = foreign(folder) {
        inputs.push(Input { path: folder.to_owned(), format: Some(format), is_named: depth == 0 });
        return Ok(());
    }
    if depth > FOLDER_DEPTH {
        return Ok(());
    }
    let unreadable =
        |error: std::io::Error| Faults::from(Fault::of_file(folder, format!("cannot be listed: {error}")));
    let entries = std::fs::read_dir(folder).map_err(unreadable)?;
    let mut entries = entries.collect::<Result<Vec<_>, _>>().map_err(unreadable)?;
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        // Links to folders are not followed: they may lead in circles.
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_hidden {
            continue;
        }
        if is_folder {
            walk(&path, depth + 1, inputs)?;
        } else if path.is_file() && (has_native_extension(&path) || foreign(&path).is_some()) {
            let format = foreign(&path);
            inputs.push(Input { path, format, is_named: false });
        }
    }
    Ok(())
}

fn has_native_extension(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    NATIVE_EXTENSIONS.iter().any(|known| extension.eq_ignore_ascii_case(known))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(files: &[&str]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for file in files {
            let path = folder.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "levels: []\n").unwrap();
        }
        folder
    }

    fn names(folder: &Path, paths: &[&str]) -> Vec<String> {
        let paths: Vec<PathBuf> = paths.iter().map(|path| folder.join(path)).collect();
        let (inputs, faults) = find_inputs(&paths);
        assert!(faults.is_empty(), "{faults}");
        let name = |input: &Input| input.path.strip_prefix(folder).unwrap().to_string_lossy().into_owned();
        inputs.iter().map(name).collect()
    }

    #[test]
    fn folders_are_searched_and_sorted() {
        let folder = folder(&["b.yaml", "a/z.json", "a/notes.txt", ".hidden.yaml", "c.yml"]);
        assert_eq!(names(folder.path(), &[""]), ["a/z.json", "b.yaml", "c.yml"]);
    }

    #[test]
    fn a_file_named_twice_is_read_once() {
        let folder = folder(&["b.yaml", "a/z.json"]);
        assert_eq!(names(folder.path(), &["b.yaml", "", "a/../b.yaml"]).len(), 2);
        assert_eq!(names(folder.path(), &["*.yaml"]), ["b.yaml"]);
        assert_eq!(names(folder.path(), &["**/*.json", "*"]), ["a/z.json", "b.yaml"]);
    }

    #[test]
    fn a_folder_without_plans_is_a_fault() {
        let folder = folder(&["notes.txt"]);
        for (path, message) in [("", "the folder holds no plan"), ("*.yaml", "no file matches")] {
            let (inputs, faults) = find_inputs(&[folder.path().join(path)]);
            assert!(inputs.is_empty());
            assert_eq!(faults.0[0].message, message);
        }
    }
}
