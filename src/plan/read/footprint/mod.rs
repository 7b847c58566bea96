//! Building footprints: maps of outlines without rooms, from which storeys are planned.
//!
//! ```text
//! geojson ─┐
//! cityjson ┼─▶ Drawing ─▶ site.rs: frame (metres) ─▶ sound ─▶ tidy ─▶ merge ─▶ Site
//! osm ─────┘   (units of the file, facts by family of tags)
//! ```
//!
//! A reader of a format makes a [`drawn::Drawing`]; everything after it is common. Each building that a file draws is a footprint,
//! or [`SiteNotes`] says what became of it. The answer does not depend on the order of features in the file.

mod cityjson;
mod drawn;
mod entrances;
mod facts;
mod frame;
mod geojson;
mod ids;
mod kind;
mod merge;
mod needles;
mod notes;
mod osm;
mod projection;
mod properties;
mod recognise;
mod site;
mod sound;
mod streets;
mod syntax;
#[cfg(test)]
mod tests;
mod tidy;

use std::path::Path;

pub use notes::SiteNotes;
pub(crate) use projection::{Projection, code_of};
pub(super) use properties::hstore;
pub(crate) use recognise::{FootprintFormat, recognises};

use crate::document::{Fault, Faults, Source};
use crate::storey::Site;

/// A file's buildings, what is wrong with the rest, and what was merged or dropped.
#[derive(Debug)]
pub(crate) struct ReadSite {
    /// The buildings on one plane.
    pub(crate) site: Site,
    /// Warnings, sorted.
    pub(crate) faults: Faults,
    /// What became of everything else that the file draws.
    pub(crate) notes: SiteNotes,
}

impl ReadSite {
    /// Notes buildings of the site, by number, that are not planned, and warns of them.
    pub(crate) fn leave_out(&mut self, file: &Path, buildings: &[usize], reason: &str) {
        for &index in buildings {
            self.notes.leave_out(&self.site.footprints[index].id, reason);
        }
        self.notes.sort();
        self.faults = self.notes.faults(file);
        self.faults.sort();
    }
}

/// Reads the buildings of a file of any format of footprints.
///
/// # Errors
/// A file of another format, one with faults of syntax, and one without a building that can be used.
pub(crate) fn read_site(path: &Path) -> Result<ReadSite, Faults> {
    let (drawing, notes) = match recognises(path) {
        Some(FootprintFormat::GeoJson) => geojson::read(path)?,
        Some(FootprintFormat::CityJson) => cityjson::read(path)?,
        Some(FootprintFormat::OsmXml) => osm::read_xml(path)?,
        Some(FootprintFormat::OsmPbf) => osm::read_pbf(path)?,
        // What is not there is told as everywhere.
        None if !path.exists() => return Err(Source::read(path).err().unwrap_or_default()),
        None => {
            let fault = Fault::of_file(path, "is no map of building footprints");
            let hint =
                "maps are GeoJSON features, CityJSON and OpenStreetMap; `bake` and `import` read plans";
            return Err(fault.with_hint(hint).into());
        }
    };
    site::site_of(drawing, notes, path)
}
