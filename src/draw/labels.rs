//! Places the names of rooms, each at the emptiest spot of its room.

use crate::audit::Grade;
use crate::geometry::{Bounds, Point, Segment};
use crate::layout::{Furnished, Parent};
use crate::plan::Room;

use super::Drawing;
use super::canvas::{Canvas, LETTER_WIDTH, TextStyle};
use super::findings::grade_color;
use super::shell::is_furnished;

/// Places per side that are compared for a room's name.
const RASTER: usize = 24;

/// Pixels of the letters of a room's name.
const NAME_SIZE: f64 = 13.0;

/// Pixels of the letters of a room's type and area.
const DETAIL_SIZE: f64 = 10.0;

/// How much wider heavy letters are.
const BOLD: f64 = 1.1;

/// Pixels of the smallest letters that are written at all.
const SMALLEST: f64 = 6.0;

/// Names all rooms: title or id, then type and square metres. Words stay inside their room.
pub(crate) fn draw_labels(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    for (index, room) in drawing.level.rooms.iter().enumerate() {
        let at = label_place(drawing, index);
        let line = Point::new(0.0, 0.6 * NAME_SIZE / canvas.scale());
        let name = room.name.as_deref().unwrap_or(&room.id);
        let style = TextStyle {
            size: NAME_SIZE,
            anchor: "middle",
            is_bold: true,
            has_halo: true,
            color: name_color(drawing, index),
            ..TextStyle::default()
        };
        draw_line(canvas, room, at + line, name, style);
        let room_type = drawing.catalog.room_types.get(&room.room_type);
        let room_type = room_type.map_or(room.room_type.as_str(), |found| &found.label);
        let detail = format!("{room_type}, {:.1} m²", room.region.area());
        let style = TextStyle { size: DETAIL_SIZE, is_bold: false, color: "#555", ..style };
        draw_line(canvas, room, at - line, &detail, style);
    }
}

/// Writes a line as near to a place as the room's walls allow: smaller where it is too long, cut off where
/// letters would be too small.
fn draw_line(canvas: &mut Canvas, room: &Room, at: Point, text: &str, style: TextStyle) {
    let (left, right) = free_stretch(room, at, style.size / canvas.scale());
    let width = (right - left) * canvas.scale() / if style.is_bold { BOLD } else { 1.0 };
    let letters = text.chars().count().max(1) as f64;
    let size = style.size.min(width / (letters * LETTER_WIDTH)).max(SMALLEST);
    let most = width / (size * LETTER_WIDTH);
    let text = if letters <= most { text.to_owned() } else { cut(text, most as usize) };
    let half = text.chars().count() as f64 * size * LETTER_WIDTH / canvas.scale() / 2.0;
    let at = Point::new(at.x.clamp(left + half, (right - half).max(left + half)), at.y);
    let height = Point::new(0.0, size / canvas.scale() / 2.0);
    let is_inside = room.region.contains(at - height) && room.region.contains(at + height);
    if is_inside && !text.is_empty() {
        canvas.text_if_clear(at, &text, TextStyle { size, ..style });
    }
}

/// The beginning of a text in so many letters, or nothing where that would be too short.
fn cut(text: &str, letters: usize) -> String {
    const FEWEST: usize = 4;
    if letters < FEWEST { String::new() } else { text.chars().take(letters - 1).chain(['…']).collect() }
}

/// The lowest and highest x around a place between which a line of text of some height stays in the room.
fn free_stretch(room: &Room, at: Point, height: f64) -> (f64, f64) {
    let Bounds { low, high } = room.region.outline.bounds();
    let crossings = |y: f64| {
        let crossed = room.region.borders().filter(move |edge| (edge.start.y > y) != (edge.end.y > y));
        crossed.map(move |Segment { start: a, end: b }| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
    };
    [at.y - height / 2.0, at.y + height / 2.0].into_iter().flat_map(crossings).fold(
        (low.x, high.x),
        |(left, right), x| if x < at.x { (left.max(x), right) } else { (left, right.min(x)) },
    )
}

/// Where a room's name stands.
pub(crate) fn label_place(drawing: &Drawing<'_>, room: usize) -> Point {
    emptiest_place(&drawing.level.rooms[room], &drawing.furnished[room])
}

/// The colour of the room's grade where findings are shown.
fn name_color(drawing: &Drawing<'_>, room: usize) -> &'static str {
    match drawing.findings.get(room) {
        Some(findings) if drawing.has_findings && is_furnished(drawing, &drawing.level.rooms[room]) => {
            grade_color(Grade::of(findings))
        }
        _ => "",
    }
}

/// The place of a raster over the room that is farthest from walls and furniture.
fn emptiest_place(room: &Room, furnished: &Furnished) -> Point {
    let bounds = room.region.outline.bounds();
    let step = bounds.size() / RASTER as f64;
    let at = |index: usize| {
        bounds.low + step * Point::new((index % RASTER) as f64 + 0.5, (index / RASTER) as f64 + 0.5)
    };
    let inside = (0..RASTER * RASTER).map(at).filter(|&point| room.region.contains(point));
    let best = inside.map(|point| (point, freedom(point, room, furnished)));
    // The first of equals: `max_by` would take the last.
    let best = best.reduce(|best, next| if next.1 > best.1 { next } else { best });
    best.map_or(bounds.center(), |(point, _)| point)
}

/// Metres to the nearest wall or object; names are wide, so that metres to the side count less.
fn freedom(point: Point, room: &Room, furnished: &Furnished) -> f64 {
    const SIDEWAYS: Point = Point::new(0.5, 1.0);
    let to_wall = room.region.borders().map(|border| ((border.nearest(point) - point) * SIDEWAYS).length());
    let standing = furnished.placements.iter().filter(|object| object.parent != Parent::Ceiling);
    let to_object = standing.map(|object| {
        let radius = (object.size.width + object.size.depth) / 4.0;
        ((object.position - point) * SIDEWAYS).length() - radius
    });
    to_wall.chain(to_object).fold(f64::INFINITY, f64::min)
}
