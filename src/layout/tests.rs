//! Agents in small rooms, with classes made by hand.

use std::f64::consts::PI;

use super::constants::MOST_STEPS;
use super::surroundings::{Surroundings, Swings};
use super::*;
use crate::catalog::*;
use crate::geometry::{Convex, Point, Polygon, Region, Solid, direction};
use crate::plan::{Leaf, Level, Opening, OpeningKind, OpeningSide, Room, RoomOpening, Stairs, Well};
use crate::recipes::{GeometrySet, Slot, find};

pub(super) fn rule(parent: ParentName, sides: &[Side], turn: Turn, along: Along) -> ParentRule {
    ParentRule {
        parent,
        sides: sides.to_vec(),
        tag: None,
        orientation: Orientation { turn, jitter: 0.0 },
        along,
        gap: (0.0, 0.0),
        elevation: (0.0, 0.0),
        above_head: None,
    }
}

fn class(id: &str, size: (f64, f64, f64), parents: Vec<ParentRule>, depth: u32) -> Class {
    let size = Size { width: size.0, depth: size.1, height: size.2 };
    Class { parents, depth, ..Class::plain(id, vec![size], find("cabinet").unwrap()) }
}

/// chair, desk, lamp, light, shelf: sorted by id, as a catalogue must be.
fn classes() -> Vec<Class> {
    let mut desk = class(
        "desk",
        (1.6, 0.8, 0.74),
        vec![rule(ParentName::Wall, &[Side::Front], Turn::Parallel, Along::Random)],
        0,
    );
    desk.sides[Side::Front.index()].places = 1;
    desk.sides[Side::Above.index()].places = 2;
    desk.clearances = vec![Clearance::SEAT];
    let at_desk = rule(ParentName::Classes(vec![1]), &[Side::Front], Turn::Facing, Along::Center);
    let on_desk = rule(ParentName::Classes(vec![1]), &[Side::Above], Turn::Parallel, Along::Back);
    let on_ceiling = rule(ParentName::Ceiling, &[Side::Below], Turn::Parallel, Along::Random);
    let mut light = class("light", (0.6, 0.6, 0.1), vec![on_ceiling], 0);
    light.grid = Some(Grid {
        interval: Point::splat(2.0),
        block: [0, 0],
        aisle: 0.0,
        is_centered: true,
        is_halved: false,
        is_back_to_back: false,
        margin: [0.0; 4],
    });
    let at_wall = rule(ParentName::Wall, &[Side::Front], Turn::Parallel, Along::Random);
    vec![
        class("chair", (0.5, 0.5, 0.9), vec![at_desk], 1),
        desk,
        class("lamp", (0.2, 0.2, 0.4), vec![on_desk], 1),
        light,
        class("shelf", (1.0, 0.4, 2.0), vec![at_wall], 0),
    ]
}

pub(super) fn catalog(programme: &[(usize, Count)], untidiness: Untidiness) -> Catalog {
    let request = |&(class, count): &(usize, Count)| Request {
        classes: vec![class],
        substitutes: Vec::new(),
        count,
        area: (0.0, f64::INFINITY),
        is_required: false,
        chance: 1.0,
        needs_window: false,
        for_whom: crate::catalog::ForWhom::default(),
    };
    let finish = Finish {
        floor: Slot::Carpet,
        wall: Slot::Plaster,
        ceiling: Slot::Ceiling,
        dado: None,
        sockets: None,
        has_switches: false,
    };
    let room_type = RoomType {
        id: "office".into(),
        label: "Office".into(),
        is_furnished: true,
        joins_levels: false,
        programme: programme.iter().map(request).collect(),
        excludes: Vec::new(),
        area: (0.0, 1e6),
        plausible: crate::catalog::Plausible::default(),
        share: crate::catalog::Share::default(),
        density: (0.2, 0.4),
        finish,
    };
    let style = Style {
        id: DEFAULT_STYLE.into(),
        label: "Default".into(),
        room_types: Vec::new(),
        programmes: Default::default(),
        additions: Default::default(),
        geometry: GeometrySet::Plain,
        palette: PaletteRef::default(),
        untidiness,
        density: 1.0,
        access: Access::default(),
        era: None,
        wealth: None,
    };
    Catalog {
        classes: classes(),
        room_types: [("office".to_owned(), room_type)].into(),
        styles: [style].into_iter().collect(),
        ..Catalog::default()
    }
}

