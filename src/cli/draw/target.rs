//! The files that drawings go to.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use super::super::arguments::DrawArguments;
use super::chosen::Page;
use crate::batch::distinct_names;
use crate::document::{Fault, Faults};

/// Endings of formats that users may expect from `draw`, and that it does not write.
const OTHER_FORMATS: [&str; 12] =
    ["png", "jpg", "jpeg", "gif", "webp", "bmp", "tif", "tiff", "pdf", "html", "dxf", "dwg"];

/// Where drawings go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// To stdout, which another program reads.
    Stdout,
    /// Into a file of this folder that is named after the building, because SVG is not readable at a terminal.
    Here,
    /// Into this file.
    File(PathBuf),
    /// Into files in this folder.
    Folder(PathBuf),
}

/// The meaning of `--out`.
///
/// # Errors
/// If it names a file of another format.
pub(super) fn target(arguments: &DrawArguments) -> Result<Target, Faults> {
    let Some(out) = &arguments.out else {
        return Ok(if std::io::stdout().is_terminal() { Target::Here } else { Target::Stdout });
    };
    let ending = out.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    if out.is_dir() {
        Ok(Target::Folder(out.clone()))
    } else if ending == "svg" {
        Ok(Target::File(out.clone()))
    } else if OTHER_FORMATS.contains(&ending.as_str()) {
        let fault = Fault::of_file(out, format!("drawings are SVG, not {}", ending.to_uppercase()));
        let example = out.with_extension("svg");
        let hint = format!("write --out {}, or name a folder; browsers print SVG", example.display());
        Err(fault.with_hint(hint).into())
    } else {
        Ok(Target::Folder(out.clone()))
    }
}

impl Target {
    /// Whether all levels go onto one sheet.
    pub(super) fn is_one_file(&self) -> bool {
        !matches!(self, Self::Folder(_))
    }

    /// The pages, each with the file that it goes to; stdout has none.
    ///
    /// # Errors
    /// If several buildings would go into one file.
    pub(super) fn jobs<'p, 'a>(
        self,
        pages: &'p [Page<'a>],
        is_sheet: bool,
    ) -> Result<Vec<(&'p Page<'a>, Option<PathBuf>)>, Faults> {
        match (self, pages) {
            (Self::Folder(folder), _) => {
                let paths = names(pages, is_sheet).into_iter().map(|name| Some(folder.join(name)));
                Ok(pages.iter().zip(paths).collect())
            }
            (Self::File(file), [page]) => Ok(vec![(page, Some(file))]),
            (Self::Here, [page]) => Ok(vec![(page, Some(names(pages, true).remove(0)))]),
            (Self::Stdout, [page]) => Ok(vec![(page, None)]),
            (Self::File(file), _) => Err(too_many(&file, "is one file", pages)),
            (Self::Here | Self::Stdout, _) => Err(too_many(Path::new("--out"), "names no folder", pages)),
        }
    }
}

/// A file each: `<building>.svg` for sheets, `<building>/<level>.svg` for levels.
fn names(pages: &[Page<'_>], is_sheet: bool) -> Vec<PathBuf> {
    let buildings: Vec<&str> = pages.iter().map(|page| page[0].placed.id.as_str()).collect();
    let levels: Vec<&str> = pages.iter().map(|page| page[0].level.id.as_str()).collect();
    let name = |(building, level): (String, String)| match is_sheet {
        true => PathBuf::from(building + ".svg"),
        false => Path::new(&building).join(level + ".svg"),
    };
    distinct_names(&buildings).into_iter().zip(distinct_names(&levels)).map(name).collect()
}

fn too_many(place: &Path, what: &str, pages: &[Page<'_>]) -> Faults {
    let fault = Fault::of_file(place, format!("{what}, but {} buildings are drawn", pages.len()));
    let first = &pages[0][0].placed.id;
    let hint = format!("name a folder with --out, or one building, for example --building {first}");
    fault.with_hint(hint).into()
}
