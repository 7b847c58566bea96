//! Watches folders, and reports changed files.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use notify::{Config, Event, EventKind, PollWatcher, RecommendedWatcher, RecursiveMode, Watcher};

use super::inputs::Inputs;
use crate::document::{Fault, Faults};

/// Time between two looks at folders for which the system reports no changes.
const LOOK_INTERVAL: Duration = Duration::from_secs(1);

/// Something that happened in a watched folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Change {
    /// A file was written, made, renamed or deleted.
    Of(PathBuf),
    /// The system lost count.
    Unknown,
}

/// Watches folders.
#[derive(Default)]
pub(super) struct FolderWatcher {
    folders: BTreeSet<(PathBuf, bool)>,
    running: Option<(Box<dyn Watcher>, Receiver<Change>)>,
}

impl FolderWatcher {
    /// Watches the folders of inputs from now on. Earlier changes are not reported: read the inputs afterwards.
    ///
    /// # Errors
    /// If the system watches none of them.
    pub(super) fn watch(&mut self, inputs: &Inputs) -> Result<&Receiver<Change>, Faults> {
        let folders = inputs.folders();
        if self.running.is_none() || folders != self.folders {
            self.running = Some(start(&folders)?);
            self.folders = folders;
        }
        let (_, changes) = self.running.as_ref().expect("it was started above");
        Ok(changes)
    }
}

/// A watcher of the system's own kind, or, where that has no room for more folders, one that looks by itself.
fn start(folders: &BTreeSet<(PathBuf, bool)>) -> Result<(Box<dyn Watcher>, Receiver<Change>), Faults> {
    let config = Config::default().with_poll_interval(LOOK_INTERVAL).with_compare_contents(true);
    start_kind::<RecommendedWatcher>(folders, config)
        .or_else(|_| start_kind::<PollWatcher>(folders, config))
        .map_err(|error| {
            let folder = error.paths.first().or(folders.first().map(|(folder, _)| folder)).cloned();
            let message = format!("cannot be watched: {error}");
            Fault::of_file(&folder.unwrap_or_default(), message)
                .with_hint("check the rights of the folder")
                .into()
        })
}

fn start_kind<W: Watcher + 'static>(
    folders: &BTreeSet<(PathBuf, bool)>,
    config: Config,
) -> notify::Result<(Box<dyn Watcher>, Receiver<Change>)> {
    let (sender, changes) = channel();
    let mut watcher = W::new(move |event| pass_on(event, &sender), config)?;
    for (folder, is_tree) in folders {
        let mode = if *is_tree { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive };
        watcher.watch(folder, mode)?;
    }
    Ok((Box::new(watcher), changes))
}

/// Sends the changed paths; a receiver that has ended is no fault.
fn pass_on(event: notify::Result<Event>, sender: &Sender<Change>) {
    match event {
        // Reading is no change, and a bake reads.
        Ok(event) if matches!(event.kind, EventKind::Access(_)) => {}
        Ok(event) if event.need_rescan() => drop(sender.send(Change::Unknown)),
        Ok(event) => event.paths.into_iter().for_each(|path| drop(sender.send(Change::Of(path)))),
        Err(_) => drop(sender.send(Change::Unknown)),
    }
}
