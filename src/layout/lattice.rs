//! A lattice: where its places are, how many of them a length has room for, and how many columns and rows some pieces make.

use std::cell::Cell;

use crate::catalog::{ClassIndex, Grid};
use crate::geometry::{Bounds, Point};

use super::body::Pose;

/// Added before rounding down, so that a length of exactly n intervals counts n.
const ROUNDING: f64 = 1e-9;

/// Where the agents of a class stand: the same for all of them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lattice {
    /// Its axes, at the angle of its rows.
    pub(crate) frame: Pose,
    /// Metres of its undersides above the floor.
    pub(crate) elevation: f64,
    /// Along its rows and across them.
    pub(crate) axes: [Axis; 2],
    /// Who stands at a place.
    pub(crate) members: Vec<Member>,
    /// The places that the agents take.
    pub(crate) block: Block,
    /// Where the middles of places may be at all.
    pub(crate) middles: Bounds,
}

impl Lattice {
    /// Where a member stands at a place in the frame of the lattice.
    pub(crate) fn pose(&self, place: Point, member: &Member) -> Pose {
        Pose::new(self.frame.turn(place + member.offset), self.elevation, self.frame.angle + member.turn)
    }
}

/// The agent at a place of the lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Member {
    /// From the place, in the frame of the lattice.
    pub(crate) offset: Point,
    /// Radians beyond the angle of the lattice.
    pub(crate) turn: f64,
}

/// The places of a lattice that its agents take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    /// The first place, in the frame of the lattice.
    pub(crate) first: Point,
    /// Columns and rows.
    pub(crate) counts: [usize; 2],
}

impl Block {
    /// How many places it has.
    pub(crate) fn len(&self) -> usize {
        self.counts[0] * self.counts[1]
    }

    /// A place of it, row by row, in the frame of the lattice.
    pub(crate) fn place(&self, axes: &[Axis; 2], index: usize) -> Point {
        let at = [index % self.counts[0], index / self.counts[0]];
        let offset = |axis: usize| axes[axis].offset(at[axis], self.counts[axis]);
        self.first + Point::new(offset(0), offset(1))
    }
}

/// Which slots of a lattice the proposals of an agent are: those of the block, beginning with one of them, and those around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slots {
    /// The first slot that is proposed.
    pub(crate) first: usize,
    /// How many slots the block has.
    pub(crate) in_block: usize,
    /// How many were proposed before.
    pub(crate) before: usize,
}

impl Slots {
    /// Slots that are proposed at once. Nearly all agents take one of these: the others are worked out where they do not.
    const AT_ONCE: usize = 8;

    /// Those of the first proposals, beginning with a slot.
    pub(crate) fn from(first: usize, in_block: usize) -> Self {
        Self { first, in_block, before: 0 }
    }

    /// Those of all other proposals.
    pub(crate) fn others(self) -> Self {
        Self { before: self.before + self.at_once(), ..self }
    }

    /// How many slots of the block are proposed at once.
    pub(crate) fn at_once(self) -> usize {
        self.in_block.min(Self::AT_ONCE)
    }

    /// The slot of a proposal.
    pub(crate) fn slot(self, proposal: usize) -> usize {
        let proposal = self.before + proposal;
        if proposal < self.in_block { (proposal + self.first) % self.in_block } else { proposal }
    }
}

/// A block with the axes of its lattice.
pub(crate) type LaidBlock = (Block, [Axis; 2]);

/// What the block of some agents depends on within an attempt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AskedBlock {
    /// Whose it is.
    pub(crate) class: ClassIndex,
    /// Its intervals.
    pub(crate) grid: Grid,
    /// Radians of its rows.
    pub(crate) angle: f64,
    /// Where it may be, in its frame.
    pub(crate) bounds: Bounds,
    /// Half of the width and depth of what takes a place.
    pub(crate) half: Point,
    /// Places that it should have.
    pub(crate) wanted: usize,
}

/// The block that was asked for last: the agents of a class ask for the same one after the other.
#[derive(Debug, Default)]
pub(crate) struct KnownBlock(Cell<Option<(AskedBlock, LaidBlock)>>);

impl KnownBlock {
    /// The block that is known, else the one that is found.
    pub(crate) fn get_or(&self, asked: AskedBlock, find: impl FnOnce() -> LaidBlock) -> LaidBlock {
        match self.0.get() {
            Some((known, found)) if known == asked => found,
            _ => {
                let found = find();
                self.0.set(Some((asked, found)));
                found
            }
        }
    }
}

/// One direction of a lattice: regular intervals, and aisles between blocks of as many places, or of one less.
///
/// ```text
///  o--o--o----o--o----o--o     seven places, three at most in a block
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    /// Metres between neighbours.
    interval: f64,
    /// Most places in a row without an aisle; zero for no aisles.
    block: usize,
    /// Metres that an aisle adds to the interval.
    aisle: f64,
    /// Whether an aisle is in the middle of an even number of places.
    is_halved: bool,
}

