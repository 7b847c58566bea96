//! What a number in a file names.

use crate::contract::{Extras, OpeningExtras, Part, PartExtras, PartId, RoomExtras};

/// A piece of furniture, an opening or a part of a room: what a click names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Feature {
    /// Building id.
    pub(super) building: String,
    /// Level id.
    pub(super) level: String,
    /// Room id; of an opening the ids of the rooms that it joins, with a space between.
    pub(super) room: String,
    /// Room type; empty for openings.
    pub(super) room_type: String,
    /// Class id; for the shell the kind of part or of opening.
    pub(super) class: String,
    /// Unique in the room; of an opening unique in the level.
    pub(super) id: String,
}

/// The facts that nodes have from the nodes above them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Above<'s> {
    building: &'s str,
    level: &'s str,
    room: Option<&'s RoomExtras>,
    opening: Option<&'s OpeningExtras>,
}

impl<'s> Above<'s> {
    /// The facts for what is below a node.
    pub(super) fn below(self, extras: Option<&'s Extras>) -> Self {
        match extras {
            Some(Extras::Level(level)) => {
                Self { building: &level.building, level: &level.level, ..Self::default() }
            }
            Some(Extras::Room(room)) => Self { room: Some(room), opening: None, ..self },
            Some(Extras::Opening(opening)) => Self { room: None, opening: Some(opening), ..self },
            _ => self,
        }
    }

    /// The feature that a node begins; `None` where it belongs to that of a node above it.
    pub(super) fn feature(self, extras: Option<&Extras>) -> Option<Feature> {
        match extras? {
            Extras::Opening(opening) => Some(Feature {
                room: opening.rooms.join(" "),
                class: opening.closure.name().to_owned(),
                id: opening.element().to_string(),
                ..self.bare()
            }),
            Extras::Furniture(furniture) => {
                Some(Feature { class: furniture.class.clone(), id: furniture.id.to_string(), ..self.bare() })
            }
            // The parts of an opening are the opening.
            Extras::Part(part) if self.opening.is_none() => Some(self.of_part(part)),
            _ => None,
        }
    }

    fn of_part(self, part: &PartExtras) -> Feature {
        // As scenes with few meshes have them: a wall has one name in all details of a level.
        let part = match part.part {
            Part::Wall | Part::Skirting | Part::Column | Part::Socket | Part::Switch => {
                &PartExtras::of(PartId::only(Part::Walls))
            }
            _ => part,
        };
        Feature { class: part.part.name().to_owned(), id: part.id.to_string(), ..self.bare() }
    }

    fn bare(self) -> Feature {
        Feature {
            building: self.building.to_owned(),
            level: self.level.to_owned(),
            room: self.room.map(|room| room.room.clone()).unwrap_or_default(),
            room_type: self.room.map(|room| room.room_type.clone()).unwrap_or_default(),
            class: String::new(),
            id: String::new(),
        }
    }
}
