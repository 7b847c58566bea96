//! OpenStreetMap: areas and multipolygons with `building` or `building:part`, doors, streets.
//!
//! ```text
//! ../osm/ ─▶ elements (relations, then ways, then nodes) ─▶ selection.rs ─▶ areas.rs ─▶ Drawing
//! ```
//!
//! A file is gone through once for each kind, in the order in which they refer to each other, so that only the nodes that are
//! needed are kept.

mod areas;
mod selection;

use std::path::Path;

use areas::drawing_of;
use selection::Selection;

use super::drawn::Drawing;
use super::notes::SiteNotes;
use crate::document::Faults;
use crate::plan::read::osm::{Elements, PbfFile, XmlFile};

/// Reads the buildings of a file in XML.
///
/// # Errors
/// Faults of syntax, at their places.
pub(super) fn read_xml(path: &Path) -> Result<(Drawing, SiteNotes), Faults> {
    read(&XmlFile::open(path)?)
}

/// Reads the buildings of a file in protocol buffers.
///
/// # Errors
/// A file that is cut off or damaged, or uses features of the format that are not read.
pub(super) fn read_pbf(path: &Path) -> Result<(Drawing, SiteNotes), Faults> {
    read(&PbfFile::open(path)?)
}

fn read(file: &dyn Elements) -> Result<(Drawing, SiteNotes), Faults> {
    let mut notes = SiteNotes::default();
    let selection = Selection::of(file, &mut notes)?;
    Ok((drawing_of(selection, &mut notes), notes))
}