impl Axis {
    /// One of the two directions of a grid.
    pub(crate) fn new(grid: &Grid, axis: usize) -> Self {
        let is_halved = grid.is_halved && axis == 0;
        Self { interval: grid.interval[axis], block: grid.block[axis] as usize, aisle: grid.aisle, is_halved }
    }

    /// The same with so many places spread over a length, one in the middle of each share of it, where that puts them farther
    /// apart.
    pub(crate) fn spread(self, count: usize, length: f64) -> Self {
        let share = length / count.max(1) as f64;
        if self.block == 0 { Self { interval: self.interval.max(share), ..self } } else { self }
    }

    /// Metres from the first of so many places to another; places behind the last go on in the same way.
    pub(crate) fn offset(&self, index: usize, count: usize) -> f64 {
        index as f64 * self.interval + self.aisles_before(index, count) as f64 * self.aisle
    }

    /// The same for places before the first too. These have no aisles: what stands there has lost its block anyway. Halves go on alike
    /// on both sides.
    pub(crate) fn at(&self, index: i64, count: usize) -> f64 {
        match usize::try_from(index) {
            Ok(index) => self.offset(index, count),
            Err(_) if self.is_halved => {
                let mirrored = index.unsigned_abs() as usize + count.max(1) - 1;
                self.span(count) - self.offset(mirrored, count)
            }
            Err(_) => index as f64 * self.interval,
        }
    }

    /// By how many places it grows: by one, or by one on each side of the aisle in the middle.
    pub(crate) fn step(&self) -> usize {
        1 + usize::from(self.is_halved)
    }

    /// How many places a length has room for before the first.
    pub(crate) fn count_before(&self, length: f64) -> i64 {
        (length / self.interval + ROUNDING).max(0.0) as i64
    }

    /// Metres from the first of so many places to the last.
    pub(crate) fn span(&self, count: usize) -> f64 {
        self.offset(count.max(1) - 1, count)
    }

    /// Aisles before a place. Of halves, the one before the aisle in the middle is the mirror of the other.
    fn aisles_before(&self, index: usize, count: usize) -> usize {
        let half = count / 2;
        if !self.is_halved || half == 0 {
            return self.aisles_in_row(index, count);
        }
        let last = self.aisles_in_row(half - 1, half);
        match index.checked_sub(half) {
            Some(behind) => last + 1 + self.aisles_in_row(behind, half),
            None => last - self.aisles_in_row(half - 1 - index, half),
        }
    }

    /// Aisles before a place of a row without one in the middle. The first blocks are the larger ones.
    fn aisles_in_row(&self, index: usize, count: usize) -> usize {
        if self.block == 0 {
            return 0;
        }
        let blocks = count.div_ceil(self.block).max(1);
        let (small, large_blocks) = ((count / blocks).max(1), count % blocks);
        let in_large = large_blocks * (small + 1);
        match index.checked_sub(in_large) {
            Some(behind) => large_blocks + behind / small,
            None => index / (small + 1),
        }
    }

    /// How many places a length has room for, one at least.
    pub(crate) fn count(&self, length: f64) -> usize {
        let most = (length / self.interval + ROUNDING).max(0.0) as usize + 1;
        let fits =
            |count: &usize| count.is_multiple_of(self.step()) && self.span(*count) <= length + ROUNDING;
        (1..=most).rev().find(fits).unwrap_or(1)
    }
}

/// Columns and rows for `wanted` places: enough, few empty, and filling both directions alike. `most` bounds
/// both; `intervals` is how many fit into each direction, and columns are a multiple of `step` where as many fit.
pub(crate) fn columns_and_rows(wanted: usize, most: [usize; 2], intervals: Point, step: usize) -> [usize; 2] {
    let mut best = (f64::INFINITY, most);
    for columns in (step.min(most[0])..=most[0]).step_by(step) {
        let rows = wanted.max(1).div_ceil(columns);
        if rows > most[1] {
            continue;
        }
        let empty = (columns * rows - wanted) as f64 / wanted.max(1) as f64;
        let filled = Point::new(columns as f64, rows as f64) / (intervals + Point::ONE);
        // Both are shares: empty places of those wanted, and how unevenly the two directions are filled. They count the same.
        let cost = empty + (filled.x - filled.y).abs();
        if cost < best.0 {
            best = (cost, [columns, rows]);
        }
    }
    best.1
}

