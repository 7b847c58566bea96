//! Meshes and materials of a scene, each once.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::SceneInput;
use super::light::{SceneLight, scene_light};
use super::node::{ModelKey, Node, Scene, SceneMaterial, SceneMesh, SceneVariant};
use super::shell::Shape;
use super::tint::Tint;
use crate::catalog::{Catalog, ClassIndex, DEFAULT_STYLE, Light, MATERIAL_SLOTS, Material};
use crate::model::{Model, ModelMaterial, OwnMaterial, Primitive};
use crate::texture::TextureLibrary;

/// How a room's style looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Look<'a> {
    /// Geometry set.
    pub geometry: &'a str,
    /// Palette.
    pub palette: &'a str,
}

impl<'a> Look<'a> {
    /// The look of a style; that of the default style where the catalogue does not know the name.
    pub(crate) fn of_style(catalog: &'a Catalog, style: &str) -> Self {
        let style = catalog.styles.get(style).or_else(|| catalog.styles.get(DEFAULT_STYLE));
        style.map_or(Self { geometry: "", palette: "" }, |style| Self {
            geometry: &style.geometry,
            palette: &style.palette,
        })
    }
}

/// Builds and looks up models: class, variant, geometry set.
pub type ModelSourceFunction<'a> = dyn Fn(ClassIndex, u32, &str) -> Arc<Model> + Sync + 'a;

