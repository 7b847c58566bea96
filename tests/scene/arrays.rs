//! Files omit arrays that repeat, corners that agree, and normals that follow from flat faces.

use std::collections::BTreeSet;

use gltf::mesh::Semantic;
use roomwright::internals::gltf::{EncodedModels, FlatNormals, WriteOptions, write_glb, write_glb_with};
use roomwright::internals::model::Primitive;
use roomwright::internals::scene::Scene;

use crate::fixture::*;

const IMPLIED: WriteOptions<'_> =
    WriteOptions { library: None, models: None, flat_normals: FlatNormals::Implied };

fn furnished_scene() -> Scene {
    scene(&two_rooms(), &two_furnished(&catalog()))
}

/// The corners of each triangle of each primitive, and whether it has normals.
fn triangles(bytes: &[u8]) -> Vec<(Vec<[f32; 3]>, bool)> {
    let file = gltf::Gltf::from_slice(bytes).unwrap();
    let primitives = file.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>());
    let read = primitives.map(|primitive| {
        let reader = primitive.reader(|_| file.blob.as_deref());
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let indices = reader.read_indices().unwrap().into_u32();
        let corners = indices.map(|index| positions[index as usize]).collect();
        (corners, primitive.get(&Semantic::Normals).is_some())
    });
    read.collect()
}

#[test]
fn flat_faces_may_do_without_normals() {
    let scene = furnished_scene();
    let (written, implied) = (write_glb(&scene).unwrap(), write_glb_with(&scene, IMPLIED).unwrap());
    assert!(implied.len() < written.len());
    let (written, implied) = (triangles(&written), triangles(&implied));
    assert!(written.iter().all(|(_, has_normals)| *has_normals));
    // Shell and boxes of the fixture are flat.
    assert!(implied.iter().all(|(_, has_normals)| !has_normals));
    let corners = |found: &[(Vec<[f32; 3]>, bool)]| found.iter().map(|(c, _)| c.clone()).collect::<Vec<_>>();
    assert_eq!(corners(&written), corners(&implied), "the triangles are the same");
}

#[test]
fn faces_without_normals_share_their_corners() {
    let file = gltf::Gltf::from_slice(&write_glb_with(&furnished_scene(), IMPLIED).unwrap()).unwrap();
    for primitive in file.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>()) {
        let positions = primitive.reader(|_| file.blob.as_deref()).read_positions().unwrap();
        let positions: Vec<[u32; 3]> = positions.map(|position| position.map(f32::to_bits)).collect();
        let distinct: BTreeSet<&[u32; 3]> = positions.iter().collect();
        assert_eq!(distinct.len(), positions.len());
    }
}

#[test]
fn equal_arrays_are_there_once() {
    let scene = furnished_scene();
    let file = gltf::Gltf::from_slice(&write_glb(&scene).unwrap()).unwrap();
    let places: Vec<_> = file
        .accessors()
        .map(|accessor| (accessor.view().unwrap().index(), accessor.offset(), accessor.count()))
        .collect();
    assert_eq!(places.iter().collect::<BTreeSet<_>>().len(), places.len());
    // The fixture's boxes differ in size only.
    let boxes: Vec<&Primitive> =
        scene.meshes.iter().filter(|mesh| mesh.is_shared()).flat_map(|mesh| &mesh.model.primitives).collect();
    assert!(boxes.len() > 1 && boxes.iter().all(|part| part.normals == boxes[0].normals));
    let shared = |semantic: &Semantic| -> BTreeSet<usize> {
        let meshes = file.meshes().filter(|mesh| scene.meshes[mesh.index()].is_shared());
        let primitives = meshes.flat_map(|mesh| mesh.primitives().collect::<Vec<_>>());
        primitives.map(|primitive| primitive.get(semantic).unwrap().index()).collect()
    };
    assert_eq!(shared(&Semantic::Normals).len(), 1);
    assert!(shared(&Semantic::Positions).len() > 1);
}

#[test]
fn models_encoded_for_other_levels_change_no_byte() {
    let scene = furnished_scene();
    let models = EncodedModels::default();
    for flat_normals in [FlatNormals::Written, FlatNormals::Implied, FlatNormals::Written] {
        let alone = WriteOptions { flat_normals, ..WriteOptions::default() };
        let known = WriteOptions { models: Some(&models), ..alone };
        assert_eq!(write_glb_with(&scene, known).unwrap(), write_glb_with(&scene, alone).unwrap());
    }
}
