//! Reads the content of a finished file without a catalogue, for comparisons.
//!
//! A class that only one of two catalogues has is compared by its name.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DQuat, DVec3};
use gltf::json::Root;

use super::family::Family;
use super::furniture::{Spot, spots};
use super::looks::{Looks, material_names};
use super::problem::Problem;
use super::tree::Node;
use crate::contract::{
    ElementId, Extras, FindingExtras, FurnitureExtras, ObjectId, OpeningExtras, RoomExtras, SiteExtras,
    room_in_name,
};
use crate::scene::{plan_point, plan_rotation};

/// A level and all that is in it. Lengths are metres in the plan frame, z up.
#[derive(Clone, Debug, Default)]
pub struct Inventory {
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
    /// Metres above the building's zero.
    pub elevation: f64,
    /// Metres from floor to floor.
    pub height: f64,
    /// Where the building stands; none at the site's origin.
    pub site: Option<SiteExtras>,
    /// The origin of the level, as the file says it: `generator`, `seed`.
    pub settings: BTreeMap<&'static str, String>,
    /// By id.
    pub rooms: BTreeMap<String, RoomContents>,
    /// Rooms of which something cannot be read: nothing is said about them.
    pub broken_rooms: BTreeSet<String>,
    /// Doors and windows, in the order of the file.
    pub openings: Vec<OpeningEntry>,
    /// The looks of the parts of the file, besides their places.
    pub looks: Looks,
}

/// A room and what stands in it.
#[derive(Clone, Debug, Default)]
pub struct RoomContents {
    /// Room type.
    pub room_type: String,
    /// Style.
    pub style: String,
    /// The seed that repeats it.
    pub seed: u64,
    /// Rings of corners: the outline, holes, columns.
    pub rings: Vec<Vec<[f64; 2]>>,
    /// Metres from floor to ceiling.
    pub height: f64,
    /// Missing pieces: class and reason.
    pub missing: Vec<(String, String)>,
    /// The findings of the bake.
    pub findings: Vec<FindingExtras>,
    /// The furniture, in the order of the file.
    pub objects: Vec<ObjectEntry>,
}

/// A piece of furniture where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectEntry {
    /// Unique in the room.
    pub id: ObjectId,
    /// Class id.
    pub class: String,
    /// Id of the object or part that it stands on or belongs to.
    pub parent: ElementId,
    /// Middle of its underside: x east, y north, z above the floor.
    pub position: DVec3,
    /// How it is turned, in the same frame.
    pub rotation: DQuat,
    /// Width, depth, height as it is scaled.
    pub size: [f64; 3],
    /// Variant.
    pub variant: u32,
    /// Names of the materials of its mesh, sorted.
    pub materials: Vec<String>,
}

/// A door, window or passage.
#[derive(Clone, Debug, PartialEq)]
pub struct OpeningEntry {
    /// A door or a window.
    pub id: ElementId,
    /// How it is closed.
    pub closure: String,
    /// Rooms that it joins.
    pub rooms: Vec<String>,
    /// Middle of its threshold or sill.
    pub position: DVec3,
    /// Width, height.
    pub size: [f64; 2],
    /// Tips of its open leaves.
    pub leaves: Vec<[f64; 2]>,
}

/// Reads everything that nodes say; what cannot be read is a problem and a broken room.
pub(super) fn read(
    document: &Root,
    nodes: &[Node],
    problems: &mut Vec<Problem>,
) -> Result<Inventory, Problem> {
    let level = super::level::level_extras(nodes)?;
    let seed = level.seed.map_or_else(String::new, |seed| seed.to_string());
    let settings = [("generator", level.generator.into_owned()), ("seed", seed)];
    let mut inventory = Inventory {
        building: level.building,
        level: level.level,
        elevation: level.elevation,
        height: level.height,
        site: level.site,
        settings: settings.into_iter().collect(),
        ..Inventory::default()
    };
    let room_ids = room_ids(nodes);
    for (index, node) in nodes.iter().enumerate() {
        match &node.extras {
            Some(Extras::Room(extras)) if room_ids[index] == Some(&extras.room) => {
                inventory.rooms.insert(extras.room.clone(), room(extras));
            }
            Some(Extras::Room(extras)) => {
                problems.push(Problem::new(&node.name, format!("is a second room \"{}\"", extras.room)));
                inventory.broken_rooms.insert(extras.room.clone());
            }
            Some(Extras::Opening(extras)) => inventory.openings.push(opening(extras, node)),
            _ => {}
        }
    }
    add_contents(&mut inventory, document, nodes, &room_ids, problems);
    inventory.looks = Looks::read(document, nodes);
    let Inventory { rooms, broken_rooms, .. } = &mut inventory;
    rooms.retain(|id, _| !broken_rooms.contains(id));
    Ok(inventory)
}

