//! Few meshes: what never moves apart is one, and nothing of the tree or of what one sees is lost.

use std::collections::BTreeSet;
use std::sync::Arc;

use roomwright::catalog::Size;
use roomwright::model::{Model, ModelMaterial, SwatchedModels};
use roomwright::plan::SitePlacement;
use roomwright::scene::{Node, Parts, Scene, SceneInput, SceneOptions, build_scene};

use crate::fixture::*;

/// Two rooms with furniture whose models are a cupboard of several plain slots.
fn scene_with(parts: Parts, has_swatches: bool) -> Scene {
    let (catalog, level) = (catalog(), two_rooms());
    let swatched = SwatchedModels::new(&catalog);
    let model = Arc::new(cupboard());
    build_scene(&SceneInput {
        level: &level,
        building: "tower",
        site: SitePlacement::default(),
        furnished: &two_furnished(&catalog),
        verdicts: &[],
        catalog: &catalog,
        models: &|_, _, _| Arc::clone(&model),
        textures: None,
        swatches: has_swatches.then_some(&swatched),
        options: SceneOptions { parts, ..SceneOptions::default() },
        seed: 42,
    })
}

/// Boxes of three plain slots and a pane of glass.
fn cupboard() -> Model {
    let size = Size { width: 0.4, depth: 0.3, height: 0.5 };
    let parts = ["painted", "plastic", "chrome", "glass"].map(|slot| box_model(size, slot));
    Model { primitives: parts.into_iter().flat_map(|model| model.primitives).collect() }
}

fn nodes(scene: &Scene) -> Vec<&Node> {
    fn add<'n>(node: &'n Node, all: &mut Vec<&'n Node>) {
        all.push(node);
        node.children.iter().for_each(|child| add(child, all));
    }
    let mut all = Vec::new();
    add(&scene.root, &mut all);
    all
}

fn draw_calls(scene: &Scene) -> usize {
    let meshes = nodes(scene).into_iter().filter_map(|node| node.mesh);
    meshes.map(|mesh| scene.meshes[mesh].model.primitives.len()).sum()
}

/// Triangles, and the square metres of all of them, to a square centimetre.
fn surface(scene: &Scene) -> (usize, i64) {
    let meshes = nodes(scene).into_iter().filter_map(|node| node.mesh);
    let mut sum = (0, 0.0);
    for primitive in meshes.flat_map(|mesh| &scene.meshes[mesh].model.primitives) {
        for triangle in primitive.indices.chunks_exact(3) {
            let corner =
                |at: usize| glam::Vec3::from_array(primitive.positions[triangle[at] as usize]).as_dvec3();
            sum.0 += 1;
            sum.1 += (corner(1) - corner(0)).cross(corner(2) - corner(0)).length() / 2.0;
        }
    }
    (sum.0, (sum.1 * 1e2).round() as i64)
}

#[test]
fn merging_halves_the_draw_calls_and_keeps_nodes_and_triangles() {
    let (merged, separate) = (scene_with(Parts::Merged, true), scene_with(Parts::Separate, false));
    assert!(
        2 * draw_calls(&merged) <= draw_calls(&separate),
        "{} {}",
        draw_calls(&merged),
        draw_calls(&separate)
    );
    assert_eq!(surface(&merged), surface(&separate));
    let names =
        |scene: &Scene| nodes(scene).into_iter().map(|node| node.name.clone()).collect::<BTreeSet<_>>();
    let added: Vec<String> = names(&merged).difference(&names(&separate)).cloned().collect();
    assert_eq!(added, ["walls@101", "walls@102"]);
    assert!(names(&merged).is_superset(&names(&separate)), "the contract's nodes are all there");
}

#[test]
fn floors_ceilings_leaves_and_panes_keep_their_own_mesh() {
    let scene = scene_with(Parts::Merged, true);
    let has_mesh = |start: &str| {
        let mut found = nodes(&scene).into_iter().filter(|node| node.name.starts_with(start)).peekable();
        assert!(found.peek().is_some(), "{start}");
        found.all(|node| node.mesh.is_some())
    };
    for start in ["floor@", "ceiling@", "walls@", "leaf@", "glass@", "frame@"] {
        assert!(has_mesh(start), "{start} can be hidden or moved by itself");
    }
    for start in ["wall.", "sill@", "socket."] {
        assert!(!has_mesh(start), "{start} is in another mesh");
    }
}

#[test]
fn plain_slots_become_one_primitive_and_glass_stays_glass() {
    let (catalog, model) = (catalog(), Arc::new(cupboard()));
    let swatched = SwatchedModels::new(&catalog);
    let made = swatched.of(&model);
    let materials: Vec<&ModelMaterial> =
        made.primitives.iter().map(|primitive| &primitive.material).collect();
    let slots = ["chrome", "painted", "plastic"];
    assert_eq!(materials, [&ModelMaterial::Slot("glass"), &ModelMaterial::Swatches(slots.into())]);
    let places: BTreeSet<[u32; 2]> =
        made.primitives[1].texture_coordinates.iter().map(|at| at.map(f32::to_bits)).collect();
    assert_eq!(places.len(), slots.len(), "a square for each slot");
    assert!(Arc::ptr_eq(&made, &swatched.of(&model)), "made once");
}
