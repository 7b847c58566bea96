//! Flats at landings: a storey is cut into sections, each with stairs of its own and a flat on one or both sides of them.

use crate::geometry::{Point, Segment};
use crate::layout::seed::Stream;

use super::brief::Brief;
use super::disc::is_as_wide_as;
use super::dwelling::{Cell, Division, Port, Strips, Task, fitting, plan, studio};
use super::faces::Partition;
use super::hopeless::{Floor, Kind};
use super::links::link;
use super::open::{End, part_cells};
use super::ring::{
    Axis, Ring, along, area, bounds, inner_corners, join, longest, shared, split, total_length,
};
use super::spine::{Ground, cut_along, extent, turned_ring_back};
use super::thin::{Rules, has_thin_parts, trade_thin_parts};
use super::typology::{PlanKind, Typologies};

/// Metres of the strip with the stairs; where there is a lift behind them, a way to it leads past.
const STAIRS_WIDTH: f64 = 2.7;
/// See [`STAIRS_WIDTH`].
const STAIRS_AND_WAY_WIDTH: f64 = 3.05;
/// Metres of the stairs and their landing into the building.
const STAIRS_DEPTH: f64 = 5.2;
/// Metres of a lift into the building.
const LIFT_DEPTH: f64 = 1.9;
/// Storeys from which on there is a lift.
const LIFT_STOREYS: u32 = 5;
/// Metres of outer wall that stairs need for a door and windows.
const STAIRS_LIGHT: f64 = 1.3;
/// Flats below this many square metres are joined with the other of their landing.
const LEAST_FLAT: f64 = 18.0;
/// Square metres from which on a landing has two flats.
const TWO_FLATS: f64 = 130.0;
/// Of the larger of two flats of a landing, the least share that the smaller has.
const LEAST_SHARE: f64 = 0.4;
/// Square metres of a section of a kind that says none.
const USUAL_SECTION: f64 = 200.0;
/// Square metres of sections that follow from the number of flats of a map, which may count what is planned otherwise.
const KNOWN_SECTION: (f64, f64) = (90.0, 420.0);
/// The attempt from which on sections that have no other plan are lofts, and square metres of the largest one.
const LOFT_ATTEMPT: usize = 2;
/// Into how many parts a section is cut that has no plan.
const PARTS: [usize; 2] = [2, 3];
/// See [`LOFT_ATTEMPT`].
const LARGEST_LOFT: f64 = 180.0;
/// Square metres of the stairs and of the bath of a loft.
const LOFT_STAIRS: f64 = 12.0;
/// See [`LOFT_STAIRS`].
const LOFT_BATH: f64 = 5.5;
/// Metres of the hall of a flat on a corridor between the middles of its walls: a shelf as deep as a hand and a way past it.
const FLAT_HALL_WIDTH: f64 = 1.37;
/// Pieces that one cut through a storey may leave: three at an arm of it.
const MOST_PIECES: usize = 3;
/// The shares of a border with the stairs at which a flat may have its way in, and what the others cost: the doors of all flats
/// are at one landing, away from the light, so that the stairs have the floor between.
const WAYS_IN: [f64; 3] = [0.85, 0.15, 0.5];
/// See [`WAYS_IN`].
const OTHER_WAYS: [f64; 3] = [0.0, 6.0, 9.0];
/// The cost of a flat that is good enough: no other is looked for.
const GOOD_FLAT: f64 = 5.0;

/// One level of flats, alike on all storeys; `None` where a section has no sound plan. The last attempt has more sections.
pub(super) fn flats(
    grounds: &[Ground],
    kind: Kind<'_>,
    known: Option<u32>,
    attempt: usize,
    stream: &mut Stream,
) -> Option<Vec<Cell>> {
    let mut cells = Vec::new();
    let brief = kind.brief;
    let mut landings = Landings { kind, attempt, unit: 0, stream };
    for ground in grounds {
        let wanted = known_section(grounds, brief, known).or(brief.typology.section).unwrap_or(USUAL_SECTION);
        let count = ((area(&ground.ring) / wanted).round() as usize).max(1);
        // Where a section has no plan, the storey may have one with sections of another size.
        let counts = match attempt {
            0 | 1 => [count, count + 1, count - 1],
            _ => [count + 2, 2 * count, 2 * count + 1],
        };
        let mut counts = counts.into_iter().filter(|count| *count > 0);
        cells.extend(counts.find_map(|count| landings.in_sections(ground, count))?);
    }
    Some(cells)
}

