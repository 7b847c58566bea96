//! Merged meshes: fixed parts share one mesh, and no node or triangle is lost.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::Vec3;
use roomwright::internals::catalog::Size;
use roomwright::internals::model::{Model, ModelMaterial, SwatchedModels};
use roomwright::internals::recipes::Slot;
use roomwright::internals::scene::{Node, Parts, Scene, SceneInput, SceneOptions, build_scene};

use crate::fixture::*;
use crate::levels;

/// Two rooms with furniture whose models are a cupboard of several plain slots.
fn scene_with(parts: Parts, has_swatches: bool) -> Scene {
    let (catalog, level) = (catalog(), two_rooms());
    let furnished = two_furnished(&catalog);
    let swatched = SwatchedModels::new(&catalog);
    let model = Arc::new(cupboard());
    let models = |_, _| Arc::clone(&model);
    let (swatches, options) =
        (has_swatches.then_some(&swatched), SceneOptions { parts, ..SceneOptions::default() });
    build_scene(&SceneInput { swatches, options, ..input(&level, &furnished, &catalog, &models) })
}

/// Boxes of three plain slots and a pane of glass.
fn cupboard() -> Model {
    let size = Size { width: 0.4, depth: 0.3, height: 0.5 };
    let parts = [Slot::Painted, Slot::Plastic, Slot::Chrome, Slot::Glass].map(|slot| box_model(size, slot));
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

/// Triangles, and the square metres of all of them.
fn surface(scene: &Scene) -> (usize, f64) {
    let meshes = nodes(scene).into_iter().filter_map(|node| node.mesh);
    let mut sum = (0, 0.0);
    for primitive in meshes.flat_map(|mesh| &scene.meshes[mesh].model.primitives) {
        for triangle in primitive.indices.chunks_exact(3) {
            let corner = |at: usize| Vec3::from_array(primitive.positions[triangle[at] as usize]).as_dvec3();
            sum.0 += 1;
            sum.1 += (corner(1) - corner(0)).cross(corner(2) - corner(0)).length() / 2.0;
        }
    }
    sum
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
    let (merged_surface, surface) = (surface(&merged), surface(&separate));
    assert_eq!(merged_surface.0, surface.0);
    // Walls of one mesh are fractions of a millimetre shorter.
    assert!((merged_surface.1 / surface.1 - 1.0).abs() < 1e-3, "{merged_surface:?} {surface:?}");
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
    let slots = [Slot::Painted, Slot::Chrome, Slot::Plastic];
    assert_eq!(materials, [&ModelMaterial::Slot(Slot::Glass), &ModelMaterial::Swatches(slots.into())]);
    let places: BTreeSet<[u32; 2]> =
        made.primitives[1].texture_coordinates.iter().map(|at| at.map(f32::to_bits)).collect();
    assert_eq!(places.len(), slots.len(), "a square for each slot");
    assert!(Arc::ptr_eq(&made, &swatched.of(&model)), "made once");
}

/// Metres within which tools take corners of a mesh for one (Blender's usual choice).
const WELDED: f32 = 1e-4;

/// Metres up to which skirting boards reach, which share their mitres: nobody cuts a room so low.
const SKIRTING: f32 = 0.07;

/// The corners of a mesh by number, those at one place with one number.
fn welded(positions: &[[f32; 3]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..positions.len()).collect();
    order.sort_by(|&one, &other| positions[one][0].total_cmp(&positions[other][0]));
    let mut number: Vec<usize> = (0..positions.len()).collect();
    for (at, &corner) in order.iter().enumerate() {
        let near = order[..at]
            .iter()
            .rev()
            .take_while(|&&other| positions[corner][0] - positions[other][0] <= WELDED);
        let place = Vec3::from_array(positions[corner]);
        if let Some(&same) =
            near.into_iter().find(|&&other| Vec3::from_array(positions[other]).distance(place) <= WELDED)
        {
            number[corner] = number[same];
        }
    }
    number
}

/// Edges of the walls of a mesh that more than one face is on each side of, once its corners are joined.
fn crowded_edges(model: &Model) -> usize {
    let positions: Vec<[f32; 3]> =
        model.primitives.iter().flat_map(|primitive| primitive.positions.iter().copied()).collect();
    let number = welded(&positions);
    let mut faces: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    let mut first = 0;
    for primitive in &model.primitives {
        let triangles = primitive.indices.as_chunks::<3>().0.iter();
        for triangle in triangles.map(|corners| corners.map(|index| first + index as usize)) {
            if triangle.iter().all(|&corner| (0.0..=SKIRTING).contains(&positions[corner][1])) {
                continue;
            }
            let [a, b, c] = triangle.map(|corner| number[corner]);
            [(a, b), (b, c), (c, a)].into_iter().for_each(|edge| *faces.entry(edge).or_default() += 1);
        }
        first += primitive.positions.len();
    }
    faces.values().filter(|&&count| count > 1).count()
}

#[test]
fn walls_of_one_mesh_stay_closed_bodies_where_tools_join_corners() {
    // In two of them walls stand back to back where there is no room for either, and railings begin at the very wall.
    let is_roomy = |name: &str| !["nib", "folding", "balcony"].iter().any(|word| name.contains(word));
    for (name, level) in levels::all().into_iter().filter(|(name, _)| is_roomy(name)) {
        let scene = merged_scene(&level);
        let walls: Vec<_> = scene.meshes.iter().filter(|mesh| mesh.name.starts_with("walls@")).collect();
        assert!(!walls.is_empty(), "{name}");
        for mesh in walls {
            assert_eq!(crowded_edges(&mesh.model), 0, "{name}: {}", mesh.name);
        }
    }
}
