//! The tileset leads to every level, from outside in.

use serde_json::Value;

use super::tileset::files;
use crate::output::{IndexOptions, IndexedLevel};
use crate::plan::{EarthPlace, SiteOrigin};
use crate::scene::LevelBounds;

fn level(building: &str, level: &str, place: [f64; 2], elevation: f64) -> IndexedLevel {
    let path = |detail: &str| format!("{building}/{level}.{detail}.glb");
    IndexedLevel {
        building: building.to_owned(),
        level: level.to_owned(),
        position: place,
        turn: 0.3,
        bounds: Some(LevelBounds {
            elevation,
            low: [0.0, 0.0, elevation],
            high: [10.0, 8.0, elevation + 3.0],
        }),
        attribution: None,
        paths: ["full", "reduced", "boxes"].map(path).to_vec(),
    }
}

/// A town of so many towers of so many levels.
fn town(towers: usize, levels: usize) -> Vec<IndexedLevel> {
    let tower = |tower: usize| {
        let place = [tower as f64 % 10.0 * 40.0, (tower / 10) as f64 * 40.0];
        (0..levels)
            .map(move |floor| level(&format!("t{tower:03}"), &format!("{floor}"), place, floor as f64 * 3.0))
    };
    (0..towers).flat_map(tower).collect()
}

fn parsed(levels: &[IndexedLevel], options: &IndexOptions) -> Vec<(String, Value)> {
    let parsed = files(levels, options).into_iter();
    parsed.map(|(path, bytes)| (path, serde_json::from_slice(&bytes).unwrap())).collect()
}

/// Walks a tree: errors fall, and the contents that are found, with the file that each is named in.
fn contents(tile: &Value, found: &mut Vec<String>) {
    if let Some(uri) = tile.pointer("/content/uri") {
        found.push(uri.as_str().unwrap().to_owned());
    }
    let error = tile["geometricError"].as_f64().unwrap();
    for child in tile["children"].as_array().into_iter().flatten() {
        assert!(child["geometricError"].as_f64().unwrap() < error, "{child}");
        contents(child, found);
    }
}

#[test]
fn the_first_file_names_each_source_that_asks_for_it_once() {
    let mut levels = town(30, 20);
    let asset = |levels: &[IndexedLevel]| {
        let files = parsed(levels, &IndexOptions::default());
        files.into_iter().map(|(_, mut file)| file["asset"].take()).collect::<Vec<Value>>()
    };
    assert!(asset(&levels).iter().all(|asset| asset["extras"]["attributions"].is_null()));
    for (number, level) in levels.iter_mut().enumerate() {
        level.attribution = Some(format!("© source {}", number % 2));
    }
    let told = asset(&levels);
    assert_eq!(told[0]["extras"]["attributions"], serde_json::json!(["© source 0", "© source 1"]));
    assert!(told.len() > 1 && told[1..].iter().all(|asset| asset["extras"]["attributions"].is_null()));
}

#[test]
fn every_detail_of_every_level_is_reached_once() {
    for (towers, levels) in [(1, 2), (3, 80), (30, 100)] {
        let levels = town(towers, levels);
        let files = parsed(&levels, &IndexOptions::default());
        assert_eq!(files[0].0, "tileset.json");
        let mut reached = Vec::new();
        let mut open = vec![("".to_owned(), "tileset.json".to_owned())];
        while let Some((folder, name)) = open.pop() {
            let path = format!("{folder}{name}");
            let (_, json) =
                files.iter().find(|(known, _)| *known == path).expect("a file that is named is there");
            let mut found = Vec::new();
            contents(&json["root"], &mut found);
            for uri in found {
                let whole = uri.strip_prefix("../").map_or_else(|| format!("{folder}{uri}"), str::to_owned);
                match whole.rsplit_once('/').filter(|_| whole.ends_with(".json")) {
                    Some((folder, name)) => open.push((format!("{folder}/"), name.to_owned())),
                    None => reached.push(whole),
                }
            }
        }
        let mut expected: Vec<String> = levels.iter().flat_map(|level| level.paths.clone()).collect();
        reached.sort();
        expected.sort();
        assert_eq!(reached, expected);
        let largest = files.iter().map(|(_, json)| json.to_string().len()).max().unwrap();
        assert!(largest < 400_000, "{largest} bytes in one file");
    }
}

#[test]
fn boxes_hold_what_is_in_them() {
    let [(_, json), ..] = &parsed(&town(5, 3), &IndexOptions::default())[..] else { panic!("no file") };
    let root = &json["root"];
    let number = |tile: &Value, index: usize| tile["boundingVolume"]["box"][index].as_f64().unwrap();
    for building in root["children"].as_array().unwrap() {
        for level in building["children"].as_array().unwrap() {
            let rise = level["transform"][14].as_f64().unwrap();
            assert!(
                number(level, 2) + number(level, 11) + rise
                    <= number(building, 2) + number(building, 11) + 1e-3
            );
            assert!((number(level, 3) - number(building, 3)).abs() < 1e-3);
        }
        let [x, y] = [12, 13].map(|index| building["transform"][index].as_f64().unwrap());
        assert!((x - number(root, 0)).abs() < number(root, 3) + 1e-3);
        assert!((y - number(root, 1)).abs() < number(root, 7) + 1e-3);
    }
}

#[test]
fn an_origin_moves_the_root_and_nothing_else_of_one_building() {
    let place = EarthPlace::Degrees(crate::geometry::Point::new(13.41, 52.53));
    let origin = Some(SiteOrigin { place, height: 40.0, heading: 0.0 });
    let one = &parsed(&town(1, 2), &IndexOptions::default())[0].1["root"];
    let other = &parsed(&town(1, 2), &IndexOptions { origin, ..IndexOptions::default() })[0].1["root"];
    assert!(one.get("transform").is_none() && other["transform"][12].as_f64().unwrap() > 3e6);
    let volume = |root: &Value| root["boundingVolume"]["box"].as_array().unwrap().clone();
    for (here, there) in volume(one).iter().zip(volume(other)) {
        assert!((here.as_f64().unwrap() - there.as_f64().unwrap()).abs() < 2e-3, "{here} {there}");
    }
}

#[test]
fn distances_become_errors() {
    let near = |boxes| IndexOptions { near: [boxes, 10.0, 5.0], ..IndexOptions::default() };
    let [near, far] = [near(100.0), near(300.0)].map(|options| {
        parsed(&town(1, 1), &options)[0]
            .1
            .pointer("/root/children/0/children/0/geometricError")
            .unwrap()
            .as_f64()
            .unwrap()
    });
    assert!((far / near - 3.0).abs() < 1e-3, "{near} {far}");
}

#[test]
fn a_site_without_levels_is_a_tileset() {
    let files = parsed(&[], &IndexOptions::default());
    assert_eq!(files.len(), 1);
    assert_eq!(files[0].1["root"]["geometricError"], 0);
}
