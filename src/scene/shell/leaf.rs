//! Door leaves on hinges, with handles.

use super::slots::{FRAME_SLOT, GLASS_SLOT};
use super::solid::{Grain, Solid};
use super::ticks::Ticks;
use crate::recipes::{GeometrySet, Slot};

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
    /// How it is made.
    pub design: LeafDesign,
}

/// How a leaf is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum LeafDesign {
    /// A smooth board.
    Flush,
    /// A smooth board with a skin of laminate.
    Laminate,
    /// Two panels between stiles and rails.
    Panelled,
    /// Sheet steel with a strip of glass.
    Steel,
    /// A pane in a frame: to balconies and terraces.
    Glazed,
}

/// Width of the jambs and heads of doors, behind which a leaf keeps.
pub(super) const JAMB: Ticks = Ticks(4_000);
/// Thickness of a leaf.
const LEAF: Ticks = Ticks(4_000);
/// Air around a leaf.
pub(super) const LEAF_GAP: Ticks = Ticks(400);
/// Height of the middle of a handle above the floor.
const HANDLE_HEIGHT: Ticks = Ticks(105_000);
/// Handle: distance from the free end, length, thickness, distance from the leaf.
const HANDLE: [Ticks; 4] = [Ticks(5_000), Ticks(12_000), Ticks(2_000), Ticks(4_000)];
/// How much further than the neck the plate behind a handle reaches, and its thickness.
const ROSE: [Ticks; 2] = [Ticks(1_600), Ticks(500)];
/// Lowest leaf that has a handle.
const HANDLE_FROM: Ticks = Ticks(130_000);
/// Hinges: height of each, distance from the leaf's ends, reach over the leaf.
const HINGE: [Ticks; 3] = [Ticks(9_000), Ticks(20_000), Ticks(2_000)];
/// Where hinges begin: not in the plane of the wall's face, where a leaf that stands open has them.
const HINGE_START: Ticks = Ticks(300);
/// Stiles and upper rail, lower rail, and lock rail from and to.
const STILE: Ticks = Ticks(11_000);
const LOWER_RAIL: Ticks = Ticks(22_000);
const LOCK_RAIL: [Ticks; 2] = [Ticks(95_000), Ticks(116_000)];
/// How far panels, and panes, lie behind the face.
const PANEL_INSET: Ticks = Ticks(1_200);
const PANE_INSET: Ticks = Ticks(1_500);
/// Strip of glass in steel: half its width, and its distance from the leaf's ends.
const STRIP: [Ticks; 2] = [Ticks(7_000), Ticks(30_000)];
/// Narrowest and lowest leaf that is more than a board.
const WORKED_FROM: [Ticks; 2] = [Ticks(40_000), Ticks(160_000)];

impl LeafDesign {
    /// The design of a geometry set.
    pub(crate) fn of_set(set: GeometrySet) -> Self {
        match set {
            GeometrySet::Budget => Self::Laminate,
            GeometrySet::Industrial => Self::Steel,
            GeometrySet::Plain => Self::Flush,
            GeometrySet::Traditional => Self::Panelled,
        }
    }

    /// Slots of leaf and handle.
    fn slots(self) -> [Slot; 2] {
        match self {
            Self::Flush => [Slot::WoodLight, Slot::Metal],
            Self::Laminate => [Slot::Laminate, Slot::Metal],
            Self::Panelled => [Slot::Painted, Slot::Brass],
            Self::Steel => [Slot::MetalDark, Slot::Metal],
            Self::Glazed => [FRAME_SLOT, Slot::Metal],
        }
    }
}

impl LeafShape {
    /// The leaf, then its handles and hinges, then glass.
    ///
    /// The body keeps clear of the jamb by starting a frame's width from the hinge, both shut and open.
    pub(crate) fn build(&self) -> [Solid; 3] {
        let clear = JAMB + LEAF_GAP;
        let end = if self.meets_jamb { self.length - clear } else { self.length - LEAF_GAP };
        let top = self.top - clear;
        let [leaf_slot, metal_slot] = self.design.slots();
        let mut solids =
            [leaf_slot, metal_slot, GLASS_SLOT].map(|slot| Solid::new(slot).with_grain(Grain::Upright));
        let [leaf, metal, glass] = &mut solids;
        self.body([clear, end], [LEAF_GAP, top], leaf, glass);
        if top > HANDLE_FROM && !leaf.is_empty() {
            self.handles(end, metal);
            let [height, from_end, reach] = HINGE;
            for low in [from_end, top - from_end - height] {
                let (back, front) = self.depth(-LEAF_GAP, LEAF_GAP);
                metal.cuboid([HINGE_START, low, back], [clear + reach, low + height, front]);
            }
        }
        solids
    }

