//! Merges meshes: all triangles of one material become one primitive, in the frame of the level.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use glam::{DVec3, Vec3};

use super::Shown;
use super::listing::{Drawn, Frame};
use super::options::Coloring;
use crate::mesh::Primitive;
use crate::scene::SceneMaterial;
use crate::texture::average_shade;

/// Triangles of one material. All lists but `indices` have one entry a corner, or none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Merged {
    /// Metres in the frame of the level.
    pub(super) positions: Vec<DVec3>,
    pub(super) normals: Vec<Vec3>,
    /// Sets of texture coordinates, as many as the material needs.
    pub(super) coordinates: Vec<Vec<[f32; 2]>>,
    /// Linear.
    pub(super) colors: Vec<[f32; 4]>,
    /// Indices of features.
    pub(super) features: Vec<usize>,
    /// Three a triangle.
    pub(super) indices: Vec<u32>,
}

/// The look that merged triangles share; the order is that of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Surface {
    /// A material of the scene.
    Material(usize),
    /// Corners have their colours, and nothing shines through.
    Opaque,
    /// Corners have their colours, and what is behind shines through.
    Clear,
}

impl Surface {
    /// The look of a material.
    fn of(shown: &Shown<'_>, material: usize) -> Self {
        match shown.coloring {
            Coloring::Materials => Self::Material(material),
            Coloring::Corners if is_clear(&shown.scene.materials[material]) => Self::Clear,
            Coloring::Corners => Self::Opaque,
        }
    }
}

/// The looks of a mesh: each is a draw call.
pub(super) fn surfaces(shown: &Shown<'_>, mesh: usize) -> BTreeSet<Surface> {
    shown.scene.meshes[mesh].materials.iter().map(|&material| Surface::of(shown, material)).collect()
}

/// White, which multiplies nothing.
const WHITE: [f32; 4] = [1.0; 4];
/// Opacity of glass whose material lets light through by transmission, which few clients draw.
pub(super) const GLASS_OPACITY: f32 = 0.2;

/// Corners of a primitive beyond which another begins: as many as indices of 16 bits count, whose highest restarts a strip.
const MOST_CORNERS: usize = u16::MAX as usize - 1;

/// The triangles of meshes by look, in primitives of which each but a very large one has short indices.
pub(super) fn merge(shown: &Shown<'_>, drawn: &[&Drawn]) -> BTreeMap<Surface, Vec<Merged>> {
    let mut merged: BTreeMap<Surface, Vec<Merged>> = BTreeMap::new();
    for drawn in drawn {
        let Some(model) = &shown.models[drawn.mesh] else { continue };
        let materials = &shown.scene.meshes[drawn.mesh].materials;
        for (primitive, &material) in model.primitives.iter().zip(materials) {
            if primitive.indices.is_empty() {
                continue;
            }
            let source = &shown.scene.materials[material];
            let surface = Surface::of(shown, material);
            let has_colors = shown.coloring == Coloring::Corners;
            let (color, sets) =
                if has_colors { (shown_color(source), 0) } else { (WHITE, coordinate_sets(source)) };
            let known = merged.entry(surface).or_default();
            let has_room = |last: &Merged| last.positions.len() + primitive.positions.len() <= MOST_CORNERS;
            if !known.last().is_some_and(has_room) {
                known.push(Merged::default());
            }
            let Some(into) = known.last_mut() else { continue };
            into.add(primitive, &drawn.frame, drawn.feature);
            into.lay(primitive, sets);
            into.paint(primitive, color, has_colors);
        }
    }
    merged
}

impl Merged {
    /// Makes one of corners that agree in everything.
    pub(super) fn join_corners(&mut self) {
        let mut known: HashMap<Vec<u64>, u32> = HashMap::with_capacity(self.positions.len());
        let mut kept: Vec<usize> = Vec::new();
        let mut new = Vec::with_capacity(self.positions.len());
        for corner in 0..self.positions.len() {
            let key = self.key(corner);
            new.push(*known.entry(key).or_insert_with(|| {
                kept.push(corner);
                kept.len() as u32 - 1
            }));
        }
        self.indices.iter_mut().for_each(|index| *index = new[*index as usize]);
        self.positions = kept.iter().map(|&corner| self.positions[corner]).collect();
        self.normals = kept.iter().map(|&corner| self.normals[corner]).collect();
        self.features = kept.iter().map(|&corner| self.features[corner]).collect();
        if !self.colors.is_empty() {
            self.colors = kept.iter().map(|&corner| self.colors[corner]).collect();
        }
        for set in &mut self.coordinates {
            *set = kept.iter().map(|&corner| set[corner]).collect();
        }
    }

