//! Locked objects are placed before the others.

use super::edits;
use crate::best::furnish_best;
use crate::catalog::{Catalog, builtin_catalog};
use crate::document::Source;
use crate::edits::{RoomEdits, finish};
use crate::layout::{FurnishOptions, Furnished, Placement};
use crate::plan::{Level, PlanOptions, read_plans};

const PLAN: &str = "version: 1\nlevels:\n  - id: \"1\"\n    height: 3\n    rooms:\n      \
                    - {id: study, type: study, rectangle: [0, 0, 5, 4]}\n    openings:\n      \
                    - {kind: door, at: [4.5, 0], rooms: [study], width: 0.8}\n";

fn level(catalog: &Catalog) -> Level {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("house.yaml");
    std::fs::write(&path, Source::new("house.yaml".as_ref(), PLAN).text()).unwrap();
    let mut plan = read_plans(&[path], &PlanOptions::new(&catalog.room_words)).plan;
    plan.buildings.remove(0).building.levels[0].clone()
}

fn furnish(level: &Level, catalog: &Catalog, seed: u64, edits: &RoomEdits) -> (Furnished, usize) {
    let locks = edits.locks(level.room(0), catalog);
    let run = edits.options(FurnishOptions::new(seed, "house"), &locks);
    let judged = furnish_best(level.room(0), catalog, &run, 4);
    let judge = |furnished: &Furnished| crate::solve::judge_room(level.room(0), furnished, catalog);
    let finished = finish(level, judged, edits, catalog, judge);
    (finished.judged.furnished, finished.misfits.len())
}

fn object<'a>(furnished: &'a Furnished, catalog: &Catalog, id: &str) -> Option<&'a Placement> {
    let name = |placement: &&Placement| {
        format!("{}.{}", catalog.classes[placement.class].id, placement.number) == id
    };
    furnished.placements.iter().find(name)
}

#[test]
fn a_locked_desk_stands_where_it_was_put_and_its_chair_comes_to_it() {
    let catalog = builtin_catalog();
    let level = level(catalog);
    let edits = edits(&["desk.1: {lock: true, parent: wall.2, at: [2.2, 3.6], turn: 0}"]);
    for seed in 1..20 {
        let (furnished, misfits) = furnish(&level, catalog, seed, &edits);
        let desk = object(&furnished, catalog, "desk.1").unwrap();
        assert_eq!((desk.position.x, desk.position.y, desk.angle), (2.2, 3.6, 0.0), "seed {seed}");
        assert_eq!(misfits, 0, "seed {seed}: nothing else stands there");
        let chair = object(&furnished, catalog, "office_chair.1").unwrap();
        assert!(chair.position.distance(desk.position) < 1.0, "seed {seed}");
    }
}

#[test]
fn a_locked_object_that_the_programme_lacks_is_one_more_piece() {
    let catalog = builtin_catalog();
    let level = level(catalog);
    let (plain, _) = furnish(&level, catalog, 1, &RoomEdits::default());
    assert!(object(&plain, catalog, "piano.1").is_none());
    let edits = edits(&["plant.9: {lock: true, at: [0.5, 3.5], turn: 0}"]);
    let (furnished, misfits) = furnish(&level, catalog, 1, &edits);
    let plant = object(&furnished, catalog, "plant.9").unwrap();
    assert_eq!((plant.position.x, plant.position.y, misfits), (0.5, 3.5, 0));
}

#[test]
fn an_object_locked_on_another_stands_on_it_or_is_reported() {
    let catalog = builtin_catalog();
    let level = level(catalog);
    let lamp = edits(&["desk_lamp.1: {lock: true, parent: desk.1, at: [0.5, 0.1], turn: 0}"]);
    let (furnished, misfits) = furnish(&level, catalog, 3, &lamp);
    let desk = object(&furnished, catalog, "desk.1").unwrap();
    let lamp = object(&furnished, catalog, "desk_lamp.1").unwrap();
    assert!((lamp.position.distance(desk.position) - 0.26_f64.sqrt()).abs() < 1e-9);
    assert!((lamp.elevation - desk.size.height).abs() < 1e-9);
    assert_eq!(misfits, 0);
    let nowhere = edits(&["desk_lamp.1: {lock: true, parent: desk.7, at: [0.5, 0.1], turn: 0}"]);
    assert_eq!(furnish(&level, catalog, 3, &nowhere).1, 1);
}

#[test]
fn a_pinned_room_does_not_follow_the_seed_of_the_run() {
    let catalog = builtin_catalog();
    let level = level(catalog);
    let pinned = RoomEdits { seed: Some(7), ..RoomEdits::default() };
    let (one, _) = furnish(&level, catalog, 1, &pinned);
    assert_eq!(one, furnish(&level, catalog, 2, &pinned).0);
    assert_eq!(one, furnish(&level, catalog, 7, &RoomEdits::default()).0);
    assert_ne!(one, furnish(&level, catalog, 1, &RoomEdits::default()).0);
}
