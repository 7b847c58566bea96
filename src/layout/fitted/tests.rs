//! Kitchens of the catalogue in rooms made by hand, each with several seeds.

use crate::catalog::{Catalog, FittedPart, Side, builtin_catalog};
use crate::geometry::{Point, Solid};
use crate::layout::tests::{kinds_of_alternatives, level, run};
use crate::layout::{FurnishOptions, Furnished, Lock, LockSupport, Parent, Placement, furnish, solids};
use crate::plan::{Level, Opening, OpeningKind, OpeningSide, RoomOpening};

const SEEDS: std::ops::Range<u64> = 0..12;
/// Metres between units that stand side by side.
const TOUCHING: f64 = 0.005;

fn corners(width: f64, depth: f64) -> [(f64, f64); 4] {
    [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)]
}

/// A room with a door at the start of its first wall.
fn room(room_type: &str, width: f64, depth: f64) -> Level {
    let mut level = level(&corners(width, depth));
    level.rooms[0].room_type = room_type.to_owned();
    level
}

/// The low units of a room, each with its part and its box.
fn units(catalog: &Catalog, furnished: &Furnished) -> Vec<(FittedPart, Solid)> {
    let low = furnished.placements.iter().filter_map(|placement| {
        let class = &catalog.classes[placement.class];
        let part = class.fitted.filter(|part| *part != FittedPart::WallUnit)?;
        Some((part, solids(class, placement)[0]))
    });
    low.collect()
}

fn distance(a: &Solid, b: &Solid) -> f64 {
    let (a, b) = (a.bounds, b.bounds);
    let x = (a.low.x - b.high.x).max(b.low.x - a.high.x).max(0.0);
    let y = (a.low.y - b.high.y).max(b.low.y - a.high.y).max(0.0);
    libm::hypot(x, y)
}

/// Groups of units that touch.
fn runs(units: &[(FittedPart, Solid)]) -> usize {
    let mut left: Vec<usize> = (0..units.len()).collect();
    let mut runs = 0;
    while let Some(first) = left.pop() {
        runs += 1;
        let mut reached = vec![first];
        while let Some(unit) = reached.pop() {
            let touches = |&other: &usize| distance(&units[unit].1, &units[other].1) < TOUCHING;
            let (near, far) = left.iter().copied().partition(touches);
            left = far;
            reached.extend::<Vec<usize>>(near);
        }
    }
    runs
}

fn apart(units: &[(FittedPart, Solid)], a: FittedPart, b: FittedPart) -> Option<f64> {
    let find = |part| units.iter().find(|unit| unit.0 == part).map(|unit| &unit.1);
    Some(distance(find(a)?, find(b)?))
}

#[test]
fn a_kitchen_is_one_row_with_worktop_between_sink_and_hob() {
    let catalog = builtin_catalog();
    for (width, depth) in [(2.6, 3.4), (3.0, 3.0), (2.4, 4.4), (4.0, 4.5)] {
        let level = room("kitchen", width, depth);
        for seed in SEEDS {
            let furnished = run(&level, catalog, seed);
            let units = units(catalog, &furnished);
            let place = format!("{width} x {depth} m, seed {seed}");
            assert!(runs(&units) <= 2, "{place}: {} runs", runs(&units));
            let between = apart(&units, FittedPart::Sink, FittedPart::Hob).expect(&place);
            assert!((0.3..2.0).contains(&between), "{place}: {between} m between sink and hob");
            if let Some(metres) = apart(&units, FittedPart::Sink, FittedPart::BesideSink) {
                assert!(metres < TOUCHING, "{place}: the dishwasher stands {metres} m off the sink");
            }
            let fridge = apart(&units, FittedPart::Tall, FittedPart::Hob).expect(&place);
            assert!(fridge > TOUCHING, "{place}: the fridge stands at the hob");
        }
    }
}

