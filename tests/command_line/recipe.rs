//! The page about recipes works: the recipe that it shows is the one that is compiled, and its commands run.

use roomwright::internals::geometry::Size;
use roomwright::internals::recipes::{GeometrySet, Mesh, RecipeInput, find};

use super::guide::{extras, world_of};

const PAGE: &str = include_str!("../../docs/recipe.md");
const RECIPE: &str = include_str!("../../src/recipes/furniture/step_stool.rs");
/// What a reader can take in at once.
const MOST_LINES: usize = 60;

fn build(size: Size, geometry: GeometrySet) -> Mesh {
    find("step_stool").unwrap().build(&RecipeInput { size, look: 0, geometry, parameters: &[] })
}

#[test]
fn the_recipe_of_the_page_is_the_file_that_is_compiled() {
    assert!(PAGE.contains(&format!("```rust\n{RECIPE}```")));
    assert!(RECIPE.lines().count() <= MOST_LINES);
}

/// The files of the kit, as one text.
fn kit() -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/recipes/kit");
    let files =
        std::fs::read_dir(folder).unwrap().map(|file| std::fs::read_to_string(file.unwrap().path()).unwrap());
    files.collect()
}

#[test]
fn the_tools_of_the_page_are_those_of_the_kit() {
    let table = PAGE.split("### Tools").nth(1).unwrap().split("\n\n").nth(2).unwrap();
    let kit = kit();
    let mut count = 0;
    for code in table.split('`').skip(1).step_by(2).filter(|code| code.starts_with(char::is_lowercase)) {
        let call = code.split('(').next().unwrap();
        let name = call.rsplit('.').next().unwrap();
        // Of the sampler the draft makes one.
        let is_known =
            name == "sampler" || ["(", "<"].iter().any(|next| kit.contains(&format!("fn {name}{next}")));
        assert!(is_known, "the kit has no `{name}`");
        count += 1;
    }
    assert!(count > 30, "{count}");
}

#[test]
fn the_recipe_of_the_page_fills_its_box_in_every_size_and_set() {
    for [width, depth, height] in [[0.42, 0.4, 0.45], [0.5, 0.3, 0.4], [0.3, 0.5, 0.7], [0.9, 0.9, 0.3]] {
        for geometry in GeometrySet::ALL {
            let mesh = build(Size { width, depth, height }, geometry);
            let corners = || mesh.parts.iter().flat_map(|part| &part.positions);
            let ends = |axis: usize| {
                let along = || corners().map(|corner| f64::from(corner[axis]));
                [along().fold(f64::MAX, f64::min), along().fold(f64::MIN, f64::max)]
            };
            let wanted = [[-width / 2.0, width / 2.0], [0.0, height], [-depth / 2.0, depth / 2.0]];
            for (axis, wanted) in wanted.into_iter().enumerate() {
                let [low, high] = ends(axis);
                let miss = (low - wanted[0]).abs().max((high - wanted[1]).abs());
                assert!(miss < 0.001, "{geometry}: axis {axis} misses by {miss} m");
            }
        }
    }
}

#[test]
fn a_set_without_a_form_gets_the_form_that_is_named_first() {
    let recipe = find("step_stool").unwrap();
    assert_eq!(recipe.served(GeometrySet::Budget), GeometrySet::Plain);
    assert_eq!(recipe.served(GeometrySet::Industrial), GeometrySet::Industrial);
    let size = recipe.usual_size();
    assert_eq!(build(size, GeometrySet::Traditional), build(size, GeometrySet::Plain));
    assert_ne!(build(size, GeometrySet::Industrial), build(size, GeometrySet::Plain));
}

#[test]
fn the_commands_of_the_page_draw_and_bake_a_room_with_the_new_piece() {
    let world = world_of(PAGE);
    assert!(world.read("pantry.svg").starts_with(b"<svg"));
    let furniture = extras(&world, "out/pantry/ground.glb", "furniture");
    assert_eq!(furniture.iter().filter(|piece| piece["class"] == "step_stool").count(), 1);
}
