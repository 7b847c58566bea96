//! Small cities in CityJSON.

use super::*;

/// A box of 10 × 8 × 6 m at a corner, as the boundaries of a solid with its bottom first; six faces, ten numbers each.
const FACES: &str = "[[[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]]]";
const VERTICES: &str = "[[0,0,0],[10000,0,0],[10000,8000,0],[0,8000,0],[0,0,6000],[10000,0,6000],[10000,8000,6000],[0,8000,6000]]";

fn city(objects: &str) -> String {
    format!(
        r#"{{"type": "CityJSON", "version": "2.0", "transform": {{"scale": [0.001, 0.001, 0.001], "translate": [84600, 447400, 2]}},
            "metadata": {{"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"}},
            "CityObjects": {{{objects}}}, "vertices": {VERTICES}}}"#
    )
}

fn solid(more: &str) -> String {
    format!(r#""geometry": [{{"type": "Solid", "lod": 1, "boundaries": {FACES}{more}}}]"#)
}

#[test]
fn a_building_stands_on_its_lowest_faces() {
    let text = city(&format!(
        r#""a": {{"type": "Building", "attributes": {{"storeysAboveGround": 2, "function": "school"}}, {}}},
           "r": {{"type": "Road", "geometry": []}}"#,
        solid("")
    ));
    let read = read("a.city.json", text).unwrap();
    assert_eq!(ids(&read), ["a"]);
    let building = &read.site.footprints[0];
    assert!((building.region.area() - 80.0).abs() < 1e-6);
    assert_eq!(building.storeys.above_ground, Some(2.0));
    assert_eq!(building.storeys.height, Some(6.0));
    assert_eq!(building.uses, [("function".to_owned(), "school".to_owned())]);
    assert_eq!(read.site.origin.position, [85_000.0, 447_000.0]);
    assert_eq!(read.site.reference_system.as_deref(), Some("EPSG:7415"));
    assert_eq!(read.notes.no_buildings.values().sum::<usize>(), 1);
}

#[test]
fn what_is_null_is_not_there() {
    let text = city(&format!(
        r#""a": {{"type": "Building", "attributes": null, "parents": null, "children": null, {}}}"#,
        solid(r#", "semantics": null"#)
    ));
    let metadata = r#"{"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"}"#;
    assert!(text.contains(metadata));
    let read = read("a.json", text.replace(metadata, "null")).unwrap();
    assert!((read.site.footprints[0].region.area() - 80.0).abs() < 1e-6);
    assert_eq!(read.site.reference_system, None);
}

#[test]
fn the_faces_that_are_called_ground_come_first() {
    let semantics = r#", "semantics": {"surfaces": [{"type": "WallSurface"}, {"type": "GroundSurface"}], "values": [[0, 1, 0, null, 0, 0]]}"#;
    let read =
        read("a.json", city(&format!(r#""a": {{"type": "Building", {}}}"#, solid(semantics)))).unwrap();
    assert!((read.site.footprints[0].region.area() - 80.0).abs() < 1e-6);
}

#[test]
fn a_solid_without_a_bottom_is_seen_from_above() {
    let roof = r#""geometry": [{"type": "MultiSurface", "lod": "1", "boundaries": [[[4,5,6]],[[4,6,7]],[[0,1,5,4]]]}]"#;
    let read = read("a.json", city(&format!(r#""a": {{"type": "Building", {roof}}}"#))).unwrap();
    assert!((read.site.footprints[0].region.area() - 80.0).abs() < 1e-6);
}

#[test]
fn the_parts_of_a_building_without_geometry_make_it() {
    let objects = format!(
        r#""a": {{"type": "Building", "attributes": {{"name": "Hall"}}, "children": ["p"]}},
           "p": {{"type": "BuildingPart", "parents": ["a"], "attributes": {{"storeysAboveGround": 3}}, {}}}"#,
        solid("")
    );
    let read = read("a.json", city(&objects)).unwrap();
    assert_eq!(ids(&read), ["a"]);
    let building = &read.site.footprints[0];
    assert_eq!((building.name.as_deref(), building.parts.len()), (Some("Hall"), 1));
    assert_eq!(building.storeys.above_ground, Some(3.0));
    assert_accounted(&read);
}

#[test]
fn the_rings_among_the_attributes_are_the_last_resort() {
    let attributes = r#""attributes": {"footprint": [[[84600, 447400], [84610, 447400], [84610, 447405], [84600, 447405], [84600, 447400]]]}"#;
    let read = read("a.json", city(&format!(r#""a": {{"type": "Building", {attributes}}}"#))).unwrap();
    assert!((read.site.footprints[0].region.area() - 50.0).abs() < 1e-6);
}

#[test]
fn damaged_objects_are_left_out() {
    let good = format!(r#""good": {{"type": "Building", {}}}"#, solid(""));
    for bad in [
        r#"{"type": "Building"}"#.to_owned(),
        r#"{"type": "Building", "geometry": [{"type": "Solid", "lod": 1, "boundaries": [[[[0,1,99999]]]]}]}"#
            .to_owned(),
        r#"{"type": "Building", "geometry": [{"type": "Solid", "lod": 1, "boundaries": 7}]}"#.to_owned(),
        r#"{"type": "Building", "geometry": [{"type": "Solid", "boundaries": [[[[0,1,-2]]]]}]}"#.to_owned(),
        r#"{"type": "Building", "geometry": 7}"#.to_owned(),
        r#"{"type": "BuildingPart", "parents": ["none"]}"#.to_owned(),
        r#"{"type": "Building", "attributes": {"footprint": [[[1]]]}}"#.to_owned(),
        "7".to_owned(),
    ] {
        let read = read("a.json", city(&format!(r#"{good}, "bad": {bad}"#))).unwrap();
        assert_eq!(ids(&read), ["good"], "{bad}");
        assert_eq!(read.notes.left_out.len(), 1, "{bad}");
        assert_accounted(&read);
    }
}

#[test]
fn broken_cities_are_faults() {
    let cases = [
        (r#"{"type": "CityJSON", "CityObjects": {}, "vertices": []}"#, "has no objects"),
        (
            r#"{"type": "CityJSON", "CityObjects": {"a": {"type": "Road"}}, "vertices": []}"#,
            "objects of other kinds (1)",
        ),
        (r#"{"type": "CityJSON", "CityObjects": {"a": "#, "EOF while parsing"),
        (r#"{"type": "CityJSON", "CityObjects": [], "vertices": []}"#, "invalid type"),
        (r#"{"type": "CityJSON", "CityObjects": {}, "vertices": [[1e999, 0, 0]]}"#, "number out of range"),
    ];
    for (text, message) in cases {
        let faults = read("a.json", text).unwrap_err();
        assert!(faults.to_string().contains(message), "{text}\n{faults}");
    }
}

#[test]
fn faces_that_are_heaped_upon_each_other_are_no_outline() {
    let vertices: Vec<String> = (0..400)
        .flat_map(|face| [[0, face, 0], [20_000, 10 * face, 0], [10_000 + 10 * face, 9_000, 0]])
        .map(|vertex| format!("{vertex:?}"))
        .collect();
    let faces: Vec<String> =
        (0..400).map(|face| format!("[[{},{},{}]]", 3 * face, 3 * face + 1, 3 * face + 2)).collect();
    let heap = format!(
        r#""geometry": [{{"type": "MultiSurface", "lod": "0", "boundaries": [{}]}}]"#,
        faces.join(",")
    );
    let text = city(&format!(r#""a": {{"type": "Building", {heap}}}"#))
        .replace(VERTICES, &format!("[{}]", vertices.join(",")));
    let faults = read("a.json", text).unwrap_err();
    assert!(faults.to_string().contains("building \"a\" is left out: it has no outline"), "{faults}");
}

#[test]
fn an_object_with_more_text_than_any_building_is_left_out() {
    let padding = " ".repeat(17 << 20);
    let objects = format!(
        r#""a": {{"type": "Building", {padding} {}}}, "b": {{"type": "Building", {}}}"#,
        solid(""),
        solid("")
    );
    let read = read("a.json", city(&objects)).unwrap();
    assert_eq!(ids(&read), ["b"]);
    assert_eq!(read.notes.left_out[0].reason, "its text has 17 MB, 16 are the most");
}
