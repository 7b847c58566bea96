//! The keys of `configs/palettes/*.yaml`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use super::FormatVersion;
use crate::catalog::table::Extends;

/// Palettes: what the material slots of the recipes look like.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Palettes")]
pub(crate) struct PaletteFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// The palettes by id: lower-case words joined by `_`.
    pub(crate) palettes: BTreeMap<String, PaletteEntry>,
}

/// A palette; with what it extends it fills every slot.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PaletteEntry {
    /// Another palette, whose materials are taken slot by slot and key by key where this one has none.
    pub(crate) extends: Option<String>,
    /// Materials by slot.
    pub(crate) materials: Option<BTreeMap<String, MaterialEntry>>,
}

impl Extends for PaletteEntry {
    const KIND: &'static str = "palette";
    const TABLE: &'static str = "palettes";

    fn base(&self) -> Option<&str> {
        self.extends.as_deref()
    }
}

/// A metallic-roughness material.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaterialEntry {
    /// sRGB, `#rrggbb`.
    pub(crate) color: Option<String>,
    /// 0 a mirror, 1 chalk; default 0.7.
    pub(crate) roughness: Option<f64>,
    /// 0 for all materials except bare metal; default 0.
    pub(crate) metallic: Option<f64>,
    /// Default 1.
    pub(crate) opacity: Option<f64>,
    /// Light given off, sRGB, `#rrggbb`; default `#000000`.
    pub(crate) emissive: Option<String>,
    /// Multiplies `emissive` where lamps are lit, 0 to 1000; default 1.
    pub(crate) emissive_strength: Option<f64>,
    /// Share of light that passes, for glass; default 0.
    pub(crate) transmission: Option<f64>,
    /// The texture on it: wood, tile, fabric and others; default `none`, a plain colour.
    pub(crate) texture: Option<String>,
    /// Other colours, sRGB `#rrggbb`, that furniture of this palette may have in its stead, each as often.
    pub(crate) tints: Option<Vec<String>>,
}
