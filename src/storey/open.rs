//! One large room with small ones at its darkest end: shops, halls, workshops, open offices.

use crate::plan::limits::{ROOM_AREA, ROOM_BOX, ROOM_SIDE};

use super::brief::Brief;
use super::disc::is_as_wide_as;
use super::dwelling::Cell;
use super::flats::sections;
use super::links::LEAST_BORDER;
use super::ring::{Axis, Ring, along, area, bounds, join, on_grid, shared_length, split, total_length};
use super::spine::{Ground, cut_along, extent, settle, turned_ring_back};
use super::thin::leave_thin_parts;
use super::typology::Typologies;

/// Metres of the depth of the small rooms, and with stairs among them.
const DEPTH: (f64, f64) = (3.0, 4.6);
/// Ways of dividing a storey, the usual one first.
pub(super) const WAYS: [Way; 4] = [
    Way { with_stairs: 700.0, without_stairs: f64::INFINITY, is_careful: false },
    Way { with_stairs: 320.0, without_stairs: 6_000.0, is_careful: false },
    Way { with_stairs: 700.0, without_stairs: 6_000.0, is_careful: true },
    Way { with_stairs: 320.0, without_stairs: 2_500.0, is_careful: true },
];
/// Metres of the depth of stairs that take a whole end.
const WHOLE_ENDS: [f64; 3] = [2.6, 4.0, 6.0];
/// Metres of the width of stairs at least.
const LEAST_STAIRS: f64 = 2.1;
/// Square metres of stairs.
const STAIRS: f64 = 13.0;
/// How many sides of a square of its largest area a compartment stretches over at most: a narrow one around a court, or a bent one
/// of a hundred metres, is no room that people see the end of, though it is no larger than others.
const LONGEST_COMPARTMENT: f64 = 2.0;
/// How many times the width that they need small rooms are given, walls and sloping ends included.
const WIDER: f64 = 1.1;
/// Share of the storey that small rooms take at most.
const MOST_SHARE: f64 = 0.4;

/// A way of dividing an open storey.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    /// Square metres of a part with stairs of its own, about, so that nobody walks far to them.
    with_stairs: f64,
    /// Square metres of a part of the only storey at most: the middle of a larger one is far from all outer walls.
    without_stairs: f64,
    /// Whether small rooms are only where they leave no thin part beside them.
    is_careful: bool,
}

impl Way {
    /// Parts of a piece of the storey.
    fn parts(self, area: f64, has_stairs: bool) -> usize {
        let count =
            if has_stairs { (area / self.with_stairs).round() } else { (area / self.without_stairs).ceil() };
        count as usize
    }
}

/// How many small rooms an open storey has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SmallRooms {
    /// As large as people need in each of its parts.
    Enough,
    /// One of each, as small as may be.
    Few,
}

