//! Meshes and materials of a scene, each once.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::node::{ModelKey, SceneMaterial, SceneMesh};
use super::shell::Shape;
use crate::catalog::{Catalog, ClassIndex, DEFAULT_STYLE, MATERIAL_SLOTS, Material};
use crate::model::{Model, ModelMaterial, OwnMaterial};

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
    /// Kept here too, so that one model is one allocation in a scene whatever the source does.
    built: BTreeMap<(ClassIndex, u32, &'a str), Arc<Model>>,
    furniture: BTreeMap<(ClassIndex, u32, Look<'a>), usize>,
    shapes: BTreeMap<Shape, (usize, Arc<Model>)>,
    shells: BTreeMap<(usize, &'a str), usize>,
    slots: BTreeMap<(&'a str, &'static str), usize>,
}

/// What is drawn where a palette lacks a slot, which a checked catalogue never does: middle grey.
const NEUTRAL: Material = Material {
    base_color: [0.5, 0.5, 0.5, 1.0],
    metallic: 0.0,
    roughness: 0.8,
    emissive: [0.0; 3],
    transmission: 0.0,
};

impl<'a> MeshTable<'a> {
    pub(crate) fn new(catalog: &'a Catalog, models: &'a ModelSourceFunction<'a>) -> Self {
        Self {
            catalog,
            models,
            meshes: Vec::new(),
            materials: Vec::new(),
            built: BTreeMap::new(),
            furniture: BTreeMap::new(),
            shapes: BTreeMap::new(),
            shells: BTreeMap::new(),
            slots: BTreeMap::new(),
        }
    }

    /// Meshes and materials in the order of first use.
    pub(crate) fn finish(self) -> (Vec<SceneMesh>, Vec<SceneMaterial>) {
        (self.meshes, self.materials)
    }

    /// The mesh of a variant of a class.
    pub(crate) fn furniture(&mut self, class: ClassIndex, variant: u32, look: Look<'a>) -> usize {
        if let Some(&mesh) = self.furniture.get(&(class, variant, look)) {
            return mesh;
        }
        let models = self.models;
        let built = self.built.entry((class, variant, look.geometry));
        let model = Arc::clone(built.or_insert_with(|| models(class, variant, look.geometry)));
        let id = &self.catalog.classes[class].id;
        let name = format!("{id}.{variant}@{}/{}", look.geometry, look.palette);
        let key = ModelKey { class: id.clone(), variant, geometry: look.geometry.to_owned() };
        let mesh = self.push(name, model, look.palette, Some(key));
        self.furniture.insert((class, variant, look), mesh);
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
        let mesh = self.push(node.to_owned(), model, palette, None);
        self.shells.insert((number, palette), mesh);
        Some(mesh)
    }

    fn push(&mut self, name: String, model: Arc<Model>, palette: &'a str, key: Option<ModelKey>) -> usize {
        let materials = model
            .primitives
            .iter()
            .map(|primitive| match &primitive.material {
                ModelMaterial::Slot(slot) => self.slot(palette, slot),
                ModelMaterial::Own(own) => self.own(own),
            })
            .collect();
        self.meshes.push(SceneMesh { name, model, materials, key });
        self.meshes.len() - 1
    }

    fn slot(&mut self, palette: &'a str, slot: &'static str) -> usize {
        let (catalog, materials) = (self.catalog, &mut self.materials);
        *self.slots.entry((palette, slot)).or_insert_with(|| {
            let found = catalog.palettes.get(palette).and_then(|palette| palette.materials.get(slot));
            let material = found.cloned().unwrap_or(NEUTRAL);
            materials.push(SceneMaterial::Slot { name: format!("{palette}.{slot}"), material });
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
