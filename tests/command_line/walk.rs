//! `walk` as a real process.

use serde_json::Value;

use super::world::World;

fn plan(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("configs").join(name);
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_recorded_walk_is_reported_for_machines() {
    let world = World::new();
    let (hotel, path) = (plan("plans/hotel.yaml"), plan("walks/hotel.yaml"));
    let words = ["walk", &hotel, "--path", &path, "--effort", "1", "--speed", "4", "--json"];
    let answer: Value = serde_json::from_str(&world.must(&words).stdout).unwrap();
    assert_eq!((&answer["rooms"], answer["walks"].as_array().unwrap().len()), (&177.into(), 1));
    let walk = &answer["walks"][0];
    assert!(walk["metres"].as_f64().unwrap() > 200.0 && walk["made_again"] == 0);
    assert!(walk["rooms_in_view"]["max"].as_f64().unwrap() >= walk["rooms_in_view"]["p50"].as_f64().unwrap());
    assert_eq!(walk["bytes_by_tenth"].as_array().unwrap().len(), 10);
}

#[test]
fn a_small_budget_is_kept_on_a_random_walk() {
    let world = World::new();
    let city = plan("city.yaml");
    let words =
        ["walk", &city, "--random", "600", "--speed", "4", "--budget-rooms", "20", "--effort", "1", "--json"];
    let answer: Value = serde_json::from_str(&world.must(&words).stdout).unwrap();
    assert_eq!(answer["rooms"], 102_500);
    let walk = &answer["walks"][0];
    assert!((walk["metres"].as_f64().unwrap() - 600.0).abs() < 1.0 && walk["arrivals"] == 2);
    assert!(walk["most_rooms"].as_u64().unwrap() <= 20, "{walk}");
}

#[test]
fn what_cannot_be_walked_is_said() {
    let world = World::new();
    let house = plan("plans/house.yaml");
    for (words, part) in [
        (vec!["--path", "nowhere.yaml"], "nowhere.yaml"),
        (vec!["--random", "0"], "above 0"),
        (vec!["--random", "3", "--path", "a.yaml"], "--path"),
        (vec!["--speed", "0"], "from 0.1 on"),
    ] {
        let words: Vec<&str> = ["walk", &house].into_iter().chain(words).collect();
        let output = world.command(&words).output().unwrap();
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && error.contains(part), "{words:?}: {error}");
    }
}