    fn body(&self, [from, to]: [Ticks; 2], [low, high]: [Ticks; 2], leaf: &mut Solid, glass: &mut Solid) {
        let board = |x: [Ticks; 2], y: [Ticks; 2], inset: Ticks, solid: &mut Solid| {
            let (back, front) = self.depth(LEAF_GAP + inset, LEAF_GAP + LEAF - inset);
            solid.cuboid([x[0], y[0], back], [x[1], y[1], front]);
        };
        let none = Ticks(0);
        if to - from < WORKED_FROM[0] || high - low < WORKED_FROM[1] {
            return board([from, to], [low, high], none, leaf);
        }
        let (inner, edge) = ([from + STILE, to - STILE], high - STILE);
        let frame = |leaf: &mut Solid| {
            board([from, inner[0]], [low, high], none, leaf);
            board([inner[1], to], [low, high], none, leaf);
            board(inner, [low, LOWER_RAIL], none, leaf);
            board(inner, [edge, high], none, leaf);
        };
        match self.design {
            LeafDesign::Flush | LeafDesign::Laminate => board([from, to], [low, high], none, leaf),
            LeafDesign::Panelled => {
                frame(leaf);
                board(inner, LOCK_RAIL, none, leaf);
                board(inner, [LOWER_RAIL, LOCK_RAIL[0]], PANEL_INSET, leaf);
                board(inner, [LOCK_RAIL[1], edge], PANEL_INSET, leaf);
            }
            LeafDesign::Glazed => {
                frame(leaf);
                board(inner, [LOWER_RAIL, edge], PANE_INSET, glass);
            }
            LeafDesign::Steel => {
                let middle = Ticks((from.0 + to.0) / 2);
                let strip = [middle - STRIP[0], middle + STRIP[0]];
                board([from, strip[0]], [low, high], none, leaf);
                board([strip[1], to], [low, high], none, leaf);
                board(strip, [low, STRIP[1]], none, leaf);
                board(strip, [high - STRIP[1], high], none, leaf);
                board(strip, [STRIP[1], high - STRIP[1]], PANE_INSET, glass);
            }
        }
    }

    /// A lever on either face, held by a short neck on a plate.
    fn handles(&self, end: Ticks, solid: &mut Solid) {
        let [from_end, length, thickness, distance] = HANDLE;
        let [margin, plate] = ROSE;
        let (low, high) = (HANDLE_HEIGHT, HANDLE_HEIGHT + thickness);
        let neck = [end - from_end - thickness, end - from_end];
        // Depths are measured from either face outwards.
        let faces = [(LEAF_GAP + LEAF, 1), (LEAF_GAP, -1)];
        for (face, sign) in faces {
            let out = |from: Ticks, to: Ticks| {
                let [one, two] = [from, to].map(|depth| Ticks(face.0 + sign * depth.0));
                self.depth(one.min(two), one.max(two))
            };
            let (back, front) = out(Ticks(0), plate);
            let corner = [neck[1] + margin, high + margin, front];
            solid.cuboid([neck[0] - margin, low - margin, back], corner);
            let (back, front) = out(plate, distance);
            solid.cuboid([neck[0], low, back], [neck[1], high, front]);
            let (back, front) = out(distance, distance + thickness);
            solid.cuboid([neck[1] - length, low, back], [neck[1], high, front]);
        }
    }

    /// Depths measured from the hinge line into the leaf, as low and high z.
    fn depth(&self, near: Ticks, far: Ticks) -> (Ticks, Ticks) {
        if self.body_on_front { (near, far) } else { (-far, -near) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn leaf(length: i32, design: LeafDesign) -> [usize; 3] {
        let shape = LeafShape {
            length: Ticks(length),
            top: Ticks(210_000),
            body_on_front: false,
            meets_jamb: true,
            design,
        };
        shape.build().map(|solid| solid.finish().indices.len() / 3)
    }

    #[test]
    fn designs_differ_and_stay_small() {
        assert_eq!(leaf(90_000, LeafDesign::Flush), [12, 96, 0]);
        assert_eq!(leaf(90_000, LeafDesign::Panelled), [84, 96, 0]);
        assert_eq!(leaf(90_000, LeafDesign::Steel), [48, 96, 12]);
        assert_eq!(leaf(90_000, LeafDesign::Glazed), [48, 96, 12]);
    }

    #[test]
    fn a_leaf_is_where_furniture_keeps_free() {
        use crate::geometry::Point;
        use crate::plan::{HANDLE_HEIGHTS, HANDLE_LENGTH, HANDLE_REACH, LEAF_DEPTH, Leaf};
        const ROUNDING: f64 = 1e-4;
        let shape = LeafShape {
            length: Ticks(90_000),
            top: Ticks(210_000),
            body_on_front: true,
            meets_jamb: false,
            design: LeafDesign::Panelled,
        };
        let mut corners = shape.build().into_iter().flat_map(|solid| solid.finish().positions);
        let deepest = corners.clone().map(|[_, _, z]| f64::from(z)).fold(0.0, f64::max);
        assert!((deepest - LEAF_DEPTH - HANDLE_REACH).abs() < ROUNDING, "{deepest}");
        assert!(corners.all(|corner| {
            let [x, y, z] = corner.map(f64::from);
            let is_handle = x > 0.9 - HANDLE_LENGTH && y > HANDLE_HEIGHTS.0 && y < HANDLE_HEIGHTS.1;
            z < LEAF_DEPTH + ROUNDING || is_handle
        }));
        // The same leaf in a plan: it turns clockwise, its body on the right of the line to its free end.
        let leaf = Leaf { hinge: Point::ZERO, closed_tip: Point::Y * 0.9, open_tip: Point::X * 0.9 };
        let [board, _] = leaf.standing_open().unwrap();
        assert!(board.iter().all(|corner| corner.y <= 0.0), "{board:?}");
    }

    #[test]
    fn the_grain_of_a_leaf_runs_up() {
        let shape = LeafShape {
            length: Ticks(90_000),
            top: Ticks(210_000),
            body_on_front: true,
            meets_jamb: true,
            design: LeafDesign::Flush,
        };
        let [leaf, ..] = shape.build().map(Solid::finish);
        let extent = |axis: usize| {
            let values = || leaf.texture_coordinates.iter().map(|pair| pair[axis]);
            values().fold(f32::MIN, f32::max) - values().fold(f32::MAX, f32::min)
        };
        assert!(extent(0) > 2.0 && extent(1) < 2.0, "{} m along the grain", extent(0));
    }

    #[test]
    fn a_narrow_leaf_is_a_board() {
        assert_eq!(leaf(45_000, LeafDesign::Panelled)[0], 12);
    }
}
