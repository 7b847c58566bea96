//! Sets the edit of one object, or the seed of one room, in an edits file.

use serde_json::{Map, Value};

use super::file::{EditsFile, ObjectEntry, RoomEntry, VERSION};
use crate::contract::RoomId;

/// A file in which keys of the edit of an object are set; without keys, the object is as it is arranged again.
///
/// # Errors
/// If a key is none of an edit, or its value has the wrong type.
pub fn set_object(
    file: Option<EditsFile>,
    room: &RoomId,
    object: &str,
    keys: Option<&Map<String, Value>>,
) -> Result<EditsFile, String> {
    let (mut file, index) = entry_of(file, room);
    let objects = &mut file.edits[index].objects;
    let before = objects.remove(object);
    if let Some(keys) = keys {
        let known =
            serde_json::to_value(before.clone().unwrap_or_default()).map_err(|error| error.to_string())?;
        let Value::Object(mut merged) = known else { return Err("an edit is an object".to_owned()) };
        merged.extend(keys.clone());
        let entry: ObjectEntry =
            serde_json::from_value(Value::Object(merged)).map_err(|error| error.to_string())?;
        // What goes has no place and no lock.
        let entry = if entry.remove { ObjectEntry { remove: true, ..ObjectEntry::default() } } else { entry };
        // What was added and is gone was never there.
        let is_undone = entry.remove && before.is_some_and(|before| before.add);
        if !is_undone && entry != ObjectEntry::default() {
            objects.insert(object.to_owned(), entry);
        }
    }
    Ok(without_empty(file))
}

/// A file in which the seed of a room is set.
#[must_use]
pub fn set_seed(file: Option<EditsFile>, room: &RoomId, seed: Option<u64>) -> EditsFile {
    let (mut file, index) = entry_of(file, room);
    file.edits[index].seed = seed;
    without_empty(file)
}

/// The file with an entry for a room of one building, and where that is.
fn entry_of(file: Option<EditsFile>, id: &RoomId) -> (EditsFile, usize) {
    let mut file = file.unwrap_or(EditsFile { version: VERSION, edits: Vec::new() });
    let RoomId { building, level, room } = id;
    let is_room = |entry: &RoomEntry| {
        entry.building.as_ref() == Some(building) && entry.level == *level && entry.room == *room
    };
    let index = file.edits.iter().position(is_room).unwrap_or_else(|| {
        let entry = RoomEntry {
            building: Some(building.clone()),
            level: level.clone(),
            room: room.clone(),
            ..RoomEntry::default()
        };
        file.edits.push(entry);
        file.edits.len() - 1
    });
    (file, index)
}

fn without_empty(mut file: EditsFile) -> EditsFile {
    file.edits.retain(|entry| entry.seed.is_some() || !entry.objects.is_empty());
    file
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn keys(value: Value) -> Map<String, Value> {
        let Value::Object(keys) = value else { panic!("keys are an object") };
        keys
    }

    #[test]
    fn keys_that_are_not_set_stay() {
        let room = RoomId::new("house", "ground", "living");
        let moved = keys(json!({"at": [1.0, 2.0], "lock": true}));
        let file = set_object(None, &room, "sofa.1", Some(&moved)).unwrap();
        let file = set_object(Some(file), &room, "sofa.1", Some(&keys(json!({"lock": false, "turn": 90.0}))))
            .unwrap();
        let entry = &file.edits[0].objects["sofa.1"];
        assert_eq!((entry.at.as_deref(), entry.turn, entry.lock), (Some(&[1.0, 2.0][..]), Some(90.0), false));
        assert!(set_object(Some(file), &room, "sofa.1", None).unwrap().edits.is_empty());
    }

    #[test]
    fn what_is_removed_has_no_other_keys() {
        let room = RoomId::new("house", "ground", "living");
        let moved = keys(json!({"at": [1.0, 2.0], "lock": true}));
        let file = set_object(None, &room, "sofa.1", Some(&moved)).unwrap();
        let file = set_object(Some(file), &room, "sofa.1", Some(&keys(json!({"remove": true})))).unwrap();
        let entry = &file.edits[0].objects["sofa.1"];
        assert_eq!(*entry, ObjectEntry { remove: true, ..ObjectEntry::default() });
    }

    #[test]
    fn unknown_keys_are_refused() {
        let room = RoomId::new("house", "ground", "living");
        let error = set_object(None, &room, "sofa.1", Some(&keys(json!({"att": 1})))).unwrap_err();
        assert!(error.contains("att"), "{error}");
    }

    #[test]
    fn a_seed_stands_beside_edits_of_objects() {
        let room = RoomId::new("house", "ground", "living");
        let file = set_object(None, &room, "sofa.1", Some(&keys(json!({"remove": true})))).unwrap();
        let file = set_seed(Some(file), &room, Some(9));
        assert_eq!((file.edits.len(), file.edits[0].seed), (1, Some(9)));
        assert_eq!(set_seed(Some(file), &room, None).edits[0].objects.len(), 1);
    }
}
