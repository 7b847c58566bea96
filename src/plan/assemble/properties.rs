//! Assembled levels keep the guarantees of `plan/mod.rs`, whatever the draft.

use proptest::prelude::*;

use crate::geometry::Point;
use crate::plan::sample::{check_guarantees, level, points};
use crate::plan::{
    LeafDraft, LevelDraft, ObstacleDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind, RoomDraft,
    Subject, assemble_level,
};

/// Mostly sane numbers, sometimes hostile ones.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        40 => (-40i32..40).prop_map(|steps| f64::from(steps) * 0.25),
        20 => -10.0..10.0f64,
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(1e300), Just(1e-300), Just(-0.0)],
    ]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}

fn ring() -> impl Strategy<Value = Vec<Point>> {
    let block = (point(), 0.02..6.0f64, 0.02..6.0f64, 0.0..1.0f64).prop_map(|(low, width, depth, notch)| {
        let (x, y) = (low.x, low.y);
        let cut = (x + width * notch, y + depth * notch);
        points(&[
            (x, y),
            (x + width, y),
            (x + width, cut.1),
            (cut.0, cut.1),
            (cut.0, y + depth),
            (x, y + depth),
        ])
    });
    prop_oneof![5 => block, 1 => prop::collection::vec(point(), 0..9)]
}

fn room_draft() -> impl Strategy<Value = RoomDraft> {
    let id = (0u32..30).prop_map(|number| format!("r{number}"));
    let tags = prop::collection::vec((0usize..8, "[a-c]"), 0..4);
    let height = prop::option::of(coordinate());
    (id, ring(), prop::collection::vec(ring(), 0..3), tags, height, prop::option::of(0u32..5)).prop_map(
        |(id, outline, holes, edge_tags, height, number)| RoomDraft {
            id,
            number,
            room_type: "generic".to_owned(),
            outline,
            holes,
            edge_tags,
            height,
            ..RoomDraft::default()
        },
    )
}

fn opening_draft() -> impl Strategy<Value = OpeningDraft> {
    let kinds = prop::sample::select(vec![
        OpeningKind::Door,
        OpeningKind::SlidingDoor,
        OpeningKind::Passage,
        OpeningKind::OpenBoundary,
        OpeningKind::Window,
    ]);
    let place = prop_oneof![
        (point(), prop::option::of(point()))
            .prop_map(|(center, along)| OpeningPlace::Points { center, along }),
        (0usize..8, coordinate()).prop_map(|(edge, at)| OpeningPlace::Edge { edge, at }),
    ];
    let rooms = prop::collection::vec((0u32..30).prop_map(|number| format!("r{number}")), 0..3);
    (0u32..60, kinds, place, rooms, 0.05..3.0f64, coordinate(), coordinate()).prop_map(
        |(id, kind, place, rooms, width, bottom, top)| OpeningDraft {
            id: format!("o{id}"),
            kind,
            place,
            rooms,
            width,
            bottom: if bottom < 1.0 { 0.0 } else { bottom },
            top: if top < 1.0 { 2.0 } else { top },
            leaf: LeafDraft::Automatic,
        },
    )
}

