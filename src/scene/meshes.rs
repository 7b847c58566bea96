//! The meshes and materials of a scene, each once.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::input::{ModelSourceFunction, SceneInput};
use super::light::scene_light;
use super::node::{ModelKey, Node, Scene, SceneLight, SceneMaterial, SceneMesh, SceneVariant};
use super::options::Lights;
use super::shell::{MergedKey, Shape};
use super::tint::Tint;
use crate::catalog::{Catalog, Light, Material, PaletteRef, StyleRef, VariantRef};
use crate::contract::{VariantId, model_name};
use crate::model::{Model, ModelMaterial, OwnMaterial, Primitive, SwatchedModels};
use crate::recipes::{GeometrySet, Slot};
use crate::texture::{SurfaceUse, TextureLibrary, swatch_textures};

/// How a room's style looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Look {
    /// Geometry set.
    pub geometry: GeometrySet,
    /// Palette.
    pub palette: PaletteRef,
}

impl Look {
    /// The look of a style of the catalogue.
    pub(crate) fn of_style(catalog: &Catalog, style: StyleRef) -> Self {
        let style = &catalog.styles[style];
        Self { geometry: style.geometry, palette: style.palette }
    }
}

/// Hands out mesh indices; equal requests get the same one.
pub(crate) struct MeshTable<'a> {
    catalog: &'a Catalog,
    models: &'a ModelSourceFunction<'a>,
    meshes: Vec<SceneMesh>,
    materials: Vec<SceneMaterial>,
    lights: Vec<SceneLight>,
    /// Kept here too, so that one model is one allocation in a scene whatever the source does.
    built: BTreeMap<(VariantRef, GeometrySet), Arc<Model>>,
    textures: Option<&'a TextureLibrary>,
    /// Models whose plain parts share a material; none where every slot keeps its material.
    swatches_of: Option<&'a SwatchedModels>,
    lights_mode: Lights,
    has_variants: bool,
    furniture: BTreeMap<(VariantRef, Look), Vec<usize>>,
    shapes: BTreeMap<Shape, (usize, Arc<Model>)>,
    shells: BTreeMap<(usize, PaletteRef), usize>,
    merged: BTreeMap<(MergedKey, PaletteRef), usize>,
    /// By palette, slot and tint.
    slots: BTreeMap<(PaletteRef, Slot, usize), usize>,
    /// By palette, the number that all slots are tinted by, and whether they give light.
    swatches: BTreeMap<(PaletteRef, usize, bool), usize>,
}

/// How much brighter what gives pure white light is drawn where nothing else lights a room in renderers without surroundings
/// of their own, as Blender's are at first; what shines more faintly, as shades of cloth do, in proportion. Tuned on rendered
/// rooms (docs/viewers.md): at half of it Blender's rooms are dim, at twice as much the ceiling around lamps is bleached. Viewers
/// with surroundings draw lamps white from a strength of about 2 on, so that more does not change them.
const SHINING_GAIN: f32 = 25.0;

/// Numbers that are looked through for the colours of several slots: palettes with up to four tints a slot repeat after 60.
const MOST_SWATCHES: u32 = 60;