/// A room with a door 0.9 m wide that opens inward at the start of its first wall.
pub(super) fn level(corners: &[(f64, f64)]) -> Level {
    let points: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
    let region = Region::simple(Polygon::new(&points).unwrap());
    let bare = Room::bare("1", "office", region, 2.8, 0.1);
    let walls = &bare.walls;
    let hinge = walls[0].after(0.2);
    let leaf = Leaf {
        hinge,
        closed_tip: hinge + walls[0].direction() * 0.9,
        open_tip: hinge + walls[0].normal() * 0.9,
    };
    let door = Opening {
        id: "1".into(),
        kind: OpeningKind::Door,
        center: walls[0].after(0.65),
        along: walls[0].direction(),
        width: 0.9,
        bottom: 0.0,
        top: 2.0,
        leaves: vec![leaf],
        sides: vec![OpeningSide { room: 0, wall: 0, from: 0.2, to: 1.1 }],
    };
    let room = Room { openings: vec![RoomOpening { opening: 0, wall: 0, from: 0.2, to: 1.1 }], ..bare };
    Level { openings: vec![door].into(), ..Level::bare("0", 3.0, vec![room]) }
}

pub(super) const WIDE: &[(f64, f64)] = &[(0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0)];
const CONCAVE: &[(f64, f64)] = &[(0.0, 0.0), (6.0, 0.0), (6.0, 2.5), (3.0, 2.5), (3.0, 5.0), (0.0, 5.0)];

pub(super) fn run(level: &Level, catalog: &Catalog, seed: u64) -> Furnished {
    furnish(level.room(0), catalog, &FurnishOptions::new(seed, "test"))
}

const OFFICE: &[(usize, Count)] = &[
    (0, Count::Fixed(3)),
    (1, Count::Fixed(3)),
    (2, Count::Fixed(3)),
    (3, Count::Fixed(6)),
    (4, Count::Fixed(2)),
];

fn assert_free(level: &Level, catalog: &Catalog, furnished: &Furnished) {
    let solid = |p: &Placement| solids(&catalog.classes[p.class], p)[0];
    let all: Vec<_> = furnished.placements.iter().map(solid).collect();
    for (index, a) in all.iter().enumerate() {
        assert!(all[..index].iter().all(|b| !a.overlaps(b, 1e-3)), "collision in seed {}", furnished.seed);
        let inside = |corner: &&Point| {
            let inward = **corner + (a.base.center() - **corner).normalize() * 2e-3;
            level.rooms[0].region.contains(inward)
        };
        assert!(a.footprint().iter().all(|corner| inside(&corner)), "outside in seed {}", furnished.seed);
    }
    let swing = Surroundings::new(level.room(0), &catalog.audit, Swings::Simple).kept_free;
    assert!(all.iter().all(|a| swing.iter().all(|region| !a.overlaps(&region.solid, 1e-3))), "door blocked");
}

#[test]
fn nothing_stands_in_the_hole_of_stairs() {
    let catalog = catalog(OFFICE, Untidiness::default());
    let mut level = level(WIDE);
    let opening = Polygon::rectangle(Point::new(0.0, 3.0), Point::new(3.0, 2.0));
    let base = Convex::rectangle(Point::new(1.5, 4.0), Point::new(1.5, 1.0), Point::X);
    let hole = Solid::new(base, 0.0, 2.0);
    let met = |level: &Level| {
        let pieces = (0..10).flat_map(|seed| run(level, &catalog, seed).placements);
        pieces
            .flat_map(|piece| solids(&catalog.classes[piece.class], &piece))
            .filter(|body| body.overlaps(&hole, 1e-3))
            .count()
    };
    assert!(met(&level) > 0, "pieces stand there in a room without stairs");
    let well = Well { opening, guards: Vec::new(), nosings: Vec::new() };
    level.stairs = vec![Stairs { room: 0, up: None, well: Some(well) }].into();
    assert_eq!(met(&level), 0);
}

