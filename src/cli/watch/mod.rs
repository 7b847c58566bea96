//! `bake --watch`: bakes, waits until an input changes, and bakes again.
//!
//! The folders of all inputs are watched before a bake reads them, so that no change is missed. A fault in a file does
//! not end the watching, for the file is an input, too.

mod inputs;
mod watcher;

use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use super::arguments::BakeArguments;
use super::bake::bake_once;
use super::exit::Outcome;
use super::screen::Screen;
use crate::document::{Fault, Faults};
pub(crate) use inputs::Inputs;
use watcher::{Change, FolderWatcher};

/// Time without a change after which a burst of them is over: editors write a file in several steps.
const QUIET: Duration = Duration::from_millis(200);

/// The same for somebody who looks at the screen.
const SHORT_QUIET: Duration = Duration::from_millis(40);

/// Longest burst: inputs that change all the time are baked now and then.
const LONGEST_BURST: Duration = Duration::from_secs(3);

/// Bakes until Ctrl-C ends the process with exit code 0.
pub(super) fn watch(arguments: &BakeArguments, screen: Screen) -> Outcome {
    // Files appear whole or not at all: an interrupted bake leaves nothing that the next one does not take over.
    let is_handled = ctrlc::set_handler(|| std::process::exit(Outcome::Done as i32)).is_ok();
    let ended = watch_all(arguments, screen, if is_handled { "; Ctrl-C ends" } else { "" });
    screen.faults(&ended);
    Outcome::NotStarted
}

/// Ends only where nothing can be watched, and says why.
fn watch_all(arguments: &BakeArguments, screen: Screen, how_to_end: &str) -> Faults {
    let mut watcher = FolderWatcher::default();
    loop {
        let inputs = Inputs::of(arguments);
        if inputs.is_empty() {
            let fault =
                Fault::of_file(&arguments.run.sources.paths[0], "is in no folder that can be watched");
            return fault.with_hint("check the path").into();
        }
        let changes = match watcher.watch(&inputs) {
            Ok(changes) => changes,
            Err(faults) => return faults,
        };
        bake_once(arguments.clone(), screen);
        screen.note(&format!("Watching {} files and folders{how_to_end}.", inputs.count()));
        match next_change(changes, &inputs, QUIET) {
            Some(name) => screen.note(&format!("{name} changed: baking again.")),
            None => {
                return Fault::of_file(&arguments.run.sources.paths[0], "can no longer be watched").into();
            }
        }
    }
}

/// Calls `read`, which says what it has read, once the inputs are watched and after each change of them, with less patience than a
/// bake has; ends where nothing can be watched any more, and says why.
pub(super) fn watch_inputs(place: &Path, mut inputs: Inputs, read: impl Fn() -> Inputs) -> Faults {
    let mut watcher = FolderWatcher::default();
    loop {
        if inputs.is_empty() {
            return Fault::of_file(place, "is in no folder that can be watched").into();
        }
        let changes = match watcher.watch(&inputs) {
            Ok(changes) => changes,
            Err(faults) => return faults,
        };
        let watched = inputs.folders();
        // What changed before these folders were watched is read now.
        inputs = read();
        while inputs.folders() == watched {
            if next_change(changes, &inputs, SHORT_QUIET).is_none() {
                return Fault::of_file(place, "can no longer be watched").into();
            }
            inputs = read();
        }
    }
}

/// Waits for a change of an input and the end of its burst; the name of the first file that changed, or nothing if nobody
/// watches any more.
fn next_change(changes: &Receiver<Change>, inputs: &Inputs, quiet: Duration) -> Option<String> {
    let first = loop {
        match changes.recv().ok()? {
            Change::Of(path) if inputs.contains(&path) => break inputs.show(&path),
            Change::Of(_) => {}
            Change::Unknown => break "something".to_owned(),
        }
    };
    let started = Instant::now();
    while started.elapsed() < LONGEST_BURST {
        match changes.recv_timeout(quiet) {
            Ok(_) => {}
            Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => break,
        }
    }
    Some(first)
}
