//! Plans with wrong units or broken coordinates: rooms beyond the limits are reported and left out, the rest is read.

use std::path::Path;

use roomwright::internals::plan::PlanReading;

use super::support::{read_ready, read_text, repository};

/// Reads a copy of a case with replacements in one of its files.
fn changed(case: &str, file: &str, replacements: &[(&str, &str)]) -> PlanReading {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join(case);
    std::fs::create_dir(&target).unwrap();
    for entry in std::fs::read_dir(repository("tests/cases/plan_import").join(case)).unwrap() {
        let path = entry.unwrap().path();
        let mut text = std::fs::read_to_string(&path).unwrap();
        if path.file_name() == Path::new(file).file_name() {
            for (from, to) in replacements {
                assert!(text.contains(from), "{file} has no {from}");
                text = text.replace(from, to);
            }
        }
        std::fs::write(target.join(path.file_name().unwrap()), text).unwrap();
    }
    read_ready(&[target])
}

fn room_ids(reading: &PlanReading) -> Vec<&str> {
    let levels = reading.plan.buildings.iter().flat_map(|placed| &placed.building.levels);
    levels.flat_map(|level| &level.rooms).map(|room| room.id.as_str()).collect()
}

/// All errors with their hints.
fn errors(reading: &PlanReading) -> Vec<String> {
    let errors = reading.faults.0.iter().filter(|fault| fault.is_error());
    errors.map(|fault| format!("{} ({})", fault.message, fault.hint.as_deref().unwrap_or("-"))).collect()
}

#[test]
fn rooms_of_kilometres_from_a_broken_ifc_unit_are_left_out() {
    let reading = changed("villa", "villa.ifc", &[("(#3,#4)", "(#99,#4)")]);
    let errors = errors(&reading);
    assert!(room_ids(&reading).is_empty(), "{errors:?}");
    assert!(errors.iter().any(|error| error.contains("m wide and")), "{errors:?}");
    assert!(errors.iter().any(|error| error.contains("millimetres are read as metres")), "{errors:?}");
    assert!(errors.len() < 20, "{errors:?}");
}

#[test]
fn a_longitude_five_degrees_off_leaves_out_one_room() {
    let reading = changed("campus", "unit.geojson", &[("[[[30.000159179, ", "[[[35.000159179, ")]);
    let whole = read_ready(&[repository("tests/cases/plan_import/campus")]);
    let (found, all) = (room_ids(&reading), room_ids(&whole));
    let lost: Vec<&&str> = all.iter().filter(|id| !found.contains(id)).collect();
    assert_eq!(lost, [&"u-odd"]);
    let errors = errors(&reading);
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert!(errors[0].contains("room \"u-odd\": corner 0 is 279 km from the origin"), "{errors:?}");
}

#[test]
fn a_room_five_degrees_away_is_far_from_the_others() {
    let moved: Vec<(&str, &str)> = vec![
        ("[30.000159179, 60.000095879], [30.000293902", "[35.000159179, 60.000095879], [35.000293902"),
        (
            "[30.000263255, 60.00016261], [30.000128532, 60.000138051], [30.000159179, 60.000095879]]]}, \"properties\": {\"category\": \"planetarium\"",
            "[35.000263255, 60.00016261], [35.000128532, 60.000138051], [35.000159179, 60.000095879]]]}, \"properties\": {\"category\": \"planetarium\"",
        ),
    ];
    let errors = errors(&changed("campus", "unit.geojson", &moved));
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert!(errors[0].contains("room \"u-odd\"") && errors[0].contains("km from"), "{errors:?}");
}

#[test]
fn a_level_far_off_leaves_its_rooms_where_they_are() {
    let level = "[[[30.0, 60.0]";
    let reading = changed("campus", "level.geojson", &[(level, "[[[60.0, 60.0]")]);
    let whole = read_ready(&[repository("tests/cases/plan_import/campus")]);
    assert_eq!(room_ids(&reading), room_ids(&whole));
    let areas = |reading: &PlanReading| -> f64 {
        let levels = reading.plan.buildings.iter().flat_map(|placed| &placed.building.levels);
        levels.flat_map(|level| &level.rooms).map(|room| room.region.area()).sum()
    };
    assert!((areas(&reading) - areas(&whole)).abs() < 0.1, "{} {}", areas(&reading), areas(&whole));
}

const NATIVE: &str = "version: 1\nlevels:\n  - id: ground\n    rooms:\n";
const GOOD: &str = "      - {id: good, type: office, rectangle: [0, 0, 4, 3]}\n";

#[test]
fn a_native_room_that_is_too_large_leaves_the_others() {
    for (shape, fact) in [
        ("rectangle: [10, 0, 5000, 3000]", "room \"big\" is 5000 m wide"),
        ("rectangle: [10, 0, 900, 900]", "room \"big\" is 900 m wide and 900 m deep"),
        ("rectangle: [10, 0, 400, 400]", "room \"big\" has 160000 m²"),
        ("rectangle: [10, 0, -5, 3]", "room \"big\" has a width of -5"),
        ("rectangle: [200000, 0, 5, 3]", "[200000, 0] is farther than 100 km from the origin"),
        ("rectangle: [20000, 0, 5, 3]", "room \"big\" lies 20 km from the other rooms"),
    ] {
        let doors = "    openings:\n      - {kind: door, room: big, edge: 0, at: 1}\n      - {kind: door, room: good, edge: 0}\n";
        let other = "      - {id: other, type: office, rectangle: [5, 0, 4, 3]}\n";
        let text = format!("{NATIVE}{GOOD}{other}      - {{id: big, type: office, {shape}}}\n{doors}");
        let reading = read_text(&text);
        assert_eq!(room_ids(&reading), ["good", "other"], "{shape}: {}", reading.faults);
        let errors = errors(&reading);
        assert_eq!(errors.len(), 1, "{shape}: {errors:?}");
        assert!(errors[0].contains(fact), "{shape}: {errors:?}");
        assert!(reading.faults.0.iter().all(|fault| fault.position.is_some()), "{}", reading.faults);
    }
}

#[test]
fn audit_reads_every_level_that_bake_writes() {
    // The largest room of each shape: the finished file is read back by the same table.
    for size in ["1000, 100", "316, 316"] {
        let reading =
            read_text(&format!("{NATIVE}      - {{id: hall, type: office, rectangle: [0, 0, {size}]}}\n"));
        assert_eq!(room_ids(&reading), ["hall"], "{}", reading.faults);
        assert!(!reading.faults.has_errors(), "{}", reading.faults);
    }
}

#[test]
fn outlines_with_too_many_corners_name_their_count() {
    // Battlements.
    let corner = |index: u32| format!("[{:.1}, {}]", f64::from(index / 2) * 0.1, 10 + index % 4 / 2);
    let corners: Vec<String> =
        (0..4998).map(corner).chain(["[249.8, 0]".to_owned(), "[0, 0]".to_owned()]).collect();
    let room = format!("      - {{id: disc, type: office, outline: [{}]}}\n", corners.join(", "));
    let reading = read_text(&format!("{NATIVE}{GOOD}{room}"));
    assert_eq!(room_ids(&reading), ["good"]);
    assert!(errors(&reading)[0].contains("5000 corners (4096 corners are the most"), "{}", reading.faults);
}
