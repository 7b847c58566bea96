//! Reading users' models from files made here.

use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

use glam::Vec3;
use proptest::prelude::*;
use serde_json::{Value, json};

use super::*;
use crate::model::{ModelMaterial, OwnMaterial, TextureUse};

/// The smallest PNG there is: its signature and nothing after it, for nothing here decodes it.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// A file under construction: a box 1 wide, 2 high, 4 deep with its front at +z, standing on the origin's plane.
struct Draft {
    document: Value,
    bytes: Vec<u8>,
}

impl Draft {
    fn of_a_box() -> Self {
        let mut bytes = Vec::new();
        let positions: Vec<[f32; 3]> = (0..8)
            .map(|corner| [0, 1, 2].map(|axis| (corner >> axis & 1) as f32))
            .map(|[x, y, z]| [x - 0.5, y * 2.0, z * 4.0 - 2.0])
            .collect();
        bytes.extend(positions.iter().flatten().flat_map(|value| value.to_le_bytes()));
        let quads: [[u16; 4]; 6] =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let indices = quads.iter().flat_map(|&[a, b, c, d]| [a, b, c, a, c, d]);
        bytes.extend(indices.flat_map(u16::to_le_bytes));
        let document = json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8, "min": [-0.5, 0.0, -2.0], "max": [0.5, 2.0, 2.0]},
                {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 36},
            ],
            "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
            "buffers": [{"byteLength": 168}],
        });
        Self { document, bytes }
    }

    /// Adds a view of bytes and an accessor on it; gives the accessor's number.
    fn accessor(&mut self, bytes: &[u8], accessor: Value) -> usize {
        let view = self.view(bytes);
        let mut accessor = accessor;
        accessor["bufferView"] = json!(view);
        let accessors = self.document["accessors"].as_array_mut().unwrap();
        accessors.push(accessor);
        accessors.len() - 1
    }

    fn view(&mut self, bytes: &[u8]) -> usize {
        let views = self.document["bufferViews"].as_array_mut().unwrap();
        views.push(json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()}));
        self.bytes.extend_from_slice(bytes);
        self.document["buffers"][0]["byteLength"] = json!(self.bytes.len());
        self.document["bufferViews"].as_array().unwrap().len() - 1
    }

    fn glb(&self) -> Vec<u8> {
        let json = serde_json::to_vec(&self.document).unwrap();
        let glb = gltf::Glb {
            header: gltf::binary::Header { magic: *b"glTF", version: 2, length: 0 },
            json: json.into(),
            bin: Some(self.bytes.clone().into()),
        };
        glb.to_vec().unwrap()
    }

    fn read(&self) -> Result<UserModel, Faults> {
        read_bytes(&self.glb(), 0.0)
    }

    fn fault(&self) -> (String, String) {
        let fault = self.read().unwrap_err().0.remove(0);
        (fault.message, fault.hint.unwrap_or_default())
    }
}

fn read_bytes(bytes: &[u8], turn: f64) -> Result<UserModel, Faults> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("thing.glb");
    std::fs::write(&path, bytes).unwrap();
    UserModel::read(&path, turn)
}

fn size(width: f64, depth: f64, height: f64) -> Size {
    Size { width, depth, height }
}

fn bounds(model: &Model) -> (Vec3, Vec3) {
    let positions =
        model.primitives.iter().flat_map(|part| &part.positions).map(|&position| Vec3::from(position));
    positions.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
}

fn volume(model: &Model) -> f32 {
    let part = &model.primitives[0];
    let corner = |index: &u32| Vec3::from(part.positions[*index as usize]);
    part.indices.chunks_exact(3).map(|t| corner(&t[0]).dot(corner(&t[1]).cross(corner(&t[2]))) / 6.0).sum()
}

fn own_material(model: &Model) -> &OwnMaterial {
    match &model.primitives[0].material {
        ModelMaterial::Own(own) => own,
        ModelMaterial::Slot(slot) => panic!("a user's model has its own materials, not {slot}"),
    }
}

