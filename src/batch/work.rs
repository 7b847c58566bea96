//! The work loop: threads take the next level until none is left.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::chosen::chosen_among;
use super::context::Context;
use super::event::{BakeReport, Event, LevelFailure, LevelMisfit, Observer, Stage, Stopwatch};
use super::fault::{FaultCode, OutputFault};
use super::folder::OutputFolder;
use super::in_place::is_in_place;
use super::job::list_jobs;
use super::join::Planned;
use super::level::{BakedLevel, bake_level};
use super::options::BakeOptions;
use super::program::PROGRAM;
use super::record::{FileRecord, LevelKey, Totals};
use super::shared::SharedFiles;
use super::sources::{Contents, RecordHead};
use super::task::Task;
use super::unplanned::Leftovers;
use crate::catalog::Catalog;
use crate::disk::look_inside;
use crate::edits::EditBook;
use crate::model::ModelLibrary;
use crate::output::output_format;
use crate::plan::Plan;

/// The input of a bake.
#[derive(Clone, Copy, Debug)]
pub struct BakeInput<'a> {
    /// The buildings.
    pub plan: &'a Plan,
    /// The edits of their rooms.
    pub edits: &'a EditBook,
    /// The catalogue.
    pub catalog: &'a Catalog,
    /// The models of that catalogue.
    pub models: &'a ModelLibrary,
    /// Everything else that the output depends on.
    pub options: &'a BakeOptions,
}

/// Bakes all levels of a plan, or of this shard, into a folder.
///
/// One bad room or level does not stop the others; see [`BakeReport::failures`]. The files do not depend on
/// the number of threads or the order of the plan's buildings.
///
/// # Errors
/// If the threads cannot be started, or the plan lacks levels that were chosen by name.
pub fn bake(
    input: &BakeInput<'_>,
    folder: &OutputFolder,
    observer: &Observer<'_>,
) -> Result<BakeReport, OutputFault> {
    let &BakeInput { plan, edits, catalog, models, options } = input;
    let jobs = list_jobs(plan, edits, catalog, &options.level);
    let begin = |pool: &rayon::ThreadPool, has_work: bool| {
        let output = (output_format(options.level.format).begin)(catalog, &options.level);
        let textures = options.level.texture_library(options.cache.clone()).filter(|_| has_work);
        let watch = Stopwatch::default();
        if let Some(textures) = &textures {
            watch.measure(Stage::Scene, || pool.install(|| textures.paint_all()));
        }
        let shared = SharedFiles::default();
        let swatched = options.level.swatches(catalog).filter(|_| has_work);
        Context { catalog, options, folder, models, swatched, output, textures, shared, watch }
    };
    write_all(&jobs, &Run { options, folder, observer }, &begin, &bake_level)
}

/// Where and how levels are written.
#[derive(Clone, Copy)]
pub(super) struct Run<'a> {
    pub(super) options: &'a BakeOptions,
    pub(super) folder: &'a OutputFolder,
    pub(super) observer: &'a Observer<'a>,
}

/// Writes a level of a kind of task.
pub(super) type Writer<'w, T> = dyn Fn(&Context<'_>, &T) -> Result<BakedLevel, Box<LevelFailure>> + Sync + 'w;

/// Writes all levels, or those of this shard, and joins their records. `begin` makes what they share, on the threads of the run; it
/// is told whether any is left to write.
pub(super) fn write_all<'a, T: Task>(
    jobs: &[T],
    run: &Run<'_>,
    begin: &dyn Fn(&rayon::ThreadPool, bool) -> Context<'a>,
    write: &Writer<'_, T>,
) -> Result<BakeReport, OutputFault> {
    // The levels of this share; those that are up to date are kept.
    let &Run { options, folder, observer } = run;
    let is_ours = share_of(jobs, options)?;
    let share = jobs.iter().zip(is_ours).filter(|(_, is_ours)| *is_ours).map(|(job, _)| job);
    let (kept, open): (Vec<&T>, Vec<&T>) = share.partition(|job| folder.is_current(*job));
    let rooms = open.iter().map(|job| job.room_count()).sum();
    observer(&Event::Started { levels: open.len(), rooms, kept: kept.len() });

    // The others are baked.
    let pool = thread_pool(options, folder.root())?;
    let context = begin(&pool, !open.is_empty());
    let tally = work(&pool, &open, &|job| write(&context, job), observer);

    // The records become the manifest.
    let (joined, leftovers) = folder
        .finish(&Planned {
            levels: jobs.iter().map(Task::key).collect(),
            shard: options.shard,
            unplanned: options.unplanned,
            index: &|levels| context.output.index(levels, &options.index),
            is_whole: &|contents| {
                options.only_levels.is_none() && jobs.iter().all(|job| is_recorded(contents, job))
            },
        })
        .map_or_else(|fault| (Err(fault), Leftovers::default()), |(joined, found)| (Ok(joined), found));
    let mut in_place = tally.totals.clone();
    kept.iter().for_each(|job| in_place.add(&folder.known.levels[&job.key()].1.totals));
    let done = tally.baked + tally.failed_levels;
    Ok(BakeReport {
        baked: tally.baked,
        kept: kept.len(),
        skipped: open.len() - done,
        failures: tally.failures,
        misfits: tally.misfits,
        written: tally.totals,
        in_place,
        bytes: tally.bytes,
        timings: context.watch.timings(),
        joined,
        leftovers,
    })
}

