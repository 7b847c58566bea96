//! Compact files hold what the scene shows.

use std::collections::BTreeMap;

use glam::{DQuat, DVec3};
use serde_json::Value;

use super::{Coarse, Coloring, CompactOptions, Instancing, Known, Shapes, write_compact};
use crate::contract::{Extras, RoomId};
use crate::output::{LevelOptions, TextureOptions};
use crate::project::Project;
use crate::scene::{Node, Scene};

/// A parsed file.
struct File {
    json: Value,
    data: Vec<u8>,
}

const PLAIN: CompactOptions = CompactOptions {
    coloring: Coloring::Corners,
    least_size: 0.0,
    shapes: Shapes::Kept,
    coarsest_step: 0.01,
    instancing: Instancing::Gpu,
    most_draws: 150,
    has_normal_maps: false,
    keeps_nodes: false,
};

/// The living room of the house.
fn living() -> Scene {
    let project = Project::read(&["configs/plans/house.yaml"].into_iter().collect()).unwrap();
    let options = LevelOptions {
        textures: TextureOptions { size: None, are_shared: false },
        ..project.level_options()
    };
    let rooms = project.rooms(&options);
    let room = rooms.furnish(&RoomId::new("house", "ground", "living")).unwrap();
    rooms.scene(&room)
}

fn written(scene: &Scene, options: &CompactOptions) -> File {
    let bytes = write_compact(scene, &scene.materials, &Known::default(), options).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let json = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    File { json, data: bytes.get(28 + length..).unwrap_or_default().to_vec() }
}

impl File {
    fn number(&self, pointer: &str) -> usize {
        self.json.pointer(pointer).and_then(Value::as_u64).unwrap_or(0) as usize
    }

    /// The elements of an accessor as they are in the file, without scales.
    fn elements(&self, accessor: usize) -> Vec<Vec<f64>> {
        let of = |key: &str| format!("/accessors/{accessor}/{key}");
        let view = self.number(&of("bufferView"));
        let start = self.number(&format!("/bufferViews/{view}/byteOffset")) + self.number(&of("byteOffset"));
        let components = match self.json.pointer(&of("type")).unwrap().as_str().unwrap() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            _ => 4,
        };
        let (size, read): (usize, fn(&[u8]) -> f64) = match self.number(&of("componentType")) {
            5120 => (1, |bytes| f64::from(bytes[0] as i8)),
            5121 => (1, |bytes| f64::from(bytes[0])),
            5122 => (2, |bytes| f64::from(i16::from_le_bytes([bytes[0], bytes[1]]))),
            5123 => (2, |bytes| f64::from(u16::from_le_bytes([bytes[0], bytes[1]]))),
            5125 => (4, |bytes| f64::from(u32::from_le_bytes(bytes[..4].try_into().unwrap()))),
            _ => (4, |bytes| f64::from(f32::from_le_bytes(bytes[..4].try_into().unwrap()))),
        };
        let stride = match self.number(&format!("/bufferViews/{view}/byteStride")) {
            0 => size * components,
            stride => stride,
        };
        let element = |index: usize| {
            let from = start + index * stride;
            (0..components).map(|part| read(&self.data[from + part * size..])).collect()
        };
        (0..self.number(&of("count"))).map(element).collect()
    }

    fn vectors(&self, accessor: usize) -> Vec<DVec3> {
        self.elements(accessor).into_iter().map(|at| DVec3::new(at[0], at[1], at[2])).collect()
    }

    /// A column of the table.
    fn column(&self, name: &str) -> Vec<String> {
        let table = format!("/extensions/EXT_structural_metadata/propertyTables/0/properties/{name}");
        let slice = |view: usize| {
            let start = self.number(&format!("/bufferViews/{view}/byteOffset"));
            &self.data[start..start + self.number(&format!("/bufferViews/{view}/byteLength"))]
        };
        let text = slice(self.number(&format!("{table}/values")));
        assert_eq!(self.json.pointer(&format!("{table}/stringOffsetType")).unwrap(), "UINT16");
        let offsets = slice(self.number(&format!("{table}/stringOffsets"))).chunks_exact(2);
        let offsets: Vec<usize> =
            offsets.map(|word| usize::from(u16::from_le_bytes(word.try_into().unwrap()))).collect();
        offsets.windows(2).map(|ends| String::from_utf8(text[ends[0]..ends[1]].to_vec()).unwrap()).collect()
    }

    /// The box of each feature in the frame of the level, by room and id, and how many triangles are drawn.
    fn features(&self) -> (BTreeMap<(String, String), [DVec3; 2]>, usize) {
        let (rooms, ids) = (self.column("room"), self.column("id"));
        let mut found: BTreeMap<(String, String), [DVec3; 2]> = BTreeMap::new();
        let mut triangles = 0;
        let mut add = |feature: f64, at: DVec3| {
            let key = (rooms[feature as usize].clone(), ids[feature as usize].clone());
            let known = found.entry(key).or_insert([DVec3::INFINITY, DVec3::NEG_INFINITY]);
            *known = [known[0].min(at), known[1].max(at)];
        };
        for node in self.json["nodes"].as_array().unwrap() {
            let Some(mesh) = node["mesh"].as_u64() else { continue };
            let instanced = &node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
            let vector = |key: &str, default: f64| {
                let of = |axis: usize| node[key][axis].as_f64().unwrap_or(default);
                DVec3::new(of(0), of(1), of(2))
            };
            for primitive in self.json["meshes"][mesh as usize]["primitives"].as_array().unwrap() {
                let accessor = |value: &Value| value.as_u64().unwrap() as usize;
                let positions = self.vectors(accessor(&primitive["attributes"]["POSITION"]));
                let count = self.elements(accessor(&primitive["indices"])).len() / 3;
                let (scale, move_by) = (vector("scale", 1.0), vector("translation", 0.0));
                if instanced.is_null() {
                    let features = self.elements(accessor(&primitive["attributes"]["_FEATURE_ID_0"]));
                    let corners = positions.iter().zip(features);
                    corners.for_each(|(at, feature)| add(feature[0], *at * scale + move_by));
                    triangles += count;
                    continue;
                }
                let of = |key: &str| match &instanced[key] {
                    Value::Null => Vec::new(),
                    given => self.elements(accessor(given)),
                };
                let (places, scales, turns) = (of("TRANSLATION"), of("SCALE"), of("ROTATION"));
                for (instance, feature) in of("_FEATURE_ID_0").iter().enumerate() {
                    let place = DVec3::from_slice(&places[instance]);
                    let turn = turns
                        .get(instance)
                        .map_or(DQuat::IDENTITY, |turn| DQuat::from_slice(turn).normalize());
                    let own = scales.get(instance).map_or(DVec3::ONE, |scale| DVec3::from_slice(scale));
                    let at_home = |at: &DVec3| (turn * (*at * own) + place) * scale;
                    positions.iter().for_each(|at| add(feature[0], at_home(at)));
                    triangles += count;
                }
            }
        }
        (found, triangles)
    }
}

