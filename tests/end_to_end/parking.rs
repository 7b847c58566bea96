//! Parking decks: full of cars, each with an aisle that it drives out to.

use roomwright::internals::best::furnish_best;
use roomwright::internals::geometry::Point;
use roomwright::internals::layout::{FurnishOptions, Placement};

use super::pipeline::Pipeline;

/// A deck of 40 by 38 m with a gate in its southern wall.
const DECK: &str = "version: 1
id: deck
levels:
  - id: '0'
    height: 3
    rooms: [{id: deck, type: garage, outline: [[0, 0], [40, 0], [40, 38], [0, 38]]}]
    openings: [{id: gate, kind: door, rooms: [deck], at: [20, 0], width: 2.9}]
";
/// Metres of an aisle that no car stands in.
const AISLE: f64 = 5.4;
/// Square metres of deck for each car, at most.
const AREA_OF_A_CAR: f64 = 40.0;

/// A place in the frame of a car: x to its right, y to its back, from its middle.
fn seen_from(car: &Placement, place: Point) -> Point {
    let (sine, cosine) = libm::sincos(car.angle);
    let offset = place - car.position;
    Point::new(offset.dot(Point::new(cosine, sine)), offset.dot(Point::new(-sine, cosine)))
}

/// Places before a car, as wide as it, down to the end of its aisle.
fn aisle(car: &Placement) -> impl Iterator<Item = Point> {
    let (sine, cosine) = libm::sincos(car.angle);
    let (right, back) = (Point::new(cosine, sine), Point::new(-sine, cosine));
    let (half, front) = (0.45 * car.size.width, 0.5 * car.size.depth + 0.05);
    let middle = car.position;
    (0..=10).flat_map(move |step| {
        let ahead = front + (AISLE - 0.05) * f64::from(step) / 10.0;
        [-half, 0.0, half].map(|beside| middle + right * beside - back * ahead)
    })
}

fn stands_in(car: &Placement, place: Point) -> bool {
    let place = seen_from(car, place).abs();
    place.x < 0.5 * car.size.width && place.y < 0.5 * car.size.depth
}

#[test]
fn a_parking_deck_is_full_and_its_cars_drive_out() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("deck.yaml");
    std::fs::write(&file, DECK).unwrap();
    let pipeline = Pipeline::new();
    let plan = pipeline.read(&[file]).plan;
    let level = &plan.buildings[0].building.levels[0];
    for seed in 1..=8 {
        let options = FurnishOptions::new(seed, "deck");
        let furnished = furnish_best(level.room(0), &pipeline.catalog, &options, 16).furnished;
        let id = |placement: &Placement| pipeline.catalog.classes[placement.class].id.as_str();
        let cars: Vec<&Placement> =
            furnished.placements.iter().filter(|placement| id(placement).ends_with("car")).collect();
        assert!(AREA_OF_A_CAR * cars.len() as f64 > 40.0 * 38.0, "seed {seed}: {} cars", cars.len());
        for car in cars.iter().filter(|car| ["parked_car", "row_car"].contains(&id(car))) {
            let is_free = |place: Point| {
                let is_on_deck = place.cmpge(Point::ZERO).all() && place.cmple(Point::new(40.0, 38.0)).all();
                is_on_deck && !cars.iter().any(|other| stands_in(other, place))
            };
            assert!(aisle(car).all(is_free), "seed {seed}: {} {} at {}", id(car), car.number, car.position);
        }
    }
}