/// The number nearest to `wanted` whose lattice in a room of a size has no empty place, of two the larger.
pub(crate) fn full_number(wanted: u32, grid: &Grid, room: Point) -> u32 {
    let axes = [Axis::new(grid, 0), Axis::new(grid, 1)];
    let most = [axes[0].count(room.x), axes[1].count(room.y)];
    let is_full = |&number: &u32| {
        let [columns, rows] = columns_and_rows(number as usize, most, room / grid.interval, axes[0].step());
        columns * rows == number as usize
    };
    let nearest = (0..wanted).flat_map(|off| [wanted + off, wanted - off]);
    nearest.into_iter().find(is_full).unwrap_or(wanted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_aisle_follows_each_block() {
        let axis = Axis { interval: 1.0, block: 2, aisle: 0.5, is_halved: false };
        assert_eq!([0, 1, 2, 3, 4].map(|index| axis.offset(index, 5)), [0.0, 1.0, 2.5, 3.5, 5.0]);
        assert_eq!([axis.count(0.9), axis.count(2.4), axis.count(2.5)], [1, 2, 3]);
        let without = Axis { block: 0, ..axis };
        assert_eq!((without.offset(4, 5), without.count(3.0)), (4.0, 4));
    }

    #[test]
    fn halves_are_alike_with_an_aisle_in_the_middle() {
        let axis = Axis { interval: 1.0, block: 2, aisle: 0.5, is_halved: true };
        assert_eq!([0, 1].map(|index| axis.offset(index, 2)), [0.0, 1.5]);
        assert_eq!([0, 1, 2, 3].map(|index| axis.offset(index, 4)), [0.0, 1.0, 2.5, 3.5]);
        assert_eq!([1.4, 1.5, 2.9, 3.5].map(|length| axis.count(length)), [1, 2, 2, 4]);
        for count in [2, 4, 6, 8] {
            let at: Vec<f64> = (-3..count + 3).map(|index| axis.at(index, count as usize)).collect();
            let middle = axis.span(count as usize) / 2.0;
            let mirrored: Vec<f64> = at.iter().rev().map(|at| 2.0 * middle - at).collect();
            assert!(at.iter().zip(&mirrored).all(|(a, b)| (a - b).abs() < 1e-9), "{count}: {at:?}");
        }
        assert_eq!(columns_and_rows(9, [7, 9], Point::new(7.0, 9.0), 2)[0] % 2, 0);
        assert_eq!(columns_and_rows(9, [1, 9], Point::new(0.5, 9.0), 2), [1, 9], "too narrow for an aisle");
    }

    #[test]
    fn no_block_has_a_single_place_where_another_has_three() {
        let axis = Axis { interval: 1.0, block: 12, aisle: 1.0, is_halved: false };
        let places: Vec<f64> = (0..13).map(|index| axis.offset(index, 13)).collect();
        assert_eq!((places[6], places[7], places[12]), (6.0, 8.0, 13.0), "seven and six");
        for (count, most) in (1..60).flat_map(|count| (1..9).map(move |most| (count, most))) {
            let axis = Axis { block: most, ..axis };
            let mut sizes = vec![0; count];
            (0..count).for_each(|index| sizes[axis.aisles_before(index, count)] += 1);
            sizes.retain(|&size| size > 0);
            let (least, largest) = (*sizes.iter().min().unwrap(), *sizes.iter().max().unwrap());
            assert_eq!(sizes.len(), count.div_ceil(most), "as few aisles as with full blocks");
            assert!(largest <= most && largest - least <= 1, "{count} {most}: {sizes:?}");
        }
    }

    #[test]
    fn six_lamps_in_a_wide_room_make_three_by_two() {
        assert_eq!(columns_and_rows(6, [3, 3], Point::new(2.8, 2.3), 1), [3, 2]);
    }

    #[test]
    fn more_than_fit_takes_all_there_is() {
        assert_eq!(columns_and_rows(100, [3, 4], Point::new(2.0, 3.0), 1), [3, 4]);
    }

    #[test]
    fn thirty_six_in_a_hall_make_a_square() {
        assert_eq!(columns_and_rows(36, [8, 7], Point::new(7.5, 6.5), 1), [6, 6]);
    }

    #[test]
    fn lamps_are_counted_up_or_down_to_full_rows() {
        let grid = Grid {
            interval: Point::splat(2.2),
            block: [0, 0],
            aisle: 0.0,
            is_centered: true,
            is_halved: false,
            is_back_to_back: false,
            margin: [0.0; 4],
        };
        let number = |wanted: u32, x: f64, y: f64| full_number(wanted, &grid, Point::new(x, y));
        // Eight would hang in three rows of three, with a gap.
        assert_eq!([5, 7, 8, 11].map(|wanted| number(wanted, 7.0, 6.6)), [6, 6, 9, 12]);
        assert_eq!(number(5, 12.0, 1.5), 5, "in a row");
        assert_eq!(number(5, 4.4, 2.2), 6);
        assert_eq!(
            (number(13, 4.4, 4.4), number(1, 0.1, 0.1), number(0, 4.0, 4.0)),
            (9, 1, 0),
            "no more than fit"
        );
    }
}
