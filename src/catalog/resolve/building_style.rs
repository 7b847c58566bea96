//! Resolves building styles.

use std::collections::BTreeMap;

use super::style::check_room_type;
use super::{merged_keys, resolve_label};
use crate::catalog::file::{BuildingStyleEntry, ChoiceEntry, RoomTypeEntry, StyleEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::{Chain, Table};
use crate::catalog::{BuildingStyle, ById, Share, Style, StyleRef, WeightedStyle};

/// The definitions that a building style may refer to.
pub(crate) struct BuildingStyleWorld<'a> {
    /// The room types.
    pub(crate) room_types: &'a Table<RoomTypeEntry>,
    /// The styles as written.
    pub(crate) style_table: &'a Table<StyleEntry>,
    /// The styles without faults.
    pub(crate) styles: &'a ById<Style>,
}

/// All building styles that are not broken, sorted by id.
pub(crate) fn resolve_building_styles(
    chains: &[Chain<'_, BuildingStyleEntry>],
    world: &BuildingStyleWorld<'_>,
    report: &mut Report<'_>,
) -> Vec<BuildingStyle> {
    chains.iter().map(|chain| resolve_building_style(chain, world, report)).collect()
}

fn resolve_building_style(
    chain: &Chain<'_, BuildingStyleEntry>,
    world: &BuildingStyleWorld<'_>,
    report: &mut Report<'_>,
) -> BuildingStyle {
    let own = chain.own();
    if world.style_table.get(&own.id).is_some() {
        let message = format!("\"{}\" is a style already", own.id);
        report.error_at_key(&own.spot, message, "plans name styles and building styles by the same key");
    }
    let styles = chain.find("styles", |entry| entry.styles.as_ref());
    let styles = styles.map(|found| resolve_choice(found.value, &found.spot, world, report));
    let rooms = resolve_rooms(chain, world, report);
    if styles.is_none() && rooms.is_empty() {
        report.error_at_key(
            &own.spot,
            "this building style names no style",
            "write `styles`, `rooms` or both",
        );
    }
    BuildingStyle {
        id: own.id.clone(),
        label: resolve_label(chain, |entry| entry.label.as_ref()),
        share: chain
            .find("share", |entry| entry.share.as_ref())
            .map_or_else(Share::default, |found| (*found.value).into()),
        styles: styles.unwrap_or_default(),
        rooms,
        instead: resolve_instead(chain, world, report),
    }
}

/// Exceptions by drawn style, each list from the nearest building style that has one.
fn resolve_instead(
    chain: &Chain<'_, BuildingStyleEntry>,
    world: &BuildingStyleWorld<'_>,
    report: &mut Report<'_>,
) -> BTreeMap<StyleRef, Vec<WeightedStyle>> {
    let mut instead = BTreeMap::new();
    for style in merged_keys(chain, |entry| entry.instead.as_ref()) {
        let found = chain.find("instead", |entry| entry.instead.as_ref()?.get(style));
        let found = found.expect("the key comes from the chain");
        let spot = found.spot.key(style);
        if world.style_table.get(style).is_none() {
            report.unknown(&spot, "style", style, world.style_table.ids());
        }
        let choice = resolve_choice(&ChoiceEntry::Weighted(found.value.clone()), &spot, world, report);
        let share: f64 = choice.iter().map(|one| one.weight).sum();
        if share > 1.0 {
            let hint = "they are shares of all dwellings or rooms";
            report.error_with_hint(&spot, format!("the shares add up to {share}"), hint);
        }
        instead.extend(world.styles.find(style).map(|style| (style, choice)));
    }
    instead
}

/// Lists by room type, each from the nearest building style that has one.
fn resolve_rooms(
    chain: &Chain<'_, BuildingStyleEntry>,
    world: &BuildingStyleWorld<'_>,
    report: &mut Report<'_>,
) -> BTreeMap<String, Vec<WeightedStyle>> {
    let mut rooms = BTreeMap::new();
    for room_type in merged_keys(chain, |entry| entry.rooms.as_ref()) {
        let found = chain.find("rooms", |entry| entry.rooms.as_ref()?.get(room_type));
        let found = found.expect("the key comes from the chain");
        let spot = found.spot.key(room_type);
        check_room_type(room_type, &spot, world.room_types, report);
        let choice = resolve_choice(found.value, &spot, world, report);
        for one in &choice {
            warn_of_unsuitable(one, room_type, &spot, world, report);
        }
        rooms.insert(room_type.clone(), choice);
    }
    rooms
}

/// A style that is not made for a room type leaves its rooms to the default style.
fn warn_of_unsuitable(
    one: &WeightedStyle,
    room_type: &str,
    spot: &Spot,
    world: &BuildingStyleWorld<'_>,
    report: &mut Report<'_>,
) {
    let style = &world.styles[one.style];
    if !style.suits(room_type) {
        let message = format!("style \"{}\" is not made for rooms of type \"{room_type}\"", style.id);
        report.warning(spot, message, "such rooms are furnished in the default style");
    }
}

fn resolve_choice(
    choice: &ChoiceEntry,
    spot: &Spot,
    world: &BuildingStyleWorld<'_>,
    report: &mut Report<'_>,
) -> Vec<WeightedStyle> {
    let written: Vec<(Spot, &String, f64)> = match choice {
        ChoiceEntry::One(style) => vec![(spot.clone(), style, 1.0)],
        ChoiceEntry::Even(styles) => {
            styles.iter().enumerate().map(|(place, style)| (spot.index(place), style, 1.0)).collect()
        }
        ChoiceEntry::Weighted(styles) => {
            styles.iter().map(|(style, weight)| (spot.key(style), style, *weight)).collect()
        }
    };
    if written.is_empty() {
        report.error_with_hint(spot, "this list names no style", "name one style, or several");
    }
    for (spot, style, weight) in &written {
        if world.style_table.get(style).is_none() {
            report.unknown(spot, "style", style, world.style_table.ids());
        }
        if !(weight.is_finite() && *weight > 0.0) {
            let hint = "weights are above zero; take the style away if it is never to be drawn";
            report.error_with_hint(spot, format!("weight is {weight}"), hint);
        }
    }
    // Those that are not there are reported.
    let known = |(_, style, weight): (Spot, &String, f64)| {
        world.styles.find(style).map(|style| WeightedStyle { style, weight })
    };
    written.into_iter().filter_map(known).collect()
}
