//! Whether a level keeps what later stages and people rely on; a plan that does not is tried in a simpler way.

use super::disc::{is_as_wide_as, is_simple};
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
        if !is_simple(&cell.ring) {
            return Some(format!("the outline of the {} crosses itself", cell.room_type));
        }
        if has_slivers(&partition.faces[index]) {
            return Some(format!("a part of the {} is narrower than {SLIVER_WIDTH} m", cell.room_type));
        }
        let Some(needs) = typologies.rooms.get(&cell.room_type) else { continue };
        if !is_as_wide_as(&cell.ring, needs.width) {
            return Some(format!("the {} is narrower than {} m", cell.room_type, needs.width));
        }
        if needs.light == Light::Required && !lit[index] {
            return Some(format!("the {} has no window", cell.room_type));
        }
    }
    let far = too_far_out(partition, links, is_ground);
    far.map(|(room, metres)| format!("from the {} it is {metres:.0} m to a way out", cells[room].room_type))
}
