//! The digest changes if and only if configuration that was read has changed.

use std::path::PathBuf;

use tempfile::TempDir;

use super::cases::load_above_base;
use super::resolved::{folder, write};
use crate::catalog::load_catalog;

const VASE: &str = "version: 1\nclasses:\n  vase: {sizes: [[0.1, 0.1, 0.3]], parents: {on: floor}, model: {file: vase.gltf}}\n";
const MODEL: &str = r#"{"asset": {"version": "2.0"}, "buffers": [{"uri": "vase.bin"}, {"uri": "data:,"}]}"#;

fn vase() -> TempDir {
    folder(&[("classes/vase.yaml", VASE), ("classes/vase.gltf", MODEL), ("classes/vase.bin", "bytes")])
}

fn digest(folders: &[&TempDir]) -> [u8; 32] {
    let folders: Vec<PathBuf> = folders.iter().map(|folder| folder.path().to_owned()).collect();
    load_above_base(&folders).unwrap_or_else(|faults| panic!("{faults}")).0.digest
}

#[test]
fn the_digest_does_not_depend_on_the_place_of_the_folder() {
    assert_eq!(digest(&[&vase()]), digest(&[&vase()]));
    assert_eq!(load_catalog(&[]).unwrap().value.digest, load_catalog(&[]).unwrap().value.digest);
}

#[test]
fn the_digest_changes_with_every_byte_that_is_read() {
    let folder = vase();
    let before = digest(&[&folder]);
    let mut seen = vec![digest(&[]), before];
    for (name, text) in [
        ("classes/vase.yaml", format!("{VASE}# a comment\n")),
        ("classes/vase.gltf", format!("{MODEL}\n")),
        ("classes/vase.bin", "other bytes".to_owned()),
    ] {
        write(folder.path(), name, &text);
        let after = digest(&[&folder]);
        assert!(!seen.contains(&after), "{name}");
        seen.push(after);
    }
}

#[test]
fn the_digest_covers_files_with_encoded_names_and_those_beside_a_container() {
    let model = MODEL
        .replace("vase.bin", "parts/the%20vase.bin")
        .replace("}]}", "}], \"images\": [{\"uri\": \"glaze.png\"}]}");
    let folder = folder(&[("classes/vase.yaml", &VASE.replace("vase.gltf", "vase.glb"))]);
    write(folder.path(), "classes/parts/the vase.bin", "bytes");
    write(folder.path(), "classes/glaze.png", "green");
    let glb = gltf::Glb {
        header: gltf::binary::Header { magic: *b"glTF", version: 2, length: 0 },
        json: model.into_bytes().into(),
        bin: None,
    };
    std::fs::write(folder.path().join("classes/vase.glb"), glb.to_vec().unwrap()).unwrap();
    let before = digest(&[&folder]);
    write(folder.path(), "classes/parts/the vase.bin", "BYTES");
    let after = digest(&[&folder]);
    assert_ne!(after, before, "the buffer, though its name is encoded");
    write(folder.path(), "classes/glaze.png", "white");
    assert_ne!(digest(&[&folder]), after, "the image");
    write(folder.path(), "classes/parts/the vase.bin", "bytes");
    write(folder.path(), "classes/glaze.png", "green");
    assert_eq!(digest(&[&folder]), before);
}

#[test]
fn the_digest_changes_with_names_and_order_but_not_with_unread_files() {
    let (first, second) = (folder(&[("classes/a.yaml", "version: 1\nclasses: {}\n")]), vase());
    assert_ne!(digest(&[&first, &second]), digest(&[&second, &first]));
    let renamed = folder(&[("classes/b.yaml", "version: 1\nclasses: {}\n")]);
    assert_ne!(digest(&[&first]), digest(&[&renamed]));
    let before = digest(&[&first]);
    write(first.path(), "notes.txt", "not read");
    write(first.path(), "classes/notes.txt", "not read");
    assert_eq!(digest(&[&first]), before);
}

#[test]
fn the_digest_covers_files_that_two_models_share() {
    let folder = vase();
    write(folder.path(), "classes/a.yaml", &VASE.replace("vase", "a"));
    write(folder.path(), "classes/a.gltf", &MODEL.replace("vase.bin", "vase.gltf"));
    let before = digest(&[&folder]);
    write(folder.path(), "classes/vase.bin", "other bytes");
    assert_ne!(digest(&[&folder]), before);
}

#[test]
fn a_model_above_the_limit_is_refused_without_reading_it() {
    let folder = vase();
    let file = std::fs::File::create(folder.path().join("classes/vase.bin")).unwrap();
    // Sparse: to read it would take all memory.
    file.set_len(1 << 40).unwrap();
    let faults = load_above_base(&[folder.path().to_owned()]).unwrap_err();
    assert!(faults.to_string().contains("128 MB are the most"), "{faults}");
}
