//! Rounds lengths as native plans write them, so that an imported home is furnished as the home itself.

use crate::geometry::Point;
use crate::plan::{LeafDraft, LevelDraft, OpeningPlace};

/// Steps of a metre, those of `write_native`.
const STEPS: f64 = 1e5;

fn rounded(length: f64) -> f64 {
    // Adding zero makes negative zero zero.
    (length * STEPS).round() / STEPS + 0.0
}

fn point(point: Point) -> Point {
    Point::new(rounded(point.x), rounded(point.y))
}

fn ring(ring: &mut [Point]) {
    ring.iter_mut().for_each(|corner| *corner = point(*corner));
}

/// Rounds all lengths of a level.
pub(super) fn round_lengths(level: &mut LevelDraft) {
    let lengths = [
        &mut level.elevation,
        &mut level.height,
        &mut level.exterior_thickness,
        &mut level.interior_thickness,
    ];
    lengths.into_iter().for_each(|length| *length = rounded(*length));
    for room in &mut level.rooms {
        ring(&mut room.outline);
        room.holes.iter_mut().for_each(|hole| ring(hole));
        room.height = room.height.map(rounded);
    }
    for opening in &mut level.openings {
        if let OpeningPlace::Points { center, along } = &mut opening.place {
            *center = point(*center);
            *along = along.map(point);
        }
        for length in [&mut opening.width, &mut opening.bottom, &mut opening.top] {
            *length = rounded(*length);
        }
        if let LeafDraft::Points(leaves) = &mut opening.leaf {
            for end in
                leaves.iter_mut().flat_map(|leaf| [&mut leaf.hinge, &mut leaf.closed_tip, &mut leaf.open_tip])
            {
                *end = point(*end);
            }
        }
    }
    for obstacle in &mut level.obstacles {
        ring(&mut obstacle.outline);
        obstacle.height = obstacle.height.map(rounded);
    }
    level.railings.iter_mut().chain(&mut level.wall_outlines).for_each(|outline| ring(outline));
}
