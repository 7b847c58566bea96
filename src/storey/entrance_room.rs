//! The room that people come into on the ground floor of a building along corridors: a lobby, a reception.

use crate::geometry::{Bounds, Point, ring_contains};

use super::disc::is_as_wide_as;
use super::dwelling::{Cell, Port};
use super::links::room_at;
use super::ring::{Axis, Ring, along, area, bounds, join, shared, shared_length, split};
use super::typology::{RoomNeeds, Typology};

/// Metres of wall between it and the corridor at least: one sees the desk from there.
const LEAST_BORDER: f64 = 1.5;

/// The ground floor with a room of another type in place of the one of the main type that lies nearest to the way in; its bath, and
/// the part of the corridor up to the way in where it lies beside that, belong to it. `None` where no room can be it.
pub(super) fn with_entrance_room(
    cells: &[Cell],
    port: Port,
    typology: &Typology,
    (room_type, needs): (&String, &RoomNeeds),
) -> Option<Vec<Cell>> {
    let hall = hall_of(cells, port, typology)?;
    let way_in = Bounds::around_point(port.at, 0.0);
    let mut rooms: Vec<(f64, usize)> = (0..cells.len())
        .filter(|&room| Some(&cells[room].room_type) == typology.main.as_ref())
        .map(|room| (bounds(&cells[room].ring).gap(way_in), room))
        .collect();
    rooms.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    rooms.into_iter().find_map(|(_, room)| {
        let (own, bath) = with_its_bath(cells, room)?;
        let is_fit = |(own, rest): &(Ring, Ring)| {
            is_as_wide_as(own, needs.width) && shared_length(own, rest) >= LEAST_BORDER
        };
        let whole = cells[hall].ring.clone();
        let (own, rest) =
            with_way_in(&own, &whole, port).filter(is_fit).or(Some((own, whole)).filter(is_fit))?;
        let mut found = cells.to_vec();
        found[room] = Cell::shared(own, room_type);
        found[hall].ring = rest;
        if let Some(bath) = bath {
            found.remove(bath);
        }
        Some(found)
    })
}

/// The corridor behind the way in.
fn hall_of(cells: &[Cell], port: Port, typology: &Typology) -> Option<usize> {
    let hall = room_at(cells, port)?;
    (Some(&cells[hall].room_type) == typology.hall.as_ref()).then_some(hall)
}

/// A room and the bath beside it that is reached through it alone, with the number of the bath.
fn with_its_bath(cells: &[Cell], room: usize) -> Option<(Ring, Option<usize>)> {
    let bath = room + 1;
    match cells.get(bath).filter(|cell| cell.room_type == "hotel_bathroom") {
        Some(cell) => Some((join(&cells[room].ring, &cell.ring)?, Some(bath))),
        None => Some((cells[room].ring.clone(), None)),
    }
}

/// A room with the part of the corridor between it and the way in, and what is left of the corridor.
fn with_way_in(room: &Ring, hall: &Ring, port: Port) -> Option<(Ring, Ring)> {
    let axis = if port.way.x.abs() > port.way.y.abs() { Axis::X } else { Axis::Y };
    let across = |point: Point| along(point, axis);
    // The side of the corridor on which the room lies.
    let borders =
        shared(room, hall).into_iter().filter(|border| border.direction().dot(port.way).abs() < 0.1);
    let border = borders.reduce(|a, b| if b.length() > a.length() { b } else { a })?;
    let (below, above) = split(hall, axis, across(border.middle()));
    let is_below = across(port.at) < across(border.middle());
    let (ways, rest) = if is_below { (below, above) } else { (above, below) };
    let [rest] = <[Ring; 1]>::try_from(rest).ok()?;
    let inside = port.at + port.way * 0.4;
    let (mut own, others): (Vec<Ring>, Vec<Ring>) =
        ways.into_iter().partition(|way| ring_contains(way, inside));
    let others = others.into_iter().try_fold(rest, |rest, other| join(&rest, &other))?;
    // Where people come in at the side of the corridor itself, that stays one.
    let way = own.pop().filter(|way| area(way) < area(&others))?;
    Some((join(room, &way)?, others))
}
