//! Reads all furniture of a file as an editor left it, for capturing edits.
//!
//! Editors rename copies, detach the children of a removed parent, and hang objects below other rooms. None of this is a
//! fault here; [`super::parse_level`] is stricter.

use std::collections::BTreeMap;

use glam::DVec3;
use gltf::json::Root;

use super::family::Family;
use super::furniture::{pose, spots};
use super::looks::{mesh_bounds, mesh_name, shape};
use super::problem::Problem;
use super::tree::Node;
use crate::contract::{
    ElementId, Extras, FurnitureExtras, ObjectId, VariantId, model_in_name, owner_in_name,
};

/// The furniture of a level.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
    /// The furniture, in the order of the file.
    pub objects: Vec<SurveyedObject>,
    /// The looks of the models, by variant: equal texts, equal models.
    pub models: BTreeMap<VariantId, String>,
    /// Names of nodes with a mesh that say nothing of themselves and hang in a room, or nowhere.
    pub strangers: Vec<String>,
    /// Names of nodes whose extras cannot be read.
    pub broken: Vec<String>,
}

/// A piece of furniture.
#[derive(Clone, Debug)]
pub struct SurveyedObject {
    /// Name of its node.
    pub node: String,
    /// The id that it says it has; copies say the same.
    pub id: ObjectId,
    /// Class id.
    pub class: String,
    /// Variant.
    pub variant: u32,
    /// The side of its parent that it touches.
    pub side: String,
    /// Width, depth, height before it is scaled.
    pub size: [f64; 3],
    /// The variant in the name of its mesh, if it has one.
    pub model: Option<VariantId>,
    /// The box around its mesh, in its own frame: the least and the greatest of each axis, in metres.
    pub bounds: Option<[[f64; 3]; 2]>,
    /// The room that it hangs below, else the one in its name.
    pub room: Option<String>,
    /// The room in its name: where it was when it was baked.
    pub named_room: Option<String>,
    /// The object that it belongs to, by index.
    pub above: Option<usize>,
    /// The parent in its extras.
    pub parent: ElementId,
    /// Where it is; `None` unless it stands upright somewhere.
    pub place: Option<SurveyedPlace>,
}

/// A place in the plan frame of the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurveyedPlace {
    /// Metres east, north, above the floor.
    pub position: DVec3,
    /// Radians counter-clockwise.
    pub angle: f64,
    /// Factors of width, depth and height.
    pub scale: [f64; 3],
}

pub(super) fn read(document: &Root, nodes: &[Node]) -> Result<Survey, Problem> {
    let level = super::level::level_extras(nodes)?;
    let mut survey = Survey { building: level.building, level: level.level, ..Survey::default() };
    let room_of = |node: usize| matches!(nodes[node].extras, Some(Extras::Room(_))).then_some(node);
    let spots = spots(nodes, room_of);
    let worlds = worlds(nodes);
    let family = Family::new(nodes, &spots);
    let mut index_of = vec![None; nodes.len()];
    let mut parents = Vec::new();
    for (index, node) in nodes.iter().enumerate() {
        let Some(Extras::Furniture(extras)) = &node.extras else {
            survey.strangers.extend(stranger(nodes, node));
            survey.broken.extend(node.is_broken.then(|| node.name.clone()));
            continue;
        };
        let room = spots[index].and_then(|spot| match &nodes[spot.room].extras {
            Some(Extras::Room(room)) => Some(room.room.clone()),
            _ => None,
        });
        let place = spots[index].map_or(worlds[index], |spot| spot.place);
        index_of[index] = Some(survey.objects.len());
        parents.push(family.parent_of(index).or_else(|| furniture_above(nodes, node)));
        let object = object(document, node, extras, room, &place);
        if let (Some(model), Some(mesh)) = (object.model.clone(), node.mesh) {
            survey.models.entry(model).or_insert_with(|| shape(document, mesh));
        }
        survey.objects.push(object);
    }
    for (object, parent) in survey.objects.iter_mut().zip(parents) {
        object.above = parent.and_then(|parent| index_of[parent]);
    }
    Ok(survey)
}

fn object(
    document: &Root,
    node: &Node,
    extras: &FurnitureExtras,
    room: Option<String>,
    place: &glam::DMat4,
) -> SurveyedObject {
    let named_room = owner_in_name(&node.name, &extras.id).map(str::to_owned);
    SurveyedObject {
        node: node.name.clone(),
        id: extras.id.clone(),
        class: extras.class.clone(),
        variant: extras.variant,
        side: extras.side.to_string(),
        size: extras.size,
        model: mesh_name(document, node.mesh).and_then(model_in_name),
        bounds: node.mesh.and_then(|mesh| mesh_bounds(document, mesh)),
        room: room.or_else(|| named_room.clone()),
        named_room,
        above: None,
        parent: extras.parent.clone(),
        place: pose(place).map(|(position, angle, scale)| SurveyedPlace {
            position,
            angle,
            scale: [scale.x, scale.z, scale.y],
        }),
    }
}

/// The nearest piece of furniture that a node hangs below.
fn furniture_above(nodes: &[Node], node: &Node) -> Option<usize> {
    let mut ancestors = std::iter::successors(node.parent, |&ancestor| nodes[ancestor].parent);
    ancestors.find(|&ancestor| matches!(nodes[ancestor].extras, Some(Extras::Furniture(_))))
}

/// The place of each node in the file.
fn worlds(nodes: &[Node]) -> Vec<glam::DMat4> {
    let mut worlds: Vec<glam::DMat4> = Vec::with_capacity(nodes.len());
    for node in nodes {
        // Parents come before children.
        let world = node.parent.map_or(node.local, |parent| worlds[parent] * node.local);
        worlds.push(world);
    }
    worlds
}

/// The name of a node that was added by other means.
fn stranger(nodes: &[Node], node: &Node) -> Option<String> {
    let is_in_room = match node.parent {
        Some(parent) => matches!(nodes[parent].extras, Some(Extras::Room(_) | Extras::Level(_))),
        None => true,
    };
    (node.extras.is_none() && !node.is_broken && node.mesh.is_some() && is_in_room).then(|| node.name.clone())
}
