//! What stands in an opening: frames, thresholds, leaves, panels, glass.
//!
//! All shapes are in the frame of the opening's node: the origin on the floor in the middle of the opening,
//! x along the wall, +Z towards the first room.

use super::solid::Solid;
use super::ticks::Ticks;

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

/// A hinged leaf in the frame of its own node: the hinge at the origin, x towards the free end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct LeafShape {
    /// From the hinge to the free end.
    pub length: Ticks,
    /// Head of the opening.
    pub top: Ticks,
    /// Whether the leaf's body lies on +Z of the hinge line (it opens clockwise seen from above).
    pub body_on_front: bool,
    /// Whether the free end closes against a jamb and not against another leaf.
    pub meets_jamb: bool,
}

/// Width of jambs and heads of doors.
const DOOR_FRAME: Ticks = Ticks(4_000);
/// How far a door frame stands out of the wall on each side, so that no two faces lie in one plane.
const PROJECTION: Ticks = Ticks(1_000);
/// Width of the bars of a window frame and of the stiles of a sliding panel.
const BAR: Ticks = Ticks(6_000);
/// Depth of the bars of a window frame.
const BAR_DEPTH: Ticks = Ticks(7_000);
/// Width above which a window has a bar in its middle.
const MULLION_FROM: Ticks = Ticks(120_000);
/// Thickness of glass.
const GLASS: Ticks = Ticks(1_000);
/// Thickness of the board on a window sill, and how far it stands into the room.
const SILL_BOARD: [Ticks; 2] = [Ticks(2_500), Ticks(2_000)];
/// Thickness of a door leaf.
const LEAF: Ticks = Ticks(4_000);
/// Air around a leaf.
const LEAF_GAP: Ticks = Ticks(400);
/// Height of the middle of a handle above the floor.
const HANDLE_HEIGHT: Ticks = Ticks(105_000);
/// Handle: distance from the free end, length, thickness, distance from the leaf.
const HANDLE: [Ticks; 4] = [Ticks(5_000), Ticks(12_000), Ticks(2_000), Ticks(4_000)];
/// Lowest leaf that has a handle.
const HANDLE_FROM: Ticks = Ticks(130_000);
/// Depth of a sliding panel.
const PANEL: Ticks = Ticks(3_500);
/// Overlap of the two panels of a sliding door.
const PANEL_OVERLAP: Ticks = Ticks(3_000);

impl Reveal {
    fn width(&self) -> Ticks {
        self.right - self.left
    }

    fn middle_depth(&self) -> Ticks {
        Ticks((self.back.0 + self.front.0) / 2)
    }

    /// A bar's width, less in openings too small for it.
    fn fitted(&self, bar: Ticks) -> Ticks {
        const SMALLEST_SHARE: i32 = 6;
        let room = self.width().min(self.top - self.bottom);
        bar.min(Ticks(room.0 / SMALLEST_SHARE))
    }

