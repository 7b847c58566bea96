//! OpenStreetMap with the tags of Simple Indoor Tagging (wiki.openstreetmap.org/wiki/Simple_Indoor_Tagging), in XML, in protocol
//! buffers and in GeoJSON.
//!
//! ```text
//! elements.rs (XML, PBF) ─┐
//! geojson.rs             ─┴─▶ Mapped (degrees, tags) ─▶ sort.rs ─▶ spaces, doors, outlines ─▶ translate.rs ─▶ drafts
//! ```
//!
//! The same map gives the same plan in all three. A file that holds outlines of buildings as well as rooms is a plan of the
//! buildings with rooms.

mod elements;
mod geojson;
mod houses;
mod levels;
mod mapped;
mod recognise;
mod sort;
mod translate;
mod walls;

#[cfg(test)]
mod tests;

use std::path::Path;

use recognise::{SitFormat, recognises};

use super::remarks::Remarks;
use crate::document::{Fault, Faults};
use crate::plan::RoomWords;
use crate::plan::read::foreign::id_of_file;
use crate::plan::read::osm::{Elements, PbfFile, XmlFile};
use crate::plan::read::reader::{ForeignFormat, ReadFormat, ReadResult};

/// The section of `formats` in `room_words.yaml`.
const WORDS: &str = "osm";

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: "osm-indoor",
        title: "OpenStreetMap indoor maps",
        input: "an OSM XML, OSM PBF or GeoJSON file with `indoor=room`, `corridor` or `area`",
        content: "rooms, corridors and areas of all levels, doors and entrances; the tags have no windows and no walls of a thickness",
    },
    recognises: |path| recognises(path).is_some(),
    near_miss: |_| None,
    read: |path, options| read(path, options.words),
    furniture: None,
};

/// Reads the buildings of a file that have rooms.
fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let own_id = id_of_file(path, "map");
    match recognises(path) {
        Some(SitFormat::Xml) => read_elements(&XmlFile::open(path)?, &own_id, words),
        Some(SitFormat::Pbf) => read_elements(&PbfFile::open(path)?, &own_id, words),
        Some(SitFormat::GeoJson) => {
            let (source, mapped) = geojson::read(path)?;
            let fault = |place, message: &str| geojson::fault_of(&source, place, message);
            translate::buildings(mapped, (words, &own_id), Remarks::default(), &fault)
        }
        None => Err(Faults::from(Fault::of_file(path, "has no rooms with indoor tags"))),
    }
}

fn read_elements(file: &dyn Elements, own_id: &str, words: &RoomWords) -> ReadResult {
    let mut remarks = Remarks::default();
    let mapped = elements::mapped(file, &mut remarks)?;
    translate::buildings(mapped, (words, own_id), remarks, &|offset, message| file.fault(offset, message))
}
