//! Floors, walls with their openings, and what stands in them.
//!
//! Each part is described by a [`Shape`] in whole ticks in its own node's frame, then built; rooms that are
//! equal but for their place share meshes.

mod corner;
mod frame;
mod opening;
mod railing;
mod room;
mod skirting;
mod slab;
mod solid;
mod ticks;
mod wall;

pub(crate) use opening::opening_node;
pub(crate) use room::{RoomFinish, room_parts};

use frame::{LeafShape, Reveal};
use railing::RailingShape;
use skirting::SkirtingShape;
use slab::SlabShape;
use solid::Solid;
use ticks::Ticks;
use wall::WallShape;

use crate::model::Model;

/// Thickness of floors, downward from zero, and of ceilings, upward from the room's height. Walls reach as
/// far up as the ceiling's top, so that no light passes the edge between them.
const SLAB: Ticks = Ticks(2_000);

/// How much less than floors and ceilings walls and thresholds reach past the room, so that their ends lie inside the
/// slabs of overlapping rooms and not in one plane with them.
const INSET: Ticks = Ticks(100);

/// Slots of frames, door leaves, handles, glass and sills.
const FRAME_SLOT: &str = "painted";
const LEAF_SLOT: &str = "wood_light";
const HANDLE_SLOT: &str = "metal";
const GLASS_SLOT: &str = "glass";
const SKIRTING_SLOT: &str = "painted";
const RAILING_SLOT: &str = "metal_dark";
/// Slot of walls seen from the open air, whatever the room behind them is lined with.
const FACADE_SLOT: &str = "plaster";

/// A part of the shell, complete: equal shapes are equal meshes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Shape {
    /// A floor, ceiling or column.
    Slab(SlabShape),
    /// A wall or parapet.
    Wall(WallShape),
    /// A railing.
    Railing(RailingShape),
    /// The skirting boards of a room.
    Skirting(SkirtingShape),
    /// The floor of a doorway, with its slot.
    Threshold(Reveal, &'static str),
    /// Jambs and head.
    DoorFrame(Reveal),
    /// Bars of a window.
    WindowFrame(Reveal),
    /// Panes of a window.
    WindowGlass(Reveal),
    /// Board of a window.
    SillBoard(Reveal),
    /// A leaf on hinges.
    Leaf(LeafShape),
    /// One of two sliding panels; `true` for the second.
    SlidingPanel(Reveal, bool),
}

impl Shape {
    /// The mesh; without primitives if the shape has no extent.
    pub(crate) fn build(&self) -> Model {
        let solids: Vec<Solid> = match self {
            Self::Slab(slab) => vec![slab.build()],
            Self::Wall(wall) => wall.build().into(),
            Self::Railing(railing) => vec![railing.build(-SLAB)],
            Self::Skirting(skirting) => vec![skirting.build()],
            Self::Threshold(reveal, slot) => vec![reveal.threshold(-SLAB, slot)],
            Self::DoorFrame(reveal) => vec![reveal.door_frame(FRAME_SLOT)],
            Self::WindowFrame(reveal) => vec![reveal.window_frame(FRAME_SLOT)],
            Self::WindowGlass(reveal) => vec![reveal.window_glass(GLASS_SLOT)],
            Self::SillBoard(reveal) => vec![reveal.sill_board(FRAME_SLOT)],
            Self::Leaf(leaf) => leaf.build([LEAF_SLOT, HANDLE_SLOT]).into(),
            Self::SlidingPanel(reveal, second) => {
                reveal.sliding_panel(*second, [FRAME_SLOT, GLASS_SLOT]).into()
            }
        };
        let filled = solids.into_iter().filter(|solid| !solid.is_empty());
        Model { primitives: filled.map(Solid::finish).collect() }
    }
}
