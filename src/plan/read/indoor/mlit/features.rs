//! Reads the files of a storey: collections of features of one kind each.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use super::files::file;
use crate::document::{Faults, Source};
use crate::plan::read::foreign::both;
use crate::plan::read::geojson::{Geometry, reference_system};

/// A file; `crs` names the reference system, as before RFC 7946.
#[derive(Debug, Deserialize, JsonSchema)]
struct Collection<P> {
    crs: Option<Value>,
    features: Vec<Feature<P>>,
}

/// A feature; its id is a property.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Feature<P> {
    pub(super) geometry: Option<Geometry>,
    pub(super) properties: P,
}

/// Properties of a floor: a part of a storey.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct FloorProperties {
    pub(super) id: String,
    /// 1 is the ground floor, -1 the first basement, 0 open ground.
    pub(super) ordinal: f64,
    pub(super) name: Option<String>,
}

/// Properties of a space.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct SpaceProperties {
    pub(super) id: String,
    /// A code such as `B001`.
    pub(super) category: Option<String>,
    pub(super) floor_id: String,
    pub(super) name: Option<String>,
}

/// Properties of an opening.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct OpeningProperties {
    pub(super) id: String,
    pub(super) floor_id: String,
}

/// Properties of what is counted only.
#[derive(Debug, Deserialize, JsonSchema)]
struct AnyProperties {}

/// A file's text, reference system and features.
pub(super) struct Table<P> {
    pub(super) source: Source,
    pub(super) reference_system: Option<String>,
    pub(super) features: Vec<Feature<P>>,
}

/// The files of a storey.
pub(super) struct StoreyFiles {
    pub(super) floors: Table<FloorProperties>,
    pub(super) spaces: Table<SpaceProperties>,
    pub(super) openings: Option<Table<OpeningProperties>>,
    /// Counters, lockers and pillars, which are not read.
    pub(super) fixture_count: usize,
}

/// Reads all storeys of a building.
///
/// # Errors
/// All faults of all files, each at its place.
pub(super) fn read_storeys(stems: &[PathBuf]) -> Result<Vec<StoreyFiles>, Faults> {
    let mut storeys = Vec::with_capacity(stems.len());
    let mut faults = Faults::default();
    for stem in stems {
        match read_storey(stem) {
            Ok(storey) => storeys.push(storey),
            Err(found) => faults.merge(found),
        }
    }
    if faults.is_empty() { Ok(storeys) } else { Err(faults) }
}

fn read_storey(stem: &Path) -> Result<StoreyFiles, Faults> {
    let openings = file(stem, "_Opening.geojson");
    let openings = if openings.exists() { read_table(&openings).map(Some) } else { Ok(None) };
    let floors = read_table(&file(stem, "_Floor.geojson"));
    let ((floors, spaces), openings) =
        both(both(floors, read_table(&file(stem, "_Space.geojson"))), openings)?;
    // Faults of what is not read are nobody's loss.
    let fixtures = read_table::<AnyProperties>(&file(stem, "_Fixture.geojson"));
    let fixture_count = fixtures.map_or(0, |table| table.features.len());
    Ok(StoreyFiles { floors, spaces, openings, fixture_count })
}

fn read_table<P>(path: &Path) -> Result<Table<P>, Faults>
where
    P: for<'de> Deserialize<'de> + JsonSchema,
{
    let source = Source::read(path)?;
    let collection: Collection<P> = source.parse()?;
    let reference_system = reference_system(collection.crs.as_ref());
    Ok(Table { source, reference_system, features: collection.features })
}
