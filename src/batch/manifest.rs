//! `manifest.json`: every file with its hash, counts and findings; sorted, without times or facts of the machine.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{File, Metadata};
use std::io::{self, Read, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::ser::{Formatter, PrettyFormatter};
use serde_json::value::RawValue;

use super::program::PROGRAM;
use super::record::{FileRecord, LevelRecord, Totals};
use crate::disk::{open_plain, read_plain};

/// The file in the output folder.
pub(crate) const MANIFEST_NAME: &str = "manifest.json";

/// Whether a file name is that of a manifest or of a shard's part of one.
pub(crate) fn is_manifest_name(name: &str) -> bool {
    name == MANIFEST_NAME || is_part_name(name)
}

/// Whether a file name is that of a shard's part: `manifest.<i>-of-<n>.json`.
pub(crate) fn is_part_name(name: &str) -> bool {
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    part_words(name).is_some_and(|(index, count)| is_number(index) && is_number(count))
}

/// The share that the name of a part is of: which, and of how many. None if the numbers are too large to be any.
pub(crate) fn part_numbers(name: &str) -> Option<(u32, u32)> {
    let (index, count) = part_words(name)?;
    Some((index.parse().ok()?, count.parse().ok()?))
}

fn part_words(name: &str) -> Option<(&str, &str)> {
    name.strip_prefix("manifest.")?.strip_suffix(".json")?.split_once("-of-")
}

/// The most bytes of a manifest or journal that are read: ten thousand levels of forty rooms take a hundredth of it.
pub(crate) const LARGEST_RECORDS: u64 = 1 << 30;

/// The version of the format.
const MANIFEST_VERSION: u32 = 1;

/// The content of a manifest. It is written and read level by level, for cities do not fit into memory; this type is there for
/// the JSON Schema.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[schemars(title = "Roomwright manifest")]
#[expect(dead_code, reason = "only its shape counts")]
pub(crate) struct Manifest {
    /// The version of the format: 1.
    manifest: u32,
    /// The program that wrote it: version and hash of its sources.
    program: String,
    /// The levels, sorted by building and level.
    levels: Vec<LevelRecord>,
    /// Shared geometry and textures that the levels refer to.
    library: Vec<FileRecord>,
    /// Files over all levels, the one to open first.
    #[serde(default)]
    index: Vec<FileRecord>,
    /// Levels that are in the folder, but no longer in the plan.
    #[serde(default)]
    former_levels: Vec<LevelRecord>,
    /// Other files of earlier bakes that no level uses.
    #[serde(default)]
    former_files: Vec<FileRecord>,
    /// The texts by which the sources of the plans ask to be named wherever the levels are shown, each once, sorted.
    #[serde(default)]
    attributions: Vec<String>,
    /// Sums over the levels.
    totals: Totals,
}

/// A manifest as found, its levels not yet read.
#[derive(Deserialize)]
pub(crate) struct ManifestText<'a> {
    /// [`MANIFEST_VERSION`].
    pub(crate) manifest: u32,
    /// The program that wrote it.
    pub(crate) program: String,
    /// A [`LevelRecord`] each.
    #[serde(borrow)]
    pub(crate) levels: Vec<&'a RawValue>,
    /// Shared geometry.
    #[serde(default)]
    pub(crate) library: Vec<FileRecord>,
    /// Files over all levels.
    #[serde(default)]
    pub(crate) index: Vec<FileRecord>,
    /// A [`LevelRecord`] for each level that is in the folder, but no longer in the plan.
    #[serde(default, borrow)]
    pub(crate) former_levels: Vec<&'a RawValue>,
    /// Other files of earlier bakes that no level uses.
    #[serde(default)]
    pub(crate) former_files: Vec<FileRecord>,
}

/// The content of a manifest besides its levels.
pub(crate) struct Listed<'a> {
    /// Shared files by path, also those that no level uses.
    pub(crate) library: &'a BTreeMap<String, FileRecord>,
    /// Files over all levels.
    pub(crate) index: &'a [FileRecord],
    /// Levels that the plan has no longer.
    pub(crate) former_levels: Vec<LevelRecord>,
    /// Other files of earlier bakes that no level uses.
    pub(crate) former_files: Vec<&'a FileRecord>,
}

/// Reads a manifest's frame.
///
/// # Errors
/// Says in one sentence why the text is no manifest of this program.
pub(crate) fn parse_manifest(text: &[u8]) -> Result<ManifestText<'_>, String> {
    let found: ManifestText<'_> = serde_json::from_slice(text).map_err(|error| error.to_string())?;
    if found.manifest == MANIFEST_VERSION {
        Ok(found)
    } else {
        Err(format!("manifest version {} is not {MANIFEST_VERSION}", found.manifest))
    }
}

