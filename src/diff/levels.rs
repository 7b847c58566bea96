//! Compares a level before and after.

use std::collections::BTreeSet;

use serde_json::Value;

use super::change::{Change, Worth};
use super::kind::Kind;
use super::openings::compare_openings;
use super::report::{Presence, RoomDiff};
use super::rooms::{compare_rooms, lone_room};
use super::tolerance::Tolerance;
use crate::read_back::{Described, Inventory};

/// Names of parts, models or materials that are listed; the others are counted.
const LISTED_NAMES: usize = 5;

/// The differences of two levels.
pub(super) struct Differences {
    /// Of the level as a whole.
    pub(super) changes: Vec<Change>,
    /// Room by room.
    pub(super) rooms: Vec<RoomDiff>,
}

/// Compares two levels; there is always an answer, if only that their bytes differ.
pub(super) fn compare_levels(old: &Inventory, new: &Inventory, tolerance: &Tolerance) -> Differences {
    let mut changes = place(old, new, tolerance);
    changes.extend(compare_openings(&old.openings, &new.openings, tolerance));
    let rooms = rooms(old, new, tolerance);
    changes.extend(looks(old, new));
    changes.extend(settings(old, new));
    if changes.is_empty() && rooms.is_empty() {
        changes.push(Change::of(Kind::Bytes, ""));
    }
    Differences { changes, rooms }
}

fn place(old: &Inventory, new: &Inventory, tolerance: &Tolerance) -> Vec<Change> {
    let mut changes = Vec::new();
    for (id, a, b) in [("elevation", old.elevation, new.elevation), ("height", old.height, new.height)] {
        if tolerance.is_far((a - b).abs()) {
            changes.push(Change::of(Kind::Levels, id).between(Worth::metres([a]), Worth::metres([b])));
        }
    }
    let names = |level: &Inventory| format!("{}/{}", level.building, level.level);
    if names(old) != names(new) {
        changes
            .push(Change::of(Kind::Levels, "id").between(Worth::Word(names(old)), Worth::Word(names(new))));
    }
    if old.site != new.site {
        let [old, new] = [old, new].map(|level| shown(&serde_json::json!(level.site)));
        changes.push(Change::of(Kind::Levels, "site").between(old, new));
    }
    changes
}

/// A value as the file has it; nothing where it says nothing.
fn shown(value: &Value) -> Worth {
    match value {
        Value::Null => Worth::word("none"),
        Value::String(text) => Worth::word(text),
        other => Worth::word(other),
    }
}

/// Rooms that both sides could read, by id.
fn rooms(old: &Inventory, new: &Inventory, tolerance: &Tolerance) -> Vec<RoomDiff> {
    let ids: BTreeSet<&String> = old.rooms.keys().chain(new.rooms.keys()).collect();
    let is_broken = |id: &&String| old.broken_rooms.contains(*id) || new.broken_rooms.contains(*id);
    let compare = |id: &String| match (old.rooms.get(id), new.rooms.get(id)) {
        (Some(before), Some(after)) => compare_rooms(id, before, after, tolerance),
        (Some(before), None) => Some(lone_room(id, before, Presence::Removed)),
        (None, Some(after)) => Some(lone_room(id, after, Presence::Added)),
        (None, None) => None,
    };
    ids.into_iter().filter(|id| !is_broken(id)).filter_map(compare).collect()
}

/// Parts, models, materials, textures and lights that both sides have and that are not the same. Which of them came or
/// went with a room, an opening or an object is reported there.
fn looks(old: &Inventory, new: &Inventory) -> Vec<Change> {
    let (a, b) = (&old.looks, &new.looks);
    let groups: [(Kind, &str, &Described, &Described); 5] = [
        (Kind::Shell, "", &a.shell, &b.shell),
        (Kind::Models, "", &a.models, &b.models),
        (Kind::Looks, "materials", &a.materials, &b.materials),
        (Kind::Looks, "textures", &a.textures, &b.textures),
        (Kind::Looks, "lights", &a.lights, &b.lights),
    ];
    let change = |(kind, id, before, after): (Kind, &str, &Described, &Described)| {
        let differing: Vec<&String> = before
            .iter()
            .filter(|(name, description)| after.get(*name).is_some_and(|other| other != *description))
            .map(|(name, _)| name)
            .collect();
        let names = differing.iter().take(LISTED_NAMES).map(|name| (*name).clone()).collect();
        (!differing.is_empty()).then(|| Change {
            new: Some(Worth::Words(names)),
            amount: Some(differing.len() as f64),
            ..Change::of(kind, id)
        })
    };
    groups.into_iter().filter_map(change).collect()
}

