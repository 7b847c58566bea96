//! Small maps in GeoJSON.

use super::*;
use crate::geometry::Point;
use crate::plan::read::footprint::{FootprintFormat, recognises};

/// A feature with properties and a square of so many degrees.
fn square(id: &str, properties: &str, at: (f64, f64), side: f64) -> String {
    let (x, y) = at;
    let (far_x, far_y) = (x + side, y + side);
    format!(
        r#"{{"type": "Feature", {id}"properties": {properties}, "geometry": {{"type": "Polygon", "coordinates":
            [[[{x}, {y}], [{far_x}, {y}], [{far_x}, {far_y}], [{x}, {far_y}], [{x}, {y}]]]}}}}"#
    )
}

fn collection(features: &[String]) -> String {
    format!(r#"{{"type": "FeatureCollection", "features": [{}]}}"#, features.join(",\n"))
}

const SIDE: f64 = 0.0001;

#[test]
fn outlines_without_anything_else_are_buildings() {
    let features = [square("", "{}", (5.12, 52.1), SIDE), square("", "null", (5.121, 52.1), SIDE)];
    let read = read("a.geojson", collection(&features)).unwrap();
    assert_eq!(ids(&read), ["at_52.100050_5.120050", "at_52.100050_5.121050"]);
    assert_eq!(read.site.reference_system.as_deref(), Some("EPSG:4326"));
    assert_eq!(read.site.origin.position, [5.12, 52.1]);
    let area = read.site.footprints[0].region.area();
    assert!((area - 6.85 * 11.13).abs() < 0.3, "{area}");
    assert_accounted(&read);
}

#[test]
fn the_order_of_features_does_not_show() {
    let mut features = vec![
        square(r#""id": "w1", "#, r#"{"height": 4}"#, (5.12, 52.1), SIDE),
        square(r#""id": "w1", "#, r#"{"height": 4, "levels": 2}"#, (5.12, 52.1), SIDE),
        square(r#""id": 7, "#, r#"{"levels": "x"}"#, (5.1201, 52.1), SIDE),
        square(r#""id": 7, "#, r#"{"num_floors": 3}"#, (5.1204, 52.1), SIDE),
        square("", r#"{"buildingPart": true, "minLevel": 2}"#, (5.12002, 52.10002), SIDE / 3.0),
    ];
    let one = read("a.geojson", collection(&features)).unwrap();
    assert_eq!(ids(&one), ["7", "7-2", "w1"]);
    assert_eq!(one.notes.duplicates.len(), 1);
    assert_eq!(one.notes.parts.len(), 1);
    assert_eq!(one.notes.unreadable[0].value, "x");
    assert_eq!(one.site.footprints[2].storeys.above_ground, Some(2.0));
    features.reverse();
    let other = read("a.geojson", collection(&features)).unwrap();
    assert_eq!(shown(&one.site.footprints), shown(&other.site.footprints));
    assert_eq!(one.notes, other.notes);
}

#[test]
fn features_on_lines_are_buildings_with_and_without_record_separators() {
    let features = [square("", "{}", (5.12, 52.1), SIDE), square("", "null", (5.121, 52.1), SIDE)];
    let line = |before: &str| -> String {
        features.iter().map(|feature| format!("{before}{}\n", feature.replace('\n', " "))).collect()
    };
    for before in ["", "\u{1e}"] {
        let read = read("a.geojsonl", line(before)).unwrap();
        assert_eq!(ids(&read), ["at_52.100050_5.120050", "at_52.100050_5.121050"]);
    }
}

#[test]
fn buildings_on_the_map_of_the_web_are_as_large_as_on_the_ground() {
    // 12 m by 10 m at 47.37° north, where a metre of the ground is 1.477 of the map.
    let feature = r#"{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
        [[[951000, 6003000], [951017.72, 6003000], [951017.72, 6003014.77], [951000, 6003014.77]]]}}"#;
    for crs in ["urn:ogc:def:crs:EPSG::3857", "EPSG:900913", "ESRI:102100"] {
        let crs = format!(r#""crs": {{"type": "name", "properties": {{"name": "{crs}"}}}}"#);
        let text = format!(r#"{{"type": "FeatureCollection", {crs}, "features": [{feature}]}}"#);
        let found = read("a.geojson", text).unwrap();
        let size = found.site.footprints[0].region.outline.bounds().size();
        assert!((size - Point::new(12.0, 10.0)).abs().max_element() < 0.05, "{size}");
        assert_eq!(found.site.reference_system.as_deref(), Some("EPSG:4326"));
        assert_eq!(found.notes.assumed, Vec::<String>::new());
    }
}

#[test]
fn lengths_of_a_reference_system_that_is_not_known_are_metres_with_a_warning() {
    let feature = r#"{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
        [[[5000, 5000], [5010, 5000], [5010, 5010], [5000, 5010]]]}}"#;
    for crs in ["EPSG:22263", "urn:local:site-grid"] {
        let text = format!(
            r#"{{"type": "FeatureCollection", "crs": {{"properties": {{"name": "{crs}"}}}}, "features": [{feature}]}}"#
        );
        let found = read("a.geojson", text).unwrap();
        assert_eq!(found.notes.assumed, [format!("{crs} is not known: its lengths are taken as metres")]);
        assert!((found.site.footprints[0].region.area() - 100.0).abs() < 1e-6);
    }
}

#[test]
fn metres_are_read_with_their_reference_system_and_refused_without() {
    let feature = r#"{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
        [[[-8210.5, -34520], [-8200.5, -34520], [-8200.5, -34510], [-8210.5, -34510]]]}}"#;
    let crs = r#""crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::6677"}},"#;
    let with_crs = |crs: &str| format!(r#"{{"type": "FeatureCollection", {crs} "features": [{feature}]}}"#);
    let found = read("a.geojson", with_crs(crs)).unwrap();
    assert_eq!(found.site.reference_system.as_deref(), Some("EPSG:6677"));
    assert_eq!(found.site.origin.position, [-8000.0, -35000.0]);
    assert_eq!(found.site.footprints[0].region.outline.corners()[0].to_array(), [-210.5, 480.0]);
    let faults = read("a.geojson", with_crs("")).unwrap_err();
    assert!(faults.to_string().contains("no degrees of longitude and latitude"), "{faults}");
}

#[test]
fn feet_become_metres() {
    // 100 feet by 50 in Manhattan, on the state plane of Long Island.
    let text = r#"{"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:2263"}}, "features": [
        {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
        [[[988000, 212000], [988100, 212000], [988100, 212050], [988000, 212050]]]}}]}"#;
    let found = read("a.geojson", text).unwrap();
    assert!(found.faults.is_empty(), "{}", found.faults);
    let origin = found.site.origin;
    assert_eq!((origin.position, origin.is_in_feet), ([988_000.0, 212_000.0], true));
    let size = found.site.footprints[0].region.outline.bounds().size();
    assert!((size - Point::new(30.48, 15.24)).abs().max_element() < 1e-3, "{size}");
}

