//! Names of rooms, each where its room is emptiest.

use crate::geometry::Point;
use crate::layout::{Furnished, Parent};
use crate::plan::Room;

use super::Drawing;
use super::canvas::{Canvas, TextStyle};
use super::furniture::LETTER_WIDTH;

/// Places per side that are compared for a room's name.
const RASTER: usize = 24;

/// Pixels of the letters of a room's name.
const NAME_SIZE: f64 = 13.0;

/// Pixels of the letters of a room's type and area.
const DETAIL_SIZE: f64 = 10.0;

/// Pixels of the smallest letters that are written at all.
const SMALLEST: f64 = 6.0;

/// Names all rooms: title or id, then type and square metres.
pub(crate) fn draw_labels(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    for (room, furnished) in drawing.level.rooms.iter().zip(drawing.furnished) {
        let at = emptiest_place(room, furnished);
        let name = room.name.as_deref().unwrap_or(&room.id);
        let room_type = drawing.catalog.room_types.get(&room.room_type);
        let room_type = room_type.map_or(room.room_type.as_str(), |found| &found.label);
        let line = Point::new(0.0, 0.6 * NAME_SIZE / canvas.scale());
        let style = TextStyle {
            size: NAME_SIZE,
            anchor: "middle",
            is_bold: true,
            has_halo: true,
            ..TextStyle::default()
        };
        let style = TextStyle { size: fitting(canvas, room, name).min(NAME_SIZE), ..style };
        canvas.text(at + line, name, style);
        let detail = format!("{room_type}, {:.1} m²", room.region.area());
        let size = fitting(canvas, room, &detail).min(DETAIL_SIZE);
        let style = TextStyle { size, is_bold: false, color: "#555", ..style };
        if size >= SMALLEST {
            canvas.text(at - line, &detail, style);
        }
    }
}

/// Pixels of the largest letters with which a text fits into the room's width.
fn fitting(canvas: &Canvas, room: &Room, text: &str) -> f64 {
    let (low, high) = room.region.outline.bounds();
    (high.x - low.x) * canvas.scale() / (text.chars().count().max(1) as f64 * LETTER_WIDTH)
}

/// The place of a raster over the room that is farthest from walls and furniture.
fn emptiest_place(room: &Room, furnished: &Furnished) -> Point {
    let (low, high) = room.region.outline.bounds();
    let step = (high - low) / RASTER as f64;
    let at =
        |index: usize| low + step * Point::new((index % RASTER) as f64 + 0.5, (index / RASTER) as f64 + 0.5);
    let inside = (0..RASTER * RASTER).map(at).filter(|&point| room.region.contains(point));
    let best = inside.map(|point| (point, freedom(point, room, furnished)));
    // The first of equals: `max_by` would take the last.
    let best = best.reduce(|best, next| if next.1 > best.1 { next } else { best });
    best.map_or((low + high) / 2.0, |(point, _)| point)
}

/// Metres to the nearest wall or object; names are wide, so that metres to the side count less.
fn freedom(point: Point, room: &Room, furnished: &Furnished) -> f64 {
    const SIDEWAYS: Point = Point::new(0.5, 1.0);
    let to_wall = room.region.borders().map(|(start, end)| {
        let along = end - start;
        let share = ((point - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        ((start + along * share - point) * SIDEWAYS).length()
    });
    let standing = furnished.placements.iter().filter(|object| object.parent != Parent::Ceiling);
    let to_object = standing.map(|object| {
        let radius = (object.size.width + object.size.depth) / 4.0;
        ((object.position - point) * SIDEWAYS).length() - radius
    });
    to_wall.chain(to_object).fold(f64::INFINITY, f64::min)
}
