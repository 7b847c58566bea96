//! Draws walls, floors and openings.

use crate::geometry::Point;
use crate::plan::{Level, Opening, OpeningKind, Room, STAIRS_ROOM_TYPE, Stairs, Wall, WallKind};

use super::Drawing;
use super::canvas::Canvas;

pub(crate) const WALL: &str = "fill=\"#1c1c1c\" stroke=\"#1c1c1c\" stroke-width=\"1.2\"";
const THIN_WALL: &str = "stroke=\"#1c1c1c\" stroke-width=\"2\" stroke-linecap=\"square\"";
pub(crate) const RAILING: &str = "stroke=\"#1c1c1c\" stroke-width=\"1.2\" stroke-dasharray=\"2 2\"";
const FLOOR: &str = "fill=\"#fefdfb\" stroke=\"#1c1c1c\" stroke-width=\"0.5\"";
pub(crate) const UNFURNISHED: &str = "fill=\"url(#hatch)\" stroke=\"#555\" stroke-width=\"0.5\"";
pub(crate) const OBSTACLE: &str = "fill=\"#1c1c1c\" stroke=\"#1c1c1c\" stroke-width=\"1\"";
const GAP: &str = "fill=\"#fefdfb\" stroke=\"#fefdfb\" stroke-width=\"0.7\"";
pub(crate) const GLASS: &str = "fill=\"#f4f9fc\" stroke=\"#1c1c1c\" stroke-width=\"0.7\"";
pub(crate) const GLASS_LINE: &str = "stroke=\"#1c1c1c\" stroke-width=\"0.6\"";
pub(crate) const LEAF: &str = "stroke=\"#1c1c1c\" stroke-width=\"1.8\"";
pub(crate) const SWING: &str =
    "fill=\"#f7f3ea\" fill-opacity=\"0.5\" stroke=\"#555\" stroke-width=\"0.5\" stroke-linejoin=\"round\"";
pub(crate) const DASHES: &str = "stroke=\"#999\" stroke-width=\"1\" stroke-dasharray=\"4 3\"";

const TREAD_LINE: &str = "stroke=\"#777\" stroke-width=\"0.5\"";

/// The way up stairs, and metres of half of its arrow's width.
const WALKING_LINE: &str = "stroke=\"#1c1c1c\" stroke-width=\"0.8\"";
const ARROW: f64 = 0.08;
/// Metres of a tread of stairs of which only the room is known.
const TREAD: f64 = 0.28;

/// Metres that a gap reaches beyond the faces of its wall, so that no sliver of wall remains.
const GAP_OVERLAP: f64 = 0.01;

/// Metres of wall that are drawn where the plan's walls have no thickness.
const LEAST_THICKNESS: f64 = 0.06;

/// All walls, each behind its inner face. The floors are drawn over what reaches into rooms.
pub(crate) fn draw_walls(canvas: &mut Canvas, level: &Level) {
    for wall in level.rooms.iter().flat_map(|room| &room.walls) {
        match wall.kind {
            WallKind::Solid if wall.thickness > 0.0 => canvas.polygon(&wall_body(wall), WALL),
            WallKind::Solid => canvas.line(wall.start, wall.end, THIN_WALL),
            WallKind::Railing(_) => canvas.line(wall.start, wall.end, RAILING),
        }
    }
}

/// The wall's footprint, lengthened at both ends so that corners are filled.
fn wall_body(wall: &Wall) -> [Point; 4] {
    let (back, along) = (-wall.normal() * wall.thickness, wall.direction() * wall.thickness);
    let (start, end) = (wall.start - along, wall.end + along);
    [start, end, end + back, start + back]
}

/// All floors; rooms that are not furnished are hatched.
pub(crate) fn draw_floors(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    for (index, room) in drawing.level.rooms.iter().enumerate() {
        let outline = room.region.outline.corners();
        let holes = room.region.holes.iter().map(crate::geometry::Polygon::corners);
        let rings: Vec<&[Point]> = std::iter::once(outline).chain(holes).collect();
        canvas.polygons(
            &rings,
            if is_furnished(drawing, room) || is_stairs(room) { FLOOR } else { UNFURNISHED },
        );
        match drawing.level.stairs_of(index) {
            Some(stairs) => draw_stairs(canvas, stairs),
            None if is_stairs(room) => draw_treads(canvas, room),
            None => {}
        }
    }
}

