//! The indoor map of the Japanese ministry of land (MLIT): a folder of GeoJSON files, a `Floor`, a `Space` and an `Opening` for each
//! storey, in metres of the Japanese plane or in degrees.
//!
//! ```text
//! Station_B1_Floor.geojson, ..._Space, ..._Opening      building `station`, the levels by the ordinal of their floors
//! ```
//!
//! A file has several floors of one storey: separate buildings and the passages between them. They are one level, so that openings
//! between them join rooms. The format is IMDF's with other names: spaces share their edges, and it has no windows and no heights.

mod features;
mod files;
mod frame;
mod translate;

#[cfg(test)]
mod tests;

use std::path::Path;

use crate::document::Faults;
use crate::plan::RoomWords;
use crate::plan::read::reader::{ForeignFormat, ReadBuildings, ReadFormat, ReadResult};

/// The format's word in `room_words.yaml`.
const NAME: &str = "mlit";

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "Japanese indoor maps (MLIT)",
        input: "a folder with <name>_Floor.geojson and <name>_Space.geojson of each storey; _Opening where it is",
        content: "spaces and openings of all floors; the format has no windows and no heights",
    },
    recognises: |path| !files::storeys(path).is_empty(),
    near_miss: |_| None,
    read: |path, options| read(path, options.words),
    furniture: None,
};

/// Reads the buildings of a folder, each with all of its storeys.
fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let mut faults = Faults::default();
    let mut buildings = Vec::new();
    let mut origins = Vec::new();
    for (id, storeys) in files::buildings(path) {
        let read =
            features::read_storeys(&storeys).and_then(|storeys| translate::building(&id, &storeys, words));
        match read {
            Ok((building, origin, warnings)) => {
                buildings.push(building);
                origins.push(origin);
                faults.merge(warnings);
            }
            Err(found) => faults.merge(found),
        }
    }
    // Each building has a frame of its own: of several, nothing is said of where the site is.
    let origin = if let [origin] = origins.as_mut_slice() { origin.take() } else { None };
    Ok(ReadBuildings { origin, ..ReadBuildings::new(buildings, faults)? })
}
