//! Options for the looks of the same rooms: textures, lights, levels of detail, doors, variants.

use std::collections::BTreeMap;

use super::world::{World, plan};

/// A folder with two furnished rooms, baked with these options.
fn baked(options: &[&str]) -> World {
    let world = World::new();
    world.write("house.yaml", plan("house", 1));
    bake(&world, options);
    world
}

fn bake(world: &World, options: &[&str]) -> String {
    world.must(&[&["bake", "house.yaml", "--effort", "1"], options].concat()).stdout
}

fn textures(world: &World) -> Vec<String> {
    world.names("out").into_iter().filter(|name| name.starts_with("house/shared-textures/")).collect()
}

fn level(world: &World) -> gltf::Gltf {
    gltf::Gltf::from_slice_without_validation(&world.contents("out")["house/1.glb"]).unwrap()
}

/// The images of the level's file: path, or nothing for one inside.
fn images(world: &World) -> Vec<Option<String>> {
    let source = |image: gltf::Image| match image.source() {
        gltf::image::Source::Uri { uri, .. } => Some(uri.to_owned()),
        gltf::image::Source::View { .. } => None,
    };
    level(world).images().map(source).collect()
}

#[test]
fn levels_refer_to_shared_textures_by_relative_paths_that_exist() {
    let world = baked(&["--textures", "small", "--shared-textures"]);
    let (files, images) = (textures(&world), images(&world));
    let paths: Vec<String> = images.into_iter().flatten().collect();
    assert!(!paths.is_empty(), "all but the swatches, of a few bytes, have files of their own");
    for path in paths {
        assert!(files.contains(&format!("house/{path}")), "beside the floor, never above it: {path}");
    }
    let manifest = String::from_utf8(world.contents("out").remove("manifest.json").unwrap()).unwrap();
    assert!(files.iter().all(|file| manifest.contains(file)), "the manifest lists them");
}

#[test]
fn a_second_bake_keeps_levels_unless_a_texture_is_gone() {
    let world = baked(&["--textures", "small", "--shared-textures"]);
    let before = world.files("out");
    assert!(bake(&world, &["--textures", "small", "--shared-textures"]).contains("Kept 1 level"));
    let first = textures(&world).remove(0);
    std::fs::remove_file(world.path("out").join(&first)).unwrap();
    bake(&world, &["--textures", "small", "--shared-textures"]);
    assert_eq!(world.files("out"), before);
}

#[test]
fn the_cache_changes_no_byte() {
    let world = World::new();
    world.write("house.yaml", plan("house", 1));
    let bakes = |out: &str, cache: &str| {
        let options = ["--textures", "small", "--detail", "reduced", "--out", out, "--cache", cache];
        bake(&world, &options);
        world.files(out)
    };
    let plain = bakes("plain", "none");
    assert!(bakes("first", "cache") == plain);
    // Beside the entries are notes where plans lie, one for each output folder.
    let kept_entries = || {
        let is_note = |name: &str| name.starts_with("plans/");
        world.contents("cache").into_iter().filter(|(name, _)| !is_note(name)).collect::<BTreeMap<_, _>>()
    };
    let kept = kept_entries();
    let entries = || kept.keys().filter(|name| name.ends_with(".entry"));
    assert!(entries().count() > 20, "{kept:?}");
    // One entry is damaged, one is gone: both are made again, the others are read.
    let (damaged, gone) = (entries().next().unwrap(), entries().next_back().unwrap());
    world.write(&format!("cache/{damaged}"), &kept[damaged][..40]);
    std::fs::remove_file(world.path(&format!("cache/{gone}"))).unwrap();
    assert!(bakes("second", "cache") == plain);
    assert!(kept_entries() == kept);
}

#[test]
fn a_file_needs_no_other_file() {
    let world = baked(&["--textures", "small"]);
    assert!(textures(&world).is_empty());
    assert!(level(&world).buffers().all(|buffer| matches!(buffer.source(), gltf::buffer::Source::Bin)));
    let images = images(&world);
    assert!(!images.is_empty() && images.iter().all(Option::is_none));
}

#[test]
fn without_textures_there_are_no_images_and_the_file_is_smaller() {
    let size = |world: &World| world.contents("out")["house/1.glb"].len();
    let plain = baked(&["--textures", "none"]);
    assert!(images(&plain).is_empty() && textures(&plain).is_empty());
    assert!(size(&plain) < size(&baked(&["--textures", "small"])));
}

