//! Skirting boards: what covers the seam between floor and walls.

use glam::Vec3;

use super::solid::Solid;
use super::ticks::{Ticks, point_in_ticks};
use crate::geometry::Point;
use crate::plan::{Wall, WallKind};
use crate::recipes::Slot;

/// The boards of a room, in plan axes relative to the node that carries them.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SkirtingShape {
    /// Straight boards.
    pub boards: Vec<Board>,
    /// Material.
    pub slot: Slot,
}

/// The footprint of one board.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Board {
    /// At the wall, from its start to its end.
    pub back: [[Ticks; 2]; 2],
    /// In the room.
    pub front: [[Ticks; 2]; 2],
}

/// Metres that boards stand out of the wall. Furniture stands at the very wall: its back legs may stand on as much of
/// the board, which is less than the gap that real furniture keeps.
const DEPTH: f64 = 0.012;
/// Height of the boards.
pub(crate) const HEIGHT: Ticks = Ticks(7_000);
/// Height and depth of the chamfer along the upper edge, as a share of the depth.
const CHAMFER: (Ticks, f64) = (Ticks(600), 0.5);
/// Metres of wall that are too short for a board.
const SHORTEST: f64 = 0.03;
/// How far a mitre may reach, in depths: sharper corners are cut.
const MITRE_LIMIT: f64 = 2.5;

impl SkirtingShape {
    /// The boards along the walls of a ring or several, with a gap for each of `gaps` of a wall: metres from its start.
    pub(crate) fn along(
        walls: &[Wall],
        gaps: impl Fn(usize) -> Vec<(f64, f64)>,
        anchor: Point,
        slot: Slot,
    ) -> Self {
        let mut boards = Vec::new();
        for (index, wall) in walls.iter().enumerate().filter(|(_, wall)| wall.kind == WallKind::Solid) {
            let [start, end] = mitres(wall, walls);
            let (direction, normal, length) = (wall.direction(), wall.normal(), wall.length());
            for (from, to) in between(gaps(index), length) {
                // Only the ends of the wall are mitred.
                let front_from = if from > 0.0 { from } else { start };
                let front_to = if to < length { to } else { length - end };
                if to - from < SHORTEST || front_to - front_from < SHORTEST {
                    continue;
                }
                let at = |along: f64, depth: f64| {
                    point_in_ticks(wall.start + direction * along + normal * depth, anchor)
                };
                let back = [at(from, 0.0), at(to, 0.0)];
                boards.push(Board { back, front: [at(front_from, DEPTH), at(front_to, DEPTH)] });
            }
        }
        Self { boards, slot }
    }

    /// The closed bodies, sixteen triangles each.
    pub(crate) fn build(&self) -> Solid {
        let mut solid = Solid::new(self.slot);
        self.boards.iter().for_each(|board| board.build(&mut solid));
        solid
    }
}

impl Board {
    fn build(&self, solid: &mut Solid) {
        let (chamfer, share) = CHAMFER;
        let at = |[x, y]: [f32; 2], height: Ticks| Vec3::new(x, height.narrow(), -y);
        let narrow = |point: [Ticks; 2]| point.map(Ticks::narrow);
        // The section at either end: foot at the wall, foot in the room, chamfer, top in the room, top at the wall.
        let section = |end: usize| {
            let (back, front) = (narrow(self.back[end]), narrow(self.front[end]));
            let edge = [0, 1].map(|axis| back[axis] + (front[axis] - back[axis]) * share as f32);
            let zero = Ticks(0);
            [at(back, zero), at(front, zero), at(front, HEIGHT - chamfer), at(edge, HEIGHT), at(back, HEIGHT)]
        };
        let (start, end) = (section(0), section(1));
        for corner in 0..start.len() {
            let next = (corner + 1) % start.len();
            solid.face(&[start[next], end[next], end[corner], start[corner]]);
        }
        solid.face(&[start[4], start[3], start[2], start[1], start[0]]);
        solid.face(&end);
    }
}

/// How far the front of a board stops short of both ends of its wall, to meet the next board; below zero where it
/// reaches round a corner that points into the room.
fn mitres(wall: &Wall, walls: &[Wall]) -> [f64; 2] {
    let is_solid = |other: &&Wall| other.kind == WallKind::Solid;
    let before = walls.iter().filter(is_solid).find(|other| other.end == wall.start);
    let after = walls.iter().filter(is_solid).find(|other| other.start == wall.end);
    let short = |before: Point, after: Point| {
        let half_turn = before.perp_dot(after) / (1.0 + before.dot(after)).max(f64::EPSILON);
        DEPTH * half_turn.clamp(-MITRE_LIMIT, MITRE_LIMIT)
    };
    [
        before.map_or(0.0, |before| short(before.direction(), wall.direction())),
        after.map_or(0.0, |after| short(wall.direction(), after.direction())),
    ]
}

/// The stretches of a wall between gaps.
pub(super) fn between(mut gaps: Vec<(f64, f64)>, length: f64) -> Vec<(f64, f64)> {
    gaps.sort_by(|one, two| one.0.total_cmp(&two.0));
    let mut kept = Vec::with_capacity(gaps.len() + 1);
    let mut start = 0.0;
    for (from, to) in gaps {
        kept.push((start, from.min(length)));
        start = to.max(start);
    }
    kept.push((start, length));
    kept.retain(|(from, to)| from < to);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];

    fn boards(walls: &[Wall], gap: Option<(f64, f64)>) -> Vec<Board> {
        let gaps = |index: usize| if index == 0 { gap.into_iter().collect() } else { Vec::new() };
        SkirtingShape::along(walls, gaps, Point::ZERO, Slot::Painted).boards
    }

    #[test]
    fn boards_meet_at_corners_and_stop_at_doors() {
        let whole = boards(&Wall::around(&SQUARE), None);
        assert_eq!(whole.len(), 4);
        assert_eq!(whole[0].front[0], [Ticks(1_200), Ticks(1_200)]);
        assert_eq!(whole[0].front[0], whole[3].front[1], "both end at the same point");
        let broken = boards(&Wall::around(&SQUARE), Some((1.0, 2.0)));
        assert_eq!(broken.len(), 5);
        assert_eq!(broken[0].front[1], [Ticks(100_000), Ticks(1_200)], "square at a door");
        assert_eq!(broken[1].back[0], [Ticks(200_000), Ticks(0)]);
    }

    #[test]
    fn a_corner_that_points_into_the_room_is_reached_round() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)];
        let boards = boards(&Wall::around(&corners), None);
        assert_eq!(boards[2].front[1], [Ticks(198_800), Ticks(198_800)]);
        assert_eq!(boards[3].front[0], boards[2].front[1]);
    }

    #[test]
    fn railings_have_no_skirting() {
        let mut walls = Wall::around(&SQUARE);
        walls[1].kind = WallKind::Railing(1.0);
        let boards = boards(&walls, None);
        assert_eq!(boards.len(), 3);
        assert_eq!(boards[0].front[1], [Ticks(400_000), Ticks(1_200)], "square at the railing");
    }

    #[test]
    fn a_board_has_sixteen_triangles() {
        let shape = SkirtingShape::along(&Wall::around(&SQUARE), |_| Vec::new(), Point::ZERO, Slot::Painted);
        assert_eq!(shape.build().finish().indices.len(), 4 * 16 * 3);
    }
}
