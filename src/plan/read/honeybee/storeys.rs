//! Shares honeybee's rooms out among storeys: by the name of the storey that they say, else by the heights of their floors.

use std::collections::BTreeMap;

use super::model::{Place, Space, Storey};
use crate::plan::limits::BUILDING_LEVELS;

/// Metres between two floors of which the upper stands on the lower.
const LOWEST_STOREY: f64 = 1.8;

/// A space, and the name of the storey that its room says.
pub(super) type Named = (Option<String>, Space);

/// The storeys of rooms.
pub(super) fn storeys(rooms: Vec<Named>, place: &Place) -> Vec<Storey> {
    let mut storeys = Vec::new();
    add(rooms, &mut storeys, place);
    storeys
}

/// Adds rooms to the storeys of their names and, those without a name, to the storeys on whose height their floors lie; for the
/// others new storeys are made.
pub(super) fn add(rooms: Vec<Named>, storeys: &mut Vec<Storey>, place: &Place) {
    let mut numbers: BTreeMap<String, usize> = BTreeMap::new();
    for (number, storey) in storeys.iter().enumerate() {
        numbers.entry(storey.name.clone()).or_insert(number);
    }
    let mut nameless: Vec<Space> = Vec::new();
    for (name, space) in rooms {
        let Some(name) = name.filter(|name| !name.trim().is_empty()) else {
            nameless.push(space);
            continue;
        };
        let number = *numbers.entry(name).or_insert_with_key(|name| {
            storeys.push(storey(name.clone(), place));
            storeys.len() - 1
        });
        storeys[number].spaces.push(space);
    }
    add_by_height(nameless, storeys, place);
}

fn storey(name: String, place: &Place) -> Storey {
    Storey { name, height: None, repeat: 1, spaces: Vec::new(), place: place.clone() }
}

fn add_by_height(mut spaces: Vec<Space>, storeys: &mut Vec<Storey>, place: &Place) {
    let lowest =
        |storey: &Storey| storey.spaces.iter().map(|space| space.floor).fold(f64::INFINITY, f64::min);
    let named: Vec<f64> = storeys.iter().take(BUILDING_LEVELS).map(lowest).collect();
    // A stable sort: rooms on one height keep the order of the file.
    spaces.sort_by(|one, two| one.floor.total_cmp(&two.floor));
    let mut made: Option<(f64, usize)> = None;
    for space in spaces {
        let distance = |number: &usize| (space.floor - named[*number]).abs();
        let nearest = (0..named.len()).min_by(|one, two| distance(one).total_cmp(&distance(two)));
        let number = nearest.filter(|number| distance(number) < LOWEST_STOREY / 2.0);
        let last = made.filter(|(floor, _)| space.floor - floor < LOWEST_STOREY).map(|(_, number)| number);
        let number = number.or(last).unwrap_or_else(|| {
            storeys.push(storey(format!("Level {}", storeys.len() + 1), place));
            made = Some((space.floor, storeys.len() - 1));
            storeys.len() - 1
        });
        storeys[number].spaces.push(space);
    }
}
