//! The images of all surfaces, each generated once.

use std::sync::{Arc, OnceLock};

use rayon::prelude::*;
use sha2::{Digest, Sha256};

use super::encode::png;
use super::relief::normals;
use super::surface::{Sample, has_relief, sample};
use super::{SurfaceUse, TextureSize};
use crate::cache::Cache;
use crate::catalog::{SURFACES, srgb_linear};
use crate::model::{Image, Texture, TextureSampler, TextureUse};

/// Where images lie.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TextureLocation {
    /// Inside each file that shows them.
    Embedded,
    /// In a folder that all files share, named by its path from the folder of such a file, without a slash at its
    /// end.
    Beside(String),
}

/// The images of all surfaces, generated when first asked for and then shared.
#[derive(Debug)]
pub struct TextureLibrary {
    size: TextureSize,
    location: TextureLocation,
    cache: Option<Cache>,
    /// For rooms, then for furniture alone where that has images of its own.
    surfaces: Vec<[OnceLock<Painted>; 2]>,
}

/// The images of a surface by use.
type Painted = Vec<(TextureUse, Texture)>;

/// Digits of the content's hash in the name of an image's file.
const NAME_DIGITS: usize = 12;

impl TextureLibrary {
    /// A library without images yet.
    #[must_use]
    pub fn new(size: TextureSize, location: TextureLocation) -> Self {
        Self { size, location, cache: None, surfaces: SURFACES.iter().map(|_| Default::default()).collect() }
    }

    /// The same library that looks for its images in a cache before it generates them, and keeps them there.
    #[must_use]
    pub fn with_cache(self, cache: Option<Cache>) -> Self {
        Self { cache, ..self }
    }

    /// Base colour, normals where it has relief, and roughness of a surface; none for an unknown name. Images inside files are
    /// half as wide on furniture alone: each file carries its own. Shared ones have one size.
    pub fn textures(&self, surface: &str, covered: SurfaceUse) -> &[(TextureUse, Texture)] {
        let Some(index) = SURFACES.iter().position(|&name| name == surface) else { return &[] };
        let is_half = covered == SurfaceUse::Furniture && self.location == TextureLocation::Embedded;
        let pixels = self.size.pixels() / if is_half { 2 } else { 1 };
        self.surfaces[index][usize::from(is_half)].get_or_init(|| self.paint(SURFACES[index], pixels))
    }

    /// Generates all surfaces at once, on as many threads as there are: generated on demand, the first level would wait for one
    /// after the other, and all other levels for it.
    pub fn paint_all(&self) {
        SURFACES.par_iter().for_each(|surface| {
            for covered in [SurfaceUse::Room, SurfaceUse::Furniture] {
                let _ = self.textures(surface, covered);
            }
        });
    }

    fn paint(&self, surface: &'static str, pixels: usize) -> Painted {
        let files = match &self.cache {
            Some(cache) => cache.get_or_make(&("surface", surface, pixels), || images(surface, pixels)),
            None => images(surface, pixels),
        };
        let texture = |(purpose, bytes): (TextureUse, Vec<u8>)| {
            let uri = match &self.location {
                TextureLocation::Embedded => None,
                TextureLocation::Beside(folder) => {
                    Some(format!("{folder}/{}", file_name(surface, purpose, &bytes)))
                }
            };
            let name = Some(format!("{surface}.{}", purpose_name(purpose)));
            let image = Image { name, mime_type: "image/png".to_owned(), bytes, uri };
            (purpose, Texture::plain(Arc::new(image), TextureSampler::default()))
        };
        files.into_iter().map(texture).collect()
    }
}

/// A name for the content, and the content, so that runs of other sizes and versions do not disturb each
/// other.
fn file_name(surface: &str, purpose: TextureUse, bytes: &[u8]) -> String {
    let what = purpose_name(purpose);
    let hash: String = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{surface}.{what}.{}.png", &hash[..NAME_DIGITS])
}

fn purpose_name(purpose: TextureUse) -> &'static str {
    match purpose {
        TextureUse::BaseColor => "base_color",
        TextureUse::Normal => "normal",
        _ => "roughness",
    }
}

/// The files of a surface by use; normals only where it has relief.
fn images(surface: &str, pixels: usize) -> Vec<(TextureUse, Vec<u8>)> {
    let samples = samples(surface, pixels);
    let steps = ShadeSteps::new();
    let shades: Vec<u8> = samples.iter().map(|sample| steps.encoded(sample.shade)).collect();
    // Occlusion, roughness and metalness share an image: red is none, blue leaves metalness to the palette.
    let rough = |sample: &Sample| [255, stepped_roughness(sample.roughness), 255];
    let roughness: Vec<u8> = samples.iter().flat_map(rough).collect();
    let mut images = vec![(TextureUse::BaseColor, png(&shades, pixels, 1))];
    if has_relief(surface) {
        let heights: Vec<f64> = samples.iter().map(|sample| sample.height).collect();
        images.push((TextureUse::Normal, png(&normals(&heights, pixels), pixels, 3)));
    }
    images.push((TextureUse::MetallicRoughness, png(&roughness, pixels, 3)));
    images
}

