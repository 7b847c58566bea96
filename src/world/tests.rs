use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::Arc;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use super::graph::{BuildingGraph, Place};
use super::near::near;
use super::path::WalkPath;
use super::sight::{Sector, Stand, rooms_at, seen_from};
use super::*;
use crate::contract::RoomId;
use crate::geometry::{Point, Region};
use crate::output::{LevelOptions, TextureOptions};
use crate::plan::{Building, Level};
use crate::project::{Project, ProjectPaths};

fn configs(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("configs").join(name)
}

fn project(name: &str) -> Arc<Project> {
    Arc::new(Project::read(&ProjectPaths::from_iter([configs(name)])).unwrap())
}

fn plain() -> LevelOptions {
    let textures = TextureOptions { size: None, are_shared: false };
    LevelOptions { seed: 3, effort: 1, textures, ..LevelOptions::default() }
}

/// Numbers from 0 to 1.
struct Draw(ChaCha8Rng);

impl Draw {
    fn share(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / 4_294_967_296.0
    }

    /// A place in a room.
    fn place(&mut self, region: &Region) -> Point {
        let bounds = region.outline.bounds();
        loop {
            let at = bounds.low + bounds.size() * Point::new(self.share(), self.share());
            if region.contains(at) {
                return at;
            }
        }
    }
}

/// The rooms that a ray goes through until it meets a wall: each time out through an opening of one room, and in through the same
/// opening of the next.
fn rooms_along(level: &Level, room: usize, eye: Point, direction: Point) -> Vec<usize> {
    let mut rooms = vec![room];
    let mut from = 0.0;
    loop {
        let at = rooms[rooms.len() - 1];
        let here = &level.rooms[at];
        // The nearest wall that the ray leaves through: metres along the ray, wall, metres along the wall.
        let hits = here.walls.iter().enumerate().filter_map(|(index, wall)| {
            let along = wall.direction();
            let slope = direction.perp_dot(along);
            if slope.abs() < 1e-9 {
                return None;
            }
            let metres = (wall.start - eye).perp_dot(along) / slope;
            let on_wall = (eye + direction * metres - wall.start).dot(along);
            let is_hit = metres > from + 1e-9 && (0.0..=wall.length()).contains(&on_wall);
            is_hit.then_some((metres, index, on_wall))
        });
        let Some((metres, wall, on_wall)) = hits.min_by(|one, other| one.0.total_cmp(&other.0)) else {
            return rooms;
        };
        let next = here.openings.iter().find_map(|opening| {
            let is_through = opening.wall == wall && (opening.from..=opening.to).contains(&on_wall);
            let sides = &level.openings[opening.opening].sides;
            let other = sides.iter().find(|side| side.room != at)?;
            is_through.then_some(other)
        });
        let Some(side) = next else { return rooms };
        // The wall has two faces: the ray has to come out within the opening again.
        let far = &level.rooms[side.room].walls[side.wall];
        let slope = direction.perp_dot(far.direction());
        if slope.abs() < 1e-9 {
            return rooms;
        }
        let out = (far.start - eye).perp_dot(far.direction()) / slope;
        let on_far = (eye + direction * out - far.start).dot(far.direction());
        if out < metres - 1e-6 || !(side.from..=side.to).contains(&on_far) || rooms.len() > 12 {
            return rooms;
        }
        rooms.push(side.room);
        from = out;
    }
}

/// Looks from a place in all directions; how many rays went through two openings.
fn check_sight(graph: &BuildingGraph, building: &Building, index: usize, draw: &mut Draw) -> usize {
    let level = &building.levels[index];
    let room = (draw.share() * level.rooms.len() as f64) as usize;
    let eye = draw.place(&level.rooms[room].region);
    let gaze = Point::from_angle(draw.share() * core::f64::consts::TAU);
    let view = Sector::around(gaze, 1.6);
    let seen = seen_from(graph, building, &Stand { level: index, position: eye, view });
    let mut through_two = 0;
    for ray in 0..360 {
        let direction = Point::from_angle(f64::from(ray).to_radians() + 1e-4);
        let is_in_view = direction.angle_to(gaze).abs() < 0.8;
        let rooms = rooms_along(level, room, eye, direction);
        through_two += usize::from(rooms.len() > 2);
        for reached in rooms {
            let name = &level.rooms[reached].id;
            let found = seen.get(&Place { level: index, room: reached });
            let found =
                found.unwrap_or_else(|| panic!("from {eye} in {} one sees {name}", level.rooms[room].id));
            assert!(
                found.is_in_view || !is_in_view,
                "{name} is in view from {eye} in {}",
                level.rooms[room].id
            );
        }
    }
    through_two
}

