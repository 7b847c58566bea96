//! Counts and guarantees on the shared maps, and a small map of our own with one property at a time.

use std::collections::BTreeSet;

use super::{read, recognises};
use crate::plan::read::reader::ReadBuildings;
use crate::plan::read::real_data::{assert_comes_back, folder, words};
use crate::plan::{LevelDraft, OpeningKind, assemble_level};

fn faculty(name: &str) -> Option<ReadBuildings> {
    let path = folder("osm-indoor")?.join(name);
    Some(read(&path, &words()).unwrap_or_else(|faults| panic!("{faults}")))
}

fn levels(read: &ReadBuildings) -> impl Iterator<Item = &LevelDraft> {
    read.buildings.iter().flat_map(|building| &building.draft.levels)
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_faculty_is_the_same_plan_from_xml_and_from_geojson() {
    let (Some(xml), Some(geojson)) = (faculty("APBorig.osm"), faculty("apb.geojson")) else { return };
    assert_eq!(xml.buildings.len(), 1);
    assert_eq!(xml.buildings[0].id, "andreas_pfitzmann_bau");
    let text = |read: &ReadBuildings| format!("{:#?}\n{:?}", read.buildings, read.origin);
    assert!(text(&xml) == text(&geojson), "the plans differ");
    let warnings = |read: &ReadBuildings| -> Vec<String> {
        read.faults.0.iter().map(|fault| fault.message.clone()).collect()
    };
    let sorted = |mut texts: Vec<String>| {
        texts.sort();
        texts
    };
    assert_eq!(sorted(warnings(&xml)), sorted(warnings(&geojson)));
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_faculty_has_the_counts_of_its_source() {
    let Some(read) = faculty("APBorig.osm") else { return };
    assert!(!read.faults.has_errors(), "{}", read.faults);
    let spaces: BTreeSet<&str> =
        levels(&read).flat_map(|level| &level.rooms).map(|room| room.id.as_str()).collect();
    assert_eq!(spaces.len(), 446);
    let doors: BTreeSet<&str> =
        levels(&read).flat_map(|level| &level.openings).map(|opening| opening.id.as_str()).collect();
    assert_eq!(doors.iter().filter(|id| id.starts_with('n')).count(), doors.len());
    let mut joined = BTreeSet::new();
    let (mut drawn_count, mut placed_count) = (0, 0);
    for draft in levels(&read) {
        let (drawn, rooms) = (draft.openings.len(), draft.rooms.len());
        let (level, problems) = assemble_level(draft.clone());
        let told: Vec<&str> = problems.iter().map(|problem| problem.message.as_str()).collect();
        assert_eq!(level.rooms.len(), rooms, "{}: {told:#?}", level.id);
        let two = level.openings.iter().filter(|opening| opening.sides.len() == 2);
        joined.extend(two.map(|opening| opening.id.clone()));
        drawn_count += drawn;
        placed_count += level.openings.len();
    }
    println!(
        "{} of 502 doors join two rooms; {placed_count} of {drawn_count} openings attached",
        joined.len()
    );
    assert!(joined.len() >= 465, "{} doors join two rooms", joined.len());
    assert!(placed_count * 100 >= 99 * drawn_count, "{placed_count} of {drawn_count} openings");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_station_is_read_although_it_has_no_doors() {
    let Some(read) = faculty("gare-de-l-est.geojson") else { return };
    assert!(!read.faults.has_errors(), "{}", read.faults);
    let ids: Vec<(&str, usize)> = levels(&read).map(|level| (level.id.as_str(), level.rooms.len())).collect();
    assert_eq!(ids.iter().map(|(_, rooms)| rooms).sum::<usize>(), 116, "{ids:?}");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_maps_are_the_same_as_native_plans() {
    let Some(folder) = folder("osm-indoor") else { return };
    for name in ["APBorig.osm", "gare-de-l-est.geojson"] {
        assert_comes_back(&folder.join(name));
    }
}

/// A flat of two rooms with a door between, an entrance, a bin and a lift through two levels, in XML.
const FLAT: &str = include_str!("../../../../../tests/cases/plan_import/indoor_xml/flat.osm");

/// What is read of the flat with some text replaced.
fn broken(from: &str, to: &str) -> Result<ReadBuildings, String> {
    assert!(FLAT.contains(from), "the map has no {from}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flat.osm");
    std::fs::write(&path, FLAT.replacen(from, to, 1)).unwrap();
    read(&path, &words()).map_err(|faults| faults.to_string())
}

fn messages(read: &ReadBuildings) -> String {
    read.faults.0.iter().map(|fault| format!("{}\n", fault.report())).collect()
}

#[test]
fn doors_join_rooms_and_lifts_are_on_all_of_their_levels() {
    let read = broken("Flat", "Flat").unwrap();
    let counts: Vec<(&str, usize, usize)> =
        levels(&read).map(|level| (level.id.as_str(), level.rooms.len(), level.openings.len())).collect();
    assert_eq!(counts, [("level_0", 3, 2), ("level_1", 1, 0)]);
    assert_eq!(read.buildings[0].id, "flat");
    let (level, problems) = assemble_level(read.buildings[0].draft.levels[0].clone());
    assert!(!problems.iter().any(|problem| problem.is_error), "{problems:?}");
    let joined: Vec<(usize, f64)> =
        level.openings.iter().map(|opening| (opening.sides.len(), opening.width)).collect();
    assert!(joined.iter().any(|(sides, width)| *sides == 2 && (width - 0.9).abs() < 1e-6), "{joined:?}");
}

#[test]
fn words_of_doors_decide_what_closes_them() {
    for (word, kind) in
        [("hinged", OpeningKind::Door), ("sliding", OpeningKind::SlidingDoor), ("no", OpeningKind::Passage)]
    {
        let read = broken("v=\"hinged\"", &format!("v=\"{word}\"")).unwrap();
        let openings = &read.buildings[0].draft.levels[0].openings;
        let door = openings.iter().find(|opening| opening.id == "n9").expect("the door between the rooms");
        assert_eq!(door.kind, kind, "{word}");
    }
}

#[test]
fn faults_of_a_map_name_their_lines() {
    let told = |from: &str, to: &str| messages(&broken(from, to).unwrap());
    let line = |text: &str| {
        let at = FLAT.find(text).expect("the text");
        format!("flat.osm:{}:", FLAT[..at].matches('\n').count() + 1)
    };
    let level = told("k=\"level\" v=\"0-1\"", "k=\"level\" v=\"top\"");
    assert!(
        level.contains("level \"top\" is neither a number") && level.contains(&line("<way id=\"103\"")),
        "{level}"
    );
    let open = told("<nd ref=\"11\"/><nd ref=\"1\"/>", "<nd ref=\"11\"/>");
    assert!(open.contains("w101 is a room without a closed outline"), "{open}");
    let word = told("v=\"kitchen\"", "v=\"gizmo\"");
    assert!(word.contains("unknown room word \"gizmo\"") && word.contains("formats.osm"), "{word}");
    let missing = told("<node id=\"4\"", "<node id=\"44\"");
    assert!(missing.contains("has not all of its corners"), "{missing}");
}

#[test]
fn a_map_of_buildings_with_hardly_a_room_is_no_plan_of_rooms() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.osm");
    let of = |rooms: usize, buildings: usize| {
        let way = |key: &str, value: &str| format!("<way id='1'><tag k='{key}' v='{value}'/></way>\n");
        let text = way("indoor", "room").repeat(rooms) + &way("building", "yes").repeat(buildings);
        std::fs::write(&path, format!("<osm>\n{text}<way><tag k='indoor' v='yes'/></way></osm>")).unwrap();
        recognises(&path).is_some()
    };
    assert!(of(1, 0) && of(1, 100) && of(20, 5));
    assert!(!of(0, 3) && !of(1, 101));
}

/// A room and the corridor beside it with a door between, as features; `tagged` makes the properties of the tags of each.
fn features(tagged: &dyn Fn(serde_json::Value) -> serde_json::Value) -> Vec<serde_json::Value> {
    let (south, door_at, north) = (47.0, 47.00001, 47.00004);
    let (west, middle, east) = (7.0, 7.00005, 7.0001);
    let area = |ring: &[[f64; 2]]| serde_json::json!({"type": "Polygon", "coordinates": [ring]});
    let room =
        [[west, south], [middle, south], [middle, door_at], [middle, north], [west, north], [west, south]];
    let corridor =
        [[middle, south], [east, south], [east, north], [middle, north], [middle, door_at], [middle, south]];
    let feature = |geometry: serde_json::Value, tags: serde_json::Value| serde_json::json!({"type": "Feature", "geometry": geometry, "properties": tagged(tags)});
    let door = serde_json::json!({"type": "Point", "coordinates": [middle, door_at]});
    vec![
        feature(area(&room), serde_json::json!({"indoor": "room", "room": "office", "level": "1"})),
        feature(area(&corridor), serde_json::json!({"indoor": "corridor", "level": 1})),
        feature(door, serde_json::json!({"door": "hinged", "level": "1"})),
    ]
}

/// What is read of a text as a map in GeoJSON.
fn geojson(text: &str) -> ReadBuildings {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.geojson");
    std::fs::write(&path, text).unwrap();
    assert!(recognises(&path).is_some(), "{text}");
    read(&path, &words()).unwrap_or_else(|faults| panic!("{faults}"))
}

fn collection(features: &[serde_json::Value]) -> String {
    serde_json::json!({"type": "FeatureCollection", "features": features}).to_string()
}

#[test]
fn tags_are_read_wherever_an_export_has_them() {
    let text = |value: &serde_json::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let pairs = |tags: &serde_json::Value| -> Vec<String> {
        let tags = tags.as_object().expect("tags");
        tags.iter().map(|(key, value)| format!("\"{key}\"=>\"{}\"", text(value))).collect()
    };
    let lines = |features: Vec<serde_json::Value>, before: &str| -> String {
        features.iter().map(|feature| format!("{before}{feature}\n")).collect()
    };
    let maps = [
        collection(&features(&|tags| tags)),
        collection(&features(&|tags| serde_json::json!({"type": "way", "tags": tags, "meta": {}}))),
        collection(&features(
            &|tags| serde_json::json!({"osm_id": null, "other_tags": pairs(&tags).join(",")}),
        )),
        lines(features(&|tags| tags), ""),
        lines(features(&|tags| tags), "\u{1e}"),
    ];
    for map in maps {
        let read = geojson(&map);
        assert!(read.faults.is_empty(), "{map}: {}", read.faults);
        let found: Vec<_> = levels(&read)
            .map(|level| {
                (
                    level.id.as_str(),
                    level.rooms[0].room_type.as_str(),
                    level.rooms.len(),
                    level.openings.len(),
                )
            })
            .collect();
        assert_eq!(found, [("level_1", "office", 2, 1)], "{map}");
    }
}

#[test]
fn a_room_whose_geometry_is_none_of_an_area_is_told() {
    for geometry in [
        serde_json::json!(null),
        serde_json::json!({"type": "GeometryCollection", "geometries": []}),
        serde_json::json!({"type": "MultiLineString", "coordinates": [[[7, 47], [7.1, 47]]]}),
    ] {
        let mut features = features(&|tags| tags);
        features.push(serde_json::json!({"type": "Feature", "id": "r9", "geometry": geometry,
            "properties": {"indoor": "room", "level": "1"}}));
        let told = messages(&geojson(&collection(&features)));
        assert!(told.contains("r9 is a room without a closed outline"), "{told}");
        assert!(told.contains("features[3]"), "{told}");
    }
}
