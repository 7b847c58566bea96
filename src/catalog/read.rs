//! Reads folders of configuration as files, and files as definitions.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::audit::{AUDIT_FILE, AuditFile};
use super::builtin::{BUILTIN_FOLDER, builtin_files};
use super::file::{
    BuildingStyleEntry, ClassEntry, ClassFile, HouseholdsFile, PaletteEntry, PaletteFile, RoomFile,
    RoomTypeEntry, StyleEntry,
};
use super::file::{StyleFile, WordsFile};
use super::report::{Promised, Report, Spot};
use super::table::{Definition, Extends, Table};
use crate::document::{Fault, Faults, Source};
use crate::storey::Typologies;

/// The kind of definitions in a file, by its folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FileKind {
    Classes,
    RoomTypes,
    Styles,
    Palettes,
    Words,
    Households,
    Typologies,
    Audit,
}

/// The folders that hold definitions.
const FOLDERS: [(&str, FileKind); 4] = [
    ("classes", FileKind::Classes),
    ("palettes", FileKind::Palettes),
    ("rooms", FileKind::RoomTypes),
    ("styles", FileKind::Styles),
];
/// Names that one might give to those folders, and what is meant.
const MISNAMED_FOLDERS: [(&str, &str); 8] = [
    ("class", "classes"),
    ("furniture", "classes"),
    ("material", "palettes"),
    ("materials", "palettes"),
    ("palette", "palettes"),
    ("room", "rooms"),
    ("room_types", "rooms"),
    ("style", "styles"),
];
/// The key of classes under which they name the groups that they are of.
const GROUPS_KEY: &str = "groups";
/// The file of room words, whatever its extension.
const WORDS_FILE: &str = "room_words";
/// The file of households, whatever its extension.
const HOUSEHOLDS_FILE: &str = "households";
/// The file of kinds of buildings, whatever its extension.
const TYPOLOGIES_FILE: &str = "typologies";
/// The extensions that are read; everything else below the folders is left alone.
const EXTENSIONS: [&str; 3] = ["yaml", "yml", "json"];
/// The layer of the files in the binary.
pub(crate) const BUILTIN_LAYER: usize = 0;

/// One file and where it belongs.
#[derive(Debug)]
struct FilePlace {
    kind: FileKind,
    layer: usize,
    /// Its path below the folder, with `/`: the same wherever the folder stands.
    key: String,
}

/// The files of all folders in order: built-in first, then each folder's by path.
#[derive(Debug, Default)]
pub(crate) struct Files {
    places: Vec<FilePlace>,
    /// The texts, in the same order.
    pub(crate) sources: Vec<Source>,
    /// Files that could not be read.
    pub(crate) faults: Faults,
    layer_count: usize,
}

/// All definitions as they are written.
#[derive(Debug, Default)]
pub(crate) struct Definitions {
    /// The classes.
    pub(crate) classes: Table<ClassEntry>,
    /// The room types.
    pub(crate) room_types: Table<RoomTypeEntry>,
    /// The styles.
    pub(crate) styles: Table<StyleEntry>,
    /// The building styles.
    pub(crate) building_styles: Table<BuildingStyleEntry>,
    /// The palettes.
    pub(crate) palettes: Table<PaletteEntry>,
    /// The room words of each file, with its index.
    pub(crate) words: Vec<(usize, WordsFile)>,
    /// The households of each file, with its index.
    pub(crate) households: Vec<(usize, HouseholdsFile)>,
    /// The kinds of buildings of each file, with its index.
    pub(crate) typologies: Vec<(usize, Typologies)>,
    /// The thresholds of each file, with its index.
    pub(crate) audit: Vec<(usize, AuditFile)>,
}

impl Files {
    /// Adds the files inside the binary.
    pub(crate) fn add_builtin(&mut self) {
        let layer = self.next_layer();
        for file in builtin_files() {
            if let Some(kind) = kind_of(file.path) {
                self.sources.push(Source::new(&Path::new(BUILTIN_FOLDER).join(file.path), file.text));
                self.places.push(FilePlace { kind, layer, key: file.path.to_owned() });
            }
        }
    }

