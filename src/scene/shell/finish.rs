//! The materials of the surfaces of a room.

use super::ticks::Ticks;
use crate::catalog::Catalog;
use crate::plan::Room;
use crate::scene::meshes::slot_named;

/// Material slots of a room's shell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoomFinish {
    /// Of the floor.
    pub floor: &'static str,
    /// Of walls and columns.
    pub wall: &'static str,
    /// Of the ceiling.
    pub ceiling: &'static str,
    /// Of the lower part of walls, and up to which height.
    pub dado: Option<(Ticks, &'static str)>,
    /// Metres of wall for each socket, if it has any.
    pub sockets: Option<f64>,
    /// Whether light switches are beside its doors.
    pub has_switches: bool,
}

impl RoomFinish {
    /// Where no room type says otherwise.
    pub(crate) const PLAIN: Self = Self {
        floor: "parquet",
        wall: "plaster",
        ceiling: "ceiling",
        dado: None,
        sockets: None,
        has_switches: false,
    };

    /// The finish of a room's type.
    pub(crate) fn of(catalog: &Catalog, room: &Room) -> Self {
        catalog.room_types.get(&room.room_type).map_or(Self::PLAIN, |kind| Self {
            floor: slot_named(&kind.finish.floor, Self::PLAIN.floor),
            wall: slot_named(&kind.finish.wall, Self::PLAIN.wall),
            ceiling: slot_named(&kind.finish.ceiling, Self::PLAIN.ceiling),
            dado: kind.finish.dado.as_ref().map(|dado| {
                (Ticks::of(dado.height.min(room.height)), slot_named(&dado.slot, Self::PLAIN.wall))
            }),
            sockets: kind.finish.sockets,
            has_switches: kind.finish.has_switches,
        })
    }
}
