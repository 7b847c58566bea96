//! A user's model from its file into the output.

use gltf::image::Source;
use gltf::material::AlphaMode;
use gltf::mesh::Semantic;
use gltf::texture::{MagFilter, MinFilter, WrappingMode};
use serde_json::json;

use super::world::World;

/// A PNG of one white dot.
const DOT: [u8; 67] = [
    137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0, 58,
    126, 155, 85, 0, 0, 0, 10, 73, 68, 65, 84, 120, 156, 99, 248, 15, 0, 1, 1, 1, 0, 177, 56, 246, 20, 0, 0,
    0, 0, 73, 69, 78, 68, 174, 66, 96, 130,
];

const CLASSES: &str = "version: 1\nclasses:\n  crate:\n    label: Crate\n    sizes: [[1, 1, 1]]\n    \
                       parents: [{on: floor}]\n    model: {file: crate.gltf}\n";
const ROOMS: &str = "version: 1\nroom_types:\n  crate_room:\n    label: Crate room\n    extends: study\n    \
                     programme: [{class: crate, count: 1, required: true}]\n";
const PLAN: &str = "version: 1\nid: a\nlevels:\n  - id: 1\n    rooms:\n      \
                    - {id: r, type: crate_room, rectangle: [0, 0, 4, 4]}\n    openings:\n      \
                    - {kind: door, room: r, edge: 0}\n";

/// The model's own colours: a different red for each corner.
const REDS: [u8; 8] = [0, 36, 73, 109, 146, 182, 219, 255];

/// Positions, indices, texture coordinates and colours of a cube.
fn buffer() -> Vec<u8> {
    let corner = |index: usize| [0, 1, 2].map(|axis| (index >> axis & 1) as f32);
    let quads: [[u16; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [a, b, c, a, c, d]);
    let mut bytes: Vec<u8> = (0..8).flat_map(corner).flat_map(f32::to_le_bytes).collect();
    bytes.extend(triangles.flat_map(u16::to_le_bytes));
    bytes.extend((0..8).flat_map(|index| [0, 1].map(|axis| corner(index)[axis])).flat_map(f32::to_le_bytes));
    bytes.extend(REDS.iter().flat_map(|&red| [red, 255, 255, 0]));
    bytes
}

fn document() -> serde_json::Value {
    json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "TEXCOORD_0": 2, "COLOR_0": 3}, "indices": 1, "material": 0,
        }]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8, "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 36},
            {"bufferView": 2, "componentType": 5126, "type": "VEC2", "count": 8},
            {"bufferView": 3, "componentType": 5121, "type": "VEC3", "count": 8, "normalized": true},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 96},
            {"buffer": 0, "byteOffset": 96, "byteLength": 72},
            {"buffer": 0, "byteOffset": 168, "byteLength": 64},
            {"buffer": 0, "byteOffset": 232, "byteLength": 32, "byteStride": 4},
        ],
        "buffers": [{"byteLength": 264, "uri": "parts/the%20box.bin"}],
        "images": [{"uri": "grain%20%231.png"}],
        "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728, "minFilter": 9987}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 0}],
        "materials": [{
            "name": "veil", "alphaMode": "BLEND",
            "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
            "emissiveTexture": {"index": 1},
        }],
    })
}

fn world() -> World {
    let world = World::new();
    world.write("a.yaml", PLAN);
    world.write("more/rooms/mine.yaml", ROOMS);
    world.write("more/classes/mine.yaml", CLASSES);
    world.write("more/classes/crate.gltf", document().to_string());
    world.write("more/classes/parts/the box.bin", buffer());
    world.write("more/classes/grain #1.png", DOT);
    world
}

fn bake(world: &World) -> String {
    world.must(&["bake", "a.yaml", "--catalog", "more"]).stdout
}

