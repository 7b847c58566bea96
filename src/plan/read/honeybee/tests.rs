//! Models from the text to levels.

use std::fs;

use super::{read, recognises};
use crate::document::Faults;
use crate::plan::read::real_data::words;
use crate::plan::{Level, LevelDraft, Opening, OpeningKind, assemble_level};

/// The drafts of a model in a text, and its faults.
fn drafts(text: &str) -> (Vec<LevelDraft>, Faults) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("house.json");
    fs::write(&path, text).unwrap();
    assert!(recognises(&path), "{text}");
    match read(&path, &words()) {
        Ok(read) => (read.buildings.into_iter().flat_map(|one| one.draft.levels).collect(), read.faults),
        Err(faults) => (Vec::new(), faults),
    }
}

fn messages(faults: &Faults) -> Vec<String> {
    faults.0.iter().map(|fault| fault.message.clone()).collect()
}

fn levels(drafts: Vec<LevelDraft>) -> Vec<Level> {
    let level = |draft| {
        let (level, problems) = assemble_level(draft);
        assert!(problems.iter().all(|problem| !problem.is_error), "{problems:?}");
        level
    };
    drafts.into_iter().map(level).collect()
}

/// The openings between two rooms.
fn between<'a>(level: &'a Level, one: &str, other: &str) -> Vec<&'a Opening> {
    let joins = |opening: &&Opening| {
        let rooms: Vec<&str> = opening.sides.iter().map(|side| level.rooms[side.room].id.as_str()).collect();
        rooms == [one, other] || rooms == [other, one]
    };
    level.openings.iter().filter(joins).collect()
}

#[test]
fn models_in_the_coordinates_of_a_country_are_moved_to_the_origin() {
    let near = story(r#""units": "Meters","#, ["\"floor_holes\": null"; 2], "");
    let mut model: serde_json::Value = serde_json::from_str(&near).unwrap();
    for room in model["buildings"][0]["unique_stories"][0]["room_2ds"].as_array_mut().unwrap() {
        for corner in room["floor_boundary"].as_array_mut().unwrap() {
            corner[0] = (corner[0].as_f64().unwrap() + 2_600_000.0).into();
            corner[1] = (corner[1].as_f64().unwrap() + 1_200_000.0).into();
        }
    }
    let (far, faults) = drafts(&model.to_string());
    assert!(!faults.has_errors(), "{faults}");
    let (near, _) = drafts(&near);
    let outlines = |levels: &[LevelDraft]| -> Vec<_> {
        levels.iter().flat_map(|level| &level.rooms).map(|room| room.outline.clone()).collect()
    };
    assert_eq!(outlines(&far), outlines(&near));
}

/// A story of two rooms of 4 by 3 units side by side, with what else each room says.
fn story(unit: &str, [west, east]: [&str; 2], story: &str) -> String {
    let room = |id: &str, x: f64, more: &str| {
        format!(
            r#"{{"type": "Room2D", "identifier": "{id}", "floor_height": 0, "floor_to_ceiling_height": 3,
                "floor_boundary": [[{x}, 0], [{}, 0], [{}, 3], [{x}, 3]], {more}}}"#,
            x + 4.0,
            x + 4.0
        )
    };
    format!(
        r#"{{"type": "Model", {unit} "buildings": [{{"identifier": "b", "unique_stories": [{{
            "identifier": "Ground", {story} "room_2ds": [{}, {}]}}]}}]}}"#,
        room("Kitchen_1", 0.0, west),
        room("Bedroom_2", 4.0, east)
    )
}

const JOINED: [&str; 2] = [
    r#""boundary_conditions": [{"type": "Outdoors"}, {"type": "Surface",
        "boundary_condition_objects": ["Bedroom_2..Face4", "Bedroom_2"]}, {"type": "Ground"}, {"type": "Outdoors"}]"#,
    r#""boundary_conditions": [{"type": "Outdoors"}, {"type": "Outdoors"}, {"type": "Outdoors"},
        {"type": "Surface", "boundary_condition_objects": ["Kitchen_1..Face2", "Kitchen_1"]}]"#,
];

