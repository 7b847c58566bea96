//! The image of the plain colours of a palette: one pixel for each slot, in a square.

use std::sync::{Arc, LazyLock};

use super::encode::png;
use super::surface::sample;
use crate::catalog::{Material, SURFACES, srgb_encoded};
use crate::model::{Image, SWATCHES_PER_SIDE, Texture, TextureSampler, TextureUse};
use crate::recipes::Slot;

/// Samples along each side of a surface, for its average.
const SAMPLES: usize = 24;

/// Base colour and roughness with metalness of all slots, one pixel each, and their light where it is wanted, with the strength
/// that multiplies it (1 without). `material` says what a slot is, in the colour that is wanted. Textured slots have the
/// average of their texture.
pub(crate) fn swatch_textures(
    name: &str,
    is_lit: bool,
    material: impl Fn(Slot) -> Material,
) -> (Vec<(TextureUse, Texture)>, f32) {
    let materials: Vec<Material> = Slot::ALL.iter().copied().map(material).collect();
    let light = |one: &Material| one.emissive.map(|channel| channel * one.emissive_strength);
    let strongest = materials.iter().flat_map(light).fold(1.0, f32::max);
    let mut images = [Vec::new(), Vec::new(), Vec::new()];
    for one in &materials {
        let (shade, rough) = one.texture.map_or((1.0, 1.0), known_average);
        let encoded = |linear: f32, factor: f64| byte(srgb_encoded(f64::from(linear) * factor));
        let [red, green, blue, _] = one.base_color;
        images[0].extend([red, green, blue].map(|channel| encoded(channel, shade)));
        // Red would be occlusion, of which there is none.
        images[1].extend([u8::MAX, byte(f64::from(one.roughness) * rough), byte(f64::from(one.metallic))]);
        images[2].extend(light(one).map(|channel| encoded(channel / strongest, 1.0)));
    }
    let uses = [
        (TextureUse::BaseColor, "base_color"),
        (TextureUse::MetallicRoughness, "roughness"),
        (TextureUse::Emissive, "light"),
    ];
    let shown = uses.into_iter().zip(images).take(if is_lit { 3 } else { 2 });
    let textures =
        shown.map(|((purpose, what), pixels)| (purpose, texture(format!("{name}.{what}"), pixels)));
    (textures.collect(), if is_lit { strongest } else { 1.0 })
}

fn texture(name: String, mut pixels: Vec<u8>) -> Texture {
    pixels.resize(3 * SWATCHES_PER_SIDE * SWATCHES_PER_SIDE, 0);
    let bytes = png(&pixels, SWATCHES_PER_SIDE, 3);
    let image = Image { name: Some(name), mime_type: "image/png".to_owned(), bytes, uri: None };
    Texture::plain(Arc::new(image), TextureSampler::default())
}

/// The factor by which the texture of a surface darkens the colour of its material on average, linear.
pub(crate) fn average_shade(surface: &str) -> f32 {
    known_average(surface).0 as f32
}

/// [`average`], taken once a run: each level has swatches, which would sample every surface anew.
fn known_average(surface: &str) -> (f64, f64) {
    static AVERAGES: LazyLock<Vec<(f64, f64)>> =
        LazyLock::new(|| SURFACES.iter().map(|surface| average(surface)).collect());
    let index = SURFACES.iter().position(|&known| known == surface);
    index.map_or_else(|| average(surface), |index| AVERAGES[index])
}

/// Mean shade, linear, and mean roughness of a surface.
fn average(surface: &str) -> (f64, f64) {
    let middle = |index: usize| (index as f64 + 0.5) / SAMPLES as f64;
    let points = (0..SAMPLES).flat_map(|row| (0..SAMPLES).map(move |column| [middle(column), middle(row)]));
    let sum = points
        .map(|point| sample(surface, point))
        .fold((0.0, 0.0), |(shade, roughness), sample| (shade + sample.shade, roughness + sample.roughness));
    let count = (SAMPLES * SAMPLES) as f64;
    (sum.0 / count, sum.1 / count)
}

fn byte(value: f64) -> u8 {
    (value.clamp(0.0, 1.0) * f64::from(u8::MAX)).round() as u8
}
