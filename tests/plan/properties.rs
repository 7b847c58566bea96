//! Random plans give a plan or faults, and the plan keeps its guarantees.

use std::path::PathBuf;

use proptest::prelude::*;
use roomwright::internals::plan::{Level, PlanReading};

use super::support::{files, read_text, repository};

/// What a mutation puts in the place of a piece of a plan.
const PIECES: [&str; 24] = [
    "", " ", "\n", "  ", "-", ":", "[", "]", "{", "}", ",", "#", "\"", "0", "-1", "1e9", ".nan", "1e400",
    "null", "{n}", "{level}", "*a", "&a ", "\u{fffd}",
];

fn sources() -> Vec<String> {
    let folders = ["tests/cases/plan", "tests/cases/plan/faults", "configs/plans"];
    let plans: Vec<PathBuf> =
        folders.iter().flat_map(|folder| files(&repository(folder), &["yaml"])).collect();
    let texts = plans.iter().map(|plan| std::fs::read_to_string(plan).unwrap());
    // Large plans are slow to read a thousand times, and mutate no differently.
    texts.filter(|text| text.contains("\nlevels:") && text.len() < 4000).collect()
}

fn mutated() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(&PIECES[..]);
    let mutation = (any::<prop::sample::Index>(), 0_usize..12, piece);
    (prop::sample::select(sources()), prop::collection::vec(mutation, 1..4)).prop_map(|(text, mutations)| {
        let mut letters: Vec<char> = text.chars().collect();
        for (place, removed, piece) in mutations {
            let start = place.index(letters.len() + 1);
            let end = (start + removed).min(letters.len());
            letters.splice(start..end, piece.chars());
        }
        letters.into_iter().collect()
    })
}

fn numbers() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        -20.0..20.0_f64,
        (-40_i32..40).prop_map(|quarter| f64::from(quarter) / 4.0),
        prop::sample::select(&[0.0, -0.0, 1e-9, 1e5, 1e308, 5e-324][..]),
    ];
    let point = (number.clone(), number).prop_map(|(x, y)| format!("[{x}, {y}]"));
    let outline =
        prop::collection::vec(point.clone(), 0..9).prop_map(|points| format!("[{}]", points.join(", ")));
    (prop::collection::vec(outline, 1..4), prop::collection::vec(point, 0..4), any::<bool>()).prop_map(
        |(outlines, doors, is_center)| {
            let mut text = format!("version: 1\noutlines: {}\n", if is_center { "center" } else { "inner" });
            text.push_str("levels:\n- id: a\n  rooms:\n");
            for (index, outline) in outlines.iter().enumerate() {
                text.push_str(&format!("  - {{id: r{index}, type: office, outline: {outline}}}\n"));
            }
            text.push_str("  openings:\n");
            for door in doors {
                text.push_str(&format!("  - {{kind: door, at: {door}}}\n"));
            }
            text
        },
    )
}

/// The promises of `plan/mod.rs`.
fn assert_promises(level: &Level) {
    for room in &level.rooms {
        assert_eq!(room.walls.len(), room.region.borders().count(), "one wall per border");
        for (wall, border) in room.walls.iter().zip(room.region.borders()) {
            assert_eq!(wall.segment(), border);
            assert!(wall.thickness >= 0.0 && wall.thickness.is_finite());
        }
        for entry in &room.openings {
            assert!(entry.from < entry.to && entry.from >= -1e-9);
            assert!(entry.to <= room.walls[entry.wall].length() + 1e-9);
        }
    }
    for (number, opening) in level.openings.iter().enumerate() {
        assert!(!opening.sides.is_empty() && opening.bottom < opening.top);
        for side in &opening.sides {
            let room = &level.rooms[side.room];
            assert!(room.openings.iter().any(|entry| entry.opening == number && entry.wall == side.wall));
        }
    }
    let mut ids: Vec<&str> = level.rooms.iter().map(|room| room.id.as_str()).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), level.rooms.len(), "ids are unique");
}

fn assert_sound(reading: &PlanReading) {
    assert!(reading.faults.has_errors() || !reading.plan.buildings.is_empty());
    assert!(reading.faults.0.iter().all(|fault| !fault.message.is_empty()));
    // The full report is printed whatever the texts hold.
    assert!(reading.faults.to_string().lines().count() >= reading.faults.0.len());
    let buildings = reading.plan.buildings.iter();
    buildings.flat_map(|placed| &placed.building.levels).for_each(assert_promises);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn mutated_plans_give_a_plan_or_faults(text in mutated()) {
        assert_sound(&read_text(&text));
    }

    #[test]
    fn rooms_of_any_numbers_give_a_plan_or_faults(text in numbers()) {
        assert_sound(&read_text(&text));
    }

    #[test]
    fn random_bytes_give_faults(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plan.yaml");
        std::fs::write(&path, &bytes).unwrap();
        prop_assert!(super::support::read(&[path]).faults.has_errors());
    }
}
