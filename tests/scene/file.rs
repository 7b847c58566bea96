//! Files, read back with another library.

use std::collections::BTreeMap;
use std::sync::Arc;

use gltf::mesh::Semantic;
use roomwright::internals::catalog::{Material, Size};
use roomwright::internals::gltf::{
    GltfError, Painting, SharedLibrary, SharedModel, WriteOptions, write_glb, write_glb_with, write_gltf,
    write_gltf_with,
};
use roomwright::internals::model::{
    Image, Model, ModelMaterial, OwnMaterial, Primitive, Texture, TextureSampler, TextureUse, Transparency,
};
use roomwright::internals::plan::SitePlacement;
use roomwright::internals::recipes::Slot;
use roomwright::internals::scene::{
    Lights, ModelKey, Node, Parts, Scene, SceneInput, SceneMaterial, SceneOptions, build_scene,
};

use crate::fixture::*;

fn furnished_scene() -> Scene {
    scene(&two_rooms(), &two_furnished(&catalog()))
}

fn read(bytes: &[u8]) -> gltf::Gltf {
    gltf::Gltf::from_slice(bytes).unwrap()
}

fn node_count(node: &Node) -> usize {
    1 + node.children.iter().map(node_count).sum::<usize>()
}

/// Same names, places, meshes and extras below both nodes.
fn assert_same(node: &Node, found: &gltf::Node<'_>) {
    assert_eq!(found.name(), Some(node.name.as_str()));
    let (translation, rotation, scale) = found.transform().decomposed();
    assert_eq!(translation, node.translation.to_array());
    assert_eq!(rotation, node.rotation.to_array());
    assert_eq!(scale, [1.0; 3]);
    assert_eq!(found.mesh().map(|mesh| mesh.index()), node.mesh);
    let extras = found.extras().as_ref().map(|raw| raw.get().to_owned());
    assert_eq!(extras, node.extras.as_ref().map(|extras| serde_json::to_string(extras).unwrap()));
    let children: Vec<gltf::Node<'_>> = found.children().collect();
    assert_eq!(children.len(), node.children.len(), "{}", node.name);
    for (child, found) in node.children.iter().zip(&children) {
        assert_same(child, found);
    }
}

#[test]
fn the_tree_comes_back_as_it_was() {
    let scene = furnished_scene();
    let file = read(&write_glb(&scene).unwrap());
    assert_eq!(file.nodes().len(), node_count(&scene.root));
    let roots: Vec<gltf::Node<'_>> = file.default_scene().unwrap().nodes().collect();
    assert_eq!(roots.len(), 1);
    assert_same(&scene.root, &roots[0]);
}

/// Corners, normals and indices of a primitive.
type Triangles = (Vec<[f32; 3]>, Vec<[f32; 3]>, Vec<u32>);

/// The primitives of a file.
fn geometry(file: &gltf::Gltf, buffers: &[&[u8]]) -> Vec<Triangles> {
    let primitives = file.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>());
    let read = primitives.map(|primitive| {
        let reader = primitive.reader(|buffer| Some(buffers[buffer.index()]));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let bounds = primitive.bounding_box();
        for axis in 0..3 {
            let values = || positions.iter().map(|position| position[axis]);
            assert_eq!(bounds.min[axis], values().fold(f32::INFINITY, f32::min));
            assert_eq!(bounds.max[axis], values().fold(f32::NEG_INFINITY, f32::max));
        }
        let normals = reader.read_normals().unwrap().collect();
        (positions, normals, reader.read_indices().unwrap().into_u32().collect())
    });
    read.collect()
}

fn assert_geometry(scene: &Scene, found: &[Triangles]) {
    let primitives: Vec<&Primitive> = scene.meshes.iter().flat_map(|mesh| &mesh.model.primitives).collect();
    assert_eq!(primitives.len(), found.len());
    for (primitive, (positions, normals, indices)) in primitives.iter().zip(found) {
        assert_eq!(&primitive.positions, positions);
        assert_eq!(&primitive.normals, normals);
        assert_eq!(&primitive.indices, indices);
    }
}

#[test]
fn triangles_come_back_as_they_were() {
    let scene = furnished_scene();
    let file = read(&write_glb(&scene).unwrap());
    assert_geometry(&scene, &geometry(&file, &[file.blob.as_ref().unwrap()]));
    let (json, bin) = write_gltf(&scene, "floor 1.bin");
    let file = read(&json);
    let buffer = file.buffers().next().unwrap();
    assert_eq!(buffer.length(), bin.len());
    assert!(matches!(buffer.source(), gltf::buffer::Source::Uri("floor%201.bin")));
    assert_geometry(&scene, &geometry(&file, &[&bin]));
}

