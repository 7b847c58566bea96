//! The rooms of a dwelling as its people see them: how large, how light, what may become of them.

use std::collections::BTreeSet;

use crate::catalog::{Homes, Households, Role};
use crate::plan::{Building, Opening, OpeningKind, OpeningSide, Room};

use super::groups::{Dwelling, components, links};

/// Factors of a room's floor area where the plan does not say which room is the living room. More than 1 makes a room likelier;
/// usual rooms of a flat differ by a fifth, so that light and ways decide among rooms of about one size only.
///
/// Others are reached through it, as through no bedroom.
const THOROUGHFARE: f64 = 1.5;
/// A way to the kitchen or the dining room.
const AT_KITCHEN: f64 = 1.25;
/// A way to a balcony, a loggia or the garden.
const AT_BALCONY: f64 = 1.15;
/// No window, in a dwelling with windows.
const DARK: f64 = 0.3;
/// A bathroom of its own, which belongs to a bedroom.
const AT_BATHROOM: f64 = 0.7;

/// One room of a dwelling.
#[derive(Debug)]
pub(super) struct Chamber<'a> {
    /// The room.
    pub(super) room: &'a Room,
    /// Square metres.
    pub(super) area: f64,
    /// Whether it has daylight; in a dwelling that is dark everywhere each room has.
    pub(super) is_light: bool,
    /// Square metres times what speaks for a living room.
    pub(super) living_score: f64,
}

/// All rooms of a dwelling, in its order.
pub(super) fn chambers<'a>(
    building: &'a Building,
    dwelling: &Dwelling,
    households: &Households,
) -> Vec<Chamber<'a>> {
    let room = |&(level, room): &(usize, usize)| &building.levels[level].rooms[room];
    let lit = |place: &(usize, usize)| is_lit(building, *place, &households.homes);
    let windows: Vec<bool> = dwelling.rooms.iter().map(lit).collect();
    let is_dark_everywhere = !windows.contains(&true);
    let mut chambers = Vec::new();
    for (place, has_window) in dwelling.rooms.iter().zip(windows) {
        let area = room(place).region.area();
        let is_light = has_window || is_dark_everywhere;
        let score = area * living_factor(building, dwelling, *place, households);
        let living_score = if is_light { score } else { score * DARK };
        chambers.push(Chamber { room: room(place), area, is_light, living_score });
    }
    chambers
}

impl Chamber<'_> {
    /// Whether the plan and the size leave it open for a role.
    pub(super) fn suits(&self, role: &Role) -> bool {
        let (least, most) = role.area;
        role.of.contains(&self.room.room_type) && (least..=most).contains(&self.area)
    }

    /// Whether somebody may sleep there.
    pub(super) fn may_sleep(&self, households: &Households) -> bool {
        let named = households.roles.get(&self.room.room_type);
        let is_named = named.is_some_and(|role| role.sleeps);
        is_named || households.roles.values().any(|role| role.sleeps && role.wants_window && self.suits(role))
    }
}

/// Whether a room has a window, or a door to the open air or a balcony, which is of glass.
fn is_lit(building: &Building, (level, room): (usize, usize), homes: &Homes) -> bool {
    let level = &building.levels[level];
    let is_outdoors = |side: &OpeningSide| homes.outdoors.contains(&level.rooms[side.room].room_type);
    let lets_light_in = |index: usize| {
        let Opening { kind, sides, .. } = &level.openings[index];
        *kind == OpeningKind::Window || sides.len() == 1 || sides.iter().any(is_outdoors)
    };
    level.rooms[room].openings.iter().any(|side| lets_light_in(side.opening))
}

/// What speaks for a room as the living room, besides its size and light.
fn living_factor(
    building: &Building,
    dwelling: &Dwelling,
    (level, room): (usize, usize),
    households: &Households,
) -> f64 {
    let homes = &households.homes;
    let of_level = &building.levels[level];
    let links = links(of_level);
    let ends = links.iter().filter_map(|&(one, other)| match (one == room, other == room) {
        (true, _) => Some(other),
        (_, true) => Some(one),
        _ => None,
    });
    let beside: BTreeSet<&str> = ends.map(|other| of_level.rooms[other].room_type.as_str()).collect();
    let has = |set: &BTreeSet<String>| beside.iter().any(|kind| set.contains(*kind));
    let mut factor = 1.0;
    for (holds, weight) in [
        (has(&homes.kitchens) || has(&homes.dining), AT_KITCHEN),
        (has(&homes.outdoors), AT_BALCONY),
        (has(&homes.bathrooms), AT_BATHROOM),
        (is_thoroughfare(dwelling, (level, room), building, households), THOROUGHFARE),
    ] {
        factor *= if holds { weight } else { 1.0 };
    }
    factor
}

/// Whether rooms where people live or sleep are reached through a room only.
fn is_thoroughfare(
    dwelling: &Dwelling,
    (level, room): (usize, usize),
    building: &Building,
    households: &Households,
) -> bool {
    let of_level = &building.levels[level];
    let on_level = dwelling.rooms.iter().filter(|place| place.0 == level).map(|place| place.1);
    let all: Vec<usize> = on_level.collect();
    let others: Vec<usize> = all.iter().copied().filter(|&other| other != room).collect();
    let links = links(of_level);
    let is_open = |other: &&usize| {
        let kind = &of_level.rooms[**other].room_type;
        households.roles.values().any(|role| role.of.contains(kind))
    };
    let with_open = |rooms: &[usize]| {
        components(rooms, &links).iter().filter(|group| group.iter().any(|other| is_open(&other))).count()
    };
    with_open(&others) > with_open(&all)
}
