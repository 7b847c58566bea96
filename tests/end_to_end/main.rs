//! Runs whole plans through every stage in memory, reads the output back with the `gltf` crate, and checks all its
//! guarantees.
//!
//! Built-in plans are always baked, the real ones if the folder `shared/data/floorplans` lies beside or above the
//! project.
#![allow(clippy::unwrap_used, clippy::print_stdout, unreachable_pub)]

mod contract;
mod parking;
mod pipeline;
mod read_back;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use roomwright::internals::audit::AuditSummary;
use roomwright::internals::document::FaultSeverity;
use roomwright::internals::layout::{Alternative, FurnishOptions, Placement, RoomLayout, furnish};
use roomwright::internals::plan::{Building, write_native};

use contract::{check_level, grave_findings};
use pipeline::{BakedLevel, Pipeline, each_level};
use read_back::check_agreement;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every ready plan in a folder of `configs/`.
fn ready_plans(folder: &str) -> Vec<PathBuf> {
    let listed = std::fs::read_dir(root().join("configs").join(folder)).unwrap();
    let mut files: Vec<PathBuf> = listed.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|kind| kind == "yaml"));
    files.sort();
    assert!(!files.is_empty(), "configs/{folder} holds plans");
    files
}

/// The floor plans of other people, if they are there.
fn real_plans() -> Option<PathBuf> {
    let folder =
        root().ancestors().map(|folder| folder.join("shared/data/floorplans")).find(|folder| folder.is_dir());
    if folder.is_none() {
        println!("skipped: there is no shared/data/floorplans beside or above {}", root().display());
    }
    folder
}

/// Bakes every distinct level of some plans; asserts what holds for each; the answer counts verdicts.
fn bake_and_check(pipeline: &Pipeline, paths: &[PathBuf]) -> (usize, AuditSummary) {
    let mut summary = AuditSummary::default();
    let mut level_count = 0;
    let mut grave = Vec::new();
    let mut known = BTreeSet::new();
    let reading = pipeline.read(paths);
    let errors: Vec<String> = reading
        .faults
        .0
        .iter()
        .filter(|fault| fault.severity == FaultSeverity::Error)
        .map(ToString::to_string)
        .collect();
    assert!(errors.is_empty(), "{errors:#?}");
    each_level(&reading.plan, |building, level| {
        // Storeys that repeat are equal but for their seeds: one of them is enough here.
        if !known.insert(level.digest) {
            return;
        }
        let baked = pipeline.bake(building, level);
        check_level(&baked, &pipeline.catalog);
        check_agreement(pipeline, &baked);
        grave.extend(grave_findings(&baked));
        level_count += 1;
        baked.verdicts.iter().for_each(|verdict| summary.add_room(verdict));
    });
    assert!(grave.is_empty(), "{} of {} rooms: {grave:#?}", grave.len(), summary.room_count());
    (level_count, summary)
}

#[test]
fn built_in_plans_keep_the_contract_of_the_output() {
    let pipeline = Pipeline::new();
    for folder in ["paper", "cases", "plans"] {
        for plan in ready_plans(folder) {
            let (levels, summary) = bake_and_check(&pipeline, std::slice::from_ref(&plan));
            let name = plan.strip_prefix(root()).unwrap().display();
            println!("{name}: {levels} levels, {summary:?}");
            assert!(levels > 0 && summary.room_count() > 0, "{name} holds rooms");
        }
    }
}

#[test]
fn the_same_plan_gives_the_same_bytes_and_another_seed_gives_others() {
    let plans = [root().join("configs/paper/office.yaml")];
    let bytes = |seed| {
        let pipeline = Pipeline { seed, ..Pipeline::new() };
        let mut files: Vec<Vec<u8>> = Vec::new();
        each_level(&pipeline.read(&plans).plan, |building, level| {
            files.push(pipeline.bake(building, level).glb)
        });
        files
    };
    let first = bytes(1);
    assert!(!first.is_empty());
    assert!(first == bytes(1), "the same seed");
    assert!(first != bytes(2), "another seed");
}

#[test]
fn changing_one_room_changes_its_nodes_only() {
    let pipeline = Pipeline::new();
    let reading = pipeline.read(&[root().join("configs/cases/flat.yaml")]);
    each_level(&reading.plan, |building, level| {
        let before = pipeline.bake(building, level);
        let mut changed = level.clone();
        let target = changed.rooms.iter().position(|room| room.room_type != "corridor").unwrap();
        changed.rooms[target].room_type = "storeroom".into();
        let after = pipeline.bake(building, &changed);
        for (index, room) in level.rooms.iter().enumerate() {
            let is_same = room_lines(&before, &room.id) == room_lines(&after, &room.id);
            assert_eq!(is_same, index != target, "room {}", room.id);
        }
    });
}

