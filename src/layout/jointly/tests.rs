//! Bathrooms of the catalogue in rooms made by hand, each with several seeds.

use crate::catalog::{Catalog, Side, builtin_catalog};
use crate::geometry::{Point, Solid, direction};
use crate::layout::tests::{kinds_of_alternatives, level, run};
use crate::layout::{
    Alternative, Counted, FurnishOptions, Furnished, Lock, LockSupport, Parent, Placement, RoomLayout,
    clearance_solids, furnish,
};
use crate::plan::Level;

const SEEDS: std::ops::Range<u64> = 0..12;

/// A bathroom with a door at the start of its south wall, and pipes in some of its walls: 0 south, 1 east, 2 north, 3 west.
fn bathroom(width: f64, depth: f64, pipes: &[usize]) -> Level {
    let mut level = level(&[(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)]);
    let room = &mut level.rooms[0];
    room.room_type = "bathroom".to_owned();
    room.walls[0].tags.push("door".to_owned());
    pipes.iter().for_each(|&wall| room.walls[wall].tags.push("pipes".to_owned()));
    level
}

fn placement<'f>(catalog: &Catalog, furnished: &'f Furnished, group: &str) -> Option<&'f Placement> {
    let is_it =
        |placement: &&Placement| catalog.classes[placement.class].groups.iter().any(|other| other == group);
    furnished.placements.iter().find(is_it)
}

#[test]
fn toilet_and_basin_stand_side_by_side_at_the_wall_with_pipes() {
    let catalog = builtin_catalog();
    for seed in SEEDS {
        let furnished = run(&bathroom(3.3, 2.0, &[2]), catalog, seed);
        for group in ["wc", "washing"] {
            let fixture = placement(catalog, &furnished, group).unwrap();
            assert_eq!(fixture.parent, Parent::Wall(2), "{group}, seed {seed}");
        }
    }
}

#[test]
fn nothing_of_a_bathroom_stands_at_the_wall_of_its_door_where_others_are_free() {
    let catalog = builtin_catalog();
    for seed in SEEDS {
        let furnished = run(&bathroom(3.2, 2.4, &[]), catalog, seed);
        for group in ["wc", "washing"] {
            let fixture = placement(catalog, &furnished, group).unwrap();
            assert_ne!(fixture.parent, Parent::Wall(0), "{group}, seed {seed}");
        }
    }
}

#[test]
fn all_fixtures_of_a_small_bathroom_find_a_place_with_the_space_that_they_need() {
    let catalog = builtin_catalog();
    for seed in SEEDS {
        let level = bathroom(1.8, 2.3, &[3]);
        let furnished = run(&level, catalog, seed);
        let fixtures =
            ["wc", "washing", "bathing"].map(|group| placement(catalog, &furnished, group).unwrap());
        for fixture in fixtures {
            for (_, region) in clearance_solids(&catalog.classes[fixture.class], fixture, false) {
                assert!(is_inside(&level, &region), "seed {seed}: {}", catalog.classes[fixture.class].id);
            }
        }
    }
}

/// Whether a region lies in a rectangular room, but for a centimetre.
fn is_inside(level: &Level, region: &Solid) -> bool {
    let (room, region) = (level.rooms[0].region.outline.bounds(), region.bounds);
    let margin = Point::splat(0.011);
    (region.low.cmpge(room.low - margin) & region.high.cmple(room.high + margin)).all()
}

#[test]
fn what_is_locked_stays_and_the_others_go_round_it() {
    let catalog = builtin_catalog();
    let level = bathroom(2.6, 2.6, &[2]);
    let toilet = catalog.class_index("toilet").unwrap();
    let free = run(&level, catalog, 1);
    let stands = placement(catalog, &free, "wc").unwrap();
    let lock = Lock {
        class: toilet,
        number: 1,
        on: LockSupport::Part(Parent::Floor),
        side: Side::Above,
        position: Point::new(0.6, 1.5),
        elevation: None,
        angle: stands.angle,
        variant: None,
    };
    let locks = [lock.clone()];
    let options = FurnishOptions { locks: &locks, ..FurnishOptions::new(1, "test") };
    let furnished = furnish(level.room(0), catalog, &options);
    let kept = placement(catalog, &furnished, "wc").unwrap();
    assert_eq!(kept.position, lock.position);
    assert!(placement(catalog, &furnished, "washing").is_some());
}