/// The landings of a level that are planned so far.
struct Landings<'a, 'b> {
    kind: Kind<'a>,
    attempt: usize,
    /// Flats so far.
    unit: usize,
    stream: &'b mut Stream,
}

impl Landings<'_, '_> {
    /// A ground in so many sections.
    fn in_sections(&mut self, ground: &Ground, count: usize) -> Option<Vec<Cell>> {
        let before = self.unit;
        let mut cells = Vec::new();
        for ring in sections(ground, ground.ring.clone(), count) {
            let Some(rooms) = self.section(&ground.part(ring)) else {
                self.unit = before;
                return None;
            };
            cells.extend(rooms);
        }
        Some(cells)
    }

    /// A section, where the first attempt failed perhaps in parts, or as a loft.
    fn section(&mut self, section: &Ground) -> Option<Vec<Cell>> {
        if let Some(cells) = self.landing(section) {
            return Some(cells);
        }
        if self.attempt == 0 {
            return None;
        }
        let before = self.unit;
        for count in PARTS {
            let parts = sections(section, section.ring.clone(), count);
            if parts.len() > 1 {
                let rooms = parts.into_iter().map(|ring| self.part(&section.part(ring)));
                if let Some(cells) = rooms.collect::<Option<Vec<_>>>() {
                    return Some(cells.concat());
                }
                self.unit = before;
            }
        }
        self.loft(section)
    }

    fn part(&mut self, part: &Ground) -> Option<Vec<Cell>> {
        self.landing(part).or_else(|| self.loft(part))
    }

    fn landing(&mut self, section: &Ground) -> Option<Vec<Cell>> {
        landing(section, self.kind, &mut self.unit, self.stream)
    }

    fn loft(&mut self, section: &Ground) -> Option<Vec<Cell>> {
        let may_be = self.attempt >= LOFT_ATTEMPT;
        if may_be { loft(section, self.kind.typologies, &mut self.unit) } else { None }
    }
}

/// A flat of one room in a section whose form leaves no other: stairs first, then the room and its bath.
fn loft(section: &Ground, typologies: &Typologies, unit: &mut usize) -> Option<Vec<Cell>> {
    let services = [("stairs", LOFT_STAIRS), ("bathroom", LOFT_BATH)];
    let mut cells = part_cells(
        section,
        End { services: &services, has_stairs: true, typologies, is_careful: false },
        "studio",
    )?;
    for cell in cells.iter_mut().filter(|cell| cell.room_type != "stairs") {
        cell.unit = Some(*unit);
    }
    *unit += 1;
    cells.sort_by_key(|cell| cell.unit.is_some());
    let has_bath = cells.iter().any(|cell| cell.room_type == "bathroom");
    // People come in by the stairs.
    let has_door =
        |cell: &Cell| longest(section.light(&cell.ring)).map_or(0.0, Segment::length) >= STAIRS_LIGHT;
    let is_reached = cells.iter().filter(|cell| cell.room_type == "stairs").all(has_door);
    (has_bath && is_reached && area(&section.ring) <= LARGEST_LOFT).then_some(cells)
}

/// Square metres of a section with two flats, where the map says how many flats a building has.
fn known_section(grounds: &[Ground], brief: &Brief<'_>, known: Option<u32>) -> Option<f64> {
    let total: f64 = grounds.iter().map(|ground| area(&ground.ring)).sum();
    let on_level = f64::from(known.filter(|flats| *flats > 0)?) / f64::from(brief.storeys);
    Some((2.0 * total / on_level.max(1.0)).clamp(KNOWN_SECTION.0, KNOWN_SECTION.1))
}

/// Cuts a ring into so many pieces of about one size, each with light.
pub(super) fn sections(ground: &Ground, ring: Ring, count: usize) -> Vec<Ring> {
    // No recursion: a plate of a thousand sections may lose one with each cut.
    let mut open = vec![(ring, count)];
    let mut done = Vec::new();
    while let Some((ring, count)) = open.pop() {
        let Some(pieces) = best_pieces(ground, &ring, count) else {
            done.push(ring);
            continue;
        };
        let each = area(&ring) / count as f64;
        let share = |ring: &Ring| (area(ring) / each).round().clamp(1.0, count as f64 - 1.0) as usize;
        open.extend(pieces.into_iter().rev().map(|ring| {
            let share = share(&ring);
            (ring, share)
        }));
    }
    done
}