#[test]
fn an_alternative_is_the_same_whatever_was_made_before_it() {
    for (width, depth) in [(3.0, 3.0), (2.1, 3.4)] {
        let level = room("kitchen", width, depth);
        for seed in 0..3 {
            let kinds = kinds_of_alternatives(&level, seed);
            assert!(kinds >= 4, "{width} x {depth} m, seed {seed}: {kinds} kinds");
        }
    }
}

#[test]
fn a_row_turns_at_a_corner_where_one_wall_is_too_short() {
    let catalog = builtin_catalog();
    let level = room("kitchen", 2.5, 2.6);
    let turns = |seed: &u64| {
        let furnished = run(&level, catalog, *seed);
        units(catalog, &furnished).iter().any(|(part, _)| *part == FittedPart::Corner)
    };
    assert!(SEEDS.filter(turns).count() > 0);
}

#[test]
fn a_kitchen_turns_at_one_corner_or_at_two_by_the_seed() {
    let catalog = builtin_catalog();
    let mut level = room("kitchen", 2.2, 4.4);
    // A third leg is no gain here: what it holds is lost by windows and heating.
    level.rooms[0].walls.iter_mut().for_each(|wall| wall.is_exterior = true);
    let corners = |seed: u64| {
        let units = units(catalog, &run(&level, catalog, seed));
        units.iter().filter(|(part, _)| *part == FittedPart::Corner).count()
    };
    let corners: Vec<usize> = (0..24).map(corners).collect();
    assert!([1, 2].iter().all(|count| corners.contains(count)), "{corners:?}");
}

/// Metres at both ends of the third wall that its row leaves, if there is one.
fn gaps_at_third_wall(units: &[(FittedPart, Solid)], width: f64, depth: f64) -> Vec<f64> {
    let at_wall = || units.iter().filter(|(_, solid)| solid.bounds.high.y > depth - 0.01);
    let from = at_wall().map(|(_, solid)| solid.bounds.low.x).reduce(f64::min);
    let to = at_wall().map(|(_, solid)| width - solid.bounds.high.x).reduce(f64::min);
    from.into_iter().chain(to).collect()
}

/// Whether wall beside a row is lost: more than a joint, less than is of use.
fn is_lost(metres: &f64) -> bool {
    (0.03..0.6).contains(metres)
}

#[test]
fn a_row_reaches_the_walls_at_its_ends() {
    let catalog = builtin_catalog();
    for width in [2.33, 2.47, 2.58, 2.71, 3.04] {
        let level = room("kitchen", width, 3.6);
        let mut fillers = 0;
        for seed in SEEDS {
            let units = units(catalog, &run(&level, catalog, seed));
            let gaps = gaps_at_third_wall(&units, width, 3.6);
            assert!(!gaps.iter().any(is_lost), "{width} m, seed {seed}: {gaps:?}");
            fillers += units.iter().filter(|(part, _)| *part == FittedPart::Filler).count();
        }
        assert!(fillers > 0, "{width} m: no filler in any kitchen");
    }
}

#[test]
fn a_row_reaches_the_wall_that_an_open_side_begins_at() {
    let catalog = builtin_catalog();
    let (width, depth) = (3.1, 3.2);
    let mut level = room("kitchen", width, depth);
    // Less deep than the units are.
    open_to_end(&mut level, OpeningKind::OpenBoundary, (3, 0.5), [0.0, 2.5]);
    let mut rows = 0;
    for seed in SEEDS {
        let units = units(catalog, &run(&level, catalog, seed));
        // A bar leaves the floor before the open side free, and its corner, too.
        let is_bar = |solid: &Solid| solid.bounds.low.x < 0.5 && solid.bounds.low.y < depth - 0.7;
        if units.iter().any(|(_, solid)| is_bar(solid)) {
            continue;
        }
        let gaps = gaps_at_third_wall(&units, width, depth);
        assert!(!gaps.iter().any(is_lost), "seed {seed}: {gaps:?}");
        rows += usize::from(!gaps.is_empty());
    }
    assert!(rows > 0, "bars alone");
}

