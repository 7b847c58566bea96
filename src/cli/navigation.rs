//! `navigation`: navigation meshes and occupancy maps of finished files.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

use super::answer::{FaultAnswer, fault_answers};
use super::arguments::NavigationArguments;
use super::audit::level_files;
use super::exit::Outcome;
use super::files::{LARGEST_OWN, Overwrite, write_bytes};
use super::screen::Screen;
use crate::batch::catch_bug;
use crate::catalog::{Catalog, load_catalog};
use crate::disk::{content_hash, read_regular};
use crate::document::{Fault, Faults, counted};
use crate::navigation::{Agent, IndexFile, IndexedMap, LevelFloor, MapFile, MeshFile, mesh, occupancy};
use crate::read_back::read_level;

/// The file over all levels.
const INDEX: &str = "navigation.json";
/// Of its format.
const VERSION: u32 = 1;
/// Endings of the files of a level.
const MESH: &str = ".navigation.json";
const PICTURE: &str = ".occupancy.png";
const MAP: &str = ".occupancy.yaml";
/// Rooms that are named in a line.
const LISTED_ROOMS: usize = 5;

/// The answer of `navigation`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct NavigationAnswer {
    /// The output folder.
    out: String,
    /// The levels that were written.
    levels: Vec<IndexedMap>,
    /// What is wrong with the files.
    faults: Vec<FaultAnswer>,
}

/// What all levels have in common.
struct Work<'a> {
    arguments: &'a NavigationArguments,
    catalog: &'a Catalog,
    agent: Agent,
    /// Hashes of the files that the command wrote before, by path.
    known: BTreeMap<String, String>,
}

/// Runs the command.
pub(crate) fn run(arguments: &NavigationArguments, screen: Screen) -> Outcome {
    let (levels, faults) = match write_all(arguments, screen) {
        Ok(written) => written,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    screen.faults(&faults);
    if screen.is_json {
        let out = arguments.out.display().to_string();
        screen.json(&NavigationAnswer { out, levels: levels.clone(), faults: fault_answers(&faults) });
    } else if !screen.is_quiet && !levels.is_empty() {
        screen.result(&text(&levels, &arguments.out));
    }
    if levels.is_empty() { Outcome::NotStarted } else { Outcome::of_failures(faults.has_errors()) }
}

fn write_all(arguments: &NavigationArguments, screen: Screen) -> Result<(Vec<IndexedMap>, Faults), Faults> {
    let (files, mut faults) = level_files(&arguments.paths)?;
    let loaded = load_catalog(&arguments.catalog)?;
    screen.faults(&loaded.warnings);
    let places = places(&files)?;
    let rules = &loaded.value.audit.walking;
    let agent = Agent {
        radius: arguments.radius.unwrap_or(rules.robot / 2.0),
        height: arguments.height.unwrap_or(rules.body_height),
        step: rules.step,
    };
    let index = arguments.out.join(INDEX);
    let known = known_files(&index)?;
    let is_new = known.is_none() && !arguments.force;
    let work = Work { arguments, catalog: &loaded.value, agent, known: known.unwrap_or_default() };
    // One file a thread, collected in the order of their names.
    let written: Vec<_> =
        files.par_iter().zip(&places).map(|(file, place)| write_level(&work, file, place)).collect();
    let mut levels = Vec::new();
    for result in written {
        match result {
            Ok((level, others)) => {
                faults.merge(others);
                levels.push(level);
            }
            Err(others) => faults.merge(others),
        }
    }
    levels.sort_by(|a, b| {
        (&a.building, &a.level, &a.files[0].path).cmp(&(&b.building, &b.level, &b.files[0].path))
    });
    if !levels.is_empty() {
        let generator = concat!("roomwright ", env!("CARGO_PKG_VERSION")).to_owned();
        let content = document(&IndexFile { version: VERSION, generator, agent, levels: levels.clone() });
        let overwrite = if is_new { Overwrite::Nothing } else { Overwrite::All };
        write_bytes(&index, &content, overwrite)?;
    }
    Ok((levels, faults))
}

/// Where the files of each level go, below the output folder and without their endings: as the folder and the file are called.
fn places(files: &[PathBuf]) -> Result<Vec<String>, Faults> {
    let name = |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned());
    let (mut known, mut faults) = (BTreeSet::new(), Faults::default());
    let mut places = Vec::new();
    for file in files {
        // A file in the folder of the shell has no folder in its path.
        let folder = file.canonicalize().ok().as_deref().and_then(Path::parent).and_then(name);
        let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let place = folder.map_or(stem.clone(), |folder| format!("{folder}/{stem}"));
        if !known.insert(place.to_lowercase()) {
            let fault = Fault::of_file(file, format!("is the second file that would become {place}{MESH}"));
            faults.push(fault.with_hint("name their folders in runs of their own, with other --out"));
        }
        places.push(place);
    }
    if faults.is_empty() { Ok(places) } else { Err(faults) }
}

