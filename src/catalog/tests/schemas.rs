//! The published schemas are those of the types that are read.

use std::path::Path;

use schemars::{JsonSchema, schema_for};

use crate::catalog::audit::AuditFile;
use crate::catalog::file::{ClassFile, PaletteFile, RoomFile, StyleFile, WordsFile};

/// Writes a schema that differs and tells so.
fn is_published<T: JsonSchema>(name: &str) -> bool {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/schema").join(format!("{name}.schema.json"));
    let text = serde_json::to_string_pretty(&schema_for!(T)).unwrap() + "\n";
    let is_same = std::fs::read_to_string(&path).is_ok_and(|published| published == text);
    if !is_same {
        std::fs::write(&path, text).unwrap();
        eprintln!("{} has been written anew: look at it and run again", path.display());
    }
    is_same
}

#[test]
fn published_schemas_are_up_to_date() {
    let all = [
        is_published::<ClassFile>("classes"),
        is_published::<RoomFile>("rooms"),
        is_published::<StyleFile>("styles"),
        is_published::<PaletteFile>("palettes"),
        is_published::<WordsFile>("room_words"),
        is_published::<AuditFile>("audit"),
    ];
    assert_eq!(all, [true; 6], "schemas have been written anew");
}