fn settings(old: &Inventory, new: &Inventory) -> Vec<Change> {
    let mut changes = Vec::new();
    for (name, before) in &old.settings {
        let after = new.settings.get(name).map_or("", String::as_str);
        if before != after {
            changes.push(Change::of(Kind::Settings, *name).between(Worth::word(before), Worth::word(after)));
        }
    }
    changes
}

#[cfg(test)]
mod tests {
    use crate::contract::SiteExtras;

    use super::{Inventory, Tolerance, compare_levels};
    use crate::read_back::RoomContents;

    fn level() -> Inventory {
        let mut level =
            Inventory { building: "house".to_owned(), level: "0".to_owned(), ..Inventory::default() };
        level.rooms.insert("a".to_owned(), RoomContents::default());
        level.settings.insert("generator", "1".into());
        level.looks.shell.insert("floor@a".to_owned(), "flat".to_owned());
        level.looks.models.insert("desk.0".to_owned(), "box".to_owned());
        level.looks.materials.insert("plain.wood".to_owned(), "brown".to_owned());
        level
    }

    /// Kinds and ids of the level's changes, then rooms with their states.
    fn shown(old: &Inventory, new: &Inventory) -> String {
        let found = compare_levels(old, new, &Tolerance::default());
        let changes = found.changes.iter().map(|change| format!("{} {}", change.kind.name(), change.id));
        let rooms = found.rooms.iter().map(|room| format!("{:?} {}", room.state, room.room));
        let words: Vec<String> = changes.chain(rooms).map(|text| text.trim().to_owned()).collect();
        words.join(", ")
    }

    type Change = fn(&mut Inventory);

    #[test]
    fn each_difference_of_a_level_has_its_kind() {
        let faults: [(&str, Change); 9] = [
            ("bytes", |_| ()),
            ("levels elevation", |level| level.elevation = 3.0),
            ("levels height", |level| level.height = 3.0),
            ("levels site", |level| level.site = Some(SiteExtras { position: [0.0; 2], turn: 1.0 })),
            ("levels id", |level| level.level = "1".to_owned()),
            ("shell", |level| drop(level.looks.shell.insert("floor@a".to_owned(), "tilted".to_owned()))),
            ("models", |level| drop(level.looks.models.insert("desk.0".to_owned(), "round".to_owned()))),
            ("looks materials", |level| {
                level.looks.materials.insert("plain.wood".to_owned(), "red".to_owned());
            }),
            ("settings generator", |level| drop(level.settings.insert("generator", "2".into()))),
        ];
        for (expected, fault) in faults {
            let mut new = level();
            fault(&mut new);
            assert_eq!(shown(&level(), &new), expected);
        }
    }

    #[test]
    fn rooms_are_added_and_removed_but_unreadable_ones_are_neither() {
        let mut new = level();
        new.rooms.insert("b".to_owned(), RoomContents::default());
        assert_eq!(shown(&level(), &new), "Added b");
        assert_eq!(shown(&new, &level()), "Removed b");
        let mut broken = level();
        broken.broken_rooms.insert("b".to_owned());
        assert_eq!(shown(&new, &broken), "bytes");
    }

    #[test]
    fn models_on_one_side_only_are_no_change() {
        let mut new = level();
        new.looks.models.insert("chair.0".to_owned(), "seat".to_owned());
        assert_eq!(shown(&level(), &new), "bytes");
    }
}