#[test]
fn clearances_reach_across_an_open_side_but_not_onto_stairs() {
    let catalog = catalog(OFFICE, Untidiness::default());
    // A desk and the seat before it are deeper than the room.
    let mut level = level(&[(0.0, 0.0), (6.0, 0.0), (6.0, 1.4), (0.0, 1.4)]);
    let (from, to) = (0.0, 6.0);
    let open = &mut level.openings[0];
    (open.kind, open.width, open.leaves) = (OpeningKind::OpenBoundary, 6.0, Vec::new());
    open.sides = vec![OpeningSide { room: 0, wall: 0, from, to }, OpeningSide { room: 1, wall: 0, from, to }];
    level.rooms[0].openings[0] = RoomOpening { opening: 0, wall: 0, from, to };
    let other = level.rooms[0].clone();
    level.rooms.push(other);
    let desks = |level: &Level| {
        let pieces = (0..10).flat_map(|seed| run(level, &catalog, seed).placements);
        pieces.filter(|piece| catalog.classes[piece.class].id == "desk").count()
    };
    assert!(desks(&level) > 0);
    let well = Well {
        opening: Polygon::rectangle(Point::new(0.0, -3.0), Point::new(6.0, 3.0)),
        guards: Vec::new(),
        nosings: Vec::new(),
    };
    level.stairs = vec![Stairs { room: 1, up: None, well: Some(well) }].into();
    assert_eq!(desks(&level), 0);
}

/// Metres between an open side of a room and the nearest body, over many seeds.
fn nearest_to_the_open_side(catalog: &Catalog) -> f64 {
    let mut level = level(WIDE);
    let open = &mut level.openings[0];
    (open.kind, open.width, open.leaves) = (OpeningKind::OpenBoundary, 6.0, Vec::new());
    let (from, to) = (0.0, 6.0);
    level.rooms[0].openings[0] = RoomOpening { opening: 0, wall: 0, from, to };
    let bodies = (0..40).flat_map(|seed| {
        let furnished = run(&level, catalog, seed);
        let on_floor = furnished.placements.into_iter().filter(|one| one.elevation < 2.0);
        on_floor.flat_map(|one| solids(&catalog.classes[one.class], &one)).collect::<Vec<_>>()
    });
    let low = bodies.map(|solid| solid.bounds.low.y);
    low.fold(f64::INFINITY, f64::min)
}

#[test]
fn layouts_obey_the_figures_of_the_audit() {
    let mut catalog = catalog(OFFICE, Untidiness::default());
    let usual = nearest_to_the_open_side(&catalog);
    let asked = catalog.audit.doors.open_boundary_depth;
    assert!(usual >= asked - 1e-3 && usual < 2.0 * asked, "{usual}");
    catalog.audit.doors.open_boundary_depth = 2.0 * asked;
    let wider = nearest_to_the_open_side(&catalog);
    assert!(wider >= 2.0 * asked - 1e-3, "{wider}");
}

#[test]
fn rooms_are_free_of_collisions_whatever_their_shape() {
    let catalog = catalog(OFFICE, Untidiness::default());
    for corners in [WIDE, CONCAVE] {
        let level = level(corners);
        for seed in 0..100 {
            assert_free(&level, &catalog, &run(&level, &catalog, seed));
        }
    }
}

#[test]
fn an_office_with_room_enough_holds_all_it_asks_for() {
    let (level, catalog) = (level(WIDE), catalog(OFFICE, Untidiness::default()));
    let placed: usize = (0..100).map(|seed| run(&level, &catalog, seed).placements.len()).sum();
    assert!(placed >= 1690, "only {placed} of 1700 rest");
}

#[test]
fn chairs_face_their_desks_and_lamps_stand_on_them() {
    let (level, catalog) = (level(WIDE), catalog(OFFICE, Untidiness::default()));
    let room = run(&level, &catalog, 5);
    for child in room.placements.iter().filter(|p| p.class == 0 || p.class == 2) {
        let Parent::Object(desk) = child.parent else { panic!("{child:?} has no desk") };
        let desk = &room.placements[desk];
        assert_eq!(desk.class, 1);
        if child.class == 0 {
            let turned = (child.angle - desk.angle).rem_euclid(2.0 * PI);
            assert!((turned - PI).abs() < 1e-9, "a chair looks at its desk");
            assert_eq!(child.elevation, 0.0);
        } else {
            assert_eq!(child.elevation, 0.74);
        }
    }
}

#[test]
fn each_light_hangs_in_the_middle_of_its_share_of_the_room() {
    let (level, catalog) = (level(WIDE), catalog(&[(3, Count::Fixed(6))], Untidiness::default()));
    let room = run(&level, &catalog, 1);
    let mut positions: Vec<(i64, i64)> = room
        .placements
        .iter()
        .map(|p| ((p.position.x * 1e3).round() as i64, (p.position.y * 1e3).round() as i64))
        .collect();
    positions.sort_unstable();
    assert_eq!(
        positions,
        [(1000, 1250), (1000, 3750), (3000, 1250), (3000, 3750), (5000, 1250), (5000, 3750)]
    );
}

