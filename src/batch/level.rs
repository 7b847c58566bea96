//! Bakes one level: furnishes its rooms, builds the scene, writes the files.

use rayon::prelude::*;

use crate::audit::{Finding, Verdict};
use crate::best::{Judged, best_of};
use crate::catalog::Catalog;
use crate::edits::{Finished, Misfit, finish};
use crate::layout::{FurnishOptions, Furnished, RoomLayout, room_style};
use crate::output::{LevelToWrite, SceneLook, TooLarge, WrittenLevel, output_format};
use crate::plan::Level;
use crate::scene::{LevelBounds, Scene, SceneInput, build_scene};
use crate::solve::RoomSolver;

use super::bug::catch_bug;
use super::context::Context;
use super::event::{LevelFailure, LevelMisfit, Stage};
use super::fault::{FaultCode, OutputFault};
use super::folder::OutputFolder;
use super::job::Job;
use super::record::{FileRecord, LevelKey, LevelRecord, RemovedRecord, RoomRecord, SiteRecord, Totals};
use super::task::Task;

/// A level that is in place.
pub(crate) struct BakedLevel {
    /// Its sums.
    pub(crate) totals: Totals,
    /// Bytes written.
    pub(crate) bytes: u64,
    /// Rooms that the program failed to furnish.
    pub(crate) failures: Vec<LevelFailure>,
    /// Edits that do not fit.
    pub(crate) misfits: Vec<LevelMisfit>,
}

/// One room on its way to the scene.
struct BakedRoom {
    furnished: Furnished,
    verdict: Verdict,
    misfits: Vec<Misfit>,
    failure: Option<String>,
}

/// Bakes one level: rooms, judgement, scene, bytes, files, record.
///
/// # Errors
/// Why the level is not in place.
pub(crate) fn bake_level(context: &Context<'_>, job: &Job<'_>) -> Result<BakedLevel, Box<LevelFailure>> {
    let level = job.homes.apply(job.level);
    let job = &Job { level: &level, ..job.clone() };
    // Rooms in parallel, collected in the plan's order: the file does not depend on which room is finished first.
    let rooms: Vec<BakedRoom> =
        (0..job.level.rooms.len()).into_par_iter().map(|room| bake_room(context, job, room)).collect();
    let mut results = RoomResults::default();
    rooms.into_iter().for_each(|room| results.add(room));

    // The tree of nodes, and what it becomes; what other levels refer to as well is put into place at once.
    let built = catch_bug(|| {
        let look = SceneLook::of(&context.options.level);
        let shown =
            |look: SceneLook| context.watch.measure(Stage::Scene, || scene(context, job, &results, look));
        let scene = shown(look);
        let bounds = LevelBounds::of(&scene, job.level.elevation);
        let level = LevelToWrite { scene: &scene, path: &job.path, shown: &shown };
        let written = context.watch.measure(Stage::Encoding, || context.output.level(&level));
        let written = written.map_err(|error| too_large(context, &job.path, error))?;
        let files = context.watch.measure(Stage::Writing, || LevelFiles::new(context, &job.path, written))?;
        Ok((files, bounds))
    });
    let (files, bounds) = match built {
        Ok(Ok(built)) => built,
        Ok(Err(fault)) => return Err(Box::new(level_failure(context, job, fault))),
        Err(bug) => return Err(Box::new(bug_failure(context, job, None, bug))),
    };

    // Files first, the record after them: what is recorded is there.
    let record = LevelRecord { bounds, ..record(context, job, &files, &results) };
    let written = context.watch.measure(Stage::Writing, || write(context.folder, &files, &record));
    written.map_err(|fault| Box::new(level_failure(context, job, fault)))?;
    Ok(BakedLevel {
        totals: record.totals,
        bytes: record.files.iter().map(|file| file.bytes).sum(),
        misfits: level_misfits(job, results.misfits),
        failures: room_failures(context, job, results.failures),
    })
}

/// The files of a level with their content, the one to open first.
pub(super) struct LevelFiles {
    pub(super) files: Vec<(FileRecord, Vec<u8>)>,
    /// Paths in the output folder of the shared files that they refer to.
    pub(super) shared: Vec<String>,
}

impl LevelFiles {
    /// Puts what a level shares with others into place, and hashes its own files.
    pub(super) fn new(
        context: &Context<'_>,
        path: &str,
        written: WrittenLevel<'_>,
    ) -> Result<Self, OutputFault> {
        let shared = written.shared.into_iter().map(|file| context.shared.put(file, context.folder));
        let shared = shared.collect::<Result<_, _>>()?;
        let record = |(extension, bytes)| FileRecord::with_bytes(format!("{path}.{extension}"), bytes);
        Ok(Self { files: written.files.into_iter().map(record).collect(), shared })
    }
}

