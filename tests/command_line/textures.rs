//! Textures of materials: shared, embedded, or none.

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
    world.names("out").into_iter().filter(|name| name.starts_with("shared-textures/")).collect()
}

/// The images of the level's file: path, or nothing for one inside.
fn images(world: &World) -> Vec<Option<String>> {
    let gltf = gltf::Gltf::from_slice_without_validation(&world.contents("out")["house/1.glb"]).unwrap();
    let source = |image: gltf::Image| match image.source() {
        gltf::image::Source::Uri { uri, .. } => Some(uri.to_owned()),
        gltf::image::Source::View { .. } => None,
    };
    gltf.images().map(source).collect()
}

#[test]
fn levels_refer_to_shared_textures_by_relative_paths_that_exist() {
    let world = baked(&["--textures", "small"]);
    let (files, images) = (textures(&world), images(&world));
    assert!(!images.is_empty());
    for image in images {
        let path = image.expect("shared images have files of their own");
        assert!(files.contains(&path.strip_prefix("../").unwrap().to_owned()), "{path}");
    }
    let manifest = String::from_utf8(world.contents("out").remove("manifest.json").unwrap()).unwrap();
    assert!(files.iter().all(|file| manifest.contains(file)), "the manifest lists them");
}

#[test]
fn a_second_bake_keeps_levels_unless_a_texture_is_gone() {
    let world = baked(&["--textures", "small"]);
    let before = world.files("out");
    assert!(bake(&world, &["--textures", "small"]).contains("Kept 1 level"));
    let first = textures(&world).remove(0);
    std::fs::remove_file(world.path("out").join(&first)).unwrap();
    bake(&world, &["--textures", "small"]);
    assert_eq!(world.files("out"), before);
}

#[test]
fn embedded_textures_leave_one_file() {
    let world = baked(&["--textures", "small", "--embed-textures"]);
    assert!(textures(&world).is_empty());
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
fn lamps_give_light_unless_told_otherwise() {
    let lights = |world: &World| {
        let gltf = gltf::Gltf::from_slice_without_validation(&world.contents("out")["house/1.glb"]).unwrap();
        gltf.nodes().filter(|node| node.light().is_some()).count()
    };
    assert!(lights(&baked(&[])) > 0);
    assert_eq!(lights(&baked(&["--no-lights"])), 0);
}