#[test]
fn the_same_seed_gives_the_same_room_and_another_seed_another() {
    let (level, catalog) = (level(WIDE), catalog(OFFICE, Untidiness::default()));
    assert_eq!(run(&level, &catalog, 3), run(&level, &catalog, 3));
    assert_ne!(run(&level, &catalog, 3).placements, run(&level, &catalog, 4).placements);
}

#[test]
fn mats_in_rows_lie_beside_each_other() {
    let mut catalog = catalog(&[(3, Count::Fill(60))], Untidiness::default());
    let mat = &mut catalog.classes[3];
    mat.sizes = vec![Size { width: 1.2, depth: 0.8, height: 0.012 }];
    mat.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random)];
    let grid = mat.grid.as_mut().expect("lights hang in a grid");
    grid.interval = Point::new(1.22, 0.85);
    let mats = run(&level(&[(0.0, 0.0), (8.0, 0.0), (8.0, 6.0), (0.0, 6.0)]), &catalog, 1).placements;
    assert!((20..60).contains(&mats.len()), "as many as have a place: {}", mats.len());
    let is_apart = |one: &Placement, other: &Placement| one.position.distance(other.position) > 0.75;
    let mut pairs = (0..mats.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
    assert!(pairs.all(|(a, b)| is_apart(&mats[a], &mats[b])));
}

#[test]
fn what_is_known_of_the_places_of_a_lattice_changes_no_room() {
    // Explanations know nothing of places that were refused before.
    let mut catalog = catalog(&[(3, Count::Fixed(40)), (4, Count::Fixed(80))], Untidiness::default());
    let grid = catalog.classes[3].grid;
    let shelf = &mut catalog.classes[4];
    shelf.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random)];
    shelf.grid = grid.map(|grid| Grid { interval: Point::new(1.1, 0.7), is_back_to_back: true, ..grid });
    let level = level(CONCAVE);
    for seed in 0..20 {
        let options = FurnishOptions::new(seed, "test");
        let layout = RoomLayout::new(level.room(0), &catalog, &options);
        let furnished = layout.furnish(&Alternative::default()).furnished;
        assert!(furnished.placements.len() > 12 && !furnished.removals.is_empty());
        assert_eq!(layout.explain(&Alternative::default()).0, furnished, "seed {seed}");
    }
}

#[test]
fn shelves_stand_back_to_back_in_rows_with_an_aisle_between() {
    let level = level(&[(0.0, 0.0), (9.0, 0.0), (9.0, 8.0), (0.0, 8.0)]);
    let mut catalog = catalog(&[(4, Count::Fixed(8))], Untidiness::default());
    let shelf = &mut catalog.classes[4];
    shelf.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random)];
    let interval = Point::new(1.0, 2.0);
    let margin = [0.0; 4];
    shelf.grid = Some(Grid {
        interval,
        block: [0, 0],
        aisle: 0.0,
        is_centered: true,
        is_halved: false,
        is_back_to_back: true,
        margin,
    });
    let placements = run(&level, &catalog, 1).placements;
    assert_eq!(placements.len(), 8);
    for one in &placements {
        let back = direction(one.angle).perp();
        let is_partner = |other: &&Placement| (one.position + back * 0.4).distance(other.position) < 1e-9;
        let partner = placements.iter().find(is_partner).expect("somebody's back is at its back");
        assert!((direction(partner.angle) + direction(one.angle)).length() < 1e-9);
    }
}

#[test]
fn one_more_lamp_moves_no_desk() {
    let level = level(WIDE);
    let with = |lamps| {
        let catalog = catalog(&[(1, Count::Fixed(3)), (2, Count::Fixed(lamps))], Untidiness::default());
        let mut placements = run(&level, &catalog, 9).placements;
        placements.retain(|p| p.class == 1);
        placements
    };
    assert_eq!(with(2), with(3));
}