/// The pieces of a ring of several sections after the best cut; `None` if there is nothing to cut.
fn best_pieces(ground: &Ground, ring: &Ring, count: usize) -> Option<Vec<Ring>> {
    if count < 2 {
        return None;
    }
    let total = area(ring);
    let each = total / count as f64;
    let mut best: Option<(f64, Vec<Ring>)> = None;
    for (axis, at) in cuts(ring, count) {
        let (below, above) = split(ring, axis, at);
        let chords = below.iter().flat_map(|first| above.iter().map(move |second| shared(first, second)));
        let chord: f64 = chords.map(|border| total_length(&border)).sum();
        let pieces: Vec<Ring> = below.into_iter().chain(above).collect();
        if !(2..=MOST_PIECES).contains(&pieces.len()) {
            continue;
        }
        let imbalance = |ring: &Ring| {
            let share = area(ring) / each;
            libm::log(share / share.round().max(1.0)).abs()
        };
        let light = |ring: &Ring| total_length(&ground.light(ring)) / area(ring);
        let slender = |ring: &Ring| {
            let size = bounds(ring).size();
            (size.max_element() / size.min_element() - 2.2).max(0.0)
                + (1.0 - area(ring) / (size.x * size.y)) * 2.0
        };
        let least_light = pieces.iter().map(light).fold(f64::INFINITY, f64::min);
        let darkness = (0.12 - least_light).max(0.0) * 40.0;
        let shape: f64 = pieces.iter().map(|ring| 2.0 * imbalance(ring) + slender(ring)).sum();
        let cost = shape + chord / total.sqrt() + darkness;
        if best.as_ref().is_none_or(|(known, _)| cost < *known - 1e-9) {
            best = Some((cost, pieces));
        }
    }
    best.map(|(_, pieces)| pieces)
}

/// Lines that a ring may be cut along: at its inner corners, and at equal shares.
fn cuts(ring: &Ring, count: usize) -> Vec<(Axis, f64)> {
    let mut found = Vec::new();
    for axis in [Axis::X, Axis::Y] {
        let (low, high) = extent(ring, axis);
        let mut places: Vec<f64> = inner_corners(ring).map(|corner| along(corner, axis)).collect();
        places.extend((1..count).take(12).map(|share| low + (high - low) * share as f64 / count as f64));
        places.retain(|place| *place > low + 2.5 && *place < high - 2.5);
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| (*a - *b).abs() < 0.3);
        places.truncate(24);
        found.extend(places.into_iter().map(|place| (axis, (place * 1000.0).round() / 1000.0)));
    }
    found
}

/// The stairs of a section and its flats.
fn landing(section: &Ground, kind: Kind<'_>, unit: &mut usize, stream: &mut Stream) -> Option<Vec<Cell>> {
    let size = bounds(&section.ring).size();
    let first_turned = size.y > size.x;
    let turned = section.turned();
    let mut ways: Vec<(bool, Core)> = Vec::new();
    for is_turned in [first_turned, !first_turned] {
        let ground = if is_turned { &turned } else { section };
        ways.extend(cores(ground, kind.brief.storeys).into_iter().map(|core| (is_turned, core)));
    }
    // Two flats where there is floor for them, one flat else.
    let wants_two = area(&section.ring) >= TWO_FLATS;
    ways.sort_by_key(|(_, core)| core.has_two_flats() != wants_two);
    for (is_turned, core) in ways {
        let ground = if is_turned { &turned } else { section };
        let Some(mut cells) = flats_at(ground, core, kind, stream) else { continue };
        trade_thin_parts(&mut cells, Rules::of_rooms(kind.typologies));
        if !is_joined(&cells, kind, stream) {
            continue;
        }
        let first = *unit;
        for cell in &mut cells {
            if is_turned {
                cell.ring = turned_ring_back(&cell.ring);
            }
            if let Some(number) = &mut cell.unit {
                *number += first;
                *unit = (*unit).max(*number + 1);
            }
        }
        return Some(cells);
    }
    None
}

