//! Makes edits that keep objects of a level where they stand.

use std::collections::{BTreeMap, BTreeSet};

use super::file::{ObjectEntry, RoomEntry};
use super::standing::{Floor, moved, own_keys, turned};
use crate::catalog::Side;
use crate::read_back::Survey;

/// Locks objects of a room where they stand: all of them where none is named.
///
/// # Errors
/// If there is no such room, no such object, or one that does not stand upright; says which, with those that there are.
pub fn lock_objects(survey: &Survey, room: &str, ids: &[String]) -> Result<RoomEntry, String> {
    let floor = Floor::new(survey, own_keys(survey));
    let here = || (0..floor.objects.len()).filter(|&index| floor.room(index).is_some_and(|own| own == room));
    if here().next().is_none() {
        let rooms: BTreeSet<&str> =
            (0..floor.objects.len()).filter_map(|index| floor.room(index)).map(String::as_str).collect();
        let rooms = rooms.into_iter().collect::<Vec<_>>().join(", ");
        return Err(format!("there is no furniture in a room \"{room}\", but in {rooms}"));
    }
    let known: BTreeMap<String, usize> =
        here().map(|index| (floor.objects[index].id.to_string(), index)).collect();
    let chosen: Vec<usize> = match ids {
        [] => here().collect(),
        ids => {
            ids.iter().map(|id| known.get(id).copied().ok_or(id)).collect::<Result<_, _>>().map_err(|id| {
                let known: Vec<&str> = known.keys().map(String::as_str).collect();
                format!("there is no {id} in room \"{room}\", but {}", known.join(", "))
            })?
        }
    };
    let mut objects = BTreeMap::new();
    for index in chosen {
        let object = &floor.objects[index];
        let standing =
            floor.standing(index).ok_or_else(|| format!("{} does not stand upright", object.id))?;
        let entry = ObjectEntry {
            lock: true,
            variant: Some(object.variant),
            side: Side::ALL.into_iter().find(|side| side.name() == object.side),
            at: moved(None, &standing.place),
            turn: turned(None, &standing.place),
            parent: Some(standing.parent),
            ..ObjectEntry::default()
        };
        objects.insert(object.id.to_string(), entry);
    }
    let (building, level) = (Some(survey.building.clone()), survey.level.clone());
    Ok(RoomEntry { building, level, room: room.to_owned(), seed: None, objects })
}
