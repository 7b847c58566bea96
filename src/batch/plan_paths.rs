//! Remembers which plan each output folder was baked from, so that edits captured from a level go beside its plan.
//!
//! Kept beside the cache and not in the output folder: it says something of this machine, and the same plans bake to the same
//! bytes wherever they lie. It may be deleted at any time; nothing that is baked depends on it.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::disk::content_hash;
use crate::disk::{ignore_unsupported, new_temporary, read_plain, sweep_temporaries};
use crate::plan::Plan;

/// The folder of notes, in that of the cache.
const FOLDER: &str = "plans";

/// The file that is locked while a note is renewed.
const LOCK_NAME: &str = "lock";

/// How notes begin that are not yet in place.
const TEMPORARY_PREFIX: &str = "note-";

/// Most bytes that are read of a note: a million buildings have some 100 MB.
const MOST_BYTES: u64 = 256 << 20;

/// The note about one output folder.
#[derive(Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
struct Note {
    /// By building: the project that places it, else its plan.
    plans: BTreeMap<String, PathBuf>,
}

/// Notes where the plans of an output folder lie, beside what was known of others.
///
/// # Errors
/// If the note cannot be written.
pub fn record_plans(cache: &Path, output: &Path, plan: &Plan) -> io::Result<()> {
    let folder = cache.join(FOLDER);
    fs::create_dir_all(&folder)?;
    let lock = File::options().create(true).truncate(false).write(true).open(folder.join(LOCK_NAME))?;
    ignore_unsupported(lock.lock())?;
    sweep_temporaries(&folder, TEMPORARY_PREFIX);
    let path = note_path(cache, &output.canonicalize()?);
    let mut note = read(&path);
    for placed in &plan.buildings {
        let source = &placed.source;
        let place = source.project.as_ref().unwrap_or(&source.plan).canonicalize()?;
        note.plans.insert(placed.id.clone(), place);
    }
    if note == read(&path) {
        return Ok(());
    }
    let mut temporary = new_temporary(&folder, TEMPORARY_PREFIX)?;
    temporary.write_all(&serde_json::to_vec_pretty(&note)?)?;
    temporary.persist(&path)?;
    Ok(())
}

/// The plan or project that a floor was baked from, if that is noted for a folder that the floor lies in, and still there.
#[must_use]
pub fn recorded_plan(cache: &Path, floor: &Path, building: &str) -> Option<PathBuf> {
    let floor = floor.canonicalize().ok()?;
    let output = floor.ancestors().skip(1).find(|output| note_path(cache, output).is_file())?;
    read(&note_path(cache, output)).plans.get(building)?.canonicalize().ok()
}

fn note_path(cache: &Path, output: &Path) -> PathBuf {
    cache.join(FOLDER).join(format!("{}.json", content_hash(output.as_os_str().as_encoded_bytes())))
}

/// The note; empty if there is none, or none of this program.
fn read(path: &Path) -> Note {
    read_plain(path, MOST_BYTES).ok().and_then(|text| serde_json::from_slice(&text).ok()).unwrap_or_default()
}
