//! Edits files beside plans.

use std::fs;
use std::path::PathBuf;

use crate::catalog::{Catalog, builtin_catalog};
use crate::document::Faults;
use crate::edits::{EditBook, edits_path, read_edits};
use crate::plan::{Plan, PlanOptions, read_plans};

const PLAN: &str = "version: 1\nlevels:\n  - id: \"1\"\n    height: 3\n    rooms:\n      \
                    - {id: bed, type: bedroom, rectangle: [0, 0, 4, 4]}\n    openings:\n      \
                    - {kind: door, at: [3, 0], rooms: [bed]}\n";

struct World {
    folder: tempfile::TempDir,
    catalog: &'static Catalog,
}

impl World {
    fn new(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            fs::write(folder.path().join(name), text).unwrap();
        }
        Self { folder, catalog: builtin_catalog() }
    }

    fn plan(&self, name: &str) -> Plan {
        let path = self.folder.path().join(name);
        let reading = read_plans(&[path], &PlanOptions::new(&self.catalog.room_words));
        assert!(reading.faults.is_empty(), "{}", reading.faults);
        reading.plan
    }

    fn read(&self, plan: &str, named: &[&str]) -> (EditBook, Faults) {
        let named: Vec<PathBuf> = named.iter().map(|name| self.folder.path().join(name)).collect();
        read_edits(&self.plan(plan), &named, self.catalog)
    }
}

fn file(room: &str) -> String {
    format!("version: 1\nedits:\n- {room}\n")
}

/// The faults of an edits file with these lines about objects of the bedroom.
fn faults(objects: &str) -> Faults {
    let text = file(&format!("{{level: \"1\", room: bed, objects: {{{objects}}}}}"));
    World::new(&[("house.yaml", PLAN), ("house.edits.yaml", &text)]).read("house.yaml", &[]).1
}

#[test]
fn the_edits_file_lies_beside_the_plan_and_names_its_edits() {
    assert_eq!(edits_path("plans/house.yaml".as_ref()), PathBuf::from("plans/house.edits.yaml"));
    let text = file("{level: \"1\", room: bed, seed: 7, objects: {desk.1: {at: [1, 2]}}}");
    let world = World::new(&[("house.yaml", PLAN), ("house.edits.yaml", &text), ("other.yaml", PLAN)]);
    let (book, faults) = world.read("house.yaml", &[]);
    assert!(faults.is_empty(), "{faults}");
    let room = book.level("house", "1").unwrap().room("bed").unwrap();
    assert_eq!((room.seed, room.objects["desk.1"].entry.at.as_deref()), (Some(7), Some(&[1.0, 2.0][..])));
    assert!(world.read("other.yaml", &[]).0.is_empty());
}

#[test]
fn named_edits_files_win_over_those_beside_plans_and_one_building_over_all() {
    let all = "{level: \"1\", room: bed, seed: 1, objects: {desk.1: {turn: 1}, double_bed.1: {turn: 1}}}";
    let one = "{building: house, level: \"1\", room: bed, objects: {desk.1: {turn: 2}}}";
    let beside = format!("version: 1\nedits:\n- {one}\n- {all}\n");
    let named = file("{level: \"1\", room: bed, objects: {double_bed.1: {turn: 3}}}");
    let files = [("house.yaml", PLAN), ("house.edits.yaml", &*beside), ("new.yaml", &*named)];
    let (book, faults) = World::new(&files).read("house.yaml", &["new.yaml"]);
    assert!(faults.is_empty(), "{faults}");
    let room = book.level("house", "1").unwrap().room("bed").unwrap();
    let turn = |id: &str| room.objects[id].entry.turn.unwrap() as i32;
    assert_eq!((room.seed, turn("desk.1"), turn("double_bed.1")), (Some(1), 2, 3));
}

#[test]
fn a_project_has_edits_for_single_buildings() {
    let project = "version: 1\nproject:\n  plans:\n    - {plan: house.yaml, count: 3}\n";
    let text = file("{building: house-2, level: \"1\", room: bed, objects: {desk.1: {remove: true}}}");
    let general = file("{level: \"1\", room: bed, seed: 5}");
    let files = [
        ("house.yaml", PLAN),
        ("house.edits.yaml", &*general),
        ("city.yaml", project),
        ("city.edits.yaml", &*text),
    ];
    let (book, faults) = World::new(&files).read("city.yaml", &[]);
    assert!(faults.is_empty(), "{faults}");
    let objects = |building| {
        let room = book.level(building, "1").unwrap().room("bed").unwrap();
        assert_eq!(room.seed, Some(5));
        room.objects.len()
    };
    assert_eq!(["house-1", "house-2", "house-3"].map(objects), [0, 1, 0]);
}

