use crate::geometry::Point;
use crate::layout::{Parent, Placement, Removal, RemovalReason};
use crate::plan::{LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, assemble_level};

use super::*;
use crate::catalog::{Class, Clearance, RoomType, Side, Size};

const DESK: Size = Size { width: 1.6, depth: 0.8, height: 0.74 };

fn class() -> Class {
    Class {
        label: "Desk <wide>".to_owned(),
        clearances: vec![Clearance::SEAT],
        ..Class::plain("desk", vec![DESK], "desk")
    }
}

fn catalog() -> Catalog {
    let office = RoomType {
        id: "office".to_owned(),
        label: "Office".to_owned(),
        is_furnished: true,
        programme: Vec::new(),
        excludes: Vec::new(),
        density: (0.0, 1.0),
        finish: crate::catalog::Finish {
            floor: "wood".into(),
            wall: "plaster".into(),
            ceiling: "ceiling".into(),
        },
    };
    let room_types = [("office".to_owned(), office)].into();
    Catalog { classes: vec![class()], room_types, ..Catalog::default() }
}

fn opening(id: &str, kind: OpeningKind, center: Point) -> OpeningDraft {
    OpeningDraft {
        id: id.to_owned(),
        kind,
        place: OpeningPlace::Points { center, along: None },
        rooms: vec!["study".to_owned()],
        width: 0.9,
        bottom: 0.0,
        top: 2.0,
        leaf: crate::plan::LeafDraft::Automatic,
    }
}

fn level() -> Level {
    let room = |id: &str, room_type: &str, x: f64| RoomDraft {
        id: id.to_owned(),
        room_type: room_type.to_owned(),
        outline: [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)].map(|(u, v)| Point::new(x + u, v)).to_vec(),
        ..RoomDraft::default()
    };
    let draft = LevelDraft {
        id: "1".to_owned(),
        height: 3.0,
        exterior_thickness: 0.3,
        interior_thickness: 0.1,
        rooms: vec![room("study", "office", 0.0), room("shaft", "shaft", 4.1)],
        openings: vec![
            opening("d", OpeningKind::Door, Point::new(1.0, 0.0)),
            opening("w", OpeningKind::Window, Point::new(2.0, 3.0)),
        ],
        ..LevelDraft::default()
    };
    assemble_level(draft).0
}

fn furnished(room: usize) -> Furnished {
    let placement = Placement {
        class: 0,
        number: 1,
        parent: Parent::Floor,
        side: Side::Above,
        position: Point::new(2.0, 2.0),
        elevation: 0.0,
        angle: 0.0,
        variant: 0,
        size: DESK,
    };
    let removal = Removal { class: 0, reason: RemovalReason::NoPlace, is_required: false };
    Furnished {
        room,
        seed: 1,
        style: "default".to_owned(),
        requested: 3,
        placements: if room == 0 { vec![placement] } else { Vec::new() },
        removals: if room == 0 { vec![removal.clone(), removal] } else { Vec::new() },
    }
}

fn drawn(has_clearances: bool) -> String {
    let (level, catalog) = (level(), catalog());
    draw_level(&Drawing {
        building: "house & home",
        site: SitePlacement::default(),
        level: &level,
        furnished: &[furnished(0), furnished(1)],
        findings: &[],
        catalog: &catalog,
        seed: 1,
        has_clearances,
    })
}

#[test]
fn words_of_the_plan_cannot_break_the_file() {
    let svg = drawn(false);
    assert!(svg.contains("house &amp; home") && svg.contains("Desk &lt;wide&gt;"));
    assert!(!svg.contains("<wide>"));
}

#[test]
fn the_sheet_names_rooms_and_what_is_missing() {
    let svg = drawn(false);
    assert!(svg.contains(">study<") && svg.contains("Office, 12.0 m²"));
    assert!(svg.contains("study: 2 desk (no place)"));
    assert!(svg.contains("1 of 6 pieces placed"));
}

#[test]
fn a_door_has_an_arc_and_a_window_glass() {
    let svg = drawn(false);
    assert_eq!(svg.lines().filter(|line| line.contains('A') && line.contains("#f5e6cf")).count(), 1);
    assert_eq!(svg.matches("#e4f1fa").count(), 1);
}

#[test]
fn rooms_that_are_not_furnished_are_hatched() {
    assert_eq!(drawn(false).matches("fill=\"url(#hatch)\"").count(), 1);
}

#[test]
fn clearances_come_on_request() {
    assert_eq!(drawn(false).matches("#d9480f").count(), 0);
    assert!(drawn(true).matches("#d9480f").count() >= 2);
}

#[test]
fn up_in_the_plan_is_up_on_the_sheet() {
    let canvas = Canvas::new((Point::ZERO, Point::splat(10.0)));
    assert!(canvas.pixel(Point::new(0.0, 9.0)).y < canvas.pixel(Point::new(0.0, 1.0)).y);
}

#[test]
fn the_same_level_is_the_same_text() {
    assert_eq!(drawn(true), drawn(true));
}

#[test]
fn a_level_without_rooms_can_be_drawn() {
    let level = Level { rooms: Vec::new(), openings: Vec::new(), ..level() };
    let catalog = catalog();
    let svg = draw_level(&Drawing {
        building: "b",
        site: SitePlacement::default(),
        level: &level,
        furnished: &[],
        findings: &[],
        catalog: &catalog,
        seed: 1,
        has_clearances: false,
    });
    assert!(svg.ends_with("</svg>\n"));
}