/// Hands out mesh indices; equal requests get the same one.
pub(crate) struct MeshTable<'a> {
    catalog: &'a Catalog,
    models: &'a ModelSourceFunction<'a>,
    meshes: Vec<SceneMesh>,
    materials: Vec<SceneMaterial>,
    lights: Vec<SceneLight>,
    /// Kept here too, so that one model is one allocation in a scene whatever the source does.
    built: BTreeMap<(ClassIndex, u32, &'a str), Arc<Model>>,
    textures: Option<&'a TextureLibrary>,
    has_lights: bool,
    has_variants: bool,
    furniture: BTreeMap<(ClassIndex, u32, Look<'a>), Vec<usize>>,
    shapes: BTreeMap<Shape, (usize, Arc<Model>)>,
    shells: BTreeMap<(usize, &'a str), usize>,
    /// By palette, slot and tint.
    slots: BTreeMap<(&'a str, &'static str, usize), usize>,
}

/// What is drawn where a palette lacks a slot, which a checked catalogue never does: middle grey.
const NEUTRAL: Material = Material {
    base_color: [0.5, 0.5, 0.5, 1.0],
    metallic: 0.0,
    roughness: 0.8,
    emissive: [0.0; 3],
    emissive_strength: 1.0,
    transmission: 0.0,
    texture: None,
    tints: Vec::new(),
};

impl<'a> MeshTable<'a> {
    pub(crate) fn new(input: &SceneInput<'a>) -> Self {
        Self {
            catalog: input.catalog,
            models: input.models,
            textures: input.textures,
            has_lights: input.options.has_lights,
            has_variants: input.options.has_variants,
            meshes: Vec::new(),
            materials: Vec::new(),
            lights: Vec::new(),
            built: BTreeMap::new(),
            furniture: BTreeMap::new(),
            shapes: BTreeMap::new(),
            shells: BTreeMap::new(),
            slots: BTreeMap::new(),
        }
    }

    /// The scene of a tree, its meshes, materials and lights in the order of first use.
    pub(crate) fn finish(mut self, root: Node) -> Scene {
        let variants = if self.has_variants { self.variants() } else { Vec::new() };
        let Self { meshes, materials, lights, .. } = self;
        Scene { root, meshes, materials, lights, variants }
    }

    /// What every slot in use looks like in each palette: a tint goes to the tint of the same number, as far as there
    /// are as many.
    fn variants(&mut self) -> Vec<SceneVariant> {
        let (catalog, in_use) = (self.catalog, self.slots.clone());
        let variant = |palette: &'a str| {
            let replacement =
                |(&(_, slot, number), &material)| (material, self.slot_of_number(palette, slot, number));
            SceneVariant { name: palette.to_owned(), materials: in_use.iter().map(replacement).collect() }
        };
        catalog.palettes.keys().map(String::as_str).map(variant).collect()
    }

    /// The light of a lamp; there are few kinds, and equal ones are found by looking at all.
    pub(crate) fn light(&mut self, light: &Light) -> usize {
        let made = scene_light(light);
        self.lights.iter().position(|known| *known == made).unwrap_or_else(|| {
            self.lights.push(made);
            self.lights.len() - 1
        })
    }

    /// The mesh of a variant of a class in a tint; tints that come to the same colours share one.
    pub(crate) fn furniture(&mut self, class: ClassIndex, variant: u32, look: Look<'a>, tint: Tint) -> usize {
        let models = self.models;
        let built = self.built.entry((class, variant, look.geometry));
        let model = Arc::clone(built.or_insert_with(|| models(class, variant, look.geometry)));
        let materials = self.materials_of(&model, look.palette, tint);
        let known = self.furniture.get(&(class, variant, look)).map_or(&[][..], Vec::as_slice);
        if let Some(&mesh) = known.iter().find(|&&mesh| self.meshes[mesh].materials == materials) {
            return mesh;
        }
        let id = &self.catalog.classes[class].id;
        // The first keeps the plain name, the others count on.
        let suffix = if known.is_empty() { String::new() } else { format!("#{}", known.len() + 1) };
        let name = format!("{id}.{variant}@{}/{}{suffix}", look.geometry, look.palette);
        let key = ModelKey { class: id.clone(), variant, geometry: look.geometry.to_owned() };
        self.meshes.push(SceneMesh { name, model, materials, key: Some(key) });
        let mesh = self.meshes.len() - 1;
        self.furniture.entry((class, variant, look)).or_default().push(mesh);
        mesh
    }

    /// The mesh of a shell part, named after the first node that uses it; `None` if it has no triangles.
    pub(crate) fn shell(&mut self, shape: Shape, palette: &'a str, node: &str) -> Option<usize> {
        let (number, model) = match self.shapes.get(&shape) {
            Some((number, model)) => (*number, Arc::clone(model)),
            None => {
                let entry = (self.shapes.len(), Arc::new(shape.build()));
                self.shapes.insert(shape, entry.clone());
                entry
            }
        };
        if model.primitives.is_empty() {
            return None;
        }
        if let Some(&mesh) = self.shells.get(&(number, palette)) {
            return Some(mesh);
        }
        let materials = self.materials_of(&model, palette, Tint::default());
        self.meshes.push(SceneMesh { name: node.to_owned(), model, materials, key: None });
        let mesh = self.meshes.len() - 1;
        self.shells.insert((number, palette), mesh);
        Some(mesh)
    }

    fn materials_of(&mut self, model: &Model, palette: &'a str, tint: Tint) -> Vec<usize> {
        let primitives = model.primitives.iter();
        let material = |primitive: &Primitive| match &primitive.material {
            ModelMaterial::Slot(slot) => self.slot(palette, slot, tint),
            ModelMaterial::Own(own) => self.own(own),
        };
        primitives.map(material).collect()
    }

    fn slot(&mut self, palette: &'a str, slot: &'static str, tint: Tint) -> usize {
        let found = self.catalog.palettes.get(palette).and_then(|palette| palette.materials.get(slot));
        self.slot_of_number(palette, slot, found.map_or(0, |material| tint.pick(material.tints.len())))
    }

    fn slot_of_number(&mut self, palette: &'a str, slot: &'static str, number: usize) -> usize {
        let (catalog, materials) = (self.catalog, &mut self.materials);
        let found = catalog.palettes.get(palette).and_then(|palette| palette.materials.get(slot));
        let number = number.min(found.map_or(0, |material| material.tints.len()));
        let (textures, has_lights) = (self.textures, self.has_lights);
        *self.slots.entry((palette, slot, number)).or_insert_with(|| {
            let mut material = found.cloned().unwrap_or(NEUTRAL);
            if !has_lights {
                material.emissive_strength = 1.0;
            }
            let mut name = format!("{palette}.{slot}");
            if number > 0 {
                material.base_color = material.tints[number - 1];
                name += &format!(".{number}");
            }
            let images = textures.zip(material.texture).map(|(library, surface)| library.textures(surface));
            let textures = images.unwrap_or_default().to_vec();
            materials.push(SceneMaterial::Slot { name, material, textures });
            materials.len() - 1
        })
    }

    /// Own materials are few: equal ones are found by looking at all.
    fn own(&mut self, own: &Arc<OwnMaterial>) -> usize {
        let known = self.materials.iter().position(|material| match material {
            SceneMaterial::Own(other) => Arc::ptr_eq(own, other) || own == other,
            SceneMaterial::Slot { .. } => false,
        });
        known.unwrap_or_else(|| {
            self.materials.push(SceneMaterial::Own(Arc::clone(own)));
            self.materials.len() - 1
        })
    }
}

/// The fixed name of a material slot; `fallback` for words that are none.
pub(crate) fn slot_named(word: &str, fallback: &'static str) -> &'static str {
    MATERIAL_SLOTS.iter().find(|slot| **slot == word).copied().unwrap_or(fallback)
}
