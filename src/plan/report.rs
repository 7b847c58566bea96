//! The report on an imported plan: what was read, attached to rooms, and left out.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use super::{Level, LevelDraft, OpeningKind, Problem};

/// The report on one file or folder.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct InputReport {
    /// The file or folder.
    pub path: PathBuf,
    /// The word of its format.
    pub format: &'static str,
    /// Its buildings.
    pub buildings: Vec<BuildingReport>,
}

/// The report on a building.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct BuildingReport {
    /// Id of the building.
    pub id: String,
    /// Its levels, also those that were left out.
    pub levels: Vec<LevelReport>,
}

/// The report on a level.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LevelReport {
    /// Id of the level.
    pub id: String,
    /// Rooms that the input draws, and those that were read.
    pub rooms: Share,
    /// How many rooms of each type were read.
    pub room_types: BTreeMap<String, usize>,
    /// Rooms whose words no table knows and whose types were guessed.
    pub guessed: usize,
    /// Openings that the input draws, and those that lie in a wall. A window along several walls counts once.
    pub openings: Share,
    /// Openings between two rooms.
    pub between_rooms: usize,
    /// Openings of one room, to the open air or to what is not drawn.
    pub to_outside: usize,
    /// Stretches without a wall between two rooms, which were found by geometry.
    pub open_boundaries: usize,
    /// Columns that the input draws.
    pub columns: usize,
    /// Parts that were left out or mended, in words.
    pub notes: Vec<String>,
}

/// So many of so many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Share {
    /// Those of the input.
    pub drawn: usize,
    /// Those that were read.
    pub read: usize,
}

impl LevelReport {
    /// A level before it is put together.
    pub(super) fn of_draft(draft: &LevelDraft) -> Self {
        Self {
            id: draft.id.clone(),
            rooms: Share { drawn: draft.rooms.len(), read: 0 },
            openings: Share { drawn: draft.openings.len(), read: 0 },
            columns: draft.obstacles.len(),
            ..Self::default()
        }
    }

    /// Adds what came of it; `drawn` are the ids of its drafted openings.
    pub(super) fn complete(&mut self, level: &Level, problems: &[Problem], drawn: &BTreeSet<String>) {
        self.rooms.read = level.rooms.len();
        for room in &level.rooms {
            *self.room_types.entry(room.room_type.clone()).or_default() += 1;
        }
        let (read, found): (Vec<_>, Vec<_>) =
            level.openings.iter().partition(|opening| drawn.contains(&opening.id));
        self.open_boundaries = found.iter().filter(|found| found.kind == OpeningKind::OpenBoundary).count();
        self.openings.read = read.len();
        self.between_rooms = read.iter().filter(|opening| opening.sides.len() == 2).count();
        self.to_outside = read.len() - self.between_rooms;
        self.notes = problems.iter().map(|problem| problem.message.clone()).collect();
    }
}