#[test]
fn materials_are_those_of_the_palette() {
    let scene = furnished_scene();
    let file = read(&write_glb(&scene).unwrap());
    assert_eq!(file.materials().len(), scene.materials.len());
    for (source, found) in scene.materials.iter().zip(file.materials()) {
        let SceneMaterial::Slot { name, material, .. } = source else {
            panic!("the fixture has no own materials")
        };
        assert_eq!(found.name(), Some(name.as_str()));
        let factors = found.pbr_metallic_roughness();
        assert_eq!(factors.base_color_factor(), material.base_color);
        assert_eq!(factors.roughness_factor(), material.roughness);
        assert_eq!(factors.metallic_factor(), material.metallic);
        let glass = found.transmission().map(|glass| glass.transmission_factor());
        assert_eq!(glass, (material.transmission > 0.0).then_some(material.transmission));
        assert!(name.starts_with("modern."), "{name}");
    }
    assert_eq!(file.extensions_used().collect::<Vec<_>>(), ["KHR_materials_transmission"]);
}

#[test]
fn meshes_that_differ_in_material_only_share_accessors() {
    let catalog = catalog();
    let mut rooms = two_furnished(&catalog);
    rooms[1].style = catalog.styles.find("warm").unwrap();
    let scene = scene(&two_rooms(), &rooms);
    let chairs: Vec<&str> =
        scene.meshes.iter().filter(|mesh| mesh.is_shared()).map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(
        chairs,
        ["desk.0@plain/modern", "lamp.0@plain/modern", "chair.0@plain/modern", "chair.0@plain/warm"]
    );
    let file = read(&write_glb(&scene).unwrap());
    let positions = |name: &str| {
        let mesh = file.meshes().find(|mesh| mesh.name() == Some(name)).unwrap();
        let primitive = mesh.primitives().next().unwrap();
        (primitive.get(&Semantic::Positions).unwrap().index(), primitive.material().index())
    };
    let (modern, warm) = (positions("chair.0@plain/modern"), positions("chair.0@plain/warm"));
    assert_eq!(modern.0, warm.0);
    assert_ne!(modern.1, warm.1);
}

/// A library of all models of a scene, and the bytes of each file by its path.
fn library_of(scene: &Scene) -> (SharedLibrary, BTreeMap<String, Vec<u8>>) {
    let keyed = scene.meshes.iter().filter_map(|mesh| Some((mesh.key.clone()?, mesh.model.as_ref())));
    let made = |(key, model): (ModelKey, &Model)| {
        let path = format!("shared/{}.{}.bin", key.variant, key.geometry);
        (key, Arc::new(SharedModel::new(model, |_| Painting::default(), |_| path)))
    };
    let library: SharedLibrary = keyed.map(made).collect();
    let files = library.values().map(|model| (model.path().to_owned(), model.bytes())).collect();
    (library, files)
}

/// The bytes of the buffers of a file, its own first.
fn buffers<'b>(file: &gltf::Gltf, own: &'b [u8], files: &'b BTreeMap<String, Vec<u8>>) -> Vec<&'b [u8]> {
    let bytes = |buffer: gltf::Buffer<'_>| match buffer.source() {
        gltf::buffer::Source::Uri(uri) if files.contains_key(uri) => files[uri].as_slice(),
        _ => own,
    };
    file.buffers().map(bytes).collect()
}

#[test]
fn shared_files_hold_the_models_that_are_in_use_and_the_level_the_shell() {
    let scene = furnished_scene();
    let (library, files) = library_of(&scene);
    let options = WriteOptions { library: Some(&library), ..WriteOptions::default() };

    let glb = write_glb_with(&scene, options).unwrap();
    let file = read(&glb);
    let alone = read(&write_glb(&scene).unwrap());
    assert!(file.blob.as_ref().unwrap().len() < alone.blob.as_ref().unwrap().len());
    let named: Vec<usize> = file.buffers().skip(1).map(|buffer| buffer.length()).collect();
    assert_eq!(named.len(), library.len(), "one file a model");
    assert_eq!(named.iter().sum::<usize>(), files.values().map(Vec::len).sum::<usize>());
    assert_geometry(&scene, &geometry(&file, &buffers(&file, file.blob.as_ref().unwrap(), &files)));

    let (json, bin) = write_gltf_with(&scene, "1.bin", options);
    let file = read(&json);
    assert_geometry(&scene, &geometry(&file, &buffers(&file, &bin, &files)));
}

