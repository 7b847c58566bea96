//! `man` and `completions`: print the definition of the command line for other programs.

use std::path::{Path, PathBuf};

use clap::{Command, CommandFactory};

use super::arguments::{Arguments, CompletionsArguments, ManArguments};
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::screen::Screen;
use crate::document::Faults;

/// The command as it is typed.
const NAME: &str = "roomwright";

/// Prints a completion script.
pub(crate) fn run_completions(arguments: CompletionsArguments, screen: Screen) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), NAME, &mut script);
    screen.result(String::from_utf8_lossy(&script).trim_end());
    Outcome::Done
}

/// Prints the manual page, or writes those of all commands.
pub(crate) fn run_man(arguments: &ManArguments, screen: Screen) -> Outcome {
    let mut command = Arguments::command();
    command.build();
    let Some(folder) = &arguments.out else {
        screen.result(page(&command).trim_end());
        return Outcome::Done;
    };
    match write_pages(&command, folder, Overwrite::forced(arguments.force)) {
        Ok(paths) => {
            screen.note(&format!("{} pages in {}", paths.len(), folder.display()));
            Outcome::Done
        }
        Err(faults) => {
            screen.faults(&faults);
            Outcome::NotStarted
        }
    }
}

/// Writes the page of a command and those of the commands below it; the first that cannot be written ends it.
fn write_pages(command: &Command, folder: &Path, overwrite: Overwrite) -> Result<Vec<PathBuf>, Faults> {
    let path = folder.join(format!("{}.1", name_of_page(command)));
    write_text(&path, &page(command), overwrite)?;
    let mut paths = vec![path];
    for below in command.get_subcommands().filter(|below| below.get_name() != "help") {
        paths.extend(write_pages(below, folder, overwrite)?);
    }
    Ok(paths)
}

/// `roomwright-edits-lock`.
fn name_of_page(command: &Command) -> String {
    command.get_display_name().unwrap_or(NAME).to_owned()
}

fn page(command: &Command) -> String {
    let mut text = Vec::new();
    let page =
        clap_mangen::Man::new(command.clone()).source(concat!("roomwright ", env!("CARGO_PKG_VERSION")));
    page.render(&mut text).expect("writing to memory does not fail");
    String::from_utf8_lossy(&text).into_owned()
}
