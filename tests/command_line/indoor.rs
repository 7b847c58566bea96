//! Indoor maps from the file to furnished levels. The maps are our own.

use std::path::Path;

use super::world::World;

/// The folders of the maps below `tests/cases`, with their levels.
const MAPS: [(&str, usize); 3] = [(XML, 2), (GEOJSON, 2), ("plan_import/indoor_mlit", 2)];
/// One map in two encodings; apart, for two buildings of one folder may not have the same id.
const XML: &str = "plan_import/indoor_xml";
const GEOJSON: &str = "plan_encodings/indoor_geojson";

fn world(map: &str) -> World {
    let world = World::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases").join(map);
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        world.write(&format!("map/{name}"), std::fs::read(&path).unwrap());
    }
    world
}

/// The sources that the manifest of a folder names.
fn attributions(world: &World, folder: &str) -> Vec<serde_json::Value> {
    let contents = world.contents(folder);
    let (_, text) = contents.iter().find(|(name, _)| *name == "manifest.json").expect("a manifest");
    let manifest: serde_json::Value = serde_json::from_slice(text).unwrap();
    manifest["attributions"].as_array().cloned().unwrap_or_default()
}

#[test]
fn imported_indoor_maps_bake_to_the_bytes_of_the_maps() {
    for (map, level_count) in MAPS {
        let world = world(map);
        world.run(&["import", "map", "--out", "plans"]);
        world.run(&["bake", "map", "--out", "direct", "--effort", "1"]);
        world.run(&["bake", "plans", "--out", "native", "--effort", "1"]);
        let [direct, native] = ["direct", "native"].map(|folder| world.levels(folder));
        assert_eq!(direct.len(), level_count, "{map}");
        assert!(direct == native, "{map}: the levels differ");
        let [direct, native] = ["direct", "native"].map(|folder| attributions(&world, folder));
        assert!(!direct.is_empty() && direct == native, "{map}: {direct:?}, {native:?}");
    }
}

/// The JSON of a binary glTF file.
fn document(bytes: &[u8]) -> serde_json::Value {
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).unwrap()
}

#[test]
fn files_and_tiles_name_the_source_where_viewers_look_for_it() {
    let world = world(XML);
    world.run(&["bake", "map", "--out", "out", "--effort", "1"]);
    world.run(&["tiles", "map", "--out", "tiles", "--effort", "1"]);
    world.run(&["tiles", "out", "--out", "of_bake"]);
    let named = attributions(&world, "out");
    assert_eq!(named.len(), 1);
    for folder in ["out", "tiles", "of_bake"] {
        let levels = world.levels(folder);
        assert!(levels.len() > 1);
        for (name, bytes) in levels {
            assert_eq!(document(&bytes)["asset"]["copyright"], named[0], "{folder}/{name}");
        }
    }
    for folder in ["tiles", "of_bake"] {
        let tileset = world.read(&format!("{folder}/tileset.json"));
        let tileset: serde_json::Value = serde_json::from_slice(&tileset).unwrap();
        assert_eq!(tileset["asset"]["extras"]["attributions"], serde_json::json!(named), "{folder}");
    }
}

#[test]
fn one_map_bakes_to_the_same_bytes_in_each_encoding() {
    let [xml, geojson] = [XML, GEOJSON].map(|map| {
        let world = world(map);
        world.run(&["bake", "map", "--out", "out", "--effort", "1"]);
        world.levels("out")
    });
    assert!(!xml.is_empty() && xml == geojson);
}
