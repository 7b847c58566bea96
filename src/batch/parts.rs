//! Joins the parts of a manifest where the files of the levels are not at hand: on other machines, in an object store.
//!
//! The bytes are those of the manifest that one machine would have written. Nothing is written while parts are missing or
//! contradict each other, because what is there is then not known.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, BufWriter};
use std::path::Path;

use super::fault::{FaultCode, OutputFault};
use super::listed_inputs::ListedInputs;
use super::manifest::{Listed, is_manifest_file, write_manifest};
use super::part_file::{Part, PartFile, PartLevel, Span};
use super::program::PROGRAM;
use super::record::{FileRecord, LevelKey, Totals};
use crate::disk::new_temporary;
use crate::document::{Fault, Faults};
use crate::output::INDEX_NAME;

/// How temporary files of a manifest begin. Hidden, so that none is taken for a result.
const TEMPORARY_PREFIX: &str = ".roomwright-manifest-";

/// The report of a merge of parts.
#[derive(Clone, Debug)]
pub struct PartsReport {
    /// Whether the manifest was written.
    pub is_written: bool,
    /// Parts that were found.
    pub parts: usize,
    /// Levels in them.
    pub levels: usize,
    /// Sums over the levels that were written.
    pub totals: Totals,
    /// Missing parts, contradictions, and levels of the plan that no part has.
    pub faults: Faults,
}

/// Joins the parts in a folder into the manifest `out`. Levels of `planned` that no part has are reported, and the manifest is
/// written without them, as that of a bake in which they failed.
///
/// # Errors
/// If the folder holds no part, or the manifest cannot be written.
pub fn merge_parts(
    folder: &Path,
    planned: Option<&ListedInputs>,
    out: &Path,
) -> Result<PartsReport, OutputFault> {
    let files = PartFile::all_in(folder)?;
    if files.is_empty() {
        return Err(nothing_to_join(folder));
    }
    check_target(out)?;
    let mut gathered = Gathered { expected: planned, ..Gathered::default() };
    gathered.faults.extend(missing_parts(folder, &files));
    for (number, file) in files.iter().enumerate() {
        match file.read() {
            Ok(part) => gathered.add(&files, number, part),
            Err(reason) => {
                gathered.contradict(&file.path, format!("is no part of a manifest: {reason}"), COPY)
            }
        }
    }
    let is_written = gathered.faults.is_empty();
    let totals = if is_written { gathered.write(&files, out)? } else { Totals::default() };
    let mut faults = Faults(gathered.faults);
    faults.0.extend(missing_levels(folder, planned, &gathered.levels));
    Ok(PartsReport { is_written, parts: files.len(), levels: gathered.levels.len(), totals, faults })
}

const COPY: &str = "copy the part again from the machine or store that has it, or bake its share again";
const BAKE: &str = "bake this share and put its part into the folder";
const INDEXED: &str = "bake in another format, join the parts, and write the tiles from the finished bake: `roomwright tiles OUT`";
const SAME: &str = "bake all shares with the same plans, options and program into new folders";

/// The records of all parts so far.
#[derive(Default)]
struct Gathered<'a> {
    /// The inputs of the levels of the plan, where they are known.
    expected: Option<&'a ListedInputs>,
    levels: BTreeMap<LevelKey, Place>,
    library: BTreeMap<String, (FileRecord, usize)>,
    faults: Vec<Fault>,
}

/// Where the record of a level is.
struct Place {
    part: usize,
    span: Span,
    content: [u8; 32],
}