#[test]
fn an_untidy_room_is_crooked_but_free() {
    let untidiness = Untidiness { turn: 0.2, distance: 0.1 };
    let (level, catalog) = (level(WIDE), catalog(OFFICE, untidiness));
    let mut crooked = 0;
    for seed in 0..50 {
        let room = run(&level, &catalog, seed);
        assert_free(&level, &catalog, &room);
        let off = |p: &&Placement| libm::sin(2.0 * p.angle).abs() > 0.02;
        crooked += room.placements.iter().filter(off).count();
    }
    assert!(crooked > 100, "only {crooked} of about 850 objects are off their angle");
}

#[test]
fn what_finds_no_room_is_removed_with_its_reason() {
    let (level, catalog) = (
        level(&WIDE.iter().map(|&(x, y)| (x / 3.0, y / 3.0)).collect::<Vec<_>>()),
        catalog(OFFICE, Untidiness::default()),
    );
    let room = run(&level, &catalog, 2);
    assert_eq!(room.placements.len() + room.removals.len(), 17);
    assert!(room.removals.iter().any(|removal| removal.class == 1));
    let chairs_gone = room.removals.iter().filter(|removal| removal.class == 0);
    assert!(chairs_gone.into_iter().all(|removal| removal.reason != RemovalReason::Outside));
}

#[test]
fn fill_asks_for_no_more_than_fits() {
    let (level, catalog) = (level(WIDE), catalog(&[(4, Count::Fill(100))], Untidiness::default()));
    let room = run(&level, &catalog, 2);
    assert!(room.removals.is_empty());
    assert!((8..=22).contains(&room.placements.len()), "{} shelves", room.placements.len());
    assert_eq!(room.requested as usize, room.placements.len());
}

/// A strip with a door at each end: shelves against both walls leave too little between them.
fn strip_rooms() -> (Level, Catalog, Vec<Furnished>) {
    let mut level = level(&[(0.0, 0.0), (1.2, 0.0), (1.2, 6.0), (0.0, 6.0)]);
    let far = Opening {
        id: "2".into(),
        center: Point::new(0.6, 6.0),
        along: level.rooms[0].walls[2].direction(),
        leaves: Vec::new(),
        sides: vec![OpeningSide { room: 0, wall: 2, from: 0.15, to: 1.05 }],
        ..level.openings[0].clone()
    };
    level.openings.push(far);
    level.rooms[0].openings.push(RoomOpening { opening: 1, wall: 2, from: 0.15, to: 1.05 });
    let catalog = catalog(&[(4, Count::Fixed(5))], Untidiness::default());
    let rooms = (0..50).map(|seed| run(&level, &catalog, seed)).collect();
    (level, catalog, rooms)
}

#[test]
fn who_stands_in_the_only_way_is_sent_away() {
    let (level, catalog, rooms) = strip_rooms();
    let is_closed = |room: &Furnished| {
        let findings = crate::solve::judge_room(level.room(0), room, &catalog).findings;
        findings.iter().any(|finding| finding.code == crate::audit::Code::Unreachable)
    };
    assert!(!rooms.iter().any(is_closed));
    let shelves: usize = rooms.iter().map(|room| room.placements.len()).sum();
    assert!(shelves >= 2 * rooms.len(), "{shelves} of {} rest", 5 * rooms.len());
}

#[test]
fn who_was_sent_away_for_good_says_so() {
    let (.., rooms) = strip_rooms();
    let removals = rooms.iter().flat_map(|room| &room.removals);
    assert!(removals.filter(|removal| removal.reason == RemovalReason::Repair).count() > 0);
}

/// The office with shelves that are good to have 2 m before them, in a room as deep as is asked for.
fn shelves_before(depth: f64, is_required: bool) -> Furnished {
    let mut catalog = catalog(&[(4, Count::Fixed(1))], Untidiness::default());
    let front = Clearance { minimum: 0.5, good: 2.0, ..Clearance::SEAT };
    catalog.classes[4].clearances = vec![Clearance { allows_children: false, ..front }];
    for room_type in catalog.room_types.values_mut() {
        room_type.programme[0].is_required = is_required;
    }
    run(&level(&[(0.0, 0.0), (2.2, 0.0), (2.2, depth), (0.0, depth)]), &catalog, 3)
}

#[test]
fn a_piece_that_would_be_tight_stays_out_unless_it_is_required() {
    assert_eq!(shelves_before(2.6, false).placements.len(), 1, "2.6 m hold 0.4 and 2.0");
    let tight = shelves_before(2.1, false);
    assert_eq!(tight.removals[0].reason, RemovalReason::Comfort);
    assert_eq!(shelves_before(2.1, true).placements.len(), 1);
}