/// Every pixel's middle, row by row from the top of the image, which is the far end of `v`: the image's rows go down
/// as glTF's texture coordinates do.
fn samples(surface: &str, pixels: usize) -> Vec<Sample> {
    let middle = |index: usize| (index as f64 + 0.5) / pixels as f64;
    let points = (0..pixels).flat_map(|row| (0..pixels).map(move |column| [middle(column), middle(row)]));
    points.map(|point| sample(surface, point)).collect()
}

/// Steps of grey, of 255: fewer of them compress better.
const SHADE_STEP: u8 = 2;
/// Steps of roughness, of 255.
const ROUGHNESS_STEP: f64 = 16.0;

/// Linear shades between the steps of encoded ones, from light to dark: looked up, because the transfer function for each
/// pixel takes longer than the surface.
struct ShadeSteps(Vec<f64>);

impl ShadeSteps {
    fn new() -> Self {
        let middle = |index: u8| 1.0 - (f64::from(index) + 0.5) * f64::from(SHADE_STEP) / f64::from(u8::MAX);
        Self((0..u8::MAX / SHADE_STEP).map(|index| srgb_linear(middle(index))).collect())
    }

    /// The nearest step of a linear shade in sRGB.
    fn encoded(&self, shade: f64) -> u8 {
        u8::MAX - SHADE_STEP * self.0.partition_point(|&middle| shade <= middle) as u8
    }
}

fn stepped_roughness(value: f64) -> u8 {
    let steps = ((1.0 - value.clamp(0.0, 1.0)) * 255.0 / ROUGHNESS_STEP).round();
    (255.0 - steps * ROUGHNESS_STEP).clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    use SurfaceUse::{Furniture, Room};

    /// Bytes of the images of a surface that a level with a dozen surfaces can afford.
    const MOST_BYTES: usize = 420_000;

    fn library(size: TextureSize) -> TextureLibrary {
        TextureLibrary::new(size, TextureLocation::Beside("../textures".to_owned()))
    }

    #[test]
    fn every_surface_has_its_images_and_they_are_small() {
        let library = library(TextureSize::Small);
        let mut total = 0;
        for surface in SURFACES {
            let textures = library.textures(surface, Room);
            let bytes: usize = textures.iter().map(|(_, texture)| texture.image.bytes.len()).sum();
            assert_eq!(textures.len(), if has_relief(surface) { 3 } else { 2 }, "{surface}");
            assert!(bytes < MOST_BYTES, "{surface} takes {bytes} bytes");
            total += bytes;
        }
        assert!(total < SURFACES.len() * MOST_BYTES / 2, "{total} bytes");
    }

    #[test]
    fn shades_are_encoded_to_the_nearest_step() {
        let steps = ShadeSteps::new();
        assert_eq!([steps.encoded(1.0), steps.encoded(0.0)], [255, 1]);
        for code in (1..=255).step_by(SHADE_STEP.into()) {
            let exact = srgb_linear(f64::from(code) / 255.0);
            let [darker, lighter] = [-0.9, 0.9].map(|by| srgb_linear((f64::from(code) + by) / 255.0));
            assert_eq!([exact, darker, lighter].map(|shade| steps.encoded(shade.clamp(0.0, 1.0))), [code; 3]);
        }
    }

    #[test]
    fn paths_are_relative_and_have_a_hash_of_the_content() {
        let library = library(TextureSize::Small);
        let (_, texture) = &library.textures("tile", Room)[0];
        let uri = texture.image.uri.as_deref().unwrap();
        assert!(uri.starts_with("../textures/tile.base_color.") && uri.ends_with(".png"), "{uri}");
        let embedded = TextureLibrary::new(TextureSize::Small, TextureLocation::Embedded);
        assert_eq!(embedded.textures("tile", Room)[0].1.image.uri, None);
        assert_eq!(embedded.textures("tile", Room)[0].1.image.bytes, texture.image.bytes);
    }

    #[test]
    fn images_inside_files_are_smaller_on_furniture() {
        let bytes = |location: TextureLocation, covered: SurfaceUse| {
            let library = TextureLibrary::new(TextureSize::Small, location);
            let textures = library.textures("leather", covered);
            textures.iter().map(|(_, texture)| texture.image.bytes.len()).sum::<usize>()
        };
        let embedded = [Room, Furniture].map(|covered| bytes(TextureLocation::Embedded, covered));
        assert!(3 * embedded[1] < embedded[0], "{embedded:?}");
        let beside =
            [Room, Furniture].map(|covered| bytes(TextureLocation::Beside("textures".to_owned()), covered));
        assert_eq!(beside, [embedded[0]; 2]);
    }

    #[test]
    fn equal_requests_share_one_image_and_unknown_surfaces_have_none() {
        let library = library(TextureSize::Small);
        let image = |index: usize| Arc::clone(&library.textures("tile", Room)[index].1.image);
        assert!(Arc::ptr_eq(&image(0), &image(0)));
        assert!(library.textures("marzipan", Room).is_empty());
    }

    #[test]
    fn the_pixels_are_the_same_on_every_machine() {
        let painted = SURFACES.iter().flat_map(|surface| {
            let samples = samples(surface, 32);
            samples.into_iter().flat_map(|s| [s.shade, s.roughness, s.height]).flat_map(f64::to_le_bytes)
        });
        let hash = Sha256::digest(painted.collect::<Vec<u8>>());
        let hash: String = hash.iter().take(8).map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(hash, "58af5cb6fcf88107");
    }
}