pub(super) fn too_large(
    context: &Context<'_>,
    path: &str,
    TooLarge { message, hint }: TooLarge,
) -> OutputFault {
    let extension = output_format(context.options.level.format).extensions[0];
    let name = format!("{path}.{extension}");
    OutputFault {
        code: FaultCode::TooLarge,
        path: context.folder.root().join(name),
        message,
        hint: Some(hint.to_owned()),
    }
}

fn bake_room(context: &Context<'_>, job: &Job<'_>, room: usize) -> BakedRoom {
    catch_bug(|| furnish_room(context, job, room)).unwrap_or_else(|bug| BakedRoom {
        furnished: unfurnished(context, job, room),
        verdict: Verdict::default(),
        misfits: Vec::new(),
        failure: Some(bug),
    })
}

fn furnish_room(context: &Context<'_>, job: &Job<'_>, room: usize) -> BakedRoom {
    let Context { catalog, watch, .. } = context;
    let options = &context.options.level;
    let at = job.level.room(room);
    let edits = job.edits.and_then(|edits| edits.room(&at.room.id));
    let locks = edits.map(|edits| edits.locks(at, catalog)).unwrap_or_default();
    let run = FurnishOptions::new(options.seed, &job.placed.id).with_style(options.style.as_deref());
    let run = edits.map_or(run, |edits| edits.options(run, &locks));
    let layout = RoomLayout::new(at, catalog, &run);
    let solver = RoomSolver::new(at, catalog);
    let judge = |furnished: &Furnished| watch.measure(Stage::Audit, || solver.judge(furnished));
    let judged = best_of(
        options.effort,
        |alternative| watch.measure(Stage::Layout, || layout.furnish(alternative)),
        judge,
        |furnished| watch.measure(Stage::Audit, || solver.suggest_places(furnished)),
        || solver.steps(),
    );
    let Finished { judged: Judged { furnished, verdict, .. }, misfits } = match edits {
        Some(edits) => finish(at.level, judged, edits, catalog, judge),
        None => Finished { judged, misfits: Vec::new() },
    };
    BakedRoom { furnished, verdict, misfits, failure: None }
}

/// The bare room that stands in for one that could not be furnished.
fn unfurnished(context: &Context<'_>, job: &Job<'_>, room: usize) -> Furnished {
    let options = &context.options.level;
    let run = FurnishOptions::new(options.seed, &job.placed.id).with_style(options.style.as_deref());
    Furnished {
        room,
        seed: options.seed,
        style: room_style(job.level.room(room), context.catalog, &run),
        requested: 0,
        placements: Vec::new(),
        removals: Vec::new(),
    }
}

fn scene(context: &Context<'_>, job: &Job<'_>, rooms: &RoomResults, look: SceneLook) -> Scene {
    let catalog = context.catalog;

    build_scene(&SceneInput {
        level: job.level,
        building: &job.placed.id,
        attribution: job.placed.building.attribution.as_deref(),
        site: job.placed.site,
        furnished: &rooms.furnished,
        verdicts: &rooms.verdicts,
        catalog,
        models: &|of, geometry| context.models.model_in_detail(of, geometry, look.detail),
        swatches: context.swatched.as_ref().filter(|_| !look.is_plain),
        options: look.options(context.options.level.scene),
        textures: context.textures.as_ref().filter(|_| !look.is_plain),
        seed: context.options.level.seed,
        style: context.options.level.style.as_deref(),
    })
}

/// Puts the files of a level into place and records them.
pub(super) fn write(
    folder: &OutputFolder,
    files: &LevelFiles,
    record: &LevelRecord,
) -> Result<(), OutputFault> {
    folder.announce(&record.files)?;
    folder.place_level(&files.files)?;
    folder.record(record)?;
    folder.retire_replaced(record)
}

/// The results for the rooms of a level, in the plan's order.
#[derive(Default)]
struct RoomResults {
    furnished: Vec<Furnished>,
    verdicts: Vec<Verdict>,
    misfits: Vec<Vec<Misfit>>,
    failures: Vec<Option<String>>,
}

impl RoomResults {
    fn add(&mut self, room: BakedRoom) {
        self.furnished.push(room.furnished);
        self.verdicts.push(room.verdict);
        self.misfits.push(room.misfits);
        self.failures.push(room.failure);
    }
}