/// Whether a file is a manifest. What begins as one is not read further: that of a city may be larger than is ever read.
pub(crate) fn is_manifest_file(path: &Path) -> bool {
    let begin = format!("{{\n\"manifest\": {MANIFEST_VERSION},\n\"program\": \"");
    let begins = |(file, _): (File, Metadata)| {
        let mut head = Vec::new();
        file.take(begin.len() as u64).read_to_end(&mut head).is_ok() && head == begin.as_bytes()
    };
    open_plain(path).is_ok_and(begins)
        || read_plain(path, LARGEST_RECORDS).is_ok_and(|text| parse_manifest(&text).is_ok())
}

/// Writes a manifest from records that arrive in order, one at a time, so that a city need not be in memory.
///
/// # Errors
/// Passes on the errors of `records` and of the writer.
pub(crate) fn write_manifest<W: Write>(
    out: &mut W,
    records: impl Iterator<Item = io::Result<LevelRecord>>,
    listed: &Listed<'_>,
) -> io::Result<Totals> {
    write!(out, "{{\n\"manifest\": {MANIFEST_VERSION},\n\"program\": \"{PROGRAM}\",\n\"levels\": [")?;
    let mut totals = Totals::default();
    let mut used = BTreeMap::new();
    let mut attributions: BTreeSet<String> =
        listed.former_levels.iter().filter_map(|level| level.attribution.clone()).collect();
    for (index, record) in records.enumerate() {
        let record = without_own_program(record?);
        totals.add(&record.totals);
        attributions.extend(record.attribution.clone());
        used.extend(record.library.iter().filter_map(|path| Some((path.clone(), listed.library.get(path)?))));
        out.write_all(if index == 0 { b"\n" } else { b",\n" })?;
        write_value(out, &record)?;
    }
    out.write_all(b"\n],\n\"library\": ")?;
    write_value(out, &used.values().collect::<Vec<_>>())?;
    if !listed.index.is_empty() {
        out.write_all(b",\n\"index\": ")?;
        write_value(out, &listed.index)?;
    }
    // Left out where there is none: then the bytes do not depend on the past.
    if !listed.former_levels.is_empty() {
        out.write_all(b",\n\"former_levels\": ")?;
        write_value(out, &listed.former_levels)?;
    }
    if !listed.former_files.is_empty() {
        out.write_all(b",\n\"former_files\": ")?;
        write_value(out, &listed.former_files)?;
    }
    if !attributions.is_empty() {
        out.write_all(b",\n\"attributions\": ")?;
        write_value(out, &attributions)?;
    }
    out.write_all(b",\n\"totals\": ")?;
    write_value(out, &totals)?;
    out.write_all(b"\n}\n")?;
    Ok(totals)
}

/// The manifest names its own program once; a level names another one only.
pub(crate) fn without_own_program(mut record: LevelRecord) -> LevelRecord {
    record.program = record.program.filter(|program| program != PROGRAM);
    record
}

fn write_value<W: Write>(out: &mut W, value: &impl Serialize) -> io::Result<()> {
    let mut serializer = serde_json::Serializer::with_formatter(out, ShallowFormatter::default());
    value.serialize(&mut serializer).map_err(io::Error::from)
}

/// Nesting down to which keys and items get a line of their own: one line per file, per room, per count.
const BROKEN_DEPTH: usize = 2;

/// Breaks lines near the root only, so that a changed room is a changed line.
struct ShallowFormatter {
    pretty: PrettyFormatter<'static>,
    depth: usize,
}

impl Default for ShallowFormatter {
    fn default() -> Self {
        Self { pretty: PrettyFormatter::with_indent(b" "), depth: 0 }
    }
}

impl ShallowFormatter {
    fn is_broken(&self) -> bool {
        self.depth <= BROKEN_DEPTH
    }
}