#[test]
fn each_alternative_holds_the_same_pieces_elsewhere() {
    let (level, catalog) = (level(WIDE), catalog(OFFICE, Untidiness::default()));
    let options = FurnishOptions::new(1, "test");
    let alternative = |number| {
        RoomLayout::new(level.room(0), &catalog, &options).furnish(&Alternative::numbered(number)).furnished
    };
    assert_eq!(alternative(0), run(&level, &catalog, 1));
    let pieces = |room: &Furnished| (room.requested, room.seed);
    assert_eq!(pieces(&alternative(1)), pieces(&alternative(0)));
    assert_ne!(alternative(1).placements, alternative(0).placements);
}

#[test]
fn who_has_a_suggestion_stands_there_and_others_keep_off() {
    let (level, catalog) = (level(WIDE), catalog(OFFICE, Untidiness::default()));
    let options = FurnishOptions::new(1, "test");
    let desk = &run(&level, &catalog, 2).placements[0];
    let wall = match desk.parent {
        Parent::Wall(wall) => Some(wall),
        _ => None,
    };
    let suggestion =
        Suggestion { class: desk.class, size: desk.size, position: desk.position, angle: desk.angle, wall };
    let alternative = Alternative { suggestions: vec![suggestion], ..Alternative::numbered(1) };
    let furnished = RoomLayout::new(level.room(0), &catalog, &options).furnish(&alternative).furnished;
    let is_there = |placement: &Placement| {
        placement.class == desk.class && placement.position.distance(desk.position) < 1e-9
    };
    assert!(furnished.placements.iter().any(is_there));
}

#[test]
fn no_alternative_depends_on_those_that_were_furnished_before_it() {
    let (level, catalog) = (level(WIDE), catalog(OFFICE, Untidiness::default()));
    let options = FurnishOptions::new(1, "test");
    let desk = &run(&level, &catalog, 2).placements[0];
    let suggestion = Suggestion {
        class: desk.class,
        size: desk.size,
        position: desk.position,
        angle: desk.angle,
        wall: None,
    };
    let shared = RoomLayout::new(level.room(0), &catalog, &options);
    for suggestions in [Vec::new(), vec![suggestion], Vec::new()] {
        for number in 0..3 {
            let alternative =
                Alternative { suggestions: suggestions.clone(), ..Alternative::numbered(number) };
            let alone = RoomLayout::new(level.room(0), &catalog, &options).furnish(&alternative);
            assert_eq!(shared.furnish(&alternative), alone);
        }
    }
}

/// In how many kinds of places the pieces of the first few alternatives of a room stand. Fails where one is not the same, steps
/// included, made alone, after others of the room, and with an explanation.
pub(super) fn kinds_of_alternatives(level: &Level, seed: u64) -> usize {
    let options = FurnishOptions::new(seed, "test");
    let room = || RoomLayout::new(level.room(0), builtin_catalog(), &options);
    let shared = room();
    let mut kinds = Vec::new();
    for alternative in (0..6).rev().map(Alternative::numbered) {
        let made = shared.furnish(&alternative);
        assert_eq!(made, room().furnish(&alternative), "{seed} {alternative:?}");
        assert_eq!(made.furnished, room().explain(&alternative).0, "{seed} {alternative:?}");
        let placements = made.furnished.placements.iter();
        let kind: Vec<_> = placements.map(|placement| (placement.class, placement.parent)).collect();
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    kinds.len()
}

#[test]
fn what_has_no_place_in_a_corridor_of_any_length_takes_a_bounded_number_of_steps() {
    let mut catalog = catalog(&[(4, Count::Fixed(1))], Untidiness::default());
    for room_type in catalog.room_types.values_mut() {
        room_type.programme[0].is_required = true;
    }
    let steps = |length: f64| {
        let level = level(&[(0.0, 0.0), (length, 0.0), (length, 0.3), (0.0, 0.3)]);
        let options = FurnishOptions::new(1, "test");
        let counted = RoomLayout::new(level.room(0), &catalog, &options).furnish(&Alternative::default());
        assert_eq!(counted.furnished.placements, []);
        counted.steps
    };
    for length in [300.0, 1000.0, 3000.0] {
        let steps = steps(length);
        assert!(steps < 2 * MOST_STEPS, "{length} m: {steps} steps");
    }
}