/// The steps up, with the way that one walks; where none lead up, those that come from below.
fn draw_stairs(canvas: &mut Canvas, stairs: &Stairs) {
    let (opening, nosings) = match (&stairs.up, &stairs.well) {
        (Some(flight), _) => (&flight.opening, flight.nosings()),
        (None, Some(well)) => (&well.opening, well.nosings.clone()),
        (None, None) => return,
    };
    opening.edges().for_each(|edge| canvas.line(edge.start, edge.end, TREAD_LINE));
    nosings.iter().for_each(|edge| canvas.line(edge.start, edge.end, TREAD_LINE));
    let middles: Vec<Point> = nosings.iter().map(|edge| edge.middle()).collect();
    middles.windows(2).for_each(|step| canvas.line(step[0], step[1], WALKING_LINE));
    // An arrow at the upper end.
    if let [.., before, last] = middles[..]
        && let Some(along) = (last - before).try_normalize()
    {
        for side in [along.perp(), -along.perp()] {
            canvas.line(last, last + (side - along * 1.5) * ARROW, WALKING_LINE);
        }
    }
}

/// Whether people climb in it: a rectangle of that type.
pub(crate) fn is_stairs(room: &Room) -> bool {
    room.room_type == STAIRS_ROOM_TYPE && room.region.outline.corners().len() == 4
}

/// Steps across the longer side of a room, in two flights.
fn draw_treads(canvas: &mut Canvas, room: &Room) {
    let corners = room.region.outline.corners();
    let (a, b) = (corners[1] - corners[0], corners[3] - corners[0]);
    let (along, across) = if a.length() >= b.length() { (a, b) } else { (b, a) };
    let count = (along.length() / TREAD).floor().max(1.0) as u32;
    for step in 1..count {
        let from = corners[0] + along * (f64::from(step) / f64::from(count));
        canvas.line(from, from + across, TREAD_LINE);
    }
    let middle = corners[0] + across / 2.0;
    canvas.line(middle, middle + along, TREAD_LINE);
}

/// Whether the catalogue furnishes rooms of this type.
pub(crate) fn is_furnished(drawing: &Drawing<'_>, room: &Room) -> bool {
    drawing.catalog.room_types.get(&room.room_type).is_some_and(|room_type| room_type.is_furnished)
}

/// Columns and other fixed bodies.
pub(crate) fn draw_obstacles(canvas: &mut Canvas, level: &Level) {
    for obstacle in level.rooms.iter().flat_map(|room| &room.obstacles) {
        canvas.polygon(obstacle.outline.corners(), OBSTACLE);
    }
}

/// All openings, over the walls that they pierce.
pub(crate) fn draw_openings(canvas: &mut Canvas, level: &Level) {
    for opening in &level.openings {
        match opening.kind {
            OpeningKind::Window => draw_window(canvas, level, opening),
            OpeningKind::Door => draw_door(canvas, level, opening),
            OpeningKind::SlidingDoor => draw_sliding_door(canvas, level, opening),
            OpeningKind::Passage | OpeningKind::OpenBoundary => draw_passage(canvas, level, opening),
        }
    }
}

fn draw_window(canvas: &mut Canvas, level: &Level, opening: &Opening) {
    let corners = gap(level, opening, 0.0);
    canvas.polygon(&corners, GLASS);
    let half = opening.along * (opening.width / 2.0);
    // Both faces of the pane, a tenth of the wall apart.
    let apart = (corners[3] - corners[0]) / 20.0;
    for pane in [opening.center - apart, opening.center + apart] {
        canvas.line(pane - half, pane + half, GLASS_LINE);
    }
}

fn draw_door(canvas: &mut Canvas, level: &Level, opening: &Opening) {
    canvas.polygon(&gap(level, opening, GAP_OVERLAP), GAP);
    for leaf in &opening.leaves {
        canvas.sector(leaf.hinge, leaf.closed_tip, leaf.open_tip, SWING);
        canvas.line(leaf.hinge, leaf.open_tip, LEAF);
    }
}

fn draw_sliding_door(canvas: &mut Canvas, level: &Level, opening: &Opening) {
    canvas.polygon(&gap(level, opening, GAP_OVERLAP), GAP);
    let half = opening.along * (opening.width / 2.0);
    canvas.line(opening.center - half, opening.center + half, LEAF);
}

fn draw_passage(canvas: &mut Canvas, level: &Level, opening: &Opening) {
    let corners = gap(level, opening, GAP_OVERLAP);
    canvas.polygon(&corners, GAP);
    canvas.line(corners[0], corners[1], DASHES);
    canvas.line(corners[2], corners[3], DASHES);
}

/// The opening's footprint through the whole wall.
fn gap(level: &Level, opening: &Opening, overlap: f64) -> [Point; 4] {
    let thickness: f64 =
        opening.sides.iter().map(|side| level.rooms[side.room].walls[side.wall].thickness).sum();
    let along = opening.along * (opening.width / 2.0);
    let across = opening.along.perp() * (thickness.max(LEAST_THICKNESS) / 2.0 + overlap);
    let center = opening.center;
    [center - along - across, center + along - across, center + along + across, center - along + across]
}