#[test]
fn a_door_that_both_rooms_state_joins_them_once() {
    let west = format!(
        r#"{}, "window_parameters": [{{"type": "SimpleWindowRatio", "window_ratio": 0.3}},
            {{"type": "DetailedWindows", "polygons": [[[0.5, 0], [1.4, 0], [1.4, 2.1], [0.5, 2.1]]], "are_doors": [true]}},
            null, null]"#,
        JOINED[0]
    );
    let east = format!(
        r#"{}, "window_parameters": [null, null, null,
            {{"type": "RectangularWindows", "origins": [[1.6, 0.01]], "widths": [0.9], "heights": [2.1], "are_doors": [true]}}]"#,
        JOINED[1]
    );
    let (drafts, faults) = drafts(&story("", [&west, &east], ""));
    assert!(faults.is_empty(), "{faults}");
    let level = &levels(drafts)[0];
    let doors = between(level, "Kitchen_1", "Bedroom_2");
    assert_eq!(level.openings.len(), 2);
    assert_eq!((doors.len(), doors[0].kind, doors[0].width), (1, OpeningKind::Door, 1.4 - 0.5));
    assert_eq!(doors[0].center.x, 4.0);
    assert!((doors[0].center.y - 0.95).abs() < 1e-9);
    let types: Vec<&str> = level.rooms.iter().map(|room| room.room_type.as_str()).collect();
    assert_eq!(types, ["kitchen", "bedroom"]);
    assert_eq!(level.rooms[0].region.area(), 12.0, "walls take nothing from the floors of a model");
}