/// The same of a scene: the box of each piece by room and id, and how many triangles there are.
fn shown(scene: &Scene) -> (BTreeMap<(String, String), [DVec3; 2]>, usize) {
    let mut found = BTreeMap::new();
    let mut triangles = 0;
    add_node(scene, &scene.root, (DQuat::IDENTITY, DVec3::ZERO), "", &mut (&mut found, &mut triangles));
    (found, triangles)
}

type Found<'f> = (&'f mut BTreeMap<(String, String), [DVec3; 2]>, &'f mut usize);

fn add_node(scene: &Scene, node: &Node, parent: (DQuat, DVec3), room: &str, found: &mut Found<'_>) {
    let turn = parent.0 * node.rotation.as_dquat();
    let place = parent.1 + parent.0 * node.translation.as_dvec3();
    let room = match &node.extras {
        Some(Extras::Room(extras)) => extras.room.clone(),
        _ => room.to_owned(),
    };
    if let Some(mesh) = node.mesh {
        let model = &scene.meshes[mesh].model;
        *found.1 += model.primitives.iter().map(|part| part.indices.len() / 3).sum::<usize>();
        if let Some(Extras::Furniture(piece)) = &node.extras {
            let key = (room.clone(), piece.id.to_string());
            let known = found.0.entry(key).or_insert([DVec3::INFINITY, DVec3::NEG_INFINITY]);
            for corner in model.primitives.iter().flat_map(|part| &part.positions) {
                let at = turn * glam::Vec3::from_array(*corner).as_dvec3() + place;
                *known = [known[0].min(at), known[1].max(at)];
            }
        }
    }
    node.children.iter().for_each(|child| add_node(scene, child, (turn, place), &room, found));
}

#[test]
fn everything_is_drawn_where_the_scene_has_it_and_has_its_name() {
    let scene = living();
    let (pieces, triangles) = shown(&scene);
    assert!(pieces.len() > 20);
    for coloring in [Coloring::Corners, Coloring::Materials] {
        for instancing in [Instancing::Gpu, Instancing::None] {
            let file = written(&scene, &CompactOptions { coloring, instancing, ..PLAIN });
            let (features, drawn) = file.features();
            assert_eq!(drawn, triangles, "{coloring:?} {instancing:?}");
            for (key, [low, high]) in &pieces {
                let [found_low, found_high] = features[key];
                let off = (found_low - low).abs().max((found_high - high).abs()).max_element();
                assert!(off < 0.001, "{key:?} is off by {off} m");
            }
        }
    }
}

#[test]
fn what_all_pieces_share_is_said_once() {
    let file = written(&living(), &PLAIN);
    let metadata = &file.json["extensions"]["EXT_structural_metadata"];
    let described = &metadata["schema"]["classes"]["piece"]["properties"];
    assert_eq!(described["building"]["default"], "house");
    assert_eq!(described["level"]["default"], "ground");
    let columns: Vec<&String> =
        metadata["propertyTables"][0]["properties"].as_object().unwrap().keys().collect();
    assert_eq!(columns, ["class", "id", "room", "room_type"]);
    assert!(columns.iter().all(|column| described[column.as_str()]["required"] == true));
}

