//! Finds levels, buildings and shared files of earlier bakes that no plan needs any more. No command counts them. Only
//! `--prune` removes them, unless they were changed since.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use super::fault::OutputFault;
use super::in_place::is_in_place;
use super::record::{FileRecord, LevelKey};
use super::sources::{Contents, FoundRecord};
use crate::disk::look_inside;

/// The leftovers of earlier bakes, and their treatment. All lists are sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Leftovers {
    /// Building id and level id of levels whose files stay.
    pub levels: Vec<(String, String)>,
    /// Paths of shared files that stay although no level uses them.
    pub files: Vec<String>,
    /// Paths of files that were removed.
    pub removed: Vec<String>,
    /// Paths of files that were to be removed, but were changed since: they stay, and are listed no longer.
    pub changed: Vec<String>,
}

impl Leftovers {
    /// Whether everything stays as it was, also what is left to those who changed it.
    pub(super) fn is_nothing_removed(&self) -> bool {
        self.removed.is_empty() && self.changed.is_empty()
    }
}

/// Levels and files that the manifest lists apart.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Apart {
    pub(super) levels: BTreeSet<LevelKey>,
    pub(super) files: BTreeSet<FileRecord>,
}

impl Apart {
    /// The levels and files that the manifest lists apart.
    pub(super) fn as_listed(contents: &Contents<'_>) -> Self {
        Self { levels: contents.former.clone(), files: contents.former_files.iter().cloned().collect() }
    }

    /// The levels and files that the records list apart, without those that are planned again.
    pub(super) fn of_records(
        root: &Path,
        contents: &Contents<'_>,
        is_planned: impl Fn(&LevelKey) -> bool,
    ) -> Self {
        let levels =
            contents.former.iter().filter(|key| !is_planned(key) && is_any_there(root, contents, key));
        let levels: BTreeSet<LevelKey> = levels.cloned().collect();
        let used = used_paths(contents, |key| !levels.contains(key));
        let is_left = |file: &&FileRecord| !used.contains(file.path.as_str()) && is_unchanged(root, file);
        let files = contents.former_files.iter().filter(is_left).cloned().collect();
        Self { levels, files }
    }

    /// All that is neither planned nor in the new index nor written by a bake `beside` this one.
    pub(super) fn of_plan(
        root: &Path,
        contents: &Contents<'_>,
        index: &[FileRecord],
        beside: &Contents<'_>,
        is_planned: impl Fn(&LevelKey) -> bool,
    ) -> Self {
        let is_apart = |key: &LevelKey| !is_planned(key) && !beside.levels.contains_key(key);
        let levels = contents.levels.keys().filter(|key| is_apart(key) && is_any_there(root, contents, key));
        let levels: BTreeSet<LevelKey> = levels.cloned().collect();
        // Files of levels that are set apart are theirs; what they share with others is set apart by itself.
        let mut used = used_paths(contents, |key| !is_apart(key));
        used.extend(index.iter().map(|file| file.path.as_str()));
        used.extend(levels.iter().flat_map(|key| &contents.levels[key]).flat_map(own_paths));
        let is_left = |path: &&String| !used.contains(path.as_str()) && !beside.written.contains_key(*path);
        let left = contents.written.keys().filter(is_left);
        let known =
            left.flat_map(|path| contents.written[path].iter().map(move |content| content.of_file(path)));
        Self { levels, files: known.filter(|file| is_unchanged(root, file)).collect() }
    }

    /// Says what stays.
    pub(super) fn leftovers(&self) -> Leftovers {
        let paths: BTreeSet<&String> = self.files.iter().map(|file| &file.path).collect();
        Leftovers {
            levels: self.levels.iter().map(|key| (key.building.clone(), key.level.clone())).collect(),
            files: paths.into_iter().cloned().collect(),
            ..Leftovers::default()
        }
    }

    /// Removes all files of these levels and these files, where they hold what was recorded; then folders that became empty.
    ///
    /// # Errors
    /// If a file cannot be deleted.
    pub(super) fn remove(&self, root: &Path, contents: &Contents<'_>) -> Result<Leftovers, OutputFault> {
        let of_levels = self.levels.iter().flat_map(|key| &contents.levels[key]).flat_map(own_paths);
        let paths: BTreeSet<&str> =
            of_levels.chain(self.files.iter().map(|file| file.path.as_str())).collect();
        let mut leftovers = Leftovers::default();
        for path in paths {
            let known: Vec<FileRecord> = contents
                .written
                .get(path)
                .into_iter()
                .flatten()
                .map(|content| content.of_file(path))
                .collect();
            if !known.iter().any(|file| is_unchanged(root, file)) {
                let is_changed = look_inside(root, path).map_or(true, |found| found.is_some());
                leftovers.changed.extend(is_changed.then(|| path.to_owned()));
                continue;
            }
            let place = root.join(path);
            fs::remove_file(&place).map_err(|error| OutputFault::of(&place, "delete the file", &error))?;
            remove_empty_folders(root, &place);
            leftovers.removed.push(path.to_owned());
        }
        Ok(leftovers)
    }
}

/// Removes the folder of a file and those above it, as long as they are empty and below the root.
fn remove_empty_folders(root: &Path, file: &Path) {
    let above = file.ancestors().skip(1).take_while(|folder| *folder != root);
    for folder in above {
        if fs::remove_dir(folder).is_err() {
            return;
        }
    }
}

/// Paths that the levels of these keys use: their own and shared ones.
fn used_paths<'a>(contents: &'a Contents<'_>, is_used: impl Fn(&LevelKey) -> bool) -> BTreeSet<&'a str> {
    let used = contents.levels.iter().filter(|(key, _)| is_used(key)).flat_map(|(_, found)| found);
    used.flat_map(|found| own_paths(found).chain(found.head.library.iter().map(String::as_str))).collect()
}

fn own_paths<'a>(found: &'a FoundRecord<'_>) -> impl Iterator<Item = &'a str> {
    found.head.files.iter().map(|file| file.path.as_str())
}

fn is_any_there(root: &Path, contents: &Contents<'_>, key: &LevelKey) -> bool {
    let found = contents.levels.get(key).into_iter().flatten();
    found.flat_map(|found| &found.head.files).any(|file| is_there(root, file))
}

fn is_unchanged(root: &Path, file: &FileRecord) -> bool {
    is_in_place(root, std::slice::from_ref(file))
}

/// Whether a plain file lies at the place of a recorded one.
pub(super) fn is_there(root: &Path, file: &FileRecord) -> bool {
    look_inside(root, &file.path).is_ok_and(|found| found.is_some())
}