#[test]
fn where_a_long_bowl_leaves_too_little_space_a_short_one_stands() {
    let catalog = builtin_catalog();
    for seed in SEEDS {
        // Deep enough along the pipes for a bowl of 0.48 m, not for the usual ones.
        let level = bathroom(1.26, 2.6, &[1, 3]);
        let furnished = run(&level, catalog, seed);
        let toilet = placement(catalog, &furnished, "wc").unwrap();
        for (_, region) in clearance_solids(&catalog.classes[toilet.class], toilet, true) {
            assert!(is_inside(&level, &region), "seed {seed}");
        }
    }
}

/// Metres from the sides of a piece, across its width, to the sides of a rectangular room: the lesser and the larger.
fn gaps_beside(level: &Level, piece: &Placement) -> [f64; 2] {
    let right = direction(piece.angle);
    let (middle, half) = (piece.position.dot(right), piece.size.width / 2.0);
    let corners = level.rooms[0].region.outline.corners().iter().map(|corner| corner.dot(right));
    let (low, high) =
        corners.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (at.min(low), at.max(high)));
    let (left, right) = (middle - half - low, high - middle - half);
    [left.min(right), left.max(right)]
}

#[test]
fn what_bathes_stands_in_a_corner_and_fills_the_short_side_of_a_narrow_bathroom() {
    let catalog = builtin_catalog();
    let mut filled = 0;
    for seed in SEEDS {
        // The usual tubs leave 0.2 m or more of the short side.
        let level = bathroom(1.9, 3.4, &[1]);
        let furnished = run(&level, catalog, seed);
        let bath = placement(catalog, &furnished, "bathing").unwrap();
        let [corner, rest] = gaps_beside(&level, bath);
        assert!(corner < 0.04, "seed {seed}: {corner} m from a corner");
        filled += u32::from(rest < 0.111);
    }
    assert!(filled >= 9, "{filled} of 12 fill the niche");
}

#[test]
fn a_shower_fills_a_niche_and_leaves_the_others_their_places() {
    let catalog = builtin_catalog();
    let mut filled = 0;
    for seed in SEEDS {
        // The usual trays leave 0.35 m or more of the short side.
        let level = bathroom(1.25, 3.9, &[3]);
        let furnished = run(&level, catalog, seed);
        let [_, rest] = gaps_beside(&level, placement(catalog, &furnished, "bathing").unwrap());
        filled += u32::from(rest < 0.111);
        for group in ["wc", "washing"] {
            assert!(placement(catalog, &furnished, group).is_some(), "{group}, seed {seed}");
        }
    }
    assert!(filled >= 9, "{filled} of 12 fill the niche");
}

/// A bathroom whose north wall leans, so that no tray fits into a corner there; beside its door there are 0.68 m.
fn leaning_bathroom() -> Level {
    let mut level = level(&[(0.0, 0.0), (1.78, 0.0), (1.78, 2.4), (0.0, 2.6)]);
    let room = &mut level.rooms[0];
    room.room_type = "bathroom".to_owned();
    room.walls[0].tags.push("door".to_owned());
    room.walls[1].tags.push("pipes".to_owned());
    level
}

