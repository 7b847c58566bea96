//! Finds the real plans for tests; they are no part of the project.

use std::path::{Path, PathBuf};

use crate::document::Source;
use crate::plan::{Building, BuildingDraft, PlanOptions, RoomWords, write_native};

/// A folder of the shared floor plans, or `None` with a printed reason where it is absent.
pub(in crate::plan) fn folder(name: &str) -> Option<PathBuf> {
    present(PathBuf::from("../shared/data/floorplans").join(name))
}

/// A file of the shared maps of footprints, or `None` with a printed reason where it is absent.
pub(in crate::plan) fn footprints(name: &str) -> Option<PathBuf> {
    present(PathBuf::from("../shared/data/footprints").join(name))
}

fn present(path: PathBuf) -> Option<PathBuf> {
    if path.exists() {
        return Some(path);
    }
    println!("skipped: {} is absent", path.display());
    None
}

/// The drafts of all buildings of a plan in one of the shared folders.
pub(in crate::plan) fn drafts(path: &Path, words: &RoomWords) -> Vec<BuildingDraft> {
    let reading = super::read_drafts(path, &crate::plan::PlanOptions::new(words));
    reading.drafts.into_iter().map(|drafted| drafted.draft).collect()
}

/// The words of a published vocabulary, from `tests/cases/words/`.
pub(in crate::plan) fn published(vocabulary: &str) -> Vec<String> {
    let path = format!("tests/cases/words/{vocabulary}.txt");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect()
}

/// The project's own table of room words.
pub(super) fn words() -> RoomWords {
    #[derive(serde::Deserialize, schemars::JsonSchema)]
    struct Table {
        #[allow(dead_code)]
        version: u32,
        formats: std::collections::BTreeMap<String, std::collections::BTreeMap<String, String>>,
    }
    let path = PathBuf::from("configs/room_words.yaml");
    let text = std::fs::read_to_string(&path).unwrap();
    let table: Table = Source::new(&path, &text).parse().unwrap();
    let lower = |words: std::collections::BTreeMap<String, String>| {
        words.into_iter().map(|(word, kind)| (word.to_lowercase(), kind)).collect()
    };
    let words = table.formats.into_iter().map(|(format, words)| (format, lower(words))).collect();
    RoomWords { known: ["toilet".to_owned()].into(), words, ..RoomWords::default() }
}

/// Asserts that all levels of a plan are the same, to the last bit, read from it and from its native plan.
pub(super) fn assert_comes_back(path: &Path) {
    let mut words = words();
    words.accept_everything();
    let options = PlanOptions::new(&words);
    let paths = [path.to_owned()];
    let direct = super::read_plans(&paths, &options);
    let imported = super::read_plans(&paths, &PlanOptions { is_for_writing: true, ..options });
    assert_eq!(direct.plan.buildings.len(), imported.plan.buildings.len());
    for (direct, imported) in direct.plan.buildings.iter().zip(&imported.plan.buildings) {
        let text = write_native(&imported.building, &imported.id);
        let again = super::parse_plan(Source::new(Path::new("plan.yaml"), &text), &options);
        let [again] = again.plan.buildings.as_slice() else { panic!("{}", again.faults) };
        assert_eq!(again.building.attribution, direct.building.attribution);
        let digests = |building: &Building| -> Vec<[u8; 32]> {
            building.levels.iter().map(|level| level.digest).collect()
        };
        assert_eq!(digests(&again.building), digests(&direct.building), "{}", path.display());
    }
}