#[test]
fn no_room_is_missed_that_a_ray_reaches() {
    let mut draw = Draw(ChaCha8Rng::seed_from_u64(1));
    let mut through_two = 0;
    for plan in ["plans/house.yaml", "plans/hotel.yaml", "plans/office.yaml"] {
        let project = project(plan);
        let building: &Building = &project.plan.buildings[0].building;
        let graph = BuildingGraph::new(building, &project.catalog);
        for index in 0..building.levels.len() {
            for _ in 0..40 {
                through_two += check_sight(&graph, building, index, &mut draw);
            }
        }
    }
    assert!(through_two > 1000, "{through_two} rays went through two openings");
}

#[test]
fn a_view_in_one_direction_has_few_rooms() {
    let project = project("plans/hotel.yaml");
    let building: &Building = &project.plan.buildings[0].building;
    let graph = BuildingGraph::new(building, &project.catalog);
    let position = Point::new(20.0, 7.6);
    let at = |view| Stand { level: 1, position, view };
    let all = seen_from(&graph, building, &at(None));
    let east = seen_from(&graph, building, &at(Sector::around(Point::X, 1.0)));
    assert_eq!(all.len(), east.len());
    let count =
        |seen: &BTreeMap<Place, super::sight::Seen>| seen.values().filter(|seen| seen.is_in_view).count();
    assert!(count(&all) > count(&east) && count(&east) > 1, "{} {}", count(&all), count(&east));
}

#[test]
fn from_outside_one_sees_rooms_with_windows() {
    let project = project("plans/hotel.yaml");
    let building: &Building = &project.plan.buildings[0].building;
    let graph = BuildingGraph::new(building, &project.catalog);
    let stand = Stand { level: 0, position: Point::new(12.0, -8.0), view: None };
    assert!(rooms_at(&graph, building, 0, stand.position).is_empty());
    let seen = seen_from(&graph, building, &stand);
    let ids: BTreeSet<&str> =
        seen.keys().map(|place| building.levels[place.level].rooms[place.room].id.as_str()).collect();
    assert!(ids.contains("lobby") && ids.contains("restaurant") && ids.contains("106-room"), "{ids:?}");
    assert!(!ids.contains("101-room"), "its window is on the other side");
}

#[test]
fn in_the_street_one_sees_into_the_buildings_on_both_sides() {
    // Towers of 80 x 15 m stand 100 m apart from west to east, and 40 m from south to north.
    let mut world = World::open(project("city.yaml"), plain());
    let street = world.eye_on_site(Point::new(40.0, 27.5), 1.6, Point::X).unwrap();
    assert_eq!(street.level, "1");
    world.update(&street, Budget::default()).unwrap();
    let seen: BTreeSet<String> = world.wanted().into_iter().map(|wanted| wanted.id.building).collect();
    assert_eq!(seen.iter().map(String::as_str).collect::<Vec<_>>(), ["tower-001", "tower-011"]);
    let inside = world.eye_on_site(Point::new(140.0, 7.6), 31.7, Point::X).unwrap();
    assert_eq!((inside.building.as_str(), inside.level.as_str()), ("tower-002", "11"));
    world.update(&inside, Budget::default()).unwrap();
    assert!(world.wanted().iter().all(|wanted| wanted.id.building == "tower-002"));
    assert_eq!(world.wanted()[0].id.room, "corridor");
}

#[test]
fn stairs_join_levels_and_ways_are_measured() {
    let project = project("plans/hotel.yaml");
    let building: &Building = &project.plan.buildings[0].building;
    let graph = BuildingGraph::new(building, &project.catalog);
    let id = |place: &Place| {
        let level = &building.levels[place.level];
        format!("{}/{}", level.id, level.rooms[place.room].id)
    };
    let ways = near(&graph, building, (0, Point::new(-2.0, 7.6)), 12.0);
    let ways: BTreeMap<String, f64> = ways.iter().map(|(place, metres)| (id(place), *metres)).collect();
    assert!((ways["1/stairs"] - 4.0).abs() < 1e-9, "{ways:?}");
    assert!((ways["2/stairs"] - 8.0).abs() < 1e-9, "{ways:?}");
    assert!(ways["1/corridor"] > 5.0 && ways["1/corridor"] < 7.0, "{ways:?}");
    assert!(!ways.contains_key("1/119-room"));
}

