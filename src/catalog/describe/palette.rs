//! Describes a palette.

use serde_json::{Map, Value, json};

use super::lines::{Lines, rounded};
use crate::catalog::resolve::srgb_hex;
use crate::catalog::{Catalog, Material, PaletteRef};

/// Nothing for a title, and the styles that use it.
pub(super) fn summary(catalog: &Catalog, id: &str) -> (String, String) {
    (
        String::new(),
        catalog.palettes.find(id).map(|palette| list_styles(catalog, palette)).unwrap_or_default().join(", "),
    )
}

fn list_styles(catalog: &Catalog, palette: PaletteRef) -> Vec<&str> {
    let styles = catalog.styles.values().filter(|style| style.palette == palette);
    styles.map(|style| style.id.as_str()).collect()
}

/// Everything about a palette.
pub(super) fn describe_palette(catalog: &Catalog, palette: PaletteRef) -> (Lines, Value) {
    let styles = list_styles(catalog, palette);
    let mut lines = Lines::default();
    let mut materials: Vec<(&str, &Material)> =
        catalog.palettes[palette].materials.iter().map(|(slot, material)| (slot.name(), material)).collect();
    materials.sort_by_key(|(slot, _)| *slot);
    for (slot, material) in &materials {
        lines.add(slot, &show_material(material));
    }
    lines.add("styles", &styles.join(", "));
    let materials: Map<String, Value> = materials
        .into_iter()
        .map(|(slot, material)| (slot.to_owned(), value_of_material(material)))
        .collect();
    (lines, json!({"materials": materials, "styles": styles}))
}

fn color(material: &Material) -> String {
    let [red, green, blue, _] = material.base_color;
    srgb_hex([red, green, blue])
}

fn tints(material: &Material) -> Vec<String> {
    material.tints.iter().map(|&[red, green, blue, _]| srgb_hex([red, green, blue])).collect()
}

fn show_material(material: &Material) -> String {
    let mut text = format!("{} roughness {}", color(material), rounded(f64::from(material.roughness)));
    let others = [
        ("metallic", material.metallic, 0.0),
        ("opacity", material.base_color[3], 1.0),
        ("transmission", material.transmission, 0.0),
    ];
    for (name, value, usual) in others {
        if value != usual {
            text += &format!(", {name} {}", rounded(f64::from(value)));
        }
    }
    if let Some(texture) = material.texture {
        text += &format!(", texture {texture}");
    }
    if !material.tints.is_empty() {
        text += &format!(", or {}", tints(material).join(", "));
    }
    if material.emissive != [0.0; 3] {
        text += &format!(", gives off {}", srgb_hex(material.emissive));
        if material.emissive_strength != 1.0 {
            text += &format!(" times {}", material.emissive_strength);
        }
    }
    text
}

fn value_of_material(material: &Material) -> Value {
    let number = |value: f32| rounded(f64::from(value));
    json!({
        "color": color(material),
        "roughness": number(material.roughness),
        "metallic": number(material.metallic),
        "opacity": number(material.base_color[3]),
        "emissive": srgb_hex(material.emissive),
        "emissive_strength": number(material.emissive_strength),
        "transmission": number(material.transmission),
        "texture": material.texture,
        "tints": tints(material),
    })
}
