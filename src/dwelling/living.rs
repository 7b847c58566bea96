//! The living room of a dwelling, if the plan leaves it open.

use core::slice;
use std::collections::BTreeSet;

use crate::catalog::Households;

use super::rooms::Chamber;

/// A room, by its index in the dwelling, and the role that it gets.
pub(super) type Choice = (usize, String);

/// The living room, where the plan names none; where it names several, all but the largest without a screen. Where it names no
/// kitchen, the largest has one.
pub(super) fn living_rooms(chambers: &[Chamber<'_>], households: &Households) -> Vec<Choice> {
    let homes = &households.homes;
    let is_living = |index: &usize| homes.living.contains(&chambers[*index].room.room_type);
    let named: Vec<usize> = (0..chambers.len()).filter(is_living).collect();
    let Some(first) = best(named.iter().copied(), |index| chambers[index].area) else {
        return open_living_room(chambers, households).into_iter().collect();
    };
    let second = slice::from_ref(&homes.second_living);
    let others = named.into_iter().filter(|&index| index != first);
    let others = others.filter_map(|index| role_of(chambers, index, second, households));
    let open_kitchen = lacks_a_kitchen(chambers, first, households)
        .then(|| role_of(chambers, first, &homes.living_with_kitchen, households));
    open_kitchen.flatten().into_iter().chain(others).collect()
}

/// Whether people who have a bath, and a bed in their living room or in another, would have nowhere to cook. Without these, the
/// dwelling goes on on another floor, and may have its kitchen there.
fn lacks_a_kitchen(chambers: &[Chamber<'_>], living: usize, households: &Households) -> bool {
    let homes = &households.homes;
    !has(chambers, &homes.kitchens)
        && has(chambers, &homes.bathrooms)
        && (chambers[living].room.room_type == homes.only_room
            || leaves_a_bedroom(chambers, living, households))
}

/// Whether somebody may sleep in another room than the living room.
fn leaves_a_bedroom(chambers: &[Chamber<'_>], living: usize, households: &Households) -> bool {
    (0..chambers.len()).any(|other| other != living && chambers[other].may_sleep(households))
}

/// Whether the plan names a room of some types.
fn has(chambers: &[Chamber<'_>], types: &BTreeSet<String>) -> bool {
    chambers.iter().any(|chamber| types.contains(&chamber.room.room_type))
}

/// The living room of a plan that names none.
fn open_living_room(chambers: &[Chamber<'_>], households: &Households) -> Option<Choice> {
    let homes = &households.homes;
    // A floor without a kitchen is part of a dwelling that goes on elsewhere.
    if !has(chambers, &homes.kitchens) {
        return None;
    }
    let is_there = has_table(chambers, households);
    let roles = if is_there { &homes.living_without_table } else { &homes.living_with_table };
    let suits = |index: &usize| role_of(chambers, *index, roles, households).is_some();
    let leaves_a_bedroom = |living: &usize| leaves_a_bedroom(chambers, *living, households);
    let score = |index: usize| chambers[index].living_score;
    let all = || (0..chambers.len()).filter(suits);
    let first = best(all().filter(leaves_a_bedroom), score).or_else(|| best(all(), score))?;
    // Where there is no bath, people sleep on another floor.
    let is_only = has(chambers, &homes.bathrooms) && !leaves_a_bedroom(&first);
    let only = is_only.then(|| role_of(chambers, first, slice::from_ref(&homes.only_room), households));
    only.flatten().or_else(|| role_of(chambers, first, roles, households))
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
