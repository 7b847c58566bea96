//! Turns arguments into a job and its exit code; the only folder that prints.

mod answer;
mod arguments;
mod audit;
mod bake;
mod catalog;
mod check;
mod diff;
mod draw;
mod edits;
mod exit;
mod explain;
mod files;
mod find_room;
mod formats;
mod import;
mod import_report;
mod init;
mod kept_furniture;
mod leftovers;
mod level_lists;
mod man;
mod merge;
mod navigation;
mod plan;
mod progress;
mod reroll;
mod room_styles;
#[cfg(test)]
mod schemas;
mod screen;
mod sources;
mod summary;
mod tiles;
mod update;
mod usage;
mod version;
mod view;
mod walk;
mod watch;

use clap::Parser;
use clap::error::ErrorKind;

use arguments::{Arguments, Command};
pub use exit::Outcome;
use screen::{Screen, is_result_lost};

/// Runs the command line of this process. Whatever else went well: a result that was lost is a failure.
#[must_use]
pub fn run() -> Outcome {
    crate::batch::collect_panics();
    tell_of_large_files();
    bound_threads();
    let outcome = run_command();
    if is_result_lost() { outcome.and(Outcome::NotStarted) } else { outcome }
}

fn run_command() -> Outcome {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if is_about_version(&error) => {
            return version::show(Screen { is_quiet: false, is_json: true });
        }
        Err(error) => return usage::show(error),
    };
    let screen = Screen { is_quiet: arguments.manner.quiet, is_json: arguments.manner.json };
    match arguments.command.unwrap_or_else(demo) {
        Command::Bake(arguments) => bake::run(arguments, screen),
        Command::Check(arguments) => check::run(&arguments, screen),
        Command::Catalog(arguments) => catalog::run(&arguments, screen),
        Command::Audit(arguments) => audit::run(&arguments, screen),
        Command::Diff(arguments) => diff::run(&arguments, screen),
        Command::Draw(arguments) => draw::run(&arguments, screen),
        Command::Edits { command } => edits::run(command, screen),
        Command::Explain(arguments) => explain::run(&arguments, screen),
        Command::Formats => formats::run(screen),
        Command::Import(arguments) => import::run(arguments, screen),
        Command::Plan(arguments) => plan::run(arguments, screen),
        Command::Merge(arguments) => merge::run(&arguments, screen),
        Command::Init(arguments) => init::run(&arguments, screen),
        Command::Tiles(arguments) => tiles::run(arguments, screen),
        Command::Navigation(arguments) => navigation::run(&arguments, screen),
        Command::View(arguments) => view::run(arguments, screen),
        Command::Walk(arguments) => walk::run(&arguments, screen),
        Command::Completions(arguments) => man::run_completions(arguments, screen),
        Command::Man(arguments) => man::run_man(&arguments, screen),
    }
}

/// Whether `--version` was asked for as JSON.
fn is_about_version(error: &clap::Error) -> bool {
    error.kind() == ErrorKind::DisplayVersion && version::asks_for_json(std::env::args_os())
}

/// The action without arguments: the program bakes the demo, so that the first result a new user sees
/// is furniture.
fn demo() -> Command {
    let typed = Arguments::parse_from(["roomwright", "bake"]);
    typed.command.expect("a command was given")
}

/// Threads of the largest pool that a command makes, as of `--threads`.
const MOST_THREADS: usize = 1024;

/// A slip in the variable that sets the threads of a pool by itself must not ask the system for millions of them.
fn bound_threads() {
    let asked = std::env::var("RAYON_NUM_THREADS").ok().and_then(|text| text.parse::<usize>().ok());
    if asked.is_some_and(|threads| threads > MOST_THREADS) {
        // It fails only where there is a pool already, and then there is nothing to bound.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(MOST_THREADS).build_global();
    }
}

/// A file that may not grow further (`ulimit -f`) is an error of the write; by itself it would kill the process without a word.
fn tell_of_large_files() {
    // Where the signal cannot be taken, it kills as it did.
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
}
