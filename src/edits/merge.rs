//! Merges new edits into those that a file already has.

use super::file::{EditsFile, ObjectEntry, RoomEntry, VERSION};

/// A file with these edits. What is new wins, object by object and word by word: an object that was moved and is now
/// turned is both; one that was added and is gone was never there.
#[must_use]
pub fn merge(file: Option<EditsFile>, new: Vec<RoomEntry>) -> EditsFile {
    let mut file = file.unwrap_or(EditsFile { version: VERSION, edits: Vec::new() });
    for entry in new {
        let is_room = |known: &&mut RoomEntry| {
            (&known.building, &known.level, &known.room) == (&entry.building, &entry.level, &entry.room)
        };
        match file.edits.iter_mut().find(is_room) {
            Some(known) => merge_room(known, entry),
            None => file.edits.push(entry),
        }
    }
    file.edits.retain(|entry| entry.seed.is_some() || !entry.objects.is_empty());
    file
}

fn merge_room(known: &mut RoomEntry, new: RoomEntry) {
    known.seed = new.seed.or(known.seed);
    for (id, entry) in new.objects {
        let merged = match known.objects.remove(&id) {
            Some(before) if entry.remove && before.add => None,
            Some(_) if entry.remove => Some(entry),
            Some(before) if before.remove => Some(entry),
            Some(before) => Some(merge_object(before, entry)),
            None => Some(entry),
        };
        known.objects.extend(merged.map(|merged| (id, merged)));
    }
}

fn merge_object(before: ObjectEntry, new: ObjectEntry) -> ObjectEntry {
    ObjectEntry {
        add: before.add || new.add,
        remove: false,
        lock: before.lock || new.lock,
        class: new.class.or(before.class),
        variant: new.variant.or(before.variant),
        parent: new.parent.or(before.parent),
        side: new.side.or(before.side),
        at: new.at.or(before.at),
        turn: new.turn.or(before.turn),
    }
}
