//! All edits of a run, sorted by building, level and room.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;

use super::file::{ObjectEntry, RoomEntry};
use crate::contract::RoomId;
use crate::document::Fault;

/// The edits of all buildings.
#[derive(Clone, Debug, Default)]
pub struct EditBook {
    /// By building id, then level id.
    pub(super) buildings: BTreeMap<String, BTreeMap<String, Arc<LevelEdits>>>,
}

/// The edits of a level, by room id.
#[derive(Clone, Debug, Default)]
pub struct LevelEdits {
    pub(super) rooms: BTreeMap<String, RoomEdits>,
}

/// The edits of a room.
#[derive(Clone, Debug, Default)]
pub struct RoomEdits {
    /// Seed of the room's furniture in place of the run's.
    pub seed: Option<u64>,
    /// By id of the object.
    pub objects: BTreeMap<String, ObjectEdit>,
}

/// The edit of one object.
#[derive(Clone, Debug)]
pub struct ObjectEdit {
    /// The edit.
    pub entry: ObjectEntry,
    /// A fault at the edit's place in its file, without a message, for rejected edits.
    pub(super) mark: Fault,
}

impl EditBook {
    /// Whether nothing is edited.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.buildings.is_empty()
    }

    /// The edits of a level, if it has any.
    #[must_use]
    pub fn level(&self, building: &str, level: &str) -> Option<&LevelEdits> {
        Some(self.buildings.get(building)?.get(level)?)
    }

    /// The edits of a building, room by room, as a file writes them.
    #[must_use]
    pub fn entries(&self, building: &str) -> Vec<RoomEntry> {
        let levels = self.buildings.get(building).into_iter().flatten();
        let rooms = levels
            .flat_map(|(level, edits)| edits.rooms.iter().map(move |(room, edits)| (level, room, edits)));
        let entry = |(level, room, edits): (&String, &String, &RoomEdits)| RoomEntry {
            building: Some(building.to_owned()),
            level: level.clone(),
            room: room.clone(),
            seed: edits.seed,
            objects: edits.objects.iter().map(|(id, edit)| (id.clone(), edit.entry.clone())).collect(),
        };
        rooms.map(entry).collect()
    }

    /// A text that is equal for equal edits, wherever they are written.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let levels = self.buildings.iter().flat_map(|(id, levels)| {
            levels.iter().map(move |(level, edits)| format!("{id}/{level} {}\n", edits.fingerprint()))
        });
        levels.collect()
    }

    /// Gives a room another seed, as long as this book lives.
    pub fn pin(&mut self, id: &RoomId, seed: u64) {
        let levels = self.buildings.entry(id.building.clone()).or_default();
        let edits = Arc::make_mut(levels.entry(id.level.clone()).or_default());
        edits.rooms.entry(id.room.clone()).or_default().seed = Some(seed);
    }
}

impl RoomEdits {
    /// A text that is equal for equal edits, wherever they are written.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        as_text(&self.content())
    }

    /// What the edits say, without where they say it.
    fn content(&self) -> (Option<u64>, BTreeMap<&String, &ObjectEntry>) {
        (self.seed, self.objects.iter().map(|(id, edit)| (id, &edit.entry)).collect())
    }

    /// Ids of the objects of which the arrangement knows nothing.
    #[must_use]
    pub fn later_edits(&self) -> Vec<String> {
        let later = self.objects.iter().filter(|(_, edit)| !edit.entry.lock);
        later.map(|(id, _)| id.clone()).collect()
    }
}

impl LevelEdits {
    /// The edits of a room, if it has any.
    #[must_use]
    pub fn room(&self, room: &str) -> Option<&RoomEdits> {
        self.rooms.get(room)
    }

    /// A text that is equal for equal edits, wherever they are written: what a level is made from besides its plan.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let rooms = self.rooms.iter().map(|(id, room)| (id, room.content()));
        as_text(&rooms.collect::<BTreeMap<_, _>>())
    }
}

fn as_text(content: &impl Serialize) -> String {
    serde_json::to_string(content).expect("edits are texts and finite numbers")
}