/// Whether stairs and lift are wide enough, and lead to all flats.
fn is_joined(cells: &[Cell], kind: Kind<'_>, stream: &mut Stream) -> bool {
    let Kind { brief, typologies, .. } = kind;
    let mut shared = cells.iter().filter(|cell| cell.unit.is_none());
    let is_wide = |cell: &Cell| {
        let needs = typologies.rooms.get(&cell.room_type);
        !has_thin_parts(&cell.ring) && needs.is_none_or(|needs| is_as_wide_as(&cell.ring, needs.width))
    };
    let partition = || Partition::new(cells, typologies, brief.typology.interior);
    shared.all(is_wide) && link(&partition(), &[], true, stream).unreached.is_empty()
}

/// Stairs, perhaps with a lift, and the outlines of the flats beside them.
struct Core {
    stairs: Ring,
    lift: Option<Ring>,
    flats: Vec<Ring>,
}

impl Core {
    /// Whether there are two flats of about one size.
    fn has_two_flats(&self) -> bool {
        match self.flats.as_slice() {
            [smaller, larger] => area(smaller) >= LEAST_SHARE * area(larger),
            _ => false,
        }
    }
}

fn cores(ground: &Ground, storeys: u32) -> Vec<Core> {
    let (left, right) = extent(&ground.ring, Axis::X);
    let width = right - left;
    let strip = if storeys >= LIFT_STOREYS { STAIRS_AND_WAY_WIDTH } else { STAIRS_WIDTH };
    let mut places = Vec::new();
    if area(&ground.ring) >= TWO_FLATS && width > 11.0 {
        places.extend([0.5, 0.42, 0.58].map(|share| left + width * share - strip / 2.0));
        places.extend(inner_corners(&ground.ring).map(|corner| corner.x).flat_map(|x| [x, x - strip]));
    }
    places.extend([left - 0.1, right - strip + 0.1, left + 0.5 * width - strip / 2.0]);
    places.retain(|from| *from >= left - 0.2 && from + strip <= right + 0.2);
    places.truncate(8);
    let mut found = Vec::new();
    for from in places {
        for is_top in [false, true] {
            found.extend(core(ground, (from, from + strip), is_top, storeys));
        }
    }
    // Where the entrance is, else on the street.
    let entrance = ground.facade.entrance.map(|(_, at)| at);
    let key = |core: &Core| {
        let near = entrance
            .map_or(0.0, |at| bounds(&core.stairs).gap(crate::geometry::Bounds::around_point(at, 0.1)));
        if near < 1.0 { 0 } else { 1 }
    };
    found.sort_by_key(key);
    found
}

fn core(ground: &Ground, (from, to): (f64, f64), is_top: bool, storeys: u32) -> Option<Core> {
    let (slices, crumbs) = cut_along(std::slice::from_ref(&ground.ring), &[from, to]);
    let [left, middle, right] = slices.try_into().ok()?;
    if middle.is_empty() || crumbs.iter().map(|ring| area(ring)).sum::<f64>() > 1.0 {
        return None;
    }
    let (bottom, top) = extent(&middle, Axis::Y);
    let depth = top - bottom;
    if depth < 3.6 {
        return None;
    }
    let has_lift = storeys >= LIFT_STOREYS && depth > STAIRS_DEPTH + LIFT_DEPTH;
    let inner = STAIRS_DEPTH + if has_lift { LIFT_DEPTH } else { 0.0 };
    let cut = |ring: Ring, depth: f64| {
        let at = if is_top { top - depth } else { bottom + depth };
        let (below, above) = split(&ring, Axis::Y, at);
        let (mut outer, mut inner) = if is_top { (above, below) } else { (below, above) };
        (outer.len() == 1 && inner.len() == 1).then(|| (outer.remove(0), inner.remove(0)))
    };
    let (block, rest) = match depth - inner {
        // What would be left is too little for a room.
        left_over if left_over < 2.2 => (middle, None),
        _ => cut(middle, inner).map(|(block, rest)| (block, Some(rest)))?,
    };
    let (stairs, lift) = match has_lift {
        true => cut(block, STAIRS_DEPTH).map(|(stairs, lift)| (stairs, Some(lift)))?,
        false => (block, None),
    };
    let light: f64 = longest(ground.light(&stairs)).map_or(0.0, Segment::length);
    if light < STAIRS_LIGHT {
        return None;
    }
    let mut flats: Vec<Ring> = [left, right].into_iter().filter(|ring| !ring.is_empty()).collect();
    flats.sort_by(|a, b| area(a).total_cmp(&area(b)));
    let mut rest = rest;
    for ring in &mut flats {
        if let Some(joined) = rest.as_ref().and_then(|rest| join(ring, rest)) {
            *ring = joined;
            rest = None;
        }
    }
    for crumb in crumbs {
        let place = flats.iter_mut().find_map(|ring| Some((join(ring, &crumb)?, ring)))?;
        *place.1 = place.0;
    }
    if rest.is_some() || flats.iter().any(|ring| area(ring) < LEAST_FLAT) {
        return None;
    }
    Some(Core { stairs, lift, flats })
}