#[test]
fn an_air_boundary_is_no_wall_and_rooms_without_a_door_are_counted_once() {
    let open = |condition: &str, edges: &str| format!(r#"{condition}, "air_boundaries": [{edges}]"#);
    let west = open(JOINED[0], "false, true, false, false");
    let east = open(JOINED[1], "false, false, false, true");
    let (open_drafts, faults) = drafts(&story("", [&west, &east], ""));
    assert!(faults.is_empty(), "{faults}");
    let level = &levels(open_drafts)[0];
    let boundary = between(level, "Kitchen_1", "Bedroom_2");
    assert_eq!((boundary.len(), boundary[0].kind), (1, OpeningKind::OpenBoundary));
    assert!((boundary[0].width - 3.0).abs() < 1e-9);
    let (_, faults) = drafts(&story("", JOINED, ""));
    let told = messages(&faults);
    assert_eq!(told, ["2 rooms without a way in: the model draws neither a door nor an air boundary"]);
    assert!(faults.0[0].position.is_some() && !faults.has_errors());
}

#[test]
fn lengths_are_in_the_units_of_the_model() {
    let units = [
        ("Meters", 1.0),
        ("Feet", 0.3048),
        ("Inches", 0.0254),
        ("Centimeters", 0.01),
        ("Millimeters", 0.001),
    ];
    for (word, metres) in units {
        let unit = format!(r#""units": "{word}","#);
        let (drafts, _) = drafts(&story(&unit, JOINED, r#""floor_to_floor_height": 4, "multiplier": 2,"#));
        let corner = drafts[0].rooms[1].outline[2];
        assert!((corner.x - 8.0 * metres).abs() < 1e-12 && (corner.y - 3.0 * metres).abs() < 1e-12);
        assert!((drafts[0].rooms[0].height.unwrap() - 3.0 * metres).abs() < 1e-12);
    }
    let (_, faults) = drafts(&story(r#""units": "Feets","#, JOINED, ""));
    assert_eq!(messages(&faults), ["unknown unit \"Feets\""]);
    assert_eq!(faults.0[0].hint.as_deref(), Some("did you mean \"Feet\"?"));
}

#[test]
fn a_multiplied_storey_stands_on_itself() {
    let (drafts, _) = drafts(&story("", JOINED, r#""floor_to_floor_height": 3.5, "multiplier": 3,"#));
    let levels: Vec<(&str, f64, f64)> =
        drafts.iter().map(|level| (level.id.as_str(), level.elevation, level.height)).collect();
    assert_eq!(levels, [("ground", 0.0, 3.5), ("ground_2", 3.5, 3.5), ("ground_3", 7.0, 3.5)]);
    let (many, faults) = self::drafts(&story("", JOINED, r#""multiplier": 4000000000,"#));
    assert_eq!(many.len(), 200);
    assert!(messages(&faults)[0].contains("3999999800 levels are left out"), "{faults}");
}

#[test]
fn all_faults_have_their_places() {
    let west =
        r#""boundary_conditions": [{"type": "Outdoors"}], "window_parameters": [{"type": "Bubble"}, null]"#;
    let east = r#""floor_holes": null, "floor_boundary_": 1, "boundary_conditions": [
        {"type": "Surface", "boundary_condition_objects": ["x", "Attic"]}, {"type": "Outdoors"},
        {"type": "Outdoors"}, {"type": "Outdoors"}]"#;
    let text = story("", [west, east], "").replace("[4, 0], [8, 0], [8, 3], [4, 3]", "[4, 0], [8, 0]");
    let (_, faults) = drafts(&text);
    let told: Vec<(String, String)> = faults
        .0
        .iter()
        .map(|fault| (crate::document::show_path(&fault.path), fault.message.clone()))
        .collect();
    let room = "buildings[0].unique_stories[0].room_2ds";
    let expected = [
        (format!("{room}[0]"), "1 room without a way in: the model draws neither a door nor an air boundary"),
        (
            format!("{room}[0].boundary_conditions"),
            "room \"Kitchen_1\" has 4 edges and 1 boundary_conditions",
        ),
        (format!("{room}[0].window_parameters"), "room \"Kitchen_1\" has 4 edges and 2 window_parameters"),
        (
            format!("{room}[0].window_parameters[0]"),
            "window parameters \"Bubble\" are unknown or incomplete: 1 wall without windows",
        ),
        (format!("{room}[1].floor_boundary"), "the floor of room \"Bedroom_2\" has 2 corners"),
    ];
    let expected: Vec<(String, String)> =
        expected.into_iter().map(|(path, message)| (path, message.to_owned())).collect();
    let mut told = told;
    told.sort();
    assert_eq!(told, expected);
    assert!(faults.0.iter().all(|fault| fault.position.is_some()));
}

#[test]
fn what_is_no_model_is_said_to_be_none() {
    let (_, faults) = drafts(r#"{"type": "Story", "room_2ds": [{"type": "Room2D"}]}"#);
    assert_eq!(messages(&faults), ["is a Story, no Model"]);
    let (_, faults) = drafts(r#"{"type": "Model", "properties": {"type": "ModelProperties"}, "rooms": []}"#);
    assert_eq!(messages(&faults), ["the model has neither buildings nor rooms"]);
    let (_, faults) =
        drafts(r#"{"type": "Model", "rooms": [{"properties": {"type": "RoomPropertiesAbridged"}}]}"#);
    assert!(messages(&faults).iter().any(|message| message.contains("identifier")), "{faults}");
}

/// A honeybee face.
fn face(kind: &str, corners: &[[f64; 3]], more: &str) -> String {
    format!(r#"{{"face_type": "{kind}", "geometry": {{"boundary": {corners:?}}} {more}}}"#)
}

/// A honeybee room between two corners, with faces of its own for the south wall.
fn block(
    id: &str,
    [x, y, z]: [f64; 3],
    [east, north, up]: [f64; 3],
    (south, story): (&[String], &str),
) -> String {
    let at = |dx: f64, dy: f64, dz: f64| [x + dx * east, y + dy * north, z + dz * up];
    let mut faces = vec![
        face("Floor", &[at(0., 0., 0.), at(0., 1., 0.), at(0.5, 1., 0.), at(0.5, 0., 0.)], ""),
        face("Floor", &[at(0.5, 0., 0.), at(0.5, 1., 0.), at(1., 1., 0.), at(1., 0., 0.)], ""),
        face("RoofCeiling", &[at(0., 0., 1.), at(1., 0., 1.), at(1., 1., 1.), at(0., 1., 1.)], ""),
        face("Wall", &[at(1., 0., 0.), at(1., 1., 0.), at(1., 1., 1.), at(1., 0., 1.)], ""),
        face("Wall", &[at(1., 1., 0.), at(0., 1., 0.), at(0., 1., 1.), at(1., 1., 1.)], ""),
        face("Wall", &[at(0., 1., 0.), at(0., 0., 0.), at(0., 0., 1.), at(0., 1., 1.)], ""),
    ];
    faces.extend(south.iter().cloned());
    format!(
        r#"{{"type": "Room", "identifier": "{id}", {story} "faces": [{}], "properties": {{"type": "RoomPropertiesAbridged"}}}}"#,
        faces.join(", ")
    )
}

#[test]
fn floors_of_bodies_are_joined_and_holes_of_walls_are_where_they_are_drawn() {
    let south = face(
        "Wall",
        &[[0., 0., 1.], [4., 0., 1.], [4., 0., 4.], [0., 0., 4.]],
        r#", "boundary_condition": {"type": "Outdoors"},
            "doors": [{"identifier": "d", "geometry": {"boundary": [[1, 0, 1.1], [2, 0, 1.1], [2, 0, 3.1], [1, 0, 3.1]]}}],
            "apertures": [{"identifier": "w", "geometry": {"boundary": [[2.5, 0, 2], [3.5, 0, 2], [3.5, 0, 3.5], [2.5, 0, 3.5]]}}]"#,
    );
    let room = block("Living", [0., 0., 1.], [4., 5., 3.], (&[south], ""));
    let (drafts, faults) = drafts(&format!(r#"{{"type": "Model", "rooms": [{room}]}}"#));
    assert!(faults.is_empty(), "{faults}");
    assert_eq!((drafts[0].elevation, drafts[0].name.as_str()), (1.0, "Level 1"));
    let level = &levels(drafts)[0];
    assert_eq!((level.rooms[0].region.area(), level.rooms[0].height), (20.0, 3.0));
    let found: Vec<(&str, OpeningKind, f64, f64, f64)> = level
        .openings
        .iter()
        .map(|opening| (opening.id.as_str(), opening.kind, opening.center.x, opening.bottom, opening.top))
        .collect();
    let expected = [("w", OpeningKind::Window, 3.0, 1.0, 2.5), ("d", OpeningKind::Door, 1.5, 0.0, 2.1)];
    let mut found = found;
    found.sort_by(|one, two| two.0.cmp(one.0));
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!((found.0, found.1), (expected.0, expected.1));
        let misfit = [found.2 - expected.2, found.3 - expected.3, found.4 - expected.4];
        assert!(misfit.iter().all(|misfit| misfit.abs() < 1e-9), "{found:?}");
    }
}

#[test]
fn storeys_are_told_apart_by_name_or_by_height() {
    let size = [3., 3., 2.8];
    let at = |id: &str, z: f64, story: &str| block(id, [0., 0., z], size, (&[], story));
    let rooms = [
        at("a", 0., r#""story": "Ground","#),
        at("b", 3., r#""story": null,"#),
        at("c", 3.2, ""),
        at("d", 6., ""),
        at("e", 0.3, ""),
    ];
    let (drafts, _) = drafts(&format!(r#"{{"type": "Model", "rooms": [{}]}}"#, rooms.join(", ")));
    let found: Vec<(&str, Vec<&str>)> = drafts
        .iter()
        .map(|level| (level.id.as_str(), level.rooms.iter().map(|room| room.id.as_str()).collect()))
        .collect();
    let expected = [("ground", vec!["a", "e"]), ("level_2", vec!["b", "c"]), ("level_3", vec!["d"])];
    assert_eq!(found, expected);
    assert_eq!(drafts[0].height, 3.0);
}

#[test]
fn windows_that_both_rooms_draw_in_a_thick_wall_are_one() {
    let west = r#""window_parameters": [null, {"type": "DetailedWindows",
        "polygons": [[[0.5, 1], [1.5, 1], [1.5, 2], [0.5, 2]]]}, null, null]"#;
    let east = r#""window_parameters": [null, null, null, {"type": "DetailedWindows",
        "polygons": [[[1.5, 1], [2.5, 1], [2.5, 2], [1.5, 2]]]}]"#;
    let text = story("", [west, east], "")
        .replace("[[4, 0], [8, 0], [8, 3], [4, 3]]", "[[4.3, 0], [8, 0], [8, 3], [4.3, 3]]");
    let (drafts, _) = drafts(&text);
    assert_eq!(drafts[0].openings.len(), 1);
    assert_eq!(between(&levels(drafts)[0], "Kitchen_1", "Bedroom_2").len(), 1);
}

#[test]
fn plenums_are_left_out_and_slopes_are_flat() {
    let named = |text: String, name: &str| {
        text.replace(r#""story""#, &format!(r#""display_name": "{name}", "story""#))
    };
    let plenum = named(block("p", [0., 0., 3.], [4., 4., 1.], (&[], r#""story": null,"#)), "Plenum 1");
    let (none, faults) = drafts(&format!(r#"{{"type": "Model", "rooms": [{plenum}]}}"#));
    assert!(none.is_empty() && faults.has_errors());
    assert_eq!(messages(&faults).len(), 2, "{faults}");
    let roof = face("RoofCeiling", &[[0., 0., 3.], [4., 0., 3.], [4., 4., 5.], [0., 4., 5.]], "");
    let room = block("r", [0., 0., 0.], [4., 4., 3.], (&[roof], ""));
    let (drafts, faults) = drafts(&format!(r#"{{"type": "Model", "rooms": [{plenum}, {room}]}}"#));
    assert_eq!((drafts.len(), drafts[0].rooms.len(), drafts[0].rooms[0].height), (1, 1, Some(3.0)));
    let told = messages(&faults);
    assert!(told.iter().any(|told| told.starts_with("1 plenum left out")), "{faults}");
    assert!(told.iter().any(|told| told.starts_with("1 room with a sloping")), "{faults}");
}
