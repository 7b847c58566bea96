//! Corners, faces and normals: placed, turned and fitted.

use std::f64::consts::FRAC_PI_2;

use glam::Vec3;
use serde_json::json;

use super::{Draft, bounds, read_bytes, size, volume};

#[test]
fn a_box_is_fitted_to_its_class() {
    let model = Draft::of_a_box().read().unwrap().fitted("chair", size(0.5, 2.0, 1.0)).unwrap();
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
    let (low, high) = bounds(&read.fitted("chair", size(0.55, 2.0, 1.0)).unwrap());
    assert!((high - low).distance(Vec3::new(0.55, 1.0, 2.0)) < 1e-6);
    let fault = read.fitted("chair", size(1.0, 2.0, 1.0)).unwrap_err().0.remove(0);
    assert!(fault.message.contains("1.000 × 4.000 × 2.000 m"), "{}", fault.message);
    assert!(fault.message.contains("by 100 %"), "{}", fault.message);
    assert_eq!(
        fault.hint.as_deref(),
        Some("give the class the size [0.63, 2.52, 1.26], or that of the model by `scale: 1` beside `file`")
    );
}

#[test]
fn a_turn_brings_the_front_to_positive_z() {
    let glb = Draft::of_a_box().glb();
    let straight =
        read_bytes(&glb, 0.0).unwrap().fitted("chair", size(4.0, 1.0, 2.0)).unwrap_err().0.remove(0);
    assert!(straight.hint.unwrap().contains("turn: 90"));
    let turned = read_bytes(&glb, FRAC_PI_2).unwrap();
    assert!(turned.fitted("chair", size(4.0, 1.0, 2.0)).is_ok());
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

#[test]
fn a_flat_model_cannot_be_scaled_to_a_box() {
    let mut draft = Draft::of_a_box();
    draft.document["nodes"] = json!([{"mesh": 0, "scale": [1.0, 1.0, 0.0]}]);
    let fault = draft.read().unwrap().fitted("chair", size(1.0, 1.0, 1.0)).unwrap_err().0.remove(0);
    assert!(fault.message.contains("is flat"), "{fault}");
}
