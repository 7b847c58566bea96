//! Materials and images, inside the file and beside it.

use gltf::json::texture::{MinFilter, WrappingMode};
use serde_json::json;

use super::{Draft, PNG, own_material, textured};
use crate::mesh::{TextureSampler, TextureUse, Transparency};
use crate::model_file::UserModel;

#[test]
fn materials_come_along_with_their_images() {
    let model = textured().read().unwrap().model;
    let own = own_material(&model);
    assert_eq!(
        (own.name.as_str(), own.is_double_sided, own.transparency),
        ("oak", true, Transparency::CutOut(0.25))
    );
    assert_eq!(own.material.base_color, [0.5, 0.25, 0.125, 0.75]);
    assert_eq!(
        (own.material.metallic, own.material.roughness, own.material.emissive),
        (0.0, 0.5, [0.0, 0.5, 0.0])
    );
    let uses: Vec<TextureUse> = own.textures.iter().map(|(usage, _)| *usage).collect();
    assert_eq!(uses, [TextureUse::BaseColor, TextureUse::Normal]);
    assert_eq!(own.textures[0].1.image.bytes, PNG);
    let part = &model.primitives[0];
    assert_eq!(part.texture_coordinates.len(), part.positions.len());
    assert_eq!(part.texture_coordinates[0], [0.0, 17.0 / 255.0]);
}

/// Upholstery as the samples of the Khronos group have it: cloth that repeats, finer folds, and shadows that are unwrapped
/// apart from both.
#[test]
fn images_may_be_laid_on_in_different_ways() {
    let mut draft = textured();
    let places: Vec<u8> = (0..16).map(|value| value * 10).collect();
    let second = draft
        .accessor(&places, json!({"componentType": 5121, "type": "VEC2", "count": 8, "normalized": true}));
    draft.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = json!(second);
    let laid = |transform| json!({"index": 0, "extensions": {"KHR_texture_transform": transform}});
    let material = &mut draft.document["materials"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"] = laid(json!({"scale": [2, 3], "offset": [0.5, 0]}));
    material["normalTexture"] = laid(json!({"scale": [8, 8]}));
    material["normalTexture"]["scale"] = json!(0.6);
    material["emissiveTexture"] = laid(json!({"scale": [8, 8]}));
    material["occlusionTexture"] = json!({"index": 0, "texCoord": 1, "strength": 0.25});
    for key in ["extensionsUsed", "extensionsRequired"] {
        draft.document[key] = json!(["KHR_texture_transform"]);
    }
    let model = draft.read().unwrap().model;
    let textures = &own_material(&model).textures;
    let found: Vec<_> =
        textures.iter().map(|(_, texture)| (texture.coordinate_set, texture.strength)).collect();
    assert_eq!(found, [(0, 1.0), (1, 0.6), (2, 0.25), (1, 1.0)]);
    let sets: Vec<&[[f32; 2]]> = model.primitives[0].coordinate_sets().collect();
    assert!(sets.len() == 3 && sets.iter().all(|set| set.len() == model.primitives[0].positions.len()));
    // Every corner by all three: the first set runs in steps of 17 of 255, the second of 10.
    for (corner, finer) in sets[1].iter().enumerate() {
        let plain = finer.map(|number| number / 8.0);
        let shadow = plain.map(|number| number * 10.0 / 17.0);
        for (set, wanted) in [(0, [plain[0] * 2.0 + 0.5, plain[1] * 3.0]), (2, shadow)] {
            assert!(
                (0..2).all(|axis| (sets[set][corner][axis] - wanted[axis]).abs() < 1e-5),
                "{set} {corner}"
            );
        }
    }
    draft.document["materials"][0]["normalTexture"] = laid(json!({"scale": [1e9, 8]}));
    assert!(draft.fault().0.contains("out of all bounds"));
    draft.document["materials"][0]["occlusionTexture"]["strength"] = json!(2);
    assert!(draft.fault().0.contains("strength 2"));
}

#[test]
fn opacity_means_what_the_file_says() {
    let mut draft = textured();
    let mut mode = |word: &str| {
        draft.document["materials"][0]["alphaMode"] = json!(word);
        let model = draft.read().unwrap().model;
        (own_material(&model).transparency, own_material(&model).material.base_color[3])
    };
    assert_eq!(mode("BLEND"), (Transparency::Blended, 0.75), "no cut-out, whatever the texture");
    assert_eq!(mode("MASK"), (Transparency::CutOut(0.25), 0.75));
    assert_eq!(mode("OPAQUE"), (Transparency::Opaque, 1.0));
}

#[test]
fn textures_keep_their_samplers() {
    let mut draft = textured();
    draft.document["samplers"] = json!([{"wrapT": 33071, "minFilter": 9728}]);
    draft.document["textures"] = json!([{"source": 0, "sampler": 0}, {"source": 0}]);
    draft.document["materials"][0]["normalTexture"]["index"] = json!(1);
    let model = draft.read().unwrap().model;
    let clamped = TextureSampler {
        wrapping: [WrappingMode::Repeat, WrappingMode::ClampToEdge],
        magnification: None,
        minification: Some(MinFilter::Nearest),
    };
    let samplers: Vec<TextureSampler> =
        own_material(&model).textures.iter().map(|(_, texture)| texture.sampler).collect();
    assert_eq!(samplers, [clamped, TextureSampler::default()]);
}

#[test]
fn colours_of_corners_come_along_and_parts_without_are_white() {
    let mut draft = Draft::of_a_box();
    let shares: Vec<u8> = (0..8).flat_map(|corner| [corner * 32, 0, 255, 128]).collect();
    let colors = draft
        .accessor(&shares, json!({"componentType": 5121, "type": "VEC4", "count": 8, "normalized": true}));
    let colored = json!({"attributes": {"POSITION": 0, "COLOR_0": colors}, "indices": 1});
    let plain = json!({"attributes": {"POSITION": 0}, "indices": 1});
    for primitives in [json!([colored, plain]), json!([plain, colored])] {
        let is_first = primitives[0] == colored;
        draft.document["meshes"][0]["primitives"] = primitives;
        let model = draft.read().unwrap().model;
        let found = &model.primitives[0].colors;
        assert_eq!(found.len(), model.primitives[0].positions.len());
        let white = found.iter().filter(|color| **color == [1.0; 4]).count();
        assert_eq!(white, found.len() / 2);
        let first = if is_first { found[0] } else { found[found.len() / 2] };
        assert_eq!(first, [0.0, 0.0, 1.0, 128.0 / 255.0]);
    }
    draft.document["meshes"][0]["primitives"] = json!([plain]);
    assert!(draft.read().unwrap().model.primitives[0].colors.is_empty());
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
    assert_eq!(own_material(&read.model).textures[0].1.image.mime_type, "image/png");
    std::fs::remove_file(folder.path().join("grain.png")).unwrap();
    let fault = UserModel::read(&path, 0.0).unwrap_err().0.remove(0);
    assert!(fault.message.contains("grain.png") && fault.file == path, "{fault}");
}
