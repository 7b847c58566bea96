//! A wall as a body with holes for its openings.

use glam::Vec3;

use super::solid::Solid;
use super::ticks::Ticks;
use crate::recipes::Slot;

/// A wall in its own frame: the origin at the middle of the inner face's foot, +Z into the room, the body
/// behind (−Z). Seen from above, `u` runs along the inner face from the wall's start:
///
/// ```text
///   back's end          back's start
///      +---------+  +---------+        z = -depth
///       \         \/         /         (less where a room lies behind)
///        +------------------+          z = 0, the room is below
///      u = length         u = 0   →  +X
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct WallShape {
    /// Length of the inner face.
    pub length: Ticks,
    /// The outer face: from `u` zero to the length, two at least.
    pub back: Vec<Cut>,
    /// Underside; the floor of the room is zero.
    pub bottom: Ticks,
    /// Top.
    pub top: Ticks,
    /// The holes for openings.
    pub holes: Vec<Hole>,
    /// Material.
    pub slot: Slot,
    /// Material of the outer face.
    pub outer_slot: Slot,
    /// Height up to which the inner face has another material, and that one.
    pub dado: Option<(Ticks, Slot)>,
}

/// A rectangular hole through a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Hole {
    /// Begins at this `u`.
    pub from: Ticks,
    /// Ends at this `u`.
    pub to: Ticks,
    /// Lower edge.
    pub low: Ticks,
    /// Upper edge.
    pub high: Ticks,
}

/// How much shorter walls of one mesh are at each end: more than what tools take for one corner when they join those of a mesh
/// (Blender: 0.1 mm), so that each wall stays a closed body that can be cut and filled.
const SEAM: Ticks = Ticks(20);

/// A cut through the wall: where it meets the inner and the outer face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Cut {
    /// On the inner face.
    pub inner: Ticks,
    /// On the outer face: along the wall, beyond its ends where it reaches round a corner, and behind the inner face.
    pub outer: [Ticks; 2],
}

impl WallShape {
    /// The same wall a little shorter at both ends, its middle where it was: it shares no corner with its neighbours.
    pub(crate) fn apart(self) -> Self {
        let seam = SEAM.min(Ticks(self.length.0 / 4));
        let length = self.length - seam - seam;
        let inside = |u: Ticks| (u - seam).clamp(Ticks(0), length);
        let hole = |hole: Hole| Hole { from: inside(hole.from), to: inside(hole.to), ..hole };
        let cut = |cut: Cut| {
            let [u, depth] = cut.outer;
            let u = match cut.inner {
                Ticks(0) => u,
                inner if inner == self.length => u - seam - seam,
                _ => u - seam,
            };
            Cut { inner: inside(cut.inner), outer: [u, depth] }
        };
        let mut back: Vec<Cut> = self.back.iter().copied().map(cut).collect();
        // A face that is shorter than the seams keeps its direction.
        for index in 1..back.len() {
            if self.back[index].outer[0] >= self.back[index - 1].outer[0] {
                back[index].outer[0] = back[index].outer[0].max(back[index - 1].outer[0]);
            }
        }
        back.dedup();
        Self { length, back, holes: self.holes.into_iter().map(hole).collect(), ..self }
    }

    /// The wall as a grid of cells between cuts and heights; faces stand where a filled cell meets none, so
    /// that the body is closed and no face touches another one's middle. The second part is the outer face, the
    /// third the lower inner face, where their material is another one.
    pub(crate) fn build(&self) -> [Solid; 3] {
        let (cuts, heights) = (self.cuts(), self.heights());
        let (columns, rows) = (cuts.len() - 1, heights.len() - 1);
        let is_filled = |column: Option<usize>, row: Option<usize>| match (column, row) {
            (Some(column), Some(row)) if column < columns && row < rows => {
                self.is_filled([cuts[column], cuts[column + 1]], [heights[row], heights[row + 1]])
            }
            _ => false,
        };
        let dado_slot = self.dado.map_or(self.slot, |(_, slot)| slot);
        let mut solids = [self.slot, self.outer_slot, dado_slot].map(Solid::new);
        for column in 0..columns {
            for row in (0..rows).filter(|&row| is_filled(Some(column), Some(row))) {
                let cell = Cell {
                    shape: self,
                    start: cuts[column],
                    end: cuts[column + 1],
                    low: heights[row],
                    high: heights[row + 1],
                };
                let bare = Bare {
                    above: !is_filled(Some(column), Some(row + 1)),
                    below: !is_filled(Some(column), row.checked_sub(1)),
                    start: !is_filled(column.checked_sub(1), Some(row)),
                    end: !is_filled(Some(column + 1), Some(row)),
                };
                cell.faces(&bare, &mut solids);
            }
        }
        solids
    }