impl Formatter for ShallowFormatter {
    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        if self.is_broken() { self.pretty.begin_array(writer) } else { writer.write_all(b"[") }
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let is_broken = self.is_broken();
        self.depth -= 1;
        if is_broken { self.pretty.end_array(writer) } else { writer.write_all(b"]") }
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        match (self.is_broken(), first) {
            (true, _) => self.pretty.begin_array_value(writer, first),
            (false, true) => Ok(()),
            (false, false) => writer.write_all(b", "),
        }
    }

    fn end_array_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        if self.is_broken() { self.pretty.end_array_value(writer) } else { Ok(()) }
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        if self.is_broken() { self.pretty.begin_object(writer) } else { writer.write_all(b"{") }
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let is_broken = self.is_broken();
        self.depth -= 1;
        if is_broken { self.pretty.end_object(writer) } else { writer.write_all(b"}") }
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        match (self.is_broken(), first) {
            (true, _) => self.pretty.begin_object_key(writer, first),
            (false, true) => Ok(()),
            (false, false) => writer.write_all(b", "),
        }
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }

    fn end_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        if self.is_broken() { self.pretty.end_object_value(writer) } else { Ok(()) }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::super::record::{RemovedRecord, RoomRecord, SiteRecord};
    use super::*;
    use crate::audit::{AuditSummary, Grade, Verdict};
    use crate::contract::FindingExtras;

    pub(crate) fn record(building: &str, level: &str) -> LevelRecord {
        let mut audit = AuditSummary::default();
        audit.add_room(&Verdict::default());
        LevelRecord {
            building: building.to_owned(),
            level: level.to_owned(),
            program: Some(PROGRAM.to_owned()),
            inputs: "00".to_owned(),
            seed: 1,
            site: SiteRecord { position: [0.1 + 0.2, -4.0], turn: 1.0 / 3.0 },
            bounds: None,
            files: vec![FileRecord {
                path: format!("{building}/{level}.glb"),
                sha256: crate::disk::content_hash(level.as_bytes()),
                bytes: level.len() as u64,
            }],
            library: Vec::new(),
            totals: Totals { rooms: 2, requested: 5, placed: 4, removed: 1, audit, ..Totals::default() },
            classes: BTreeMap::from([("bed".to_owned(), 1), ("chair".to_owned(), 3)]),
            left_out: Vec::new(),
            attribution: None,
            rooms: vec![RoomRecord {
                room: "12".to_owned(),
                grade: Some(Grade::Minor),
                score: Some(0.8125),
                removed: vec![RemovedRecord { class: "lamp".to_owned(), reason: "no place".to_owned() }],
                findings: vec![FindingExtras {
                    code: "tight_use".into(),
                    severity: "minor".into(),
                    objects: Vec::new(),
                    measured: 0.729_999_999_999_999_9,
                    threshold: 0.75,
                    not_searched_further: false,
                }],
                misfits: Vec::new(),
                failure: None,
            }],
        }
    }

    fn written(records: &[LevelRecord]) -> String {
        let mut out = Vec::new();
        let library = BTreeMap::new();
        let listed =
            Listed { library: &library, index: &[], former_levels: Vec::new(), former_files: Vec::new() };
        write_manifest(&mut out, records.iter().cloned().map(Ok), &listed).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn numbers_are_read_back_to_the_last_digit() {
        let records = [record("a", "1"), record("a", "2")];
        let text = written(&records);
        let found = parse_manifest(text.as_bytes()).unwrap();
        let again: Vec<LevelRecord> =
            found.levels.iter().map(|level| serde_json::from_str(level.get()).unwrap()).collect();
        assert_eq!(written(&again), text);
        assert_eq!(again[1].site, records[1].site);
    }

    #[test]
    fn a_room_is_one_line() {
        let text = written(&[record("a", "1")]);
        let line = text.lines().find(|line| line.contains("\"room\"")).unwrap();
        assert_eq!(
            line.trim(),
            r#"{"room": "12", "grade": "minor", "score": 0.8125, "removed": [{"class": "lamp", "reason": "no place"}], "findings": [{"code": "tight_use", "severity": "minor", "objects": [], "measured": 0.7299999999999999, "threshold": 0.75}]}"#
        );
        assert!(text.lines().any(|line| line.trim() == r#""classes": {"#));
    }

    #[test]
    fn each_source_is_named_once() {
        let of = |level: &str, text: &str| LevelRecord {
            attribution: Some(text.to_owned()),
            ..record("a", level)
        };
        let text = written(&[of("1", "© B"), of("2", "© A"), of("3", "© B"), record("b", "1")]);
        let manifest: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(manifest["attributions"], serde_json::json!(["© A", "© B"]));
        assert!(!written(&[record("a", "1")]).contains("attribution"));
    }

    #[test]
    fn a_manifest_without_levels_is_valid() {
        assert!(parse_manifest(written(&[]).as_bytes()).unwrap().levels.is_empty());
    }

    #[test]
    fn the_name_of_the_program_is_written_once() {
        assert_eq!(written(&[record("a", "1"), record("b", "1")]).matches(PROGRAM).count(), 1);
    }

    #[test]
    fn parts_are_known_by_name() {
        assert!(is_manifest_name("manifest.json") && is_manifest_name("manifest.2-of-16.json"));
        assert!(!is_part_name("manifest.json") && !is_part_name("manifest.a-of-b.json"));
    }

    #[test]
    fn other_json_is_no_manifest() {
        assert!(parse_manifest(b"{\"name\": \"web app\"}").is_err());
        assert!(parse_manifest(b"{\"manifest\": 99, \"program\": \"x\", \"levels\": []}").is_err());
    }
}