/// One level, alike on all storeys; `None` where there is no place for the small rooms. Later attempts have more stairs or more
/// parts, then fewer places for small rooms.
pub(super) fn open_plan(
    grounds: &[Ground],
    brief: &Brief<'_>,
    typologies: &Typologies,
    attempt: usize,
    small: SmallRooms,
) -> Option<Vec<Cell>> {
    let way = WAYS[attempt.min(WAYS.len() - 1)];
    let main = brief.typology.main.as_deref()?;
    let has_stairs = brief.storeys > 1;
    let stairs = has_stairs.then_some(("stairs", STAIRS));
    let mut cells: Vec<Cell> = Vec::new();
    for (index, ground) in grounds.iter().enumerate() {
        let is_joined = || cells.iter().any(|cell| shared_length(&cell.ring, &ground.ring) >= LEAST_BORDER);
        // Pieces that were cut at a courtyard are reached from others; what stands apart has stairs of its own.
        if index > 0 && area(&ground.ring) < way.with_stairs && is_joined() {
            cells.push(Cell::shared(ground.ring.clone(), main));
            continue;
        }
        // The last attempt does without: where a part in the middle has no way out, a larger one has.
        let most = brief.typology.compartment.filter(|_| attempt < 2).unwrap_or(f64::INFINITY);
        let count = way.parts(area(&ground.ring), has_stairs).max(compartments(&ground.ring, most));
        let mut parts = sections(ground, ground.ring.clone(), count);
        if !has_stairs {
            lightest_first(ground, &mut parts);
        }
        for (part, ring) in parts.into_iter().enumerate() {
            let is_first = index == 0 && part == 0;
            let wanted = match (is_first, small) {
                (true, SmallRooms::Enough) => brief.typology.services_of(area(&ring)),
                (true, SmallRooms::Few) => brief.typology.services_of(0.0),
                (false, SmallRooms::Enough) => brief.typology.shared_services_of(area(&ring)),
                (false, SmallRooms::Few) => Vec::new(),
            };
            let services: Vec<(&str, f64)> = stairs.into_iter().chain(wanted).collect();
            let whole = || vec![Cell::shared(ring.clone(), main)];
            let end = End { services: &services, has_stairs, typologies, is_careful: way.is_careful };
            let cut = part_cells(&ground.part(ring.clone()), end, main);
            // Other parts are reached through the first, where they have no place for stairs.
            cells.extend(cut.or_else(|| (!is_first).then(whole))?);
        }
    }
    Some(cells)
}

/// A piece of a storey along corridors in which none has a place, as large rooms of a type, each with stairs where there are to be any.
pub(super) fn large_rooms(
    ground: &Ground,
    room_type: &str,
    has_stairs: bool,
    typologies: &Typologies,
) -> Vec<Cell> {
    let count = WAYS[0].parts(area(&ground.ring), true);
    let services: &[(&str, f64)] = if has_stairs { &[("stairs", STAIRS)] } else { &[] };
    let end = End { services, has_stairs, typologies, is_careful: true };
    let cells = |ring: Ring| {
        let cut = part_cells(&ground.part(ring.clone()), end, room_type);
        cut.unwrap_or_else(|| vec![Cell::shared(ring, room_type)])
    };
    sections(ground, ground.ring.clone(), count).into_iter().flat_map(cells).collect()
}

/// How many compartments of so many square metres at most a ring is parted into.
fn compartments(ring: &Ring, most: f64) -> usize {
    let stretch = bounds(ring).size().max_element();
    (area(ring) / most).max(stretch / (LONGEST_COMPARTMENT * most.sqrt())).ceil() as usize
}

/// The small rooms are in the first part: one with much outer wall has ways out near them.
fn lightest_first(ground: &Ground, parts: &mut [Ring]) {
    let light = |ring: &Ring| total_length(&ground.light(ring));
    let lights = parts.iter().map(light).enumerate();
    if let Some((best, _)) = lights.reduce(|a, b| if b.1 > a.1 { b } else { a }) {
        parts[..=best].rotate_right(1);
    }
}

/// What is wanted at an end of a large room.
#[derive(Clone, Copy)]
pub(super) struct End<'a> {
    /// Small rooms with their square metres; stairs are the first.
    pub(super) services: &'a [(&'a str, f64)],
    /// Whether there are stairs.
    pub(super) has_stairs: bool,
    /// What rooms need.
    pub(super) typologies: &'a Typologies,
    /// Whether nothing thin may be left beside the small rooms.
    pub(super) is_careful: bool,
}

impl End<'_> {
    fn allows(self, ground: &Ground, room: &Ring, small: &[Ring]) -> bool {
        !self.is_careful || !leave_thin_parts(&ground.ring, room, small)
    }
}

/// A large room and the small ones at its end.
pub(super) fn part_cells(ground: &Ground, end: End<'_>, main: &str) -> Option<Vec<Cell>> {
    let (room, small) = with_services(ground, end)?;
    let small = small.into_iter().zip(end.services);
    let small = small.map(|(ring, (room_type, _))| Cell::shared(ring, room_type));
    Some(std::iter::once(Cell::shared(room, main)).chain(small).collect())
}