fn record(context: &Context<'_>, job: &Job<'_>, files: &LevelFiles, rooms: &RoomResults) -> LevelRecord {
    let site = job.placed.site;
    let mut record = LevelRecord {
        building: job.placed.id.clone(),
        level: job.level.id.clone(),
        program: None,
        inputs: job.inputs.clone(),
        seed: context.options.level.seed,
        site: SiteRecord { position: [site.position.x, site.position.y], turn: site.turn },
        bounds: None,
        files: files.files.iter().map(|(file, _)| file.clone()).collect(),
        library: files.shared.clone(),
        totals: Totals { rooms: rooms.furnished.len() as u64, ..Totals::default() },
        classes: std::collections::BTreeMap::new(),
        left_out: job.level.left_out.clone(),
        attribution: job.placed.building.attribution.clone(),
        rooms: Vec::new(),
    };
    for room in 0..rooms.furnished.len() {
        count_room(&mut record, context.catalog, &rooms.furnished[room]);
        record.totals.audit.add_room(&rooms.verdicts[room]);
        record.totals.broken += u64::from(rooms.failures[room].is_some());
        let unmade = rooms.misfits[room].iter().filter(|misfit| !misfit.is_made).count();
        record.totals.misfits += unmade as u64;
        record.rooms.extend(room_record(job.level, context.catalog, rooms, room));
    }
    record
}

fn count_room(record: &mut LevelRecord, catalog: &Catalog, furnished: &Furnished) {
    record.totals.requested += u64::from(furnished.requested);
    record.totals.placed += furnished.placements.len() as u64;
    record.totals.removed += furnished.removals.len() as u64;
    for placement in &furnished.placements {
        let class = &catalog.classes[placement.class].id;
        match record.classes.get_mut(class) {
            Some(count) => *count += 1,
            None => drop(record.classes.insert(class.clone(), 1)),
        }
    }
}

fn room_record(level: &Level, catalog: &Catalog, rooms: &RoomResults, room: usize) -> Option<RoomRecord> {
    let (furnished, verdict, misfits) = (&rooms.furnished[room], &rooms.verdicts[room], &rooms.misfits[room]);
    let is_broken = rooms.failures[room].is_some();
    let has_misfits = !misfits.is_empty();
    if furnished.removals.is_empty() && verdict.findings.is_empty() && !is_broken && !has_misfits {
        return None;
    }
    let removed = furnished.removals.iter().map(|removal| RemovedRecord {
        class: catalog.classes[removal.class].id.clone(),
        reason: removal.reason.name().to_owned(),
    });
    Some(RoomRecord {
        room: level.rooms[furnished.room].id.clone(),
        grade: (!is_broken).then(|| verdict.grade()),
        score: verdict.score.map(|score| score.value),
        removed: removed.collect(),
        findings: verdict.findings.iter().map(Finding::extras).collect(),
        misfits: misfits.iter().map(|misfit| misfit.fault.message.clone()).collect(),
        failure: is_broken.then(|| FaultCode::RoomBroken.name().to_owned()),
    })
}

fn level_misfits(job: &Job<'_>, misfits: Vec<Vec<Misfit>>) -> Vec<LevelMisfit> {
    let of_room = |(room, misfits): (usize, Vec<Misfit>)| {
        misfits.into_iter().map(move |misfit| LevelMisfit {
            building: job.placed.id.clone(),
            level: job.level.id.clone(),
            room: job.level.rooms[room].id.clone(),
            misfit,
        })
    };
    misfits.into_iter().enumerate().flat_map(of_room).collect()
}

fn room_failures(context: &Context<'_>, job: &Job<'_>, failures: Vec<Option<String>>) -> Vec<LevelFailure> {
    let failure = |(room, bug): (usize, Option<String>)| {
        let room = job.level.rooms[room].id.clone();
        bug.map(|bug| bug_failure(context, job, Some(room), bug))
    };
    failures.into_iter().enumerate().filter_map(failure).collect()
}

/// The failure of a level, or of one of its rooms, by a fault of the program.
pub(super) fn bug_failure(
    context: &Context<'_>,
    task: &impl Task,
    room: Option<String>,
    bug: String,
) -> LevelFailure {
    let LevelKey { building, level } = task.key();
    LevelFailure {
        building,
        level,
        code: if room.is_some() { FaultCode::RoomBroken } else { FaultCode::LevelBroken },
        room,
        message: format!("the program failed: {bug}"),
        hint: Some("this is a fault of roomwright; please report it with these ids and the seed".to_owned()),
        seed: context.options.level.seed,
    }
}

/// The failure of a level that cannot be written.
pub(super) fn level_failure(context: &Context<'_>, task: &impl Task, fault: OutputFault) -> LevelFailure {
    let LevelKey { building, level } = task.key();
    LevelFailure {
        building,
        level,
        room: None,
        code: fault.code,
        message: fault.to_string(),
        hint: fault.hint,
        seed: context.options.level.seed,
    }
}
