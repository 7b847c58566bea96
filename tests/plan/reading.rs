//! Paths, folders, patterns and projects.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use roomwright::internals::document::Source;

use super::support::{read, read_text, summary};

const ROOM: &str = "version: 1\nlevels:\n- id: a\n  rooms:\n  - {id: r, type: office, rectangle: [0, 0, 4, 3]}\n  openings:\n  - {kind: door, at: [1, 0], hinge: left, opens_into: r}\n";

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    folder
}

fn ids(folder: &Path, paths: &[&str]) -> Vec<String> {
    let paths: Vec<PathBuf> = paths.iter().map(|path| folder.join(path)).collect();
    read(&paths).plan.buildings.into_iter().map(|placed| placed.id).collect()
}

#[test]
fn the_order_of_paths_does_not_matter() {
    let folder = folder(&[
        ("b.yaml", ROOM),
        ("a/c.json", &to_json(ROOM)),
        ("other.yaml", "classes: {}\n"),
        ("x.txt", ""),
    ]);
    assert_eq!(ids(folder.path(), &["b.yaml", "a"]), ["b", "c"]);
    assert_eq!(ids(folder.path(), &["a", "b.yaml"]), ["b", "c"]);
    assert_eq!(ids(folder.path(), &[""]), ["b", "c"]);
    assert_eq!(ids(folder.path(), &["**/*.json"]), ["c"]);
}

fn to_json(yaml: &str) -> String {
    let value: serde_json::Value = Source::new("text.yaml".as_ref(), yaml).parse().unwrap();
    serde_json::to_string_pretty(&value).unwrap()
}

#[test]
fn json_and_yaml_give_equal_levels() {
    let folder = folder(&[("y.yaml", ROOM), ("j.json", &to_json(ROOM))]);
    let reading = read(&[folder.path().to_owned()]);
    let digests: Vec<_> =
        reading.plan.buildings.iter().map(|placed| placed.building.levels[0].digest).collect();
    assert_eq!(digests[0], digests[1]);
}

#[test]
fn one_bad_file_does_not_stop_the_others() {
    let folder =
        folder(&[("a.yaml", ROOM), ("b.yaml", "version: 1\nlevels: []\n"), ("c.yaml", "levels: [\n")]);
    let reading = read(&[folder.path().to_owned()]);
    assert_eq!(reading.plan.buildings.len(), 1);
    let files: Vec<_> =
        reading.faults.0.iter().map(|fault| fault.file.file_name().unwrap().to_owned()).collect();
    assert_eq!(files, ["b.yaml", "c.yaml"]);
}

#[test]
fn one_bad_room_does_not_stop_a_building() {
    let bow_tie = "  - {id: bad, type: office, outline: [[9, 0], [12, 3], [12, 0], [9, 3]]}\n  openings:";
    let reading = read_text(&ROOM.replace("  openings:", bow_tie));
    assert!(reading.faults.has_errors());
    let level = &reading.plan.buildings[0].building.levels[0];
    assert_eq!(level.rooms.len(), 1, "the sound room is kept");
}

#[test]
fn two_files_with_one_building_id_are_named() {
    let with_id = ROOM.replace("version: 1", "version: 1\nid: same");
    let folder = folder(&[("a.yaml", &with_id), ("b.yaml", &with_id)]);
    let reading = read(&[folder.path().to_owned()]);
    assert_eq!(reading.plan.buildings.len(), 1);
    let text = reading.faults.to_string();
    assert!(text.contains("b.yaml: building id \"same\" is used by") && text.contains("a.yaml"), "{text}");
}

