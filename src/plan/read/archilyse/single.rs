//! Reads one drawing with the file of its areas.

use std::path::{Path, PathBuf};

use super::areas::Area;
use super::drawing::Drawing;
use super::level::{Floor, Heights, Naming, level};
use super::rooms::{RoomTypes, outlined};
use super::tables::Table;
use crate::document::{Fault, FaultSeverity, Faults, PathStep, Source};
use crate::plan::read::foreign::{both, missing_files};
use crate::plan::read::reader::{DraftedBuilding, ReadBuildings, ReadResult};
use crate::plan::units::metres_per_pixel;
use crate::plan::{BuildingDraft, RoomWords};

/// Reads a drawing and its areas.
pub(super) fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let source = Source::read(path)?;
    let drawing = source.parse::<Drawing>();
    let areas_file = areas_file(path)?;
    let mut faults = Faults::default();
    // Both files are looked at before giving up on one.
    let (drawing, areas) = both(drawing, Table::<Area>::read(&areas_file, &mut faults))?;
    let pixel = pixel_size(&source, drawing.scale, &["scale".into()])?;
    let areas_of_floor = outlined(&areas, &mut faults);
    let mut types = RoomTypes::new(words);
    let heights = Heights::default();
    let floor = Floor { drawing: &drawing, pixel, areas: areas_of_floor, heights, number: 0 };
    let mut naming =
        Naming { room_type: &mut |area, is_toilet| types.of(area, is_toilet), apartment: &|_| None };
    let levels = vec![level(&floor, &mut naming)];
    let id = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let draft = BuildingDraft { levels, ..BuildingDraft::default() };
    faults.merge(types.warnings(&areas));
    ReadBuildings::new(vec![DraftedBuilding { id, draft, ..DraftedBuilding::default() }], faults)
}

/// The file of a drawing's areas, beside it or in the folder `areas` beside its own.
fn areas_file(drawing: &Path) -> Result<PathBuf, Faults> {
    let folder = drawing.parent().unwrap_or(Path::new(""));
    let name = drawing.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let name = format!("areas_{name}");
    let candidates = [folder.join(&name), folder.join("..").join("areas").join(&name)];
    candidates.into_iter().find(|candidate| candidate.is_file()).ok_or_else(|| {
        let (_, here) = missing_files(folder, &[name.as_str()], &[]);
        let hint = format!("put the file beside the drawing, or into \"../areas\"; {here}");
        Fault::of_file(drawing, format!("its areas \"{name}\" are missing")).with_hint(hint).into()
    })
}

/// Metres per pixel.
pub(super) fn pixel_size(source: &Source, scale: f64, path: &[PathStep]) -> Result<f64, Faults> {
    metres_per_pixel(scale).ok_or_else(|| {
        let hint = Some("square centimetres per square pixel, above zero".to_owned());
        source.fault(path, format!("scale {scale} is no size of a pixel"), hint, FaultSeverity::Error).into()
    })
}
