//! Builds the node of a room with its shell and furniture.

use super::axes::Pose;
use super::carrier::carriers;
use super::extras::{furniture_extras, room_extras};
use super::input::SceneInput;
use super::light::{Owner, light_node};
use super::meshes::{Look, MeshTable};
use super::node::Node;
use super::options::{Lights, Parts};
use super::shell::{Equipment, RoomFinish, Storey, room_parts};
use super::tint::Tint;
use crate::catalog::{Catalog, FittedPart, VariantRef};
use crate::contract::{Extras, FurnitureExtras, owned_name, room_name};
use crate::geometry::{Convex, Point, direction};
use crate::layout::{Furnished, Parent, Placement};

/// The node of a room: shell parts first, then furniture in the order of its placement.
pub(crate) fn room_node<'a>(
    input: &SceneInput<'a>,
    storey: &Storey<'_>,
    index: usize,
    meshes: &mut MeshTable<'a>,
) -> Node {
    let furnished = &input.furnished[index];
    let room = &input.level.rooms[furnished.room];
    let verdict = input.verdicts.get(index).cloned().unwrap_or_default();
    let look = Look::of_style(input.catalog, furnished.style);
    let finish = RoomFinish::of(input.catalog, room);
    let extras = room_extras(room, furnished, verdict, input.catalog);
    let mut node = Node::at(room_name(&room.id), &ROOM_POSE, None, extras);
    let is_merged = input.options.parts == Parts::Merged;
    let worktops = worktops(input.catalog, furnished);
    node.children = room_parts(
        storey,
        furnished.room,
        finish,
        &Equipment { look, is_merged, worktops: &worktops },
        meshes,
    );
    node.children.extend(furniture(input, furnished, &room.id, look, meshes));
    node
}

/// The footprints of what people set things down on in fitted rows: there sockets are above it.
fn worktops(catalog: &Catalog, furnished: &Furnished) -> Vec<Convex> {
    let is_worktop = |placement: &&Placement| {
        let part = catalog.classes[placement.class].fitted;
        matches!(part, Some(FittedPart::Worktop | FittedPart::Corner | FittedPart::BesideSink))
    };
    let footprint = |placement: &Placement| {
        let half = Point::new(placement.size.width, placement.size.depth) / 2.0;
        Convex::rectangle(placement.position, half, direction(placement.angle))
    };
    furnished.placements.iter().filter(is_worktop).map(footprint).collect()
}

/// Rooms stand at the level's origin: outlines and placements are in the level's frame.
const ROOM_POSE: Pose = Pose { position: Point::ZERO, elevation: 0.0, angle: 0.0 };

fn pose(placement: &Placement) -> Pose {
    Pose { position: placement.position, elevation: placement.elevation, angle: placement.angle }
}

/// The objects that the room carries, each with what it carries.
fn furniture<'a>(
    input: &SceneInput<'a>,
    furnished: &Furnished,
    room: &str,
    look: Look,
    meshes: &mut MeshTable<'a>,
) -> Vec<Node> {
    let placements = &furnished.placements;
    let carriers = carriers(input.catalog, placements);
    let mut nodes: Vec<Option<Node>> = Vec::with_capacity(placements.len());
    let mut tints = Vec::with_capacity(placements.len());
    for (placement, carrier) in placements.iter().zip(&carriers) {
        let frame = carrier.map_or(ROOM_POSE, |carrier| pose(&placements[carrier]));
        let extras = furniture_extras(input, furnished, placement);
        let name = owned_name(&extras.id, room);
        let tint = tint_of(furnished, placement, &extras, &tints);
        tints.push(tint);
        let mesh = meshes.furniture(VariantRef::new(placement.class, placement.variant), look, tint);
        let light = light_of(input, placement, Owner { id: &extras.id, room }, meshes);
        let place = pose(placement).relative_to(&frame);
        let mut node = Node::at(name, &place, Some(mesh), Extras::Furniture(extras));
        node.children.extend(light);
        nodes.push(Some(node));
    }
    // Carriers come before what they carry: from the end, each node is complete when its turn comes.
    for index in (0..placements.len()).rev() {
        if let Some(carrier) = carriers[index]
            && let Some(child) = nodes[index].take()
            && let Some(Some(carrier)) = nodes.get_mut(carrier)
        {
            carrier.children.push(child);
        }
    }
    let mut roots: Vec<Node> = nodes.into_iter().flatten().collect();
    roots.iter_mut().for_each(order_children);
    roots
}

/// The node of a lamp's light.
fn light_of(
    input: &SceneInput<'_>,
    placement: &Placement,
    owner: Owner<'_>,
    meshes: &mut MeshTable<'_>,
) -> Option<Node> {
    let light =
        input.catalog.classes[placement.class].light.filter(|_| input.options.lights != Lights::Off)?;
    let index = (input.options.lights == Lights::Physical).then(|| meshes.light(&light));
    Some(light_node(&light, placement.size, owner, index))
}

/// A piece beside one of its own class has the same tint, so that a row of bookcases has one.
fn tint_of(furnished: &Furnished, placement: &Placement, extras: &FurnitureExtras, earlier: &[Tint]) -> Tint {
    match placement.parent {
        Parent::Object(parent) if furnished.placements[parent].class == placement.class => earlier[parent],
        _ => Tint::of_set(furnished.seed, &extras.class, &extras.parent),
    }
}

/// Children were attached last first; the order of placement is the order in the file.
fn order_children(node: &mut Node) {
    node.children.reverse();
    node.children.iter_mut().for_each(order_children);
}
