//! The materials of the surfaces of a room.

use super::ticks::Ticks;
use crate::catalog::Catalog;
use crate::plan::Room;
use crate::recipes::Slot;

/// Material slots of a room's shell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoomFinish {
    /// Of the floor.
    pub floor: Slot,
    /// Of walls and columns.
    pub wall: Slot,
    /// Of the ceiling.
    pub ceiling: Slot,
    /// Of the lower part of walls, and up to which height.
    pub dado: Option<(Ticks, Slot)>,
    /// Metres of wall for each socket, if it has any.
    pub sockets: Option<f64>,
    /// Whether light switches are beside its doors.
    pub has_switches: bool,
}

impl RoomFinish {
    /// Where no room type says otherwise.
    pub(crate) const PLAIN: Self = Self {
        floor: Slot::Parquet,
        wall: Slot::Plaster,
        ceiling: Slot::Ceiling,
        dado: None,
        sockets: None,
        has_switches: false,
    };

    /// The finish of a room's type.
    pub(crate) fn of(catalog: &Catalog, room: &Room) -> Self {
        catalog.room_types.get(&room.room_type).map_or(Self::PLAIN, |kind| Self {
            floor: kind.finish.floor,
            wall: kind.finish.wall,
            ceiling: kind.finish.ceiling,
            dado: kind.finish.dado.as_ref().map(|dado| (Ticks::of(dado.height.min(room.height)), dado.slot)),
            sockets: kind.finish.sockets,
            has_switches: kind.finish.has_switches,
        })
    }
}
