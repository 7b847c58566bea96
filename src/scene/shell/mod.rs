//! Builds floors, ceilings, walls with their openings, doors, windows and fittings.
//!
//! Each part is described by a [`Shape`] in whole ticks in the frame of its own node, then built. Rooms that are equal
//! apart from their place share meshes, also where parts are merged.

mod behind;
mod corner;
mod finish;
mod fitted;
mod fitting;
mod frame;
mod leaf;
mod merge;
mod opening;
mod opening_size;
mod railing;
mod room;
mod skirting;
mod slab;
mod slots;
mod solid;
mod stairs;
mod storey;
mod thickness;
mod ticks;
mod wall;
mod window;

pub(crate) use finish::RoomFinish;
pub(crate) use opening::{OpeningLook, opening_node};
pub(crate) use room::{Equipment, room_parts};
pub(crate) use storey::Storey;

use fitting::Fitting;
use frame::Reveal;
use leaf::LeafShape;
use railing::RailingShape;
use skirting::SkirtingShape;
use slab::SlabShape;
use slots::{FRAME_SLOT, GLASS_SLOT};
use solid::Solid;
use stairs::StairsShape;
use ticks::Ticks;
use wall::WallShape;

use crate::model::Model;
use crate::recipes::Slot;

/// Thickness of floors, downward from zero, and least thickness of ceilings, upward from the room's height.
const SLAB: Ticks = Ticks(2_000);

/// How much less than floors and ceilings walls and thresholds reach past the room, so that their ends lie inside the
/// slabs of overlapping rooms and not in one plane with them.
const INSET: Ticks = Ticks(100);

/// The numbers of the shapes of a merged mesh, each with the bits of its translation and rotation: equal ones are equal meshes.
pub(crate) type MergedKey = Vec<(usize, [u32; 7])>;

/// A part of the shell, complete: equal shapes are equal meshes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Shape {
    /// A floor, ceiling or column.
    Slab(SlabShape),
    /// A wall or parapet.
    Wall(WallShape),
    /// A railing.
    Railing(RailingShape),
    /// Steps up and balustrades around those from below.
    Stairs(StairsShape),
    /// The skirting boards of a room.
    Skirting(SkirtingShape),
    /// A socket or switch, with its plate's slot.
    Fitting(Fitting, Slot),
    /// The floor of a doorway, with its slot.
    Threshold(Reveal, Slot),
    /// Jambs and head, with boards of a width around them.
    DoorFrame(Reveal, Ticks),
    /// Bars of a window.
    WindowFrame(Reveal),
    /// Panes of a window.
    WindowGlass(Reveal),
    /// Sill of a window; `true` for one to the open air.
    Sill(Reveal, bool),
    /// A leaf on hinges.
    Leaf(LeafShape),
    /// One of two sliding panels; `true` for the second. Its stiles have the slot.
    SlidingPanel(Reveal, bool, Slot),
}

impl Shape {
    /// The mesh; without primitives if the shape has no extent.
    pub(crate) fn build(&self) -> Model {
        let solids: Vec<Solid> = match self {
            Self::Slab(slab) => vec![slab.build()],
            Self::Wall(wall) => wall.build().into(),
            Self::Railing(railing) => vec![railing.build(-SLAB)],
            Self::Stairs(stairs) => stairs.build(INSET - SLAB).into(),
            Self::Skirting(skirting) => vec![skirting.build()],
            Self::Fitting(fitting, slot) => fitting.build(*slot).into(),
            Self::Threshold(reveal, slot) => vec![reveal.threshold(-SLAB, *slot)],
            Self::DoorFrame(reveal, casing) => vec![reveal.door_frame(*casing, FRAME_SLOT)],
            Self::WindowFrame(reveal) => reveal.window_frame().into(),
            Self::WindowGlass(reveal) => vec![reveal.window_glass()],
            Self::Sill(reveal, is_exterior) => reveal.sills(*is_exterior).into(),
            Self::Leaf(leaf) => leaf.build().into(),
            Self::SlidingPanel(reveal, second, slot) => {
                reveal.sliding_panel(*second, [*slot, GLASS_SLOT]).into()
            }
        };
        let filled = solids.into_iter().filter(|solid| !solid.is_empty());
        Model { primitives: filled.map(Solid::finish).collect() }
    }
}
