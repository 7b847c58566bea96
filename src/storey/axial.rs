//! Rooms that people look along, such as churches: they come in at one end and look to the other.

use crate::geometry::{Point, Segment, edges, main_axis};

use super::dwelling::Port;
use super::faces::Partition;
use super::house::outer_port;
use super::links::Entry;
use super::ring::area;
use super::spine::Ground;

/// Cosines between a wall and the axis from which and up to which it is a slanted one, as of an apse.
const SLANTED: (f64, f64) = (0.2, 0.97);
/// Share of the axis behind which a slanted wall is one of its end.
const END: f64 = 0.7;
/// Metres of slanted walls by which one end has more, where it is the end that people look to.
const APSE: f64 = 2.0;
/// Metres of wall that hold the door at an end, and of them that stay free beside its middle.
const LEAST_WALL: f64 = 1.6;
const BESIDE_DOOR: f64 = 0.8;
/// Share of the axis within which the wall at its end lies: that of a tower before it is nearer, that of a wing is not.
const FARTHEST_WALL: f64 = 0.2;
/// Share of the axis, and metres at least, before the end that people look to, where no further doors are.
const CALM: (f64, f64) = (0.15, 4.0);

/// The line along which people look, from where they come in; none of a room that has no such line.
pub(super) fn axis(ground: &Ground, partition: &Partition<'_>, room: usize) -> Option<Segment> {
    let cell = &partition.cells[room];
    partition.typologies.rooms.get(&cell.room_type).filter(|needs| needs.axial)?;
    let walls: Vec<Segment> = edges(&cell.ring).collect();
    let street = outer_port(ground).map(|port| port.at);
    let gap = |end: Point| street.map_or(0.0, |street| street.distance(end));
    let axis = main_axis(&walls, Point::X, gap)?;
    let (before, behind) = (slanted(&walls, axis.reversed()), slanted(&walls, axis));
    let is_reversed =
        if (before - behind).abs() > APSE { before > behind } else { gap(axis.start) > gap(axis.end) };
    Some(if is_reversed { axis.reversed() } else { axis })
}

/// Metres of slanted walls at the end of an axis.
fn slanted(walls: &[Segment], axis: Segment) -> f64 {
    let along = axis.direction();
    let is_slanted = |wall: &&Segment| {
        let cosine = wall.direction().dot(along).abs();
        (wall.middle() - axis.start).dot(along) > END * axis.length()
            && cosine > SLANTED.0
            && cosine < SLANTED.1
    };
    walls.iter().filter(is_slanted).map(|wall| wall.length()).sum()
}

/// The way into the largest room that people look along, at the end of its axis; at the other end where the first has no free wall.
/// None where the map shows the door.
pub(super) fn way_in(ground: &Ground, partition: &Partition<'_>) -> Option<Entry> {
    let (span, at) = ground.facade.entrance?;
    let is_drawn = at.distance(ground.facade.spans.get(span)?.line.middle()) > 0.01;
    let rooms = (0..partition.cells.len()).filter_map(|room| Some((room, axis(ground, partition, room)?)));
    let size = |room: usize| area(&partition.cells[room].ring);
    let (room, axis) =
        rooms.reduce(|a, b| if size(b.0) > size(a.0) { b } else { a }).filter(|_| !is_drawn)?;
    let walls = partition.light(ground, room);
    let port = |axis: Segment| {
        let is_end = |wall: &&Segment| {
            wall.normal().dot(axis.direction()) > SLANTED.1
                && wall.length() >= LEAST_WALL
                && wall.distance(axis.start) < FARTHEST_WALL * axis.length()
        };
        let ends = walls.iter().filter(is_end);
        let wall = ends.reduce(|a, b| if b.distance(axis.start) < a.distance(axis.start) { b } else { a })?;
        let place = (axis.start - wall.start).dot(wall.direction());
        let place = place.clamp(BESIDE_DOOR, wall.length() - BESIDE_DOOR);
        Some(Port { at: wall.after(place), way: wall.normal() })
    };
    Some(Entry { room, port: port(axis).or_else(|| port(axis.reversed()))? })
}

/// Whether further doors may be at a place of a room: not where all look.
pub(super) fn may_have_door(axis: Option<Segment>, at: Point) -> bool {
    axis.is_none_or(|axis| (axis.end - at).dot(axis.direction()) > (CALM.0 * axis.length()).max(CALM.1))
}