#[test]
fn samplers_colours_and_blending_are_kept() {
    let world = world();
    bake(&world);
    let file = gltf::Gltf::from_slice(&world.read("out/a/1.glb")).unwrap();
    let veil = file.materials().find(|material| material.name() == Some("veil")).unwrap();
    assert_eq!((veil.alpha_mode(), veil.alpha_cutoff()), (AlphaMode::Blend, None));
    let texture = veil.pbr_metallic_roughness().base_color_texture().unwrap().texture();
    let sampler = texture.sampler();
    assert_eq!(
        (sampler.wrap_s(), sampler.wrap_t()),
        (WrappingMode::ClampToEdge, WrappingMode::MirroredRepeat)
    );
    assert_eq!(sampler.mag_filter(), Some(MagFilter::Nearest));
    assert_eq!(sampler.min_filter(), Some(MinFilter::LinearMipmapLinear));
    let plain = veil.emissive_texture().unwrap().texture();
    assert_eq!(plain.sampler().index(), None, "the file's second texture names no sampler");
    assert_eq!(plain.source().index(), texture.source().index(), "one image");
    assert!(matches!(texture.source().source(), Source::View { mime_type: "image/png", .. }));

    let mesh = file.meshes().find(|mesh| mesh.name().unwrap().starts_with("crate.")).unwrap();
    let primitive = mesh.primitives().next().unwrap();
    assert!(primitive.get(&Semantic::TexCoords(0)).is_some());
    let blob = file.blob.as_ref().unwrap();
    let reader = primitive.reader(|_| Some(blob));
    let colors: Vec<[f32; 4]> = reader.read_colors(0).unwrap().into_rgba_f32().collect();
    let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
    assert_eq!(colors.len(), positions.len());
    for ([red, green, blue, opacity], position) in colors.into_iter().zip(positions) {
        // The model is moved to the middle of its underside.
        let bits = [position[0] > 0.0, position[1] > 0.5, position[2] > 0.0].map(usize::from);
        let corner = bits[0] + 2 * bits[1] + 4 * bits[2];
        assert_eq!([red, green, blue, opacity], [f32::from(REDS[corner]) / 255.0, 1.0, 1.0, 1.0]);
    }
}

#[test]
fn images_with_different_transforms_have_coordinates_of_their_own() {
    let world = world();
    let mut document = document();
    let transform = json!({"KHR_texture_transform": {"scale": [4, 4]}});
    document["materials"][0]["normalTexture"] = json!({"index": 0, "scale": 0.5, "extensions": transform});
    document["extensionsUsed"] = json!(["KHR_texture_transform"]);
    document["extensionsRequired"] = json!(["KHR_texture_transform"]);
    world.write("more/classes/crate.gltf", document.to_string());
    for detail in ["full", "boxes"] {
        world.must(&["bake", "a.yaml", "--catalog", "more", "--detail", detail]);
        let file = gltf::Gltf::from_slice(&world.read("out/a/1.glb")).unwrap();
        assert!(file.extensions_required().next().is_none(), "no viewer needs the extension");
        let veil = file.materials().find(|material| material.name() == Some("veil")).unwrap();
        let normals = veil.normal_texture().unwrap();
        assert_eq!((normals.tex_coord(), normals.scale()), (1, 0.5));
        assert_eq!(veil.emissive_texture().unwrap().tex_coord(), 0);
        let mesh = file.meshes().find(|mesh| mesh.name().unwrap().starts_with("crate.")).unwrap();
        let primitive = mesh.primitives().next().unwrap();
        let blob = file.blob.as_ref().unwrap();
        let reader = primitive.reader(|_| Some(blob));
        let [plain, finer] = [0, 1].map(|set| {
            let coordinates = reader.read_tex_coords(set).unwrap().into_f32();
            coordinates.collect::<Vec<[f32; 2]>>()
        });
        let times = if detail == "full" { 4.0 } else { 1.0 };
        assert!(plain.len() == finer.len() && plain.iter().any(|place| place[0] > 0.5));
        assert!(plain.iter().zip(&finer).all(|(a, b)| (a[0] * times - b[0]).abs() < 1e-5), "{detail}");
    }
}

/// The model in a container whose buffer and image stay outside it.
fn container() -> Vec<u8> {
    let glb = gltf::Glb {
        header: gltf::binary::Header { magic: *b"glTF", version: 2, length: 0 },
        json: document().to_string().into_bytes().into(),
        bin: None,
    };
    glb.to_vec().unwrap()
}

#[test]
fn a_change_beside_the_model_is_baked_again() {
    for is_container in [false, true] {
        let world = world();
        if is_container {
            world.write("more/classes/crate.glb", container());
            world.write("more/classes/mine.yaml", CLASSES.replace("crate.gltf", "crate.glb"));
        }
        assert!(bake(&world).contains("Baked 1 level,"));
        assert!(bake(&world).contains("Baked 0 levels"), "nothing has changed");
        let mut bytes = buffer();
        bytes[232] = 7;
        world.write("more/classes/parts/the box.bin", &bytes);
        assert!(bake(&world).contains("Baked 1 level,"), "the buffer, container: {is_container}");
        let image = [&DOT[..], b"more"].concat();
        world.write("more/classes/grain #1.png", &image);
        assert!(bake(&world).contains("Baked 1 level,"), "the image, container: {is_container}");
        assert!(bake(&world).contains("Baked 0 levels"));
    }
}
