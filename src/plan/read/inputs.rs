//! Turns paths of the command line into input files: folders, patterns, kinds.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::nothing;
use super::reader::ForeignFormat;
use super::readers::FOREIGN_FORMATS;
use crate::disk::unpacked_name;
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

/// What paths mean, and what cannot be looked up of it.
type Found = (Vec<Input>, Faults);

/// Looks up what paths mean; sorted by path, each file once. A folder that cannot be listed does not hide the others.
pub(super) fn find_inputs(paths: &[PathBuf]) -> Found {
    let (mut inputs, mut faults) = Found::default();
    for path in paths {
        let (found, unfound) = find(path);
        inputs.extend(found);
        faults.merge(unfound);
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

fn find(path: &Path) -> Found {
    if path.is_dir() {
        let mut found = Found::default();
        walk(path, 0, &mut found);
        let (inputs, faults) = &mut found;
        if inputs.is_empty() && faults.is_empty() {
            faults.merge(nothing::of_path(path));
        }
        return found;
    }
    if path.symlink_metadata().is_err()
        && let Some(pattern) = path.to_str().filter(|path| path.contains(['*', '?', '[']))
    {
        return match_pattern(path, pattern);
    }
    (vec![Input { path: path.to_owned(), format: foreign(path), is_named: true }], Faults::default())
}

fn match_pattern(path: &Path, pattern: &str) -> Found {
    let fault = |reason: String| Fault::of_file(path, reason);
    let matches = match glob::glob(pattern) {
        Ok(matches) => matches,
        Err(error) => return (Vec::new(), fault(format!("is no pattern: {}", error.msg)).into()),
    };
    let mut found = Found::default();
    for matched in matches {
        match matched {
            Ok(folder) if folder.is_dir() => walk(&folder, 0, &mut found),
            Ok(file) => {
                let format = foreign(&file);
                found.0.push(Input { path: file, format, is_named: false });
            }
            Err(error) => found.1.push(fault(format!("cannot be looked up: {error}")).with_hint(RIGHTS)),
        }
    }
    if found.0.is_empty() && found.1.is_empty() {
        found.1.push(fault("no file matches".to_owned()));
    }
    found
}

fn foreign(path: &Path) -> Option<&'static ForeignFormat> {
    FOREIGN_FORMATS.iter().find(|format| (format.recognises)(path))
}

/// Advice where the system lists no folder.
const RIGHTS: &str = "check the path and the rights of the folder";

fn walk(folder: &Path, depth: usize, found: &mut Found) {
    if let Some(format) = foreign(folder) {
        found.0.push(Input { path: folder.to_owned(), format: Some(format), is_named: depth == 0 });
        return;
    }
    if depth > FOLDER_DEPTH {
        return;
    }
    let listed = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let mut entries = match listed {
        Ok(entries) => entries,
        Err(error) => {
            let fault = Fault::of_file(folder, format!("cannot be listed: {error}"));
            return found.1.push(fault.with_hint(RIGHTS));
        }
    };
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
            walk(&path, depth + 1, found);
        } else if path.is_file() && (has_native_extension(&path) || foreign(&path).is_some()) {
            let format = foreign(&path);
            found.0.push(Input { path, format, is_named: false });
        }
    }
}

fn has_native_extension(path: &Path) -> bool {
    let extension =
        unpacked_name(path).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
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

    #[cfg(unix)]
    #[test]
    fn a_folder_that_cannot_be_listed_does_not_hide_the_others() {
        use std::os::unix::fs::PermissionsExt;
        let folder = folder(&["b.yaml", "closed/a.yaml"]);
        let closed = folder.path().join("closed");
        let permit = |mode: u32| {
            std::fs::set_permissions(&closed, std::fs::Permissions::from_mode(mode)).unwrap();
        };
        permit(0o000);
        // Root lists everything.
        let is_closed = std::fs::read_dir(&closed).is_err();
        let (inputs, faults) = find_inputs(&[folder.path().to_owned()]);
        permit(0o700);
        if is_closed {
            assert_eq!(inputs.len(), 1);
            assert!(
                faults.0[0].message.starts_with("cannot be listed") && faults.0[0].hint.is_some(),
                "{faults}"
            );
        }
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
