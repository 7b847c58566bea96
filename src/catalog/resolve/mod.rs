//! Resolves definitions: follows inheritance, finds names, converts units, checks every value. A fault is reported at its
//! place, and the other definitions are resolved all the same.

mod audit;
mod building_style;
mod class;
mod color;
mod households;
mod model;
mod names;
mod number;
mod palette;
mod parents;
mod relations;
mod request;
mod room;
mod shape;
mod sides;
mod sizes;
mod style;
mod typologies;
mod words;

pub(crate) use audit::resolve_audit;
pub(crate) use building_style::{BuildingStyleWorld, resolve_building_styles};
pub(crate) use class::{ResolvedClass, resolve_classes};
pub(crate) use color::{srgb_encoded, srgb_hex, srgb_linear};
pub(crate) use households::resolve_households;
pub(crate) use names::Names;
pub(crate) use palette::resolve_palettes;
pub(crate) use request::ResolvedProgramme;
pub(crate) use room::{ResolvedRoomType, resolve_room_types};
pub(crate) use style::{ResolvedStyle, StyleLines, StyleWorld, resolve_styles};
pub(crate) use typologies::resolve_typologies;
pub(crate) use words::{resolve_pieces, resolve_words};

use std::collections::BTreeMap;

use super::table::Chain;

/// The title of a definition; without one, the id: `tv_stand` becomes `Tv stand`.
fn resolve_label<'a, T>(chain: &Chain<'a, T>, get: impl Fn(&'a T) -> Option<&'a String>) -> String {
    if let Some(found) = chain.find("label", get) {
        return found.value.clone();
    }
    let mut title = chain.own().id.replace('_', " ");
    if let Some(first) = title.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    title
}

/// The entries of a map key that is merged entry by entry along a chain, each from the nearest
/// definition that has it.
fn merged_keys<'a, T, V: 'a>(
    chain: &Chain<'a, T>,
    get: impl Fn(&'a T) -> Option<&'a BTreeMap<String, V>>,
) -> Vec<&'a String> {
    let mut keys: Vec<&String> =
        chain.0.iter().filter_map(|one| get(&one.entry)).flat_map(BTreeMap::keys).collect();
    keys.sort();
    keys.dedup();
    keys
}
