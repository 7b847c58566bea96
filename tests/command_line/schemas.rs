//! The JSON output of commands obeys the published schemas in `configs/schema/`.

use std::path::Path;

use serde_json::Value;

use super::world::{World, plan};

/// Asserts that a value obeys a published schema, by its path below `configs/schema/`.
fn obeys(value: &Value, schema: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("configs/schema/{schema}.schema.json"));
    let schema: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let errors: Vec<String> =
        validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{}: {errors:#?}", path.display());
}

/// The answer of a command, whatever its exit code.
fn answer(world: &World, arguments: &[&str]) -> Value {
    let ran = world.run(&[arguments, &["--json"]].concat());
    serde_json::from_str(&ran.stdout).unwrap_or_else(|error| panic!("{arguments:?}: {error}: {}", ran.stderr))
}

/// A folder with a plan of two rooms, an edit that fits no object, and a bake.
fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("a", 1));
    let edits = "version: 1\nedits:\n- {level: \"1\", room: bed, objects: {sofa.9: {remove: true}}}\n";
    world.write("a.edits.yaml", edits);
    world
}

#[test]
fn answers_obey_their_schemas() {
    let world = world();
    world.write("faulty.yaml", plan("a", 1).replace("type: study", "type: studdy"));
    let commands: [(&[&str], &str); 9] = [
        (&["bake", "a.yaml", "--out", "out"], "bake"),
        (&["audit", "out"], "audit"),
        (&["check", "faulty.yaml"], "check"),
        (&["diff", "out", "out"], "../diff"),
        (&["explain", "a.yaml", "bed"], "explain"),
        (&["formats"], "formats"),
        (&["import", "a.yaml", "--out", "imported.yaml", "--report"], "import"),
        (&["init", "begun"], "init"),
        (&["edits", "reroll", "a.yaml", "bed"], "edits"),
    ];
    for (arguments, schema) in commands {
        obeys(&answer(&world, arguments), &format!("answers/{schema}"));
    }
    let docs = answer(&world, &["catalog", "--docs", "docs"]);
    obeys(&docs, "answers/catalog-docs");
}

#[test]
fn the_version_is_told_as_json_and_names_the_program_of_manifests() {
    let world = World::new();
    world.write("a.yaml", plan("a", 1));
    world.must(&["bake", "a.yaml", "--out", "out", "--quiet"]);
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    for words in [["--version", "--json"], ["--json", "--version"]] {
        let told: Value = serde_json::from_str(&world.run(&words).stdout).unwrap();
        obeys(&told, "answers/version");
        assert_eq!(told["program"], manifest["program"]);
    }
    assert_eq!(world.run(&["--version"]).stdout.lines().count(), 1);
}

#[test]
fn progress_lines_obey_their_schema() {
    let world = world();
    let ran = world.run(&["bake", "a.yaml", "--progress", "json", "--quiet"]);
    let lines: Vec<&str> = ran.stderr.lines().filter(|line| line.starts_with('{')).collect();
    assert!(lines.len() >= 3, "{}", ran.stderr);
    for line in lines {
        obeys(&serde_json::from_str(line).unwrap(), "answers/bake-progress");
    }
}

#[test]
fn merged_shards_obey_the_schemas_of_answer_and_manifest() {
    let world = world();
    world.run(&["bake", "a.yaml", "--out", "out", "--shard", "1/1", "--quiet"]);
    obeys(&answer(&world, &["merge", "out"]), "answers/merge");
    let manifest = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    obeys(&manifest, "manifest");
}

#[test]
fn extras_and_manifest_obey_their_schemas() {
    let world = World::new();
    // Lamps, columns, doors, windows, findings and removals.
    let plan = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/paper/office_concave.yaml");
    world.must(&["bake", plan.to_str().unwrap(), "--out", "out", "--format", "gltf", "--shared-library"]);
    obeys(&serde_json::from_slice(&world.read("out/manifest.json")).unwrap(), "manifest");
    let levels: Vec<String> = world.files("out").into_keys().filter(|path| path.ends_with(".gltf")).collect();
    assert!(!levels.is_empty());
    for path in levels {
        let level: Value = serde_json::from_slice(&world.read(&format!("out/{path}"))).unwrap();
        let nodes = level["nodes"].as_array().unwrap();
        let extras: Vec<&Value> = nodes.iter().map(|node| &node["extras"]).collect();
        for kind in ["level", "opening", "room", "part", "light", "furniture"] {
            assert!(extras.iter().any(|extras| extras["kind"] == kind), "no {kind}");
        }
        extras.into_iter().for_each(|extras| obeys(extras, "extras"));
    }
}
