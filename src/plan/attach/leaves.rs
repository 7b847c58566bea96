//! Gives doors their leaves: as drawn, as described, or chosen.

use crate::geometry::Point;
use crate::plan::{Leaf, LeafDraft, Opening, OpeningKind, Room};

/// Hinged doors wider than this many metres get two leaves where the plan does not count them.
const WIDEST_SINGLE_LEAF: f64 = 1.4;
/// Radians that a leaf opens where nothing is said.
const USUAL_ANGLE: f64 = std::f64::consts::FRAC_PI_2;
/// Radians of the least and the largest angle that is believed.
const ANGLES: (f64, f64) = (0.2, std::f64::consts::PI);
/// Places on the swing, as shares of its angle and radius, that must be free floor.
const SWING_SAMPLES: [(f64, f64); 5] = [(0.25, 0.95), (0.5, 0.95), (0.75, 0.95), (1.0, 0.95), (1.0, 0.5)];
/// Squares of a leaf's width in the least room that a leaf opens into, where it may open the other way: what it sweeps is a fifth of
/// that floor, and in a toilet there is no place for the basin or for who closes the door. Larger: doors of bathrooms that have room
/// for them stand in corridors.
const LEAST_FLOOR: f64 = 3.75;
/// Room types that a leaf should not stand in.
const WALKED_ROOM_TYPES: [&str; 8] =
    ["corridor", "hallway", "hall", "lobby", "staircase", "stairs", "walkway", "elevator"];

/// One face of the wall as the leaf sees it that opens to this side.
#[derive(Clone, Copy, Debug)]
struct Frame {
    /// The ends of the opening in this face, left and right as seen from this side.
    left: Point,
    right: Point,
    /// Unit vector to this side.
    into: Point,
    /// The room on this side; open air if `None`.
    room: Option<usize>,
    /// Metres from the left and the right end to the wall's corner there.
    to_corner: [f64; 2],
}

/// The leaves of a hinged door; none for anything else.
///
/// A leaf hangs in the face of the wall on the side to which it opens. Drawn leaves keep their hinge's end, side
/// and angle; their length follows the opening, and a leaf too wide to be one becomes two.
pub(in crate::plan) fn hang_leaves(opening: &Opening, rooms: &[Room], draft: &LeafDraft) -> Vec<Leaf> {
    if opening.kind != OpeningKind::Door {
        return Vec::new();
    }
    let frames = frames(opening, rooms);
    match draft {
        LeafDraft::None => Vec::new(),
        LeafDraft::Automatic => automatic(&frames, rooms),
        LeafDraft::Points(drawn) => as_drawn(&frames, drawn).unwrap_or_else(|| automatic(&frames, rooms)),
        LeafDraft::Swing { hinge_left, into, count, angle } => {
            let frame = frames.iter().find(|frame| frame.room.map(|room| &rooms[room].id) == into.as_ref());
            let angle = if angle.is_finite() { angle.clamp(ANGLES.0, ANGLES.1) } else { USUAL_ANGLE };
            frame.map_or_else(|| automatic(&frames, rooms), |frame| frame.leaves(*hinge_left, *count, angle))
        }
    }
}

fn frames(opening: &Opening, rooms: &[Room]) -> [Frame; 2] {
    let first = frame_of(opening, rooms, 0);
    let second = if opening.sides.len() > 1 {
        frame_of(opening, rooms, 1)
    } else {
        let side = opening.sides[0];
        let behind = -first.into * rooms[side.room].walls[side.wall].thickness;
        Frame {
            left: first.right + behind,
            right: first.left + behind,
            into: -first.into,
            room: None,
            to_corner: [first.to_corner[1], first.to_corner[0]],
        }
    };
    [first, second]
}

fn frame_of(opening: &Opening, rooms: &[Room], number: usize) -> Frame {
    let side = opening.sides[number];
    let wall = &rooms[side.room].walls[side.wall];
    Frame {
        // Looking out at a wall whose room is on its left, the wall runs to the left.
        left: wall.after(side.to),
        right: wall.after(side.from),
        into: wall.normal(),
        room: Some(side.room),
        to_corner: [wall.length() - side.to, side.from],
    }
}

