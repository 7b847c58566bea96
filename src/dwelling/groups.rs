//! Finds the dwellings of a building: what the plan says, else what doors join.

use std::collections::{BTreeMap, BTreeSet};

use crate::catalog::Homes;
use crate::geometry::DisjointSets;
use crate::plan::{Building, Level, Room};

/// The type of rooms that join the rooms of a dwelling, or several dwellings.
const CORRIDOR: &str = "corridor";
/// What leads from a corridor to other levels.
const STAIRS: [&str; 3] = ["stairs", "staircase", "elevator"];

/// A room of a building, by the indices of its level and of itself.
pub(super) type Place = (usize, usize);

/// Rooms that belong together.
#[derive(Debug, PartialEq)]
pub(super) struct Dwelling {
    /// What it is called in its building, for its seed.
    pub(super) name: Vec<String>,
    /// Its rooms, in the order of the plan.
    pub(super) rooms: Vec<Place>,
}

/// All dwellings. A level whose rooms name theirs has no others; in a building that names none, a house with one kitchen is one
/// dwelling over all its levels, and elsewhere rooms belong together that doors join.
pub(super) fn dwellings(building: &Building, homes: &Homes) -> Vec<Dwelling> {
    if let Some(house) = whole_house(building, homes) {
        return vec![house];
    }
    let mut found = Vec::new();
    for (index, level) in building.levels.iter().enumerate() {
        let named = level.rooms.iter().any(|room| room.dwelling.is_some());
        let groups = if named { named_groups(level) } else { joined_groups(level, homes) };
        for (name, rooms) in groups {
            let is_home = is_home(rooms.iter().map(|&room| &level.rooms[room]), homes);
            let name = vec!["level".to_owned(), level.id.clone(), name];
            let rooms = rooms.into_iter().map(|room| (index, room)).collect();
            found.extend(is_home.then_some(Dwelling { name, rooms }));
        }
    }
    found
}

/// The whole building, if it is a house of one household.
fn whole_house(building: &Building, homes: &Homes) -> Option<Dwelling> {
    let rooms = || building.levels.iter().flat_map(|level| &level.rooms);
    let kitchens = rooms().filter(|room| homes.kitchens.contains(&room.room_type)).count();
    let is_house = kitchens == 1 && rooms().all(|room| room.dwelling.is_none()) && is_home(rooms(), homes);
    is_house.then(|| Dwelling {
        name: vec!["house".to_owned()],
        rooms: (building.levels.iter().enumerate())
            .flat_map(|(index, level)| (0..level.rooms.len()).map(move |room| (index, room)))
            .collect(),
    })
}

/// Whether people live in these rooms: none is of another kind, and there is a kitchen or a living room, or a bed and a bath.
fn is_home<'a>(rooms: impl Iterator<Item = &'a Room>, homes: &Homes) -> bool {
    let types: BTreeSet<&str> = rooms.map(|room| room.room_type.as_str()).collect();
    let has = |set: &BTreeSet<String>| types.iter().any(|kind| set.contains(*kind));
    let belongs = |kind: &&str| homes.inside.contains(*kind) || homes.between.contains(*kind);
    types.iter().all(belongs) && (has(&homes.kitchens) || has(&homes.living) || has(&homes.bathrooms))
}

/// The rooms of a level by the dwelling that the plan names.
fn named_groups(level: &Level) -> Vec<(String, Vec<usize>)> {
    let mut groups: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (index, room) in level.rooms.iter().enumerate() {
        if let Some(name) = &room.dwelling {
            groups.entry(name.clone()).or_default().push(index);
        }
    }
    groups.into_iter().collect()
}

/// The rooms of a level that doors join without stairs, each group by the least id of its rooms.
fn joined_groups(level: &Level, homes: &Homes) -> Vec<(String, Vec<usize>)> {
    let is_inside = |room: &usize| !homes.between.contains(&level.rooms[*room].room_type);
    let all: Vec<usize> = (0..level.rooms.len()).filter(is_inside).collect();
    let links = links(level);
    let is_shared = |room: usize| {
        let leads_up = |&(one, other): &(usize, usize)| {
            let (one, other) = if other == room { (other, one) } else { (one, other) };
            one == room && STAIRS.contains(&level.rooms[other].room_type.as_str())
        };
        level.rooms[room].room_type == CORRIDOR && links.iter().any(leads_up)
    };
    let mut groups = Vec::new();
    for group in components(&all, &links) {
        let is_kitchen = |room: &&usize| homes.kitchens.contains(&level.rooms[**room].room_type);
        // A corridor at the stairs that leads to several kitchens belongs to none of their dwellings.
        if group.iter().filter(is_kitchen).count() > 1 {
            let private: Vec<usize> = group.into_iter().filter(|room| !is_shared(*room)).collect();
            groups.extend(components(&private, &links));
        } else {
            groups.push(group);
        }
    }
    let name = |group: &Vec<usize>| group.iter().map(|&room| level.rooms[room].id.clone()).min();
    groups.into_iter().filter_map(|group| Some((name(&group)?, group))).collect()
}

/// The pairs of rooms with a way from one to the other.
pub(super) fn links(level: &Level) -> Vec<(usize, usize)> {
    let ways = level.openings.iter().filter(|opening| opening.kind.is_walkable());
    ways.filter_map(|way| match way.sides.as_slice() {
        [one, other] => Some((one.room, other.room)),
        _ => None,
    })
    .collect()
}

/// The rooms in groups that ways hold together.
pub(super) fn components(rooms: &[usize], links: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let place: BTreeMap<usize, usize> =
        rooms.iter().enumerate().map(|(place, &room)| (room, place)).collect();
    let mut sets = DisjointSets::new(rooms.len());
    for (one, other) in links {
        if let (Some(&one), Some(&other)) = (place.get(one), place.get(other)) {
            sets.join(one, other);
        }
    }
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, &room) in rooms.iter().enumerate() {
        groups.entry(sets.find(index)).or_default().push(room);
    }
    groups.into_values().collect()
}