/// A room that is open along its third wall, and along its second where people come in.
fn open_kitchen(width: f64, depth: f64) -> Level {
    let mut level = room("kitchen", width, depth);
    level.openings.clear();
    level.rooms[0].openings.clear();
    open_to_end(&mut level, OpeningKind::OpenBoundary, (1, 0.8), [0.0, 2.5]);
    open_to_end(&mut level, OpeningKind::OpenBoundary, (2, 0.0), [0.0, 2.5]);
    level
}

/// Adds an opening of a kind from a place on a wall, in metres from its start, to the wall's end.
fn open_to_end(level: &mut Level, kind: OpeningKind, (wall, from): (usize, f64), [bottom, top]: [f64; 2]) {
    let segment = &level.rooms[0].walls[wall];
    let (opening, to) = (level.openings.len(), segment.length());
    level.openings.push(Opening {
        id: opening.to_string(),
        kind,
        center: segment.after(f64::midpoint(from, to)),
        along: segment.direction(),
        width: to - from,
        bottom,
        top,
        leaves: Vec::new(),
        sides: vec![OpeningSide { room: 0, wall, from, to }],
    });
    level.rooms[0].openings.push(RoomOpening { opening, wall, from, to });
}

#[test]
fn a_kitchen_that_opens_to_a_room_has_a_bar_there_with_an_aisle_before_it() {
    let catalog = builtin_catalog();
    let depth = 3.0;
    let level = open_kitchen(3.0, depth);
    let mut bars = 0;
    for seed in SEEDS {
        let units = units(catalog, &run(&level, catalog, seed));
        let is_bar = |solid: &Solid| solid.bounds.low.y > depth / 2.0 && solid.bounds.high.x > 0.7;
        let bar: Vec<_> = units.iter().filter(|(_, solid)| is_bar(solid)).collect();
        bars += usize::from(bar.len() > 1);
        assert!(runs(&units) <= 2, "seed {seed}: {} runs", runs(&units));
        if let Some(metres) = apart(&units, FittedPart::Sink, FittedPart::BesideSink) {
            assert!(metres < TOUCHING, "seed {seed}: the dishwasher stands {metres} m off the sink");
        }
        for (part, solid) in bar {
            assert!(*part != FittedPart::Hob, "seed {seed}: no hood hangs over a bar");
            // The floor before the open side stays free.
            assert!(solid.bounds.high.y < depth - 0.29, "seed {seed}: {}", solid.bounds.high.y);
        }
    }
    assert!(bars > 6, "{bars} bars");
}

#[test]
fn a_small_kitchen_has_room_to_cook() {
    let catalog = builtin_catalog();
    let level = room("kitchen", 1.6, 1.8);
    for seed in SEEDS {
        let units = units(catalog, &run(&level, catalog, seed));
        let hobs = units.iter().filter(|(part, _)| *part == FittedPart::Hob).count();
        assert_eq!((hobs, runs(&units)), (1, 1), "seed {seed}");
    }
}

#[test]
fn wall_units_hang_in_one_line_beside_the_hood() {
    let catalog = builtin_catalog();
    let level = room("kitchen", 3.6, 3.2);
    for seed in SEEDS {
        let furnished = run(&level, catalog, seed);
        let of = |id: &str| {
            let class = catalog.class_index(id).unwrap();
            let is_of_class = move |placement: &&Placement| placement.class == class;
            furnished.placements.iter().filter(is_of_class).collect::<Vec<_>>()
        };
        let cabinets = of("wall_cabinet");
        assert!(cabinets.len() >= 2 && of("hood").len() == 1, "seed {seed}: {}", cabinets.len());
        assert!(cabinets.iter().all(|cabinet| cabinet.elevation == cabinets[0].elevation), "seed {seed}");
        assert!(cabinets.iter().all(|cabinet| matches!(cabinet.parent, Parent::Wall(_))), "seed {seed}");
    }
}