/// All rooms of a world, however it came to them, are those of the library's [`crate::Rooms`], which are those of a bake.
#[test]
fn rooms_are_equal_on_every_way() {
    for threads in [1, 3] {
        let project = project("plans/hotel.yaml");
        let options = plain();
        let rooms = project.rooms(&options);
        let mut world = World::open(Arc::clone(&project), options.clone());
        world.start(NonZeroUsize::new(threads).unwrap()).unwrap();
        let path = WalkPath::random(&project.plan, &project.catalog, 11 + threads as u64, 300.0).unwrap();
        // What the library furnishes, once.
        let mut compared = BTreeMap::new();
        // Few enough that rooms are forgotten and made again.
        let budget = Budget { rooms: 12, bytes: usize::MAX };
        for stop in path.pieces.iter().flatten() {
            let placed = &project.plan.buildings[stop.building];
            let level = &placed.building.levels[stop.level].id;
            world.update(&Eye::new(&placed.id, level, stop.at, Point::X), budget).unwrap();
            assert!(world.len() <= 12);
            for wanted in world.wanted().into_iter().take(3) {
                let room = world.furnish(&wanted.id).unwrap();
                let known =
                    compared.entry(wanted.id.clone()).or_insert_with(|| rooms.furnish(&wanted.id).unwrap());
                assert_eq!(
                    (&room.furnished, &room.verdict),
                    (&known.furnished, &known.verdict),
                    "{}",
                    wanted.id
                );
            }
        }
        assert!(compared.len() > 20, "{} rooms", compared.len());
        assert!(world.made() > world.len() as u64);
    }
}

#[test]
fn a_room_asked_for_twice_is_made_once() {
    let project = project("plans/house.yaml");
    let world = World::open(project, plain());
    let id = RoomId::new("house", "ground", "living");
    let numbers: Vec<u64> = std::thread::scope(|scope| {
        let asking: Vec<_> = (0..4).map(|_| scope.spawn(|| world.furnish(&id).unwrap().number)).collect();
        asking.into_iter().map(|asked| asked.join().unwrap()).collect()
    });
    assert_eq!((numbers, world.made()), (vec![1; 4], 1));
}

#[test]
fn what_is_unknown_is_named() {
    let mut world = World::open(project("plans/house.yaml"), plain());
    let eye = Eye::new("house", "attic", Point::ZERO, Point::X);
    let error = world.update(&eye, Budget::default()).unwrap_err();
    assert_eq!(error.to_string(), "the plan has no level house/attic");
    let error = world.furnish(&RoomId::new("house", "ground", "ballroom")).unwrap_err();
    assert!(
        error.to_string().starts_with("the plan has no room house/ground/ballroom; possible here: hall, ")
    );
}

#[test]
fn a_small_budget_holds_the_most_urgent_rooms_and_comes_to_rest() {
    let mut world = World::open(project("plans/hotel.yaml"), plain());
    let eye = Eye::new("hotel", "1", Point::new(20.0, 7.6), Point::X);
    for budget in [Budget { rooms: 3, bytes: usize::MAX }, Budget { rooms: 100, bytes: 9000 }] {
        world.update(&eye, budget).unwrap();
        let mut steps = 0;
        while world.step() {
            steps += 1;
            assert!(steps < 100, "rooms are made again and again");
            assert!(world.len() <= budget.rooms && (world.bytes() <= budget.bytes || world.len() == 1));
        }
        let wanted = world.wanted();
        assert!(wanted[0].room.is_some(), "the corridor that one stands in");
        assert!(wanted.iter().any(|wanted| wanted.room.is_none()), "not all have a place");
    }
}

#[test]
fn rooms_come_and_go() {
    let mut world = World::open(project("plans/hotel.yaml"), plain());
    let budget = Budget { rooms: 30, bytes: usize::MAX };
    let mut held = BTreeSet::new();
    for x in [1.0, 10.0, 20.0, 30.0, 39.0, 1.0] {
        for level in ["1", "3"] {
            let eye = Eye::new("hotel", level, Point::new(x, 7.6), Point::X);
            let mut change = world.update(&eye, budget).unwrap();
            while world.step() {
                for id in change.came {
                    assert!(held.insert(id));
                }
                for id in change.went {
                    assert!(held.remove(&id));
                }
                change = world.update(&eye, budget).unwrap();
            }
            assert_eq!(change.waiting, 0);
            change.came.into_iter().for_each(|id| assert!(held.insert(id)));
            change.went.into_iter().for_each(|id| assert!(held.remove(&id)));
            assert!(held.iter().all(|id| world.room(id).is_some()) && held.len() == world.len());
        }
    }
}