#[test]
fn a_box_is_fitted_to_its_class() {
    let model = Draft::of_a_box().read().unwrap().fitted(size(0.5, 2.0, 1.0)).unwrap();
    let (low, high) = bounds(&model);
    assert!(
        low.distance(Vec3::new(-0.25, 0.0, -1.0)) < 1e-6 && high.distance(Vec3::new(0.25, 1.0, 1.0)) < 1e-6
    );
    assert!((volume(&model) - 1.0).abs() < 1e-5);
}

#[test]
fn a_box_without_normals_gets_flat_ones() {
    let model = Draft::of_a_box().read().unwrap().model;
    let part = &model.primitives[0];
    assert_eq!((part.positions.len(), part.normals.len(), part.indices.len()), (36, 36, 36));
    assert!(part.normals.iter().all(|normal| Vec3::from(*normal).abs().max_element() > 0.999));
}

#[test]
fn slightly_different_proportions_are_evened_out_and_larger_ones_are_faults() {
    let read = Draft::of_a_box().read().unwrap();
    let (low, high) = bounds(&read.fitted(size(0.55, 2.0, 1.0)).unwrap());
    assert!((high - low).distance(Vec3::new(0.55, 1.0, 2.0)) < 1e-6);
    let fault = read.fitted(size(1.0, 2.0, 1.0)).unwrap_err().0.remove(0);
    assert!(fault.message.contains("1.000 × 4.000 × 2.000 m"), "{}", fault.message);
    assert!(fault.message.contains("by 100 %"), "{}", fault.message);
    assert_eq!(fault.hint.as_deref(), Some("give the class the size [0.63, 2.52, 1.26]"));
}

#[test]
fn a_turn_brings_the_front_to_positive_z() {
    let glb = Draft::of_a_box().glb();
    let straight = read_bytes(&glb, 0.0).unwrap().fitted(size(4.0, 1.0, 2.0)).unwrap_err().0.remove(0);
    assert!(straight.hint.unwrap().contains("turn: 90"));
    let turned = read_bytes(&glb, FRAC_PI_2).unwrap();
    assert!(turned.fitted(size(4.0, 1.0, 2.0)).is_ok());
    // Counter-clockwise seen from above, with x to the right and z towards the reader: +z goes to +x.
    let mut marked = Draft::of_a_box();
    marked.document["nodes"] = json!([{"mesh": 0, "translation": [0.0, 0.0, 10.0]}]);
    let (low, high) = bounds(&read_bytes(&marked.glb(), FRAC_PI_2).unwrap().model);
    assert!(((low + high) / 2.0).distance(Vec3::new(10.0, 1.0, 0.0)) < 1e-5);
}

