//! Reads a finished file back as a level with furniture, so that the audit can judge its present state.
//!
//! This is the reading side of the output contract (`contract/`). The transforms of the nodes give the places of
//! furniture, so that a moved piece is found at its new place. The extras give its class and the facts of its room.
//! Meshes are not read.
//!
//! Later stages may rely on:
//! - every index is valid, every number is finite, parents come before children;
//! - a room with a fault is left out and reported, the others are read.

mod family;
mod furniture;
mod inventory;
mod level;
mod looks;
mod openings;
mod outline;
mod parents;
mod problem;
mod survey;
#[cfg(test)]
mod tests;
mod tree;

use std::path::Path;

use crate::catalog::Catalog;
use crate::document::{Fault, Faults};
use crate::layout::Furnished;
use crate::plan::Level;

pub use inventory::{Inventory, ObjectEntry, OpeningEntry, RoomContents};
pub use looks::Described;
pub(crate) use parents::room_part;
pub use survey::{Survey, SurveyedObject, SurveyedPlace};

/// A level as its file has it.
#[derive(Clone, Debug)]
pub struct ReadLevel {
    /// Id of the building.
    pub building: String,
    /// The rooms and openings; rooms without an outline are missing.
    pub level: Level,
    /// The furniture of each room of `level`; `None` where a fault makes a verdict impossible.
    pub furnished: Vec<Option<Furnished>>,
    /// The faults of the file, room by room.
    pub faults: Faults,
}

/// Largest file that is read: a level of a thousand rooms with its own meshes is a tenth of it.
const LARGEST_FILE: u64 = 1 << 30;

/// Reads a `.glb` or `.gltf` file.
///
/// # Errors
/// If it cannot be read, is no glTF, or has no level in it. Faults of single rooms are in the answer.
pub fn read_level(path: &Path, catalog: &Catalog) -> Result<ReadLevel, Fault> {
    parse_level(path, &read_bytes(path)?, catalog)
}

/// The bytes of a file that is not too large.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, Fault> {
    crate::disk::read_regular(path, LARGEST_FILE)
        .map_err(|error| Fault::of_file(path, format!("cannot be read: {error}")))
}

/// As [`read_level`], for bytes in memory; `file` is the name for messages.
///
/// # Errors
/// As [`read_level`].
pub fn parse_level(file: &Path, bytes: &[u8], catalog: &Catalog) -> Result<ReadLevel, Fault> {
    // The nodes, each with its place and what it says about itself.
    let document = crate::model_file::unchecked_document(file, bytes)?;
    let (nodes, mut problems) = tree::nodes(&document);
    // The empty level, then what stands in it.
    let read = level::read(&nodes, &mut problems).map_err(|problem| problem.in_file(file))?;
    let furnished = furniture::read(&nodes, &read, catalog, &mut problems);
    let faults = problems.into_iter().map(|problem| problem.in_file(file)).collect();
    Ok(ReadLevel { building: read.building, level: read.level, furnished, faults: Faults(faults) })
}

/// The inventory of a file, with the faults of parts that cannot be read; no catalogue is needed.
///
/// # Errors
/// If it is no glTF or has no level in it.
pub fn parse_inventory(file: &Path, bytes: &[u8]) -> Result<(Inventory, Faults), Fault> {
    let document = crate::model_file::unchecked_document(file, bytes)?;
    let (nodes, mut problems) = tree::nodes(&document);
    let read = inventory::read(&document, &nodes, &mut problems).map_err(|problem| problem.in_file(file))?;
    Ok((read, Faults(problems.into_iter().map(|problem| problem.in_file(file)).collect())))
}

/// The furniture of a file as an editor left it.
///
/// # Errors
/// If it is no glTF, has no level in it, or has lost its nodes to instancing.
pub fn parse_survey(file: &Path, bytes: &[u8]) -> Result<Survey, Fault> {
    let document = crate::model_file::unchecked_document(file, bytes)?;
    if document.extensions_used.iter().any(|extension| extension == "EXT_mesh_gpu_instancing") {
        let fault = Fault::of_file(file, "holds furniture as GPU instances, which have no names");
        return Err(fault.with_hint("export it without \"GPU Instances\""));
    }
    let (nodes, _) = tree::nodes(&document);
    survey::read(&document, &nodes).map_err(|problem| problem.in_file(file))
}
