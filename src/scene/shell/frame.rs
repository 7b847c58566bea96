//! The fixed parts of doorways: frames, thresholds, sliding panels.
//!
//! All shapes are in the frame of the opening's node: the origin on the floor in the middle of the opening, x along the
//! wall, +Z towards the first room.

use super::leaf::{JAMB, LEAF_GAP};
use super::solid::Solid;
use super::ticks::Ticks;
use crate::recipes::Slot;

/// The clear hole through all of the wall, in the frame of the opening's node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Reveal {
    /// Low end along x.
    pub left: Ticks,
    /// High end along x.
    pub right: Ticks,
    /// Lower edge.
    pub bottom: Ticks,
    /// Upper edge.
    pub top: Ticks,
    /// Low end along z: the far face of the wall.
    pub back: Ticks,
    /// High end along z: the face in the first room.
    pub front: Ticks,
}

/// How far a door frame stands out of the wall on each side, so that no two faces lie in one plane.
const PROJECTION: Ticks = Ticks(1_000);
/// How far the boards around a door frame stand out of the wall.
const CASING_DEPTH: Ticks = Ticks(1_400);
/// Width of the bars of a window frame and of the stiles of a sliding panel.
pub(super) const BAR: Ticks = Ticks(6_000);
/// Thickness of glass.
pub(super) const GLASS: Ticks = Ticks(1_000);
/// Depth of a sliding panel.
const PANEL: Ticks = Ticks(3_500);
/// Overlap of the two panels of a sliding door.
const PANEL_OVERLAP: Ticks = Ticks(3_000);

impl Reveal {
    fn width(&self) -> Ticks {
        self.right - self.left
    }

    pub(super) fn middle_depth(&self) -> Ticks {
        Ticks((self.back.0 + self.front.0) / 2)
    }

    /// A bar's width, less in openings too small for it.
    pub(super) fn fitted(&self, bar: Ticks) -> Ticks {
        const SMALLEST_SHARE: i32 = 6;
        let room = self.width().min(self.top - self.bottom);
        bar.min(Ticks(room.0 / SMALLEST_SHARE))
    }

    /// The floor through the wall.
    pub(crate) fn threshold(&self, bottom: Ticks, slot: Slot) -> Solid {
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, bottom, self.back], [self.right, Ticks(0), self.front]);
        solid
    }

    /// Two jambs and a head around a doorway, and boards of the width `casing` around it on both faces of the wall.
    pub(crate) fn door_frame(&self, casing: Ticks, slot: Slot) -> Solid {
        let bar = self.fitted(JAMB);
        let (back, front) = (self.back - PROJECTION, self.front + PROJECTION);
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, self.bottom, back], [self.left + bar, self.top, front]);
        solid.cuboid([self.right - bar, self.bottom, back], [self.right, self.top, front]);
        solid.cuboid([self.left + bar, self.top - bar, back], [self.right - bar, self.top, front]);
        let [left, right, top] = [self.left - casing, self.right + casing, self.top + casing];
        for (back, front) in [(self.front, self.front + CASING_DEPTH), (self.back - CASING_DEPTH, self.back)]
        {
            solid.cuboid([left, self.bottom, back], [self.left, top, front]);
            solid.cuboid([self.right, self.bottom, back], [right, top, front]);
            solid.cuboid([self.left, self.top, back], [self.right, top, front]);
        }
        solid
    }

    /// One of the two panels of a sliding door, stiles then glass; `second` is the one on the right, nearer
    /// to the first room.
    pub(crate) fn sliding_panel(&self, second: bool, slots: [Slot; 2]) -> [Solid; 2] {
        let bar = self.fitted(JAMB);
        let middle = Ticks((self.left.0 + self.right.0) / 2);
        let (left, right) = if second {
            (middle - PANEL_OVERLAP, self.right - bar)
        } else {
            (self.left + bar, middle + PANEL_OVERLAP)
        };
        let depth = self.middle_depth();
        let (back, front) = if second { (depth, depth + PANEL) } else { (depth - PANEL, depth) };
        let gap = if second { LEAF_GAP } else { Ticks(0) };
        let panel = Self {
            left,
            right,
            bottom: self.bottom + LEAF_GAP,
            top: self.top - bar - LEAF_GAP,
            back: back + gap,
            front: front + gap,
        };
        [panel.stiles(slots[0]), panel.pane(slots[1])]
    }

    fn stiles(&self, slot: Slot) -> Solid {
        let bar = self.fitted(BAR);
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, self.bottom, self.back], [self.left + bar, self.top, self.front]);
        solid.cuboid([self.right - bar, self.bottom, self.back], [self.right, self.top, self.front]);
        let (left, right) = (self.left + bar, self.right - bar);
        solid.cuboid([left, self.bottom, self.back], [right, self.bottom + bar, self.front]);
        solid.cuboid([left, self.top - bar, self.back], [right, self.top, self.front]);
        solid
    }

    fn pane(&self, slot: Slot) -> Solid {
        let bar = self.fitted(BAR);
        let half = Ticks(GLASS.0 / 2);
        let depth = self.middle_depth();
        let mut solid = Solid::new(slot);
        let low = [self.left + bar, self.bottom + bar, depth - half];
        solid.cuboid(low, [self.right - bar, self.top - bar, depth + half]);
        solid
    }
}
