//! Apartment blocks with a fault in one place: that place is left out and reported, the rest is read.

use std::path::Path;

use roomwright::internals::plan::{Level, PlanReading};
use serde_json::Value;
use tempfile::TempDir;

use super::support::{read_ready, repository};

const DRAWINGS: &str = "react_planner_projects.json";

/// A copy of a site.
fn copy(site: &Path) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("block");
    std::fs::create_dir(&target).unwrap();
    for entry in std::fs::read_dir(site).unwrap() {
        let path = entry.unwrap().path();
        // Written anew, because the shared files may not be changed and a copy would inherit that.
        std::fs::write(target.join(path.file_name().unwrap()), std::fs::read(&path).unwrap()).unwrap();
    }
    folder
}

/// Reads a copy of a site with a change to one of its tables.
fn damaged(site: &Path, table: &str, damage: impl FnOnce(&mut Value)) -> PlanReading {
    let folder = copy(site);
    let path = folder.path().join("block").join(table);
    let mut rows: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    damage(&mut rows);
    std::fs::write(&path, serde_json::to_vec_pretty(&rows).unwrap()).unwrap();
    read_ready(&[folder.path().join("block")])
}

fn block() -> std::path::PathBuf {
    repository("tests/cases/plan_import/block")
}

fn levels(reading: &PlanReading) -> Vec<&Level> {
    reading.plan.buildings.iter().flat_map(|placed| &placed.building.levels).collect()
}

/// Ids and contents of the levels but for their stairs, which lead to the levels beside them.
fn contents(reading: &PlanReading) -> Vec<(&str, String)> {
    let text =
        |level: &Level| format!("{:?}", (level.elevation, level.height, &level.rooms, &level.openings));
    levels(reading).into_iter().map(|level| (level.id.as_str(), text(level))).collect()
}

/// The message of the first error, which names a place.
fn first_error(reading: &PlanReading) -> &str {
    let fault = reading.faults.0.iter().find(|fault| fault.is_error()).expect("an error");
    assert!(fault.position.is_some(), "{fault}");
    &fault.message
}

/// A change to one table.
type Damage = (&'static str, fn(&mut Value), &'static str);

#[test]
fn a_broken_floor_leaves_the_others() {
    let whole = damaged(&block(), DRAWINGS, |_| ());
    assert!(!whole.faults.has_errors(), "{}", whole.faults);
    assert_eq!(levels(&whole).len(), 2);
    let cases: [Damage; 4] = [
        (DRAWINGS, |rows| rows[0]["data"]["scale"] = 0.0.into(), "scale 0 is no size of a pixel"),
        (DRAWINGS, |rows| rows[0]["data"]["layers"]["layer-1"]["lines"] = Value::Null, "found nothing"),
        (DRAWINGS, |rows| rows[0]["plan_id"] = "twenty".into(), "twenty"),
        ("floors.json", |rows| rows[0]["plan_id"] = 99.into(), "floor 1 has no drawing 99"),
    ];
    for (table, damage, message) in cases {
        let reading = damaged(&block(), table, damage);
        let texts: Vec<&str> = reading.faults.0.iter().map(|fault| fault.message.as_str()).collect();
        assert!(
            first_error(&reading).contains(message) || texts.iter().any(|text| text.contains(message)),
            "{texts:?}"
        );
        assert_eq!(contents(&reading), contents(&whole)[..1], "{message}: the ground floor is the same");
        assert_eq!(reading.plan.buildings[0].id, whole.plan.buildings[0].id);
    }
}

#[test]
fn a_broken_area_leaves_the_other_rooms() {
    let whole = damaged(&block(), "areas.json", |_| ());
    let reading =
        damaged(&block(), "areas.json", |rows| rows[0]["scaled_polygon"] = "POLYGON ((0 zero".into());
    assert!(first_error(&reading).contains("broken well-known text"));
    let rooms = |reading: &PlanReading| levels(reading).iter().map(|level| level.rooms.len()).sum::<usize>();
    assert_eq!((levels(&reading).len(), rooms(&reading)), (2, rooms(&whole) - 1));
}

#[test]
fn without_a_sound_floor_there_is_no_building() {
    let reading = damaged(&block(), DRAWINGS, |rows| {
        for row in rows.as_array_mut().unwrap() {
            row["data"]["scale"] = 0.0.into();
        }
    });
    assert!(reading.plan.buildings.is_empty() && reading.faults.has_errors());
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn a_broken_floor_of_a_real_block_leaves_the_others() {
    let site = Path::new("../shared/data/floorplans/archilyse/site_1440");
    if !site.is_dir() {
        return println!("skipped: {} is absent", site.display());
    }
    let whole = damaged(site, DRAWINGS, |_| ());
    assert!(!whole.faults.has_errors(), "{}", whole.faults);
    let (mut plan, mut layers) = (0, Value::Null);
    let reading = damaged(site, DRAWINGS, |rows| {
        plan = rows[1]["plan_id"].as_i64().unwrap();
        layers = rows[1]["data"]["layers"].take();
    });
    let says =
        |text: &str| reading.faults.0.iter().any(|fault| fault.is_error() && fault.message.contains(text));
    assert!(says("found nothing") && says("has no drawing"), "{}", reading.faults);
    assert!(layers.is_object(), "plan {plan} had a drawing");
    let (before, after) = (contents(&whole), contents(&reading));
    assert_eq!(after.len(), before.len() - 1);
    assert!(after.iter().all(|level| before.contains(level)), "all other floors are as they were");
}