#[test]
fn an_explained_room_is_the_room_and_accounts_for_every_piece() {
    let pipeline = Pipeline::new();
    let mut known = BTreeSet::new();
    let mut room_count = 0;
    each_level(&pipeline.read(&ready_plans("plans")).plan, |building, level| {
        if !known.insert(level.digest) {
            return;
        }
        for room in 0..level.rooms.len() {
            let options = FurnishOptions::new(1, building);
            let (furnished, told) = RoomLayout::new(level.room(room), &pipeline.catalog, &options)
                .explain(&Alternative::default());
            let name = format!("{building}/{}/{}", level.id, level.rooms[room].id);
            assert_eq!(furnished, furnish(level.room(room), &pipeline.catalog, &options), "{name}");
            let id = |object: &Placement| {
                format!("{}.{}", pipeline.catalog.classes[object.class].id, object.number)
            };
            let ids: Vec<String> = furnished.placements.iter().map(id).collect();
            assert_eq!(
                told.objects.iter().map(|object| object.id.clone()).collect::<Vec<_>>(),
                ids,
                "{name}"
            );
            let reasons: Vec<&str> = furnished.removals.iter().map(|removal| removal.reason.name()).collect();
            assert_eq!(told.missing.iter().map(|piece| piece.reason).collect::<Vec<_>>(), reasons, "{name}");
            room_count += 1;
        }
    });
    assert!(room_count > 50, "{room_count} rooms");
}

/// A line for each node of a room: name, place and what it is.
fn room_lines(baked: &BakedLevel<'_>, room: &str) -> Vec<String> {
    let document = gltf::Gltf::from_slice(&baked.glb).unwrap();
    let owner = format!("@{room}");
    let own = document.nodes().filter(|node| {
        let name = node.name().unwrap();
        name.ends_with(&owner) || name == format!("room:{room}")
    });
    own.map(|node| {
        let extras = node.extras().as_ref().map(|extras| extras.get().to_owned());
        format!("{} {:?} {extras:?}", node.name().unwrap(), node.transform())
    })
    .collect()
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn real_apartment_blocks_have_no_room_that_fails() {
    let Some(folder) = real_plans() else { return };
    let pipeline = Pipeline::new();
    let (levels, summary) = bake_and_check(&pipeline, &[folder.join("archilyse")]);
    println!("archilyse: {levels} levels, {summary:?}");
    assert_eq!(levels, 14);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn a_real_university_has_no_room_that_fails() {
    let Some(folder) = real_plans() else { return };
    let pipeline = Pipeline::new();
    let (levels, summary) = bake_and_check(&pipeline, &[folder.join("imdf-spbpu")]);
    println!("imdf-spbpu: {levels} levels, {summary:?}");
    assert_eq!(levels, 8);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn a_real_pair_of_houses_has_no_room_that_fails() {
    let Some(folder) = real_plans() else { return };
    let pipeline = Pipeline::new();
    let (levels, summary) = bake_and_check(&pipeline, &[folder.join("ifc")]);
    println!("ifc: {levels} levels, {summary:?}");
    assert_eq!(levels, 3);
}

/// What reading a written plan back must give again.
fn outline(building: &Building) -> Vec<(String, Vec<String>, usize)> {
    let level = |level: &roomwright::internals::plan::Level| {
        let rooms = level.rooms.iter().map(|room| format!("{} {} {}", room.id, room.number, room.room_type));
        (level.id.clone(), rooms.collect(), level.openings.len())
    };
    building.levels.iter().map(level).collect()
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn imports_of_real_plans_read_back_without_an_error() {
    let Some(folder) = real_plans() else { return };
    let pipeline = Pipeline::new();
    let read = pipeline.read(&["archilyse", "imdf-spbpu", "ifc"].map(|name| folder.join(name)));
    let written = tempfile::tempdir().unwrap();
    for placed in &read.plan.buildings {
        let file = written.path().join("plan.yaml");
        std::fs::write(&file, write_native(&placed.building, &placed.id)).unwrap();
        let back = pipeline.read(&[file]);
        let errors = back.faults.0.iter().filter(|fault| fault.severity == FaultSeverity::Error);
        let errors: Vec<String> = errors.map(ToString::to_string).collect();
        assert!(errors.is_empty(), "{}: {errors:#?}", placed.id);
        assert_eq!(outline(&back.plan.buildings[0].building), outline(&placed.building), "{}", placed.id);
    }
    assert_eq!(read.plan.buildings.len(), 12);
}
