//! Loads folders of configuration as a [`Catalog`].

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::check::{check_programmes, find_depths};
use super::digest::finish_digest;
use super::read::{Definitions, Files};
use super::report::{Promised, Report};
use super::resolve::{
    BuildingStyleWorld, Names, StyleWorld, resolve_audit, resolve_building_styles, resolve_classes,
    resolve_households, resolve_palettes, resolve_pieces, resolve_room_types, resolve_styles,
    resolve_typologies, resolve_words,
};
use super::table::{Extends, Table};
use super::{BuildingStyle, ById, Catalog, Class, DEFAULT_STYLE, DefinitionKind, Origin, Palette, Style};
use crate::document::{Fault, Faults, Warned};
use crate::plan::GENERIC_ROOM_TYPE;

/// Reads the built-in configuration and then the users' folders, each of which may hold `classes/`,
/// `rooms/`, `styles/`, `palettes/`, `room_words.yaml`, `households.yaml`, `typologies.yaml` and `audit.yaml`.
///
/// A definition replaces the one of the same id in an earlier folder whole, unless it `extends` itself.
/// Definitions that extend or name an id use its last definition. Room words are merged word by word,
/// thresholds of the audit one by one.
///
/// # Errors
/// All faults of all files at once, by file and place.
pub fn load_catalog(extra_folders: &[PathBuf]) -> Result<Warned<Catalog>, Faults> {
    let mut files = Files::default();
    files.add_builtin();
    for folder in extra_folders {
        files.add_folder(folder);
    }
    load_files(&files)
}

/// What [`load_catalog`] gives without folders, for tests: read once, as it takes a second without optimisation.
#[cfg(test)]
pub(crate) fn builtin_catalog() -> &'static Catalog {
    static CATALOG: std::sync::LazyLock<Catalog> =
        std::sync::LazyLock::new(|| load_catalog(&[]).unwrap_or_else(|faults| panic!("{faults}")).value);
    &CATALOG
}

/// As [`load_catalog`], but with the catalogue as far as it goes, for reading on in search of faults. What faulty files may
/// define counts as known to its room words.
pub(crate) fn load_catalog_so_far(extra_folders: &[PathBuf]) -> (Catalog, Faults) {
    let mut files = Files::default();
    files.add_builtin();
    for folder in extra_folders {
        files.add_folder(folder);
    }
    let (definitions, mut report) = files.parse();
    let mut catalog = resolve(&definitions, &files, &mut report);
    let words = &mut catalog.room_words;
    match report.promised {
        Promised::Everything => words.accept_everything(),
        Promised::Words(promised) => {
            words.known.extend(promised.iter().cloned());
            words.styles.extend(promised);
        }
    }
    let mut faults = report.faults;
    faults.sort();
    (catalog, faults)
}

/// From files to the catalogue.
pub(super) fn load_files(files: &Files) -> Result<Warned<Catalog>, Faults> {
    let (definitions, mut report) = files.parse();
    let catalog = resolve(&definitions, files, &mut report);
    report.faults.into_result(catalog)
}

/// The catalogue as far as it is without faults.
fn resolve(definitions: &Definitions, files: &Files, report: &mut Report<'_>) -> Catalog {
    let class_chains = definitions.classes.chains(report);
    let mut names = Names::new(&definitions.classes, &class_chains, report);
    let of_files = definitions.households.iter().flat_map(|(_, file)| file.households.keys());
    names.households = of_files.map(String::as_str).collect();
    let mut classes = resolve_classes(&class_chains, &names, files, report);
    // A class that is missing for a fault of its own would take its children with it.
    if classes.len() == names.class_count() && !report.faults.has_errors() {
        find_depths(&mut classes, report);
    }
    let palettes: ById<Palette> =
        resolve_palettes(&definitions.palettes.chains(report), report).into_iter().collect();
    let room_types = resolve_room_types(&definitions.room_types.chains(report), &names, report);
    let world = StyleWorld {
        names: &names,
        room_types: &definitions.room_types,
        palette_table: &definitions.palettes,
        palettes: &palettes,
    };
    let styles = resolve_styles(&definitions.styles.chains(report), &world, report);
    check_programmes(&room_types, &styles, &names, report);
    let styles: ById<Style> = styles.into_iter().map(|resolved| resolved.style).collect();
    let building_styles = building_styles(definitions, &styles, report);
    let style_words = definitions.styles.ids().chain(definitions.building_styles.ids());
    let households = resolve_households(&definitions.households, &definitions.room_types, report);
    let typologies = resolve_typologies(&definitions.typologies, &definitions.room_types, report);
    let mut room_words = resolve_words(&definitions.words, &definitions.room_types, style_words, report);
    room_words.households = households.kinds.keys().cloned().collect();
    let audit = resolve_audit(&definitions.audit, report);
    check_indispensable(definitions, report);

    let classes: Vec<Class> = classes.into_iter().map(|resolved| resolved.class).collect();
    let class_ids = definitions.classes.ids().collect();
    room_words.pieces = resolve_pieces(&definitions.words, &class_ids, report);
    Catalog {
        digest: finish_digest(files.digest(), &classes, report),
        classes,
        room_types: by_id(room_types.into_iter().map(|resolved| resolved.room_type), |one| &one.id),
        // Where there is none, that is a fault: see `check_indispensable`.
        default_style: styles.find(DEFAULT_STYLE).unwrap_or_default(),
        styles,
        building_styles: by_id(building_styles, |one| &one.id),
        palettes,
        room_words,
        households,
        typologies,
        audit,
        origins: find_origins(definitions, files),
    }
}