    /// Adds the files of a user's folder.
    pub(crate) fn add_folder(&mut self, folder: &Path) {
        let layer = self.next_layer();
        let before = (self.places.len(), self.faults.0.len());
        let mut keys = Vec::new();
        if let Err((folder, error)) = list_files(folder, "", &mut keys) {
            let fault = Fault::of_file(&folder, format!("cannot be listed: {error}"));
            let hint = match folder.is_file() {
                true => "name the folder that holds classes/, rooms/, styles/ or palettes/",
                false => "check the path and the rights of the folder",
            };
            self.faults.push(fault.with_hint(hint));
            return;
        }
        keys.sort();
        for key in keys {
            let Some(kind) = kind_of(&key) else { continue };
            match Source::read(&folder.join(&key)) {
                Ok(source) => {
                    self.sources.push(source);
                    self.places.push(FilePlace { kind, layer, key });
                }
                Err(faults) => self.faults.merge(faults),
            }
        }
        self.report_misnamed(folder);
        if (self.places.len(), self.faults.0.len()) == before {
            self.faults.push(nothing_found(folder));
        }
    }

    /// All files as definitions, and the faults found so far.
    pub(crate) fn parse(&self) -> (Definitions, Report<'_>) {
        let mut faults = self.faults.clone();
        let mut promised =
            if faults.has_errors() { Promised::Everything } else { Promised::Words(BTreeSet::new()) };
        let mut parsed: Vec<Option<Parsed>> = Vec::with_capacity(self.places.len());
        for (place, source) in self.places.iter().zip(&self.sources) {
            let found = parse(place.kind, source).map_err(|new| {
                faults.merge(new);
                promised.add(source.promised_words(GROUPS_KEY));
            });
            parsed.push(found.ok());
        }
        let mut report = Report::new(&self.sources, faults, promised);
        let mut definitions = Definitions::default();
        for (source, (place, parsed)) in self.places.iter().zip(parsed).enumerate() {
            if let Some(parsed) = parsed {
                definitions.add(parsed, Origin { source, layer: place.layer }, &mut report);
            }
        }
        (definitions, report)
    }

    /// Starts a hash over the names and texts of all files, in their order.
    pub(crate) fn digest(&self) -> Sha256 {
        let mut hasher = Sha256::new();
        for (place, source) in self.places.iter().zip(&self.sources) {
            hasher.update((place.layer as u64).to_le_bytes());
            add_to_digest(&mut hasher, place.key.as_bytes());
            add_to_digest(&mut hasher, source.text().as_bytes());
        }
        hasher
    }

    /// Whether a file is inside the binary.
    pub(crate) fn is_builtin(&self, source: usize) -> bool {
        self.places[source].layer == BUILTIN_LAYER
    }

    fn next_layer(&mut self) -> usize {
        self.layer_count += 1;
        self.layer_count - 1
    }

    /// Folders that are not read although they look as if they were meant to be.
    fn report_misnamed(&mut self, folder: &Path) {
        for (name, meant) in MISNAMED_FOLDERS {
            let path = folder.join(name);
            if path.is_dir() {
                let fault = Fault::of_file(&path, "this folder is not read").as_warning();
                self.faults.push(fault.with_hint(format!("definitions are read from {meant}/")));
            }
        }
    }
}

/// Adds bytes with their length, so that no two lists of names and texts run together to the same bytes.
pub(crate) fn add_to_digest(hasher: &mut Sha256, bytes: &[u8]) {
    hasher.update((bytes.len() as u64).to_le_bytes());
    hasher.update(bytes);
}

fn nothing_found(folder: &Path) -> Fault {
    let fault = Fault::of_file(folder, "this folder holds no configuration").as_warning();
    if FOLDERS.iter().any(|(name, _)| folder.ends_with(name)) {
        return fault.with_hint("name the folder that it lies in");
    }
    fault.with_hint(
        "definitions stand in YAML or JSON files below classes/, rooms/, styles/ and palettes/, in room_words.yaml, households.yaml, typologies.yaml and audit.yaml",
    )
}

/// The kind of definitions at a path below a folder of configuration, if it is read at all.
fn kind_of(key: &str) -> Option<FileKind> {
    let (stem, extension) = key.rsplit_once('.')?;
    if !EXTENSIONS.contains(&extension) {
        return None;
    }
    match stem {
        WORDS_FILE => return Some(FileKind::Words),
        HOUSEHOLDS_FILE => return Some(FileKind::Households),
        TYPOLOGIES_FILE => return Some(FileKind::Typologies),
        AUDIT_FILE => return Some(FileKind::Audit),
        _ => {}
    }
    let (folder, _) = key.split_once('/')?;
    FOLDERS.iter().find(|(name, _)| *name == folder).map(|&(_, kind)| kind)
}

