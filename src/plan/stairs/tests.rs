use super::*;
use crate::geometry::{Bounds, Convex, direction};
use crate::plan::{
    LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, assemble_level,
};

/// A level with a room of stairs, and doors out of it: their middles, and metres of width.
fn level(id: &str, elevation: f64, size: (f64, f64), doors: &[(f64, f64)]) -> Level {
    let outline = Polygon::rectangle(Point::ZERO, Point::new(size.0, size.1)).corners().to_vec();
    let room = RoomDraft {
        id: "s".to_owned(),
        room_type: STAIRS_ROOM_TYPE.to_owned(),
        outline,
        ..RoomDraft::default()
    };
    let door = |(number, &(x, y)): (usize, &(f64, f64))| OpeningDraft {
        id: format!("d{number}"),
        kind: OpeningKind::Door,
        place: OpeningPlace::Points { center: Point::new(x, y), along: None },
        rooms: vec!["s".to_owned()],
        width: 0.9,
        bottom: 0.0,
        top: 2.1,
        leaf: LeafDraft::Automatic,
    };
    let openings = doors.iter().enumerate().map(door).collect();
    let draft = LevelDraft {
        id: id.to_owned(),
        elevation,
        height: 3.0,
        rooms: vec![room],
        openings,
        ..LevelDraft::default()
    };
    let (level, problems) = assemble_level(draft);
    assert!(problems.is_empty(), "{problems:?}");
    level
}

/// So many levels of one room.
fn joined(count: usize, size: (f64, f64), doors: &[(f64, f64)]) -> Vec<Level> {
    let mut levels: Vec<Level> =
        (0..count).map(|number| level(&number.to_string(), number as f64 * 3.0, size, doors)).collect();
    join_levels(&mut levels);
    levels
}

fn flights(levels: &[Level]) -> Vec<&Flight> {
    levels.iter().flat_map(|level| &level.stairs).filter_map(|stairs| stairs.up.as_ref()).collect()
}

/// Rooms of stairs of all sizes, with a door at one end.
fn sizes() -> impl Iterator<Item = (f64, f64)> {
    let widths = (0..14).map(|step| 0.9 + 0.3 * f64::from(step));
    widths.flat_map(|width| (0..10).map(move |step| (width, 2.0 + 0.5 * f64::from(step))))
}

#[test]
fn steps_lead_from_floor_to_floor_inside_the_room() {
    let mut found = 0;
    for size in sizes() {
        let levels = joined(2, size, &[(size.0 / 2.0, 0.0)]);
        for flight in flights(&levels) {
            found += 1;
            assert!((flight.rise() - 3.0).abs() < 1e-9, "{size:?}");
            let place = Bounds::new(Point::ZERO, Point::new(size.0, size.1)).inflated(0.011);
            let mut last = 0.0;
            for step in &flight.steps {
                assert!((step.top - last - step.rise).abs() < 1e-9 && step.rise <= 0.2 + 1e-9, "{size:?}");
                last = step.top;
                assert!(step.corners.iter().all(|corner| place.contains(*corner)), "{size:?} {step:?}");
                assert!(crate::geometry::signed_area(&step.corners) > 0.02, "{size:?} {step:?}");
            }
        }
    }
    assert!(found > 60, "{found} of 140 rooms have stairs");
}

/// Whoever walks up steps from each step onto the next: they share the edge that is stepped over.
#[test]
fn each_step_begins_where_the_last_one_ends() {
    for size in sizes() {
        for flight in flights(&joined(2, size, &[(size.0 / 2.0, 0.0)])) {
            for pair in flight.steps.windows(2) {
                let edge = Segment::new(pair[1].corners[0], pair[1].corners[1]);
                let before = Convex::from_corners(&pair[0].corners);
                let touched =
                    Convex::rectangle(edge.middle(), Point::new(edge.length() / 2.0, 0.02), edge.direction());
                assert!(before.overlaps(&touched, 0.0), "{size:?} {pair:?}");
            }
        }
    }
}

#[test]
fn steps_do_not_lie_on_each_other() {
    for size in sizes() {
        for flight in flights(&joined(2, size, &[(size.0 / 2.0, 0.0)])) {
            let bodies: Vec<Convex> =
                flight.steps.iter().map(|step| Convex::from_corners(&step.corners)).collect();
            for (number, body) in bodies.iter().enumerate() {
                assert!(
                    !bodies[number + 1..].iter().any(|other| body.overlaps(other, 0.01)),
                    "{size:?}: step {number}"
                );
            }
        }
    }
}

