//! `catalog`: lists the catalogue.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::answer::CatalogFilesAnswer;
use super::arguments::{CatalogArguments, CatalogWord};
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::screen::Screen;
use crate::catalog::{DefinitionKind, Description, describe, load_catalog};
use crate::document::{Fault, Faults};
use crate::handbook::{Page, handbook};

/// Runs the command.
pub(crate) fn run(arguments: &CatalogArguments, screen: Screen) -> Outcome {
    if let Some(folder) = &arguments.docs {
        return write_handbook(arguments, folder, screen);
    }
    match find(arguments, screen) {
        Ok(description) => {
            if screen.is_json {
                screen.json(&description.value);
            } else {
                screen.result(description.text.trim_end());
            }
            Outcome::Done
        }
        Err(faults) => {
            screen.faults(&faults);
            Outcome::NotStarted
        }
    }
}

/// Writes the catalogue's pages; the first file that cannot be written ends it.
fn write_handbook(arguments: &CatalogArguments, folder: &Path, screen: Screen) -> Outcome {
    let pages = load_catalog(&arguments.catalog).map(|loaded| {
        screen.faults(&loaded.warnings);
        handbook(&loaded.value)
    });
    let write = |page: &Page| {
        let path = folder.join(&page.path);
        write_text(&path, &page.text, Overwrite::forced(arguments.force)).map(|()| path)
    };
    let written = pages.and_then(|pages| pages.iter().map(write).collect::<Result<Vec<PathBuf>, Faults>>());
    match written {
        Ok(files) if screen.is_json => screen.json(&CatalogFilesAnswer { files }),
        Ok(files) => screen.note(&format!("{} files in {}", files.len(), folder.display())),
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    }
    Outcome::Done
}

fn find(arguments: &CatalogArguments, screen: Screen) -> Result<Description, Faults> {
    let (kind, id) = question(arguments.what.as_deref(), arguments.id.as_deref())?;
    let loaded = load_catalog(&arguments.catalog)?;
    screen.faults(&loaded.warnings);
    describe(&loaded.value, kind, id)
}

/// The request of two words: a kind, a kind and an id, or an id of any kind.
fn question<'a>(
    what: Option<&'a str>,
    id: Option<&'a str>,
) -> Result<(Option<DefinitionKind>, Option<&'a str>), Faults> {
    let Some(what) = what else { return Ok((None, None)) };
    match (CatalogWord::from_str(what, true), id) {
        (Ok(word), id) => Ok((Some(kind(word)), id)),
        (Err(_), None) => Ok((None, Some(what))),
        (Err(_), Some(_)) => {
            let fault =
                Fault::of_file(Path::new("catalog"), format!("\"{what}\" is no part of the catalogue"));
            Err(fault.with_hint("the parts are classes, rooms, styles and palettes").into())
        }
    }
}

fn kind(word: CatalogWord) -> DefinitionKind {
    match word {
        CatalogWord::Classes => DefinitionKind::Class,
        CatalogWord::Rooms => DefinitionKind::RoomType,
        CatalogWord::Styles => DefinitionKind::Style,
        CatalogWord::Palettes => DefinitionKind::Palette,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_word_is_a_part_or_an_id() {
        assert_eq!(question(Some("rooms"), None), Ok((Some(DefinitionKind::RoomType), None)));
        assert_eq!(question(Some("desk"), None), Ok((None, Some("desk"))));
        assert_eq!(question(Some("classes"), Some("desk")), Ok((Some(DefinitionKind::Class), Some("desk"))));
        assert!(question(Some("desk"), Some("chair")).is_err());
    }
}