/// The large room and the small ones; of these, the last are left out where they do not fit.
fn with_services(ground: &Ground, end: End<'_>) -> Option<(Ring, Vec<Ring>)> {
    let most = area(&ground.ring) * MOST_SHARE;
    let mut services = end.services;
    while services.len() > 1 && services.iter().map(|(_, area)| area).sum::<f64>() > most {
        services = &services[..services.len() - 1];
    }
    while !services.is_empty() {
        let end = End { services, ..end };
        let ends = [false, true].into_iter().filter_map(|is_turned| best_end(ground, end, is_turned));
        if let Some((_, room, small)) = ends.reduce(|best, next| if next.0 < best.0 { next } else { best }) {
            return Some((room, small));
        }
        if services.len() == 1 && end.has_stairs {
            return whole_end(ground, end).map(|(room, stairs)| (room, vec![stairs]));
        }
        services = &services[..services.len() - 1];
    }
    Some((ground.ring.clone(), Vec::new()))
}

/// Stairs across a whole end of the ground, where no smaller ones have a place: the large room and the stairs.
fn whole_end(ground: &Ground, wanted: End<'_>) -> Option<(Ring, Ring)> {
    let ways = [Axis::X, Axis::Y].into_iter().flat_map(|axis| [(axis, false), (axis, true)]);
    let cuts = ways.flat_map(|(axis, is_top)| WHOLE_ENDS.map(|depth| (axis, is_top, depth)));
    let ends = cuts.filter_map(|(axis, is_top, depth)| {
        let (low, high) = extent(&ground.ring, axis);
        let (below, above) = split(&ground.ring, axis, if is_top { high - depth } else { low + depth });
        let (mut end, mut rest) = if is_top { (above, below) } else { (below, above) };
        end.sort_by(|a, b| area(b).total_cmp(&area(a)));
        rest.sort_by(|a, b| area(b).total_cmp(&area(a)));
        let (mut end, mut rest) = (end.into_iter(), rest.into_iter());
        let mut rings = vec![rest.next()?, end.next()?];
        let is_settled = settle(end.chain(rest).collect(), &mut rings, |_| 1.0).is_empty();
        let [room, stairs] = <[Ring; 2]>::try_from(rings).ok()?;
        let is_fit = is_as_wide_as(&stairs, LEAST_STAIRS) && shared_length(&room, &stairs) >= LEAST_BORDER;
        let is_small = area(&stairs) < MOST_SHARE * area(&ground.ring);
        let is_allowed = wanted.allows(ground, &room, std::slice::from_ref(&stairs));
        (is_settled && is_fit && is_small && is_allowed).then_some((room, stairs))
    });
    ends.reduce(|best, next| if area(&next.1) < area(&best.1) { next } else { best })
}

/// Small rooms at the better of two ends of the ground, or of the ground turned by a quarter.
fn best_end(ground: &Ground, end: End<'_>, is_turned: bool) -> Option<(f64, Ring, Vec<Ring>)> {
    let turned = ground.turned();
    let framed = if is_turned { &turned } else { ground };
    let back = |ring: &Ring| if is_turned { turned_ring_back(ring) } else { ring.clone() };
    let ends = [false, true].into_iter().flat_map(|is_top| [(is_top, false), (is_top, true)]);
    let ends = ends.filter_map(|(is_top, is_right)| {
        let found = at_end(framed, end, is_top, is_right);
        let (cost, room, small) = found.filter(|(_, room, small)| end.allows(framed, room, small))?;
        // Nobody should walk far to the stairs.
        let stairs = small.first().filter(|_| end.has_stairs).map(|ring| bounds(ring).center());
        let way = stairs.map_or(0.0, |at| at.distance(bounds(&framed.ring).center()));
        Some((cost + way, back(&room), small.iter().map(back).collect()))
    });
    ends.reduce(|best, next| if next.0 < best.0 { next } else { best })
}