fn level_draft() -> impl Strategy<Value = LevelDraft> {
    let kind = prop_oneof![Just(OutlineKind::Inner), Just(OutlineKind::Center)];
    let columns = prop::collection::vec((ring(), prop::option::of(coordinate())), 0..4);
    (
        prop::collection::vec(room_draft(), 0..12),
        prop::collection::vec(opening_draft(), 0..20),
        columns,
        prop::collection::vec(ring(), 0..4),
        prop::collection::vec(ring(), 0..4),
        kind,
        coordinate(),
    )
        .prop_map(|(rooms, openings, columns, railings, wall_outlines, outlines, height)| LevelDraft {
            outlines,
            height: if (-5.0..2.0).contains(&height) { 3.0 } else { height },
            railings,
            wall_outlines,
            obstacles: columns
                .into_iter()
                .map(|(outline, height)| ObstacleDraft { outline, height })
                .collect(),
            ..level(rooms, openings)
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_draft_keeps_the_guarantees(draft in level_draft()) {
        let (room_count, opening_count) = (draft.rooms.len(), draft.openings.len());
        let (level, problems) = assemble_level(draft.clone());
        check_guarantees(&level);
        // Nothing vanishes without a word. Where most rooms are impossible, one word is for all that is in the level.
        let is_hopeless = level.rooms.is_empty() && problems.iter().any(|problem| problem.is_impossible);
        let about_rooms = problems.iter().filter(|problem| {
            matches!(problem.subject, Subject::Room(_) | Subject::RoomCorner(..))
        });
        prop_assert!(is_hopeless || level.rooms.len() + about_rooms.count() >= room_count);
        let about_openings =
            problems.iter().filter(|problem| matches!(problem.subject, Subject::Opening(_)));
        prop_assert!(is_hopeless || level.openings.len() + about_openings.count() >= opening_count);
        let (again, _) = assemble_level(draft);
        prop_assert_eq!(level.digest, again.digest);
    }
}

/// A storey of equal columns and rows, turned: rooms share edges, some wall stands between all of them.
#[derive(Clone, Debug)]
struct Block {
    widths: Vec<f64>,
    depths: Vec<f64>,
    turn: f64,
    gap: f64,
}

fn block() -> impl Strategy<Value = Block> {
    let sizes = || prop::collection::vec(1.2..6.0f64, 1..5);
    let gap = prop_oneof![Just(0.0), 0.05..0.5f64];
    (sizes(), sizes(), 0.0..6.3f64, gap).prop_map(|(widths, depths, turn, gap)| Block {
        widths,
        depths,
        turn,
        gap,
    })
}

impl Block {
    fn turned(&self, x: f64, y: f64) -> Point {
        let (sine, cosine) = libm::sincos(self.turn);
        Point::new(x * cosine - y * sine, x * sine + y * cosine)
    }

    /// A room for each cell, and a door of 0.8 m in the middle of each wall between two columns.
    fn draft(&self) -> LevelDraft {
        let (mut rooms, mut openings) = (Vec::new(), Vec::new());
        let mut x = 0.0;
        for (column, width) in self.widths.iter().enumerate() {
            let mut y = 0.0;
            for (row, depth) in self.depths.iter().enumerate() {
                let corners = [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)];
                let outline = corners.map(|(x, y)| self.turned(x, y)).to_vec();
                let id = format!("r{column}-{row}");
                rooms.push(RoomDraft {
                    id,
                    room_type: "generic".to_owned(),
                    outline,
                    ..RoomDraft::default()
                });
                if column > 0 {
                    openings.push(self.door(column, row, Point::new(x - self.gap / 2.0, y + depth / 2.0)));
                }
                y += depth + self.gap;
            }
            x += width + self.gap;
        }
        let outlines = if self.gap == 0.0 { OutlineKind::Center } else { OutlineKind::Inner };
        LevelDraft { outlines, ..level(rooms, openings) }
    }

    fn door(&self, column: usize, row: usize, middle: Point) -> OpeningDraft {
        let place = OpeningPlace::Points {
            center: self.turned(middle.x, middle.y),
            along: Some(self.turned(0.0, 1.0)),
        };
        OpeningDraft {
            id: format!("d{column}-{row}"),
            kind: OpeningKind::Door,
            place,
            rooms: Vec::new(),
            width: 0.8,
            bottom: 0.0,
            top: 2.0,
            leaf: LeafDraft::Automatic,
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn neighbours_meet_at_every_door_however_the_house_is_turned(block in block()) {
        let draft = block.draft();
        let (level, problems) = assemble_level(draft.clone());
        check_guarantees(&level);
        prop_assert_eq!(problems, vec![]);
        prop_assert_eq!(level.rooms.len(), draft.rooms.len());
        prop_assert_eq!(level.openings.len(), draft.openings.len());
        for opening in &level.openings {
            let mut rooms: Vec<&str> =
                opening.sides.iter().map(|side| level.rooms[side.room].id.as_str()).collect();
            rooms.sort_unstable();
            let (column, row) = opening.id[1..].split_once('-').unwrap();
            let column: usize = column.parse().unwrap();
            let (west, east) = (format!("r{}-{row}", column - 1), format!("r{column}-{row}"));
            prop_assert_eq!(rooms, vec![west.as_str(), east.as_str()]);
            prop_assert!((opening.width - 0.8).abs() < 1e-6);
            prop_assert_eq!(opening.leaves.len(), 1);
        }
        // Inner walls are as thick as the gap, or as the draft says where outlines are centre lines.
        let half = if block.gap == 0.0 { 0.05 } else { block.gap / 2.0 };
        for wall in level.rooms.iter().flat_map(|room| &room.walls) {
            let expected = if wall.is_exterior { 0.3 } else { half };
            prop_assert!((wall.thickness - expected).abs() < 1e-6, "{} {}", wall.thickness, expected);
        }
    }
}
