//! Prepares locked objects for the layout.

use super::book::RoomEdits;
use super::tree::{ObjectPlace, usual_place, usual_side};
use crate::catalog::Catalog;
use crate::contract::{ElementId, ObjectId};
use crate::layout::{Lock, LockSupport, Parent};
use crate::plan::RoomRef;
use crate::read_back::room_part;

/// The objects of a room that are there before the others. Those that name a wall or object that is not there are
/// left out; they are reported when the edits are applied.
#[must_use]
pub(super) fn locks(at: RoomRef<'_>, edits: &RoomEdits, catalog: &Catalog) -> Vec<Lock> {
    let locked = edits.objects.iter().filter(|(_, edit)| edit.entry.lock);
    let lock = |id: &str, entry: &super::file::ObjectEntry| {
        let id: ObjectId = id.parse().ok()?;
        let class = catalog.class_index(&id.class)?;
        let size = catalog.classes[class].size(entry.variant.unwrap_or(0));
        let on = entry.parent.as_ref().map_or(Ok(ElementId::Floor), |on| on.parse()).ok()?;
        let part = room_part(&on, at);
        let support = match (part, on) {
            (Some(part), _) => LockSupport::Part(part),
            (None, ElementId::Object(on)) => LockSupport::Object(catalog.class_index(&on.class)?, on.number),
            _ => return None,
        };
        let usual = usual_place(part.unwrap_or(Parent::Floor), size, at.room);
        let ObjectPlace { position, elevation, angle } = usual.edited(entry);
        let says_height = part.is_some() || entry.at.as_ref().is_some_and(|at| at.len() == 3);
        Some(Lock {
            class,
            number: id.number,
            variant: entry.variant,
            on: support,
            side: entry.side.unwrap_or_else(|| part.map_or(crate::catalog::Side::Above, usual_side)),
            position,
            elevation: says_height.then_some(elevation),
            angle,
        })
    };
    locked.filter_map(|(id, edit)| lock(id, &edit.entry)).collect()
}
