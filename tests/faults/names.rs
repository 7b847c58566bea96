//! Names with a meaning for file systems, terminals, SVG, HTML and JSON, and manifests with random damage.

use roomwright::internals::document::Source;
use serde_json::{Value, json};

use super::mutate::{Draw, made};
use super::world::{World, plan};

const NAMES: [&str; 22] = [
    "..",
    ".",
    "../../x",
    "/etc/passwd",
    "C:\\x",
    "CON",
    "nul.txt",
    "a/b",
    "-rf",
    "--out",
    "~",
    "$(touch x)",
    "`id`",
    "a b",
    "a'b",
    "</text><script>alert(1)</script>",
    "\"><img src=x onerror=alert(1)>",
    "]]>&amp;&#0;",
    "{\"a\":1}",
    "%2e%2e%2f",
    "e\u{301}\u{202e}txt.exe",
    "::warning::x",
];

/// A plan whose building, level and rooms have this name.
fn named(name: &str) -> String {
    let mut document: Value = Source::new("text.yaml".as_ref(), &plan("alpha", 1)).parse().unwrap();
    document["id"] = json!(name);
    document["name"] = json!(name);
    let level = &mut document["levels"][0];
    level["id"] = json!(name);
    level["name"] = json!(name);
    level["rooms"][1]["id"] = json!(name);
    level["rooms"][1]["name"] = json!(name);
    level["openings"][0]["rooms"][1] = json!(name);
    level.as_object_mut().unwrap().remove("repeat");
    document.to_string()
}

/// Whether text may be shown by a terminal.
fn is_tame(text: &str) -> bool {
    text.chars()
        .all(|found| found == '\n' || !(found.is_control() || ('\u{202a}'..='\u{202e}').contains(&found)))
}

#[test]
fn hostile_names_stay_in_the_folder_and_in_their_quotes() {
    let world = World::new();
    for (index, name) in NAMES.iter().enumerate() {
        let (plan, out) = (format!("{index}/plan.json"), format!("{index}/out"));
        world.write(&plan, named(name));
        let ran = world.run(&["bake", &plan, "--out", &out]);
        assert!(matches!(ran.code, Some(0..=2)), "{name:?}: {}", ran.stderr);
        assert!(is_tame(&ran.stdout) && is_tame(&ran.stderr), "{name:?}: {ran:?}");
        if ran.code == Some(0) {
            let manifest: Value =
                serde_json::from_slice(&world.read(&format!("{out}/manifest.json"))).unwrap();
            let path = manifest["levels"][0]["files"][0]["path"].as_str().unwrap();
            let floor = gltf::Gltf::from_slice(&world.read(&format!("{out}/{path}"))).unwrap();
            assert!(floor.nodes().count() > 3, "{name:?}");
        }
        let drawing = format!("{index}/a.svg");
        let ran = world.run(&["draw", &plan, "--out", &drawing]);
        assert!(is_tame(&ran.stdout) && is_tame(&ran.stderr), "{name:?}: {ran:?}");
        if ran.code == Some(0) && world.path(&drawing).is_file() {
            let svg = String::from_utf8(world.read(&drawing)).unwrap();
            assert!(is_tame(&svg) && !svg.contains("<script") && !svg.contains("<img"), "{name:?}: {svg}");
        }
        let beside = std::fs::read_dir(world.path(&index.to_string())).unwrap();
        let beside: Vec<String> =
            beside.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        let known = ["plan.json", "out", "a.svg"];
        assert!(beside.iter().all(|found| known.contains(&found.as_str())), "{name:?}: {beside:?}");
    }
    let mut above: Vec<String> = world.names(".");
    above.retain(|name| !name.chars().next().is_some_and(|first| first.is_ascii_digit()));
    assert_eq!(above, Vec::<String>::new());
}

/// Manifests that are damaged at random: nothing panics, and no file outside the output folder changes.
#[test]
fn damaged_manifests_delete_no_foreign_files() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.write("victim", "precious");
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    let before = world.files(".");
    let cases = [
        ("manifest".to_owned(), world.read("whole/manifest.json")),
        ("victim".to_owned(), b"{\"path\": \"../victim\", \"bytes\": 8}\n".to_vec()),
    ];
    for seed in 0..24 {
        let _ = std::fs::remove_dir_all(world.path("out"));
        for (name, bytes) in world.contents("whole") {
            world.write(&format!("out/{name}"), bytes);
        }
        let manifest = made(&cases, &mut Draw::new("manifest", seed), 1 << 20);
        world.write("out/manifest.json", &manifest);
        let command: &[&str] = match seed % 4 {
            0 => &["bake", "a.yaml", "--prune"],
            1 => &["merge", "out"],
            2 => &["diff", "out", "whole"],
            _ => &["audit", "out"],
        };
        let ran = world.run(command);
        assert!(matches!(ran.code, Some(0..=2)), "seed {seed}, {command:?}: {ran:?}");
        assert!(is_tame(&ran.stdout) && is_tame(&ran.stderr), "seed {seed}, {command:?}: {ran:?}");
        let mut after = world.files(".");
        after.retain(|name, _| !name.starts_with("out/"));
        assert_eq!(after, before, "seed {seed}, {command:?}");
    }
}
