//! The living room of a dwelling, if the plan leaves it open.

use core::slice;
use std::collections::BTreeSet;

use crate::catalog::Households;

use super::rooms::Chamber;

/// A room, by its index in the dwelling, and the role that it gets.
pub(super) type Choice = (usize, String);

/// The living room, where the plan names none; where it names several, all but the largest without a screen.
pub(super) fn living_rooms(chambers: &[Chamber<'_>], households: &Households) -> Vec<Choice> {
    let homes = &households.homes;
    let is_living = |index: &usize| homes.living.contains(&chambers[*index].room.room_type);
    let named: Vec<usize> = (0..chambers.len()).filter(is_living).collect();
    let has =
        |types: &BTreeSet<String>| chambers.iter().any(|chamber| types.contains(&chamber.room.room_type));
    if let Some(first) = best(named.iter().copied(), |index| chambers[index].area) {
        let others = named.into_iter().filter(|&index| index != first);
        return others
            .filter_map(|index| role_of(chambers, index, slice::from_ref(&homes.second_living), households))
            .collect();
    }
    // A floor without a kitchen is part of a dwelling that goes on elsewhere.
    if !has(&homes.kitchens) {
        return Vec::new();
    }
    let is_there = has_table(chambers, households);
    let roles = if is_there { &homes.living_without_table } else { &homes.living_with_table };
    let suits = |index: &usize| role_of(chambers, *index, roles, households).is_some();
    let Some(first) = best((0..chambers.len()).filter(suits), |index| chambers[index].living_score) else {
        return Vec::new();
    };
    let sleeps_elsewhere = |index: usize| index != first && chambers[index].may_sleep(households);
    // Where there is no bath, people sleep on another floor.
    let is_only = has(&homes.bathrooms) && !(0..chambers.len()).any(sleeps_elsewhere);
    let only =
        is_only.then(|| role_of(chambers, first, slice::from_ref(&homes.only_room), households)).flatten();
    only.or_else(|| role_of(chambers, first, roles, households)).into_iter().collect()
}

/// Whether the plan names a room with a table for meals.
fn has_table(chambers: &[Chamber<'_>], households: &Households) -> bool {
    let homes = &households.homes;
    chambers.iter().any(|Chamber { room, area, .. }| {
        let is_large = homes.kitchens.contains(&room.room_type) && *area >= homes.dining_kitchen;
        homes.dining.contains(&room.room_type) || is_large
    })
}

/// The first of some roles that suits a room.
pub(super) fn role_of(
    chambers: &[Chamber<'_>],
    index: usize,
    roles: &[String],
    households: &Households,
) -> Option<Choice> {
    let suits = |role: &&String| households.roles.get(*role).is_some_and(|role| chambers[index].suits(role));
    roles.iter().find(suits).map(|role| (index, role.clone()))
}

/// The item with the highest number; the first of equals.
pub(super) fn best(items: impl Iterator<Item = usize>, of: impl Fn(usize) -> f64) -> Option<usize> {
    items.reduce(|best, item| if of(item) > of(best) { item } else { best })
}
