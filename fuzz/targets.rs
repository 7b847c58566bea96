//! The fuzz targets: one function for each kind of input, for cargo-fuzz and for `tests/fuzz`.
//!
//! A target panics where the program would, and if an answer must not be shown: too many faults, control characters.
//! Formats of several files come as one text, a bundle: `=== <path>` before each file.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use roomwright::internals::batch::merge;
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::diff::{DiffOptions, Tolerance, compare};
use roomwright::internals::document::Faults;
use roomwright::internals::edits::read_edits;
use roomwright::internals::model::ModelLibrary;
use roomwright::internals::plan::{Building, Plan, PlanOptions, drawn_furniture, read_plans, write_native};
use roomwright::internals::read_back::{parse_inventory, parse_level, parse_survey};
use roomwright::internals::solve::judge_room;
use roomwright::internals::storey::Choices;
use tempfile::TempDir;

/// Reads an input; answers whether anything came of it.
pub type Target = fn(&[u8]) -> bool;

/// All targets by name, which is also that of their folder of cases: a new one is a line here and a case below `corpus/`. The cases
/// of `plan_import` are the folders of `tests/cases/plan_import`, a bundle each: a new reader needs no line.
pub const TARGETS: &[(&str, Target)] = &[
    ("archilyse", read_bundle_of_plans),
    ("catalog", read_catalog),
    ("cityjson", plan_cityjson),
    ("diff", compare_floors),
    ("drawing", read_bundle_of_plans),
    ("edits", read_edits_of_a_plan),
    ("floor", judge_floor),
    ("geojson", plan_geojson),
    ("honeybee", read_honeybee),
    ("ifc", read_ifc),
    ("imdf", read_bundle_of_plans),
    ("indoor", read_indoor),
    ("manifest", join_records),
    ("mlit", read_bundle_of_plans),
    ("model", read_model),
    ("osm", plan_osm),
    ("pbf", plan_pbf),
    ("plan", read_plan),
    (PLAN_IMPORT, read_bundle_of_plans),
    ("resplan", read_resplan),
    ("sweet_home", read_sweet_home),
    ("swiss_dwellings", read_swiss_dwellings),
];

/// The target whose cases are those of the readers' tests.
pub const PLAN_IMPORT: &str = "plan_import";

/// Faults of one input at most: those of each room and object, not of each byte.
const MOST_FAULTS: usize = 10_000;
/// Characters of one fault at most: place, fact, an excerpt, hint.
const LONGEST_FAULT: usize = 20_000;

static CATALOG: LazyLock<Catalog> = LazyLock::new(|| load_catalog(&[]).unwrap().value);

/// A floor as it was baked.
const FLOOR: &[u8] = include_bytes!("corpus/floor/toilet.glb");

/// What `plan` chooses where the command line says nothing.
static CHOICES: LazyLock<Choices> = LazyLock::new(|| Choices { seed: 1, ..Choices::default() });

/// The plan whose rooms are edited.
const EDITED: &str = "version: 1\nid: a\nlevels:\n  - id: \"1\"\n    height: 3\n    rooms:\n      \
                      - {id: study, type: study, rectangle: [0, 0, 4, 4]}\n";

static PLAN: LazyLock<Plan> = LazyLock::new(|| {
    let folder = folder(&[("plan.yaml", EDITED.as_bytes())]);
    read_plans(&[folder.path().to_owned()], &PlanOptions::new(&CATALOG.room_words)).plan
});

/// Reads an input with the target of a name.
#[allow(dead_code)] // the seeded tests take the table
pub fn run(name: &str, data: &[u8]) {
    let (_, target) = TARGETS.iter().find(|(known, _)| *known == name).unwrap();
    target(data);
}

/// Prepares what all inputs share, so that none is charged for it.
#[allow(dead_code)] // cargo-fuzz charges nobody
pub fn warm_up() {
    assert!(!PLAN.buildings.is_empty());
}

fn read_plan(data: &[u8]) -> bool {
    // The reader goes by the ending, people by what is in it.
    let is_json = data.trim_ascii_start().starts_with(b"{");
    read_files(&[(if is_json { "plan.json" } else { "plan.yaml" }, data)], "")
}

/// A model of dragonfly or honeybee: both have the same keys at their outside.
fn read_honeybee(data: &[u8]) -> bool {
    read_files(&[("model.json", data)], "")
}

fn read_ifc(data: &[u8]) -> bool {
    read_files(&[("building.ifc", data)], "")
}

/// A packed home or its text.
fn read_sweet_home(data: &[u8]) -> bool {
    read_files(&[("home.sh3d", data)], "")
}