#[test]
fn areas_of_several_pieces_are_several_buildings_and_those_that_touch_are_one() {
    let area = |pieces: &[&str]| {
        let pieces = pieces.join(",");
        format!(
            r#"{{"type": "Feature", "id": "way/5", "properties": {{"building": "yes"}}, "geometry": {{"type": "MultiPolygon", "coordinates": [{pieces}]}}}}"#
        )
    };
    let left = "[[[5.0, 52.0], [5.0001, 52.0], [5.0001, 52.0001], [5.0, 52.0001]]]";
    let right = "[[[5.0001, 52.0], [5.0002, 52.0], [5.0002, 52.0001], [5.0001, 52.0001]]]";
    let far = "[[[5.001, 52.0], [5.0012, 52.0], [5.0012, 52.0001], [5.001, 52.0001]]]";
    let one = read("a.geojson", collection(&[area(&[left, right])])).unwrap();
    assert_eq!(ids(&one), ["w5"]);
    let two = read("a.geojson", collection(&[area(&[left, far])])).unwrap();
    assert_eq!(ids(&two), ["w5-1", "w5-2"]);
    assert!(two.site.footprints[0].region.area() > two.site.footprints[1].region.area());
    assert_accounted(&two);
}

#[test]
fn marked_buildings_are_told_from_other_areas_and_streets_and_doors_are_read() {
    let features = [
        square(r#""id": "way/1", "#, r#"{"building": "school", "building:levels": "4;5"}"#, (5.12, 52.1), SIDE),
        square("", r#"{"landuse": "forest"}"#, (5.13, 52.1), SIDE),
        square("", r#"{"height": 5}"#, (5.14, 52.1), SIDE),
        r#"{"type": "Feature", "properties": {"highway": "residential"}, "geometry": {"type": "LineString", "coordinates": [[5.12, 52.0999], [5.121, 52.0999]]}}"#.to_owned(),
        r#"{"type": "Feature", "properties": {"highway": "footway"}, "geometry": {"type": "LineString", "coordinates": [[5.12, 52.0999], [5.121, 52.0999]]}}"#.to_owned(),
        r#"{"type": "Feature", "properties": {"entrance": "main"}, "geometry": {"type": "Point", "coordinates": [5.12005, 52.1]}}"#.to_owned(),
        r#"{"type": "Feature", "properties": {}, "geometry": null}"#.to_owned(),
    ];
    let read = read("a.geojson", collection(&features)).unwrap();
    assert_eq!(ids(&read), ["w1"]);
    let school = &read.site.footprints[0];
    assert_eq!(school.storeys.above_ground, Some(5.0));
    assert_eq!(school.uses, [("building".to_owned(), "school".to_owned())]);
    assert_eq!(school.entrances.len(), 1);
    assert_eq!(read.site.streets.len(), 1);
    assert_eq!(read.notes.no_buildings.values().sum::<usize>(), 4, "{:?}", read.notes.no_buildings);
}

#[test]
fn one_bad_feature_costs_no_other() {
    let bad = |coordinates: &str| {
        format!(
            r#"{{"type": "Feature", "id": "bad", "properties": {{}}, "geometry": {{"type": "Polygon", "coordinates": {coordinates}}}}}"#
        )
    };
    for coordinates in [
        "[]",
        "[[]]",
        "[[[5,52]]]",
        "[[[5,52],[5,52],[5,52],[5,52]]]",
        "[[[5,null]]]",
        "[[[1e300,52],[5,1e300],[5,52]]]",
        "[[[5,52],[5.1,52],[5.1,52.1],[5,52.1]]]",
        "{}",
        "[[[5,52],[5.0001,52],[5.0002,52]]]",
    ] {
        let features = [bad(coordinates), square(r#""id": "good", "#, "{}", (5.0, 52.0), SIDE)];
        let read = read("a.geojson", collection(&features)).unwrap();
        assert_eq!(ids(&read), ["good"], "{coordinates}");
        assert_accounted(&read);
    }
}

#[test]
fn files_without_buildings_and_broken_files_are_faults() {
    let cases = [
        (r#"{"type": "FeatureCollection", "features": []}"#, "holds no building"),
        (
            r#"{"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]}, "properties": {}}]}"#,
            "holds no building: points (1)",
        ),
        (r#"{"type": "FeatureCollection", "features": [{"type": "Fea"#, "EOF while parsing a string"),
        (r#"{"type": "FeatureCollection", "features": 7}"#, "invalid type"),
        (r#"{"type": "FeatureCollection", "features": [NaN]}"#, "expected value"),
        (r#"{"type": "Topology", "objects": {}}"#, "is no map of building footprints"),
    ];
    for (text, message) in cases {
        let faults = read("a.geojson", text).unwrap_err();
        assert!(faults.to_string().contains(message), "{text}\n{faults}");
    }
}

#[test]
fn features_on_lines_of_their_own_are_read() {
    let lines = [square("", "{}", (5.12, 52.1), SIDE), square("", "{}", (5.13, 52.1), SIDE)].join("\n");
    assert_eq!(read("a.geojsonl", lines).unwrap().site.footprints.len(), 2);
}

#[test]
fn maps_of_rooms_are_no_maps_of_footprints() {
    let cases = [
        (square("", r#"{"building": "yes"}"#, (5.0, 52.0), SIDE), true),
        (square("", r#"{"building": "yes", "indoor": "yes"}"#, (5.0, 52.0), SIDE), true),
        (square(r#""feature_type": "unit", "#, "{}", (5.0, 52.0), SIDE), false),
        (square("", r#"{"floor_id": 3}"#, (5.0, 52.0), SIDE), false),
    ];
    for (feature, is_footprints) in cases {
        let (_folder, path) = file("a.geojson", collection(std::slice::from_ref(&feature)));
        assert_eq!(recognises(&path), is_footprints.then_some(FootprintFormat::GeoJson), "{feature}");
    }
}