/// The factors of materials that images colour alone.
const WHITE: Material = Material {
    base_color: [1.0; 4],
    metallic: 1.0,
    roughness: 1.0,
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
            swatches_of: input.swatches,
            lights_mode: input.options.lights,
            has_variants: input.options.has_variants,
            meshes: Vec::new(),
            materials: Vec::new(),
            lights: Vec::new(),
            built: BTreeMap::new(),
            furniture: BTreeMap::new(),
            shapes: BTreeMap::new(),
            shells: BTreeMap::new(),
            merged: BTreeMap::new(),
            slots: BTreeMap::new(),
            swatches: BTreeMap::new(),
        }
    }

    /// The scene of a tree, its meshes, materials and lights in the order of first use.
    pub(crate) fn finish(mut self, root: Node) -> Scene {
        let variants = if self.has_variants { self.variants() } else { Vec::new() };
        self.paint(&variants);
        let Self { meshes, materials, lights, .. } = self;
        Scene { root, meshes, materials, lights, variants, copyright: None }
    }

    /// Gives each slot the images of its surface, now that it is known whether that is seen on more than furniture.
    fn paint(&mut self, variants: &[SceneVariant]) {
        let Some(library) = self.textures else { return };
        let shell = self.meshes.iter().filter(|mesh| !mesh.is_shared());
        let shown = shell.flat_map(|mesh| &mesh.materials).flat_map(|material| {
            let others = variants.iter().filter_map(|variant| variant.materials.get(material));
            others.chain([material])
        });
        let of_rooms: BTreeSet<&'static str> =
            shown.filter_map(|&material| self.materials[material].surface()).collect();
        for one in &mut self.materials {
            let surface = one.surface();
            if let (SceneMaterial::Slot { textures, .. }, Some(surface)) = (one, surface) {
                let is_of_room = of_rooms.contains(surface);
                let covered = if is_of_room { SurfaceUse::Room } else { SurfaceUse::Furniture };
                *textures = library.textures(surface, covered).to_vec();
            }
        }
    }

    /// The material of every slot in use in each palette: a tint becomes the tint of the same number, as far as there
    /// are as many.
    fn variants(&mut self) -> Vec<SceneVariant> {
        let (catalog, slots, swatches) = (self.catalog, self.slots.clone(), self.swatches.clone());
        let variant = |palette: PaletteRef| {
            let of_slot =
                |(&(_, slot, number), &material)| (material, self.slot_of_number(palette, slot, number));
            let mut materials: BTreeMap<usize, usize> = slots.iter().map(of_slot).collect();
            let of_swatches = |(&(_, number, is_lit), &material)| {
                (material, self.swatches_of_number(palette, number, is_lit))
            };
            materials.extend(swatches.iter().map(of_swatches));
            SceneVariant { name: catalog.palettes[palette].id.clone(), materials }
        };
        catalog.palettes.refs().map(variant).collect()
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
    pub(crate) fn furniture(&mut self, of: VariantRef, look: Look, tint: Tint) -> usize {
        let models = self.models;
        let built = self.built.entry((of, look.geometry));
        let swatches = self.swatches_of;
        let model = Arc::clone(built.or_insert_with(|| {
            let model = models(of, look.geometry);
            swatches.map_or_else(|| Arc::clone(&model), |swatched| swatched.of(&model))
        }));
        let materials = self.materials_of(&model, look.palette, tint);
        let known = self.furniture.get(&(of, look)).map_or(&[][..], Vec::as_slice);
        if let Some(&mesh) = known.iter().find(|&&mesh| self.meshes[mesh].materials == materials) {
            return mesh;
        }
        let class = self.catalog.classes[of.class].id.clone();
        let variant = VariantId { class, number: of.variant };
        let palette = &self.catalog.palettes[look.palette].id;
        let name = model_name(&variant, look.geometry.name(), palette, known.len() + 1);
        let key = ModelKey { variant, geometry: look.geometry };
        self.meshes.push(SceneMesh { name, model, materials, key: Some(key) });
        let mesh = self.meshes.len() - 1;
        self.furniture.entry((of, look)).or_default().push(mesh);
        mesh
    }

    /// The number of a shape of the shell and what it looks like; equal shapes have one number and are built once.
    pub(crate) fn shape(&mut self, shape: Shape) -> (usize, Arc<Model>) {
        if let Some(known) = self.shapes.get(&shape) {
            return known.clone();
        }
        let made = (self.shapes.len(), Arc::new(shape.build()));
        self.shapes.insert(shape, made.clone());
        made
    }

    /// The mesh of a shell part, named after the first node that uses it; `None` if it has no triangles.
    pub(crate) fn shell(&mut self, shape: Shape, palette: PaletteRef, node: &str) -> Option<usize> {
        let (number, model) = self.shape(shape);
        if model.primitives.is_empty() {
            return None;
        }
        if let Some(&mesh) = self.shells.get(&(number, palette)) {
            return Some(mesh);
        }
        let model = self.swatches_of.map_or_else(|| Arc::clone(&model), |swatched| swatched.of(&model));
        let mesh = self.shell_mesh(model, palette, node);
        self.shells.insert((number, palette), mesh);
        Some(mesh)
    }

    /// The mesh of several shell parts in a palette, named after the first node that shows it.
    pub(crate) fn merged(
        &mut self,
        key: (MergedKey, PaletteRef),
        node: &str,
        build: impl FnOnce() -> Model,
    ) -> usize {
        if let Some(&mesh) = self.merged.get(&key) {
            return mesh;
        }
        let model = build();
        let swatched = self.swatches_of.and_then(|swatched| swatched.made(&model));
        let mesh = self.shell_mesh(Arc::new(swatched.unwrap_or(model)), key.1, node);
        self.merged.insert(key, mesh);
        mesh
    }

    fn shell_mesh(&mut self, model: Arc<Model>, palette: PaletteRef, node: &str) -> usize {
        let materials = self.materials_of(&model, palette, Tint::default());
        self.meshes.push(SceneMesh { name: node.to_owned(), model, materials, key: None });
        self.meshes.len() - 1
    }

    fn materials_of(&mut self, model: &Model, palette: PaletteRef, tint: Tint) -> Vec<usize> {
        let primitives = model.primitives.iter();
        let material = |primitive: &Primitive| match &primitive.material {
            ModelMaterial::Slot(slot) => self.slot(palette, *slot, tint),
            ModelMaterial::Swatches(slots) => self.swatches(palette, slots, tint),
            ModelMaterial::Own(own) => self.own(own),
        };
        primitives.map(material).collect()
    }

    fn slot(&mut self, palette: PaletteRef, slot: Slot, tint: Tint) -> usize {
        self.slot_of_number(palette, slot, tint.pick(self.tint_count(palette, slot)))
    }

    fn slot_of_number(&mut self, palette: PaletteRef, slot: Slot, number: usize) -> usize {
        let (catalog, materials) = (self.catalog, &mut self.materials);
        let own = material_of(catalog, palette, slot);
        let number = number.min(own.tints.len());
        let lights = self.lights_mode;
        *self.slots.entry((palette, slot, number)).or_insert_with(|| {
            let mut name = format!("{}.{slot}", catalog.palettes[palette].id);
            if number > 0 {
                name += &format!(".{number}");
            }
            let material = shown(own, number, lights);
            materials.push(SceneMaterial::Slot { name, material, textures: Vec::new() });
            materials.len() - 1
        })
    }

    /// The swatches of a palette as an object of a tint shows them. Of the numbers by which its slots have these colours the
    /// lowest counts, so that objects that look alike share one material.
    fn swatches(&mut self, palette: PaletteRef, slots: &[Slot], tint: Tint) -> usize {
        let counts: Vec<usize> = slots.iter().map(|&slot| self.tint_count(palette, slot)).collect();
        let is_alike = |number: &u32| {
            counts.iter().all(|&count| Tint::of_number(*number).pick(count) == tint.pick(count))
        };
        let number = (0..MOST_SWATCHES).find(is_alike).unwrap_or(0);
        let is_lit = slots.iter().any(|&slot| material_of(self.catalog, palette, slot).emissive != [0.0; 3]);
        self.swatches_of_number(palette, number as usize, is_lit)
    }

    fn tint_count(&self, palette: PaletteRef, slot: Slot) -> usize {
        material_of(self.catalog, palette, slot).tints.len()
    }

    /// Those of lamps have an image of their light too.
    fn swatches_of_number(&mut self, palette: PaletteRef, number: usize, is_lit: bool) -> usize {
        let (catalog, lights, materials) = (self.catalog, self.lights_mode, &mut self.materials);
        *self.swatches.entry((palette, number, is_lit)).or_insert_with(|| {
            let lit = if is_lit { ".lit" } else { "" };
            let mut name = format!("{}.swatches{lit}", catalog.palettes[palette].id);
            if number > 0 {
                name += &format!(".{number}");
            }
            let tint = Tint::of_number(u32::try_from(number).unwrap_or(0));
            let of_slot = |slot: Slot| {
                let own = material_of(catalog, palette, slot);
                shown(own, tint.pick(own.tints.len()), lights)
            };
            let (textures, strength) = swatch_textures(&name, is_lit, of_slot);
            let emissive = if is_lit { [1.0; 3] } else { [0.0; 3] };
            let material = Material { emissive, emissive_strength: strength, ..WHITE };
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

/// The material of a slot: the catalogue's palettes have every slot.
fn material_of(catalog: &Catalog, palette: PaletteRef, slot: Slot) -> &Material {
    &catalog.palettes[palette].materials[&slot]
}

/// A slot of a palette in one of its colours, 0 for its own, as bright as lamps are lit.
fn shown(slot: &Material, number: usize, lights: Lights) -> Material {
    let mut material = slot.clone();
    match lights {
        Lights::Shining if material.emissive_strength > 1.0 => {
            let brightest = material.emissive.into_iter().fold(0.0, f32::max);
            material.emissive_strength *= (SHINING_GAIN * brightest).max(1.0);
        }
        Lights::Off => material.emissive_strength = 1.0,
        Lights::Shining | Lights::Physical => {}
    }
    if let Some(&tint) = number.checked_sub(1).and_then(|tint| material.tints.get(tint)) {
        material.base_color = tint;
    }
    material
}
