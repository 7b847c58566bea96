use crate::geometry::{Bounds, Point};
use crate::layout::{Parent, Placement, Removal, RemovalReason};
use crate::plan::{LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, WallKind, assemble_level};

use super::*;
use crate::audit::Code;
use crate::audit::testing::{found as finding, given};
use crate::catalog::{Class, Clearance, ModelSource, RoomType, Side, Size, StyleRef};
use crate::recipes::{Slot, find};

const DESK: Size = Size { width: 1.6, depth: 0.8, height: 0.74 };

fn class() -> Class {
    Class {
        label: "Desk <wide>".to_owned(),
        clearances: vec![Clearance::SEAT],
        ..Class::plain("desk", vec![DESK], find("desk").unwrap())
    }
}

fn catalog() -> Catalog {
    let office = RoomType {
        id: "office".to_owned(),
        label: "Office".to_owned(),
        is_furnished: true,
        joins_levels: false,
        programme: Vec::new(),
        excludes: Vec::new(),
        area: (0.0, 1e6),
        plausible: crate::catalog::Plausible::default(),
        share: crate::catalog::Share::default(),
        density: (0.0, 1.0),
        finish: crate::catalog::Finish {
            floor: Slot::Wood,
            wall: Slot::Plaster,
            ceiling: Slot::Ceiling,
            dado: None,
            sockets: None,
            has_switches: false,
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
        style: StyleRef::default(),
        requested: 3,
        placements: if room == 0 { vec![placement] } else { Vec::new() },
        removals: if room == 0 { vec![removal.clone(), removal] } else { Vec::new() },
    }
}

fn drawn(has_clearances: bool) -> String {
    draw(&[], has_clearances, false)
}

/// The level with findings in the study.
fn found(findings: Vec<Finding>) -> String {
    draw(&[findings, Vec::new()], false, true)
}

/// The plan without what explains its signs.
fn above_legend(svg: &str) -> String {
    svg.split_once(">Legend</text>").unwrap().0.to_owned()
}

fn draw_rooms(level: &Level, has_legend: bool) -> String {
    draw_level(&Drawing {
        building: "b",
        site: SitePlacement::default(),
        level,
        furnished: &[furnished(0), furnished(1)],
        findings: &[],
        catalog: &catalog(),
        seed: 1,
        has_clearances: false,
        has_findings: false,
        has_legend,
    })
}

fn draw(findings: &[Vec<Finding>], has_clearances: bool, has_findings: bool) -> String {
    let (level, catalog) = (level(), catalog());
    draw_level(&Drawing {
        building: "house & home",
        site: SitePlacement::default(),
        level: &level,
        furnished: &[furnished(0), furnished(1)],
        findings,
        catalog: &catalog,
        seed: 1,
        has_clearances,
        has_findings,
        has_legend: true,
    })
}

#[test]
fn the_legend_explains_what_is_shown_and_nothing_else() {
    let svg = drawn(false);
    for meaning in ["wall", "window", "door and its swing", "not furnished"] {
        assert!(svg.contains(&format!(">{meaning}</text>")), "{meaning}");
    }
    for meaning in ["railing, parapet", "sliding door", "open passage", "column", "hangs above", "bed, couch"]
    {
        assert!(!svg.contains(&format!(">{meaning}</text>")), "{meaning}");
    }
    let (mut level, mut catalog) = (level(), catalog());
    level.rooms[0].walls[0].kind = WallKind::Railing(1.0);
    catalog.classes[0].model = ModelSource::Recipe { recipe: find("bed").unwrap(), parameters: Vec::new() };
    let svg = draw_level(&Drawing {
        building: "b",
        site: SitePlacement::default(),
        level: &level,
        furnished: &[furnished(0), furnished(1)],
        findings: &[],
        catalog: &catalog,
        seed: 1,
        has_clearances: false,
        has_findings: false,
        has_legend: true,
    });
    assert!(svg.contains(">railing, parapet</text>") && svg.contains(">bed, couch</text>"));
    assert!(!draw_rooms(&level, false).contains(">Legend</text>"));
}

#[test]
fn the_legend_sums_up_the_floor_of_each_room_type() {
    let drawn = drawn(false);
    let svg = drawn.split_once(">Rooms</text>").unwrap().1;
    let [study, shaft] = [0, 1].map(|room| level().rooms[room].region.area());
    for (label, area) in [("Office", study), ("shaft", shaft), ("All rooms", study + shaft)] {
        let words = svg.split_once(&format!(">{label}</text>")).expect(label).1;
        let area = format!(">{area:.1} m²</text>");
        assert!(words.lines().take(3).any(|line| line.ends_with(&area)), "{label}: {area}");
    }
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
    let svg = above_legend(&drawn(false));
    assert_eq!(svg.lines().filter(|line| line.contains('A') && line.contains("#f7f3ea")).count(), 1);
    assert_eq!(svg.matches("#f4f9fc").count(), 1);
}

#[test]
fn levels_on_one_sheet_stand_beside_each_other() {
    let (level, catalog) = (level(), catalog());
    let rooms = [furnished(0), furnished(1)];
    let drawing = Drawing {
        building: "b",
        site: SitePlacement::default(),
        level: &level,
        furnished: &rooms,
        findings: &[],
        catalog: &catalog,
        seed: 1,
        has_clearances: false,
        has_findings: false,
        has_legend: true,
    };
    let svg = draw_levels(&[drawing; 3]);
    let places: Vec<&str> = svg.lines().filter(|line| line.starts_with("<svg")).collect();
    assert_eq!(places.len(), 4);
    let (width, height) = (paint(&drawing).extent().x, paint(&drawing).extent().y);
    assert!(places[0].contains(&format!("width=\"{}\" height=\"{}\"", 2.0 * width, 2.0 * height)));
    assert!(places[2].contains(&format!("x=\"{width}\" y=\"0\"")));
    assert!(places[3].contains(&format!("x=\"0\" y=\"{height}\"")));
}

#[test]
fn stairs_have_treads_and_a_shaft_has_none() {
    let mut level = level();
    let treads = |level: &Level| {
        let svg = draw_rooms(level, true);
        svg.matches("stroke=\"#777\" stroke-width=\"0.5\"").count()
    };
    assert_eq!(treads(&level), 0);
    level.rooms[1].room_type = "stairs".to_owned();
    assert_eq!(treads(&level), 14, "4 m in treads of 0.28 m, and the line between two flights");
}

#[test]
fn rooms_that_are_not_furnished_are_hatched() {
    assert_eq!(above_legend(&drawn(false)).matches("fill=\"url(#hatch)\"").count(), 1);
}

#[test]
fn clearances_come_on_request() {
    assert_eq!(drawn(false).matches("#d9480f").count(), 0);
    assert!(drawn(true).matches("#d9480f").count() >= 2);
}

#[test]
fn up_in_the_plan_is_up_on_the_sheet() {
    let canvas = Canvas::new(Bounds::new(Point::ZERO, Point::splat(10.0)));
    assert!(canvas.pixel(Point::new(0.0, 9.0)).y < canvas.pixel(Point::new(0.0, 1.0)).y);
}

#[test]
fn the_same_level_is_the_same_text() {
    assert_eq!(drawn(true), drawn(true));
}

#[test]
fn a_level_without_rooms_can_be_drawn() {
    let level = Level { rooms: Vec::new().into(), openings: Vec::new().into(), ..level() };
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
        has_findings: true,
        has_legend: true,
    });
    assert!(svg.ends_with("</svg>\n"));
}

