//! Moves what lies far from the origin, as in the coordinates of a country, in which millimetres are lost when they are written.

use crate::geometry::{Bounds, Point};
use crate::plan::{LeafDraft, LevelDraft, OpeningPlace};

/// Metres from the origin beyond which something is moved there.
const FARTHEST: f64 = 10_000.0;

/// By how many whole metres rooms are moved to the origin: none where one stands near.
pub(super) fn recentring<'a>(levels: impl IntoIterator<Item = &'a LevelDraft>) -> Point {
    let rooms = levels.into_iter().flat_map(|level| &level.rooms);
    let Bounds { low, .. } = Bounds::around(rooms.flat_map(|room| &room.outline).copied());
    let is_far = low.is_finite() && low.abs().max_element() > FARTHEST;
    if is_far { -low.floor() } else { Point::ZERO }
}

/// Moves everything on a level.
pub(super) fn shift(level: &mut LevelDraft, by: Point) {
    let mut ring = |ring: &mut Vec<Point>| ring.iter_mut().for_each(|corner| *corner += by);
    for room in &mut level.rooms {
        ring(&mut room.outline);
        room.holes.iter_mut().for_each(&mut ring);
    }
    level.obstacles.iter_mut().for_each(|obstacle| ring(&mut obstacle.outline));
    level.railings.iter_mut().chain(&mut level.wall_outlines).for_each(&mut ring);
    for opening in &mut level.openings {
        if let OpeningPlace::Points { center, .. } = &mut opening.place {
            *center += by;
        }
        if let LeafDraft::Points(leaves) = &mut opening.leaf {
            for leaf in leaves {
                [&mut leaf.hinge, &mut leaf.closed_tip, &mut leaf.open_tip]
                    .into_iter()
                    .for_each(|at| *at += by);
            }
        }
    }
}
