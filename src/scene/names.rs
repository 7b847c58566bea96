//! Names of nodes, unique in a level and stable between bakes.
//!
//! One rule: `<id>@<owner>` for everything that belongs to a room or an opening, where the owner is the
//! room's id or the opening's node name; `<kind>:<id>` for rooms and openings themselves.
//!
//! ```text
//! tower/2                      the level
//! |- door:d1                   every walkable opening; window:w1
//! |  '- leaf@door:d1
//! '- room:201
//!    |- wall.0@201
//!    '- desk.1@201
//!       '- lamp.1@201
//! ```

use std::fmt::Display;

use crate::catalog::Catalog;
use crate::layout::{Parent, Placement};
use crate::plan::{Level, Opening};

/// Name of a level's root.
pub(crate) fn level(building: &str, level: &str) -> String {
    format!("{building}/{level}")
}

/// Name of a room's node.
pub(crate) fn room(id: &str) -> String {
    format!("room:{id}")
}

/// Name of an opening's node, also its id as a parent.
pub(crate) fn opening(opening: &Opening) -> String {
    let kind = if opening.kind.is_walkable() { "door" } else { "window" };
    format!("{kind}:{}", opening.id)
}

/// Name of what belongs to a room (by id) or an opening (by node name).
pub(crate) fn owned(id: &str, owner: &str) -> String {
    let mut name = String::with_capacity(id.len() + 1 + owner.len());
    name.push_str(id);
    name.push('@');
    name.push_str(owner);
    name
}

/// A numbered id: `wall.0`, `desk.1`.
pub(crate) fn numbered(kind: &str, number: impl Display) -> String {
    format!("{kind}.{number}")
}

/// Id of an object in its room.
pub(crate) fn object(catalog: &Catalog, placement: &Placement) -> String {
    numbered(&catalog.classes[placement.class].id, placement.number)
}

/// Id of an object's parent: an object, a part of the room, or an opening.
pub(crate) fn parent(parent: Parent, level_: &Level, catalog: &Catalog, placements: &[Placement]) -> String {
    match parent {
        Parent::Floor => "floor".to_owned(),
        Parent::Ceiling => "ceiling".to_owned(),
        Parent::Wall(index) => numbered("wall", index),
        Parent::Opening(index) => opening(&level_.openings[index]),
        Parent::Column(index) => numbered("column", index),
        Parent::Object(index) => object(catalog, &placements[index]),
    }
}
