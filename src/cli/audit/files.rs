//! Finds the files that the paths of a command line name.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::batch::{Listing, is_bake, list_levels};
use crate::document::{Fault, Faults};
use crate::output::is_read_back;

/// Folders in folders down to this depth.
const DEEPEST: usize = 32;

/// Most names in one line.
const LISTED_NAMES: usize = 5;

/// Files and folders below a folder.
#[derive(Default)]
struct Below {
    /// Levels.
    files: BTreeSet<PathBuf>,
    /// Folders that bake wrote a manifest into; what is below them is theirs.
    bakes: Vec<PathBuf>,
    /// Folders that were looked into, without links: those that links lead to are not looked into again.
    visited: BTreeSet<PathBuf>,
}

/// The named files, and all levels below the named folders, sorted and each once, with what keeps some of them from being
/// judged. Where bake wrote a manifest, the levels are those that it lists.
///
/// # Errors
/// Paths that do not exist, and folders without a level.
pub(crate) fn level_files(paths: &[PathBuf]) -> Result<(Vec<PathBuf>, Faults), Faults> {
    let (mut files, mut faults) = (BTreeSet::new(), Faults::default());
    let mut refused = Faults::default();
    for path in paths {
        if path.is_dir() {
            match levels_below(path, &mut faults) {
                Ok(found) => files.extend(found),
                Err(fault) => refused.push(fault),
            }
        } else if path.exists() {
            files.insert(path.clone());
        } else {
            let fault = Fault::of_file(path, "does not exist");
            refused.push(fault.with_hint("`roomwright bake` writes into out/"));
        }
    }
    if refused.is_empty() { Ok((files.into_iter().collect(), faults)) } else { Err(refused) }
}

fn levels_below(folder: &Path, faults: &mut Faults) -> Result<BTreeSet<PathBuf>, Fault> {
    let mut below = Below::default();
    let unreadable = |error| Fault::of_file(folder, format!("cannot be read: {error}"));
    collect(folder, DEEPEST, &mut below).map_err(unreadable)?;
    let mut files = match listing_of(folder) {
        Some((root, listing)) => listed(folder, &root, listing, &below.files, faults),
        None => below.files,
    };
    for bake in below.bakes {
        files.extend(levels_below(&bake, faults)?);
    }
    if files.is_empty() {
        let fault = Fault::of_file(folder, "holds no level: no .glb or .gltf file");
        Err(fault.with_hint(
            "`roomwright bake PLAN --out DIR --format glb` writes them; other formats are not read back",
        ))
    } else {
        Ok(files)
    }
}

/// The manifest of a bake's folder, or of the one above a building's, with the folder that it lies in.
fn listing_of(folder: &Path) -> Option<(PathBuf, Listing)> {
    let above =
        folder.parent().map(|above| if above.as_os_str().is_empty() { Path::new(".") } else { above });
    let places = [Some(folder), above.filter(|_| folder.file_name().is_some())];
    places.into_iter().flatten().find_map(|place| Some((place.to_owned(), list_levels(place)?)))
}

/// The listed levels below a folder; reports missing levels, and files that are not listed.
fn listed(
    folder: &Path,
    root: &Path,
    listing: Listing,
    found: &BTreeSet<PathBuf>,
    faults: &mut Faults,
) -> BTreeSet<PathBuf> {
    faults.merge(listing.faults);
    let path_of = |file: &String| match root == folder {
        true => Some(folder.join(file)),
        false => Some(folder.join(Path::new(file).strip_prefix(folder.file_name()?).ok()?)),
    };
    // Other files of a bake hold levels that no command reads back.
    let listed = listing.files.iter().filter_map(path_of);
    let files: BTreeSet<PathBuf> = listed.filter(|path| is_read_back(path)).collect();
    for file in files.difference(found) {
        let fault = Fault::of_file(file, "is in the manifest, but not there");
        faults.push(fault.with_hint("bake the folder again: missing files are written again"));
    }
    let others: Vec<String> = found.difference(&files).map(|file| file.display().to_string()).collect();
    if !others.is_empty() {
        let names = others.iter().take(LISTED_NAMES).cloned().collect::<Vec<_>>().join(", ");
        let more = if others.len() > LISTED_NAMES { ", …" } else { "" };
        let message = format!(
            "holds levels that its manifest does not list ({}), which are not judged: {names}{more}",
            others.len()
        );
        let hint = "name a file to have it judged; `bake` with --prune removes what no plan has";
        faults.push(Fault::of_file(folder, message).with_hint(hint).as_warning());
    }
    files.intersection(found).cloned().collect()
}

fn collect(folder: &Path, depth: usize, below: &mut Below) -> std::io::Result<()> {
    if !below.visited.insert(folder.canonicalize()?) {
        return Ok(());
    }
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        // Hidden names are files on their way to their place.
        let is_hidden = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
        let is_level = is_read_back(&path);
        if is_hidden {
            continue;
        }
        if path.is_dir() {
            if is_bake(&path) {
                below.bakes.push(path);
            } else if depth > 0 {
                collect(&path, depth - 1, below)?;
            }
        } else if is_level {
            below.files.insert(path);
        }
    }
    Ok(())
}
