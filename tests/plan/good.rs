//! Plans without faults.

use crate::golden::check_golden;

use super::support::{files, read, read_ready, read_text, repository, summary};

#[test]
fn every_case_gives_its_golden() {
    let cases = files(&repository("tests/cases/plan"), &["yaml", "json"]);
    assert!(!cases.is_empty());
    for case in cases {
        let reading = read(std::slice::from_ref(&case));
        assert!(reading.faults.is_empty(), "{}", reading.faults);
        let mut text = String::new();
        for placed in &reading.plan.buildings {
            let site = placed.site;
            text.push_str(&format!(
                "building {} at {:.3},{:.3} turned {:.4}\n",
                placed.id, site.position.x, site.position.y, site.turn
            ));
            placed.building.levels.iter().for_each(|level| text.push_str(&summary(level)));
        }
        check_golden(&case.with_extension("txt"), &text);
    }
}

#[test]
fn every_ready_plan_is_without_fault_or_warning() {
    let plans = files(&repository("configs/plans"), &["yaml"]);
    assert!(plans.len() >= 4);
    for plan in plans {
        let reading = read_ready(std::slice::from_ref(&plan));
        assert!(reading.faults.is_empty(), "{}", reading.faults);
        let levels = &reading.plan.buildings[0].building.levels;
        assert!(!levels.is_empty());
        for room in levels.iter().flat_map(|level| &level.rooms) {
            assert!(!room.openings.is_empty(), "{}: room {}", plan.display(), room.id);
        }
    }
}

#[test]
fn every_plan_of_the_paper_and_of_the_cases_is_without_fault() {
    for folder in ["configs/paper", "configs/cases"] {
        let reading = read_ready(&[repository(folder)]);
        assert!(reading.faults.is_empty(), "{}", reading.faults);
        assert!(!reading.plan.buildings.is_empty());
    }
}

#[test]
fn the_demo_names_three_buildings() {
    let reading = read_ready(&[repository("configs/demo.yaml")]);
    assert!(reading.faults.is_empty(), "{}", reading.faults);
    let ids: Vec<&str> = reading.plan.buildings.iter().map(|placed| placed.id.as_str()).collect();
    assert_eq!(ids, ["hotel", "house", "office"]);
}

#[test]
fn the_city_has_a_hundred_thousand_hotel_rooms_in_one_building_in_memory() {
    let reading = read_ready(&[repository("configs/city.yaml")]);
    assert!(reading.faults.is_empty(), "{}", reading.faults);
    let buildings = &reading.plan.buildings;
    assert_eq!((buildings.len(), buildings[0].id.as_str()), (100, "tower-001"));
    assert!(buildings.iter().all(|placed| std::sync::Arc::ptr_eq(&placed.building, &buildings[0].building)));
    assert_eq!((buildings[99].site.position.x, buildings[99].site.position.y), (900.0, 360.0));
    let rooms = |building: &roomwright::internals::plan::Building| {
        let rooms = building.levels.iter().flat_map(|level| &level.rooms);
        rooms.filter(|room| room.room_type == "hotel_room").count()
    };
    assert_eq!(buildings.iter().map(|placed| rooms(&placed.building)).sum::<usize>(), 100_000);
}

#[test]
fn a_hotel_is_a_page_of_yaml() {
    let text = std::fs::read_to_string(repository("configs/plans/hotel-tower.yaml")).unwrap();
    assert!(text.lines().count() < 40);
    let reading = read_ready(&[repository("configs/plans/hotel-tower.yaml")]);
    let levels = &reading.plan.buildings[0].building.levels;
    assert_eq!(levels.len(), 25);
    let ids: Vec<&str> = levels[8].rooms.iter().map(|room| room.id.as_str()).collect();
    assert!(ids.contains(&"901") && ids.contains(&"940"), "{ids:?}");
    assert!((levels[24].elevation - 72.0).abs() < 1e-9);
    assert_eq!(levels[0].rooms.len(), 41);
}

#[test]
fn the_plans_of_the_description_are_without_fault_or_warning() {
    let text = std::fs::read_to_string(repository("configs/plans/README.md")).unwrap();
    let blocks: Vec<&str> =
        text.split("```yaml\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(blocks.len(), 2);
    for block in blocks {
        let version = if block.starts_with("version") { "" } else { "version: 1\n" };
        let reading = read_text(&format!("{version}{block}"));
        assert!(reading.faults.is_empty(), "{}", reading.faults);
    }
}
