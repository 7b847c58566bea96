//! Resolves palettes.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use super::color::linear_color;
use super::merged_keys;
use super::number::{Quantity, SHARE};
use super::room::find_slot;
use crate::catalog::file::{MaterialEntry, PaletteEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{Material, Palette, SURFACES};
use crate::recipes::Slot;

/// The range of the factor on emitted light.
const STRENGTH: RangeInclusive<f64> = 0.0..=1000.0;
const DEFAULT_ROUGHNESS: f64 = 0.7;
const DEFAULT_COLOR: &str = "#808080";
const DEFAULT_EMISSIVE: &str = "#000000";
/// The word that removes an inherited texture.
const NO_TEXTURE: &str = "none";

/// All palettes that are not broken, sorted by id.
pub(crate) fn resolve_palettes(chains: &[Chain<'_, PaletteEntry>], report: &mut Report<'_>) -> Vec<Palette> {
    chains.iter().map(|chain| resolve_palette(chain, report)).collect()
}

fn resolve_palette(chain: &Chain<'_, PaletteEntry>, report: &mut Report<'_>) -> Palette {
    let mut materials = BTreeMap::new();
    for word in merged_keys(chain, |entry| entry.materials.as_ref()) {
        let found = chain.find("materials", |entry| entry.materials.as_ref()?.get(word));
        let spot = found.expect("the slot comes from the chain").spot.key(word);
        let material = resolve_material(word, chain, report);
        if let Some(slot) = find_slot(word, &spot, report) {
            materials.insert(slot, material);
        }
    }
    let missing = Slot::ALL.iter().filter(|slot| !materials.contains_key(slot));
    let missing: Vec<&str> = missing.map(|slot| slot.name()).collect();
    if !missing.is_empty() {
        let own = chain.own();
        let message = format!("palette \"{}\" leaves slots empty: {}", own.id, missing.join(", "));
        report.error_at_key(
            &own.spot,
            message,
            "write materials for them, or `extends` a palette that has them",
        );
    }
    Palette { id: chain.own().id.clone(), materials }
}

/// A material, merged key by key along the chain.
fn resolve_material(slot: &str, chain: &Chain<'_, PaletteEntry>, report: &mut Report<'_>) -> Material {
    let strength = resolve_strength(slot, chain, report);
    let mut share = |key: &'static str, get: fn(&MaterialEntry) -> Option<f64>, default: f64| {
        let found = find_key(slot, key, chain, get);
        found.map_or(default, |(spot, value)| Quantity::plain(key, SHARE).check(value, &spot, report))
    };
    let roughness = share("roughness", |material| material.roughness, DEFAULT_ROUGHNESS);
    let metallic = share("metallic", |material| material.metallic, 0.0);
    let opacity = share("opacity", |material| material.opacity, 1.0);
    let transmission = share("transmission", |material| material.transmission, 0.0);
    let mut color = |key: &'static str, get: fn(&MaterialEntry) -> Option<String>, default: &str| {
        let unnamed = || (chain.own().spot.clone(), default.to_owned());
        let (spot, text) = find_key(slot, key, chain, get).unwrap_or_else(unnamed);
        linear_color(&text, &spot, report)
    };
    let [red, green, blue] = color("color", |material| material.color.clone(), DEFAULT_COLOR);
    let emissive = color("emissive", |material| material.emissive.clone(), DEFAULT_EMISSIVE);
    let texture = resolve_texture(slot, chain, report);
    let tints = resolve_tints(slot, chain, report);
    Material {
        base_color: [red, green, blue, opacity as f32],
        metallic: metallic as f32,
        roughness: roughness as f32,
        emissive,
        emissive_strength: strength as f32,
        transmission: transmission as f32,
        texture,
        tints: tints.into_iter().map(|[red, green, blue]| [red, green, blue, opacity as f32]).collect(),
    }
}

/// How much brighter than its colour a lit lamp is.
fn resolve_strength(slot: &str, chain: &Chain<'_, PaletteEntry>, report: &mut Report<'_>) -> f64 {
    let found = find_key(slot, "emissive_strength", chain, |material| material.emissive_strength);
    found.map_or(1.0, |(spot, value)| {
        Quantity::plain("emissive_strength", STRENGTH).check(value, &spot, report)
    })
}

/// The first value of a key along the chain, with its place.
fn find_key<T>(
    slot: &str,
    key: &'static str,
    chain: &Chain<'_, PaletteEntry>,
    get: impl Fn(&MaterialEntry) -> Option<T>,
) -> Option<(Spot, T)> {
    chain.0.iter().find_map(|definition| {
        let value = get(definition.entry.materials.as_ref()?.get(slot)?)?;
        Some((definition.spot.key("materials").key(slot).key(key), value))
    })
}

fn resolve_texture(
    slot: &str,
    chain: &Chain<'_, PaletteEntry>,
    report: &mut Report<'_>,
) -> Option<&'static str> {
    let (spot, word) = find_key(slot, "texture", chain, |material| material.texture.clone())?;
    let known = SURFACES.into_iter().find(|surface| *surface == word);
    if known.is_none() && word != NO_TEXTURE {
        report.unknown(&spot, "texture", &word, SURFACES.into_iter().chain([NO_TEXTURE]));
    }
    known
}

/// Other colours of a slot. A palette that changes the colour and names no tints has none: those of the palette
/// below belong to the colour below.
fn resolve_tints(slot: &str, chain: &Chain<'_, PaletteEntry>, report: &mut Report<'_>) -> Vec<[f32; 3]> {
    let own = |material: &MaterialEntry| match (&material.tints, &material.color) {
        (Some(tints), _) => Some(tints.clone()),
        (None, Some(_)) => Some(Vec::new()),
        (None, None) => None,
    };
    let (spot, texts) =
        find_key(slot, "tints", chain, own).unwrap_or_else(|| (chain.own().spot.clone(), Vec::new()));
    texts.iter().enumerate().map(|(index, text)| linear_color(text, &spot.index(index), report)).collect()
}
