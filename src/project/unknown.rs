//! What somebody asks for and the project does not have.

use std::fmt;

use crate::catalog::Catalog;
use crate::contract::RoomId;
use crate::document::did_you_mean;
use crate::plan::Plan;

/// A room that the plan does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownRoom {
    /// What was asked for.
    pub id: RoomId,
    /// What the plan has instead, where the ids go apart.
    pub hint: String,
}

impl UnknownRoom {
    pub(crate) fn in_plan(id: &RoomId, plan: &Plan) -> Self {
        let building = plan.buildings.iter().find(|placed| placed.id == id.building);
        let level =
            building.and_then(|placed| placed.building.levels.iter().find(|level| level.id == id.level));
        let hint = match (building, level) {
            (None, _) => hint(
                "buildings of the plan",
                &id.building,
                plan.buildings.iter().map(|placed| placed.id.as_str()),
            ),
            (Some(placed), None) => {
                let ids = placed.building.levels.iter().map(|level| level.id.as_str());
                hint("levels of the building", &id.level, ids)
            }
            (_, Some(level)) => {
                hint("rooms of the level", &id.room, level.rooms.iter().map(|room| room.id.as_str()))
            }
        };
        Self { id: id.clone(), hint }
    }
}

impl fmt::Display for UnknownRoom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the plan has no room {}; {}", self.id, self.hint)
    }
}

impl std::error::Error for UnknownRoom {}

/// A style that the catalogue does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownStyle {
    /// What was asked for.
    pub style: String,
    /// The nearest one, or where all are listed.
    pub hint: String,
}

impl UnknownStyle {
    pub(super) fn in_catalog(style: &str, catalog: &Catalog) -> Self {
        let hint = did_you_mean(style, catalog.style_ids());
        let hint = hint.unwrap_or_else(|| "see `roomwright catalog styles`".to_owned());
        Self { style: style.to_owned(), hint }
    }

    /// What is wrong, without the hint.
    #[must_use]
    pub fn fact(&self) -> String {
        format!("unknown style \"{}\"", self.style)
    }
}

impl fmt::Display for UnknownStyle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; {}", self.fact(), self.hint)
    }
}

impl std::error::Error for UnknownStyle {}

/// The id that was probably meant, else those that there are; where they are many, how many.
fn hint<'i>(whose: &str, unknown: &str, known: impl ExactSizeIterator<Item = &'i str> + Clone) -> String {
    let count = known.len();
    did_you_mean(unknown, known).unwrap_or_else(|| format!("it is none of the {count} {whose}"))
}
