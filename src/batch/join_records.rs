//! Joins the parts of shards whose files lie elsewhere, such as in a store on the network: no file of a level is looked for. In
//! return the parts must be complete and agree with each other, for nothing else can show that something is missing.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::fault::OutputFault;
use super::join::MergeReport;
use super::manifest::{LARGEST_RECORDS, Listed, is_part_name, parse_manifest, part_numbers, write_manifest};
use super::program::PROGRAM;
use super::record::{FileRecord, LevelKey, Totals};
use super::sources::{Contents, FoundRecord, Sources};
use crate::disk::{new_temporary, read_plain, sweep_temporaries};
use crate::document::{Fault, FaultSeverity, Faults};

/// The begin of the name of a manifest that is being written.
const TEMPORARY_PREFIX: &str = ".roomwright-joining-";

/// The most missing parts that are listed by number.
const LISTED_PARTS: usize = 20;

/// A part as its name describes it.
struct Part {
    path: PathBuf,
    /// Which share, from 1, and of how many.
    numbers: Option<(u32, u32)>,
}

/// Joins the parts in a folder and in the folders in it into the manifest `out`, which is the one that a single bake would
/// have written.
///
/// # Errors
/// All that is missing or contradictory; then nothing is written.
pub fn merge_records(folder: &Path, out: &Path) -> Result<MergeReport, Faults> {
    // The parts must be those of all shares of one division.
    let parts = find_parts(folder).map_err(|fault| as_faults(&fault))?;
    let mut faults = incomplete(folder, &parts);
    faults.merge(foreign_target(out));

    // They must agree with each other.
    let read = |part: &Part| Sources::read(std::slice::from_ref(&part.path), &[]);
    let sources: Result<Vec<Sources>, OutputFault> = parts.iter().map(read).collect();
    let sources = sources.map_err(|fault| as_faults(&fault))?;
    let mut records = Records::default();
    for (part, source) in parts.iter().zip(&sources) {
        match source.contents(false) {
            Ok(contents) => records.add(&part.path, contents),
            Err(fault) => faults.merge(as_faults(&fault)),
        }
    }
    faults.merge(std::mem::take(&mut records.faults));
    if faults.has_errors() {
        return Err(faults);
    }

    // They are written as one bake writes them.
    let totals = write(&records, out).map_err(|error| {
        let fault = OutputFault::of(out, "write the manifest", &error);
        as_faults(&fault)
    })?;
    Ok(MergeReport { manifest: out.to_owned(), totals, living_runs: 0, faults })
}

/// The parts in a folder and in the folders in it, sorted.
fn find_parts(folder: &Path) -> Result<Vec<Part>, OutputFault> {
    let mut paths = Vec::new();
    let mut folders = vec![folder.to_owned()];
    for entry in list(folder)? {
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            folders.push(entry.path());
        }
    }
    for folder in folders {
        let is_part = |entry: &fs::DirEntry| entry.file_name().to_str().is_some_and(is_part_name);
        paths.extend(list(&folder)?.iter().filter(|entry| is_part(entry)).map(fs::DirEntry::path));
    }
    paths.sort();
    let numbers = |path: &Path| part_numbers(path.file_name()?.to_str()?);
    Ok(paths.into_iter().map(|path| Part { numbers: numbers(&path), path }).collect())
}

fn list(folder: &Path) -> Result<Vec<fs::DirEntry>, OutputFault> {
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    entries.map_err(|error| OutputFault::of(folder, "list the folder", &error))
}

/// What the names of the parts lack.
fn incomplete(folder: &Path, parts: &[Part]) -> Faults {
    let mut faults = Faults::default();
    if parts.is_empty() {
        let hint = "name the folder with the files manifest.<I>-of-<N>.json that `roomwright bake --shard I/N` wrote";
        return Fault::of_file(folder, "holds no part of a manifest").with_hint(hint).into();
    }
    let mut shares: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for part in parts {
        match part.numbers {
            Some((index, count)) if (1..=count).contains(&index) => {
                shares.entry(count).or_default().insert(index);
            }
            _ => faults.push(Fault::of_file(&part.path, "is the name of no part: there is no such share")),
        }
    }
    if shares.len() > 1 {
        let counts: Vec<String> = shares.keys().map(u32::to_string).collect();
        let message = format!("holds parts of different divisions: of {} shares", counts.join(", of "));
        let hint = "move the parts of other runs away";
        faults.push(Fault::of_file(folder, message).with_hint(hint));
        return faults;
    }
    for (count, found) in shares {
        let missing = count as usize - found.len();
        if missing > 0 {
            let first = (1..=count).filter(|index| !found.contains(index)).take(LISTED_PARTS);
            let listed: Vec<String> = first.map(|index| index.to_string()).collect();
            let more = if missing > listed.len() { ", …" } else { "" };
            let message = format!("lacks {missing} of {count} parts: {}{more}", listed.join(", "));
            let hint = "bake these shares, or fetch their parts, and merge again";
            faults.push(Fault::of_file(folder, message).with_hint(hint));
        }
    }
    faults
}

