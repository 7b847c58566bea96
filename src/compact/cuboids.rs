//! Boxes as instances of one cube: those of one colour are one draw call, whichever pieces they are of, and each takes a tenth of the
//! bytes of its corners.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::{DQuat, Vec3};

use super::Shown;
use super::coarse::{Cuboid, Extent, Seen, add_box};
use super::encode::{Grid, color, encode};
use super::instances::{EncodedModel, Instance, Instances};
use super::listing::{Drawn, Frame};
use super::merged::{Merged, ShownColor, Surface};
use super::options::Coloring;
use crate::mesh::{Model, Primitive};

/// The look of a box: all its corners have one colour.
pub(super) type Look = (Surface, [u8; 4]);

/// The look of each box of a mesh, in their order.
pub(super) fn looks(shown: &Shown<'_>, mesh: usize) -> Vec<Look> {
    let Some(Seen { model, cuboids }) = &shown.models[mesh] else { return Vec::new() };
    let materials = &shown.scene.meshes[mesh].materials;
    let look = |cuboid: &Cuboid| {
        let material = materials[cuboid.primitive];
        let of_material = ShownColor::of(&shown.materials[material], shown.images);
        let shade = of_material.at(&model.primitives[cuboid.primitive], cuboid.first);
        (Surface::of(shown, material), color(shade))
    };
    cuboids.iter().map(look).collect()
}

/// The look of each material of a mesh; `None` where an image decides, or where corners have no colours.
pub(super) fn part_looks(shown: &Shown<'_>, mesh: usize) -> Option<Vec<Look>> {
    if shown.coloring == Coloring::Materials {
        return None;
    }
    let materials = shown.scene.meshes[mesh].materials.iter();
    let look = |&material: &usize| {
        let plain = ShownColor::of(&shown.materials[material], shown.images).plain()?;
        Some((Surface::of(shown, material), color(plain)))
    };
    materials.map(look).collect()
}

/// How much each number of a colour may differ from that of another that looks alike: of the highest number, in steps that look about
/// equal to the eye. Tints of one wood are as much apart; colours of different things are not.
const ALIKE: f32 = 0.035;

/// For each look one that stands for it: of looks alike, the one of most boxes, the lowest of equal ones.
pub(super) fn standing(box_counts: &BTreeMap<Look, usize>) -> BTreeMap<Look, Look> {
    let mut by_count: Vec<(Look, usize)> = box_counts.iter().map(|(look, count)| (*look, *count)).collect();
    by_count.sort_by_key(|&(look, count)| (Reverse(count), look));
    let mut leaders: Vec<Look> = Vec::new();
    let mut standing = BTreeMap::new();
    for (look, _) in by_count {
        let leader = leaders.iter().copied().find(|leader| are_alike(*leader, look)).unwrap_or(look);
        if leader == look {
            leaders.push(look);
        }
        standing.insert(look, leader);
    }
    standing
}

fn are_alike((surface, one): Look, (other_surface, other): Look) -> bool {
    // The eye sees about the square root of light.
    let seen = |number: u8| (f32::from(number) / f32::from(u8::MAX)).sqrt();
    let are_near = |channel: usize| (seen(one[channel]) - seen(other[channel])).abs() <= ALIKE;
    surface == other_surface && (0..4).all(are_near)
}