#[test]
fn nothing_of_a_row_takes_the_light_of_a_window() {
    let catalog = builtin_catalog();
    let mut level = room("kitchen", 3.0, 4.0);
    open_to_end(&mut level, OpeningKind::Window, (1, 0.0), [0.5, 2.2]);
    for seed in SEEDS {
        let furnished = run(&level, catalog, seed);
        let glass = level.rooms[0].walls[1].start.x;
        for placement in furnished.placements.iter().filter(|placement| placement.size.height > 1.5) {
            let class = &catalog.classes[placement.class];
            let reach = solids(class, placement)[0].bounds.high.x;
            assert!(class.fitted.is_none() || reach < glass - 0.05, "seed {seed}: {} takes light", class.id);
        }
    }
}

#[test]
fn what_is_locked_stays_and_the_row_is_made_of_the_others() {
    let catalog = builtin_catalog();
    let level = room("kitchen", 3.4, 3.4);
    let free = run(&level, catalog, 1);
    let fridge = catalog.class_index("fridge").unwrap();
    let standing = free.placements.iter().find(|placement| placement.class == fridge).unwrap();
    let lock = Lock {
        class: fridge,
        number: 1,
        on: LockSupport::Part(Parent::Floor),
        side: Side::Above,
        position: Point::new(3.05, 1.7),
        elevation: None,
        angle: standing.angle,
        variant: None,
    };
    let locks = [lock];
    let options = FurnishOptions { locks: &locks, ..FurnishOptions::new(1, "test") };
    let furnished = furnish(level.room(0), catalog, &options);
    let locked = furnished.placements.iter().find(|placement| placement.class == fridge).unwrap();
    assert_eq!(locked.position, locks[0].position);
    let others: Vec<_> =
        units(catalog, &furnished).into_iter().filter(|(part, _)| *part != FittedPart::Tall).collect();
    assert!(runs(&others) <= 2, "{}", runs(&others));
}

#[test]
fn a_row_is_slim_as_a_whole_where_the_usual_units_leave_too_little_space() {
    let catalog = builtin_catalog();
    for (width, is_slim) in [(1.55, true), (2.6, false)] {
        let level = room("kitchen", width, 3.6);
        for seed in SEEDS {
            let furnished = run(&level, catalog, seed);
            let part = |placement: &&Placement| catalog.classes[placement.class].fitted;
            let is_low =
                |placement: &&Placement| part(placement).is_some_and(|part| part != FittedPart::WallUnit);
            let mut low = furnished.placements.iter().filter(is_low).peekable();
            assert!(low.peek().is_some(), "{width} m, seed {seed}");
            for placement in low {
                let (class, depth) = (&catalog.classes[placement.class].id, placement.size.depth);
                assert_eq!(depth < 0.55, is_slim, "{width} m, seed {seed}: {class} is {depth} m deep");
            }
        }
    }
}

#[test]
fn wall_units_hang_where_their_wall_is() {
    // The row at the wall before the slot goes on past it, up to what closes it; the slot is as deep as a wall unit.
    let slot = [(2.03, 0.0), (2.03, 2.22), (-2.2, 2.22), (-2.2, 1.9), (0.0, 1.9), (0.0, 0.0)];
    let catalog = builtin_catalog();
    let mut hanging = 0;
    for start in 0..slot.len() {
        let mut corners = slot;
        corners.rotate_left(start);
        let mut level = level(&corners);
        level.rooms[0].room_type = "kitchen".to_owned();
        for seed in SEEDS {
            for placement in run(&level, catalog, seed).placements {
                let is_wall_unit = catalog.classes[placement.class].fitted == Some(FittedPart::WallUnit);
                let Parent::Wall(wall) = placement.parent else { continue };
                if is_wall_unit {
                    let wall = &level.rooms[0].walls[wall];
                    let middle = (placement.position - wall.start).dot(wall.direction());
                    let half = placement.size.width / 2.0;
                    let (from, to) = (middle - half, middle + half);
                    assert!(from > -0.01 && to < wall.length() + 0.01, "{start}, {seed}: {from} to {to}");
                    hanging += 1;
                }
            }
        }
    }
    assert!(hanging > 0);
}