/// Metres of width that a room needs.
fn width_of(typologies: &Typologies, room_type: &str) -> f64 {
    typologies.rooms.get(room_type).map_or(1.1, |needs| needs.width)
}

/// Metres of depth of the small rooms at least, of which so many would do for their area: deep enough for the room that needs most,
/// also at an outer wall that is not quite parallel.
fn least_depth(end: End<'_>, by_area: f64) -> f64 {
    let widths = end.services.iter().map(|(room_type, _)| WIDER * width_of(end.typologies, room_type));
    let widest = widths.fold(1.6, f64::max);
    if end.has_stairs { DEPTH.1 } else { by_area.clamp(widest, DEPTH.0.max(widest)) }
}

/// Metres of width of small rooms in a row of this depth: those among deeper stairs are as wide as they need to be, and larger than was
/// asked for.
fn small_widths(services: &[(&str, f64)], depth: f64, typologies: &Typologies) -> Vec<f64> {
    let width = |(room_type, area): &(&str, f64)| (area / depth).max(WIDER * width_of(typologies, room_type));
    services.iter().map(width).collect()
}

/// Small rooms in a row at the top or bottom end, from its left or right on; the cost is the light that they take, and closing the entrance.
fn at_end(ground: &Ground, end: End<'_>, is_top: bool, is_right: bool) -> Option<(f64, Ring, Vec<Ring>)> {
    let End { services, has_stairs, typologies, .. } = end;
    let (bottom, top) = extent(&ground.ring, Axis::Y);
    let wanted: f64 = services.iter().map(|(_, area)| area).sum();
    let (left, right) = extent(&ground.ring, Axis::X);
    let least = least_depth(end, wanted / (right - left));
    let depth = least.max(wanted / (right - left)).min((top - bottom) * 0.5);
    let at = if is_top { top - depth } else { bottom + depth };
    let (below, above) = split(&ground.ring, Axis::Y, at);
    let (end, rest) = if is_top { (above, below) } else { (below, above) };
    let mut room = rest;
    let mut row = end.first()?.clone();
    let others: Vec<Ring> = end.into_iter().skip(1).chain(room.drain(1.min(room.len())..)).collect();
    // Services take a part of the row, from one end; the rest belongs to the large room.
    let (low, high) = extent(&row, Axis::X);
    let widths = small_widths(services, area(&row) / (high - low), typologies);
    let length: f64 = widths.iter().sum();
    let mut rests = others;
    if length < 0.9 * (high - low) {
        let (below, above) = split(&row, Axis::X, if is_right { high - length } else { low + length });
        let (mut kept, beyond) = if is_right { (above, below) } else { (below, above) };
        row = if kept.is_empty() { return None } else { kept.swap_remove(0) };
        rests.extend(kept.into_iter().chain(beyond));
    }
    let (low, high) = extent(&row, Axis::X);
    let mut taken = 0.0;
    let places: Vec<f64> = widths[..widths.len() - 1]
        .iter()
        .map(|width| {
            taken += width;
            low + (high - low) * taken / length
        })
        .collect();
    let (small, crumbs) = cut_along(&[row], &places);
    let is_wide = |(ring, (room_type, _)): (&Ring, &(&str, f64))| {
        !ring.is_empty() && is_as_wide_as(ring, width_of(typologies, room_type))
    };
    if !small.iter().zip(services).all(is_wide) {
        return None;
    }
    if has_stairs && !is_as_wide_as(small.first()?, LEAST_STAIRS) {
        return None;
    }
    rests.extend(crumbs);
    let mut main = vec![room.pop()?];
    if !settle(rests, &mut main, |_| 1.0).is_empty() {
        return None;
    }
    let main = main.pop()?;
    let reaches = |ring: &Ring| shared_length(ring, &main) >= super::fill::DOOR_STRETCH;
    if !small.iter().all(reaches) {
        return None;
    }
    let light: f64 = small.iter().flat_map(|ring| ground.light(ring)).map(|piece| piece.length()).sum();
    let entrance = ground.facade.entrance.map_or(0.0, |(_, at)| {
        let near = |ring: &Ring| {
            super::ring::bounds(ring).gap(crate::geometry::Bounds::around_point(at, 1.0)) <= ground.wall + 0.2
        };
        if small.iter().any(near) { 100.0 } else { 0.0 }
    });
    Some((light + entrance, main, small))
}