/// A fault if something that is no manifest stands at the place of the manifest.
fn foreign_target(out: &Path) -> Faults {
    if out.symlink_metadata().is_err() {
        return Faults::default();
    }
    let found = read_plain(out, LARGEST_RECORDS).map_err(|error| error.to_string());
    match found.and_then(|text| parse_manifest(&text).map(drop)) {
        Ok(()) => Faults::default(),
        Err(reason) => {
            let message = format!("is no manifest of roomwright, and is not overwritten: {reason}");
            Fault::of_file(out, message).with_hint("move it away, or choose another --out").into()
        }
    }
}

/// The records of all parts so far.
#[derive(Default)]
struct Records<'a> {
    levels: BTreeMap<LevelKey, (PathBuf, FoundRecord<'a>)>,
    library: BTreeMap<String, (PathBuf, FileRecord)>,
    faults: Faults,
}

impl<'a> Records<'a> {
    fn add(&mut self, part: &Path, contents: Contents<'a>) {
        // Without its records the manifest would be that of another bake.
        let as_error = |fault: Fault| Fault { severity: FaultSeverity::Error, ..fault };
        self.faults.0.extend(contents.faults.0.into_iter().map(as_error));
        for file in contents.library.into_values() {
            self.add_shared(part, file);
        }
        let mut others = BTreeSet::new();
        for (key, found) in contents.levels {
            for record in found {
                if record.program != PROGRAM {
                    others.insert(record.program.clone());
                }
                self.add_level(part, &key, record);
            }
        }
        for program in others {
            let message = format!("was baked by {program}, and this program is {PROGRAM}");
            let hint = "bake all shares and merge them with the same program";
            self.faults.push(Fault::of_file(part, message).with_hint(hint));
        }
    }

    fn add_shared(&mut self, part: &Path, file: FileRecord) {
        match self.library.get(&file.path) {
            Some((other, known)) if *known != file => {
                let message = format!("records another content of {} than {}", file.path, other.display());
                self.faults.push(Fault::of_file(part, message).with_hint(SAME_INPUT));
            }
            Some(_) => {}
            None => drop(self.library.insert(file.path.clone(), (part.to_owned(), file))),
        }
    }

    /// The same level may come twice, for two machines may have baked the same share.
    fn add_level(&mut self, part: &Path, key: &LevelKey, found: FoundRecord<'a>) {
        match self.levels.get(key) {
            Some((other, known)) if known.text.get() != found.text.get() => {
                let LevelKey { building, level } = key;
                let message = format!(
                    "records level {level:?} of building {building:?} otherwise than {}",
                    other.display()
                );
                self.faults.push(Fault::of_file(part, message).with_hint(SAME_INPUT));
            }
            Some(_) => {}
            None => drop(self.levels.insert(key.clone(), (part.to_owned(), found))),
        }
    }
}

/// Advice for parts that contradict each other.
const SAME_INPUT: &str = "all shares must be baked from the same plans, with the same options";

fn write(records: &Records<'_>, out: &Path) -> io::Result<Totals> {
    let folder = out.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    sweep_temporaries(folder, TEMPORARY_PREFIX);
    let library: BTreeMap<String, FileRecord> =
        records.library.iter().map(|(path, (_, file))| (path.clone(), file.clone())).collect();
    let listed =
        Listed { library: &library, index: &[], former_levels: Vec::new(), former_files: Vec::new() };
    let mut writer = BufWriter::new(new_temporary(folder, TEMPORARY_PREFIX)?);
    let levels = records.levels.values().map(|(_, found)| found.read());
    let totals = write_manifest(&mut writer, levels, &listed)?;
    writer.flush()?;
    let temporary = writer.into_inner().map_err(io::IntoInnerError::into_error)?;
    temporary.persist(out).map_err(|failed| failed.error)?;
    Ok(totals)
}

fn as_faults(fault: &OutputFault) -> Faults {
    Fault::of_file(&fault.path, fault.message.clone()).with_some_hint(fault.hint.clone()).into()
}