impl Frame {
    fn leaves(&self, hinge_left: bool, count: u32, angle: f64) -> Vec<Leaf> {
        let middle = self.left.midpoint(self.right);
        match (count, hinge_left) {
            (0, _) => Vec::new(),
            (1, true) => vec![self.leaf(self.left, self.right, angle)],
            (1, false) => vec![self.leaf(self.right, self.left, angle)],
            _ => vec![self.leaf(self.left, middle, angle), self.leaf(self.right, middle, angle)],
        }
    }

    fn leaf(&self, hinge: Point, closed_tip: Point, angle: f64) -> Leaf {
        Leaf { hinge, closed_tip, open_tip: hinge + self.swing(closed_tip - hinge, angle) }
    }

    /// A vector along the wall turned towards this side.
    fn swing(&self, along: Point, angle: f64) -> Point {
        let (sine, cosine) = libm::sincos(angle);
        along * cosine + self.into * (along.length() * sine)
    }
}

fn as_drawn(frames: &[Frame; 2], drawn: &[Leaf]) -> Option<Vec<Leaf>> {
    let first = drawn.first()?;
    let (closed, open) = (first.closed_tip - first.hinge, first.open_tip - first.hinge);
    if !(closed.is_finite() && open.is_finite()) || closed == Point::ZERO || open == Point::ZERO {
        return None;
    }
    let frame = frames.iter().max_by(|a, b| open.dot(a.into).total_cmp(&open.dot(b.into)))?;
    let hinge_left = closed.dot(frame.right - frame.left) > 0.0;
    let angle = libm::atan2(closed.perp_dot(open).abs(), closed.dot(open)).clamp(ANGLES.0, ANGLES.1);
    // Drawings show one sweep for a double door too; no leaf is that wide.
    let is_double = drawn.len() > 1 || frame.left.distance(frame.right) > WIDEST_SINGLE_LEAF;
    Some(frame.leaves(hinge_left, if is_double { 2 } else { 1 }, angle))
}

/// How little a way to hang a leaf is liked: places blocked, whether it takes the room's floor, whether people walk there, square
/// metres of the room, metres to the corner.
type Rank = (u32, bool, bool, f64, f64);

/// Opens into the room that is no corridor, out of rooms that are all door, with the hinge at the end nearer a corner, where the
/// swing is free.
fn automatic(frames: &[Frame; 2], rooms: &[Room]) -> Vec<Leaf> {
    let width = frames[0].left.distance(frames[0].right);
    let count = if width > WIDEST_SINGLE_LEAF { 2 } else { 1 };
    let mut best: Option<(Rank, Vec<Leaf>)> = None;
    for frame in frames {
        for (end, hinge_left) in [true, false].into_iter().enumerate() {
            let leaves = frame.leaves(hinge_left, count, USUAL_ANGLE);
            let room = frame.room.map(|room| &rooms[room]);
            let blocked = leaves.iter().map(|leaf| blocked_samples(frame, leaf, room)).sum();
            let is_walked = room.is_none_or(|room| WALKED_ROOM_TYPES.contains(&room.room_type.as_str()));
            let area = room.map_or(f64::INFINITY, |room| room.region.area());
            let is_cramped = area < LEAST_FLOOR * (width / f64::from(count)).powi(2);
            let rank = (blocked, is_cramped, is_walked, area, frame.to_corner[end]);
            let is_better =
                best.as_ref().is_none_or(|(least, _)| rank.partial_cmp(least).is_some_and(|o| o.is_lt()));
            if is_better {
                best = Some((rank, leaves));
            }
        }
    }
    best.map(|(_, leaves)| leaves).unwrap_or_default()
}

fn blocked_samples(frame: &Frame, leaf: &Leaf, room: Option<&Room>) -> u32 {
    let Some(room) = room else { return 0 };
    let closed = leaf.closed_tip - leaf.hinge;
    let is_blocked = |&&(turn, radius): &&(f64, f64)| {
        let point = leaf.hinge + frame.swing(closed * radius, USUAL_ANGLE * turn);
        let is_in_column = room.obstacles.iter().any(|obstacle| obstacle.outline.contains(point));
        // A hair inside the room: a leaf along the wall touches it.
        let point = point + (leaf.closed_tip - point) * 0.01;
        is_in_column || !room.region.contains(point)
    };
    SWING_SAMPLES.iter().filter(is_blocked).count() as u32
}
