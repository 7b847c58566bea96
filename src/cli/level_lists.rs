//! Levels as lists, for drivers that share them out by name.

use std::path::Path;

use super::bake::{Request, understand};
use super::exit::Outcome;
use super::screen::Screen;
use super::watch::Inputs;
use crate::batch::{BakeInput, planned_levels};
use crate::document::Fault;
use crate::output::{INDEX_NAME, output_format};
use crate::project::Project;

/// A fault if levels are to be shared out by name that need files over all of them: no share knows the others.
pub(super) fn shares_without_index(request: &Request) -> Option<Fault> {
    let run = &request.run;
    let asked = [("--list-levels", run.list_levels), ("--only-levels", run.only_levels.is_some())];
    let (option, _) = asked.into_iter().find(|(_, is_asked)| *is_asked)?;
    let format = request.level.format;
    output_format(format).has_index.then(|| {
        let message = format!(
            "does not go with the format {}, whose {INDEX_NAME} is made of all levels",
            format.name()
        );
        Fault::of_file(Path::new(option), message).with_hint(AFTERWARDS)
    })
}

/// Advice where files over all levels cannot be written by shares.
const AFTERWARDS: &str = "bake in another format, join the shares, and write the tiles from the finished bake: `roomwright tiles OUT`";

/// Lists the levels that would be written.
pub(super) fn list_levels(request: Request, screen: Screen) -> Outcome {
    let typed = request.run.sources.clone();
    let run = match understand(request, screen) {
        Ok(run) => run,
        Err(outcome) => return outcome,
    };
    let Project { plan, edits, catalog, models, faults, .. } = &run.sources;
    // The demo's plans are gone when the program ends.
    let is_read = !run.teller.is_demo;
    let sources = is_read.then(|| Inputs::of_reading(&typed, Ok((plan, faults))).found());
    let input = BakeInput { plan, edits, catalog, models, options: &run.options };
    let list = planned_levels(&input, sources.unwrap_or_default());
    if screen.is_json {
        screen.json(&list);
    } else {
        for level in &list.levels {
            let rooms: Vec<String> =
                level.rooms.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
            screen.result(&format!("{}/{}: {}", level.building, level.level, rooms.join(", ")));
        }
    }
    Outcome::of_failures(run.teller.has_input_faults)
}
