//! Regular interval layouts (section 3.3): lamps in rows, tables in a hall, desks in a classroom.
//!
//! The paper's agents look for neighbours of their own class and continue their pattern. Here the pattern is
//! worked out from the room and the number of agents of the class, which gives every agent the same lattice
//! without reading the others' positions.

use core::f64::consts::PI;

use crate::catalog::{Clearance, Grid, Side, Turn};
use crate::geometry::{Bounds, Point};
use crate::layout::body::Pose;
use crate::layout::seed::{Purpose, RoomKey, Stream};

use super::View;
use super::floor::elevation;
use super::relation::best_quarter;
use super::turn::{self, Bearing};

/// Added before rounding down, so that a length of exactly n intervals counts n.
const ROUNDING: f64 = 1e-9;

/// Poses on the lattice of the agent's class, starting with the first that no neighbour holds.
pub(super) fn propose(view: &View<'_>, grid: &Grid, key: &RoomKey, poses: &mut Vec<Pose>) {
    // One stream for the class: all its agents must agree on the lattice.
    let mut stream = key.stream(Purpose::Placement, &view.class.id, 0);
    let angle = angle(view, &mut stream);
    // Rows and aisles go by the side of the pieces, not by the walls: pupils sit beside each other.
    let frame = Pose::new(Point::ZERO, 0.0, angle);
    let bounds = within_margins(view, grid, extent(view, &frame));
    let axes = [Axis::new(grid, 0), Axis::new(grid, 1)];
    let agents = &view.environment.agents;
    let class = agents[view.agent].piece.class;
    let members = members(view, grid);
    let wanted = agents.iter().filter(|agent| agent.piece.class == class).count().div_ceil(members.len());
    let frame_room = |margins: &Margins| (bounds.size() - margins.low - margins.high).max(Point::ZERO);
    let most_in = |room: Point| [axes[0].count(room.x), axes[1].count(room.y)];
    let has_places = |margins: &Margins| most_in(frame_room(margins)).iter().product::<usize>() >= wanted;
    // At the walls the good clearances if the lattice then has places for all, else the smallest, else none.
    let depths: [fn(&Clearance) -> f64; 3] =
        [|clearance| clearance.good, |clearance| clearance.minimum, |_| 0.0];
    let margins = depths.map(|depth| Margins::new(view, grid, depth));
    let margins = margins.iter().find(|margins| has_places(margins)).unwrap_or(&margins[2]);
    let room = frame_room(margins);
    let most = most_in(room);
    let counts = lattice(wanted, most, room / grid.interval);
    let span = Point::new(axes[0].span(counts[0]), axes[1].span(counts[1]));
    let slack = (room - span).max(Point::ZERO);
    let share = if grid.is_centered { Point::splat(0.5) } else { Point::new(stream.unit(), stream.unit()) };
    let first = bounds.low + margins.low + slack * share;
    let mut add = |point: Point, member: &Member| {
        let position = frame.turn(point + member.offset);
        poses.push(Pose::new(position, elevation(view), angle + member.turn));
    };
    let total = counts[0] * counts[1] * members.len();
    let resting = view.environment.resting[class].len();
    // Each agent begins behind those that rest, where its own slot is usually free.
    for slot in (0..total).map(|index| (index + resting) % total) {
        let (place, member) = (slot / members.len(), &members[slot % members.len()]);
        let at = [place % counts[0], place / counts[0]];
        let at = Point::new(axes[0].offset(at[0], counts[0]), axes[1].offset(at[1], counts[1]));
        add(first + at, member);
    }
    let half = half_of_place(view, grid);
    let middles = Bounds::new(bounds.low + half, bounds.high - half);
    add_outside(Block { first, counts }, middles, &axes, |point| {
        members.iter().for_each(|member| add(point, member));
    });
}

/// The agent at a place of the lattice.
struct Member {
    /// From the place, in the frame of the lattice.
    offset: Point,
    /// Radians beyond the angle of the lattice.
    turn: f64,
}

/// One at each place, or two whose backs meet there.
fn members(view: &View<'_>, grid: &Grid) -> Vec<Member> {
    let back = Point::new(0.0, view.size.depth / 2.0);
    match grid.is_back_to_back {
        true => vec![Member { offset: -back, turn: 0.0 }, Member { offset: back, turn: PI }],
        false => vec![Member { offset: Point::ZERO, turn: 0.0 }],
    }
}

