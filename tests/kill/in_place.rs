//! Checks that every file with its final name in an output folder is whole.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

/// Panics at a file that is not.
pub(crate) fn check(out: &Path) {
    for path in files(out) {
        let bytes = fs::read(&path).unwrap();
        let shown = path.display();
        let ending = path.extension().unwrap_or_default().to_str().unwrap();
        match ending {
            "glb" => {
                let glb = gltf::Gltf::from_slice(&bytes).unwrap_or_else(|error| panic!("{shown}: {error}"));
                assert!(glb.blob.is_some(), "{shown} has no bytes");
                let text = gltf::Glb::from_slice(&bytes).unwrap().json.into_owned();
                check_references(&path, &parsed(&path, &text));
            }
            "gltf" => check_references(&path, &parsed(&path, &bytes)),
            "json" => check_manifest(&path, &parsed(&path, &bytes)),
            "png" => assert!(bytes.ends_with(b"IEND\xae\x42\x60\x82"), "{shown} is cut off"),
            // Its length is looked at by those that refer to it.
            "bin" => {}
            _ => panic!("{shown} is none of ours"),
        }
    }
}

fn parsed(path: &Path, text: &[u8]) -> Value {
    serde_json::from_slice(text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A floor may be opened by viewers that know nothing of the bake: what it refers to is there.
fn check_references(path: &Path, document: &Value) {
    let list = |key: &str| document[key].as_array().cloned().unwrap_or_default();
    for buffer in list("buffers") {
        let Some(uri) = buffer["uri"].as_str() else { continue };
        let length = fs::metadata(path.with_file_name(uri)).map(|found| found.len());
        assert_eq!(length.ok(), buffer["byteLength"].as_u64(), "{} and {uri}", path.display());
    }
    for image in list("images") {
        let Some(uri) = image["uri"].as_str() else { continue };
        assert!(path.with_file_name(uri).is_file(), "{} and {uri}", path.display());
    }
}

fn check_manifest(path: &Path, manifest: &Value) {
    let levels = manifest["levels"].as_array().unwrap_or_else(|| panic!("{}", path.display()));
    assert!(levels.iter().all(|level| level["files"][0]["sha256"].is_string()), "{}", path.display());
}

/// All files but those of the program's own corner.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with(".roomwright") {
            found.extend(files(&path));
        } else if path.is_file() {
            found.push(path);
        }
    }
    found
}