/// Whether each job is one of this share.
fn share_of<T: Task>(jobs: &[T], options: &BakeOptions) -> Result<Vec<bool>, OutputFault> {
    let is_dealt = |index: usize| options.shard.is_none_or(|shard| shard.takes(index));
    let dealt = || Ok((0..jobs.len()).map(is_dealt).collect());
    options.only_levels.as_ref().map_or_else(dealt, |chosen| chosen_among(chosen, jobs))
}

/// The work of all threads so far. Sums only: the order in which levels finish leaves no trace.
#[derive(Default)]
struct Tally {
    baked: usize,
    failed_levels: usize,
    totals: Totals,
    bytes: u64,
    failures: Vec<LevelFailure>,
    misfits: Vec<LevelMisfit>,
}

/// Each thread takes the next level until none is left, so that no more levels are in memory than there are
/// threads. A thread that finds none left helps the others with their rooms.
fn work<T: Task>(
    pool: &rayon::ThreadPool,
    jobs: &[&T],
    write: &(dyn Fn(&T) -> Result<BakedLevel, Box<LevelFailure>> + Sync),
    observer: &Observer<'_>,
) -> Tally {
    let next = AtomicUsize::new(0);
    let is_stopped = AtomicBool::new(false);
    let tally = Mutex::new(Tally::default());
    // A broadcast runs once on every thread; a plain `spawn` per thread could be picked up by a thread
    // that waits for rooms of its own level, and that level would then stay in memory to the end.
    pool.broadcast(|_| {
        while !is_stopped.load(Ordering::Relaxed) {
            let Some(job) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            let result = write(job);
            tell(observer, &job.key(), &result);
            if result.as_ref().is_err_and(|failure| failure.code.stops_the_run()) {
                is_stopped.store(true, Ordering::Relaxed);
            }
            tally.lock().expect("counting does not panic").add(result);
        }
    });
    let mut tally = tally.into_inner().expect("counting does not panic");
    tally.failures.sort();
    let key = |misfit: &LevelMisfit| (misfit.building.clone(), misfit.level.clone(), misfit.room.clone());
    // Stable: the rejected edits of a room stay in their order.
    tally.misfits.sort_by_cached_key(key);
    tally
}

impl Tally {
    fn add(&mut self, result: Result<BakedLevel, Box<LevelFailure>>) {
        match result {
            Ok(level) => {
                self.baked += 1;
                self.totals.add(&level.totals);
                self.bytes += level.bytes;
                self.failures.extend(level.failures);
                self.misfits.extend(level.misfits);
            }
            Err(failure) => {
                self.failed_levels += 1;
                self.failures.push(*failure);
            }
        }
    }
}

fn tell(observer: &Observer<'_>, key: &LevelKey, result: &Result<BakedLevel, Box<LevelFailure>>) {
    match result {
        Ok(baked) => {
            for failure in &baked.failures {
                observer(&Event::Failed(failure));
            }
            let LevelKey { building, level } = key;
            observer(&Event::Baked { building, level, totals: &baked.totals });
        }
        Err(failure) => observer(&Event::Failed(failure)),
    }
}

fn thread_pool(options: &BakeOptions, root: &Path) -> Result<rayon::ThreadPool, OutputFault> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads.max(1)).build();
    pool.map_err(|error| OutputFault {
        code: FaultCode::NoThreads,
        path: root.to_owned(),
        message: format!("cannot start {} threads: {error}", options.threads),
        hint: Some("use a smaller number with --threads".to_owned()),
    })
}

impl OutputFolder {
    /// Whether a level is in place, made from the same inputs by the same program.
    fn is_current(&self, job: &impl Task) -> bool {
        let Some((program, head)) = self.known.levels.get(&job.key()) else { return false };
        let library: BTreeSet<&String> = head.library.iter().collect();
        let library = self.known.library.values().filter(|file| library.contains(&file.path));
        is_up_to_date(program, head, job)
            && library.clone().count() == head.library.len()
            && head.files.iter().chain(library).all(|file| self.is_untouched(file))
    }

    /// Whether a file is as it was recorded. To read all files of a city would take longer than to read its plans,
    /// so a file of the right length that is older than the manifest is trusted; any other is read and compared.
    /// The file system's times decide only how much is read: no output depends on them.
    fn is_untouched(&self, file: &FileRecord) -> bool {
        let Ok(Some(found)) = look_inside(&self.root, &file.path) else { return false };
        if found.len() != file.bytes {
            return false;
        }
        // At the same tick of the clock the order of two writes is not known.
        let times = found.modified().ok().zip(self.known.recorded);
        let is_older = times.is_some_and(|(modified, recorded)| modified < recorded);
        is_older || is_in_place(&self.root, std::slice::from_ref(file))
    }
}

/// Whether the newest record of a level is of these inputs and this program.
fn is_recorded(contents: &Contents<'_>, job: &impl Task) -> bool {
    let newest = contents.levels.get(&job.key()).and_then(|found| found.last());
    newest.is_some_and(|found| is_up_to_date(&found.program, &found.head, job))
}

fn is_up_to_date(program: &str, head: &RecordHead, job: &impl Task) -> bool {
    program == PROGRAM && head.inputs == job.inputs() && head.totals.broken == 0
}
