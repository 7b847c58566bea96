//! Reading users' models from files made here.

mod faults;
mod materials;
mod shapes;

use std::path::Path;

use glam::Vec3;
use serde_json::{Value, json};

use super::UserModel;
use crate::document::Faults;
use crate::geometry::Size;
use crate::mesh::{Model, ModelMaterial, OwnMaterial};
use crate::recipes::{GeometrySet, RecipeInput, find};

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
        other => panic!("a user's model has its own materials, not {other:?}"),
    }
}

/// A box with an image on it.
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
fn the_sample_in_assets_is_read_back_as_it_was_built() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/stool.glb");
    let size = size(0.36, 0.36, 0.65);
    let read = UserModel::read(&path, 0.0).unwrap().fitted("chair", size).unwrap();
    let input = RecipeInput { size, look: 0, geometry: GeometrySet::Plain, parameters: &[] };
    let built = find("stool").unwrap().build(&input).into();
    let counts = |model: &Model| model.primitives.iter().map(|part| part.indices.len()).sum::<usize>();
    assert_eq!(counts(&read), counts(&built));
    assert!(bounds(&read).1.distance(bounds(&built).1) < 1e-5);
}
