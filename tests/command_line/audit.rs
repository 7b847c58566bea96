//! `audit`: finished files are judged as the bake judged them.

use std::collections::BTreeMap;

use serde_json::Value;

use super::world::{World, plan};

fn json(text: impl AsRef<[u8]>) -> Value {
    serde_json::from_slice(text.as_ref()).unwrap()
}

/// The measured values and thresholds of findings to a millimetre, the rest as it is.
fn rounded(findings: &Value) -> Vec<Value> {
    let mut findings = findings.as_array().cloned().unwrap_or_default();
    for finding in &mut findings {
        for key in ["measured", "threshold"] {
            finding[key] = ((finding[key].as_f64().unwrap() * 1e3).round() as i64).into();
        }
    }
    findings
}

/// Grade, score and findings of each room that the manifest lists, by level and room.
fn recorded(manifest: &Value) -> BTreeMap<String, (Value, Option<f64>, Vec<Value>)> {
    let levels = manifest["levels"].as_array().unwrap().iter();
    let rooms = levels.flat_map(|level| {
        let place = format!("{}/{}", level["building"].as_str().unwrap(), level["level"].as_str().unwrap());
        let rooms = level["rooms"].as_array().unwrap().iter();
        rooms.map(move |room| {
            let key = format!("{place}/{}", room["room"].as_str().unwrap());
            (key, (room["grade"].clone(), room["score"].as_f64(), rounded(&room["findings"])))
        })
    });
    rooms.collect()
}

/// The same of all rooms that the audit judged.
fn judged(report: &Value) -> BTreeMap<String, (Value, Option<f64>, Vec<Value>)> {
    let levels = report["levels"].as_array().unwrap().iter();
    let rooms = levels.flat_map(|level| {
        let place = format!("{}/{}", level["building"].as_str().unwrap(), level["level"].as_str().unwrap());
        let rooms = level["rooms"].as_array().unwrap().iter();
        rooms.map(move |room| {
            let key = format!("{place}/{}", room["room"].as_str().unwrap());
            (key, (room["grade"].clone(), room["score"]["value"].as_f64(), rounded(&room["findings"])))
        })
    });
    rooms.collect()
}

fn assert_agreement(world: &World, bake: &[&str]) {
    world.must(bake);
    let manifest = json(world.read("out/manifest.json"));
    let ran = world.run(&["audit", "--json"]);
    let has_failed = manifest["totals"]["failed"] != 0;
    assert_eq!(ran.code, Some(i32::from(has_failed)), "{}", ran.stderr);
    let report = json(&ran.stdout);
    for key in ["none", "minor", "failed", "findings", "given"] {
        assert_eq!(report["totals"][key], manifest["totals"][key], "{key}");
    }
    let means = [&report, &manifest].map(|of| of["totals"]["score"]["mean"].as_f64().unwrap());
    assert!((means[0] - means[1]).abs() <= 1e-3, "{means:?}");
    let judged = judged(&report);
    assert_eq!(judged.len() as u64, manifest["totals"]["rooms"].as_u64().unwrap());
    let recorded = recorded(&manifest);
    for (room, (grade, score, findings)) in &judged {
        let Some((known_grade, known_score, known_findings)) = recorded.get(room) else {
            assert_eq!((grade, findings.len()), (&Value::from("none"), 0), "{room}");
            continue;
        };
        assert_eq!((grade, findings), (known_grade, known_findings), "{room}");
        let is_same = score.zip(*known_score).map_or(score == known_score, |(a, b)| (a - b).abs() <= 1e-3);
        assert!(is_same, "{room}: {score:?} {known_score:?}");
    }
}

#[test]
fn the_demo_is_judged_as_the_bake_judged_it() {
    assert_agreement(&World::new(), &["bake", "--quiet", "--effort", "1"]);
}

#[test]
fn plain_gltf_that_shares_its_geometry_is_judged_too() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    assert_agreement(&world, &["bake", "a.yaml", "--quiet", "--format", "gltf", "--shared-library"]);
}

#[test]
fn a_bed_moved_into_the_door_fails_its_room() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--quiet", "--format", "gltf"]);
    let file = world.files("out").into_keys().find(|name| name.ends_with(".gltf")).unwrap();
    let path = format!("out/{file}");
    let mut document = json(world.read(&path));
    let nodes = document["nodes"].as_array_mut().unwrap();
    let is_bed =
        |node: &&mut Value| node["extras"]["class"].as_str().is_some_and(|class| class.ends_with("bed"));
    nodes.iter_mut().find(is_bed).unwrap()["translation"] = serde_json::json!([3.0, 0.0, -2.0]);
    world.write(&path, document.to_string());
    let ran = world.run(&["audit", &path]);
    assert_eq!(ran.code, Some(1), "{}", ran.stdout);
    assert!(ran.stdout.contains("failed alpha/1/bed (bedroom): door_blocked"), "{}", ran.stdout);
}

#[test]
fn bad_files_are_named_and_the_others_judged() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 3));
    world.must(&["bake", "a.yaml", "--quiet"]);
    world.write("out/alpha/2.glb", b"glTF\x02\0\0\0");
    std::fs::remove_file(world.path("out/alpha/3.glb")).unwrap();
    let ran = world.run(&["audit"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.stdout.contains("2 rooms of 1 level"), "{ran:?}");
    assert!(["alpha/2.glb", "alpha/3.glb"].iter().all(|file| ran.stderr.contains(file)), "{ran:?}");
    assert_eq!(world.run(&["audit", "out/alpha/2.glb"]).code, Some(2));
    let ran = world.run(&["audit", "nowhere"]);
    assert!(ran.code == Some(2) && ran.stderr.contains("does not exist"), "{ran:?}");
}

#[test]
fn a_long_list_is_cut_unless_all_of_it_is_asked_for() {
    let world = World::new();
    world.write("strict/audit.yaml", "version: 1\nthresholds:\n  facing: {angle: 0}\n  alignment: {angle: 0}\n  balance: {least_area: 1, share: 0.5}\n  bodies: {overhang_share: 0, support_gap: 0}\n");
    world.write("a.yaml", plan("alpha", 40));
    world.must(&["bake", "a.yaml", "--quiet", "--effort", "1"]);
    let lines = |all: bool| {
        let arguments = ["audit", "--catalog", "strict", "--all"];
        let ran = world.run(&arguments[..if all { 4 } else { 3 }]);
        (
            ran.stdout.lines().filter(|line| line.starts_with("  ")).count(),
            ran.stdout.contains("--all shows them"),
        )
    };
    let (cut, all) = (lines(false), lines(true));
    assert!(cut == (40, true) && all.0 > 40 && !all.1, "{cut:?} {all:?}");
}
