//! Writes the levels of a finished bake in another format: what is in its files now, whoever edited them since.

use std::path::Path;

use super::bug::catch_bug;
use super::coarser::CoarserModels;
use super::context::Context;
use super::event::{BakeReport, LevelFailure, Observer, Stage, Stopwatch};
use super::fault::{FaultCode, OutputFault};
use super::folder::OutputFolder;
use super::level::{BakedLevel, LevelFiles, bug_failure, level_failure, too_large, write};
use super::manifest::MANIFEST_NAME;
use super::options::BakeOptions;
use super::record::{LevelKey, LevelRecord};
use super::shared::SharedFiles;
use super::sources::Sources;
use super::task::Task;
use super::work::{Run, write_all};
use crate::catalog::Catalog;
use crate::contract::Extras;
use crate::disk::{FieldHash, file_hash, open_inside};
use crate::document::Fault;
use crate::model::{Detail, ModelLibrary};
use crate::model_file::read_scene;
use crate::output::{LevelToWrite, SceneLook, is_read_back, output_format};
use crate::scene::{LevelBounds, Scene};

/// The input of [`write_finished`].
pub(crate) struct FinishedInput<'a> {
    /// The folder of the bake.
    pub(crate) bake: &'a Path,
    /// What formats ask of a run; nothing is furnished.
    pub(crate) catalog: &'a Catalog,
    /// As for the catalogue.
    pub(crate) models: &'a ModelLibrary,
    /// Everything else that the output depends on.
    pub(crate) options: &'a BakeOptions,
}

/// A level of the bake.
struct FinishedLevel<'a> {
    bake: &'a Path,
    coarser: &'a CoarserModels,
    record: LevelRecord,
    inputs: String,
}

impl Task for FinishedLevel<'_> {
    fn key(&self) -> LevelKey {
        self.record.key()
    }

    fn inputs(&self) -> &str {
        &self.inputs
    }

    fn room_count(&self) -> usize {
        usize::try_from(self.record.totals.rooms).unwrap_or(usize::MAX)
    }
}

/// Writes the levels that the manifest of a bake lists.
///
/// One bad level does not stop the others; see [`BakeReport::failures`].
///
/// # Errors
/// If the manifest cannot be read or lists no level that can be read back, or the threads cannot be started.
pub(crate) fn write_finished(
    input: &FinishedInput<'_>,
    folder: &OutputFolder,
    observer: &Observer<'_>,
) -> Result<BakeReport, OutputFault> {
    let &FinishedInput { bake, catalog, models, options } = input;
    let coarser = CoarserModels::default();
    let levels = list(bake, &coarser, options)?;
    let begin = |_: &rayon::ThreadPool, _| Context {
        catalog,
        options,
        folder,
        models,
        swatched: None,
        output: (output_format(options.level.format).begin)(catalog, &options.level),
        textures: None,
        shared: SharedFiles::default(),
        watch: Stopwatch::default(),
    };
    write_all(&levels, &Run { options, folder, observer }, &begin, &write_level)
}

fn list<'a>(
    bake: &'a Path,
    coarser: &'a CoarserModels,
    options: &BakeOptions,
) -> Result<Vec<FinishedLevel<'a>>, OutputFault> {
    let manifest = bake.join(MANIFEST_NAME);
    let fault = |error: std::io::Error| OutputFault::of(&manifest, "read the manifest", &error);
    let sources = Sources::read(std::slice::from_ref(&manifest), &[])?;
    let contents = sources.contents(false)?;
    let records: std::io::Result<Vec<LevelRecord>> =
        contents.current().map(|(_, found)| found.read()).collect();
    let mut levels = Vec::new();
    for record in records.map_err(fault)? {
        if !record.files.first().is_some_and(|file| is_read_back(Path::new(&file.path))) {
            continue;
        }
        let inputs = inputs(bake, &record, options)?;
        levels.push(FinishedLevel { bake, coarser, record, inputs });
    }
    if levels.is_empty() {
        return Err(OutputFault {
            code: FaultCode::NothingToJoin,
            path: manifest,
            message: "lists no level in a format that is read back".to_owned(),
            hint: Some("name a folder that `roomwright bake` wrote .glb or .gltf files into".to_owned()),
        });
    }
    Ok(levels)
}

