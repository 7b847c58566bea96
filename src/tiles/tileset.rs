//! The JSON of the tileset: quadtree, buildings, levels, details.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DMat4, DVec3};
use serde_json::{Value, json};

use super::near::errors;
use super::placement::Placer;
use super::quadtree::{Quarter, divide};
use super::volume::{Volume, transform};
use crate::output::{INDEX_FOLDER, INDEX_NAME, IndexFiles, IndexOptions, IndexedLevel};
use crate::scene::{GENERATOR, LevelBounds};

/// Files of the quadtree hold so many of its divisions.
const DIVISIONS_OF_FILE: usize = 3;
/// By how much the error of what holds others is at least larger than theirs.
const STEP: f64 = 2.0;
/// Endings of the files of a level, coarse ones first.
const DETAILS: [&str; 3] = [".boxes.glb", ".reduced.glb", ".full.glb"];

/// The files of the tileset of some levels, sorted by building and level; the one to open first.
pub(super) fn files(levels: &[IndexedLevel], options: &IndexOptions) -> IndexFiles {
    let placer = Placer::new(options.origin.as_ref());
    let mut by_building: BTreeMap<&str, Vec<(&IndexedLevel, LevelBounds)>> = BTreeMap::new();
    let shown = levels.iter().filter_map(|level| Some((level, level.bounds?)));
    shown.for_each(|(level, bounds)| by_building.entry(&level.building).or_default().push((level, bounds)));
    let buildings: Vec<PlacedLevels<'_>> =
        by_building.into_iter().filter_map(|(id, levels)| PlacedLevels::new(id, levels, &placer)).collect();
    let site: Vec<([f64; 2], usize)> =
        buildings.iter().map(|building| (building.volume.middle(), building.levels.len())).collect();
    let mut writer = Writer { buildings, errors: errors(options.near), files: Vec::new() };
    let top = match writer.buildings.is_empty() {
        true => Tile::nothing(),
        false => writer.quarter(&divide(&site), "", INDEX_FOLDER, 0),
    };
    let mut root = top.json;
    if let Some(matrix) = placer.root() {
        root["transform"] = transform(matrix);
    }
    let attributions = levels.iter().filter_map(|level| level.attribution.as_deref()).collect();
    let mut files = vec![(INDEX_NAME.to_owned(), tileset(top.error * STEP, root, &attributions))];
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

/// A building with its levels in its place.
struct PlacedLevels<'l> {
    id: &'l str,
    levels: Vec<(&'l IndexedLevel, LevelBounds)>,
    /// From the building's frame to that of the root.
    matrix: DMat4,
    /// In the frame of the building.
    own_volume: Volume,
    /// In the frame of the root.
    volume: Volume,
}

impl<'l> PlacedLevels<'l> {
    /// `None` without levels.
    fn new(id: &'l str, levels: Vec<(&'l IndexedLevel, LevelBounds)>, placer: &Placer<'_>) -> Option<Self> {
        let (first, _) = levels.first()?;
        let matrix = placer.building(first.position, first.turn);
        let volumes = levels.iter().map(|(_, bounds)| Volume::of(bounds));
        let own_volume = volumes.reduce(Volume::joined)?.rounded();
        Some(Self { id, levels, matrix, own_volume, volume: own_volume.placed(&matrix).rounded() })
    }

    /// Its tile; `up` leads from the file that it is in to the output folder.
    fn tile(&self, up: &str, errors: [f64; 3]) -> Tile {
        let levels = self.levels.iter();
        let children: Vec<Value> =
            levels.map(|(level, bounds)| level_tile(level, bounds, up, errors)).collect();
        let error = errors[0] * STEP;
        let json = json!({
            "transform": transform(&self.matrix),
            "boundingVolume": self.own_volume.json(),
            "geometricError": tidy(error),
            "refine": "ADD",
            "metadata": {"class": "building", "properties": {"id": self.id}},
            "children": children,
        });
        Tile { json, volume: self.volume, error }
    }
}

/// A level: from afar nothing, then its three details.
fn level_tile(level: &IndexedLevel, bounds: &LevelBounds, up: &str, errors: [f64; 3]) -> Value {
    let rise = DVec3::new(0.0, 0.0, bounds.elevation);
    let volume = Volume::of(bounds).moved(-rise).rounded().json();
    let finer = [errors[1], errors[2], 0.0];
    let mut tile: Option<Value> = None;
    for (ending, error) in DETAILS.iter().zip(finer).rev() {
        let Some(path) = level.paths.iter().find(|path| path.ends_with(ending)) else { continue };
        let mut coarser = json!({
            "boundingVolume": volume,
            "geometricError": tidy(error),
            "content": {"uri": format!("{up}{path}")},
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
struct Writer<'l> {
    buildings: Vec<PlacedLevels<'l>>,
    errors: [f64; 3],
    files: IndexFiles,
}

impl Writer<'_> {
    /// The tile of a quarter. `name` says where it is: the numbers of the quarters that it is in. `folder` leads from the file that
    /// the tile is in to the folder of the others, and `depth` counts the divisions in that file.
    fn quarter(&mut self, quarter: &Quarter, name: &str, folder: &str, depth: usize) -> Tile {
        match quarter {
            Quarter::Buildings(buildings) if name.is_empty() => self.buildings(buildings, ""),
            Quarter::Buildings(buildings) => {
                let tile = self.buildings(buildings, "../");
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
    fn buildings(&self, buildings: &[usize], up: &str) -> Tile {
        Tile::around(
            buildings.iter().map(|&building| self.buildings[building].tile(up, self.errors)).collect(),
        )
    }

    /// Moves a tile into a file of its own, and gives the one that leads there.
    fn outsourced(&mut self, tile: Tile, name: &str, folder: &str) -> Tile {
        let Tile { json, volume, error } = tile;
        self.files
            .push((format!("{INDEX_FOLDER}{name}.json"), tileset(error * STEP, json, &BTreeSet::new())));
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

/// A file of the tileset; the first names the sources that ask for it.
fn tileset(error: f64, root: Value, attributions: &BTreeSet<&str>) -> Vec<u8> {
    let id = json!({"type": "STRING", "required": true, "semantic": "ID"});
    let class = |about: &str| json!({"description": about, "properties": {"id": id}});
    let classes = json!({"building": class("A building"), "level": class("A level of a building")});
    let mut extras = json!({"generator": GENERATOR});
    if !attributions.is_empty() {
        extras["attributions"] = json!(attributions);
    }
    let json = json!({
        "asset": {"version": "1.1", "extras": extras},
        "geometricError": tidy(error),
        "schema": {"id": "roomwright_tileset", "classes": classes},
        "root": root,
    });
    serde_json::to_vec(&json).expect("ids are strings and numbers are finite")
}

/// Without digits that say nothing: a tenth of a millimetre.
fn tidy(number: f64) -> f64 {
    (number * 1e4).round() / 1e4
}