    /// Start, both ends of each hole, end. A hole that begins or ends at a corner leaves the mitre behind it: then two
    /// cuts meet on the inner face.
    fn cuts(&self) -> Vec<Cut> {
        let mut cuts = self.back_beside_holes();
        for u in self.holes.iter().flat_map(|hole| [hole.from, hole.to]) {
            let is_around =
                |pair: &[Cut]| pair[0].inner <= u && u <= pair[1].inner && pair[0].inner < pair[1].inner;
            if let Some(index) = cuts.windows(2).position(is_around) {
                cuts.insert(index + 1, between(cuts[index], cuts[index + 1], u));
            }
        }
        cuts.dedup();
        cuts
    }

    /// The outer face, and with it the mitres that lean over a hole's edge: what stands beside the hole ends square there.
    fn back_beside_holes(&self) -> Vec<Cut> {
        let edges = || self.holes.iter().flat_map(|hole| [hole.from, hole.to]);
        let is_beside = |low: Ticks, high: Ticks| edges().any(|edge| low < edge && edge < high);
        let mut back = self.back.clone();
        let foot = |inner: Ticks| Cut { inner, outer: [inner, Ticks(0)] };
        if let [first, second, ..] = &mut back[..]
            && first.outer[0] < second.inner
            && is_beside(Ticks(0), first.outer[0])
        {
            first.inner = first.outer[0];
            back.insert(0, foot(Ticks(0)));
        }
        if let [.., second, last] = &mut back[..]
            && second.inner < last.outer[0]
            && is_beside(last.outer[0], self.length)
        {
            last.inner = last.outer[0];
            back.push(foot(self.length));
        }
        back
    }

    fn heights(&self) -> Vec<Ticks> {
        let mut heights: Vec<Ticks> = self.holes.iter().flat_map(|hole| [hole.low, hole.high]).collect();
        heights.extend([self.bottom, self.top]);
        heights.extend(self.dado.map(|(height, _)| height));
        heights.retain(|height| (self.bottom..=self.top).contains(height));
        heights.sort_unstable();
        heights.dedup();
        heights
    }

    fn is_filled(&self, cuts: [Cut; 2], heights: [Ticks; 2]) -> bool {
        let [start, end] = cuts.map(|cut| cut.inner);
        let is_mitre = start == end;
        !self.holes.iter().any(|hole| {
            !is_mitre
                && hole.from <= start
                && end <= hole.to
                && hole.low <= heights[0]
                && heights[1] <= hole.high
        })
    }
}

/// A cut square through the wall at `u`, between two others: at their outer ends where those do not reach so far.
fn between(one: Cut, two: Cut, u: Ticks) -> Cut {
    let ([from, start], [to, end]) = (one.outer, two.outer);
    let at = u.max(from).min(to.max(from));
    let share = if to > from { f64::from((at - from).0) / f64::from((to - from).0) } else { 0.0 };
    let depth = f64::from(start.0) + f64::from((end - start).0) * share;
    Cut { inner: u, outer: [at, Ticks(depth.round() as i32)] }
}

/// One filled cell of the grid.
struct Cell<'a> {
    shape: &'a WallShape,
    start: Cut,
    end: Cut,
    low: Ticks,
    high: Ticks,
}

/// Which sides of a cell meet no other filled cell.
struct Bare {
    above: bool,
    below: bool,
    start: bool,
    end: bool,
}

impl Cell<'_> {
    fn faces(&self, bare: &Bare, [solid, outer, dado]: &mut [Solid; 3]) {
        let middle = self.shape.length.metres() / 2.0;
        let x = |u: Ticks| (middle - u.metres()) as f32;
        let (low, high) = (self.low.narrow(), self.high.narrow());
        let front = |cut: Cut, y: f32| Vec3::new(x(cut.inner), y, 0.0);
        let behind = |cut: Cut, y: f32| Vec3::new(x(cut.outer[0]), y, (-cut.outer[1]).narrow());
        let (start, end) = (self.start, self.end);
        let is_dado = self.shape.dado.is_some_and(|(height, _)| self.high <= height);
        let inner = if is_dado { dado } else { &mut *solid };
        inner.face(&[front(end, low), front(start, low), front(start, high), front(end, high)]);
        let is_plain = self.shape.slot == self.shape.outer_slot;
        let outer = if is_plain { &mut *solid } else { outer };
        outer.face(&[behind(start, low), behind(end, low), behind(end, high), behind(start, high)]);
        if bare.above {
            solid.face(&[front(end, high), front(start, high), behind(start, high), behind(end, high)]);
        }
        if bare.below {
            solid.face(&[behind(end, low), behind(start, low), front(start, low), front(end, low)]);
        }
        if bare.start {
            solid.face(&[front(start, low), behind(start, low), behind(start, high), front(start, high)]);
        }
        if bare.end {
            solid.face(&[behind(end, low), front(end, low), front(end, high), behind(end, high)]);
        }
    }
}
