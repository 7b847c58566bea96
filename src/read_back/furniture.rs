//! Reads the furniture of the rooms at its present places.

use glam::{DMat4, DVec3};

use super::family::Family;
use super::level::{EmptyLevel, EmptyRoomNode};
use super::parents::parents_first;
use super::problem::Problem;
use super::tree::Node;
use crate::catalog::{Catalog, ClassIndex, Side, Size, StyleRef};
use crate::contract::{Extras, FurnitureExtras, RemovedExtras};
use crate::document::did_you_mean;
use crate::layout::{Furnished, Parent, Placement, Removal, RemovalReason};
use crate::scene::{plan_angle, plan_point};

/// Sine of the largest tilt of what counts as upright, and the largest change of size that is rounding.
const ROUNDING: f64 = 1e-4;
/// Pieces of the fullest room: a hall of 500 m² has a few hundred.
const MOST_PIECES: usize = 20_000;
/// Metres: sizes outside are no furniture.
const SIZES: std::ops::Range<f64> = 1e-6..1e4;

/// A piece before its parent is known by its place in the list.
pub(super) struct Piece<'f> {
    /// The index of its node.
    pub(super) node: usize,
    /// Its extras.
    pub(super) extras: &'f FurnitureExtras,
    /// Where it stands; its parent is still to be found.
    pub(super) placement: Placement,
}

/// The furniture of each room; `None` where something of it cannot be read.
pub(super) fn read(
    nodes: &[Node],
    empty: &EmptyLevel,
    catalog: &Catalog,
    problems: &mut Vec<Problem>,
) -> Vec<Option<Furnished>> {
    let mut pieces: Vec<Vec<Piece<'_>>> = Vec::new();
    pieces.resize_with(empty.level.rooms.len(), Vec::new);
    let mut is_broken = empty.is_broken.clone();
    let spots = spots(nodes, |node| empty.room_of(node));
    for (index, node) in nodes.iter().enumerate() {
        match (&node.extras, &spots[index]) {
            (Some(Extras::Furniture(extras)), &Some(Spot { room, place, .. })) => {
                match read_piece(&node.name, extras, &place, catalog) {
                    Ok(placement) => pieces[room].push(Piece { node: index, extras, placement }),
                    Err(problem) => {
                        problems.push(problem);
                        is_broken[room] = true;
                    }
                }
            }
            // Of a room that cannot be read, one fault says so.
            (Some(Extras::Furniture(_)), None) if !is_below_bad_room(nodes, node) => {
                let problem = Problem::new(&node.name, "belongs to no room");
                problems.push(problem.with_hint("hang it below its room's node").that_only_warns());
            }
            (None, &Some(Spot { room, .. })) if node.is_broken => is_broken[room] = true,
            _ => {}
        }
    }
    let family = Family::new(nodes, &spots);
    let rooms = pieces.into_iter().enumerate().map(|(room, pieces)| {
        // Objects on a piece that cannot be read would be reported as faults, too.
        if is_broken[room] {
            return None;
        }
        let furnished = furnish(nodes, &family, empty.room(room), pieces, catalog);
        furnished.map_err(|problem| problems.push(problem)).ok()
    });
    rooms.collect()
}

/// Where a node is.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    /// The room that it belongs to.
    pub(super) room: usize,
    /// Its place in the frame of the room.
    pub(super) place: DMat4,
    /// The nearest object that it hangs below.
    pub(super) above: Option<usize>,
}

/// The spot of each node that hangs below a room; `room_of` says which room a node is.
pub(super) fn spots(nodes: &[Node], room_of: impl Fn(usize) -> Option<usize>) -> Vec<Option<Spot>> {
    let mut spots: Vec<Option<Spot>> = Vec::with_capacity(nodes.len());
    for node in nodes {
        // Parents come before children.
        let spot = node.parent.and_then(|parent| match room_of(parent) {
            Some(room) => Some(Spot { room, place: node.local, above: None }),
            None => spots[parent].map(|spot| {
                let is_object = matches!(nodes[parent].extras, Some(Extras::Furniture(_)));
                Spot {
                    place: spot.place * node.local,
                    above: if is_object { Some(parent) } else { spot.above },
                    ..spot
                }
            }),
        });
        spots.push(spot);
    }
    spots
}

/// Whether a node that has no spot hangs below a room all the same.
fn is_below_bad_room(nodes: &[Node], node: &Node) -> bool {
    /// Deeper than people stack objects.
    const DEEPEST: usize = 64;
    let ancestors = std::iter::successors(node.parent, |&ancestor| nodes[ancestor].parent);
    let is_room = |node: &Node| node.is_broken || matches!(node.extras, Some(Extras::Room(_)));
    ancestors.take(DEEPEST).any(|ancestor| is_room(&nodes[ancestor]))
}