fn read_resplan(data: &[u8]) -> bool {
    read_files(&[("plan.json", data)], "")
}

/// A table of floors.
fn read_swiss_dwellings(data: &[u8]) -> bool {
    read_files(&[("geometries.csv", data)], "")
}

fn read_bundle_of_plans(data: &[u8]) -> bool {
    read_files(&unbundled(data), "site")
}

/// Reads files below a folder, and the furniture of those that draw some.
fn read_files(files: &[(&str, &[u8])], below: &str) -> bool {
    let files: Vec<(String, &[u8])> =
        files.iter().map(|(path, bytes)| (format!("{below}/{path}"), *bytes)).collect();
    let folder = written(&files);
    let input = if below.is_empty() {
        folder.path().join(files[0].0.trim_start_matches('/'))
    } else {
        folder.path().join(below)
    };
    let options = PlanOptions::new(&CATALOG.room_words);
    for (path, _) in &files {
        if let Err(faults) = drawn_furniture(&folder.path().join(path.trim_start_matches('/')), &options) {
            check_faults(&faults);
        }
    }
    let reading = read_plans(&[input], &options);
    check_faults(&reading.faults);
    !reading.plan.buildings.is_empty()
}

/// A map of rooms; its encoding shows in what is in it.
fn read_indoor(data: &[u8]) -> bool {
    let is_json = data.trim_ascii_start().starts_with(b"{");
    read_files(&[(if is_json { "map.geojson" } else { "map.osm" }, data)], "")
}

fn plan_geojson(data: &[u8]) -> bool {
    plan_map("map.geojson", data)
}

fn plan_cityjson(data: &[u8]) -> bool {
    plan_map("map.city.json", data)
}

fn plan_osm(data: &[u8]) -> bool {
    plan_map("map.osm", data)
}

fn plan_pbf(data: &[u8]) -> bool {
    plan_map("map.osm.pbf", data)
}

/// Rooms of the largest building that is read again: a tower of 200 storeys takes more than other inputs.
const MOST_ROOMS: usize = 4_000;

/// As `plan` does, and as `bake` reads what it wrote: that has no error, and no room is lost.
fn plan_map(name: &str, data: &[u8]) -> bool {
    let options = PlanOptions::new(&CATALOG.room_words).with_planning(&CATALOG.typologies, &CHOICES);
    let folder = folder(&[(name, data)]);
    let planned = read_plans(&[folder.path().join(name)], &options);
    check_faults(&planned.faults);
    let mut plans: Vec<(PathBuf, usize)> = Vec::new();
    let is_planned = !planned.plan.buildings.is_empty();
    // One by one, and each is given back.
    for (number, placed) in planned.plan.buildings.into_iter().enumerate() {
        if room_count(&placed.building) > MOST_ROOMS {
            continue;
        }
        let path = folder.path().join(format!("{number}.yaml"));
        fs::write(&path, write_native(&placed.building, &placed.id)).unwrap();
        plans.push((path, room_count(&placed.building)));
    }
    for (path, count) in &plans {
        let read = read_plans(std::slice::from_ref(path), &options);
        assert!(!read.faults.has_errors(), "{}", read.faults);
        assert_eq!(room_count(&read.plan.buildings[0].building), *count);
    }
    is_planned
}

fn room_count(building: &Building) -> usize {
    building.levels.iter().map(|level| level.rooms.len()).sum()
}

fn read_catalog(data: &[u8]) -> bool {
    let folder = folder(&unbundled(data));
    let read = load_catalog(&[folder.path().to_owned()]);
    check_faults(read.as_ref().map_or_else(|faults| faults, |read| &read.warnings));
    read.is_ok()
}

fn read_edits_of_a_plan(data: &[u8]) -> bool {
    let folder = folder(&[("a.edits.yaml", data)]);
    let (book, faults) = read_edits(&PLAN, &[folder.path().join("a.edits.yaml")], &CATALOG);
    check_faults(&faults);
    !book.is_empty()
}

/// As `audit` and `edits capture` do.
fn judge_floor(data: &[u8]) -> bool {
    let file = Path::new("damaged.glb");
    let level = parse_level(file, data, &CATALOG);
    if let Ok(read) = &level {
        check_faults(&read.faults);
        for (room, furnished) in read.furnished.iter().enumerate() {
            let Some(furnished) = furnished else { continue };
            let verdict = judge_room(read.level.room(room), furnished, &CATALOG);
            assert!(verdict.findings.iter().all(|finding| !finding.measured.is_nan()), "{verdict:?}");
        }
    }
    if let Ok((_, faults)) = parse_inventory(file, data) {
        check_faults(&faults);
    }
    parse_survey(file, data).is_ok() && level.is_ok_and(|read| read.furnished.iter().any(Option::is_some))
}