#[test]
fn shades_shine_by_default_and_lamps_are_lights_with_physical() {
    let lights = |world: &World| level(world).nodes().filter(|node| node.light().is_some()).count();
    let nodes = |world: &World| {
        level(world).nodes().filter(|node| node.name().unwrap().starts_with("light.")).count()
    };
    let shining = baked(&[]);
    assert_eq!(
        lights(&shining),
        0,
        "more lights than a viewer can draw leave it black, and candelas make it white"
    );
    let physical = baked(&["--lights", "physical"]);
    assert!(lights(&physical) > 0);
    assert_eq!((nodes(&shining), nodes(&physical)), (lights(&physical), lights(&physical)));
    assert_eq!(nodes(&baked(&["--lights", "none"])), 0);
}

#[test]
fn levels_of_detail_have_the_same_nodes_and_fewer_triangles() {
    let look = |detail| {
        let gltf = level(&baked(&["--detail", detail]));
        let names: Vec<String> = gltf.nodes().map(|node| node.name().unwrap().to_owned()).collect();
        let count = |primitive: gltf::Primitive| primitive.indices().unwrap().count() / 3;
        (names, gltf.meshes().flat_map(|mesh| mesh.primitives()).map(count).sum::<usize>())
    };
    let [full, reduced, boxes] = ["full", "reduced", "boxes"].map(look);
    assert_eq!(full.0, reduced.0);
    assert_eq!(full.0, boxes.0);
    assert!(full.1 > reduced.1 && reduced.1 > boxes.1, "{} {} {}", full.1, reduced.1, boxes.1);
}

/// Sines of the angles between leaves and their walls, each as a positive number.
fn leaf_sines(options: &[&str]) -> Vec<f32> {
    let gltf = level(&baked(options));
    let leaves = gltf.nodes().filter(|node| node.name().is_some_and(|name| name.starts_with("leaf@")));
    let sine = |node: gltf::Node| {
        let (_, [_, y, _, w], _) = node.transform().decomposed();
        (2.0 * y * w).abs()
    };
    leaves.map(sine).collect()
}

#[test]
fn doors_stand_open_as_far_as_asked_for() {
    let near = |sine: &f32, expected: f32| (sine - expected).abs() < 1e-3;
    let wide = leaf_sines(&[]);
    assert!(!wide.is_empty() && wide.iter().all(|sine| near(sine, 1.0)), "{wide:?}");
    assert!(leaf_sines(&["--door-angle", "30"]).iter().all(|sine| near(sine, 0.5)));
    assert!(leaf_sines(&["--door-angle", "0"]).iter().all(|sine| near(sine, 0.0)));
    // No further than the plan lets them.
    assert_eq!(leaf_sines(&["--door-angle", "170"]), wide);
}

#[test]
fn every_palette_is_a_variant_on_request_with_materials_that_exist() {
    let json = |options: &[&str]| {
        let gltf = level(&baked(options)).document.into_json();
        (serde_json::to_value(&gltf).unwrap(), gltf.extensions_used)
    };
    assert!(!json(&[]).1.iter().any(|name| name == "KHR_materials_variants"));
    let (document, used) = json(&["--variants"]);
    assert!(used.iter().any(|name| name == "KHR_materials_variants"));
    let variants = document["extensions"]["KHR_materials_variants"]["variants"].as_array().unwrap();
    let materials = document["materials"].as_array().unwrap();
    let primitives =
        document["meshes"].as_array().unwrap().iter().flat_map(|mesh| mesh["primitives"].as_array().unwrap());
    for primitive in primitives {
        let mappings = primitive["extensions"]["KHR_materials_variants"]["mappings"].as_array().unwrap();
        let mut named = 0;
        for mapping in mappings {
            let material =
                materials[mapping["material"].as_u64().unwrap() as usize]["name"].as_str().unwrap();
            for variant in mapping["variants"].as_array().unwrap() {
                let palette = variants[variant.as_u64().unwrap() as usize]["name"].as_str().unwrap();
                assert_eq!(material.split('.').next(), Some(palette));
                named += 1;
            }
        }
        assert_eq!(named, variants.len(), "every variant has its own material");
    }
}