#[test]
fn mirrored_buildings_want_edits_of_their_own() {
    let project = "version: 1\nproject:\n  plans:\n    - {plan: house.yaml, mirror: true}\n";
    let general = file("{level: \"1\", room: bed, seed: 5}");
    let files = [("house.yaml", PLAN), ("house.edits.yaml", &*general), ("city.yaml", project)];
    let (book, faults) = World::new(&files).read("city.yaml", &[]);
    assert!(book.is_empty() && faults.0[0].message.contains("mirrored"), "{faults}");
}

#[test]
fn edits_for_missing_rooms_are_warnings_with_their_place() {
    for (room, message, hint) in [
        ("{level: \"1\", room: bad, seed: 1}", "there is no room \"bad\" on level \"1\"", "bed"),
        ("{level: \"11\", room: bed, seed: 1}", "there is no level \"11\"", "\"1\""),
        ("{building: hous, level: \"1\", room: bed, seed: 1}", "there is no building \"hous\"", "house"),
    ] {
        let world = World::new(&[("house.yaml", PLAN), ("house.edits.yaml", &file(room))]);
        let (book, faults) = world.read("house.yaml", &[]);
        let fault = &faults.0[0];
        assert!(book.is_empty() && !fault.is_error() && fault.message.starts_with(message), "{fault}");
        assert_eq!(fault.position.unwrap().0, 3);
        assert!(fault.hint.as_ref().unwrap().contains(hint), "{fault:?}");
    }
}

#[test]
fn of_thousands_of_edits_of_a_room_the_first_are_applied() {
    let objects: Vec<String> = (1..=2_500).map(|number| format!("plant.{number}: {{turn: 3}}")).collect();
    let faults = faults(&objects.join(", "));
    assert_eq!(faults.0.len(), 1, "{faults}");
    assert_eq!(faults.0[0].message, "has edits of 2500 objects");
}

#[test]
fn of_many_edits_of_rooms_that_are_not_there_the_first_are_reported() {
    let objects: Vec<String> = (0..1_000).map(|number| format!("desk.{number}x: {{turn: 3}}")).collect();
    let faults = faults(&objects.join(", "));
    assert!(faults.0.len() < 250, "{}", faults.0.len());
    assert!(faults.0.last().is_some_and(|fault| fault.message.ends_with("more like it)")), "{faults}");
}

#[test]
fn edits_that_make_no_sense_are_faults_and_the_others_stay() {
    for (objects, message) in [
        ("desk: {remove: true}", "\"desk\" is no id of an object"),
        ("desk.1: {remove: true, turn: 3}", "is removed and changed at once"),
        ("desk.1: {lock: true}", "does not say where it stands"),
        ("desk.7: {add: true, class: chair, at: [1, 1]}", "a new object has a second class"),
        ("desk.1: {lock: true, at: [1, 1], class: chair}", "is locked and of another class at once"),
        ("desk.1: {at: [1]}", "[1.0] is no place"),
        ("desk.1: {at: [1e300, 0]}", "e300, 0.0] is no place"),
        ("desk.1: {}", "says nothing of it"),
        ("dekc.1: {turn: 3}", "unknown class \"dekc\""),
        ("desk.1: {class: dekc}", "unknown class \"dekc\""),
        ("desk.1: {variant: 9999}", "desk has no variant 9999"),
        ("desk.1: {tunr: 3}", "unknown key \"tunr\""),
    ] {
        let faults = faults(objects);
        assert!(faults.has_errors() && faults.0[0].message.contains(message), "{objects}: {faults}");
        assert!(faults.0[0].position.is_some() && faults.0[0].hint.is_some(), "{objects}: {faults}");
    }
    assert!(faults("desk.1: {lock: true, at: [1, 1]}, desk.2: {add: true, at: [2, 2, 0]}").is_empty());
}

#[test]
fn equal_edits_have_one_fingerprint_wherever_they_are_written() {
    let fingerprint = |text: &str| {
        let world = World::new(&[("house.yaml", PLAN), ("house.edits.yaml", text)]);
        world.read("house.yaml", &[]).0.level("house", "1").unwrap().fingerprint()
    };
    let one = fingerprint(&file("{level: \"1\", room: bed, objects: {desk.1: {turn: 3}}}"));
    let same =
        "# moved\nversion: 1\nedits:\n- level: \"1\"\n  room: bed\n  objects:\n    desk.1: {turn: 3.0}\n";
    assert_eq!(one, fingerprint(same));
    assert_ne!(one, fingerprint(&file("{level: \"1\", room: bed, objects: {desk.1: {turn: 4}}}")));
}