/// Folders within folders below `classes/` and the like; deeper ones are a loop of links.
const DEPTH_LIMIT: usize = 8;

/// The paths of all files below a folder, in no order; hidden ones are left out.
fn list_files(folder: &Path, prefix: &str, keys: &mut Vec<String>) -> Result<(), (PathBuf, std::io::Error)> {
    let refuse = |error| (folder.to_owned(), error);
    for entry in std::fs::read_dir(folder).map_err(refuse)? {
        let entry = entry.map_err(refuse)?;
        let Ok(name) = entry.file_name().into_string() else { continue };
        let (path, depth) = (entry.path(), prefix.matches('/').count());
        if name.starts_with('.') {
            continue;
        }
        if !path.is_dir() {
            keys.push(format!("{prefix}{name}"));
        } else if depth < DEPTH_LIMIT && (depth > 0 || FOLDERS.iter().any(|(known, _)| *known == name)) {
            list_files(&path, &format!("{prefix}{name}/"), keys)?;
        }
    }
    Ok(())
}

/// Where definitions come from: a file, by its number, and the layer that it is part of.
#[derive(Clone, Copy)]
struct Origin {
    source: usize,
    layer: usize,
}

/// One file as it is written.
enum Parsed {
    Classes(ClassFile),
    RoomTypes(RoomFile),
    Styles(StyleFile),
    Palettes(PaletteFile),
    Words(WordsFile),
    Households(Box<HouseholdsFile>),
    Typologies(Box<Typologies>),
    Audit(Box<AuditFile>),
}

fn parse(kind: FileKind, source: &Source) -> Result<Parsed, Faults> {
    Ok(match kind {
        FileKind::Classes => Parsed::Classes(source.parse()?),
        FileKind::RoomTypes => Parsed::RoomTypes(source.parse()?),
        FileKind::Styles => Parsed::Styles(source.parse()?),
        FileKind::Palettes => Parsed::Palettes(source.parse()?),
        FileKind::Words => Parsed::Words(source.parse()?),
        FileKind::Households => Parsed::Households(Box::new(source.parse()?)),
        FileKind::Typologies => Parsed::Typologies(Box::new(source.parse()?)),
        FileKind::Audit => Parsed::Audit(Box::new(source.parse()?)),
    })
}

impl Definitions {
    fn add(&mut self, parsed: Parsed, origin: Origin, report: &mut Report<'_>) {
        match parsed {
            Parsed::Classes(file) => add_all(&mut self.classes, file.classes, origin, report),
            Parsed::RoomTypes(file) => add_all(&mut self.room_types, file.room_types, origin, report),
            Parsed::Styles(file) => {
                add_all(&mut self.styles, file.styles, origin, report);
                add_all(&mut self.building_styles, file.building_styles, origin, report);
            }
            Parsed::Palettes(file) => add_all(&mut self.palettes, file.palettes, origin, report),
            Parsed::Words(file) => self.words.push((origin.source, file)),
            Parsed::Households(file) => self.households.push((origin.source, *file)),
            Parsed::Typologies(file) => self.typologies.push((origin.source, *file)),
            Parsed::Audit(file) => self.audit.push((origin.source, *file)),
        }
    }
}

fn add_all<T: Extends>(
    table: &mut Table<T>,
    entries: std::collections::BTreeMap<String, T>,
    origin: Origin,
    report: &mut Report<'_>,
) {
    let Origin { source, layer } = origin;
    for (id, entry) in entries {
        let spot = Spot::definition(source, T::TABLE, &id);
        check_id(T::KIND, &id, &spot, report);
        table.add(Definition { id, layer, spot, entry }, report);
    }
}

/// Ids become names of nodes and words on the command line.
fn check_id(kind: &str, id: &str, spot: &Spot, report: &mut Report<'_>) {
    let is_word = id.starts_with(|first: char| first.is_ascii_lowercase())
        && id.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_');
    if !is_word {
        let message = format!("\"{id}\" is no id for a {kind}");
        report.error_at_key(
            spot,
            message,
            "ids are lower-case letters, digits and _, beginning with a letter",
        );
    }
}