#[test]
fn where_no_corner_has_room_for_a_tray_a_tub_that_fits_one_stands_in_for_it() {
    let catalog = builtin_catalog();
    // What stands with both sides open in the best of some alternatives.
    let open_sides = |may_stand_in: bool, seed: u64| {
        let mut catalog = catalog.clone();
        let programme = &mut catalog.room_types.get_mut("bathroom").unwrap().programme;
        if !may_stand_in {
            programme.iter_mut().for_each(|request| request.substitutes.clear());
        }
        let (level, options) = (leaning_bathroom(), FurnishOptions::new(seed, "test"));
        let layout = RoomLayout::new(level.room(0), &catalog, &options);
        let made = (0..8).map(|number| layout.furnish(&Alternative::numbered(number)));
        let bathing = |made: &Counted| {
            let classes = made.furnished.placements.iter().map(|placement| &catalog.classes[placement.class]);
            classes.filter(|class| class.groups.iter().any(|group| group == "bathing")).count()
        };
        let made: Vec<Counted> = made.inspect(|made| assert_eq!(bathing(made), 1, "seed {seed}")).collect();
        made.iter().map(|made| made.shortcomings.poor_places.open_sides).min().unwrap()
    };
    for seed in 0..4 {
        assert_eq!((open_sides(true, seed), open_sides(false, seed)), (0, 1), "seed {seed}");
    }
}

/// The catalogue with bathrooms that ask for one class of what bathes, for which others may stand in.
fn with_bathing(class: &str, substitutes: &[&str]) -> Catalog {
    let mut catalog = builtin_catalog().clone();
    let index = |id: &str| catalog.class_index(id).unwrap();
    let (class, substitutes) = (index(class), substitutes.iter().map(|id| index(id)).collect::<Vec<_>>());
    let bathes = |class: usize| catalog.classes[class].groups.iter().any(|group| group == "bathing");
    let bathing: Vec<bool> = (0..catalog.classes.len()).map(bathes).collect();
    for request in &mut catalog.room_types.get_mut("bathroom").unwrap().programme {
        if bathing[request.classes[0]] {
            (request.classes, request.substitutes) = (vec![class], substitutes.clone());
        }
    }
    catalog
}

#[test]
fn a_shower_stands_in_for_a_tub_that_would_take_the_place_of_the_basin() {
    let catalog = with_bathing("bathtub", &["small_shower"]);
    for seed in SEEDS {
        let furnished = run(&bathroom(1.7, 2.2, &[]), &catalog, seed);
        for group in ["wc", "washing", "bathing"] {
            assert!(placement(&catalog, &furnished, group).is_some(), "{group}, seed {seed}");
        }
    }
}

#[test]
fn of_arrangements_that_are_nearly_as_good_each_has_seeds_that_choose_it() {
    let catalog = with_bathing("shower", &[]);
    let walls = |seed: u64| {
        let furnished = run(&bathroom(1.9, 2.2, &[]), &catalog, seed);
        ["wc", "washing", "bathing"]
            .map(|group| placement(&catalog, &furnished, group).map(|piece| piece.parent))
    };
    let mut found = Vec::new();
    for seed in 0..24 {
        let walls = walls(seed);
        if !found.contains(&walls) {
            found.push(walls);
        }
    }
    assert!(found.len() > 1, "{found:?}");
}

#[test]
fn an_alternative_is_the_same_whatever_was_made_before_it() {
    let level = bathroom(2.2, 2.4, &[2]);
    for seed in 0..4 {
        let kinds = kinds_of_alternatives(&level, seed);
        assert!(kinds >= 4, "seed {seed}: {kinds} kinds");
    }
}

#[test]
fn a_bed_for_one_has_a_long_side_at_a_wall() {
    let catalog = builtin_catalog();
    let mut level = bathroom(3.4, 3.6, &[]);
    level.rooms[0].room_type = "childrens_room".to_owned();
    for seed in SEEDS {
        let furnished = run(&level, catalog, seed);
        let bed = placement(catalog, &furnished, "sleeping").unwrap();
        assert!(gaps_beside(&level, bed)[0] < 0.04, "seed {seed}");
    }
}