#[test]
fn a_library_that_lacks_a_model_leaves_it_in_the_level() {
    let scene = furnished_scene();
    let empty = SharedLibrary::new();
    let options = WriteOptions { library: Some(&empty), ..WriteOptions::default() };
    assert_eq!(write_glb_with(&scene, options).unwrap(), write_glb(&scene).unwrap());
}

/// A PNG of one white dot.
const DOT: [u8; 67] = [
    137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0, 58,
    126, 155, 85, 0, 0, 0, 10, 73, 68, 65, 84, 120, 156, 99, 248, 15, 0, 1, 1, 1, 0, 177, 56, 246, 20, 0, 0,
    0, 0, 73, 69, 78, 68, 174, 66, 96, 130,
];

/// A box with texture coordinates and a material of its own.
fn textured_model() -> Model {
    let image =
        Arc::new(Image { name: None, mime_type: "image/png".to_owned(), bytes: DOT.to_vec(), uri: None });
    let texture = Texture::plain(image, TextureSampler::default());
    let own = OwnMaterial {
        name: "leather".to_owned(),
        material: Material {
            base_color: [1.0; 4],
            metallic: 0.0,
            roughness: 0.5,
            emissive: [0.0; 3],
            emissive_strength: 1.0,
            transmission: 0.0,
            texture: None,
            tints: Vec::new(),
        },
        is_double_sided: true,
        transparency: Transparency::CutOut(0.4),
        textures: vec![(TextureUse::BaseColor, texture.clone()), (TextureUse::Occlusion, texture)],
    };
    let mut model = box_model(Size { width: 0.5, depth: 0.5, height: 1.0 }, Slot::Wood);
    let primitive = &mut model.primitives[0];
    primitive.texture_coordinates = vec![[0.25, 0.75]; primitive.positions.len()];
    primitive.material = ModelMaterial::Own(Arc::new(own));
    model
}

fn textured_scene() -> Scene {
    let catalog = catalog();
    let model = Arc::new(textured_model());
    let (level, furnished) = (two_rooms(), two_furnished(&catalog));
    let site = SitePlacement { position: point(10.0, -5.0), turn: 0.5 };
    let models = |_, _| Arc::clone(&model);
    build_scene(&SceneInput { site, ..input(&level, &furnished, &catalog, &models) })
}

#[test]
fn lamps_that_are_lit_are_brighter_than_their_colour() {
    let (catalog, level) = (catalog(), two_rooms());
    let furnished = two_furnished(&catalog);
    let model = Arc::new(box_model(Size { width: 0.2, depth: 0.2, height: 0.4 }, Slot::Lamp));
    let models = |_, _| Arc::clone(&model);
    let written = |lights: Lights| {
        let options = SceneOptions { lights, ..SceneOptions::default() };
        let scene = build_scene(&SceneInput { options, ..input(&level, &furnished, &catalog, &models) });
        let file = read(&write_glb(&scene).unwrap());
        let lamps = file.materials().filter(|one| one.emissive_factor() == [1.0; 3]);
        let strengths: Vec<Option<f32>> = lamps.map(|lamp| lamp.emissive_strength()).collect();
        (strengths, file.extensions_used().any(|name| name == "KHR_materials_emissive_strength"))
    };
    assert_eq!(written(Lights::Physical), (vec![Some(4.0)], true));
    assert_eq!(written(Lights::Off), (vec![None], false));
    // Where nothing else lights the room, shades have to.
    let (strengths, is_said) = written(Lights::Shining);
    assert!(is_said && strengths[0] > Some(4.0), "{strengths:?}");
}

#[test]
fn own_materials_bring_their_textures_once() {
    let file = read(&write_glb(&textured_scene()).unwrap());
    let own: Vec<gltf::Material<'_>> =
        file.materials().filter(|material| material.name() == Some("leather")).collect();
    assert_eq!(own.len(), 1);
    assert!(own[0].double_sided());
    assert_eq!((own[0].alpha_mode(), own[0].alpha_cutoff()), (gltf::material::AlphaMode::Mask, Some(0.4)));
    assert_eq!(file.images().len(), 1);
    let image = file.images().next().unwrap();
    let gltf::image::Source::View { view, mime_type } = image.source() else {
        panic!("the image is embedded")
    };
    assert_eq!(mime_type, "image/png");
    assert_eq!(view.offset() % 4, 0);
    assert_eq!(&file.blob.as_ref().unwrap()[view.offset()..view.offset() + view.length()], &DOT);
    let color = own[0].pbr_metallic_roughness().base_color_texture().unwrap();
    assert_eq!(color.texture().source().index(), 0);
    let chair = file.meshes().find(|mesh| mesh.name().unwrap().starts_with("chair")).unwrap();
    assert!(chair.primitives().next().unwrap().get(&Semantic::TexCoords(0)).is_some());
}

