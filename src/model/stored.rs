//! Models of recipes as a cache keeps them.

use serde::{Deserialize, Serialize};

use super::{Model, ModelMaterial, Primitive};
use crate::catalog::MATERIAL_SLOTS;

/// A [`Model`] whose materials are all slots, in a form that can be written and read.
#[derive(Serialize, Deserialize)]
pub(super) struct StoredModel(Vec<StoredPrimitive>);

/// A [`Primitive`]; see there.
#[derive(Serialize, Deserialize)]
struct StoredPrimitive {
    /// Position in [`MATERIAL_SLOTS`].
    slot: usize,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    texture_coordinates: Vec<[f32; 2]>,
    colors: Vec<[f32; 4]>,
    indices: Vec<u32>,
}

impl From<Model> for StoredModel {
    /// # Panics
    /// If a material is of a user's file, which no recipe has.
    fn from(model: Model) -> Self {
        let primitive = |primitive: Primitive| {
            let ModelMaterial::Slot(word) = primitive.material else { unreachable!("recipes use slots") };
            let slot = MATERIAL_SLOTS.iter().position(|slot| *slot == word);
            StoredPrimitive {
                slot: slot.expect("recipes name slots that there are"),
                positions: primitive.positions,
                normals: primitive.normals,
                texture_coordinates: primitive.texture_coordinates,
                colors: primitive.colors,
                indices: primitive.indices,
            }
        };
        Self(model.primitives.into_iter().map(primitive).collect())
    }
}

impl From<StoredModel> for Model {
    fn from(stored: StoredModel) -> Self {
        let primitive = |primitive: StoredPrimitive| Primitive {
            material: MATERIAL_SLOTS
                .get(primitive.slot)
                .map_or_else(ModelMaterial::default, |slot| ModelMaterial::Slot(slot)),
            positions: primitive.positions,
            normals: primitive.normals,
            texture_coordinates: primitive.texture_coordinates,
            further_coordinates: Vec::new(),
            colors: primitive.colors,
            indices: primitive.indices,
        };
        Self { primitives: stored.0.into_iter().map(primitive).collect() }
    }
}
