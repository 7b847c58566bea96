//! The fault of a folder or pattern without plans: names the files found there, and the parts that a plan would need.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::foreign::missing_parts;
use super::readers::FOREIGN_FORMATS;
use super::unread::{read_are, recognise};
use crate::document::{Fault, Faults, Source};

/// Files of a folder that are looked at.
const MOST_FILES: usize = 1_000;
/// Names that a hint lists.
const MOST_NAMES: usize = 6;

/// Why a path gives no plan.
pub(super) fn of_path(path: &Path) -> Faults {
    if !path.is_dir() {
        return Fault::of_file(path, "no plan was found").with_hint("plans have a key `levels`").into();
    }
    let files = files(path);
    if files.is_empty() {
        return Fault::of_file(path, "the folder is empty").with_hint(read_are()).into();
    }
    let mut faults = Faults::default();
    for folder in folders(path, &files) {
        faults.merge(near_miss(&folder).map(Faults::from).unwrap_or_default());
    }
    if faults.is_empty() {
        let fault = Fault::of_file(path, "the folder holds no plan");
        faults.push(fault.with_hint(format!("it holds {}; {}", census(&files), read_are())));
    }
    faults
}

/// Why a text that was named gives no plan.
pub(super) fn of_text(source: &Source) -> Fault {
    let keys = source.top_keys();
    let shown: Vec<String> = keys.iter().take(MOST_NAMES).map(|key| format!("\"{key}\"")).collect();
    let message = match shown.is_empty() {
        true => "holds no plan, for it has no keys".to_owned(),
        false => format!("holds no plan: its keys are {}", shown.join(", ")),
    };
    let hint = format!("a native plan has the keys \"version\" and \"levels\"; {}", read_are());
    Fault::of_file(source.file(), message).with_hint(hint)
}

/// A folder that lacks a file to be one of a foreign format.
fn near_miss(folder: &Path) -> Option<Fault> {
    let (title, parts) = FOREIGN_FORMATS.iter().find_map(|format| (format.near_miss)(folder))?;
    let (message, hint) = missing_parts(folder, parts);
    Some(Fault::of_file(folder, format!("looks like {title}, but {message}")).with_hint(hint))
}

/// The files below a folder that are not hidden, sorted; links are not followed.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        let entries = std::fs::read_dir(&folder).into_iter().flatten().filter_map(Result::ok);
        for entry in entries.filter(|entry| !entry.file_name().to_string_lossy().starts_with('.')) {
            match entry.file_type() {
                Ok(kind) if kind.is_dir() => open.push(entry.path()),
                Ok(kind) if kind.is_file() && found.len() < MOST_FILES => found.push(entry.path()),
                _ => {}
            }
        }
        if found.len() >= MOST_FILES {
            break;
        }
    }
    found.sort();
    found
}

/// The folders that hold the files, sorted, each once.
fn folders(path: &Path, files: &[PathBuf]) -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> =
        files.iter().filter_map(|file| file.parent().map(Path::to_owned)).collect();
    folders.push(path.to_owned());
    folders.sort();
    folders.dedup();
    folders
}

/// The kinds of files in a folder: "2 × DXF drawing (a.dxf, ...)".
fn census(files: &[PathBuf]) -> String {
    let mut kinds: BTreeMap<String, Vec<&PathBuf>> = BTreeMap::new();
    for file in files {
        let extension = file.extension().map(|extension| format!(".{} file", extension.to_string_lossy()));
        let kind = recognise(file).map(|kind| kind.name.to_owned());
        let kind = kind.or(extension).unwrap_or_else(|| "file without an ending".to_owned());
        kinds.entry(kind).or_default().push(file);
    }
    let shown = |(kind, files): (&String, &Vec<&PathBuf>)| {
        let first = files[0].file_name().unwrap_or_default().to_string_lossy();
        match files.len() {
            1 => format!("{first} ({kind})"),
            count => format!("{first} and {} more ({kind})", count - 1),
        }
    };
    let mut names: Vec<String> = kinds.iter().take(MOST_NAMES).map(shown).collect();
    if kinds.len() > MOST_NAMES {
        names.push("others".to_owned());
    }
    names.join(", ")
}