#[test]
fn the_site_is_recorded_and_moves_nothing() {
    let scene = textured_scene();
    let extras = serde_json::to_value(scene.root.extras.as_ref().unwrap()).unwrap();
    assert_eq!(extras["site"], serde_json::json!({"position": [10.0, -5.0], "turn": 0.5}));
    assert_eq!(scene.root.translation, glam::Vec3::ZERO);
}

#[test]
fn accessors_are_aligned_and_indices_as_long_as_a_mesh_needs() {
    // The highest number of a kind names no corner, so that a byte is enough for 254 corners and not for 255.
    let strip = |count: u32| Primitive {
        positions: (0..count).map(|i| [i as f32 * 0.001, (i % 2) as f32, 0.0]).collect(),
        normals: vec![[0.0, 0.0, 1.0]; count as usize],
        indices: (0..count).collect(),
        ..Primitive::default()
    };
    let primitives = vec![strip(252), strip(255), strip(u32::from(u16::MAX) + 3)];
    let catalog = catalog();
    let model = Arc::new(Model { primitives });
    let (level, furnished) = (two_rooms(), two_furnished(&catalog));
    let models = |_, _| Arc::clone(&model);
    let options = SceneOptions { parts: Parts::Separate, ..SceneOptions::default() };
    let scene = build_scene(&SceneInput { options, ..input(&level, &furnished, &catalog, &models) });
    let file = read(&write_glb(&scene).unwrap());
    assert_geometry(&scene, &geometry(&file, &[file.blob.as_ref().unwrap()]));
    for accessor in file.accessors() {
        let start = accessor.offset() + accessor.view().unwrap().offset();
        assert_eq!(start % accessor.data_type().size(), 0);
    }
    let mesh = file.meshes().find(|mesh| mesh.primitives().len() == 3).unwrap();
    let kinds: Vec<_> = mesh.primitives().map(|part| part.indices().unwrap().data_type()).collect();
    use gltf::accessor::DataType;
    assert_eq!(kinds, [DataType::U8, DataType::U16, DataType::U32]);
}

#[test]
fn a_level_without_rooms_is_a_file_without_data() {
    let file = read(&write_glb(&bare_scene(&level(Vec::new()))).unwrap());
    assert_eq!((file.nodes().len(), file.buffers().len(), file.blob.is_none()), (1, 0, true));
    let (_, bin) = write_gltf(&bare_scene(&level(Vec::new())), "1.bin");
    assert!(bin.is_empty());
}

#[test]
fn the_same_level_gives_the_same_bytes() {
    let first = write_glb(&furnished_scene()).unwrap();
    for _ in 0..3 {
        assert_eq!(write_glb(&furnished_scene()).unwrap(), first);
    }
    let threads: Vec<Vec<u8>> = std::thread::scope(|scope| {
        let spawned: Vec<_> =
            (0..4).map(|_| scope.spawn(|| write_glb(&furnished_scene()).unwrap())).collect();
        spawned.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(threads.iter().all(|bytes| *bytes == first));
}

#[test]
fn a_change_in_one_room_changes_that_rooms_nodes_only() {
    let catalog = catalog();
    let mut rooms = two_furnished(&catalog);
    let before = scene(&two_rooms(), &rooms);
    rooms[1].placements[0].position.x += 0.25;
    let after = scene(&two_rooms(), &rooms);
    let text = |node: &Node| format!("{node:?}");
    let changed: Vec<&str> = before
        .root
        .children
        .iter()
        .zip(&after.root.children)
        .filter(|(old, new)| text(old) != text(new))
        .map(|(old, _)| old.name.as_str())
        .collect();
    assert_eq!(changed, ["room:102"]);
}

#[test]
fn the_size_limit_is_reported_with_advice() {
    let message = GltfError::TooLarge(5_000_000_000).to_string();
    assert!(message.contains("5000000000") && message.contains(".gltf"), "{message}");
}