#[test]
fn doors_and_landings_stay_free() {
    let size = (2.6, 5.2);
    let doors = [(1.3, 0.0), (0.0, 4.6), (2.6, 4.6)];
    let levels = joined(5, size, &doors);
    let flights = flights(&levels);
    assert_eq!(flights.len(), 4);
    for (x, y) in doors {
        let inward = Point::new(1.3 - x, 2.6 - y);
        let inward = if x == 1.3 { Point::Y } else { Point::new(inward.x.signum(), 0.0) };
        let zone = Convex::rectangle(Point::new(x, y) + inward * 0.35, Point::splat(0.35), Point::X);
        for step in flights.iter().flat_map(|flight| &flight.steps) {
            assert!(!Convex::from_corners(&step.corners).overlaps(&zone, 0.0), "{x} {y}");
        }
    }
}

#[test]
fn stairs_go_on_where_they_come_up_and_the_last_well_is_guarded() {
    let levels = joined(4, (2.6, 5.0), &[(1.3, 0.0)]);
    for pair in levels.windows(2) {
        let (flight, well) =
            (pair[0].stairs[0].up.as_ref().unwrap(), pair[1].stairs[0].well.as_ref().unwrap());
        assert_eq!(flight.opening, well.opening);
    }
    assert!(levels[0].stairs[0].well.is_none() && levels[3].stairs[0].up.is_none());
    let guarded = |level: usize| -> f64 {
        levels[level].stairs[0].well.as_ref().unwrap().guards.iter().map(|guard| guard.length()).sum()
    };
    // One more width of a flight: where the next one would begin.
    assert!(guarded(3) > guarded(2) + 0.7, "{} {}", guarded(3), guarded(2));
}

/// Equal storeys share their stairs, whatever else they share.
#[test]
fn the_storeys_of_a_tower_have_the_same_stairs() {
    let levels = joined(6, (2.6, 5.0), &[(1.3, 0.0)]);
    assert!(std::ptr::eq(&*levels[2].stairs, &*levels[3].stairs));
    assert!(!std::ptr::eq(&*levels[0].stairs, &*levels[1].stairs));
    assert_ne!(levels[2].digest, level("2", 6.0, (2.6, 5.0), &[(1.3, 0.0)]).digest);
}

#[test]
fn a_room_that_holds_no_stairs_has_none() {
    assert!(flights(&joined(2, (1.0, 1.6), &[(0.5, 0.0)])).is_empty());
    assert!(flights(&joined(1, (2.6, 5.0), &[(1.3, 0.0)])).is_empty());
    // Doors on all sides of a small room.
    let doors = [(1.0, 0.0), (1.0, 2.2), (0.0, 1.1), (2.0, 1.1)];
    assert!(flights(&joined(2, (2.0, 2.2), &doors)).is_empty());
}

/// A long room beside a hall, as in terraced houses: in by one end of its side, out by the other.
#[test]
fn stairs_between_two_doors_of_one_side_turn_at_both_ends() {
    let outline = |x: f64, width: f64| {
        Polygon::rectangle(Point::new(x, 0.0), Point::new(width, 3.8)).corners().to_vec()
    };
    let room = |id: &str, room_type: &str, x: f64, width: f64| RoomDraft {
        id: id.to_owned(),
        room_type: room_type.to_owned(),
        outline: outline(x, width),
        ..RoomDraft::default()
    };
    let open = OpeningDraft {
        id: "open".to_owned(),
        kind: OpeningKind::OpenBoundary,
        place: OpeningPlace::Points { center: Point::new(1.0, 1.9), along: Some(Point::Y) },
        rooms: vec!["s".to_owned(), "hall".to_owned()],
        width: 3.7,
        bottom: 0.0,
        top: 2.7,
        leaf: LeafDraft::Automatic,
    };
    let storey = |id: &str, elevation: f64| {
        let rooms = vec![room("s", STAIRS_ROOM_TYPE, 0.0, 0.95), room("hall", "hallway", 1.05, 2.0)];
        let draft = LevelDraft {
            id: id.to_owned(),
            elevation,
            height: 2.8,
            rooms,
            openings: vec![open.clone()],
            ..LevelDraft::default()
        };
        assemble_level(draft).0
    };
    let mut levels = [storey("0", 0.0), storey("1", 2.8)];
    join_levels(&mut levels);
    let found = flights(&levels);
    let first = &found[0].steps[0];
    let across = (first.corners[1] - first.corners[0]).normalize();
    assert!(
        across.dot(direction(core::f64::consts::FRAC_PI_2)).abs() > 0.99,
        "one steps in from the side: {across}"
    );
}