fn flats_at(ground: &Ground, core: Core, kind: Kind<'_>, stream: &mut Stream) -> Option<Vec<Cell>> {
    let mut cells = vec![Cell::shared(core.stairs.clone(), "stairs")];
    cells.extend(core.lift.map(|ring| Cell::shared(ring, "elevator")));
    let border = |ring: &Ring| longest(shared(ring, &core.stairs)).filter(|border| border.length() >= 1.2);
    let flat = |ring: Ring| {
        let border = border(&ring)?;
        let flat = ground.part(ring);
        let floor = kind.floor(&flat, border);
        (!kind.hopeless.knows(&floor)).then_some((border, flat, floor))
    };
    let flats: Vec<(Segment, Ground, Floor)> = core.flats.into_iter().map(flat).collect::<Option<_>>()?;
    let light = longest(ground.light(&core.stairs)).map(Segment::middle);
    for (number, (border, flat, floor)) in flats.into_iter().enumerate() {
        let ways = match light {
            Some(light) if border.start.distance(light) < border.end.distance(light) => [0.15, 0.85, 0.5],
            _ => WAYS_IN,
        };
        let rooms = kind.hopeless.unless_known(floor, || best_flat(&flat, (border, ways), kind, stream))?;
        cells.extend(rooms.into_iter().map(|cell| Cell { unit: Some(number), ..cell }));
    }
    Some(cells)
}

/// The best flat with its way in somewhere on a border.
pub(super) fn flat_at(
    flat: &Ground,
    border: Segment,
    kind: Kind<'_>,
    stream: &mut Stream,
) -> Option<Vec<Cell>> {
    kind.hopeless.unless_known(kind.floor(flat, border), || best_flat(flat, (border, WAYS_IN), kind, stream))
}

/// The best flat with its way in at one of some shares of a border, rather the first.
fn best_flat(
    flat: &Ground,
    (border, ways_in): (Segment, [f64; 3]),
    kind: Kind<'_>,
    stream: &mut Stream,
) -> Option<Vec<Cell>> {
    let Kind { brief, typologies, .. } = kind;
    let programmes = typologies.programmes.get(brief.typology.programme.as_deref()?)?;
    let floor = area(&flat.ring);
    let margin = 0.75f64.min(border.length() / 2.0);
    let shares =
        ways_in.map(|share| border.after((border.length() * share).clamp(margin, border.length() - margin)));
    // Along a corridor, that is the hall of the building, not of the flat.
    let (hall, hall_width) = match brief.typology.plan {
        PlanKind::CorridorFlats => ("corridor", FLAT_HALL_WIDTH),
        _ => (brief.typology.hall.as_deref()?, brief.typology.hall_width),
    };
    let task = |at: Point, programme| Task {
        ground: flat,
        port: Some(Port { at, way: border.normal() }),
        typologies,
        programme,
        hall,
        hall_width,
        has_stairs: false,
    };
    let mut strips = Strips::of(flat);
    let mut ways: [Option<Vec<Division>>; 3] = [const { None }; 3];
    for programme in fitting(programmes, floor, flat, typologies) {
        let mut best: Option<(f64, Vec<Cell>)> = None;
        for ((way, &at), price) in ways.iter_mut().zip(&shares).zip(OTHER_WAYS) {
            if best.is_some() && price == OTHER_WAYS[2] {
                break;
            }
            let task = task(at, programme);
            let divisions = way.get_or_insert_with(|| strips.divisions(task));
            for planned in plan(task, divisions, 1, stream) {
                let cost = planned.cost + price;
                if best.as_ref().is_none_or(|(known, _)| cost < *known) {
                    best = Some((cost, planned.cells));
                }
            }
            if best.as_ref().is_some_and(|(cost, _)| *cost < GOOD_FLAT) {
                break;
            }
        }
        if let Some((_, cells)) = best {
            return Some(cells);
        }
    }
    let port = Port { at: shares[1], way: border.normal() };
    (floor < 75.0).then(|| studio(flat, port, typologies)).flatten()
}
