//! The JSON Schemas in `configs/schema/` are those of the types that are read and written.
//!
//! `UPDATE_GOLDENS=1 cargo test --lib published_schemas` writes them anew.

use std::fs;
use std::path::Path;

use schemars::{JsonSchema, Schema, schema_for};

use super::answer::answer_schemas;
use crate::batch::Manifest;
use crate::catalog::{AuditFile, ClassFile, HouseholdsFile, PaletteFile, RoomFile, StyleFile, WordsFile};
use crate::contract::Extras;
use crate::diff::Report;
use crate::edits::EditsFile;
use crate::navigation::{IndexFile, MeshFile};
use crate::plan::{PlanFile, ProjectFile};
use crate::storey::Typologies;
use crate::world::PathFile;

fn schema<T: JsonSchema>(name: &str) -> (String, Schema) {
    (name.to_owned(), schema_for!(T))
}

/// Every schema by its path below `configs/schema/`, without `.schema.json`.
fn schemas() -> Vec<(String, Schema)> {
    let files = [
        schema::<AuditFile>("audit"),
        schema::<ClassFile>("classes"),
        schema::<EditsFile>("edits"),
        schema::<Extras>("extras"),
        schema::<HouseholdsFile>("households"),
        schema::<Manifest>("manifest"),
        schema::<MeshFile>("navigation"),
        schema::<IndexFile>("navigation_index"),
        schema::<PathFile>("path"),
        schema::<PlanFile>("plan"),
        schema::<PaletteFile>("palettes"),
        schema::<ProjectFile>("project"),
        schema::<Report>("diff"),
        schema::<RoomFile>("rooms"),
        schema::<StyleFile>("styles"),
        schema::<Typologies>("typologies"),
        schema::<WordsFile>("room_words"),
    ];
    let answers = answer_schemas().into_iter().map(|(name, schema)| (format!("answers/{name}"), schema));
    files.into_iter().chain(answers).collect()
}

#[test]
fn published_schemas_are_those_of_the_types() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/schema");
    let mut differing = Vec::new();
    for (name, schema) in schemas() {
        let path = folder.join(format!("{name}.schema.json"));
        let text = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        if fs::read_to_string(&path).is_ok_and(|published| published == text) {
            continue;
        }
        if std::env::var_os("UPDATE_GOLDENS").is_some() {
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(&path, text).unwrap();
        } else {
            differing.push(name);
        }
    }
    assert!(differing.is_empty(), "{differing:?} differ; renew with UPDATE_GOLDENS=1 and look at them");
}

#[test]
fn every_published_schema_is_one_of_a_type() {
    let names: Vec<String> = schemas().into_iter().map(|(name, _)| name).collect();
    for file in crate::catalog::builtin_files() {
        let Some(name) = file.path.strip_prefix("schema/") else { continue };
        let name = name.strip_suffix(".schema.json").unwrap();
        assert!(names.iter().any(|known| known == name), "{name}");
    }
}