/// Hashes of the files that an index lists, by path; none where there is no index.
fn known_files(index: &Path) -> Result<Option<BTreeMap<String, String>>, Faults> {
    if !index.exists() {
        return Ok(None);
    }
    let read = read_regular(index, LARGEST_OWN).ok();
    let read = read.and_then(|content| serde_json::from_slice::<IndexFile>(&content).ok());
    let Some(read) = read else {
        let fault = Fault::of_file(index, "is no index that this command wrote");
        return Err(fault.with_hint("name another folder with --out").into());
    };
    let files = read.levels.into_iter().flat_map(|level| level.files);
    Ok(Some(files.map(|file| (file.path, file.sha256)).collect()))
}

/// Writes the files of one level; the faults are those of rooms.
fn write_level(work: &Work<'_>, file: &Path, place: &str) -> Result<(IndexedMap, Faults), Faults> {
    let read = read_level(file, work.catalog)?;
    let made = catch_bug(|| {
        let floor = LevelFloor::new(&read.level, &read.furnished, work.catalog, work.agent);
        (mesh(&read.building, &floor, work.agent), occupancy(&floor, work.arguments.resolution))
    });
    let (mesh, map) = made.map_err(|bug| {
        let fault = Fault::of_file(file, format!("the program failed on this level: {bug}"));
        Faults::from(fault.with_hint("this is a fault of roomwright; please report it with the file"))
    })?;
    let picture = format!("{place}{PICTURE}");
    let name_of_picture = picture.rsplit('/').next().expect("a path has a last part").to_owned();
    let contents = [
        (format!("{place}{MESH}"), document(&mesh)),
        (format!("{place}{MAP}"), map.description(&name_of_picture).into_bytes()),
        (picture, map.picture),
    ];
    let files = contents.into_iter().map(|(path, content)| write(work, path, &content));
    let files = files.collect::<Result<Vec<MapFile>, Faults>>()?;
    Ok((indexed(mesh, files), read.faults))
}

fn document(value: &impl Serialize) -> Vec<u8> {
    let mut content = serde_json::to_vec(value).expect("meshes are plain data");
    content.push(b'\n');
    content
}

fn write(work: &Work<'_>, path: String, content: &[u8]) -> Result<MapFile, Faults> {
    let target = work.arguments.out.join(&path);
    let sha256 = content_hash(content);
    let found = read_regular(&target, LARGEST_OWN).ok().map(|found| content_hash(&found));
    if found.as_ref() != Some(&sha256) {
        let is_own = found.is_some() && found.as_ref() == work.known.get(&path);
        write_bytes(&target, content, Overwrite::forced(work.arguments.force || is_own))?;
    }
    Ok(MapFile { path, bytes: content.len() as u64, sha256 })
}

fn indexed(mesh: MeshFile, files: Vec<MapFile>) -> IndexedMap {
    let unreached = mesh.unreached();
    IndexedMap {
        free: mesh.islands.iter().sum(),
        islands: u32::try_from(mesh.islands.len()).unwrap_or(u32::MAX),
        unreached,
        building: mesh.building,
        level: mesh.level,
        elevation: mesh.elevation,
        files,
    }
}

fn text(levels: &[IndexedMap], out: &Path) -> String {
    let free: f64 = levels.iter().map(|level| level.free).sum();
    let mut lines = vec![format!(
        "{}: {} with {free:.0} m² of free floor",
        out.join(INDEX).display(),
        counted(levels.len(), "level")
    )];
    for level in levels.iter().filter(|level| !level.unreached.is_empty()) {
        let names: Vec<&str> = level.unreached.iter().take(LISTED_ROOMS).map(String::as_str).collect();
        let more = if level.unreached.len() > LISTED_ROOMS { ", …" } else { "" };
        let count = counted(level.unreached.len(), "room");
        let (building, level) = (&level.building, &level.level);
        lines.push(format!(
            "  {building}/{level}: {count} not reached from the largest part of the floor: {}{more}",
            names.join(", ")
        ));
    }
    lines.join("\n")
}
