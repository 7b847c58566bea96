//! Assigns columns to the rooms that they stand in.

use geo::BooleanOps;

use super::{Assembly, BoxIndex};
use crate::geometry::Polygon;
use crate::plan::clean::{clean_ring, to_polygon, to_surface};
use crate::plan::{Obstacle, Problem, Room, Subject};

/// Pieces of a column below this many square metres are no obstacle.
const SMALLEST_PIECE: f64 = 1e-4;

/// Gives each room the pieces of columns inside its region.
pub(super) fn place_obstacles(assembly: &mut Assembly<'_>) {
    let draft = assembly.draft;
    let index = BoxIndex::of(assembly.rooms.iter().map(|room| room.region.outline.bounds()).zip(0..));
    for (number, obstacle) in draft.obstacles.iter().enumerate() {
        let subject = Subject::Obstacle(number);
        let outline = match clean_ring(&obstacle.outline, &[]).map(|ring| ring.polygon) {
            Ok(outline) => outline,
            Err(fault) => {
                let message = format!("column {number}: {fault}");
                assembly.problems.push(Problem::error(
                    subject,
                    message,
                    Some("its footprint is a simple polygon"),
                ));
                continue;
            }
        };
        let height = obstacle.height.unwrap_or(f64::INFINITY);
        if height.is_nan() || height <= 0.0 {
            let message = format!("column {number} is {height} m high");
            assembly.problems.push(Problem::error(subject, message, None));
            continue;
        }
        let mut is_inside = false;
        for room in index.near(outline.bounds()) {
            let room = &mut assembly.rooms[room];
            for piece in pieces(&outline, room) {
                is_inside = true;
                room.obstacles.push(Obstacle { outline: piece, height: height.min(room.height) });
            }
        }
        if !is_inside {
            let message = format!("column {number} stands in no room");
            assembly.problems.push(Problem::warning(subject, message, None));
        }
    }
}

fn pieces(outline: &Polygon, room: &Room) -> Vec<Polygon> {
    let surface = to_surface(&room.region.outline, &room.region.holes);
    let inside = surface.intersection(&to_surface(outline, &[]));
    inside.0.iter().filter_map(to_polygon).filter(|piece| piece.area() >= SMALLEST_PIECE).collect()
}
