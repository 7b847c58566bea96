//! Finished levels, as a bake has written them or an editor has left them.

use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;
use serde_json::{Value, json};

use super::questions::{Answers, Listener, Refusal};
use super::site::{Abilities, level, site};
use crate::catalog::Catalog;
use crate::disk::open_inside;
use crate::document::{Fault, Faults};
use crate::output::{LevelOptions, SHARED_GEOMETRY, SHARED_TEXTURES};
use crate::plan::{Building, PlacedBuilding, Plan};
use crate::read_back::{ReadLevel, read_bytes, read_level};
use crate::world::BuildingGraph;

/// Levels that are read at most: more are looked at building by building.
const MOST_LEVELS: usize = 1000;
/// The largest file beside a level that is served.
const LARGEST_SHARED: u64 = 256 << 20;

/// Finished levels.
pub(crate) struct Baked {
    plan: Plan,
    catalog: Catalog,
    options: LevelOptions,
    /// The file of each level, by building and level.
    files: BTreeMap<(String, String), PathBuf>,
}

impl Baked {
    /// Reads the levels of files, and says what is wrong with some of them.
    ///
    /// # Errors
    /// If none of them can be read, or they are too many.
    pub(crate) fn read(files: &[PathBuf], catalog: Catalog) -> Result<(Self, Faults), Faults> {
        if files.len() > MOST_LEVELS {
            let message =
                format!("{} levels, and {MOST_LEVELS} are the most that are shown at once", files.len());
            let fault = Fault::of_file(files.first().map_or(Path::new("."), PathBuf::as_path), message);
            return Err(fault.with_hint("name the folders of some buildings").into());
        }
        let mut faults = Faults::default();
        let mut buildings: BTreeMap<String, Building> = BTreeMap::new();
        let mut known = BTreeMap::new();
        let read: Vec<Result<ReadLevel, Fault>> =
            files.par_iter().map(|file| read_level(file, &catalog)).collect();
        for (file, read) in files.iter().zip(read) {
            match read {
                Ok(ReadLevel { building, level, faults: found, .. }) => {
                    faults.merge(found);
                    let key = (building.clone(), level.id.clone());
                    if known.contains_key(&key) {
                        let message = format!("is level {}/{}, which another file is", key.0, key.1);
                        faults.push(Fault::of_file(file, message));
                        continue;
                    }
                    known.insert(key, file.clone());
                    let empty = || Building { name: None, attribution: None, levels: Vec::new() };
                    buildings.entry(building).or_insert_with(empty).levels.push(level);
                }
                Err(fault) => faults.push(fault),
            }
        }
        if known.is_empty() {
            return Err(faults);
        }
        let placed = buildings.into_iter().map(|(id, mut building)| {
            building.levels.sort_by(|one, other| one.elevation.total_cmp(&other.elevation));
            PlacedBuilding {
                id,
                site: crate::plan::SitePlacement::default(),
                building: Arc::new(building),
                source: Arc::default(),
            }
        });
        let plan = Plan { buildings: placed.collect() };
        Ok((Self { plan, catalog, options: LevelOptions::default(), files: known }, faults))
    }

    fn file(&self, building: &str, level: &str) -> Result<&PathBuf, Refusal> {
        let found = self.files.get(&(building.to_owned(), level.to_owned()));
        found.ok_or_else(|| Refusal::NotFound(format!("there is no level {building}/{level}")))
    }
}

impl Answers for Baked {
    fn site(&self) -> Value {
        let abilities = Abilities { revision: 1, kind: "bake", is_editable: false };
        json!(site(&self.plan, &self.catalog, &self.options, abilities))
    }

    fn level(&self, building: &str, id: &str) -> Result<Value, Refusal> {
        self.file(building, id)?;
        let unknown = || Refusal::NotFound(format!("there is no level {building}/{id}"));
        let placed = self.plan.buildings.iter().find(|placed| placed.id == building).ok_or_else(unknown)?;
        let levels = &placed.building.levels;
        let index = levels.iter().position(|level| level.id == id).ok_or_else(unknown)?;
        let graph = BuildingGraph::new(&placed.building, &self.catalog);
        Ok(json!(level((building, &placed.building), index, &graph, 1)))
    }

    fn level_file(&self, building: &str, level: &str) -> Result<Vec<u8>, Refusal> {
        read_bytes(self.file(building, level)?).map_err(|fault| Refusal::NotFound(fault.report()))
    }

    /// A file in one of the folders that levels share, or the arrays of a level; levels of one program agree on the names.
    fn shared(&self, path: &str) -> Result<Arc<Vec<u8>>, Refusal> {
        let unknown = || Refusal::NotFound(format!("no level refers to {path}"));
        let is_shared = [SHARED_GEOMETRY, SHARED_TEXTURES].iter().any(|folder| {
            path.strip_prefix(folder).is_some_and(|name| name.starts_with('/') && !name[1..].contains('/'))
        });
        let is_arrays = |file: &Path| {
            file.extension().is_some_and(|ending| ending == "gltf")
                && file.with_extension("bin").file_name().is_some_and(|name| name == path)
        };
        for file in self.files.values().filter(|file| is_shared || is_arrays(file)) {
            let folder = file.parent().unwrap_or(Path::new("."));
            let Ok(Some((opened, found))) = open_inside(folder, path) else { continue };
            if found.len() > LARGEST_SHARED {
                return Err(Refusal::Bad(format!("{path} is too large")));
            }
            let mut bytes = Vec::new();
            if opened.take(LARGEST_SHARED).read_to_end(&mut bytes).is_ok() {
                return Ok(Arc::new(bytes));
            }
        }
        Err(unknown())
    }

    /// Finished files are shown as they were when they were read.
    fn listen(&self, _: Listener) {}
}
