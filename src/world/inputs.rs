//! What rooms are made from, and how one is made.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::graph::{Key, Place};
use super::room::WorldRoom;
use super::site::Site;
use crate::contract::RoomId;
use crate::output::LevelOptions;
use crate::plan::PlacedBuilding;
use crate::project::Project;

/// Buildings with people in them that are remembered.
const OCCUPIED: usize = 16;

/// A project with options.
pub(crate) struct Inputs {
    pub(crate) project: Arc<Project>,
    pub(crate) options: LevelOptions,
    /// Index of a building by its id.
    buildings: BTreeMap<String, usize>,
    /// Where the buildings stand.
    pub(crate) site: Site,
    /// The buildings with people in them that rooms were made of last, the latest at the end.
    occupied: Mutex<Vec<(usize, Arc<PlacedBuilding>)>>,
}

impl Inputs {
    pub(crate) fn new(project: Arc<Project>, options: LevelOptions) -> Self {
        let ids = project.plan.buildings.iter().enumerate();
        let buildings = ids.map(|(index, placed)| (placed.id.clone(), index)).collect();
        Self { project, options, buildings, site: Site::default(), occupied: Mutex::default() }
    }

    /// The index of a building.
    pub(crate) fn building(&self, id: &str) -> Option<usize> {
        self.buildings.get(id).copied()
    }

    /// A level by its ids: the indices of building and level.
    pub(crate) fn level(&self, building: &str, level: &str) -> Option<(usize, usize)> {
        let building = self.building(building)?;
        let levels = &self.project.plan.buildings[building].building.levels;
        Some((building, levels.iter().position(|other| other.id == level)?))
    }

    /// A room by its ids.
    pub(crate) fn key(&self, id: &RoomId) -> Option<Key> {
        let (building, level) = self.level(&id.building, &id.level)?;
        let rooms = &self.project.plan.buildings[building].building.levels[level].rooms;
        let room = rooms.iter().position(|room| room.id == id.room)?;
        Some(Key { building, place: Place { level, room } })
    }

    /// The ids of a room.
    pub(crate) fn id(&self, key: Key) -> RoomId {
        let placed = &self.project.plan.buildings[key.building];
        let level = &placed.building.levels[key.place.level];
        RoomId::new(&placed.id, &level.id, &level.rooms[key.place.room].id)
    }

    /// Furnishes a room.
    pub(crate) fn make(&self, key: Key) -> WorldRoom {
        let building = self.occupied(key.building);
        let level = &building.building.levels[key.place.level];
        let finished = self.project.furnish_room(&self.options, &building.id, level.room(key.place.room));
        WorldRoom::new(building, key.place.level, finished, self.project.catalog.digest)
    }

    /// Whether a room that was made from other inputs is the one that these make.
    pub(crate) fn makes_equal(&self, key: Key, room: &WorldRoom, before: &Self) -> bool {
        let building = self.occupied(key.building);
        let level = &building.building.levels[key.place.level];
        let edits = |inputs: &Self| {
            let edits = inputs.project.edits.level(&room.id.building, &room.id.level);
            edits.and_then(|edits| edits.room(&room.id.room)).map(|edits| edits.fingerprint())
        };
        // The digest leaves out who lives there.
        self.options == before.options
            && self.project.catalog.digest == room.catalog
            && level.digest == room.level().digest
            && level.rooms[key.place.room].home == room.room().home
            && level.rooms[key.place.room].room_type == room.room().room_type
            && edits(self) == edits(before)
    }

    /// A building with people in it.
    pub(crate) fn occupied(&self, building: usize) -> Arc<PlacedBuilding> {
        let lock = || self.occupied.lock().unwrap_or_else(PoisonError::into_inner);
        let found = |known: &mut Vec<(usize, Arc<PlacedBuilding>)>| {
            let index = known.iter().position(|(index, _)| *index == building)?;
            let found = known.remove(index);
            known.push(found.clone());
            Some(found.1)
        };
        if let Some(found) = found(&mut lock()) {
            return found;
        }
        // Two threads may come here at once: both make the same.
        let made = Arc::new(self.project.occupied(building, self.options.seed));
        let mut known = lock();
        if known.len() >= OCCUPIED {
            known.remove(0);
        }
        known.push((building, Arc::clone(&made)));
        made
    }
}
