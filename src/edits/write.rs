//! Writes edits as YAML, one line for each object.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_saphyr::{FlowMap, FlowSeq};

use super::file::{EditsFile, ObjectEntry, RoomEntry};
use crate::catalog::Side;

/// Writes a file. Rooms stand in the order of building, level and room; objects in that of their ids.
#[must_use]
pub fn write_edits(file: &EditsFile) -> String {
    let mut rooms: Vec<&RoomEntry> = file.edits.iter().collect();
    rooms.sort_by(|a, b| (&a.building, &a.level, &a.room).cmp(&(&b.building, &b.level, &b.room)));
    let written = Written { version: file.version, edits: rooms.into_iter().map(room).collect() };
    let options = serde_saphyr::ser_options! { prefer_block_scalars: false, compact_list_indent: true };
    // Texts and numbers alone cannot fail to be written.
    serde_saphyr::to_string_with_options(&written, options).expect("edits are texts and numbers")
}

#[derive(Serialize)]
struct Written<'a> {
    version: u32,
    edits: Vec<WrittenRoom<'a>>,
}

#[derive(Serialize)]
struct WrittenRoom<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    building: Option<&'a str>,
    level: &'a str,
    room: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    seed: Option<u64>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    objects: BTreeMap<&'a str, FlowMap<WrittenObject<'a>>>,
}

/// [`ObjectEntry`] with its place on one line.
#[derive(Serialize)]
struct WrittenObject<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    add: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    remove: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lock: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    class: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    variant: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parent: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    side: Option<Side>,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<FlowSeq<&'a [f64]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    turn: Option<f64>,
}

fn room(entry: &RoomEntry) -> WrittenRoom<'_> {
    let RoomEntry { building, level, room, seed, objects } = entry;
    WrittenRoom {
        building: building.as_deref(),
        level,
        room,
        seed: *seed,
        objects: objects.iter().map(|(id, entry)| (id.as_str(), FlowMap(object(entry)))).collect(),
    }
}

fn object(entry: &ObjectEntry) -> WrittenObject<'_> {
    let ObjectEntry { add, remove, lock, class, variant, parent, side, at, turn } = entry;
    WrittenObject {
        add: add.then_some(true),
        remove: remove.then_some(true),
        lock: lock.then_some(true),
        class: class.as_deref(),
        variant: *variant,
        parent: parent.as_deref(),
        side: *side,
        at: at.as_deref().map(FlowSeq),
        turn: *turn,
    }
}