    /// Everything about a corner.
    fn key(&self, corner: usize) -> Vec<u64> {
        let bits = |number: f32| u64::from((number + 0.0).to_bits());
        let mut key: Vec<u64> =
            self.positions[corner].to_array().map(|number| (number + 0.0).to_bits()).to_vec();
        key.extend(self.normals[corner].to_array().map(bits));
        key.extend(self.colors.get(corner).into_iter().flatten().copied().map(bits));
        key.extend(self.coordinates.iter().flat_map(|set| set[corner]).map(bits));
        key.push(self.features[corner] as u64);
        key
    }

    fn add(&mut self, primitive: &Primitive, frame: &Frame, feature: usize) {
        let first =
            u32::try_from(self.positions.len()).expect("a level has fewer corners than 32 bits count");
        let place = |&corner: &[f32; 3]| frame.point(Vec3::from_array(corner).as_dvec3());
        self.positions.extend(primitive.positions.iter().map(place));
        let turn = |&normal: &[f32; 3]| (frame.rotation * Vec3::from_array(normal).as_dvec3()).as_vec3();
        self.normals.extend(primitive.normals.iter().map(turn));
        self.features.resize(self.positions.len(), feature);
        self.indices.extend(primitive.indices.iter().map(|index| first + index));
    }

    /// The texture coordinates of what was added last.
    fn lay(&mut self, primitive: &Primitive, sets: usize) {
        self.coordinates.resize(sets.max(self.coordinates.len()), Vec::new());
        let own: Vec<&[[f32; 2]]> = primitive.coordinate_sets().collect();
        let count = self.positions.len();
        for (index, set) in self.coordinates.iter_mut().enumerate() {
            let before = count - primitive.positions.len();
            set.resize(before, [0.0; 2]);
            set.extend_from_slice(own.get(index).copied().unwrap_or_default());
            set.resize(count, [0.0; 2]);
        }
    }

    /// The colours of what was added last.
    fn paint(&mut self, primitive: &Primitive, color: [f32; 4], is_always: bool) {
        let count = self.positions.len();
        let has_own = primitive.colors.len() == primitive.positions.len();
        if !(is_always || has_own || !self.colors.is_empty()) {
            return;
        }
        self.colors.resize(count - primitive.positions.len(), WHITE);
        if has_own {
            let times = |own: &[f32; 4]| [0, 1, 2, 3].map(|channel| own[channel] * color[channel]);
            self.colors.extend(primitive.colors.iter().map(times));
        }
        self.colors.resize(count, color);
    }
}

/// How many sets of texture coordinates a material needs.
fn coordinate_sets(material: &SceneMaterial) -> usize {
    material.textures().iter().map(|(_, texture)| texture.coordinate_set + 1).max().unwrap_or(0)
}

/// Whether something shines through.
fn is_clear(material: &SceneMaterial) -> bool {
    let factors = factors(material);
    factors.transmission > 0.0 || factors.base_color[3] < 1.0
}

fn factors(material: &SceneMaterial) -> &crate::mesh::Material {
    match material {
        SceneMaterial::Slot { material, .. } => material,
        SceneMaterial::Own(own) => &own.material,
    }
}

/// The colour of a surface without its images: its own as bright as its texture is on average, and the light that it gives.
fn shown_color(material: &SceneMaterial) -> [f32; 4] {
    let factors = factors(material);
    let [red, green, blue, opacity] = factors.base_color;
    let shade = factors.texture.map_or(1.0, average_shade);
    let lit = |base: f32, light: f32| (base * shade + light).min(1.0);
    let [r, g, b] = factors.emissive;
    let opacity = if factors.transmission > 0.0 { GLASS_OPACITY } else { opacity };
    [lit(red, r), lit(green, g), lit(blue, b), opacity]
}