/// The id of the room that each node is; the first of equal ids counts.
fn room_ids<'n>(nodes: &'n [Node]) -> Vec<Option<&'n String>> {
    let mut known = BTreeSet::new();
    let first_of_id = |node: &'n Node| match &node.extras {
        Some(Extras::Room(extras)) if known.insert(&extras.room) => Some(&extras.room),
        _ => None,
    };
    nodes.iter().map(first_of_id).collect()
}

fn room(extras: &RoomExtras) -> RoomContents {
    let missing = extras.removed.iter().map(|removed| (removed.class.clone(), removed.reason.to_string()));
    RoomContents {
        room_type: extras.room_type.clone(),
        style: extras.style.clone(),
        seed: extras.seed,
        rings: std::iter::once(&extras.outline).chain(&extras.holes).cloned().collect(),
        height: extras.height,
        missing: missing.collect(),
        findings: extras.findings.clone(),
        objects: Vec::new(),
    }
}

fn opening(extras: &OpeningExtras, node: &Node) -> OpeningEntry {
    let place = plan_point(node.local.w_axis.truncate());
    OpeningEntry {
        id: extras.element(),
        closure: extras.closure.name().to_owned(),
        rooms: extras.sides.iter().map(|side| side.room.clone()).collect(),
        position: DVec3::new(place.x, place.y, extras.sill),
        size: [extras.width, extras.height],
        leaves: extras.leaves.iter().map(|leaf| leaf.open).collect(),
    }
}

/// Adds furniture and columns, and names the rooms in which something cannot be read.
fn add_contents(
    inventory: &mut Inventory,
    document: &Root,
    nodes: &[Node],
    room_ids: &[Option<&String>],
    problems: &mut Vec<Problem>,
) {
    let spots = spots(nodes, |node| room_ids[node].map(|_| node));
    let family = Family::new(nodes, &spots);
    for (index, (node, spot)) in nodes.iter().zip(&spots).enumerate() {
        let Some(spot) = spot else { continue };
        let Some(id) = room_ids[spot.room] else { continue };
        let Some(room) = inventory.rooms.get_mut(id) else { continue };
        match &node.extras {
            Some(Extras::Furniture(extras)) => {
                let above = family.parent_of(index).and_then(|above| match &nodes[above].extras {
                    Some(Extras::Furniture(above)) => Some(ElementId::Object(above.id.clone())),
                    _ => None,
                });
                let materials = material_names(document, node.mesh);
                match object(extras, spot, above, materials) {
                    Some(object) => room.objects.push(object),
                    None => {
                        problems.push(Problem::new(&node.name, "stands nowhere: its transform is no number"));
                        inventory.broken_rooms.insert(id.clone());
                    }
                }
            }
            Some(Extras::Part(part)) => room.rings.extend(part.outline.clone()),
            None if node.is_broken => {
                inventory.broken_rooms.insert(id.clone());
            }
            _ => {}
        }
    }
    for (node, spot) in nodes.iter().zip(&spots) {
        // A room whose own extras cannot be read is known by the name of its node.
        if let (true, None, Some(id)) = (node.is_broken, spot, room_in_name(&node.name)) {
            inventory.broken_rooms.insert(id.to_owned());
        }
    }
}

fn object(
    extras: &FurnitureExtras,
    spot: &Spot,
    above: Option<ElementId>,
    materials: Vec<String>,
) -> Option<ObjectEntry> {
    if !spot.place.is_finite() {
        return None;
    }
    let (scale, rotation, position) = spot.place.to_scale_rotation_translation();
    let [width, depth, height] = extras.size;
    Some(ObjectEntry {
        id: extras.id.clone(),
        class: extras.class.clone(),
        parent: above.unwrap_or_else(|| extras.parent.clone()),
        position: plan_point(position),
        rotation: plan_rotation(rotation).filter(|rotation| rotation.is_finite())?,
        size: [width * scale.x.abs(), depth * scale.z.abs(), height * scale.y.abs()],
        variant: extras.variant,
        materials,
    })
}
