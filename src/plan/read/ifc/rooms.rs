//! Turns spaces into drafted rooms.

use glam::DAffine3;

use super::boundary::bounded;
use super::footprint::{Footprint, footprints};
use super::model::{Entity, Model, Read};
use super::placement::Geometry;
use crate::plan::RoomDraft;
use crate::plan::read::foreign::{TypeOfWord, UniqueIds};

/// A space on its storey.
pub(super) struct Space {
    pub(super) id: u64,
    pub(super) rooms: Vec<RoomDraft>,
    /// Metres of its floor and of its highest point.
    pub(super) low: f64,
    pub(super) high: f64,
}

/// What becomes of a space.
pub(super) enum Outlined {
    Space(Space),
    /// It has no body and no boundaries with a shape; its walls may tell.
    Bodiless,
}

/// The rooms of a space: one, or several where its body has parts; without a body by its boundaries.
pub(super) fn space(
    geometry: &Geometry<'_>,
    frame: &DAffine3,
    space: &Entity,
    boundaries: &[u64],
    naming: &mut Naming<'_>,
) -> Read<Outlined> {
    let parts = geometry.bodies(space, frame).map(|bodies| footprints(&bodies));
    let trouble = match parts {
        Ok(parts) if !parts.is_empty() => return Ok(Outlined::Space(drafted(space, parts, naming))),
        Ok(_) => space.trouble("its body covers no floor"),
        Err(trouble) => trouble,
    };
    let is_bodiless = !geometry.has_body(space);
    match bounded(geometry, frame, space, boundaries) {
        Ok(Some(part)) => {
            naming.bounded.push(space.id);
            if is_bodiless {
                naming.by_boundaries.push(space.id);
            } else {
                let message = format!("{}: its outline is that of its boundaries", trouble.message);
                geometry.model.warn(trouble.id, message, "export the space with a body that can be read");
            }
            Ok(Outlined::Space(drafted(space, vec![part], naming)))
        }
        _ if !is_bodiless => Err(trouble),
        Ok(None) => Ok(Outlined::Bodiless),
        Err(unread) => {
            geometry.model.warn(unread.id, unread.message, "the walls around the space say its outline");
            Ok(Outlined::Bodiless)
        }
    }
}

/// A space as the rooms that its parts are, of which there is one at least.
pub(super) fn drafted(space: &Entity, parts: Vec<Footprint>, naming: &mut Naming<'_>) -> Space {
    let (low, high) = parts.first().map_or((0.0, 0.0), |part| (part.low, part.high));
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
    Space { id: space.id, rooms: rooms.collect(), low, high }
}

/// Ids of the rooms of a level and their types, and the spaces of the file whose outline is no body's.
pub(super) struct Naming<'a> {
    /// Ids of the level that is read.
    pub(super) taken: UniqueIds,
    /// Spaces whose outline is that of their boundaries, which some programs draw in the middle of walls.
    pub(super) bounded: Vec<u64>,
    /// Those of them without a body, and those with the outline of the walls around them.
    pub(super) by_boundaries: Vec<u64>,
    pub(super) by_walls: Vec<u64>,
    pub(super) room_type: &'a dyn Fn(&Entity) -> TypeOfWord,
}

impl<'a> Naming<'a> {
    pub(super) fn new(room_type: &'a dyn Fn(&Entity) -> TypeOfWord) -> Self {
        Self {
            taken: UniqueIds::default(),
            bounded: Vec::new(),
            by_boundaries: Vec::new(),
            by_walls: Vec::new(),
            room_type,
        }
    }

    /// One warning for each way in which spaces without a body were outlined, at the first of them.
    pub(super) fn warn(&self, model: &Model) {
        for (spaces, by) in
            [(&self.by_boundaries, "their boundaries"), (&self.by_walls, "the walls around them")]
        {
            if let [first, ..] = spaces[..] {
                let count =
                    if spaces.len() == 1 { "1 has".to_owned() } else { format!("{} have", spaces.len()) };
                let message = format!("spaces without a body: {count} the outline of {by}");
                model.warn(first, message, "export spaces with their bodies if a room looks wrong");
            }
        }
    }

    /// The number by which people know the room; where two have one, the global id.
    fn id(&mut self, space: &Entity) -> String {
        let global = space.text(0).map(str::to_owned).unwrap_or_default();
        let ids = [plain(space.text(2).unwrap_or_default()), plain(&global), format!("space_{}", space.id)];
        self.taken.first_free(ids).unwrap_or_default()
    }
}

/// A name without the signs that separate paths and options.
fn plain(name: &str) -> String {
    let sign = |letter: char| letter.is_alphanumeric() || matches!(letter, '-' | '_' | '.' | '$');
    let plain: String = name.chars().map(|letter| if sign(letter) { letter } else { '_' }).collect();
    plain.trim_matches(['_', '.']).to_owned()
}
