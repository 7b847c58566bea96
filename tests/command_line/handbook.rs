//! The pages of the catalogue in `docs/` match the configuration.
//!
//! `UPDATE_GOLDENS=1 cargo test --test command_line handbook` writes them anew.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use super::world::World;

/// Bytes of a picture; larger ones make the page slow to load.
const LARGEST_PICTURE: usize = 40_000;

/// The pages of the catalogue below a folder.
fn pages(world: &World, folder: &str) -> BTreeMap<String, Vec<u8>> {
    let mut files = world.contents(folder);
    files.retain(|path, _| path == "catalogue.md" || path.starts_with("catalogue/"));
    files
}

/// The folder of the repository.
fn docs() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").to_str().unwrap().to_owned()
}

#[test]
fn the_pages_in_docs_are_those_of_the_configuration() {
    let world = World::new();
    world.must(&["catalog", "--docs", "docs"]);
    let docs = docs();
    let (now, known) = (pages(&world, "docs"), pages(&world, &docs));
    if std::env::var_os("UPDATE_GOLDENS").is_some() {
        for path in known.keys().filter(|path| !now.contains_key(*path)) {
            fs::remove_file(Path::new(&docs).join(path)).unwrap();
        }
        world.must(&["catalog", "--docs", &docs, "--force"]);
        return;
    }
    let names: BTreeSet<&String> =
        now.keys().chain(known.keys()).filter(|&path| now.get(path) != known.get(path)).collect();
    assert!(names.is_empty(), "{names:?} differ; renew with UPDATE_GOLDENS=1");
}

#[test]
fn pictures_are_small_and_each_is_shown() {
    let mut files = pages(&World::new(), &docs());
    let page = String::from_utf8(files.remove("catalogue.md").unwrap()).unwrap();
    assert_eq!(page.matches("](catalogue/").count(), files.len());
    assert!(files.len() > 40, "{}", files.len());
    for (path, picture) in &files {
        assert!(page.contains(&format!("]({path})")), "{path}");
        assert!(picture.len() < LARGEST_PICTURE, "{path}: {} bytes", picture.len());
    }
}

#[test]
fn pages_of_a_users_configuration_overwrite_others_by_force_only() {
    let world = World::new();
    world.write(
        "mine/rooms/wash.yaml",
        "version: 1\nroom_types:\n  wash_house:\n    extends: laundry\n    label: Wash house\n",
    );
    world.write("docs/catalogue.md", "mine");
    let arguments = ["catalog", "--docs", "docs", "--catalog", "mine", "--json"];
    let ran = world.run(&arguments);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("--force"), "{}", ran.stderr);
    assert_eq!(world.names("docs"), ["catalogue.md"]);
    let ran = world.must(&[&arguments[..], &["--force"]].concat());
    let report: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(report["files"].as_array().unwrap().len(), world.names("docs").len());
    let page = String::from_utf8(world.read("docs/catalogue.md")).unwrap();
    assert!(page.contains("### Wash\n\nIn `mine/rooms/wash.yaml`.") && page.contains("#### Wash house"));
    assert!(String::from_utf8(world.read("docs/catalogue/wash_house.svg")).unwrap().contains("Wash house"));
}
