//! Indoor maps from the file to furnished levels. The maps are our own.

use std::path::Path;

use super::world::World;

/// The folders of the maps below `tests/cases/plan_import`, with their levels.
const MAPS: [(&str, usize); 3] = [("indoor_xml", 2), ("indoor_geojson", 2), ("indoor_mlit", 2)];

fn world(map: &str) -> World {
    let world = World::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/plan_import").join(map);
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        world.write(&format!("map/{name}"), std::fs::read(&path).unwrap());
    }
    world
}

fn levels(world: &World, folder: &str) -> Vec<(String, Vec<u8>)> {
    world.contents(folder).into_iter().filter(|(name, _)| name.ends_with(".glb")).collect()
}

#[test]
fn imported_indoor_maps_bake_to_the_bytes_of_the_maps() {
    for (map, level_count) in MAPS {
        let world = world(map);
        world.run(&["import", "map", "--out", "plans"]);
        world.run(&["bake", "map", "--out", "direct", "--effort", "1"]);
        world.run(&["bake", "plans", "--out", "native", "--effort", "1"]);
        let [direct, native] = ["direct", "native"].map(|folder| levels(&world, folder));
        assert_eq!(direct.len(), level_count, "{map}");
        assert!(direct == native, "{map}: the levels differ");
    }
}

#[test]
fn one_map_bakes_to_the_same_bytes_in_each_encoding() {
    let [xml, geojson] = ["indoor_xml", "indoor_geojson"].map(|map| {
        let world = world(map);
        world.run(&["bake", "map", "--out", "out", "--effort", "1"]);
        levels(&world, "out")
    });
    assert!(!xml.is_empty() && xml == geojson);
}
