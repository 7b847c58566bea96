//! Buildings written as native plans and read back.

use std::path::PathBuf;

use roomwright::internals::plan::{
    Building, Level, PlanOptions, PlanReading, RoomWords, Wall, read_plans, write_native,
};

use super::support::{files, read, repository};

/// Metres that a length may change by, for they are rounded.
const TOLERANCE: f64 = 2e-5;

fn read_any(path: PathBuf) -> PlanReading {
    // Room types are the catalogue's business.
    let words = RoomWords::default();
    read_plans(&[path], &PlanOptions::new(&words))
}

fn written_and_read(building: &Building) -> (String, PlanReading) {
    let text = write_native(building, "again");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("again.yaml");
    std::fs::write(&path, &text).unwrap();
    (text, read_any(path))
}

fn assert_near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= TOLERANCE, "{what}: {a} became {b}");
}

/// Which of two walls of one length is called the longest, the last digit decides.
fn tags(wall: &Wall) -> Vec<&str> {
    wall.tags.iter().map(String::as_str).filter(|tag| *tag != "longest").collect()
}

fn assert_same(before: &Level, after: &Level) {
    assert_eq!((&before.id, &before.name), (&after.id, &after.name));
    assert_near(before.elevation, after.elevation, "elevation");
    assert_eq!(before.rooms.len(), after.rooms.len());
    for (a, b) in before.rooms.iter().zip(&after.rooms) {
        assert_eq!((&a.id, a.number, &a.name, &a.style), (&b.id, b.number, &b.name, &b.style));
        assert_eq!(a.room_type, b.room_type);
        assert_near(a.height, b.height, &a.id);
        assert_eq!(a.walls.len(), b.walls.len(), "walls of room {}", a.id);
        for (wall, again) in a.walls.iter().zip(&b.walls) {
            assert!(wall.start.distance(again.start) < TOLERANCE, "room {}", a.id);
            assert_eq!((wall.kind, wall.is_exterior), (again.kind, again.is_exterior), "room {}", a.id);
            assert_eq!(tags(wall), tags(again), "room {}", a.id);
        }
        assert_eq!(a.obstacles.len(), b.obstacles.len(), "columns of room {}", a.id);
        for (column, again) in a.obstacles.iter().zip(&b.obstacles) {
            assert_near(column.height, again.height, "column");
        }
    }
    assert_eq!(before.openings.len(), after.openings.len());
    for (a, b) in before.openings.iter().zip(&after.openings) {
        assert_eq!((&a.id, a.kind), (&b.id, b.kind));
        assert_near(a.width, b.width, &a.id);
        assert_near(a.bottom, b.bottom, &a.id);
        assert_near(a.top, b.top, &a.id);
        assert_eq!(a.sides.len(), b.sides.len(), "sides of opening {}", a.id);
        for (side, again) in a.sides.iter().zip(&b.sides) {
            assert_eq!((side.room, side.wall), (again.room, again.wall), "opening {}", a.id);
            assert_near(side.from, again.from, &a.id);
        }
        assert_eq!(a.leaves.len(), b.leaves.len(), "leaves of opening {}", a.id);
        for (leaf, again) in a.leaves.iter().zip(&b.leaves) {
            assert!(leaf.hinge.distance(again.hinge) < TOLERANCE, "hinge of {}", a.id);
            assert!(leaf.open_tip.distance(again.open_tip) < 10.0 * TOLERANCE, "leaf of {}", a.id);
        }
    }
}

#[test]
fn every_plan_survives_being_written() {
    let folders = ["tests/cases/plan", "configs/plans", "configs/paper", "configs/cases"];
    let plans: Vec<PathBuf> =
        folders.iter().flat_map(|folder| files(&repository(folder), &["yaml"])).collect();
    assert!(plans.len() > 10);
    for plan in plans {
        for placed in read_any(plan.clone()).plan.buildings {
            let (text, again) = written_and_read(&placed.building);
            assert!(!again.faults.has_errors(), "{}:\n{}", plan.display(), again.faults);
            let levels = &again.plan.buildings[0].building.levels;
            assert_eq!(placed.building.levels.len(), levels.len());
            placed.building.levels.iter().zip(levels).for_each(|(before, after)| assert_same(before, after));
            let twice = write_native(&again.plan.buildings[0].building, "again");
            assert_eq!(text, twice, "{}: written twice, the same text", plan.display());
        }
    }
}

#[test]
fn a_written_plan_is_readable() {
    let reading = read(&[repository("tests/cases/plan/centre_lines.yaml")]);
    let text = write_native(&reading.plan.buildings[0].building, "flat");
    crate::golden::check_golden(&repository("tests/cases/plan/written/flat.yaml"), &text);
}
