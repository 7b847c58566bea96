//! The JSON of the tileset: quadtree, buildings, levels, details.

use std::collections::BTreeMap;

use glam::{DMat4, DVec3};
use serde_json::{Map, Value, json};

use super::near::errors;
use super::placement::Placer;
use super::quadtree::{Quarter, divide};
use super::volume::{Volume, transform};
use crate::output::{INDEX_FOLDER, INDEX_NAME, IndexFiles, IndexOptions, IndexedLevel};
use crate::scene::GENERATOR;

/// Files of the quadtree hold so many of its divisions.
const DIVISIONS_OF_FILE: usize = 3;
/// By how much the error of what holds others is at least larger than theirs.
const STEP: f64 = 2.0;
/// Endings of the files of a level, coarse ones first.
const DETAILS: [&str; 3] = [".boxes.glb", ".reduced.glb", ".full.glb"];

/// The files of the tileset of some levels, sorted by building and level; the one to open first.
pub(super) fn files(levels: &[IndexedLevel], options: &IndexOptions) -> IndexFiles {
    let placer = Placer::new(options.origin.as_ref());
    let errors = errors(options.near);
    let mut by_building: BTreeMap<&str, Vec<&IndexedLevel>> = BTreeMap::new();
    let shown = levels.iter().filter(|level| level.bounds.is_some());
    shown.for_each(|level| by_building.entry(&level.building).or_default().push(level));
    let buildings: Vec<BuildingTile> =
        by_building.into_iter().map(|(id, levels)| BuildingTile::new(id, &levels, &placer, errors)).collect();
    let mut writer = Writer { buildings, files: Vec::new() };
    let site: Vec<([f64; 2], usize)> =
        writer.buildings.iter().map(|building| (building.volume.middle(), building.level_count)).collect();
    let top = match writer.buildings.is_empty() {
        true => Tile::nothing(),
        false => writer.quarter(&divide(&site), "", INDEX_FOLDER, 0),
    };
    let mut root = top.json;
    if let Some(matrix) = placer.root() {
        root["transform"] = transform(matrix);
    }
    let whole = tileset(top.error * STEP, root, true);
    let mut files = vec![(INDEX_NAME.to_owned(), whole)];
    files.extend(writer.files);
    files
}

/// A tile of the tree under construction.
struct Tile {
    json: Value,
    volume: Volume,
    error: f64,
}

impl Tile {
    /// The tile of an empty site.
    fn nothing() -> Self {
        let volume = Volume { low: DVec3::ZERO, high: DVec3::ZERO };
        let json = json!({"boundingVolume": volume.json(), "geometricError": 0, "refine": "ADD"});
        Self { json, volume, error: 0.0 }
    }

    /// A tile without content around others.
    fn around(tiles: Vec<Self>) -> Self {
        let volumes = tiles.iter().map(|tile| tile.volume);
        let volume = volumes.reduce(Volume::joined).expect("a tile is around others");
        let error = tiles.iter().map(|tile| tile.error).fold(0.0, f64::max) * STEP;
        let json = json!({
            "boundingVolume": volume.json(),
            "geometricError": tidy(error),
            "refine": "ADD",
            "children": tiles.into_iter().map(|tile| tile.json).collect::<Vec<_>>(),
        });
        Self { json, volume, error }
    }
}

/// A building with its levels.
struct BuildingTile {
    json: Value,
    /// In the frame of the root.
    volume: Volume,
    error: f64,
    level_count: usize,
}

impl BuildingTile {
    fn new(id: &str, levels: &[&IndexedLevel], placer: &Placer<'_>, errors: [f64; 3]) -> Self {
        let place = levels.first().map_or(([0.0; 2], 0.0), |level| (level.position, level.turn));
        let matrix = placer.building(place.0, place.1);
        let tiles = levels.iter().filter_map(|level| Some((level, level.bounds?)));
        let mut volume: Option<Volume> = None;
        let children: Vec<Value> = tiles
            .map(|(level, bounds)| {
                let held = Volume { low: DVec3::from(bounds.low), high: DVec3::from(bounds.high) };
                volume = Some(volume.map_or(held, |known| known.joined(held)));
                level_tile(level, bounds.elevation, held, errors)
            })
            .collect();
        let volume = volume.expect("a building has levels with boxes").rounded();
        let error = errors[0] * STEP;
        let json = json!({
            "transform": transform(&matrix),
            "boundingVolume": volume.json(),
            "geometricError": tidy(error),
            "refine": "ADD",
            "metadata": {"class": "building", "properties": {"id": id}},
            "children": children,
        });
        Self { json, volume: volume.placed(&matrix).rounded(), error, level_count: levels.len() }
    }
}

