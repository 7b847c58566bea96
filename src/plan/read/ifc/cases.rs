//! The cases of curved bodies, roofs, curtain walls and spaces without a body: what becomes of each.

use std::f64::consts::PI;
use std::path::Path;

use super::read;
use crate::document::Faults;
use crate::geometry::{Point, Polygon};
use crate::plan::read::real_data::words;
use crate::plan::{Level, OpeningKind, assemble_level};

/// A case with some text replaced, put together; its levels, what was noted of the file, and of the levels.
fn case(name: &str, from: &str, to: &str) -> (Vec<Level>, Vec<String>) {
    let path = format!("tests/cases/plan_import/{name}/{name}.ifc");
    let text = std::fs::read_to_string(path).unwrap();
    assert!(text.contains(from), "{name} has no {from}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(Path::new(name).with_extension("ifc"));
    std::fs::write(&path, text.replacen(from, to, 1)).unwrap();
    let found = read(&path, &words(), false).unwrap_or_else(|faults| panic!("{faults}"));
    let mut noted = messages(&found.faults);
    let drafts = found.buildings.into_iter().flat_map(|building| building.draft.levels);
    let mut levels = Vec::new();
    for draft in drafts {
        let (level, problems) = assemble_level(draft);
        noted.extend(problems.into_iter().map(|problem| problem.message));
        levels.push(level);
    }
    (levels, noted)
}

fn messages(faults: &Faults) -> Vec<String> {
    assert!(faults.0.iter().all(|fault| fault.position.is_some() && fault.hint.is_some()), "{faults}");
    faults.0.iter().map(|fault| fault.message.clone()).collect()
}

fn area(level: &Level, room: &str) -> f64 {
    let room = level.rooms.iter().find(|other| other.id == room).unwrap_or_else(|| panic!("no room {room}"));
    room.region.outline.area()
}

fn height(level: &Level, room: &str) -> f64 {
    level.rooms.iter().find(|other| other.id == room).unwrap().height
}

fn assert_near(found: f64, expected: f64, reach: f64) {
    assert!((found - expected).abs() < reach, "{found} is not {expected}");
}

#[test]
fn rooms_with_curved_faces_have_outlines_within_the_sag() {
    let (levels, noted) = case("rotunda", "#1=", "#1=");
    assert_eq!(noted, Vec::<String>::new());
    let level = &levels[0];
    // Twice the chord error times the perimeter, and a door's chord.
    assert_near(area(level, "1"), PI * 9.0, 0.25);
    assert_near(height(level, "1"), 3.2, 1e-6);
    assert_near(area(level, "3"), PI * (4.8f64.powi(2) - 3.3f64.powi(2)) / 2.0, 0.25);
    assert_near(height(level, "3"), 2.6, 1e-6);
    // The spline bulges 6 t (1 - t) metres beyond its chord, of which 6 m make 6 square metres.
    assert_near(area(level, "2"), 5.7 * 6.0 + 6.0, 0.05);
    assert_near(area(level, "4"), 16.0, 1e-6);
    assert_near(height(level, "4"), 3.0, 1e-6);
    assert_eq!(level.openings.len(), 3);
    let joined = |id: &str| level.openings.iter().find(|opening| opening.id == id).unwrap().sides.len();
    assert_eq!((joined("0door1"), joined("0door2")), (2, 2));
    assert_eq!(level.rooms.iter().map(|room| room.obstacles.len()).sum::<usize>(), 1);
}

#[test]
fn broken_splines_and_edges_leave_only_their_room_out() {
    for (from, to, message) in [
        ("IFCBSPLINESURFACEWITHKNOTS(2,2", "IFCBSPLINESURFACEWITHKNOTS(2,99", "a spline of degree 99"),
        (",(3,3),(3,3),(0.,1.)", ",(3,4),(3,3),(0.,1.)", "its knots do not fit its points"),
        (",(3,3),(3,3),(0.,1.)", ",(3,3),(3,3),(1.,0.)", "its knots do not fit its points"),
        (".UNSPECIFIED.,(1.,1.,1.,1.)", ".UNSPECIFIED.,(1.,0.,1.,1.)", "no weight above zero"),
        ("KNOTS(3,(#", "KNOTS(3,($,#", "is no list of references"),
        ("IFCORIENTEDEDGE(", "IFCDIRECTION((0.),", "edges of this kind are not read"),
        ("6.283185);", "-1.);", "is no number above zero"),
    ] {
        let (levels, noted) = case("rotunda", from, to);
        assert!(noted.iter().any(|noted| noted.contains(message)), "{to}: {noted:?}");
        let rooms = if message.contains("above zero") && to.starts_with('-') { 4 } else { 3 };
        assert_eq!(levels[0].rooms.len(), rooms, "{to}");
    }
}

#[test]
fn roof_windows_are_counted_and_steep_ones_are_windows_of_their_wall() {
    let (levels, noted) = case("attic", "#1=", "#1=");
    let expected = "roof windows and hatches: 3 are left out, as a plan has openings in walls only";
    assert_eq!(noted, [expected]);
    let windows: Vec<_> =
        levels[0].openings.iter().filter(|opening| opening.kind == OpeningKind::Window).collect();
    let [window] = windows[..] else { panic!("{windows:?}") };
    assert_eq!(window.id, "0dormer");
    assert_near(window.bottom, 0.9, 1e-6);
    assert_near(window.center.x, 2.5, 1e-6);
}

#[test]
fn panes_of_curtain_walls_are_windows_of_each_storey_they_cross() {
    let (levels, noted) = case("pavilion", "#1=", "#1=");
    assert!(noted[0].starts_with("a wall is not read"), "{noted:?}");
    assert_eq!(noted[1..], ["panes of curtain walls: 2 of them stand slanting or have no flat body"]);
    let of = |level: &Level, kind: OpeningKind| -> Vec<(String, f64, f64, f64)> {
        let all = level.openings.iter().filter(|opening| opening.kind == kind);
        all.map(|opening| (opening.id.clone(), opening.width, opening.bottom, opening.top)).collect()
    };
    let shown = |level: &Level| -> Vec<String> {
        let windows = of(level, OpeningKind::Window).into_iter();
        let mut shown: Vec<String> =
            windows.map(|(id, width, low, high)| format!("{id} {width:.2} {low:.2} {high:.2}")).collect();
        shown.sort();
        shown
    };
    assert_eq!(
        shown(&levels[0]),
        [
            "0north 5.00 0.00 2.90",
            "0pane1a 1.90 0.05 2.90",
            "0pane2 1.90 0.05 2.90",
            "0pane4 1.90 0.05 2.90",
            "opening_180 2.10 0.00 2.90"
        ]
    );
    assert_eq!(
        shown(&levels[1]),
        [
            "0pane4 1.90 0.00 2.70",
            "0upper0 1.90 0.10 2.70",
            "0upper1 1.90 0.10 2.70",
            "0upper2 1.90 0.10 2.70"
        ]
    );
    let doors = of(&levels[0], OpeningKind::Door);
    assert_eq!(doors.len(), 2);
    let door = levels[0].openings.iter().find(|opening| opening.id == "0door").unwrap();
    assert!(door.center.distance(Point::new(5.0, -0.1)) < 0.1, "{}", door.center);
}

#[test]
fn spaces_without_a_body_are_outlined_by_boundaries_or_walls() {
    let (levels, noted) = case("shell", "#1=", "#1=");
    let level = &levels[0];
    for (room, square_metres) in [("1", 20.0), ("2", 19.0), ("3", 19.0)] {
        assert_near(area(level, room), square_metres, 1e-6);
    }
    assert_near(height(level, "2"), 2.7, 1e-6);
    assert_near(height(level, "3"), 2.7, 1e-6);
    let told = |part: &str| assert!(noted.iter().any(|noted| noted.contains(part)), "{part}: {noted:?}");
    told("spaces without a body: 2 have the outline of their boundaries");
    told("spaces without a body: 1 has the outline of the walls around them");
    told("space \"4\":");
    told("it has no body, and no walls are all around its place (20.00, 2.00)");
    told("it has no body, and its place (10.50, 2.00) lies in room \"3\"");
    assert_eq!((noted.len(), level.rooms.len(), level.openings.len()), (4, 3, 4));
}

#[test]
fn a_gap_in_the_walls_leaves_a_bodiless_space_out() {
    let (levels, noted) = case("shell", "'W3'", "'W3',$,$,$,$,$,$);\n#9999=IFCBEAM('0beam',$,'W3'");
    assert!(noted.iter().any(|noted| noted.contains("all around its place (10.00, 2.50)")), "{noted:?}");
    assert!(levels[0].rooms.iter().all(|room| room.id != "3"));
}

#[test]
fn outlines_of_floors_are_believed_before_those_of_walls() {
    let square = Polygon::new(&[(0.0, 0.0), (4.0, 0.0), (4.0, 5.0), (0.0, 5.0)].map(Point::from)).unwrap();
    let (levels, _) = case("shell", "#1=", "#1=");
    let kitchen = levels[0].rooms.iter().find(|room| room.id == "1").unwrap();
    assert_near(kitchen.region.outline.area(), square.area(), 1e-6);
    assert!(
        kitchen
            .region
            .outline
            .corners()
            .iter()
            .all(|corner| square.edges().any(|edge| edge.distance(*corner) < 1e-6))
    );
}