#[test]
fn transforms_of_all_nodes_apply_and_mirrors_keep_faces_outwards() {
    let mut draft = Draft::of_a_box();
    draft.document["nodes"] = json!([
        {"children": [1], "translation": [5.0, 0.0, 0.0]},
        {"mesh": 0, "scale": [-2.0, 1.0, 1.0], "rotation": [0.0, 0.0, 0.0, 1.0]},
    ]);
    let model = draft.read().unwrap().model;
    let (low, high) = bounds(&model);
    assert!(low.distance(Vec3::new(4.0, 0.0, -2.0)) < 1e-6 && high.distance(Vec3::new(6.0, 2.0, 2.0)) < 1e-6);
    assert!(volume(&model) > 0.0);
    draft.document["nodes"] =
        json!([{"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1]}]);
    assert!((bounds(&draft.read().unwrap().model).1.x - 7.5).abs() < 1e-6);
}

#[test]
fn given_normals_are_kept_and_unused_corners_dropped() {
    let mut draft = Draft::of_a_box();
    let normals: Vec<u8> = (0..8).flat_map(|_| [0.0_f32, 2.0, 0.0]).flat_map(f32::to_le_bytes).collect();
    let accessor = draft.accessor(&normals, json!({"componentType": 5126, "type": "VEC3", "count": 8}));
    draft.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = json!(accessor);
    let part = &draft.read().unwrap().model.primitives[0];
    assert_eq!(part.positions.len(), 8);
    assert!(part.normals.iter().all(|normal| *normal == [0.0, 1.0, 0.0]));
    draft.document["accessors"][1]["count"] = json!(6);
    assert_eq!(draft.read().unwrap().model.primitives[0].positions.len(), 4);
}

#[test]
fn strips_and_fans_become_triangles() {
    let quad: Vec<u8> = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]
        .iter()
        .flatten()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    for (mode, count) in [(5, 6), (6, 6), (4, 3), (1, 0)] {
        let mut draft = Draft::of_a_box();
        let positions = json!({"componentType": 5126, "type": "VEC3", "count": 4, "min": [0.0, 0.0, 0.0], "max": [1.0, 1.0, 0.0]});
        let accessor = draft.accessor(&quad, positions);
        draft.document["meshes"][0]["primitives"] =
            json!([{"attributes": {"POSITION": accessor}, "mode": mode}]);
        let found = draft.read().map(|read| read.model.primitives[0].indices.len()).unwrap_or(0);
        assert_eq!(found, count, "mode {mode}");
    }
}

#[test]
fn quantized_and_sparse_numbers_are_read() {
    let mut draft = Draft::of_a_box();
    let shares: Vec<u8> = (0..8_u16)
        .flat_map(|corner| {
            [0, 1, 2]
                .map(|axis| if corner >> axis & 1 == 1 { i16::MAX } else { -i16::MAX })
                .into_iter()
                .chain([0])
        })
        .flat_map(i16::to_le_bytes)
        .collect();
    let accessor = draft.accessor(&shares, json!({"componentType": 5122, "type": "VEC3", "count": 8, "normalized": true, "min": [-32767, -32767, -32767], "max": [32767, 32767, 32767]}));
    let view = draft.document["accessors"][accessor]["bufferView"].as_u64().unwrap() as usize;
    draft.document["bufferViews"][view]["byteStride"] = json!(8);
    draft.document["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    draft.document["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
    draft.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(accessor);
    assert_eq!(bounds(&draft.read().unwrap().model), (Vec3::splat(-1.0), Vec3::splat(1.0)));

    let mut draft = Draft::of_a_box();
    let place = draft.view(&[7, 0]);
    let value = draft.view(&[9.0_f32, 2.0, 2.0].map(f32::to_le_bytes).concat());
    draft.document["accessors"][0]["sparse"] = json!({"count": 1, "indices": {"bufferView": place, "componentType": 5123}, "values": {"bufferView": value}});
    assert_eq!(bounds(&draft.read().unwrap().model).1, Vec3::new(9.0, 2.0, 2.0));
}

fn textured() -> Draft {
    let mut draft = Draft::of_a_box();
    let view = draft.view(PNG);
    draft.document["images"] = json!([{"bufferView": view, "mimeType": "image/png"}]);
    draft.document["textures"] = json!([{"source": 0}]);
    draft.document["materials"] = json!([{
        "name": "oak", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.25,
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 0.75], "metallicFactor": 0.0, "roughnessFactor": 0.5, "baseColorTexture": {"index": 0}},
        "normalTexture": {"index": 0}, "emissiveFactor": [0.0, 0.5, 0.0],
    }]);
    draft.document["meshes"][0]["primitives"][0]["material"] = json!(0);
    let shares: Vec<u8> = (0..16).map(|value| value * 17).collect();
    let accessor = draft
        .accessor(&shares, json!({"componentType": 5121, "type": "VEC2", "count": 8, "normalized": true}));
    draft.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(accessor);
    draft
}

#[test]
fn materials_come_along_with_their_images() {
    let model = textured().read().unwrap().model;
    let own = own_material(&model);
    assert_eq!((own.name.as_str(), own.is_double_sided, own.alpha_cutoff), ("oak", true, Some(0.25)));
    assert_eq!(own.material.base_color, [0.5, 0.25, 0.125, 0.75]);
    assert_eq!(
        (own.material.metallic, own.material.roughness, own.material.emissive),
        (0.0, 0.5, [0.0, 0.5, 0.0])
    );
    let uses: Vec<TextureUse> = own.textures.iter().map(|(usage, _)| *usage).collect();
    assert_eq!(uses, [TextureUse::BaseColor, TextureUse::Normal]);
    assert_eq!(own.textures[0].1.bytes, PNG);
    let part = &model.primitives[0];
    assert_eq!(part.texture_coordinates.len(), part.positions.len());
    assert_eq!(part.texture_coordinates[0], [0.0, 17.0 / 255.0]);
}

#[test]
fn a_part_without_material_is_named_after_the_file() {
    let model = Draft::of_a_box().read().unwrap().model;
    assert_eq!(own_material(&model).name, "thing");
    assert!(model.primitives[0].texture_coordinates.is_empty());
}

#[test]
fn files_beside_the_model_are_found_from_any_folder() {
    let mut draft = textured();
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("parts")).unwrap();
    std::fs::write(folder.path().join("parts/my data.bin"), &draft.bytes).unwrap();
    std::fs::write(folder.path().join("grain.png"), PNG).unwrap();
    draft.document["buffers"][0]["uri"] = json!("parts/my%20data.bin");
    draft.document["images"] = json!([{"uri": "grain.png"}]);
    let path = folder.path().join("chair.gltf");
    std::fs::write(&path, serde_json::to_vec(&draft.document).unwrap()).unwrap();
    let read = UserModel::read(&path, 0.0).unwrap();
    assert_eq!(own_material(&read.model).textures[0].1.mime_type, "image/png");
    std::fs::remove_file(folder.path().join("grain.png")).unwrap();
    let fault = UserModel::read(&path, 0.0).unwrap_err().0.remove(0);
    assert!(fault.message.contains("grain.png") && fault.file == path, "{fault}");
}

