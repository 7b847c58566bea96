//! Indoor Mapping Data Format (OGC 20-094): a folder of GeoJSON files in degrees.
//!
//! `building`, `level`, `unit` and `opening` make the plan, `anchor` and `occupant` name rooms where they are there.
//! One building for each that has levels, one level for each of its ordinals. Units share their edges, so their
//! outlines are centre lines of walls. The format has neither windows nor heights nor thicknesses.

mod features;
mod translate;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::path::Path;

use features::{
    AnchorProperties, BuildingProperties, LevelProperties, OccupantProperties, OpeningProperties,
    UnitProperties, label, optional_features, table,
};

use super::foreign::{Parts, both, head};
use super::geojson::{Feature, Table};
use crate::document::Faults;
use crate::plan::RoomWords;
use crate::plan::read::reader::{ForeignFormat, ReadFormat, ReadResult};

/// The format's word in `room_words.yaml`.
const NAME: &str = "imdf";

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "IMDF",
        input: "a folder with building.geojson, level.geojson and unit.geojson; opening, anchor and occupant where they are",
        content: "units and openings of all levels that have a building; the format has no windows and no heights",
    },
    recognises,
    near_miss,
    read: |path, options| read(path, options.words),
    furniture: None,
};
/// The files without which there is no plan.
const NEEDED: [&str; 3] = ["level.geojson", "unit.geojson", "building.geojson"];
/// The further files of the format, read or not.
const OTHERS: [&str; 11] = [
    "address.geojson",
    "amenity.geojson",
    "anchor.geojson",
    "detail.geojson",
    "fixture.geojson",
    "footprint.geojson",
    "geofence.geojson",
    "kiosk.geojson",
    "occupant.geojson",
    "opening.geojson",
    "venue.geojson",
];

/// Whether a folder is of this format.
fn recognises(path: &Path) -> bool {
    NEEDED.iter().all(|name| path.join(name).is_file())
}

/// The fault of a folder that has some of the files, with those that are needed.
fn near_miss(folder: &Path) -> Option<(&'static str, Parts)> {
    /// Bytes at the start of a file in which the first feature says what it is.
    const HEAD_SIZE: u64 = 4096;
    let entries = std::fs::read_dir(folder).ok()?.filter_map(Result::ok);
    let mut features = entries.map(|entry| entry.path()).filter(|path| {
        let is_geojson = path.extension().is_some_and(|extension| {
            extension.eq_ignore_ascii_case("geojson") || extension.eq_ignore_ascii_case("json")
        });
        is_geojson && String::from_utf8_lossy(&head(path, HEAD_SIZE)).contains("\"feature_type\"")
    });
    let has_some = NEEDED.iter().any(|name| folder.join(name).is_file());
    (has_some || features.next().is_some())
        .then_some(("an IMDF folder", Parts { needed: &NEEDED, others: &OTHERS }))
}

/// Reads the buildings of a folder that have levels, in the order of their file.
fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let archive = Archive::read(path)?;
    translate::buildings(&archive, words)
}

/// The files of a folder.
struct Archive {
    buildings: Table<BuildingProperties>,
    levels: Table<LevelProperties>,
    units: Table<UnitProperties>,
    openings: Option<Table<OpeningProperties>>,
    /// By unit.
    occupants: BTreeMap<String, Occupant>,
}

/// The occupant of a unit.
struct Occupant {
    name: Option<String>,
    category: Option<String>,
}

impl Archive {
    fn read(folder: &Path) -> Result<Self, Faults> {
        let openings = if folder.join("opening.geojson").exists() {
            table(folder, "opening").map(Some)
        } else {
            Ok(None)
        };
        let ((buildings, levels), (units, openings)) = both(
            both(table(folder, "building"), table(folder, "level")),
            both(table(folder, "unit"), openings),
        )?;
        let (anchors, occupants) =
            both(optional_features(folder, "anchor"), optional_features(folder, "occupant"))?;
        Ok(Self { buildings, levels, units, openings, occupants: occupants_by_unit(&anchors, occupants) })
    }
}

fn occupants_by_unit(
    anchors: &[Feature<AnchorProperties>],
    occupants: Vec<Feature<OccupantProperties>>,
) -> BTreeMap<String, Occupant> {
    let units: BTreeMap<&str, &str> = anchors
        .iter()
        .filter_map(|anchor| Some((anchor.id.as_str(), anchor.properties.unit_id.as_deref()?)))
        .collect();
    let mut by_unit = BTreeMap::new();
    for Feature { properties, .. } in occupants {
        let unit = properties.anchor_id.as_deref().and_then(|anchor| units.get(anchor));
        if let Some(unit) = unit {
            let occupant = Occupant { name: label(properties.name.as_ref()), category: properties.category };
            // The first tenant names the room.
            by_unit.entry((*unit).to_owned()).or_insert(occupant);
        }
    }
    by_unit
}