#[test]
fn equal_buildings_of_a_project_are_one() {
    let project = "version: 1\nproject:\n  seed: 7\n  catalog: [more]\n  plans:\n  - {plan: p/a.yaml, count: 3, step: [10, 0]}\n  - {plan: p/a.yaml, id: 'm{n}', count: 4, columns: 2, step: [10, 20], mirror: true, turn: 90}\n";
    let folder = folder(&[("city.yaml", project), ("p/a.yaml", ROOM)]);
    let path = folder.path().join("city.yaml");
    let reading = read(std::slice::from_ref(&path));
    assert!(reading.faults.is_empty(), "{}", reading.faults);
    let buildings = &reading.plan.buildings;
    let ids: Vec<&str> = buildings.iter().map(|placed| placed.id.as_str()).collect();
    assert_eq!(ids, ["a-1", "a-2", "a-3", "m1", "m2", "m3", "m4"]);
    assert!(Arc::ptr_eq(&buildings[0].building, &buildings[2].building));
    assert!(Arc::ptr_eq(&buildings[3].building, &buildings[6].building));
    assert!(!Arc::ptr_eq(&buildings[0].building, &buildings[3].building));
    assert_eq!(buildings[6].site.position.to_array(), [10.0, 20.0]);
    let settings = roomwright::internals::plan::project_settings(&[path]).unwrap();
    assert_eq!((settings.seed, settings.catalog), (Some(7), vec![folder.path().join("more")]));
    assert_eq!(read(&[folder.path().to_owned()]).plan.buildings.len(), 1, "folders give plans, not projects");
}

#[test]
fn a_mirrored_door_hangs_on_the_other_side() {
    let project =
        "version: 1\nproject:\n  plans:\n  - {plan: a.yaml}\n  - {plan: a.yaml, id: m, mirror: true}\n";
    let folder = folder(&[("city.yaml", project), ("a.yaml", ROOM)]);
    let reading = read(&[folder.path().join("city.yaml")]);
    let leaf = |index: usize| reading.plan.buildings[index].building.levels[0].openings[0].leaves[0];
    let (plain, mirrored) = (leaf(0), leaf(1));
    for (a, b) in [(plain.hinge, mirrored.hinge), (plain.open_tip, mirrored.open_tip)] {
        assert!((a.x + b.x).abs() < 1e-12 && (a.y - b.y).abs() < 1e-12, "{a} {b}");
    }
}

#[test]
fn faults_of_a_project_are_located() {
    let project = "version: 1\nproject:\n  plans:\n  - {plan: b.yaml}\n  - {plan: a.yaml, count: 2, id: x}\n  - {plan: city.yaml}\n  - {plan: a.yaml, id: '{m}'}\n  - {plan: bad.yaml}\n";
    let folder =
        folder(&[("city.yaml", project), ("a.yaml", ROOM), ("bad.yaml", "version: 2\nlevels: []\n")]);
    let reading = read(&[folder.path().join("city.yaml")]);
    let lines: Vec<_> =
        reading.faults.0.iter().map(|fault| (fault.position.unwrap().0, &fault.message[..14])).collect();
    assert_eq!(
        lines,
        [
            (1, "version 2 is n"),
            (2, "the building h"),
            (4, "there is no fi"),
            (5, "2 buildings ha"),
            (6, "a project cann"),
            (7, "\"{m}\" in \"{m}\""),
        ]
    );
}

#[test]
fn a_room_added_leaves_the_numbers_of_others() {
    let before = read_text(ROOM);
    let added = "  rooms:\n  - {id: new, type: office, rectangle: [4.1, 0, 4, 3]}";
    let after = read_text(&ROOM.replace("  rooms:", added));
    let number = |reading: &roomwright::internals::plan::PlanReading| {
        let rooms = &reading.plan.buildings[0].building.levels[0].rooms;
        rooms.iter().find(|room| room.id == "r").unwrap().number
    };
    assert_eq!(number(&before), number(&after));
}

#[test]
fn units_do_not_change_a_plan() {
    let metres = read_text(ROOM);
    let centimetres = ROOM
        .replace("version: 1", "version: 1\nunits: cm")
        .replace("[0, 0, 4, 3]", "[0, 0, 400, 300]")
        .replace("[1, 0]", "[100, 0]");
    let centimetres = read_text(&centimetres);
    let level = |reading: &roomwright::internals::plan::PlanReading| {
        summary(&reading.plan.buildings[0].building.levels[0])
    };
    assert_eq!(level(&metres), level(&centimetres));
    let digest = |reading: &roomwright::internals::plan::PlanReading| {
        reading.plan.buildings[0].building.levels[0].digest
    };
    assert_eq!(digest(&metres), digest(&centimetres));
}

#[test]
fn a_file_above_the_limit_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("huge.yaml");
    std::fs::File::create(&path).unwrap().set_len(2 << 30).unwrap();
    let reading = read(&[path]);
    assert!(
        reading.faults.to_string().contains("is 2048 MiB large, 512 MiB is the limit"),
        "{}",
        reading.faults
    );
}