#[test]
fn what_is_not_read_is_named_with_its_remedy() {
    for (extension, remedy) in [
        ("KHR_draco_mesh_compression", "gltf-transform copy"),
        ("EXT_meshopt_compression", "gltf-transform copy"),
        ("KHR_texture_basisu", "gltf-transform ktxdecompress"),
        ("KHR_texture_transform", "texture coordinates"),
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

#[test]
fn a_flat_model_cannot_be_scaled_to_a_box() {
    let mut draft = Draft::of_a_box();
    draft.document["nodes"] = json!([{"mesh": 0, "scale": [1.0, 1.0, 0.0]}]);
    let fault = draft.read().unwrap().fitted(size(1.0, 1.0, 1.0)).unwrap_err().0.remove(0);
    assert!(fault.message.contains("is flat"), "{fault}");
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
            let _ = read.fitted(size(1.0, 4.0, 2.0));
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
            let _ = read.fitted(size(1.0, 4.0, 2.0));
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

#[test]
fn the_sample_in_assets_is_read_back_as_it_was_built() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/stool.glb");
    let size = size(0.36, 0.36, 0.65);
    let read = UserModel::read(&path, 0.0).unwrap().fitted(size).unwrap();
    let input = crate::model::RecipeInput { size, look: 0, geometry: crate::model::PLAIN, parameters: &[] };
    let built = crate::model::build_recipe("stool", &input).unwrap();
    let counts = |model: &Model| model.primitives.iter().map(|part| part.indices.len()).sum::<usize>();
    assert_eq!(counts(&read), counts(&built));
    assert!(bounds(&read).1.distance(bounds(&built).1) < 1e-5);
}
