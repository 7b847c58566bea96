//! A room that was furnished on demand.

use std::slice::from_ref;
use std::sync::Arc;

use crate::audit::{Finding, Verdict};
use crate::contract::RoomId;
use crate::edits::{Finished, Misfit};
use crate::layout::{Furnished, Placement, Removal};
use crate::plan::{Level, PlacedBuilding, Room};
use crate::project::RoomView;

/// A furnished room, with the building around it. Lives as long as somebody holds it, whatever the world forgets.
#[derive(Clone, Debug)]
pub struct WorldRoom {
    /// Its ids.
    pub id: RoomId,
    /// Its furniture; says which room of the level it is.
    pub furnished: Furnished,
    /// The findings of the audit.
    pub verdict: Verdict,
    /// Edits that were rejected, and edited objects with findings.
    pub misfits: Vec<Misfit>,
    /// Counts the rooms that a world has made, from 1: another number is another room, or the same one made again.
    pub number: u64,
    /// The digest of the catalogue that its furniture is of.
    pub(crate) catalog: [u8; 32],
    building: Arc<PlacedBuilding>,
    level: usize,
}

impl WorldRoom {
    pub(super) fn new(
        building: Arc<PlacedBuilding>,
        level: usize,
        finished: Finished,
        catalog: [u8; 32],
    ) -> Self {
        let Finished { judged, misfits } = finished;
        let at = &building.building.levels[level];
        let id = RoomId::new(&building.id, &at.id, &at.rooms[judged.furnished.room].id);
        Self {
            id,
            furnished: judged.furnished,
            verdict: judged.verdict,
            misfits,
            number: 0,
            catalog,
            building,
            level,
        }
    }

    pub(super) fn numbered(self, number: u64) -> Self {
        Self { number, ..self }
    }

    /// Its building, with the people who live there.
    #[must_use]
    pub fn building(&self) -> &PlacedBuilding {
        &self.building
    }

    /// Its level.
    #[must_use]
    pub fn level(&self) -> &Level {
        &self.building.building.levels[self.level]
    }

    /// The room as the plan says it.
    #[must_use]
    pub fn room(&self) -> &Room {
        &self.level().rooms[self.furnished.room]
    }

    pub(crate) fn view(&self) -> RoomView<'_> {
        let Self { building, furnished, verdict, .. } = self;
        let (furnished, verdicts) = (from_ref(furnished), from_ref(verdict));
        RoomView { building, level: self.level(), furnished, verdicts }
    }

    /// Bytes of memory that it takes itself, without the plan: what a budget counts.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let Furnished { placements, removals, .. } = &self.furnished;
        let texts = [&self.id.building, &self.id.level, &self.id.room].into_iter().map(String::capacity);
        let findings = self.verdict.findings.iter().map(|finding| {
            let objects = finding.objects.iter().map(|object| size_of::<String>() + object.capacity());
            let elements = size_of_val(finding.elements.as_slice()) + size_of_val(finding.region.as_slice());
            size_of::<Finding>() + elements + objects.sum::<usize>()
        });
        let rates = self.verdict.walkable.iter().map(|rate| size_of_val(rate) + rate.door.capacity());
        size_of::<Self>()
            + placements.capacity() * size_of::<Placement>()
            + removals.capacity() * size_of::<Removal>()
            + texts.sum::<usize>()
            + findings.sum::<usize>()
            + rates.sum::<usize>()
            + size_of_val(self.misfits.as_slice())
    }
}