/// Takes the boxes of some looks out of what is drawn: gives their instances, each in the look that stands for its own and in the order
/// of these, and the models without them.
pub(super) fn take(
    shown: &Shown<'_>,
    drawn: &[&Drawn],
    wanted: &BTreeMap<Look, Look>,
) -> (Vec<Instances>, Vec<Option<Seen>>) {
    let mut rest = shown.models.to_vec();
    let mut places: BTreeMap<Look, Vec<Instance>> = BTreeMap::new();
    let meshes: BTreeSet<usize> = drawn.iter().map(|drawn| drawn.mesh).collect();
    let mut taken: BTreeMap<usize, Vec<(Look, Cuboid)>> = BTreeMap::new();
    for mesh in meshes {
        let Some(seen) = &shown.models[mesh] else { continue };
        let stands = looks(shown, mesh).into_iter().map(|look| wanted.get(&look).copied());
        let all: Vec<(Option<Look>, Cuboid)> = stands.zip(seen.cuboids.iter().copied()).collect();
        if all.iter().any(|(look, _)| look.is_some()) {
            rest[mesh] = Some(without(seen, &all));
            taken.insert(mesh, all.into_iter().filter_map(|(look, cuboid)| Some((look?, cuboid))).collect());
        }
    }
    for drawn in drawn {
        for (look, cuboid) in taken.get(&drawn.mesh).into_iter().flatten() {
            places.entry(*look).or_default().push(place(drawn, cuboid));
        }
    }
    (places.into_iter().map(|(look, places)| instances(look, places)).collect(), rest)
}

/// A model without the boxes that have a look here.
fn without(seen: &Seen, all: &[(Option<Look>, Cuboid)]) -> Seen {
    let primitives = seen.model.primitives.iter().enumerate().map(|(number, primitive)| {
        let boxes: Vec<&(Option<Look>, Cuboid)> =
            all.iter().filter(|(_, cuboid)| cuboid.primitive == number).collect();
        let stays = |triangle: &&[u32; 3]| {
            let after = boxes.partition_point(|(_, cuboid)| cuboid.first <= triangle[0] as usize);
            after.checked_sub(1).is_none_or(|last| boxes[last].0.is_none())
        };
        primitive.with_triangles(primitive.indices.as_chunks::<3>().0.iter().filter(stays).flatten().copied())
    });
    Seen { model: Arc::new(Model { primitives: primitives.collect() }), cuboids: Arc::default() }
}

/// Where the cube is a box of a mesh at its place.
fn place(drawn: &Drawn, Cuboid { low, high, .. }: &Cuboid) -> Instance {
    let half = (*high - *low) / 2.0;
    let translation = drawn.frame.point(((*low + *high) / 2.0).as_dvec3());
    let (rotation, scale) = squared(drawn.frame.rotation, half);
    Instance { frame: Frame { rotation, translation }, scale, feature: drawn.feature }
}

/// Numbers of a rotation that are equal but for rounding.
const ROUNDING: f64 = 1e-6;

/// The rotation of a box and its sizes: none where quarter turns only exchange its sides.
fn squared(rotation: DQuat, half: Vec3) -> (DQuat, Vec3) {
    let [x, y, z, w] = rotation.to_array().map(f64::abs);
    if x.max(z) > ROUNDING {
        (rotation, half)
    } else if y.min(w) < ROUNDING {
        (DQuat::IDENTITY, half)
    } else if (y - w).abs() < ROUNDING {
        (DQuat::IDENTITY, Vec3::new(half.z, half.y, half.x))
    } else {
        (rotation, half)
    }
}

/// The cube of a look at some places.
fn instances((surface, shade): Look, places: Vec<Instance>) -> Instances {
    let mut cube = Primitive::default();
    add_box(&mut cube, Extent([Vec3::NEG_ONE, Vec3::ONE]), |_, _| true);
    let shade = shade.map(|channel| f32::from(channel) / f32::from(u8::MAX));
    let merged = Merged {
        positions: cube.positions.iter().map(|&at| Vec3::from_array(at).as_dvec3()).collect(),
        normals: cube.normals.iter().copied().map(Vec3::from_array).collect(),
        colors: vec![shade; cube.positions.len()],
        indices: cube.indices,
        ..Merged::default()
    };
    let parts = vec![(0, encode(&merged, &Grid::OF_WHOLE))];
    let model = Arc::new(EncodedModel { step: 1.0, parts });
    Instances { name: "boxes".to_owned(), surfaces: vec![surface], model, places }
}
