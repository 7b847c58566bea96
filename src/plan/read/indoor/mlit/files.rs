//! The files of a folder, by building and storey.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::plan::read::foreign::{head, slug};

/// The endings of the files that make a storey.
const NEEDED: [&str; 2] = ["_Floor.geojson", "_Space.geojson"];
/// Bytes at the start of a file in which its first features are.
const HEAD_SIZE: u64 = 4096;

/// The beginnings of the names of the storeys' files, such as `folder/Station_B1`, sorted.
pub(super) fn storeys(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    let mut found: Vec<PathBuf> = entries
        .filter_map(|entry| {
            let name = entry.file_name().to_str()?.strip_suffix(NEEDED[0])?.to_owned();
            let stem = folder.join(name);
            let is_whole = file(&stem, NEEDED[1]).is_file();
            (is_whole && is_of_map(&file(&stem, NEEDED[1]))).then_some(stem)
        })
        .collect();
    found.sort();
    found
}

/// The storeys by the id of their building: what stands before the last `_` of their names.
pub(super) fn buildings(folder: &Path) -> BTreeMap<String, Vec<PathBuf>> {
    let mut buildings: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
    for stem in storeys(folder) {
        let name = stem.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let id = slug(name.rsplit_once('_').map_or(name.as_str(), |(building, _)| building));
        let id = if id.is_empty() { "map".to_owned() } else { id };
        buildings.entry(id).or_default().push(stem);
    }
    buildings
}

/// A file of a storey, by the ending of its name.
pub(super) fn file(stem: &Path, ending: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(ending);
    name.into()
}

/// Whether a file of spaces is of this map: its features name their floors.
fn is_of_map(path: &Path) -> bool {
    let text = head(path, HEAD_SIZE);
    let text = String::from_utf8_lossy(&text);
    text.contains("FeatureCollection") && text.contains("\"floor_id\"")
}