/// Half of the width and depth that the members of a place take.
fn half_of_place(view: &View<'_>, grid: &Grid) -> Point {
    let depths = if grid.is_back_to_back { 2.0 } else { 1.0 };
    Point::new(view.size.width, depths * view.size.depth) / 2.0
}

/// How far the middles of the outermost places keep from the ends of the room.
struct Margins {
    low: Point,
    high: Point,
}

impl Margins {
    /// Half of what stands at a place, and a depth of the clearances on the side that meets the wall.
    fn new(view: &View<'_>, grid: &Grid, depth: impl Fn(&Clearance) -> f64) -> Self {
        let half = half_of_place(view, grid);
        let clearances = view.class.clearances.iter();
        let deepest =
            |side: Side| clearances.clone().filter(|c| c.side == side).map(&depth).fold(0.0, f64::max);
        let low = Point::new(deepest(Side::Left), deepest(Side::Front));
        let high = Point::new(deepest(Side::Right), deepest(Side::Back));
        if grid.is_back_to_back {
            // Each end meets the front of somebody.
            let both = Point::new(low.x.max(high.x), low.y);
            return Self { low: half + both, high: half + both };
        }
        Self { low: half + low, high: half + high }
    }
}

/// The angle of all agents of the class: towards what they want to face, where it is in the room, else as the
/// rule says.
fn angle(view: &View<'_>, stream: &mut Stream) -> f64 {
    let surroundings = &view.environment.brief.surroundings;
    let bearing = Bearing { parent_angle: surroundings.main_angle, outward: Point::ZERO };
    let drawn = turn::angle(&view.rule.orientation, &bearing, stream);
    if view.rule.orientation.turn != Turn::Quarter {
        return drawn;
    }
    let middle = surroundings.room.region.outline.bounds().center();
    best_quarter(view.environment, &view.class.relations, middle, surroundings.main_angle).unwrap_or(drawn)
}

/// One direction of a lattice: regular intervals, and aisles between blocks of as many places, or of one less.
///
/// ```text
///  o--o--o----o--o----o--o     seven places, three at most in a block
/// ```
#[derive(Clone, Copy, Debug)]
struct Axis {
    interval: f64,
    block: usize,
    aisle: f64,
}

impl Axis {
    fn new(grid: &Grid, axis: usize) -> Self {
        Self { interval: grid.interval[axis], block: grid.block[axis] as usize, aisle: grid.aisle }
    }

    /// Metres from the first of so many places to another; places behind the last go on in the same way.
    fn offset(&self, index: usize, count: usize) -> f64 {
        index as f64 * self.interval + self.aisles_before(index, count) as f64 * self.aisle
    }

    /// Metres from the first of so many places to the last.
    fn span(&self, count: usize) -> f64 {
        self.offset(count.max(1) - 1, count)
    }

