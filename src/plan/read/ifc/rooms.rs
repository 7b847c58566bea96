//! Turns spaces into drafted rooms.

use std::collections::BTreeSet;

use glam::DAffine3;

use super::footprint::{Footprint, footprints};
use super::model::{Entity, Read};
use super::placement::Geometry;
use crate::plan::RoomDraft;
use crate::plan::read::foreign::TypeOfWord;

/// A space on its storey.
pub(super) struct Space {
    pub(super) id: u64,
    pub(super) rooms: Vec<RoomDraft>,
    /// Metres of its floor and of its highest point.
    pub(super) low: f64,
    pub(super) high: f64,
}

/// The rooms of a space: one, or several where its body has parts.
pub(super) fn space(
    geometry: &Geometry<'_>,
    frame: &DAffine3,
    space: &Entity,
    naming: &mut Naming<'_>,
) -> Read<Space> {
    let parts = footprints(&geometry.bodies(space, frame)?);
    let Some(Footprint { low, high, .. }) = parts.first().cloned() else {
        return Err(space.trouble("its body covers no floor"));
    };
    let id = naming.id(space);
    let TypeOfWord { room_type, unknown_word } = (naming.room_type)(space);
    let name = space.text(7).or(space.text(2)).map(str::to_owned);
    let rooms = parts.into_iter().enumerate().map(|(part, footprint)| RoomDraft {
        id: if part == 0 { id.clone() } else { format!("{id}.{}", part + 1) },
        name: name.clone(),
        room_type: room_type.clone(),
        unknown_word: unknown_word.clone(),
        outline: footprint.outer,
        holes: footprint.holes,
        // A bare outline says nothing about its height.
        height: Some(high - low).filter(|height| *height > 0.0),
        ..RoomDraft::default()
    });
    Ok(Space { id: space.id, rooms: rooms.collect(), low, high })
}

/// Ids of the rooms of a level, and their types.
pub(super) struct Naming<'a> {
    pub(super) taken: BTreeSet<String>,
    pub(super) room_type: &'a dyn Fn(&Entity) -> TypeOfWord,
}

impl Naming<'_> {
    /// The number by which people know the room; where two have one, the global id.
    fn id(&mut self, space: &Entity) -> String {
        let global = space.text(0).map(str::to_owned).unwrap_or_default();
        let ids = [plain(space.text(2).unwrap_or_default()), plain(&global), format!("space_{}", space.id)];
        let free = ids.into_iter().find(|id| !id.is_empty() && self.taken.insert(id.clone()));
        free.unwrap_or_default()
    }
}

/// A name without the signs that separate paths and options.
fn plain(name: &str) -> String {
    let sign = |letter: char| letter.is_alphanumeric() || matches!(letter, '-' | '_' | '.' | '$');
    let plain: String = name.chars().map(|letter| if sign(letter) { letter } else { '_' }).collect();
    plain.trim_matches(['_', '.']).to_owned()
}