/// A level: from afar nothing, then its three details.
fn level_tile(level: &IndexedLevel, elevation: f64, held: Volume, errors: [f64; 3]) -> Value {
    let rise = DVec3::new(0.0, 0.0, elevation);
    let volume = held.moved(-rise).rounded().json();
    let finer = [errors[1], errors[2], 0.0];
    let mut tile: Option<Value> = None;
    for (ending, error) in DETAILS.iter().zip(finer).rev() {
        let Some(path) = level.paths.iter().find(|path| path.ends_with(ending)) else { continue };
        let mut coarser = json!({
            "boundingVolume": volume,
            "geometricError": tidy(error),
            "content": {"uri": path},
        });
        if let Some(finer) = tile {
            coarser["children"] = json!([finer]);
        }
        tile = Some(coarser);
    }
    json!({
        "transform": transform(&DMat4::from_translation(rise)),
        "boundingVolume": volume,
        "geometricError": tidy(errors[0]),
        "refine": "REPLACE",
        "metadata": {"class": "level", "properties": {"id": level.level}},
        "children": tile.into_iter().collect::<Vec<_>>(),
    })
}

/// Writes the files below the first.
struct Writer {
    buildings: Vec<BuildingTile>,
    files: IndexFiles,
}

impl Writer {
    /// The tile of a quarter. `name` says where it is: the numbers of the quarters that it is in. `folder` leads from the file that
    /// the tile is in to the folder of the others, and `depth` counts the divisions in that file.
    fn quarter(&mut self, quarter: &Quarter, name: &str, folder: &str, depth: usize) -> Tile {
        match quarter {
            Quarter::Buildings(buildings) if name.is_empty() => self.buildings(buildings, "").0,
            Quarter::Buildings(buildings) => {
                let (tile, _) = self.buildings(buildings, "../");
                self.outsourced(tile, name, folder)
            }
            Quarter::Quarters(parts) if depth == DIVISIONS_OF_FILE => {
                let tiles =
                    parts.iter().map(|(number, part)| self.quarter(part, &format!("{name}{number}"), "", 1));
                let tile = Tile::around(tiles.collect());
                self.outsourced(tile, name, folder)
            }
            Quarter::Quarters(parts) => {
                let tiles = parts
                    .iter()
                    .map(|(number, part)| self.quarter(part, &format!("{name}{number}"), folder, depth + 1));
                Tile::around(tiles.collect())
            }
        }
    }

    /// The tile of some buildings; `up` leads from the file that it is in to the output folder.
    fn buildings(&self, buildings: &[usize], up: &str) -> (Tile, usize) {
        let tiles = buildings.iter().map(|&building| {
            let BuildingTile { json, volume, error, .. } = &self.buildings[building];
            let mut json = json.clone();
            if !up.is_empty() {
                lift_paths(&mut json, up);
            }
            Tile { json, volume: *volume, error: *error }
        });
        (Tile::around(tiles.collect()), buildings.len())
    }

    /// Moves a tile into a file of its own, and gives the one that leads there.
    fn outsourced(&mut self, tile: Tile, name: &str, folder: &str) -> Tile {
        let Tile { json, volume, error } = tile;
        self.files.push((format!("{INDEX_FOLDER}{name}.json"), tileset(error * STEP, json, true)));
        let error = error * STEP;
        let json = json!({
            "boundingVolume": volume.json(),
            "geometricError": tidy(error),
            "refine": "ADD",
            "content": {"uri": format!("{folder}{name}.json")},
        });
        Tile { json, volume, error }
    }
}

/// Puts a way up before the paths of all contents.
fn lift_paths(tile: &mut Value, up: &str) {
    if let Some(Value::String(uri)) = tile.pointer_mut("/content/uri") {
        uri.insert_str(0, up);
    }
    for child in tile.get_mut("children").and_then(Value::as_array_mut).into_iter().flatten() {
        lift_paths(child, up);
    }
}

/// A file of the tileset.
fn tileset(error: f64, root: Value, has_schema: bool) -> Vec<u8> {
    let mut json = Map::new();
    json.insert("asset".to_owned(), json!({"version": "1.1", "extras": {"generator": GENERATOR}}));
    json.insert("geometricError".to_owned(), json!(tidy(error)));
    if has_schema {
        let id = json!({"type": "STRING", "required": true, "semantic": "ID"});
        let class = |about: &str| json!({"description": about, "properties": {"id": id}});
        let classes = json!({"building": class("A building"), "level": class("A level of a building")});
        json.insert("schema".to_owned(), json!({"id": "roomwright_tileset", "classes": classes}));
    }
    json.insert("root".to_owned(), root);
    serde_json::to_vec(&json).expect("ids are strings and numbers are finite")
}

/// Without digits that say nothing: a tenth of a millimetre.
fn tidy(number: f64) -> f64 {
    (number * 1e4).round() / 1e4
}