#[test]
fn after_a_change_of_one_room_the_others_stay() {
    let paths = ProjectPaths::from_iter([configs("plans/house.yaml")]);
    let mut world = World::open(Project::read(&paths).unwrap(), plain());
    let eye = Eye::new("house", "ground", Point::new(3.0, 2.0), Point::Y);
    world.survey(&eye, Budget::default()).unwrap();
    while world.step() {}
    let ids: Vec<RoomId> = world.wanted().into_iter().map(|wanted| wanted.id).collect();
    let before: Vec<Arc<WorldRoom>> = ids.iter().map(|id| world.room(id).unwrap()).collect();
    let mut changed = Project::read(&paths).unwrap();
    let living = RoomId::new("house", "ground", "living");
    changed.edits.pin(&living, 77);
    world.replace(changed, plain());
    world.survey(&eye, Budget::default()).unwrap();
    assert!(world.room(&living).is_none(), "it is made anew");
    let shown = world.wanted().into_iter().find(|wanted| wanted.id == living).unwrap();
    assert_eq!(shown.room.unwrap().number, before[ids.iter().position(|id| *id == living).unwrap()].number);
    while world.step() {}
    for (id, before) in ids.iter().zip(&before) {
        let after = world.room(id).unwrap();
        assert_eq!(after.number == before.number, *id != living, "{id}");
        assert_eq!(after.furnished == before.furnished, *id != living, "{id}");
    }
    world.replace(Project::read(&paths).unwrap(), LevelOptions { seed: 4, ..plain() });
    assert!(ids.iter().all(|id| world.room(id).is_none()), "another seed is another room");
}

#[test]
fn a_walk_is_measured() {
    let project = project("plans/hotel.yaml");
    let path = WalkPath::read(&configs("walks/hotel.yaml"), &project.plan).unwrap();
    assert!((path.metres() - 270.0).abs() < 40.0, "{}", path.metres());
    let mut world = World::open(Arc::clone(&project), plain());
    let pace =
        Pace { speed: 4.0, field_of_view: 1.5, reach: DEFAULT_REACH, threads: 1, budget: Budget::default() };
    let report = walk(&mut world, &path, &pace).unwrap();
    assert!((report.seconds - path.metres() / 4.0).abs() < 0.1);
    assert!((report.frames as f64 - report.seconds * 60.0).abs() < 2.0);
    assert!(report.rooms_in_view.mean > 1.0 && report.pieces_in_view.max > 100.0);
    assert_eq!((report.made_again, report.arrivals), (0, 1));
    assert!(report.made > 40 && report.made <= project.room_ids().count());
    assert!(report.needed > 50 && report.latency_ms.max >= report.latency_ms.p50);
}

#[test]
fn random_walks_stay_in_rooms_and_are_repeated() {
    for plan in ["plans/house.yaml", "plans/hotel-tower.yaml"] {
        let project = project(plan);
        let path = WalkPath::random(&project.plan, &project.catalog, 5, 700.0).unwrap();
        assert_eq!(path, WalkPath::random(&project.plan, &project.catalog, 5, 700.0).unwrap());
        // A piece may end in the middle of a flight of stairs, which counts whole.
        assert!((path.metres() - 700.0).abs() < 9.0 && path.pieces.len() >= 2, "{}", path.metres());
        for stop in path.pieces.iter().flatten() {
            let building = &project.plan.buildings[stop.building].building;
            let graph = BuildingGraph::new(building, &project.catalog);
            assert!(!rooms_at(&graph, building, stop.level, stop.at).is_empty(), "{stop:?}");
        }
    }
}

#[test]
fn faults_of_paths_have_a_place() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("path.yaml");
    let text = "version: 1\nstops:\n  - {level: ground, at: [1, 1]}\n  - {level: grund, at: [1, 1]}\n  - {building: hut, at: [1, 1]}\n";
    std::fs::write(&file, text).unwrap();
    let faults = WalkPath::read(&file, &project("plans/house.yaml").plan).unwrap_err();
    let told: Vec<String> = faults.0.iter().map(crate::document::Fault::report).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[0].contains(":4:") && told[0].contains("grund") && told[0].contains("ground"), "{told:?}");
    assert!(told[1].contains("no building \"hut\""), "{told:?}");
}
