//! Pairs the levels of two manifests.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;

use super::report::Presence;
use crate::batch::FileRecord;

/// The parts of a level's record that a comparison needs.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
pub(super) struct Entry {
    /// Building id.
    pub(super) building: String,
    /// Level id.
    pub(super) level: String,
    /// The files, the one to open first.
    pub(super) files: Vec<FileRecord>,
    /// Sums over the rooms.
    #[serde(default)]
    pub(super) totals: EntryTotals,
}

/// The sums that are reported of a level on one side only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(default)]
pub(super) struct EntryTotals {
    pub(super) rooms: u64,
    pub(super) placed: u64,
    pub(super) failed: u64,
}

/// A level on one side or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pair<'a> {
    /// On the old side only.
    Old(&'a Entry),
    /// On the new side only.
    New(&'a Entry),
    /// On both.
    Both(&'a Entry, &'a Entry),
}

/// All levels of both sides, by building and level. Of a level that is listed twice, the last counts.
pub(super) fn pair_up<'a>(old: &'a [Entry], new: &'a [Entry]) -> Vec<Pair<'a>> {
    let mut sides: BTreeMap<(&str, &str), [Option<&Entry>; 2]> = BTreeMap::new();
    for (side, entries) in [old, new].into_iter().enumerate() {
        for entry in entries {
            sides.entry((&entry.building, &entry.level)).or_default()[side] = Some(entry);
        }
    }
    let pair = |sides: [Option<&'a Entry>; 2]| match sides {
        [Some(old), Some(new)] => Some(Pair::Both(old, new)),
        [Some(old), None] => Some(Pair::Old(old)),
        [None, Some(new)] => Some(Pair::New(new)),
        [None, None] => None,
    };
    sides.into_values().filter_map(pair).collect()
}

/// Buildings that are on one side only.
pub(super) fn lone_buildings(old: &[Entry], new: &[Entry]) -> BTreeMap<String, Presence> {
    let [old, new] =
        [old, new].map(|side| side.iter().map(|entry| entry.building.clone()).collect::<BTreeSet<String>>());
    let went = old.difference(&new).map(|id| (id.clone(), Presence::Removed));
    went.chain(new.difference(&old).map(|id| (id.clone(), Presence::Added))).collect()
}

/// Shared files that are on one side only or have another content.
pub(super) fn shared_files(old: &[FileRecord], new: &[FileRecord]) -> BTreeMap<String, Presence> {
    let [old, new] = [old, new].map(|side| {
        side.iter().map(|file| (file.path.as_str(), file.sha256.as_str())).collect::<BTreeMap<_, _>>()
    });
    let paths: BTreeSet<&str> = old.keys().chain(new.keys()).copied().collect();
    let state = |path: &str| match (old.get(path), new.get(path)) {
        (Some(before), Some(after)) if before == after => None,
        (Some(_), Some(_)) => Some(Presence::Changed),
        (Some(_), None) => Some(Presence::Removed),
        (None, _) => Some(Presence::Added),
    };
    paths.into_iter().filter_map(|path| Some((path.to_owned(), state(path)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(building: &str, level: &str) -> Entry {
        Entry {
            building: building.to_owned(),
            level: level.to_owned(),
            files: vec![file(&format!("{building}/{level}.glb"), level)],
            totals: EntryTotals::default(),
        }
    }

    fn file(path: &str, content: &str) -> FileRecord {
        FileRecord { path: path.to_owned(), sha256: content.to_owned(), bytes: 1 }
    }

    #[test]
    fn levels_are_paired_by_building_and_level() {
        let (old, new) = ([entry("a", "2"), entry("a", "1")], [entry("a", "2"), entry("b", "1")]);
        let pairs = pair_up(&old, &new);
        assert_eq!(pairs, [Pair::Old(&old[1]), Pair::Both(&old[0], &new[0]), Pair::New(&new[1])]);
        let buildings = lone_buildings(&old, &new);
        assert_eq!(buildings.into_iter().collect::<Vec<_>>(), [("b".to_owned(), Presence::Added)]);
    }

    #[test]
    fn shared_files_are_compared_by_content() {
        let old = [file("oak.png", "1"), file("red.png", "1"), file("tile.png", "1")];
        let new = [file("oak.png", "1"), file("tile.png", "2"), file("wool.png", "1")];
        let found: Vec<_> = shared_files(&old, &new).into_iter().collect();
        let expected =
            [("red.png", Presence::Removed), ("tile.png", Presence::Changed), ("wool.png", Presence::Added)];
        assert_eq!(found, expected.map(|(path, state)| (path.to_owned(), state)));
    }
}