/// Hash of what a level is made from: its files as they are, and the options. Shared files have the hash of their content in their
/// name.
fn inputs(bake: &Path, record: &LevelRecord, options: &BakeOptions) -> Result<String, OutputFault> {
    let mut hash = FieldHash::new("finished level");
    hash.field(&serde_json::to_vec(&options.level).expect("options are plain data"));
    hash.field(record.building.as_bytes()).field(record.level.as_bytes());
    for number in [record.site.position[0], record.site.position[1], record.site.turn] {
        hash.field(&number.to_le_bytes());
    }
    if let Some(attribution) = &record.attribution {
        hash.field(b"attribution").field(attribution.as_bytes());
    }
    for file in &record.files {
        let fault = |error| OutputFault::of(&bake.join(&file.path), "read the file", &error);
        let content = match open_inside(bake, &file.path).map_err(fault)? {
            Some((opened, _)) => file_hash(opened).map_err(fault)?,
            // Told when the level is written.
            None => String::new(),
        };
        hash.field(content.as_bytes());
    }
    Ok(hash.finish())
}

fn write_level(context: &Context<'_>, level: &FinishedLevel<'_>) -> Result<BakedLevel, Box<LevelFailure>> {
    let of_bug = |bug: String| Box::new(bug_failure(context, level, None, bug));
    let of_fault = |fault: OutputFault| Box::new(level_failure(context, level, fault));
    let main = &level.record.files[0].path;
    let read = catch_bug(|| context.watch.measure(Stage::Scene, || read_scene(&level.bake.join(main))));
    let scene = match read {
        Ok(Ok(scene)) => scene,
        Ok(Err(Fault { message, hint, .. })) => {
            let path = level.bake.join(main);
            return Err(of_fault(OutputFault { code: FaultCode::LevelBroken, path, message, hint }));
        }
        Err(bug) => return Err(of_bug(bug)),
    };
    // The name that the bake chose for it.
    let path = main.rsplit_once('.').map_or(main.as_str(), |(path, _)| path);
    let shown = |look: SceneLook| match look.detail {
        Detail::Full => scene.clone(),
        Detail::Reduced => level.coarser.reduced(&scene),
        Detail::Boxes => level.coarser.boxes(&scene, context.catalog),
    };
    let to_write = LevelToWrite { scene: &scene, path, shown: &shown };
    let encoded = catch_bug(|| context.watch.measure(Stage::Encoding, || context.output.level(&to_write)));
    let written = match encoded {
        Ok(Ok(written)) => written,
        Ok(Err(error)) => return Err(of_fault(too_large(context, path, error))),
        Err(bug) => return Err(of_bug(bug)),
    };
    let files = LevelFiles::new(context, path, written).map_err(of_fault)?;
    let record = LevelRecord {
        program: None,
        inputs: level.inputs.clone(),
        bounds: LevelBounds::of(&scene, elevation(&scene)),
        files: files.files.iter().map(|(file, _)| file.clone()).collect(),
        library: files.shared.clone(),
        ..level.record.clone()
    };
    let written = context.watch.measure(Stage::Writing, || write(context.folder, &files, &record));
    written.map_err(of_fault)?;
    Ok(BakedLevel {
        totals: record.totals,
        bytes: record.files.iter().map(|file| file.bytes).sum(),
        failures: Vec::new(),
        misfits: Vec::new(),
    })
}

/// Metres of the level's floor above the building's zero.
fn elevation(scene: &Scene) -> f64 {
    match &scene.root.extras {
        Some(Extras::Level(level)) => level.elevation,
        _ => 0.0,
    }
}
