//! Small drafts for tests, and one check for all guarantees of a level.

use std::collections::BTreeSet;

use super::{
    LeafDraft, Level, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, OpeningSide, RoomDraft, Wall,
};
use crate::geometry::{Point, Polygon};

pub(super) fn points(list: &[(f64, f64)]) -> Vec<Point> {
    list.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

pub(super) fn rectangle(id: &str, (x, y): (f64, f64), (width, depth): (f64, f64)) -> RoomDraft {
    RoomDraft {
        id: id.to_owned(),
        room_type: "generic".to_owned(),
        outline: points(&[(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]),
        ..RoomDraft::default()
    }
}

pub(super) fn opening(id: &str, kind: OpeningKind, place: OpeningPlace, width: f64) -> OpeningDraft {
    OpeningDraft {
        id: id.to_owned(),
        kind,
        place,
        rooms: Vec::new(),
        width,
        bottom: if kind == OpeningKind::Window { 0.9 } else { 0.0 },
        top: 2.0,
        leaf: LeafDraft::Automatic,
    }
}

pub(super) fn at(x: f64, y: f64, along: (f64, f64)) -> OpeningPlace {
    OpeningPlace::Points { center: Point::new(x, y), along: Some(Point::new(along.0, along.1)) }
}

pub(super) fn level(rooms: Vec<RoomDraft>, openings: Vec<OpeningDraft>) -> LevelDraft {
    LevelDraft {
        id: "ground".to_owned(),
        height: 3.0,
        exterior_thickness: 0.3,
        interior_thickness: 0.1,
        rooms,
        openings,
        ..LevelDraft::default()
    }
}

/// Two rooms, 0.2 m of wall between them.
pub(super) fn neighbours() -> Vec<RoomDraft> {
    vec![rectangle("west", (0.0, 0.0), (4.0, 3.0)), rectangle("east", (4.2, 0.0), (3.0, 3.0))]
}

/// The guarantees, as one check for every test here.
pub(super) fn check_guarantees(level: &Level) {
    let mut ids = BTreeSet::new();
    let mut numbers = BTreeSet::new();
    for (index, room) in level.rooms.iter().enumerate() {
        assert!(ids.insert(&room.id) && numbers.insert(room.number));
        let corners = room.region.outline.corners();
        assert_eq!(Polygon::new(corners).unwrap().corners(), corners);
        for hole in &room.region.holes {
            assert!(room.region.outline.contains(hole.corners()[0]));
        }
        let borders: Vec<_> = room.region.borders().collect();
        assert_eq!(borders, room.walls.iter().map(Wall::segment).collect::<Vec<_>>());
        assert!(room.height.is_finite() && room.height > 0.0);
        for wall in &room.walls {
            assert!(wall.thickness.is_finite() && wall.thickness >= 0.0);
            assert!(wall.tags.is_sorted());
        }
        for pair in room.openings.windows(2) {
            assert!((pair[0].wall, pair[0].from) <= (pair[1].wall, pair[1].from));
            assert!(pair[0].wall != pair[1].wall || pair[0].to <= pair[1].from, "{:?}", room.openings);
        }
        for entry in &room.openings {
            assert!(0.0 <= entry.from && entry.from < entry.to);
            assert!(entry.to <= room.walls[entry.wall].length());
            let mine = |side: &&OpeningSide| side.room == index && side.wall == entry.wall;
            let sides = &level.openings[entry.opening].sides;
            assert!(sides.iter().filter(mine).any(|side| side.from == entry.from && side.to == entry.to));
        }
        assert!(room.obstacles.iter().all(|column| column.height > 0.0 && column.height <= room.height));
    }
    let mut ids = BTreeSet::new();
    for opening in &level.openings {
        assert!(ids.insert(&opening.id));
        assert!((1..=2).contains(&opening.sides.len()));
        assert!(opening.center.is_finite() && (opening.along.length() - 1.0).abs() < 1e-9);
        assert!(opening.width > 0.0 && opening.bottom >= 0.0 && opening.bottom < opening.top);
        for side in &opening.sides {
            let room = &level.rooms[side.room];
            assert!(opening.top <= room.height);
            assert!(room.openings.iter().any(|entry| entry.wall == side.wall && entry.from == side.from));
        }
        for leaf in &opening.leaves {
            assert!(leaf.hinge.is_finite() && leaf.closed_tip.is_finite() && leaf.open_tip.is_finite());
        }
    }
}
