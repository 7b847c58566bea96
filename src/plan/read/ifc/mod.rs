//! Industry Foundation Classes (ISO 16739) as exchange files (ISO 10303-21): IFC2X to IFC2X3, IFC4 and IFC4X3.
//!
//! One building for each `IfcBuilding` with storeys or spaces, one level for each storey with spaces, or for each height of the floors of
//! spaces that are on no storey. Of the file are read:
//! - `IfcSpace`: the outline is what its body covers of the floor (swept and revolved profiles, flat and curved faces,
//!   boxes, footprint curves; of clipped bodies the uncut one), the height that of its body, the room type the words of
//!   `LongName`, `Name` and `ObjectType`. Without a body it is that of its boundaries, else of the walls around its place;
//! - `IfcDoor` and `IfcWindow` in the openings that they fill, or by themselves; how doors open; windows above
//!   each other with a bar between are one; openings down to the floor that nothing fills are passages;
//! - walls, to tell where two spaces meet without one, and columns. Panes of curtain walls are windows.
//!
//! Not read: roof windows, railings, stairs, furniture. A file without spaces has no rooms and is refused.
//!
//! Arcs and splines are flattened within 5 mm of the true curve; arcs of a radius above 9.3 m within 0.06 % of it.
//!
//! Lengths of all units become metres in the file's first reading; places are those in the building's own axes.

mod bends;
mod boundary;
mod building;
mod columns;
mod curtain;
mod curve;
mod edge;
mod enclosed;
mod exterior;
mod fixtures;
mod footprint;
mod furniture;
mod level;
mod looks;
mod model;
mod openings;
mod panes;
mod placement;
mod profile;
mod relations;
mod revolved;
mod room_types;
mod rooms;
mod shape;
mod solid;
mod spline;
mod step;
mod storeyless;
mod strings;
mod swing;
mod units;
mod value;

#[cfg(test)]
mod cases;
#[cfg(test)]
mod tests;

use std::path::Path;

use super::foreign::head;
use crate::disk::unpacked_name;
use crate::document::{Fault, Faults, Source};
use crate::plan::read::drawn::DrawnPiece;
use crate::plan::read::reader::{ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use crate::plan::{PlanOptions, RoomWords};
use model::Model;

/// The format's word in `room_words.yaml`.
const NAME: &str = "ifc";

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "IFC",
        input: "an .ifc file of IFC2X to IFC2X3, IFC4 or IFC4X3 in the STEP encoding",
        content: "spaces, with curved faces or without a body too; doors and how they open, windows, panes of curtain walls, columns; no roof windows",
    },
    recognises,
    near_miss: |_| None,
    read: |path, options| read(path, options.words, options.keeps_furniture),
    furniture: Some(drawn_furniture),
};
/// The beginning of every exchange file.
const BEGINNING: &str = "ISO-10303-21";
/// Bytes at the start of a file by which it is recognised.
const HEAD_SIZE: u64 = 4096;
/// The beginnings of the schemas that are read. `IFC2X_FINAL` and `IFC2X2_FINAL` of 2000 to 2006 have what is read here in the
/// same places as IFC2X3.
const SCHEMAS: [&str; 2] = ["IFC2X", "IFC4"];

/// Whether a file is of this format: by its ending, or an exchange file of an IFC schema.
fn recognises(path: &Path) -> bool {
    if path.is_dir() {
        return false;
    }
    if unpacked_name(path).extension().is_some_and(|extension| extension.eq_ignore_ascii_case(NAME)) {
        return true;
    }
    let head = head(path, HEAD_SIZE);
    let head = String::from_utf8_lossy(&head).to_ascii_uppercase();
    let schema = head.find("FILE_SCHEMA").map(|start| &head[start..]);
    head.trim_start_matches('\u{feff}').trim_start().starts_with(BEGINNING)
        && schema.is_some_and(|schema| schema.contains("'IFC"))
}

/// Reads the buildings of a file that have spaces, in the order of their numbers.
fn read(path: &Path, words: &RoomWords, keeps_furniture: bool) -> ReadResult {
    let (model, name, mut faults) = open(path)?;
    let buildings = building::buildings(&model, words, &name, keeps_furniture);
    faults.merge(model.faults());
    if model.ids(&["IFCSPACE"]).next().is_none() {
        let hint = "export rooms as spaces; in Revit rooms must be placed, in ArchiCAD zones";
        faults.push(Fault::of_file(path, "holds no spaces (IfcSpace), so no rooms").with_hint(hint));
    }
    let (buildings, furniture): (Vec<_>, Vec<_>) = buildings.into_iter().unzip();
    let furniture = keeps_furniture.then(|| furniture.concat());
    ReadBuildings::new(buildings, faults).map(|read| ReadBuildings { furniture, ..read })
}

/// The furniture of an IFC file, by building and number; what has no place or shape is left out.
///
/// # Errors
/// Why the file cannot be read.
fn drawn_furniture(path: &Path, _: &PlanOptions<'_>) -> Result<Vec<DrawnPiece>, Faults> {
    let (model, name, _) = open(path)?;
    let buildings = building::buildings(&model, &RoomWords::default(), &name, true);
    Ok(buildings.into_iter().flat_map(|(_, pieces)| pieces).collect())
}

/// The instances of a file, its name without ending, and warnings.
fn open(path: &Path) -> Result<(Model, String, Faults), Faults> {
    let (source, faults) = Source::read_old(path)?;
    if !source.text().trim_start().starts_with(BEGINNING) {
        let fault = Fault::of_file(path, format!("does not begin with {BEGINNING}"));
        return Err(fault.with_hint("export it as IFC in the STEP encoding, not as ifcXML or ifcZIP").into());
    }
    let model = Model::new(source);
    let schemas = &model.exchange.schemas;
    if !schemas.iter().any(|schema| SCHEMAS.iter().any(|known| schema.starts_with(known))) {
        let message = format!("schema \"{}\" is not read", schemas.join("\", \""));
        return Err(Fault::of_file(path, message).with_hint("export it as IFC2X3 or IFC4").into());
    }
    let name =
        unpacked_name(path).file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    Ok((model, name, faults))
}
