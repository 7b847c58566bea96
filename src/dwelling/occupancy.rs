//! The people of a building, and its levels with the roles of their rooms.

use std::borrow::Cow;
use std::fmt::Write;
use std::sync::Arc;

use crate::catalog::{Catalog, Households};
use crate::plan::{Building, Home, Level, PlacedBuilding, Plan};

use super::claims::settle;
use super::draw::shared_draw;
use super::groups::dwellings;
use super::rooms::chambers;

/// Who lives in a building: by level, then by room.
#[derive(Clone, Debug, Default)]
pub struct Occupancy {
    levels: Vec<LevelHomes>,
}

/// Who lives on a level, by room; empty where nobody does.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LevelHomes(Vec<Option<RoomHome>>);

/// The household of a room and what it makes of it.
#[derive(Clone, Debug, PartialEq)]
struct RoomHome {
    household: String,
    persons: u32,
    bedrooms: u32,
    role: Option<String>,
}

impl Occupancy {
    /// Draws a household for each dwelling of a building and shares out the rooms.
    #[must_use]
    pub fn new(building: &Building, id: &str, households: &Households, seed: u64) -> Self {
        let mut levels: Vec<LevelHomes> = building.levels.iter().map(|_| LevelHomes::default()).collect();
        for dwelling in dwellings(building, &households.homes) {
            let names = ["household of", id].into_iter().chain(dwelling.name.iter().map(String::as_str));
            let names: Vec<&str> = names.collect();
            let draw = |purpose: &str| shared_draw(seed, names.iter().copied().chain([purpose]));
            let chambers = chambers(building, &dwelling, households);
            let Some(settled) = settle(&chambers, households, &draw) else { continue };
            for (&(level, room), role) in dwelling.rooms.iter().zip(settled.roles) {
                let (household, persons, bedrooms) =
                    (settled.household.clone(), settled.persons, settled.bedrooms);
                let homes = &mut levels[level].0;
                homes.resize(building.levels[level].rooms.len(), None);
                homes[room] = Some(RoomHome { household, persons, bedrooms, role });
            }
        }
        Self { levels }
    }

    /// Who lives on the level of an index.
    #[must_use]
    pub fn level(&self, index: usize) -> &LevelHomes {
        &self.levels[index]
    }

    /// The building with the roles of its rooms; the same one where nobody lives there.
    #[must_use]
    pub fn apply(&self, building: &Arc<Building>) -> Arc<Building> {
        if self.levels.iter().all(|level| level.0.is_empty()) {
            return Arc::clone(building);
        }
        let levels = building.levels.iter().zip(&self.levels);
        let levels = levels.map(|(level, homes)| homes.apply(level).into_owned()).collect();
        let Building { name, attribution, levels: _ } = building.as_ref();
        Arc::new(Building { name: name.clone(), attribution: attribution.clone(), levels })
    }
}

impl LevelHomes {
    /// The level with the roles of its rooms.
    #[must_use]
    pub fn apply<'a>(&self, level: &'a Level) -> Cow<'a, Level> {
        if self.0.is_empty() {
            return Cow::Borrowed(level);
        }
        let mut level = level.clone();
        for (room, home) in level.rooms.iter_mut().zip(&self.0) {
            let Some(RoomHome { household, persons, bedrooms, role }) = home.clone() else { continue };
            let planned_type = role.map(|role| std::mem::replace(&mut room.room_type, role));
            room.home = Some(Home { household, persons, bedrooms, planned_type });
        }
        Cow::Owned(level)
    }

    /// A text that differs where anything here does; empty where nobody lives there.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let mut text = String::new();
        for (room, home) in self.0.iter().enumerate() {
            if let Some(RoomHome { household, persons, bedrooms, role }) = home {
                let role = role.as_deref().unwrap_or_default();
                let _ = writeln!(text, "{room} {household} {persons} {bedrooms} {role}");
            }
        }
        text
    }
}

/// A plan with people in it: each building as it is furnished with a seed.
#[must_use]
pub fn occupied(plan: &Plan, catalog: &Catalog, seed: u64) -> Plan {
    let buildings = plan.buildings.iter().map(|placed| {
        let occupancy = Occupancy::new(&placed.building, &placed.id, &catalog.households, seed);
        PlacedBuilding { building: occupancy.apply(&placed.building), ..placed.clone() }
    });
    Plan { buildings: buildings.collect() }
}
