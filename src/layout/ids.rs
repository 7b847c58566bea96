//! Ids of the output contract for placements, parents and openings.

use super::furnished::{Parent, Placement};
use crate::catalog::Catalog;
use crate::contract::{ElementId, ObjectId};
use crate::plan::{Level, Opening};

/// Id of an object in its room.
pub(crate) fn object_id(catalog: &Catalog, placement: &Placement) -> ObjectId {
    ObjectId::new(catalog.classes[placement.class].id.as_str(), placement.number)
}

/// Id of an opening in its level; also the name of its node.
pub(crate) fn opening_id(opening: &Opening) -> ElementId {
    ElementId::opening(&opening.id, !opening.kind.is_walkable())
}

/// Id of an object's parent: an object, a part of the room, or an opening.
pub(crate) fn parent_id(
    parent: Parent,
    level: &Level,
    catalog: &Catalog,
    placements: &[Placement],
) -> ElementId {
    match parent {
        Parent::Floor => ElementId::Floor,
        Parent::Ceiling => ElementId::Ceiling,
        Parent::Wall(index) => ElementId::Wall(index),
        Parent::Opening(index) => opening_id(&level.openings[index]),
        Parent::Column(index) => ElementId::Column(index),
        Parent::Object(index) => ElementId::Object(object_id(catalog, &placements[index])),
    }
}
