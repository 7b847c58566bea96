//! Whether a level keeps what later stages and people rely on; a plan that does not is tried in a simpler way.

use super::disc::{is_as_wide_as, is_simple};
use super::dwelling::Cell;
use super::egress::too_far_out;
use super::faces::Partition;
use super::links::Links;
use super::ring::area;
use super::spine::Ground;
use super::thin::{SLIVER_WIDTH, has_slivers};
use super::typology::Light;

/// Share of the floor that rooms may miss or cover twice.
const COVER: f64 = 0.004;

/// The first thing that is wrong with a level; `None` if nothing is.
pub(super) fn first_fault(
    grounds: &[Ground],
    partition: &Partition<'_>,
    links: &Links,
    lit: &[bool],
    is_ground: bool,
) -> Option<String> {
    let &Partition { cells, typologies, .. } = partition;
    let whole: f64 = grounds.iter().map(|ground| area(&ground.ring)).sum();
    let covered: f64 = cells.iter().map(|cell| area(&cell.ring)).sum();
    if (covered / whole - 1.0).abs() > COVER {
        return Some(format!("rooms cover {covered:.1} of {whole:.1} m²"));
    }
    if let Some(room) = links.unreached.first() {
        return Some(format!("no door leads to the {}", cells[*room].room_type));
    }
    for (index, cell) in cells.iter().enumerate() {
        if let Some(fault) = partition.form_fault(index, || form_fault(partition, index)) {
            return Some(fault.to_owned());
        }
        let Some(needs) = typologies.rooms.get(&cell.room_type) else { continue };
        if needs.light == Light::Required && !lit[index] {
            return Some(format!("the {} has no window", cell.room_type));
        }
    }
    let far = too_far_out(partition, links, is_ground);
    far.map(|(room, metres)| format!("from the {} it is {metres:.0} m to a way out", cells[room].room_type))
}

/// What is wrong with the form of a room.
fn form_fault(partition: &Partition<'_>, room: usize) -> Option<String> {
    let Cell { ring, room_type, .. } = &partition.cells[room];
    if !is_simple(ring) {
        return Some(format!("the outline of the {room_type} crosses itself"));
    }
    if has_slivers(&partition.faces[room]) {
        return Some(format!("a part of the {room_type} is narrower than {SLIVER_WIDTH} m"));
    }
    let width = partition.typologies.rooms.get(room_type)?.width;
    (!is_as_wide_as(ring, width)).then(|| format!("the {room_type} is narrower than {width} m"))
}