fn building_styles(
    definitions: &Definitions,
    styles: &ById<Style>,
    report: &mut Report<'_>,
) -> Vec<BuildingStyle> {
    let Definitions { room_types, styles: style_table, building_styles, .. } = definitions;
    let world = BuildingStyleWorld { room_types, style_table, styles };
    resolve_building_styles(&building_styles.chains(report), &world, report)
}

fn by_id<T>(values: impl IntoIterator<Item = T>, id: impl Fn(&T) -> &String) -> BTreeMap<String, T> {
    values.into_iter().map(|value| (id(&value).clone(), value)).collect()
}

/// The definitions that other stages fall back to must exist.
fn check_indispensable(definitions: &Definitions, report: &mut Report<'_>) {
    if definitions.styles.get(DEFAULT_STYLE).is_none() {
        let message = format!("no folder defines the style \"{DEFAULT_STYLE}\"");
        report.error_of_all(Fault::of_file(Path::new("styles"), message));
    }
    let generic = definitions.room_types.get(GENERIC_ROOM_TYPE);
    if generic.is_none_or(|definition| definition.entry.is_abstract) {
        let message = format!("no folder defines the room type \"{GENERIC_ROOM_TYPE}\"");
        report.error_of_all(Fault::of_file(Path::new("rooms"), message));
    }
}

fn find_origins(definitions: &Definitions, files: &Files) -> BTreeMap<(DefinitionKind, String), Origin> {
    let mut origins = BTreeMap::new();
    add_origins(&definitions.classes, DefinitionKind::Class, files, &mut origins);
    add_origins(&definitions.room_types, DefinitionKind::RoomType, files, &mut origins);
    add_origins(&definitions.styles, DefinitionKind::Style, files, &mut origins);
    add_origins(&definitions.building_styles, DefinitionKind::BuildingStyle, files, &mut origins);
    add_origins(&definitions.palettes, DefinitionKind::Palette, files, &mut origins);
    origins
}

fn add_origins<T: Extends>(
    table: &Table<T>,
    kind: DefinitionKind,
    files: &Files,
    origins: &mut BTreeMap<(DefinitionKind, String), Origin>,
) {
    let mut lines: BTreeMap<usize, BTreeMap<&str, usize>> = BTreeMap::new();
    for id in table.ids() {
        let definition = table.get(id).expect("the id comes from the table");
        let number = definition.spot.source;
        let source = &files.sources[number];
        let lines = lines.entry(number).or_insert_with(|| lines_of_keys(source.text()));
        let origin = Origin {
            file: source.file().to_owned(),
            line: lines.get(id).copied(),
            extends: definition.entry.base().map(str::to_owned),
        };
        origins.insert((kind, id.to_owned()), origin);
    }
}

/// The line on which each id is defined: of the lines that begin with it as a key, the one that is indented least,
/// but is no key of the file itself. Parsing the tree once more for this would cost as much as all the rest.
fn lines_of_keys(text: &str) -> BTreeMap<&str, usize> {
    let mut found: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for (index, line) in text.lines().enumerate() {
        let rest = line.trim_start();
        let indent = line.len() - rest.len();
        let Some((key, _)) = rest.split_once(':').filter(|_| indent > 0) else { continue };
        let place = (indent, index + 1);
        let key = key.trim_start_matches('"').trim_end().trim_end_matches('"');
        found.entry(key).and_modify(|first| *first = place.min(*first)).or_insert(place);
    }
    found.into_iter().map(|(key, (_, line))| (key, line)).collect()
}
