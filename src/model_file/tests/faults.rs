//! Files that are rejected, and bytes that make no sense.

use std::path::PathBuf;

use proptest::prelude::*;
use serde_json::{Value, json};

use super::{Draft, read_bytes, size, textured};
use crate::model_file::UserModel;

#[test]
fn what_is_not_read_is_named_with_its_remedy() {
    for (extension, remedy) in [
        ("KHR_draco_mesh_compression", "gltf-transform copy"),
        ("EXT_meshopt_compression", "gltf-transform copy"),
        ("KHR_texture_basisu", "gltf-transform ktxdecompress"),
        ("VENDOR_wonder", "without the extension"),
    ] {
        let mut draft = Draft::of_a_box();
        draft.document["extensionsUsed"] = json!([extension]);
        draft.document["extensionsRequired"] = json!([extension]);
        let (message, hint) = draft.fault();
        assert!(message.contains(extension) && hint.contains(remedy), "{message} / {hint}");
    }
    let mut draft = Draft::of_a_box();
    draft.document["extensionsUsed"] = json!(["EXT_texture_webp", "KHR_materials_sheen", "VENDOR_wonder"]);
    assert!(draft.read().is_ok(), "what is optional has something plain beside it");
}

#[test]
fn motion_is_refused() {
    let cases =
        [("skins", json!([{"joints": [0]}])), ("animations", json!([{"channels": [], "samplers": []}]))];
    for (key, value) in cases {
        let mut draft = Draft::of_a_box();
        draft.document[key] = value;
        let (message, hint) = draft.fault();
        assert!(message.contains(key) && hint.contains("pose"), "{message}");
    }
}

/// A change to a good file, and a word of the message it should give.
type Spoiling = (fn(&mut Draft), &'static str);

#[test]
fn bad_files_are_faults_not_panics() {
    let cases: [Spoiling; 12] = [
        (|draft| draft.document["accessors"][0]["count"] = json!(9), "end of its buffer"),
        (|draft| draft.document["accessors"][0]["byteOffset"] = json!(u64::MAX), "end of its buffer"),
        (|draft| draft.document["bufferViews"][0]["byteOffset"] = json!(u64::MAX), "end of its buffer"),
        (|draft| draft.document["accessors"][0]["type"] = json!("VEC2"), "2 components"),
        (|draft| draft.document["accessors"][0]["count"] = json!(1_u64 << 40), "elements"),
        (|draft| draft.document["buffers"][0]["byteLength"] = json!(999), "999 are announced"),
        (|draft| draft.document["nodes"] = json!([{"mesh": 0, "children": [0]}]), "reached twice"),
        (|draft| draft.document["nodes"] = json!([{"mesh": 7}]), "not valid"),
        (|draft| draft.bytes[96] = 200, "names corner 200 of 8"),
        (|draft| draft.bytes[0..4].copy_from_slice(&f32::NAN.to_le_bytes()), "not finite"),
        (|draft| draft.document["scenes"] = json!([{"nodes": []}]), "no triangles"),
        (
            |draft| draft.document["nodes"] = json!([{"mesh": 0, "scale": [3e38, 1e38, 1e38]}]),
            "out of all bounds",
        ),
    ];
    for (spoil, expected) in cases {
        let mut draft = Draft::of_a_box();
        spoil(&mut draft);
        let (message, _) = draft.fault();
        assert!(message.contains(expected), "wanted {expected:?}: {message}");
    }
}

#[test]
fn a_missing_file_and_a_wrong_image_are_faults() {
    let fault = UserModel::read(&PathBuf::from("no/such/model.glb"), 0.0).unwrap_err().0.remove(0);
    assert!(fault.message.contains("cannot be read"), "{fault}");
    let mut draft = textured();
    draft.document["images"] = json!([{"uri": "data:image/gif;base64,R0lGODlh"}]);
    assert!(draft.fault().0.contains("neither PNG nor JPEG"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// Whatever becomes of the bytes, there is a model or a fault.
    #[test]
    fn broken_bytes_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        length in any::<prop::sample::Index>(),
        is_cut in any::<bool>(),
    ) {
        let mut bytes = textured().glb();
        for (place, value) in changes {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        if is_cut {
            bytes.truncate(length.index(bytes.len()));
        }
        if let Ok(read) = read_bytes(&bytes, 0.3) {
            let _ = read.fitted("chair", size(1.0, 4.0, 2.0));
        }
    }

    /// The same for the document alone: numbers anywhere in it may be anything.
    #[test]
    fn broken_documents_never_panic(place in any::<prop::sample::Index>(), value in any::<i64>(), is_float in any::<bool>()) {
        let mut draft = textured();
        let mut numbers = Vec::new();
        collect_numbers(&mut draft.document, &mut numbers);
        let index = place.index(numbers.len());
        *numbers[index] = if is_float { json!(value as f64 * 1e20) } else { json!(value) };
        if let Ok(read) = draft.read() {
            let _ = read.fitted("chair", size(1.0, 4.0, 2.0));
        }
    }
}

fn collect_numbers<'a>(value: &'a mut Value, numbers: &mut Vec<&'a mut Value>) {
    match value {
        Value::Number(_) => numbers.push(value),
        Value::Array(items) => items.iter_mut().for_each(|item| collect_numbers(item, numbers)),
        Value::Object(entries) => entries.values_mut().for_each(|entry| collect_numbers(entry, numbers)),
        _ => {}
    }
}
