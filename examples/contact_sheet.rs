//! Writes all recipes side by side into one `.glb`, for people to look at.
//!
//! `cargo run --example contact_sheet -- OUT.glb [SET [PALETTE [NAMES [LOOKS]]]]`: the geometry set, the palette, the
//! recipes (`all`, or names with commas between them), and how many looks of each stand behind each other.

use std::collections::BTreeMap;
use std::error::Error;
use std::sync::Arc;

use glam::{Quat, Vec3};
use roomwright::internals::catalog::{Palette, load_catalog};
use roomwright::internals::gltf::write_glb;
use roomwright::internals::model::{Model, ModelMaterial};
use roomwright::internals::recipes::{GeometrySet, Recipe, RecipeInput, Slot, recipes};
use roomwright::internals::scene::{Node, Scene, SceneMaterial, SceneMesh};
use roomwright::internals::texture::{SurfaceUse, TextureLibrary, TextureLocation, TextureSize};

/// Metres between neighbouring models.
const GAP: f64 = 0.2;
/// Width of the sheet as a share of the side of a square with room for all.
const WIDE: f64 = 1.4;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let path = arguments.first().ok_or("where to? contact_sheet OUT.glb [SET [PALETTE [NAMES [LOOKS]]]]")?;
    let text = |index: usize, default| arguments.get(index).map_or(default, String::as_str);
    let looks: u32 = text(4, "1").parse()?;
    let catalog = load_catalog(&[]).map_err(|faults| faults.to_string())?.value;
    let palette = catalog.palettes.get(text(2, "modern")).ok_or("no such palette")?;
    let wanted = text(3, "all");
    let geometry = GeometrySet::find(text(1, "plain")).ok_or("no such geometry set")?;
    let is_wanted = |recipe: &&Recipe| wanted == "all" || wanted.split(',').any(|word| word == recipe.name());
    let chosen: Vec<&Recipe> = recipes().iter().copied().filter(is_wanted).collect();
    if chosen.is_empty() {
        return Err(format!("no recipe is called {wanted}: see the files of src/recipes/furniture").into());
    }
    let sizes = chosen.iter().map(|recipe| recipe.usual_size());
    let area: f64 = sizes.map(|size| (size.width + GAP) * (size.depth + GAP) * f64::from(looks)).sum();
    let mut sheet = Sheet::new(palette);
    let (mut x, mut z, mut deepest) = (0.0, 0.0_f64, 0.0_f64);
    for recipe in chosen {
        let size = recipe.usual_size();
        if x + size.width > area.sqrt() * WIDE {
            (x, z, deepest) = (0.0, z + deepest, 0.0);
        }
        for look in 0..looks {
            let input = RecipeInput { size, look, geometry, parameters: &[] };
            let back = f64::from(look) * (size.depth + GAP) + size.depth / 2.0;
            sheet.add(
                &format!("item-{}-{look}", recipe.name()),
                recipe.build(&input).into(),
                glam::DVec3::new(x + size.width / 2.0, 0.0, z + back).as_vec3(),
            );
        }
        x += size.width + GAP;
        deepest = deepest.max(f64::from(looks) * (size.depth + GAP));
    }
    std::fs::write(path, write_glb(&sheet.scene).map_err(|error| error.to_string())?)?;
    Ok(())
}

/// A scene under construction and where each material slot stands in it.
struct Sheet<'a> {
    palette: &'a Palette,
    scene: Scene,
    textures: TextureLibrary,
    slots: BTreeMap<Slot, usize>,
}

impl<'a> Sheet<'a> {
    fn new(palette: &'a Palette) -> Self {
        let scene = Scene {
            root: node("sheet", None, Vec3::ZERO),
            meshes: Vec::new(),
            materials: Vec::new(),
            lights: Vec::new(),
            variants: Vec::new(),
            copyright: None,
        };
        let textures = TextureLibrary::new(TextureSize::Small, TextureLocation::Embedded);
        Self { palette, scene, textures, slots: BTreeMap::new() }
    }

    fn add(&mut self, name: &str, model: Model, at: Vec3) {
        let materials = model.primitives.iter().map(|part| self.slot(&part.material)).collect();
        self.scene.root.children.push(node(name, Some(self.scene.meshes.len()), at));
        let mesh = SceneMesh { name: format!("mesh-{name}"), model: Arc::new(model), materials, key: None };
        self.scene.meshes.push(mesh);
    }

    fn slot(&mut self, material: &ModelMaterial) -> usize {
        let ModelMaterial::Slot(slot) = material else { unreachable!("recipes name slots") };
        let Self { palette, scene, textures, slots } = self;
        *slots.entry(*slot).or_insert_with(|| {
            let material = palette.materials[slot].clone();
            let textures = material
                .texture
                .map_or(&[][..], |surface| textures.textures(surface, SurfaceUse::Room))
                .to_vec();
            scene.materials.push(SceneMaterial::Slot { name: slot.name().to_owned(), material, textures });
            scene.materials.len() - 1
        })
    }
}

fn node(name: &str, mesh: Option<usize>, translation: Vec3) -> Node {
    let name = name.to_owned();
    Node {
        name,
        translation,
        rotation: Quat::IDENTITY,
        mesh,
        light: None,
        extras: None,
        children: Vec::new(),
    }
}