/// The rooms of a level, those that are larger than a room may be cut in halves until none is: open to each other, they are as
/// useful as one.
pub(super) fn within_limits(cells: Vec<Cell>) -> Vec<Cell> {
    let mut open: Vec<Cell> = cells.into_iter().rev().collect();
    let mut done = Vec::with_capacity(open.len());
    while let Some(cell) = open.pop() {
        let extent = bounds(&cell.ring);
        let size = extent.size();
        let is_small = size.max_element() <= ROOM_SIDE.1 && size.element_product() <= ROOM_BOX;
        let axis = if size.x > size.y { Axis::X } else { Axis::Y };
        let halves = || split(&cell.ring, axis, along(on_grid(extent.center()), axis));
        match if is_small && area(&cell.ring) <= ROOM_AREA { None } else { Some(halves()) } {
            Some((below, above)) if !below.is_empty() && !above.is_empty() => {
                let pieces = below.into_iter().chain(above).rev();
                open.extend(pieces.map(|ring| Cell { ring, ..cell.clone() }));
            }
            _ => done.push(cell),
        }
    }
    done
}

/// One room for each piece of a storey.
pub(super) fn one_room(grounds: &[Ground], room_type: &str) -> Vec<Cell> {
    let mut rings: Vec<Ring> = grounds.iter().map(|ground| ground.ring.clone()).collect();
    // Pieces that were cut at a courtyard stay two rooms: joined they would have a hole.
    let mut index = 1;
    while index < rings.len() {
        let joined = join(&rings[0], &rings[index]);
        match joined {
            Some(ring) => {
                rings[0] = ring;
                rings.remove(index);
            }
            None => index += 1,
        }
    }
    rings.into_iter().map(|ring| Cell::shared(ring, room_type)).collect()
}

#[cfg(test)]
mod tests {
    use crate::geometry::Point;

    use super::super::facade::{Around, look_out};
    use super::*;

    #[test]
    fn careful_stairs_leave_nothing_thin_beside_a_corner_of_the_outline() {
        // Two legs that end at a neighbour: stairs in the right one part it 0.1 m beside its inner corner.
        let corners = [
            (-11.567, 5.27),
            (-10.914, -5.459),
            (9.944, -5.502),
            (10.325, 5.073),
            (5.63, 5.008),
            (5.572, 1.701),
            (0.522, 1.747),
            (0.456, 5.0),
        ];
        let ring: Ring = corners.map(Point::from).into();
        let neighbour = [(-13.0, 5.3), (12.0, 5.3), (12.0, 15.0), (-13.0, 15.0)].map(Point::from);
        let around = Around {
            neighbours: vec![neighbour.into()],
            entrances: vec![Point::new(-11.3, -0.1)],
            streets: vec![],
        };
        let ground = Ground { facade: look_out(&ring, &[], &around), ring, wall: 0.0 };
        let catalog = crate::catalog::builtin_catalog();
        let leaves_thin_parts = |is_careful: bool| {
            let services = [("stairs", STAIRS), ("storeroom", 10.0)];
            let end =
                End { services: &services, has_stairs: true, typologies: &catalog.typologies, is_careful };
            let cells = part_cells(&ground, end, "shop").expect("there is a place for them");
            let rings: Vec<Ring> = cells.into_iter().map(|cell| cell.ring).collect();
            leave_thin_parts(&ground.ring, &rings[0], &rings[1..])
        };
        assert!(leaves_thin_parts(false) && !leaves_thin_parts(true));
    }
}