#[test]
fn a_finding_is_outlined_numbered_and_listed_with_its_figures() {
    let svg = found(vec![finding(Code::Bare, &["desk.1"])]);
    assert_eq!(svg.matches("stroke=\"#e67700\" stroke-width=\"2.4\"").count(), 1);
    assert_eq!(
        svg.matches("font-weight=\"bold\" fill=\"#fff\">1<").count(),
        2,
        "in the plan and in the list"
    );
    for word in [">bare<", ">desk.1<", ">50 %<", ">90 %<", ">study: minor<", ">1 minor<"] {
        assert!(svg.contains(word), "{word}");
    }
    assert!(!drawn(false).contains("#e67700"));
}

#[test]
fn the_worst_grade_colours_the_name_of_the_room() {
    let name = |findings| {
        let svg = found(findings);
        let line = svg.lines().rfind(|line| line.contains(">study<")).unwrap().to_owned();
        line.split("fill=\"").nth(1).unwrap()[..7].to_owned()
    };
    let minor = finding(Code::Sparse, &[]);
    let failed = finding(Code::MissingRequired, &["desk"]);
    assert_eq!(name(vec![]), "#2b8a3e");
    assert_eq!(name(vec![given(&failed)]), "#2b8a3e");
    assert_eq!(name(vec![minor.clone()]), "#d9480f");
    assert_eq!(name(vec![minor, failed]), "#c92a2a");
}

#[test]
fn the_floor_that_a_finding_is_about_is_hatched() {
    let hatched = |region| {
        let svg = found(vec![Finding { region, ..finding(Code::TightUse, &["desk.1"]) }]);
        svg.matches("fill=\"url(#hatch-minor)\"").count()
    };
    let square = vec![Point::ZERO, Point::X, Point::ONE, Point::Y];
    assert_eq!(hatched(Vec::new()), 0);
    assert_eq!(hatched(vec![square.clone(), square]), 2);
}

#[test]
fn marks_of_one_object_stand_side_by_side() {
    let svg = found(vec![finding(Code::Bare, &["desk.1"]); 30]);
    let value = |line: &str, key: &str| -> f64 {
        let rest = line.split(&format!("{key}=\"")).nth(1).unwrap();
        rest.split('"').next().unwrap().parse().unwrap()
    };
    let is_mark = |line: &&str| line.starts_with("<circle") && line.contains("stroke=\"#fff\"");
    let marks: Vec<Point> =
        svg.lines().filter(is_mark).map(|line| Point::new(value(line, "cx"), value(line, "cy"))).collect();
    assert_eq!(marks.len(), 30);
    for (index, a) in marks.iter().enumerate() {
        assert!(marks[..index].iter().all(|b| (*a - *b).abs().max_element() >= 15.0), "mark {}", index + 1);
    }
}
