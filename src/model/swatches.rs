//! Fewer primitives a model: what needs no texture of its own becomes one primitive, coloured from one small image.
//!
//! Viewers draw every primitive by itself, and a bookcase has one for each colour of its books. Parts of plain colour are laid
//! on an image in which each slot has a square of its own, its swatch; textured parts that are too small for their grain to be
//! seen are coloured as their texture is on average. What passes light or mirrors keeps its own material, because renderers treat it
//! in ways of their own.

use std::collections::BTreeMap;
use std::sync::{Arc, PoisonError, RwLock};

use super::{Model, ModelMaterial, Primitive};
use crate::catalog::{Catalog, Material};
use crate::recipes::Slot;

/// Swatches along each side of their image: room for all slots.
pub(crate) const SWATCHES_PER_SIDE: usize = 8;

/// Square metres of all its faces from which a part shows its texture: the frame of a chair has less, the top of a table more.
/// Less means more textured parts and draw calls.
const LEAST_TEXTURED_AREA: f64 = 0.6;

/// Slots that renderers treat in ways of their own, whatever their material is.
const SPECIAL: [Slot; 2] = [Slot::Mirror, Slot::Screen];

/// Which slots can become swatches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rule {
    Always,
    /// It has a texture in some palette.
    WhenSmall,
    Never,
}

/// The models of a run with swatches, each made once. Threads may share it.
#[derive(Debug)]
pub struct SwatchedModels {
    /// By slot.
    rules: Vec<Rule>,
    /// By the address of the model, which is held so that no other gets it.
    known: RwLock<BTreeMap<usize, [Arc<Model>; 2]>>,
}

impl SwatchedModels {
    /// By the palettes of a catalogue; a slot is treated alike in all of them, so that they share triangles.
    #[must_use]
    pub fn new(catalog: &Catalog) -> Self {
        let rule = |slot: &Slot| {
            let materials: Vec<&Material> =
                catalog.palettes.values().filter_map(|palette| palette.materials.get(slot)).collect();
            let is_own = |material: &&Material| material.transmission > 0.0 || material.base_color[3] < 1.0;
            if SPECIAL.contains(slot) || materials.iter().any(is_own) {
                Rule::Never
            } else if materials.iter().any(|material| material.texture.is_some()) {
                Rule::WhenSmall
            } else {
                Rule::Always
            }
        };
        Self { rules: Slot::ALL.iter().map(rule).collect(), known: RwLock::default() }
    }

    /// The model with swatches; the same one for the same model.
    pub fn of(&self, model: &Arc<Model>) -> Arc<Model> {
        let key = Arc::as_ptr(model).addr();
        let read = self.known.read().unwrap_or_else(PoisonError::into_inner);
        if let Some([_, made]) = read.get(&key) {
            return Arc::clone(made);
        }
        drop(read);
        let made = self.made(model).map_or_else(|| Arc::clone(model), Arc::new);
        let mut known = self.known.write().unwrap_or_else(PoisonError::into_inner);
        // Two threads may come here at once: the first made counts for both.
        let [_, made] = known.entry(key).or_insert_with(|| [Arc::clone(model), made]);
        Arc::clone(made)
    }

    /// The model with swatches; `None` where it would have as many primitives.
    pub(crate) fn made(&self, model: &Model) -> Option<Model> {
        let can_join = |primitive: &&Primitive| self.slot_to_join(primitive).is_some();
        if model.primitives.iter().filter(can_join).count() < 2 {
            return None;
        }
        let mut joined = Primitive::default();
        let mut slots = Vec::new();
        let mut primitives = Vec::new();
        for primitive in &model.primitives {
            match self.slot_to_join(primitive) {
                Some(slot) => {
                    append(&mut joined, primitive, swatch_place(slot));
                    slots.push(slot);
                }
                None => primitives.push(primitive.clone()),
            }
        }
        slots.sort_unstable();
        slots.dedup();
        joined.material = ModelMaterial::Swatches(slots.into());
        primitives.push(joined);
        Some(Model { primitives })
    }

    /// The slot of a primitive that can be joined with others.
    fn slot_to_join(&self, primitive: &Primitive) -> Option<Slot> {
        let ModelMaterial::Slot(slot) = primitive.material else { return None };
        let can_join = match self.rules[slot as usize] {
            Rule::Always => true,
            Rule::WhenSmall => area(primitive) < LEAST_TEXTURED_AREA,
            Rule::Never => false,
        };
        (can_join && primitive.colors.is_empty()).then_some(slot)
    }
}

/// Where the swatch of a slot is in its image: the middle of its square.
fn swatch_place(slot: Slot) -> [f32; 2] {
    let index = slot as usize;
    let middle = |square: usize| (square as f32 + 0.5) / SWATCHES_PER_SIDE as f32;
    [middle(index % SWATCHES_PER_SIDE), middle(index / SWATCHES_PER_SIDE)]
}

fn append(joined: &mut Primitive, primitive: &Primitive, place: [f32; 2]) {
    let first = u32::try_from(joined.positions.len()).expect("a model has fewer corners");
    joined.positions.extend_from_slice(&primitive.positions);
    joined.normals.extend_from_slice(&primitive.normals);
    joined.texture_coordinates.resize(joined.positions.len(), place);
    joined.indices.extend(primitive.indices.iter().map(|index| first + index));
}

/// Square metres of all triangles.
fn area(primitive: &Primitive) -> f64 {
    let corner = |index: u32| glam::Vec3::from_array(primitive.positions[index as usize]).as_dvec3();
    let of_triangle = |triangle: &[u32]| {
        let [a, b, c] = [corner(triangle[0]), corner(triangle[1]), corner(triangle[2])];
        (b - a).cross(c - a).length() / 2.0
    };
    primitive.indices.chunks_exact(3).map(of_triangle).sum()
}
