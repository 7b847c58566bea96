//! Damaged files never end the program.

use std::path::PathBuf;

use proptest::prelude::*;

use super::cases::load_above_base;
use super::resolved::folder;

/// One file of each kind with every key.
const FILES: [(&str, &str); 6] = [
    (
        "classes/a.yaml",
        "version: 1
classes:
  rack:
    label: Rack
    groups: [surface, store]
    sizes: [[1.6, 0.8, 0.74]]
    looks: 2
    shape: [{from: [0, 0, \"100%-0.03\"], to: [\"100%\", \"100%\", \"100%\"]}, {disc: true, from: [0, 0, 0], to: [0.1, 0.1, 0.1]}]
    parents: [{on: wall, side: front, turn: parallel, along: random, gap: [0, 0.1], elevation: 0, jitter: 3, tag: north}, {on: [surface], side: above}]
    sides: {front: {places: 1}, above: {places: 6, margin: 0.03, surface: 0.7, space: 1}}
    clearances: {side: front, minimum: 0.75, good: 0.91, margin: 0, height: 2.0, children: true}
    relations: [{faces: chair, distance: [1.5, 4], angle: 30, weight: 1}]
    grid: {interval: [2.4, 2.4], centered: true}
    priority: 5
    model: {recipe: desk, drawers: 3}
  tall_rack: {extends: rack, abstract: false}
",
    ),
    (
        "rooms/a.yaml",
        "version: 1
room_types:
  study:
    extends: office
    furnish: true
    density: [0.25, 0.45]
    excludes: [sleeping]
    finish: {floor: parquet, wall: plaster, ceiling: ceiling}
    programme: [{class: [rack, chair], count: {per_area: 0.2, least: 1, most: 6}, area: [9, 200], chance: 0.5, window: true}]
",
    ),
    (
        "styles/a.yaml",
        "version: 1
styles:
  inn: {extends: default, room_types: [study], palette: warm, untidiness: {turn: 3, distance: 0.1}, density: 1, additions: {study: [{class: rack}]}}
",
    ),
    ("palettes/a.yaml", "version: 1\npalettes:\n  warm: {extends: modern, materials: {wood: {color: \"#b58a5a\", roughness: 0.6}}}\n"),
    ("room_words.yaml", "version: 1\nformats:\n  archilyse: {BEDROOM: office}\n"),
    ("audit.yaml", "version: 1\nthresholds:\n  walking: {person: 0.5}\n  screens: {angle: 20}\n"),
];

/// The damage to files.
const SCRAPS: [&str; 20] = [
    "-", ": ", "[", "]", "{", "}", "\"", "#", "%", "\n", "  ", "1e999", "-1", ".nan", "rack", "floor", "é",
    "&a *a", "null", "0",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_damaged_file_is_read_or_rejected(
        file in 0..FILES.len(),
        edits in prop::collection::vec((0.0..1.0_f64, 0..12_usize, 0..SCRAPS.len()), 1..4),
    ) {
        let mut files = FILES.map(|(name, text)| (name, text.to_owned()));
        let text = &mut files[file].1;
        for (place, cut, scrap) in edits {
            let mut letters: Vec<char> = text.chars().collect();
            let from = (place * letters.len() as f64) as usize;
            let to = (from + cut).min(letters.len());
            letters.splice(from..to, SCRAPS[scrap].chars());
            *text = letters.into_iter().collect();
        }
        let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (*name, text.as_str())).collect();
        let folder = folder(&files);
        let folders: [PathBuf; 1] = [folder.path().to_owned()];
        if let Err(faults) = load_above_base(&folders) {
            prop_assert!(faults.has_errors());
            prop_assert!(faults.0.iter().all(|fault| !fault.message.is_empty()));
        }
    }
}

#[test]
fn the_undamaged_files_are_good() {
    let folder = folder(&FILES);
    let (catalog, warnings) =
        load_above_base(&[folder.path().to_owned()]).unwrap_or_else(|faults| panic!("{faults}"));
    assert!(warnings.is_empty(), "{warnings}");
    assert!(catalog.class_index("tall_rack").is_some());
}

/// Classes of which each extends the one that `base` names of its number.
fn extending(count: usize, base: impl Fn(usize) -> String) -> String {
    let line = |number: usize| format!("  c{number:05}: {{extends: {}}}\n", base(number));
    let lines: String = (0..count).map(line).collect();
    format!("version: 1\nclasses:\n{lines}")
}

#[test]
fn many_classes_take_a_time_that_grows_with_their_number() {
    const STEEPEST: f64 = 1.4;
    let make = |count: usize| {
        let members = "  many: {extends: table, groups: [crowd]}\n";
        let text = extending(count, |_| "many".to_owned());
        folder(&[("classes/a.yaml", &format!("{text}{members}"))])
    };
    let run = |folder: tempfile::TempDir| drop(load_above_base(&[folder.path().to_owned()]).unwrap());
    let power = crate::growth::growth(1_000, 8, STEEPEST, make, run);
    assert!(power < STEEPEST, "time grows with the power {power:.2} of the number of classes");
}

#[test]
fn a_row_of_classes_that_extend_each_other_has_an_end() {
    let base = |number: usize| if number == 0 { "table".to_owned() } else { format!("c{:05}", number - 1) };
    let load = |count: usize| {
        let folder = folder(&[("classes/a.yaml", &extending(count, base))]);
        load_above_base(&[folder.path().to_owned()])
    };
    assert!(load(60).is_ok());
    let faults = load(200).unwrap_err();
    let message = "class \"c00199\" extends more than 64 others in a row";
    assert!(faults.0.iter().any(|fault| fault.message == message), "{faults}");
}
