//! Plans of foreign formats: every folder of `tests/cases/plan_import` is read and gives its golden, faults included.
//!
//! All cases are made for these tests, a folder for each. A new case needs no change here: its golden is written beside its folder
//! with `UPDATE_GOLDENS=1 cargo test --test plan import`. A golden whose folder is gone fails.

use std::path::PathBuf;

use roomwright::internals::catalog::load_catalog;
use roomwright::internals::plan::{Level, PlanOptions, PlanReading, WallKind, read_plans};

use super::support::{repository, summary};
use crate::golden::check_golden;

fn read(path: PathBuf) -> PlanReading {
    let catalog = load_catalog(&[]).unwrap().value;
    read_plans(&[path], &PlanOptions::new(&catalog.room_words))
}

/// Whatever lies in the folder of the cases.
fn entries() -> impl Iterator<Item = PathBuf> {
    let entries = std::fs::read_dir(repository("tests/cases/plan_import")).unwrap();
    entries.map(|entry| entry.unwrap().path())
}

fn cases() -> Vec<PathBuf> {
    let mut cases: Vec<PathBuf> = entries().filter(|path| path.is_dir()).collect();
    cases.sort();
    cases
}

/// One line per wall: where, how thick, what stands behind, which tags.
fn walls(level: &Level) -> String {
    let mut text = String::new();
    for room in &level.rooms {
        text.push_str(&format!("  walls of {} \"{}\"\n", room.id, room.name.as_deref().unwrap_or("-")));
        for wall in &room.walls {
            let (start, end) = (wall.start, wall.end);
            let railing = if wall.kind == WallKind::Solid { "" } else { " railing" };
            text.push_str(&format!(
                "    {:.3},{:.3} to {:.3},{:.3} thick {:.3}{railing}: {}\n",
                start.x,
                start.y,
                end.x,
                end.y,
                wall.thickness,
                wall.tags.join(" ")
            ));
        }
    }
    text.replace("-0.000", "0.000")
}

#[test]
fn every_golden_has_its_case() {
    let goldens: Vec<PathBuf> =
        entries().filter(|path| path.extension().is_some_and(|is| is == "txt")).collect();
    assert!(!goldens.is_empty());
    for golden in goldens {
        let case = golden.with_extension("");
        assert!(case.is_dir(), "the case of {} is missing", golden.display());
    }
}

#[test]
fn every_case_gives_its_golden() {
    for case in cases() {
        let reading = read(case.clone());
        let mut text = String::new();
        for placed in &reading.plan.buildings {
            let name = placed.building.name.as_deref().unwrap_or("-");
            text.push_str(&format!("building {} \"{name}\"\n", placed.id));
            for level in &placed.building.levels {
                text.push_str(&summary(level));
                text.push_str(&walls(level));
            }
        }
        for fault in &reading.faults {
            let hint = fault.hint.as_deref().unwrap_or("-");
            text.push_str(&format!("{:?}: {} [{hint}]\n", fault.severity, fault.message));
        }
        check_golden(&case.with_extension("txt"), &text);
    }
}

#[test]
fn a_folder_is_searched_for_foreign_plans() {
    let reading = read(repository("tests/cases/plan_import"));
    // Some cases have a faulty room; none is lost for it.
    let ids = |reading: &PlanReading| -> Vec<String> {
        reading.plan.buildings.iter().map(|placed| placed.id.clone()).collect()
    };
    let mut of_cases: Vec<String> = cases().into_iter().flat_map(|case| ids(&read(case))).collect();
    of_cases.sort();
    assert!(["block", "house_1", "plan_7", "villa"].iter().all(|id| of_cases.contains(&(*id).to_owned())));
    assert_eq!(ids(&reading), of_cases);
}

#[test]
fn foreign_room_words_become_types_of_the_catalogue() {
    let catalog = load_catalog(&[]).unwrap().value;
    let reading = read(repository("tests/cases/plan_import"));
    for placed in &reading.plan.buildings {
        for room in placed.building.levels.iter().flat_map(|level| &level.rooms) {
            assert!(catalog.room_words.known.contains(&room.room_type), "{}", room.room_type);
        }
    }
}
