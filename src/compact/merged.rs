//! Merges meshes: all triangles of one material become one primitive, in the frame of the level.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{DVec3, Vec3};
use hashbrown::HashMap;

use super::Shown;
use super::coarse::Seen;
use super::image_colors::{ImageColors, KnownImages};
use super::listing::{Drawn, Frame};
use super::options::Coloring;
use crate::mesh::{Primitive, TextureUse};
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
    pub(super) fn of(shown: &Shown<'_>, material: usize) -> Self {
        match shown.coloring {
            Coloring::Materials => Self::Material(material),
            Coloring::Corners if is_clear(&shown.materials[material]) => Self::Clear,
            Coloring::Corners => Self::Opaque,
        }
    }
}

/// The looks of a mesh in the order of its primitives, each once: each is a draw call.
pub(super) fn ordered_surfaces(shown: &Shown<'_>, mesh: usize) -> Vec<Surface> {
    let mut found = Vec::new();
    for &material in &shown.scene.meshes[mesh].materials {
        let surface = Surface::of(shown, material);
        if !found.contains(&surface) {
            found.push(surface);
        }
    }
    found
}

/// All that the arrays of a mesh depend on besides its model; `None` where that is an image.
pub(super) fn looks_of(shown: &Shown<'_>, mesh: usize) -> Option<Vec<u32>> {
    let order = ordered_surfaces(shown, mesh);
    let mut looks = Vec::new();
    for &material in &shown.scene.meshes[mesh].materials {
        let surface = Surface::of(shown, material);
        let group = order.iter().position(|known| *known == surface).unwrap_or(0);
        looks.push(group as u32);
        let source = &shown.materials[material];
        match shown.coloring {
            Coloring::Materials => looks.push(source.coordinate_set_count() as u32),
            Coloring::Corners => {
                let color = ShownColor::of(source, shown.images);
                if color.image.is_some() {
                    return None;
                }
                looks.extend(color.color.map(f32::to_bits));
            }
        }
    }
    Some(looks)
}

/// Numbers of a corner: place, normal, colour, texture coordinates, feature.
const KEY_NUMBERS: usize = 13;

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
        let Some(Seen { model, .. }) = &shown.models[drawn.mesh] else { continue };
        let materials = &shown.scene.meshes[drawn.mesh].materials;
        for (primitive, &material) in model.primitives.iter().zip(materials) {
            if primitive.indices.is_empty() {
                continue;
            }
            let source = &shown.materials[material];
            let surface = Surface::of(shown, material);
            let has_colors = shown.coloring == Coloring::Corners;
            let sets = if has_colors { 0 } else { source.coordinate_set_count() };
            let color = if has_colors { ShownColor::of(source, shown.images) } else { ShownColor::PLAIN };
            let known = merged.entry(surface).or_default();
            let has_room = |last: &Merged| last.positions.len() + primitive.positions.len() <= MOST_CORNERS;
            if !known.last().is_some_and(has_room) {
                known.push(Merged::default());
            }
            let Some(into) = known.last_mut() else { continue };
            into.add(primitive, &drawn.frame, drawn.feature);
            into.lay(primitive, sets);
            into.paint(primitive, &color, has_colors);
        }
    }
    merged.values_mut().flatten().for_each(Merged::join_corners);
    merged
}

impl Merged {
    /// Makes one of corners that agree in everything; those with several sets of texture coordinates stay as they are.
    fn join_corners(&mut self) {
        if self.coordinates.len() > 1 {
            return;
        }
        let mut known: HashMap<[u32; KEY_NUMBERS], u32> = HashMap::with_capacity(self.positions.len());
        let mut kept: Vec<usize> = Vec::new();
        let mut new = Vec::with_capacity(self.positions.len());
        for corner in 0..self.positions.len() {
            new.push(*known.entry(self.key(corner)).or_insert_with(|| {
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
    fn key(&self, corner: usize) -> [u32; KEY_NUMBERS] {
        let bits = |number: f32| (number + 0.0).to_bits();
        let [x, y, z] = self.positions[corner].as_vec3().to_array().map(bits);
        let [i, j, k] = self.normals[corner].to_array().map(bits);
        let [red, green, blue, opacity] = self.colors.get(corner).copied().unwrap_or_default().map(bits);
        let [u, v] = self.coordinates.first().map_or([0.0; 2], |set| set[corner]).map(bits);
        [x, y, z, i, j, k, red, green, blue, opacity, u, v, self.features[corner] as u32]
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
    fn paint(&mut self, primitive: &Primitive, color: &ShownColor, is_always: bool) {
        let count = self.positions.len();
        let has_own = primitive.colors.len() == primitive.positions.len();
        if !(is_always || has_own || !self.colors.is_empty()) {
            return;
        }
        let first = count - primitive.positions.len();
        self.colors.resize(first, WHITE);
        self.colors.extend((0..primitive.positions.len()).map(|corner| color.at(primitive, corner)));
    }
}

/// The colour of a material without its images.
pub(super) struct ShownColor {
    /// As bright as the texture of its surface is on average, with the light that it gives added.
    color: [f32; 4],
    /// Those that multiply it, by the set of texture coordinates.
    image: Option<(Arc<ImageColors>, usize)>,
}

impl ShownColor {
    const PLAIN: Self = Self { color: WHITE, image: None };

    pub(super) fn of(material: &SceneMaterial, images: &KnownImages) -> Self {
        let factors = factors(material);
        let [red, green, blue, opacity] = factors.base_color;
        let shade = factors.texture.map_or(1.0, average_shade);
        let lit = |base: f32, light: f32| (base * shade + light).min(1.0);
        let [r, g, b] = factors.emissive;
        let opacity = if factors.transmission > 0.0 { GLASS_OPACITY } else { opacity };
        let base = material.textures().iter().find(|(purpose, _)| *purpose == TextureUse::BaseColor);
        let image =
            base.and_then(|(_, texture)| Some((images.colors(&texture.image)?, texture.coordinate_set)));
        Self { color: [lit(red, r), lit(green, g), lit(blue, b), opacity], image }
    }

    /// The colour that corners have but for their own; `None` where that depends on an image.
    pub(super) fn plain(&self) -> Option<[f32; 4]> {
        self.image.is_none().then_some(self.color)
    }

    /// The colour of a corner.
    pub(super) fn at(&self, primitive: &Primitive, corner: usize) -> [f32; 4] {
        let own = primitive.colors.get(corner).copied().unwrap_or(WHITE);
        let image = self.image.as_ref().map_or(WHITE, |(image, set)| {
            let place = primitive.coordinate_sets().nth(*set).and_then(|set| set.get(corner));
            image.at(place.copied().unwrap_or_default())
        });
        [0, 1, 2, 3].map(|channel| self.color[channel] * own[channel] * image[channel])
    }
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
