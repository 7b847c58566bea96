//! Resolves the kinds of buildings.

use std::collections::BTreeSet;

use crate::catalog::file::RoomTypeEntry;
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Table;
use crate::storey::Typologies;

/// Merges the files of all folders by name; later ones win. A list of guesses replaces the one before.
pub(crate) fn resolve_typologies(
    files: &[(usize, Typologies)],
    room_types: &Table<RoomTypeEntry>,
    report: &mut Report<'_>,
) -> Typologies {
    let mut merged = Typologies::default();
    for (_, file) in files {
        merged.rooms.extend(file.rooms.clone());
        merged.programmes.extend(file.programmes.clone());
        merged.typologies.extend(file.typologies.clone());
        merged.uses.extend(file.uses.clone());
        if !file.unknown_use.is_empty() {
            merged.unknown_use.clone_from(&file.unknown_use);
        }
    }
    let is_room = |id: &&str| room_types.get(id).is_some_and(|definition| !definition.entry.is_abstract);
    let rooms: BTreeSet<&str> = room_types.ids().filter(is_room).collect();
    for (source, file) in files {
        check(file, *source, &merged, &rooms, report);
    }
    merged
}

/// Reports names that nothing defines.
fn check(
    file: &Typologies,
    source: usize,
    merged: &Typologies,
    rooms: &BTreeSet<&str>,
    report: &mut Report<'_>,
) {
    let spot = |list: &str, id: &str| Spot::definition(source, list, id);
    let planned: BTreeSet<&str> = merged.rooms.keys().map(String::as_str).collect();
    let programmes: BTreeSet<&str> = merged.programmes.keys().map(String::as_str).collect();
    let kinds: BTreeSet<&str> = merged.typologies.keys().map(String::as_str).collect();
    let uses: BTreeSet<&str> = merged.uses.keys().map(String::as_str).collect();
    let mut known = |spot: &Spot, what: &str, word: &str, words: &BTreeSet<&str>| {
        if !words.contains(word) {
            report.unknown(spot, what, word, words.iter().copied());
        }
    };
    for (id, needs) in &file.rooms {
        known(&spot("rooms", id), "room type", id, rooms);
        for (index, door) in needs.doors.iter().enumerate() {
            known(&spot("rooms", id).key("doors").index(index), "room type", door, rooms);
        }
        for (index, other) in needs.open_to.iter().enumerate() {
            known(&spot("rooms", id).key("open_to").index(index), "room type", other, rooms);
        }
    }
    for (id, list) in &file.programmes {
        for (index, programme) in list.iter().enumerate() {
            let spot = spot("programmes", id).index(index).key("rooms");
            programme.rooms.keys().for_each(|room| known(&spot.key(room), "room of `rooms`", room, &planned));
        }
    }
    for (id, kind) in &file.typologies {
        let spot = spot("typologies", id);
        for (key, name) in [("hall", &kind.hall), ("main", &kind.main), ("street_level", &kind.street_level)]
        {
            name.iter().for_each(|name| known(&spot.key(key), "room type", name, rooms));
        }
        for (key, room) in [("entrance", &kind.entrance), ("open_wing", &kind.open_wing)] {
            room.iter().for_each(|room| known(&spot.key(key), "room of `rooms`", room, &planned));
        }
        let lists = [
            ("others", &kind.others),
            ("services", &kind.services),
            ("service_shares", &kind.service_shares),
        ];
        for (key, list) in lists {
            list.keys().for_each(|room| known(&spot.key(key).key(room), "room of `rooms`", room, &planned));
        }
        for (key, name) in [("programme", &kind.programme), ("upper_programme", &kind.upper_programme)] {
            name.iter().for_each(|name| known(&spot.key(key), "programme", name, &programmes));
        }
    }
    for (id, entry) in &file.uses {
        for (index, name) in entry.typologies.iter().enumerate() {
            known(&spot("uses", id).key("typologies").index(index), "typology", name, &kinds);
        }
    }
    for (index, rule) in file.unknown_use.iter().enumerate() {
        let spot = Spot { source, path: vec!["unknown_use".into(), index.into()] };
        known(&spot.key("use"), "use", &rule.use_name, &uses);
        for (place, name) in rule.otherwise.iter().enumerate() {
            known(&spot.key("otherwise").index(place), "use", name, &uses);
        }
    }
}