impl Gathered<'_> {
    fn add(&mut self, files: &[PartFile], number: usize, part: Part) {
        let path = &files[number].path;
        if part.program != PROGRAM {
            let message = format!("was baked by {}, and this program is {PROGRAM}", part.program);
            self.contradict(path, message, "join the parts with the program that wrote them all");
            return;
        }
        if part.levels.iter().flatten().any(|level| level.has_index) {
            let message =
                format!("holds levels whose {INDEX_NAME} is made of all levels, which are not here");
            self.contradict(path, message, INDEXED);
            return;
        }
        for level in part.levels {
            match level {
                Ok(level) => self.add_level(files, number, level),
                Err(claim) => self.contradict(path, claim.message, COPY),
            }
        }
        for file in part.library {
            match file {
                Ok(file) => self.add_shared(files, number, file),
                Err(claim) => self.contradict(path, claim.message, COPY),
            }
        }
    }

    fn add_level(&mut self, files: &[PartFile], number: usize, level: PartLevel) {
        let (path, PartLevel { key, inputs, program, content, span, .. }) = (&files[number].path, level);
        let name = format!("{}/{}", key.building, key.level);
        if let Some(other) = program {
            self.contradict(path, format!("has level {name} of another program, {other}"), SAME);
        }
        let expected = self.expected.map(|ListedInputs(expected)| expected.get(&key));
        if expected == Some(None) {
            self.contradict(path, format!("has level {name}, which is not in the list of levels"), SAME);
        } else if expected.flatten().is_some_and(|expected| **expected != *inputs) {
            self.contradict(path, format!("has level {name} of other inputs than the list of levels"), SAME);
        }
        match self.levels.get(&key) {
            Some(known) if known.content != content => {
                let other = file_name(&files[known.part].path);
                self.contradict(path, format!("records level {name} otherwise than {other}"), SAME);
            }
            Some(_) => {}
            None => drop(self.levels.insert(key, Place { part: number, span, content })),
        }
    }

    fn add_shared(&mut self, files: &[PartFile], number: usize, file: FileRecord) {
        match self.library.get(&file.path) {
            Some((known, part)) if *known != file => {
                let other = file_name(&files[*part].path);
                let message = format!("has the shared file {:?} with another hash than {other}", file.path);
                self.contradict(&files[number].path, message, SAME);
            }
            Some(_) => {}
            None => drop(self.library.insert(file.path.clone(), (file, number))),
        }
    }

    fn contradict(&mut self, path: &Path, message: String, hint: &str) {
        self.faults.push(Fault::of_file(path, message).with_hint(hint));
    }

    /// Writes the manifest in one step.
    fn write(&self, files: &[PartFile], out: &Path) -> Result<Totals, OutputFault> {
        let fault = |error: io::Error| OutputFault::of(out, "write the manifest", &error);
        let folder = out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::create_dir_all(folder).map_err(fault)?;
        let library = self.library.iter().map(|(path, (file, _))| (path.clone(), file.clone())).collect();
        let listed =
            Listed { library: &library, index: &[], former_levels: Vec::new(), former_files: Vec::new() };
        let records = self.levels.values().map(|place| files[place.part].record_at(place.span));
        let mut text = BufWriter::new(new_temporary(folder, TEMPORARY_PREFIX).map_err(fault)?);
        let totals = write_manifest(&mut text, records, &listed).map_err(fault)?;
        let text = text.into_inner().map_err(|error| fault(error.into_error()))?;
        text.persist(out).map_err(|failed| fault(failed.error))?;
        Ok(totals)
    }
}

/// Parts that are not there, and parts of several divisions of the work.
pub(super) fn missing_parts(folder: &Path, files: &[PartFile]) -> Vec<Fault> {
    let counts: BTreeSet<u32> = files.iter().map(|file| file.count).collect();
    if counts.len() > 1 {
        let counts: Vec<String> = counts.iter().map(u32::to_string).collect();
        let message =
            format!("holds parts of different divisions: of {} shares", counts.join(" shares, of "));
        return vec![Fault::of_file(folder, message).with_hint("keep the parts of one division only")];
    }
    let count = files[0].count;
    let (mut missing, mut next) = (Vec::new(), 1);
    for index in files.iter().map(|file| u64::from(file.index)).chain([u64::from(count) + 1]) {
        if next < index {
            missing.push((next, index - 1));
        }
        next = index + 1;
    }
    if missing.is_empty() {
        return Vec::new();
    }
    let spans: Vec<String> = missing
        .iter()
        .map(|(from, to)| if from == to { from.to_string() } else { format!("{from} to {to}") })
        .collect();
    let absent: u64 = missing.iter().map(|(from, to)| to - from + 1).sum();
    let message = format!("lacks {absent} of {count} parts: {}", spans.join(", "));
    vec![Fault::of_file(folder, message).with_hint(BAKE)]
}

/// Levels of the plan that no part has.
fn missing_levels(
    folder: &Path,
    planned: Option<&ListedInputs>,
    found: &BTreeMap<LevelKey, Place>,
) -> Vec<Fault> {
    let planned = planned.into_iter().flat_map(|ListedInputs(expected)| expected.keys());
    let missing = planned.filter(|key| !found.contains_key(key));
    let fault = |LevelKey { building, level }: &LevelKey| {
        let message = format!("no part has level {building}/{level}");
        let hint = "the report of the bake that had it says why; bake its share again";
        Fault::of_file(folder, message).with_hint(hint)
    };
    missing.map(fault).collect()
}

/// Refuses to replace a file that is no manifest.
fn check_target(out: &Path) -> Result<(), OutputFault> {
    if fs::symlink_metadata(out).is_err() || is_manifest_file(out) {
        return Ok(());
    }
    Err(OutputFault {
        code: FaultCode::ForeignFile,
        path: out.to_owned(),
        message: "is no manifest of roomwright, and is not overwritten".to_owned(),
        hint: Some("move it away, or choose another file with --out".to_owned()),
    })
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn nothing_to_join(folder: &Path) -> OutputFault {
    OutputFault {
        code: FaultCode::NothingToJoin,
        path: folder.to_owned(),
        message: "holds no part of a manifest".to_owned(),
        hint: Some(
            "put the parts manifest.I-of-N.json that `roomwright bake --shard I/N` leaves into it".to_owned(),
        ),
    }
}