#[test]
fn corners_that_agree_in_everything_are_one() {
    let scene = living();
    for coloring in [Coloring::Corners, Coloring::Materials] {
        let file = written(&scene, &CompactOptions { coloring, instancing: Instancing::None, ..PLAIN });
        for primitive in file.json["meshes"][0]["primitives"].as_array().unwrap() {
            let columns = primitive["attributes"].as_object().unwrap().values();
            let columns: Vec<Vec<Vec<f64>>> =
                columns.map(|accessor| file.elements(accessor.as_u64().unwrap() as usize)).collect();
            let corner = |index: usize| -> Vec<u64> {
                columns
                    .iter()
                    .flat_map(|column| column[index].iter().map(|number| number.to_bits()))
                    .collect()
            };
            let different: std::collections::BTreeSet<Vec<u64>> = (0..columns[0].len()).map(corner).collect();
            // Two places may be one in whole numbers of a step.
            assert!(
                different.len() * 100 > columns[0].len() * 99,
                "{} of {}",
                different.len(),
                columns[0].len()
            );
        }
    }
}

#[test]
fn few_draw_calls_are_left() {
    let scene = living();
    let draws = |file: &File| -> usize {
        let meshes = file.json["meshes"].as_array().unwrap().iter();
        meshes.map(|mesh| mesh["primitives"].as_array().unwrap().len()).sum()
    };
    assert!(draws(&written(&scene, &PLAIN)) <= 150);
    assert!(draws(&written(&scene, &CompactOptions { instancing: Instancing::None, ..PLAIN })) <= 4);
    let few = CompactOptions { most_draws: 20, ..PLAIN };
    assert!(draws(&written(&scene, &few)) <= 20);
}

#[test]
fn what_is_small_is_left_out_and_boxes_are_few_triangles() {
    let scene = living();
    let (all, triangles) = written(&scene, &PLAIN).features();
    let (large, fewer) = written(&scene, &CompactOptions { least_size: 0.3, ..PLAIN }).features();
    assert!(large.len() < all.len() && fewer < triangles);
    let shapes =
        Shapes::Coarse(Coarse { least_width: 0.1, boxed: 1.0, rounding: 0.1, sheet: 0.05, has_trim: false });
    let boxes = CompactOptions { least_size: 0.3, shapes, instancing: Instancing::None, ..PLAIN };
    let (seen, least) = written(&scene, &boxes).features();
    assert!(least * 3 < fewer, "{least} of {fewer}");
    // A sofa is still where it was.
    let sofa = |features: &BTreeMap<(String, String), [DVec3; 2]>| {
        features.iter().find(|((_, id), _)| id.contains("sofa")).map(|(_, found)| *found).unwrap()
    };
    let ([low, high], [other_low, other_high]) = (sofa(&all), sofa(&seen));
    assert!((low - other_low).length() < 0.15 && (high - other_high).length() < 0.15);
}

#[test]
fn nodes_can_be_kept_for_those_who_read_them() {
    let scene = living();
    let file = written(&scene, &CompactOptions { keeps_nodes: true, ..PLAIN });
    let kinds =
        file.json["nodes"].as_array().unwrap().iter().filter_map(|node| node["extras"]["kind"].as_str());
    let furniture = kinds.filter(|kind| *kind == "furniture").count();
    assert_eq!(furniture, shown(&scene).0.len());
    assert_eq!(file.json["scenes"][0]["nodes"].as_array().unwrap().len(), 2);
}

#[test]
fn an_empty_scene_is_an_empty_file() {
    let scene = Scene { meshes: Vec::new(), ..living() };
    let scene = Scene { root: Node { children: Vec::new(), ..scene.root.clone() }, ..scene };
    let file = written(&scene, &PLAIN);
    assert!(file.json.get("meshes").is_none() && file.json.get("extensionsRequired").is_none());
}

#[test]
fn boxes_are_instances_of_one_cube_where_they_were() {
    let scene = living();
    let shapes =
        Shapes::Coarse(Coarse { least_width: 0.03, boxed: 0.4, rounding: 0.03, sheet: 0.0, has_trim: true });
    let coarse = CompactOptions { least_size: 0.1, shapes, most_draws: 20, ..PLAIN };
    let file = written(&scene, &coarse);
    let merged = written(&scene, &CompactOptions { instancing: Instancing::None, ..coarse });
    let cubes = file.json["meshes"].as_array().unwrap().iter().filter(|mesh| mesh["name"] == "boxes").count();
    assert!(cubes > 3, "{cubes}");
    assert!(file.data.len() * 3 < merged.data.len() * 2, "{} of {}", file.data.len(), merged.data.len());
    let (features, expected) = (file.features().0, merged.features().0);
    assert_eq!(features.len(), expected.len());
    for (key, [low, high]) in &expected {
        let [found_low, found_high] = features[key];
        let off = (found_low - low).abs().max((found_high - high).abs()).max_element();
        assert!(off < 0.002, "{key:?} is off by {off} m");
    }
}