fn furnish(
    nodes: &[Node],
    family: &Family<'_>,
    at: EmptyRoomNode<'_>,
    pieces: Vec<Piece<'_>>,
    catalog: &Catalog,
) -> Result<Furnished, Problem> {
    let node = &nodes[at.node];
    let Some(Extras::Room(extras)) = &node.extras else {
        return Err(Problem::new(&node.name, "is no room"));
    };
    if pieces.len() > MOST_PIECES {
        return Err(Problem::new(&node.name, format!("holds more than {MOST_PIECES} pieces")));
    }
    let removals = extras.removed.iter().map(|removed| removal(removed, &node.name, catalog));
    Ok(Furnished {
        room: at.room.index,
        seed: extras.seed,
        style: style(&extras.style, &node.name, catalog)?,
        requested: extras.requested,
        removals: removals.collect::<Result<Vec<_>, _>>()?,
        placements: parents_first(nodes, at, family, pieces)?,
    })
}

fn removal(removed: &RemovedExtras, node: &str, catalog: &Catalog) -> Result<Removal, Problem> {
    let reason = RemovalReason::ALL.into_iter().find(|reason| reason.name() == removed.reason);
    let reason =
        reason.ok_or_else(|| Problem::new(node, format!("has an unknown reason \"{}\"", removed.reason)))?;
    Ok(Removal { class: class(&removed.class, node, catalog)?, reason, is_required: removed.required })
}

fn class(id: &str, node: &str, catalog: &Catalog) -> Result<ClassIndex, Problem> {
    catalog.class_index(id).ok_or_else(|| {
        let known = catalog.classes.iter().map(|class| class.id.as_str());
        let hint = did_you_mean(id, known).unwrap_or_else(|| {
            "name the folder that has it with --catalog; its room is not judged".to_owned()
        });
        Problem::new(node, format!("is of an unknown class \"{id}\"")).with_hint(hint)
    })
}

fn style(id: &str, node: &str, catalog: &Catalog) -> Result<StyleRef, Problem> {
    catalog.styles.find(id).ok_or_else(|| {
        let hint = did_you_mean(id, catalog.styles.ids()).unwrap_or_else(|| {
            "name the folder that has it with --catalog; its room is not judged".to_owned()
        });
        Problem::new(node, format!("is of an unknown style \"{id}\"")).with_hint(hint)
    })
}

fn read_piece(
    name: &str,
    extras: &FurnitureExtras,
    place: &DMat4,
    catalog: &Catalog,
) -> Result<Placement, Problem> {
    let problem = |message: String| Problem::new(name, message);
    let class = class(&extras.class, name, catalog)?;
    let side = Side::ALL.into_iter().find(|side| side.name() == extras.side);
    let side = side.ok_or_else(|| problem(format!("touches an unknown side \"{}\"", extras.side)))?;
    let (position, angle, scale) = pose(place).ok_or_else(|| {
        let hint = "furniture is moved, turned about the vertical and scaled";
        problem("does not stand upright, or nowhere".to_owned()).with_hint(hint)
    })?;
    let [width, depth, height] = extras.size;
    let size = [width * scale.x, depth * scale.z, height * scale.y];
    if !size.iter().all(|length| SIZES.contains(length)) {
        return Err(problem(format!("has the size {size:?}, in metres")));
    }
    Ok(Placement {
        class,
        number: extras.id.number,
        // Until all pieces are known.
        parent: Parent::Floor,
        side,
        position: position.truncate(),
        elevation: position.z,
        angle,
        variant: extras.variant,
        size: Size { width: size[0], depth: size[1], height: size[2] },
    })
}

/// Position and angle in the plan's axes, and scale (width, height, depth), in the room; `None` unless upright and finite.
pub(super) fn pose(place: &DMat4) -> Option<(DVec3, f64, DVec3)> {
    let (across, up, forth) = (place.x_axis.truncate(), place.y_axis.truncate(), place.z_axis.truncate());
    let position = place.w_axis.truncate();
    let scale = DVec3::new(across.length(), up.length(), forth.length());
    if !place.is_finite() || scale.min_element() <= 0.0 || position.abs().max_element() > 1e6 {
        return None;
    }
    let is_level = |axis: DVec3, length: f64| (axis.y / length).abs() < ROUNDING;
    let is_upright = up.y / scale.y > 1.0 - ROUNDING && is_level(across, scale.x) && is_level(forth, scale.z);
    let is_mirrored = across.cross(up).dot(forth) <= 0.0;
    let exact = |factor: f64| if (factor - 1.0).abs() < ROUNDING { 1.0 } else { factor };
    let scale = DVec3::new(exact(scale.x), exact(scale.y), exact(scale.z));
    (is_upright && !is_mirrored).then(|| (plan_point(position), plan_angle(across), scale))
}