    /// The floor through the wall.
    pub(crate) fn threshold(&self, bottom: Ticks, slot: &'static str) -> Solid {
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, bottom, self.back], [self.right, Ticks(0), self.front]);
        solid
    }

    /// Two jambs and a head around a doorway.
    pub(crate) fn door_frame(&self, slot: &'static str) -> Solid {
        let bar = self.fitted(DOOR_FRAME);
        let (back, front) = (self.back - PROJECTION, self.front + PROJECTION);
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, self.bottom, back], [self.left + bar, self.top, front]);
        solid.cuboid([self.right - bar, self.bottom, back], [self.right, self.top, front]);
        solid.cuboid([self.left + bar, self.top - bar, back], [self.right - bar, self.top, front]);
        solid
    }

    /// The bars around and in a window.
    pub(crate) fn window_frame(&self, slot: &'static str) -> Solid {
        let inner = self.glazed();
        let (back, front) = self.bar_depth();
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, self.bottom, back], [inner.left, self.top, front]);
        solid.cuboid([inner.right, self.bottom, back], [self.right, self.top, front]);
        solid.cuboid([inner.left, self.bottom, back], [inner.right, inner.bottom, front]);
        solid.cuboid([inner.left, inner.top, back], [inner.right, self.top, front]);
        if self.width() > MULLION_FROM {
            let middle = Ticks((self.left.0 + self.right.0) / 2);
            let half = Ticks(BAR.0 / 2);
            solid.cuboid([middle - half, inner.bottom, back], [middle + half, inner.top, front]);
        }
        solid
    }

    /// The panes of a window.
    pub(crate) fn window_glass(&self, slot: &'static str) -> Solid {
        let inner = self.glazed();
        let (back, front) = self.glass_depth();
        let mut solid = Solid::new(slot);
        if self.width() > MULLION_FROM {
            let middle = Ticks((self.left.0 + self.right.0) / 2);
            let half = Ticks(BAR.0 / 2);
            solid.cuboid([inner.left, inner.bottom, back], [middle - half, inner.top, front]);
            solid.cuboid([middle + half, inner.bottom, back], [inner.right, inner.top, front]);
        } else {
            solid.cuboid([inner.left, inner.bottom, back], [inner.right, inner.top, front]);
        }
        solid
    }

    /// The board on the sill, from the window's bars into the first room.
    pub(crate) fn sill_board(&self, slot: &'static str) -> Solid {
        let [thickness, projection] = SILL_BOARD;
        let low = [self.left, self.bottom, self.bar_depth().1];
        let mut solid = Solid::new(slot);
        solid.cuboid(low, [self.right, self.bottom + thickness, self.front + projection]);
        solid
    }

    /// One of the two panels of a sliding door, stiles then glass; `second` is the one on the right, nearer
    /// to the first room.
    pub(crate) fn sliding_panel(&self, second: bool, slots: [&'static str; 2]) -> [Solid; 2] {
        let bar = self.fitted(DOOR_FRAME);
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

    fn stiles(&self, slot: &'static str) -> Solid {
        let bar = self.fitted(BAR);
        let mut solid = Solid::new(slot);
        solid.cuboid([self.left, self.bottom, self.back], [self.left + bar, self.top, self.front]);
        solid.cuboid([self.right - bar, self.bottom, self.back], [self.right, self.top, self.front]);
        let (left, right) = (self.left + bar, self.right - bar);
        solid.cuboid([left, self.bottom, self.back], [right, self.bottom + bar, self.front]);
        solid.cuboid([left, self.top - bar, self.back], [right, self.top, self.front]);
        solid
    }

    fn pane(&self, slot: &'static str) -> Solid {
        let bar = self.fitted(BAR);
        let half = Ticks(GLASS.0 / 2);
        let depth = self.middle_depth();
        let mut solid = Solid::new(slot);
        let low = [self.left + bar, self.bottom + bar, depth - half];
        solid.cuboid(low, [self.right - bar, self.top - bar, depth + half]);
        solid
    }

    fn glazed(&self) -> Self {
        let bar = self.fitted(BAR);
        Self {
            left: self.left + bar,
            right: self.right - bar,
            bottom: self.bottom + bar,
            top: self.top - bar,
            ..*self
        }
    }

    /// Bars stand in the middle of the wall; thin walls have bars that stand out.
    fn bar_depth(&self) -> (Ticks, Ticks) {
        let half = Ticks(BAR_DEPTH.0 / 2);
        (self.middle_depth() - half, self.middle_depth() + half)
    }

    fn glass_depth(&self) -> (Ticks, Ticks) {
        let half = Ticks(GLASS.0 / 2);
        (self.middle_depth() - half, self.middle_depth() + half)
    }
}

impl LeafShape {
    /// The leaf, then its handles.
    ///
    /// The body keeps clear of the jamb by starting a frame's width from the hinge, both shut and open.
    pub(crate) fn build(&self, slots: [&'static str; 2]) -> [Solid; 2] {
        let clear = DOOR_FRAME + LEAF_GAP;
        let end = if self.meets_jamb { self.length - clear } else { self.length - LEAF_GAP };
        let top = self.top - clear;
        let (back, front) = self.depth(LEAF_GAP, LEAF_GAP + LEAF);
        let mut leaf = Solid::new(slots[0]);
        leaf.cuboid([clear, LEAF_GAP, back], [end, top, front]);
        let mut handles = Solid::new(slots[1]);
        if top > HANDLE_FROM && !leaf.is_empty() {
            self.handles(end, &mut handles);
        }
        [leaf, handles]
    }

    /// A lever on either face, held by a short neck.
    fn handles(&self, end: Ticks, solid: &mut Solid) {
        let [from_end, length, thickness, distance] = HANDLE;
        let (low, high) = (HANDLE_HEIGHT, HANDLE_HEIGHT + thickness);
        let neck_start = end - from_end - thickness;
        let body = [LEAF_GAP, LEAF_GAP + LEAF];
        // Neck and lever as depths, on the far face and on the near face.
        let far = [(body[1], body[1] + distance), (body[1] + distance, body[1] + distance + thickness)];
        let near = [(body[0] - distance, body[0]), (body[0] - distance - thickness, body[0] - distance)];
        for [neck, lever] in [far, near] {
            let (back, front) = self.depth(neck.0, neck.1);
            solid.cuboid([neck_start, low, back], [neck_start + thickness, high, front]);
            let (back, front) = self.depth(lever.0, lever.1);
            let low = [neck_start + thickness - length, low, back];
            solid.cuboid(low, [neck_start + thickness, high, front]);
        }
    }

    /// Depths measured from the hinge line into the leaf, as low and high z.
    fn depth(&self, near: Ticks, far: Ticks) -> (Ticks, Ticks) {
        if self.body_on_front { (near, far) } else { (-far, -near) }
    }
}