    /// Aisles before a place. The first blocks are the larger ones.
    fn aisles_before(&self, index: usize, count: usize) -> usize {
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
    fn count(&self, length: f64) -> usize {
        let most = (length / self.interval + ROUNDING).max(0.0) as usize + 1;
        (1..=most).rev().find(|&count| self.span(count) <= length + ROUNDING).unwrap_or(1)
    }
}

/// The part of the room inside the margins of a grid. Along an axis where no piece would fit, the margins are dropped.
fn within_margins(view: &View<'_>, grid: &Grid, room: Bounds) -> Bounds {
    let [left, front, right, back] = grid.margin;
    let inner = Bounds::new(room.low + Point::new(left, front), room.high - Point::new(right, back));
    let fits = inner.size().cmpge(2.0 * half_of_place(view, grid));
    Bounds::new(Point::select(fits, inner.low, room.low), Point::select(fits, inner.high, room.high))
}

/// The places of a lattice that its agents take.
struct Block {
    /// The first place, in the frame of the lattice.
    first: Point,
    /// Columns and rows.
    counts: [usize; 2],
}

/// Lattice points of an area outside the chosen block, for agents whose slot is taken by a column or a door.
fn add_outside(block: Block, area: Bounds, axes: &[Axis; 2], mut add: impl FnMut(Point)) {
    let (Block { first, counts }, Bounds { low, high }) = (block, area);
    let steps = |length: f64, axis: usize| (length / axes[axis].interval + ROUNDING).max(0.0) as i64;
    let before = [steps(first.x - low.x, 0), steps(first.y - low.y, 1)];
    let after = [axes[0].count(high.x - first.x) as i64, axes[1].count(high.y - first.y) as i64];
    // Before the first place there are no aisles: what stands there has lost its block anyway.
    let at = |axis: usize, index: i64| match usize::try_from(index) {
        Ok(index) => axes[axis].offset(index, counts[axis]),
        Err(_) => index as f64 * axes[axis].interval,
    };
    for row in -before[1]..after[1] {
        for column in -before[0]..after[0] {
            let is_in_block = |index: i64, count: usize| (0..count as i64).contains(&index);
            if !(is_in_block(column, counts[0]) && is_in_block(row, counts[1])) {
                add(first + Point::new(at(0, column), at(1, row)));
            }
        }
    }
}

/// Bounding box of the room in the frame of its longest wall.
fn extent(view: &View<'_>, frame: &Pose) -> Bounds {
    let corners = view.environment.brief.surroundings.room.region.outline.corners();
    let local = |corner: &Point| Point::new(corner.dot(frame.right), corner.dot(frame.right.perp()));
    Bounds::around(corners.iter().map(local))
}

/// Columns and rows for `wanted` places: enough, few empty, and filling both directions alike. `most` bounds
/// both; `intervals` is how many fit into each direction.
fn lattice(wanted: usize, most: [usize; 2], intervals: Point) -> [usize; 2] {
    let mut best = (f64::INFINITY, most);
    for columns in 1..=most[0] {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Count, Untidiness};
    use crate::layout::tests::{catalog, level, run};

    #[test]
    fn an_aisle_follows_each_block() {
        let axis = Axis { interval: 1.0, block: 2, aisle: 0.5 };
        assert_eq!([0, 1, 2, 3, 4].map(|index| axis.offset(index, 5)), [0.0, 1.0, 2.5, 3.5, 5.0]);
        assert_eq!([axis.count(0.9), axis.count(2.4), axis.count(2.5)], [1, 2, 3]);
        let without = Axis { block: 0, ..axis };
        assert_eq!((without.offset(4, 5), without.count(3.0)), (4.0, 4));
    }

    #[test]
    fn no_block_has_a_single_place_where_another_has_three() {
        let axis = Axis { interval: 1.0, block: 12, aisle: 1.0 };
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
        assert_eq!(lattice(6, [3, 3], Point::new(2.8, 2.3)), [3, 2]);
    }

    #[test]
    fn more_than_fit_takes_all_there_is() {
        assert_eq!(lattice(100, [3, 4], Point::new(2.0, 3.0)), [3, 4]);
    }

    #[test]
    fn thirty_six_in_a_hall_make_a_square() {
        assert_eq!(lattice(36, [8, 7], Point::new(7.5, 6.5)), [6, 6]);
    }

    #[test]
    fn a_grid_keeps_its_margins_where_they_leave_something() {
        let level = level(&[(0.0, 0.0), (9.0, 0.0), (9.0, 8.0), (0.0, 8.0)]);
        let nearest_to_walls = |margin: [f64; 4]| {
            let mut catalog = catalog(&[(3, Count::Fill(100))], Untidiness::default());
            catalog.classes[3].grid.as_mut().expect("lights hang in a grid").margin = margin;
            let placements = run(&level, &catalog, 1).placements;
            let x = placements.iter().map(|one| one.position.x.min(9.0 - one.position.x));
            let y = placements.iter().map(|one| one.position.y.min(8.0 - one.position.y));
            (x.fold(f64::INFINITY, f64::min), y.fold(f64::INFINITY, f64::min))
        };
        let half = 0.3;
        let (x, y) = nearest_to_walls([1.5, 2.0, 1.5, 2.0]);
        assert!(x >= 1.5 + half - 1e-9 && y >= 2.0 + half - 1e-9, "{x} {y}");
        let (x, y) = nearest_to_walls([1.5, 4.0, 1.5, 4.0]);
        assert!(x >= 1.5 + half - 1e-9 && y < 2.0, "{x} {y}");
    }
}