fn compare_floors(data: &[u8]) -> bool {
    let folder = folder(&[("old.glb", FLOOR), ("new.glb", data)]);
    compare_in(&folder, ["old.glb", "new.glb"])
}

fn compare_in(folder: &TempDir, names: [&str; 2]) -> bool {
    let [old, new] = names.map(|name| folder.path().join(name));
    let observer = |_, _| {};
    let options = DiffOptions {
        catalog: &CATALOG,
        tolerance: Tolerance::default(),
        is_thorough: true,
        observer: &observer,
    };
    let compared = compare(&old, &new, &options);
    check_faults(compared.as_ref().map_or_else(|faults| faults, |(_, faults)| faults));
    let text = compared
        .as_ref()
        .map(|(report, _)| roomwright::internals::diff::text(report, false))
        .unwrap_or_default();
    assert!(!text.contains('\u{1b}'), "{text}");
    compared.is_ok()
}

/// As `merge` and `diff` do; nothing outside the folder changes.
fn join_records(data: &[u8]) -> bool {
    let mut files: Vec<(String, &[u8])> =
        unbundled(data).iter().map(|(path, bytes)| (format!("out/{path}"), *bytes)).collect();
    files.push(("out/a/1.glb".to_owned(), FLOOR));
    files.push(("victim".to_owned(), b"precious"));
    let folder = written(&files);
    compare_in(&folder, ["out", "out"]);
    let joined = merge(&folder.path().join("out"));
    assert_eq!(fs::read(folder.path().join("victim")).unwrap(), b"precious");
    let outside = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(outside, 2, "the folder and the victim");
    assert!(folder.path().join("out/a/1.glb").exists(), "a merge deletes no floor");
    joined.is_ok()
}

/// As the model of a class of one's own.
fn read_model(data: &[u8]) -> bool {
    const CLASS: &[u8] = b"version: 1\nclasses:\n  crate:\n    label: Crate\n    sizes: [[1, 1, 1]]\n    \
                           parents: [{on: floor}]\n    model: {file: crate.glb}\n";
    let folder = folder(&[("classes/mine.yaml", CLASS), ("classes/crate.glb", data)]);
    let models = load_catalog(&[folder.path().to_owned()]).and_then(|read| ModelLibrary::load(&read.value));
    check_faults(models.as_ref().err().unwrap_or(&Faults::default()));
    models.is_ok()
}

/// Faults that can be shown.
fn check_faults(faults: &Faults) {
    assert!(faults.0.len() <= MOST_FAULTS, "{} faults", faults.0.len());
    for fault in &faults.0 {
        let shown = fault.to_string();
        assert!(shown.len() <= LONGEST_FAULT, "a fault of {} characters", shown.len());
        let control = shown.chars().find(|&found| found.is_control() && found != '\n');
        assert_eq!(control, None, "{shown:?}");
    }
}

/// The files of a bundle; names that lead elsewhere are left out.
fn unbundled(data: &[u8]) -> Vec<(&str, &[u8])> {
    const MARK: &[u8] = b"=== ";
    let mut files = Vec::new();
    let mut rest = data;
    while let Some(after) = rest.strip_prefix(MARK) {
        let Some(line) = after.iter().position(|&byte| byte == b'\n') else { break };
        let body = &after[line + 1..];
        let end =
            body.windows(MARK.len() + 1).position(|found| found == b"\n=== ").map_or(body.len(), |at| at + 1);
        let is_plain = |step: &str| {
            step.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c))
                && !matches!(step, "" | "." | "..")
        };
        if let Ok(path) = std::str::from_utf8(&after[..line])
            && path.len() < 100
            && path.split('/').all(is_plain)
        {
            files.push((path, &body[..end]));
        }
        rest = &body[end..];
    }
    files
}

fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let files: Vec<(String, &[u8])> =
        files.iter().map(|(path, bytes)| ((*path).to_owned(), *bytes)).collect();
    written(&files)
}

/// A folder with these files; where two cannot be, the first is.
fn written(files: &[(String, &[u8])]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, bytes) in files {
        let path: PathBuf = folder.path().join(path.trim_start_matches('/'));
        if fs::create_dir_all(path.parent().unwrap()).is_ok() && !path.exists() {
            let _ = fs::write(path, bytes);
        }
    }
    folder
}
