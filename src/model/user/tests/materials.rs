//! Materials and images, inside the file and beside it.

use serde_json::json;

use super::{Draft, PNG, own_material, textured};
use crate::model::TextureUse;
use crate::model::user::UserModel;

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
