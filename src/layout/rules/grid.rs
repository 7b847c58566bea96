//! Regular interval layouts (section 3.3): lamps in rows, tables in a hall, desks in a classroom.
//!
//! The paper's agents look for neighbours of their own class and continue their pattern. Here the pattern is
//! worked out from the room and the number of agents of the class, which gives every agent the same lattice
//! without reading the others' positions.

use crate::catalog::Grid;
use crate::geometry::Point;
use crate::layout::body::Pose;
use crate::layout::seed::{Purpose, RoomKey};

use super::View;
use super::floor::elevation;
use super::turn::{self, Bearing};

/// Added before rounding down, so that a length of exactly n intervals counts n.
const ROUNDING: f64 = 1e-9;

/// Poses on the lattice of the agent's class, starting with the first that no neighbour holds.
pub(super) fn propose(view: &View<'_>, grid: &Grid, key: &RoomKey, poses: &mut Vec<Pose>) {
    let surroundings = &view.environment.surroundings;
    // One stream for the class: all its agents must agree on the lattice.
    let mut stream = key.stream(Purpose::Placement, &view.class.id, 0);
    let bearing = Bearing { parent_angle: surroundings.main_angle, outward: Point::ZERO };
    let angle = turn::angle(&view.rule.orientation, &bearing, &mut stream);
    let frame = Pose::new(Point::ZERO, 0.0, surroundings.main_angle);
    let (low, high) = extent(view, &frame);
    let margin = Point::new(view.size.width, view.size.depth) / 2.0;
    let room = (high - low - 2.0 * margin).max(Point::ZERO);
    let intervals = room / grid.interval + Point::splat(ROUNDING);
    let agents = &view.environment.agents;
    let class = agents[view.agent].piece.class;
    let wanted = agents.iter().filter(|agent| agent.piece.class == class).count();
    let counts = lattice(wanted, [intervals.x as usize + 1, intervals.y as usize + 1], intervals);
    let span = Point::new((counts[0] - 1) as f64, (counts[1] - 1) as f64) * grid.interval;
    let slack = (room - span).max(Point::ZERO);
    let share = if grid.is_centered { Point::splat(0.5) } else { Point::new(stream.unit(), stream.unit()) };
    let first = low + margin + slack * share;
    let mut add = |point: Point| poses.push(Pose::new(frame.turn(point), elevation(view), angle));
    let total = counts[0] * counts[1];
    let resting = view.environment.resting[class].len();
    for slot in (0..total).map(|index| (index + resting) % total) {
        add(first + Point::new((slot % counts[0]) as f64, (slot / counts[0]) as f64) * grid.interval);
    }
    add_outside((first, span), (low + margin, high - margin), grid, add);
}

/// Lattice points outside the chosen block, for agents whose slot is taken by a column or a door.
fn add_outside(
    (first, span): (Point, Point),
    (low, high): (Point, Point),
    grid: &Grid,
    mut add: impl FnMut(Point),
) {
    let steps =
        |length: Point| (length / grid.interval + Point::splat(ROUNDING)).max(Point::ZERO).as_i64vec2();
    let (before, after, last) = (steps(first - low), steps(high - first), steps(span));
    for row in -before.y..=after.y {
        for column in -before.x..=after.x {
            let is_in_block = (0..=last.x).contains(&column) && (0..=last.y).contains(&row);
            if !is_in_block {
                add(first + Point::new(column as f64, row as f64) * grid.interval);
            }
        }
    }
}

/// Bounding box of the room in the frame of its longest wall.
fn extent(view: &View<'_>, frame: &Pose) -> (Point, Point) {
    let corners = view.environment.surroundings.room.region.outline.corners();
    let local = |corner: &Point| Point::new(corner.dot(frame.right), corner.dot(frame.right.perp()));
    let first = local(&corners[0]);
    corners.iter().map(local).fold((first, first), |(low, high), point| (low.min(point), high.max(point)))
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
}
