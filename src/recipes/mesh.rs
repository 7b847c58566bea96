//! The result of a recipe: triangles by material slot.

use serde::{Deserialize, Serialize};

use super::slot::Slot;

/// Triangles by material slot, at least one part.
///
/// Frame: glTF's, metres, Y up; origin in the middle of the underside of the box that was asked for, front at +Z, width
/// along X. Every corner lies in the box to 1 mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    /// One for each slot, in the order of first use.
    pub parts: Vec<MeshPart>,
}

/// Triangles of one material slot; counter-clockwise seen from outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeshPart {
    /// Its material, as far as a recipe knows: palettes say what the slot looks like.
    pub slot: Slot,
    /// Corners.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals, one per position.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates, one per position.
    pub texture_coordinates: Vec<[f32; 2]>,
    /// Three per triangle.
    pub indices: Vec<u32>,
}

impl MeshPart {
    /// No triangles yet.
    pub(super) fn empty(slot: Slot) -> Self {
        let [positions, normals] = [Vec::new(), Vec::new()];
        Self { slot, positions, normals, texture_coordinates: Vec::new(), indices: Vec::new() }
    }
}
