//! 3D Tiles as a format of the table.

use std::sync::Arc;

use super::tileset;
use crate::compact::{Coarse, Coloring, CompactOptions, Instancing, Known, Shapes, write_compact};
use crate::disk::content_hash;
use crate::mesh::{Image, TextureUse};
use crate::model::Detail;
use crate::output::{
    IndexFiles, IndexOptions, IndexedLevel, LevelOptions, LevelToWrite, Output, OutputFormat,
    SHARED_TEXTURES, SceneLook, TooLarge, WrittenLevel, shared_images,
};
use crate::scene::SceneMaterial;

/// Three details of each level, and the tileset that leads to them.
pub(crate) const TILES: OutputFormat = OutputFormat {
    name: "tiles",
    about: "3D Tiles 1.1: tileset.json, and each level in three details",
    extensions: &["full.glb", "reduced.glb", "boxes.glb"],
    shows_textures: true,
    shares_all_images: true,
    has_index: true,
    is_read_back: false,
    begin: |_, options| {
        let LevelOptions { instancing, detail, .. } = *options;
        Box::new(TilesOutput { instancing, detail, known: Known::default() })
    },
};

/// Tiles in a run.
struct TilesOutput {
    instancing: Instancing,
    /// Of the scenes that levels come with.
    detail: Detail,
    known: Known,
}

/// Metres of the smallest and thinnest parts of boxes: less than what they are wrong by where they are shown first
/// ([`super::near`]).
const LEAST_OF_BOXES: f64 = 0.4;
const SHAPES_OF_BOXES: Shapes =
    Shapes::Coarse(Coarse { least_width: 0.12, boxed: 1.0, rounding: 0.1, sheet: 0.05, has_trim: false });
/// Metres of the smallest and thinnest parts of reduced levels.
const LEAST_OF_REDUCED: f64 = 0.1;
const SHAPES_OF_REDUCED: Shapes =
    Shapes::Coarse(Coarse { least_width: 0.03, boxed: 0.4, rounding: 0.03, sheet: 0.0, has_trim: true });
/// Draw calls of a level up to which equal models and boxes are instances; thirteen levels of a tower are in view as boxes before its
/// façade, seven reduced ones from nearer.
const DRAWS_OF_BOXES: usize = 10;
const DRAWS_OF_REDUCED: usize = 42;
const DRAWS_OF_FULL: usize = 300;
/// Metres of the coarsest steps of positions; levels of 65 m have steps of a millimetre.
const STEP_OF_FULL: f64 = 0.003;
const STEP_OF_REDUCED: f64 = 0.01;
const STEP_OF_BOXES: f64 = 0.03;

/// Bytes of the largest image inside a file.
const LARGEST_INSIDE: usize = 4096;
/// Digits of the content's hash in the name of an image.
const NAME_DIGITS: usize = 12;

impl Output for TilesOutput {
    fn level<'s>(&'s self, level: &LevelToWrite<'s>) -> Result<WrittenLevel<'s>, TooLarge> {
        let shown = |detail, is_plain| (level.shown)(SceneLook { detail, is_plain });
        let made = (self.detail != Detail::Full).then(|| shown(Detail::Full, false));
        let full = made.as_ref().unwrap_or(level.scene);
        let reduced = shown(Detail::Reduced, true);
        let boxes = shown(Detail::Boxes, true);
        let materials: Vec<SceneMaterial> = full.materials.iter().map(with_shared_images).collect();
        let options = CompactOptions {
            coloring: Coloring::Materials,
            least_size: 0.0,
            shapes: Shapes::Kept,
            coarsest_step: STEP_OF_FULL,
            instancing: self.instancing,
            most_draws: DRAWS_OF_FULL,
            has_normal_maps: false,
            keeps_nodes: false,
        };
        let of_reduced = CompactOptions {
            coloring: Coloring::Corners,
            least_size: LEAST_OF_REDUCED,
            shapes: SHAPES_OF_REDUCED,
            coarsest_step: STEP_OF_REDUCED,
            most_draws: DRAWS_OF_REDUCED,
            ..options
        };
        let of_boxes = CompactOptions {
            least_size: LEAST_OF_BOXES,
            shapes: SHAPES_OF_BOXES,
            coarsest_step: STEP_OF_BOXES,
            most_draws: DRAWS_OF_BOXES,
            ..of_reduced
        };
        let written = [
            ("full.glb", full, options),
            ("reduced.glb", &reduced, of_reduced),
            ("boxes.glb", &boxes, of_boxes),
        ];
        let written = written.map(|(extension, scene, options)| {
            let materials =
                if options.coloring == Coloring::Materials { &materials } else { &scene.materials };
            let bytes = write_compact(scene, materials, &self.known, &options)
                .map_err(|error| TooLarge { message: error.to_string(), hint: "split the level" });
            bytes.map(|bytes| (extension, bytes))
        });
        let files = written.into_iter().collect::<Result<Vec<_>, _>>()?;
        let textures = materials.iter().flat_map(SceneMaterial::textures);
        let shown =
            textures.filter(|(purpose, _)| *purpose != TextureUse::Normal).map(|(_, texture)| texture);
        Ok(WrittenLevel { files, shared: shared_images(shown, level.folder()) })
    }

    fn index(&self, levels: &[IndexedLevel], options: &IndexOptions) -> IndexFiles {
        tileset::files(levels, options)
    }
}

/// A material whose images have files of their own, in one folder for all buildings, but for tiny ones: clients keep one copy of what
/// has one address.
fn with_shared_images(material: &SceneMaterial) -> SceneMaterial {
    let SceneMaterial::Own(own) = material else { return material.clone() };
    let is_large = |image: &Image| image.uri.is_none() && image.bytes.len() > LARGEST_INSIDE;
    let mut own = Arc::clone(own);
    if own.textures.iter().any(|(_, texture)| is_large(&texture.image)) {
        for (_, texture) in &mut Arc::make_mut(&mut own).textures {
            if is_large(&texture.image) {
                let uri = Some(format!("../{SHARED_TEXTURES}/{}", file_name(&texture.image)));
                texture.image = Arc::new(Image { uri, ..(*texture.image).clone() });
            }
        }
    }
    SceneMaterial::Own(own)
}

/// A name for an image that depends on its content alone.
fn file_name(image: &Image) -> String {
    let ending = if image.mime_type == "image/jpeg" { "jpg" } else { "png" };
    format!("image.{}.{ending}", &content_hash(&image.bytes)[..NAME_DIGITS])
}
