//! Rooms along corridors: offices, hotels, schools, wards, and flats on a corridor.

use crate::geometry::Point;
use crate::layout::seed::Stream;

use super::brief::Brief;
use super::deep::{LIT_SIDE, Piece, light_beside, outer_strips};
use super::disc::is_as_wide_as;
use super::dwelling::{Cell, Port};
use super::fill::DOOR_STRETCH;
use super::flats::flat_at;
use super::hopeless::Kind;
use super::house::outer_port;
use super::open::large_rooms;
use super::ring::{Axis, Ring, area, bounds, join, longest, shared, split, turned, turned_back};
use super::spine::{Fixed, FixedKind, Ground, Row, Spine, extent, settle, turned_ring_back};
use super::thin::{Rules, trade_thin_parts};
use super::typology::{Light, PlanKind};
use super::wings::{Wing, compact, tree};

/// Metres along the corridor of stairs.
const STAIRS_WIDTH: f64 = 2.9;
/// Metres along the corridor of a lift, and its depth.
const LIFT: (f64, f64) = (2.1, 2.2);
/// Metres of the width of stairs at least.
const LEAST_STAIRS: f64 = 1.5;
/// Metres of depth of a row that stairs need.
const STAIRS_DEPTH: f64 = 4.0;
/// Metres of depth of stairs at most.
const DEEPEST_STAIRS: f64 = 6.0;
/// Metres of corridor from which on a wing has stairs.
const ONE_STAIRS: f64 = 12.0;
/// Metres to stairs at most from the far end of a wing, and of that what lies beyond the corridor, in a flat.
const FARTHEST_STAIRS: f64 = 33.0;
/// See [`FARTHEST_STAIRS`].
const BEYOND_CORRIDOR: f64 = 9.0;
/// Storeys from which on there is a lift.
const LIFT_STOREYS: u32 = 4;
/// Metres of corridor from which on a wing has stairs at both ends: nobody walks farther than 35 m to one.
const TWO_STAIRS: f64 = 24.0;
/// Metres between two stairs at most, for the same reason.
const STAIRS_APART: f64 = 46.0;
/// Metres of depth from which on rows lie on both sides of a corridor.
const TWO_ROWS: f64 = 9.0;
/// Metres of depth below which a wing has no corridor of its own.
const ONE_ROW: f64 = 4.2;
/// A side of a wing is dark where less than this share of its length has light.
const DARK_SIDE: f64 = 0.15;
/// Metres of depth of a row beside a dark side: stairs and stores are in it.
const DARK_ROW: f64 = 4.3;
/// Metres of depth of a row of flats, and of other rooms, that reach through to a dark side.
const DEEPEST_FLATS: f64 = 11.0;
/// See [`DEEPEST_FLATS`].
const DEEPEST_ROOMS: f64 = 7.0;
/// Rows shallower than this many metres belong to the corridor.
const LEAST_ROW: f64 = 1.7;
/// Depth of a bath at the corridor, and its width.
const BATH: (f64, f64) = (2.1, 1.75);
/// Metres of width of a bath with half of its walls at least, where the corridor is not quite parallel.
const LEAST_BATH: f64 = 1.68;
/// Metres of the walls of a room beside its bath, and of an outer wall that is not quite parallel.
const BESIDE_BATH: f64 = 0.4;
/// The room type of rooms that have a bath of their own.
const HOTEL_ROOM: &str = "hotel_room";
/// How many times as deep as wide a small room of a row is at most, where the row has place for it, and how many times as large as
/// asked for it becomes so: cubicles stand beside each other, shelves on both sides of the way between them.
const SLENDEREST: f64 = 3.0;
/// See [`SLENDEREST`].
const MOST_SERVICE: f64 = 2.5;
/// Share of the rooms without windows that are stores, where the building has others that need none.
const STORES: f64 = 0.5;
/// Rooms that keep their form.
const STRAIGHT: [&str; 2] = ["stairs", "elevator"];
/// Metres by which a corridor is moved aside where it has no place, in this order.
const ASIDE: [f64; 7] = [0.0, 1.2, -1.2, 2.4, -2.4, 3.6, -3.6];
/// Share of a storey at most in which no corridor has a place.
const MOST_OPEN: f64 = 0.5;
/// Metres of the half of a way in.
const PORT_HALF: f64 = 0.95;
/// The numbers of the slices of a row that hold stairs, a lift, and a passage to the next corridor.
const STAIRS_SLICE: usize = 0;
/// See [`STAIRS_SLICE`].
const LIFT_SLICE: usize = 1;
/// See [`STAIRS_SLICE`].
const PASSAGE_SLICE: usize = 2;

/// What a level along corridors is planned from.
struct Task<'a> {
    ground: &'a Ground,
    kind: Kind<'a>,
    hall: &'a str,
    main: &'a str,
    module: (f64, f64),
    /// Whether corridors run in the middle of their wings, wherever the light is.
    is_plain: bool,
    /// Small rooms that are still wanted.
    services: Vec<(&'a str, f64)>,
    unit: usize,
    stream: &'a mut Stream,
}

/// One level, alike on all storeys; `None` where it does not come out. Later attempts are plainer, and the last cuts more wings.
pub(super) fn corridors(
    grounds: &[Ground],
    kind: Kind<'_>,
    attempt: usize,
    stream: &mut Stream,
) -> Option<Vec<Cell>> {
    let brief = kind.brief;
    let mut rings = Vec::new();
    for ground in grounds {
        compact(ground.ring.clone(), attempt > 1, &mut rings);
    }
    let whole = grounds.first()?;
    let entrance = whole.facade.entrance.map(|(_, at)| at);
    let has_cores = attempt == 0 && brief.typology.plan == PlanKind::Corridor;
    let pieces = rings.into_iter().flat_map(|ring| match has_cores {
        true => outer_strips(whole, ring, brief.typology.hall_width),
        false => vec![Piece { ring, is_outer: false }],
    });
    let hall = brief.typology.hall.as_deref()?;
    let mut wings = tree(without_spurs(pieces.collect(), hall, kind), entrance)?;
    let floor: f64 = grounds.iter().map(|ground| area(&ground.ring)).sum();
    let mut task = Task {
        ground: whole,
        kind,
        hall,
        main: brief.typology.main.as_deref().unwrap_or("studio"),
        module: brief.typology.module?,
        is_plain: attempt > 0,
        services: brief.typology.services_of(if attempt > 1 { 0.0 } else { floor }),
        unit: 0,
        stream,
    };
    // People come in where the entrance is, if that wing has it.
    let (door, port) = wings.iter().enumerate().find_map(|(number, wing)| {
        let ground = Ground { ring: wing.ring.clone(), ..whole.clone() };
        Some((number, outer_port(&ground)?))
    })?;
    wings[door].ports.push(port);
    let mut cells = Vec::new();
    let mut ways: Vec<WayOut> = Vec::new();
    let mut open = 0.0;
    for wing in &wings {
        let far = wing.parent.map_or(0.0, |parent| {
            wing.joined.iter().map(|&at| ways[parent].metres_from(at)).fold(0.0, f64::max)
        });
        let own = longest_way(wing, brief.typology.hall_width);
        let is_far = far + own + BEYOND_CORRIDOR > FARTHEST_STAIRS;
        let is_root = wing.parent.is_none();
        let access = Access { is_root, has_stairs: is_root || is_far || own > ONE_STAIRS };
        let services = task.services.clone();
        let own = wing_cells(&mut task, wing, access);
        if own.is_none() {
            task.services = services;
            open += area(&wing.ring);
        }
        let own = own.or_else(|| open_wing(&task, wing, access))?;
        ways.push(WayOut::of(&own, wing, far));
        cells.extend(own);
    }
    (open <= MOST_OPEN * floor).then_some(cells)
}

/// The pieces of a storey of which each gives what is too thin for a row beside a corridor to its neighbours.
fn without_spurs(pieces: Vec<Piece>, hall: &str, kind: Kind<'_>) -> Vec<Piece> {
    let mut cells: Vec<Cell> = pieces.iter().map(|piece| Cell::shared(piece.ring.clone(), hall)).collect();
    trade_thin_parts(&mut cells, Rules::of_rooms(kind.typologies).below(LEAST_ROW));
    pieces.into_iter().zip(cells).map(|(piece, Cell { ring, .. })| Piece { ring, ..piece }).collect()
}

/// A wing in which no corridor has a place, where the kind of building has a use for such.
fn open_wing(task: &Task<'_>, wing: &Wing, access: Access) -> Option<Vec<Cell>> {
    let Brief { typology, storeys, .. } = task.kind.brief;
    let ground = task.ground.part(wing.ring.clone());
    let has_stairs = *storeys > 1 && access.has_stairs;
    Some(large_rooms(&ground, typology.open_wing.as_deref()?, has_stairs, task.kind.typologies))
}

/// Metres along its corridor to where a wing is joined to its parent, at most, about.
fn longest_way(wing: &Wing, width: f64) -> f64 {
    let size = bounds(&wing.ring).size();
    let (length, depth) = (size.max_element(), size.min_element());
    if wing.joined.len() < 2 {
        return length;
    }
    // Halfway to the next such place, and through a row where one lies before the corridor.
    let across = if depth - width > DEEPEST_ROOMS { 0.5 * depth } else { 0.0 };
    0.5 * length / wing.joined.len() as f64 + across
}

/// What a wing has besides rooms.
#[derive(Clone, Copy)]
struct Access {
    /// Whether it is the wing that the others are joined to.
    is_root: bool,
    /// Whether it has stairs of its own, where there are any.
    has_stairs: bool,
}

/// The way from a wing to stairs.
struct WayOut {
    /// The middles of its own stairs.
    stairs: Vec<Point>,
    /// Where it is joined to its parent; the root is nowhere.
    joined: Vec<Point>,
    /// Metres from the farthest of these places to the parent's stairs.
    far: f64,
}

impl WayOut {
    fn of(cells: &[Cell], wing: &Wing, far: f64) -> Self {
        let stairs = cells.iter().filter(|cell| cell.room_type == "stairs");
        Self {
            stairs: stairs.map(|cell| bounds(&cell.ring).center()).collect(),
            joined: wing.joined.clone(),
            far,
        }
    }

    /// Metres from a place in the corridor to stairs, about.
    fn metres_from(&self, place: Point) -> f64 {
        // Corridors run along the axes.
        let metres = |at: &Point| (*at - place).abs().element_sum();
        let nearest = |places: &[Point]| places.iter().map(metres).reduce(f64::min);
        nearest(&self.stairs).unwrap_or_else(|| nearest(&self.joined).map_or(0.0, |near| self.far + near))
    }
}

fn wing_cells(task: &mut Task<'_>, wing: &Wing, access: Access) -> Option<Vec<Cell>> {
    let is_turned = wing.axis == Axis::Y;
    let own = task.ground.part(wing.ring.clone());
    let turn = |point: Point| if is_turned { super::ring::turned_point(point) } else { point };
    let ground = if is_turned { own.turned() } else { own };
    // Turning clockwise leads y to x, and x to the other way of y.
    let middle = if is_turned { -wing.middle } else { wing.middle };
    let turned = |ports: &[Port]| -> Vec<Port> {
        ports.iter().map(|port| Port { at: turn(port.at), way: turn(port.way) }).collect()
    };
    let ways = Ways { ports: turned(&wing.ports), passages: turned(&wing.passages), middle };
    let depth = area(&ground.ring) / bounds(&ground.ring).size().x;
    let cells = if depth < ONE_ROW && !access.is_root && ways.ports.len() == 1 {
        vec![Cell::shared(ground.ring.clone(), task.main)]
    } else {
        along_corridor(task, &ground, &ways, access)?
    };
    let back = |cell: Cell| match is_turned {
        true => Cell { ring: cell.ring.iter().map(|corner| turned_back(*corner)).collect(), ..cell },
        false => cell,
    };
    Some(cells.into_iter().map(back).collect())
}

/// The ways of a wing, in its own frame.
struct Ways {
    /// Where its corridor is left: see [`Wing`].
    ports: Vec<Port>,
    /// See `ports`.
    passages: Vec<Port>,
    /// Where the middle of its corridor is, if nothing else moves it.
    middle: f64,
}

fn along_corridor(task: &mut Task<'_>, ground: &Ground, ways: &Ways, access: Access) -> Option<Vec<Cell>> {
    let width = task.kind.brief.typology.hall_width;
    let place = corridor_place(task, ground, ways.middle);
    // Where a jog of the outline is in its way, it runs beside that.
    let spines = ASIDE.into_iter().filter_map(|aside| {
        let strip = (place + aside, place + aside + width);
        Spine::new(ground, strip.0, strip.1, &fixed_slices(task, ground, ways, strip, access))
    });
    let has_wide_stairs = |spine: &Spine| {
        let mut stairs = spine.fixed.iter().filter(|(number, _)| *number == STAIRS_SLICE);
        stairs.all(|(_, ring)| is_as_wide_as(ring, LEAST_STAIRS))
    };
    let Spine { mut strip, rows, fixed: rooms, mut left_over } = spines.into_iter().find(has_wide_stairs)?;
    let mut cells: Vec<Cell> = Vec::new();
    for (number, ring) in rooms {
        match number {
            LIFT_SLICE => cells.extend(lift(ring, &strip)?),
            PASSAGE_SLICE => cells.push(Cell::shared(ring, task.hall)),
            _ => {
                let (stairs, rest) = stairs(ring, &strip);
                cells.push(Cell::shared(stairs, "stairs"));
                left_over.extend(rest);
            }
        }
    }
    let mut order: Vec<&Row> = rows.iter().collect();
    order.sort_by(|a, b| {
        let light = |row: &Row| row.light_between(row.from, row.to) / row.length();
        light(a).total_cmp(&light(b)).then(a.from.total_cmp(&b.from))
    });
    for row in order {
        let contact = row.contact_between(row.from, row.to).map_or(0.0, |(from, to)| to - from);
        if row.depth() < LEAST_ROW || contact < DOOR_STRETCH {
            left_over.push(Ring::clone(&row.ring));
            continue;
        }
        cells.extend(row_cells(task, ground, row, &strip, &mut left_over)?);
    }
    let mut rings: Vec<Ring> = vec![std::mem::take(&mut strip)];
    rings.extend(cells.iter().map(|cell| cell.ring.clone()));
    // Flights are straight: stairs and lifts take what is left over only where nobody else does.
    let is_straight = |index: usize| index > 0 && STRAIGHT.contains(&cells[index - 1].room_type.as_str());
    let rest = settle(left_over, &mut rings, |index| match index {
        0 => 0.5,
        _ if is_straight(index) => 0.0,
        _ => 1.0,
    });
    let rest = settle(rest, &mut rings, |_| 1.0);
    if rest.iter().map(|ring| area(ring)).sum::<f64>() > 0.05 {
        return None;
    }
    let mut rings = rings.into_iter();
    let hall = Cell::shared(rings.next()?, task.hall);
    let cells = cells.into_iter().zip(rings).map(|(cell, ring)| Cell { ring, ..cell });
    Some(std::iter::once(hall).chain(cells).collect())
}

/// Where the lower side of the corridor of a wing is: about the middle, or by a wall without light.
fn corridor_place(task: &Task<'_>, ground: &Ground, middle: f64) -> f64 {
    let width = task.kind.brief.typology.hall_width;
    let (bottom, top) = extent(&ground.ring, Axis::Y);
    let length = bounds(&ground.ring).size().x;
    let depth = area(&ground.ring) / length;
    let [below, above] = light_beside(ground, Axis::X, 0.5 * (bottom + top));
    let is_above_dark = above < below;
    let is_dark = !task.is_plain && below.min(above) < DARK_SIDE * length;
    let deepest =
        if task.kind.brief.typology.plan == PlanKind::CorridorFlats { DEEPEST_FLATS } else { DEEPEST_ROOMS };
    if depth < TWO_ROWS || is_dark && depth - width < deepest {
        // One row, on the side with more light.
        return if is_above_dark { top - width + 0.1 } else { bottom - 0.1 };
    }
    let rest = depth - width - DARK_ROW;
    let is_deep = rest >= deepest + 2.0;
    let is_lit_across = below.max(above) >= LIT_SIDE * length;
    if is_dark && rest > DARK_ROW && (is_lit_across || !is_deep) {
        // Stairs and stores there, no deeper than stairs are, unless the rooms across would be too deep.
        let dark = if is_deep { depth - width - (deepest + 2.0) } else { DARK_ROW };
        return if is_above_dark { top - dark - width } else { bottom + dark };
    }
    (middle - width / 2.0).max(bottom + LEAST_ROW).min(top - width - LEAST_ROW)
}

/// Ways in at the sides of rows, and stairs at the ends of the corridor.
fn fixed_slices(
    task: &Task<'_>,
    ground: &Ground,
    ways: &Ways,
    (low, high): (f64, f64),
    access: Access,
) -> Vec<Fixed> {
    let (left, right) = extent(&ground.ring, Axis::X);
    let (bottom, top) = extent(&ground.ring, Axis::Y);
    let mut fixed = Vec::new();
    let ports = ways.ports.iter().map(|port| (port, FixedKind::Port));
    let passages = ways.passages.iter().map(|port| (port, FixedKind::Room(PASSAGE_SLICE)));
    for (port, kind) in ports.chain(passages) {
        let is_in_strip = port.at.y > low + 0.6 && port.at.y < high - 0.6;
        if port.way.y.abs() > port.way.x.abs() || !is_in_strip {
            let is_above = port.at.y > 0.5 * (low + high);
            // Where no row is, the corridor itself is at the wall.
            let depth = if is_above { top - high } else { low - bottom };
            if depth < LEAST_ROW / 2.0 {
                continue;
            }
            let from = (port.at.x - PORT_HALF).min(right - 2.0 * PORT_HALF).max(left);
            fixed.push(Fixed { is_above, from, to: from + 2.0 * PORT_HALF, kind });
        }
    }
    if task.kind.brief.storeys > 1 {
        let is_above = is_darker_above(ground, (low, high));
        if access.has_stairs {
            add_stairs(&mut fixed, (left, right), is_above);
        }
        if access.is_root && task.kind.brief.storeys >= LIFT_STOREYS {
            add_lift(&mut fixed, (left, right), is_above);
        }
    }
    fixed
}

/// The side of a corridor where stairs take the least light.
fn is_darker_above(ground: &Ground, (low, high): (f64, f64)) -> bool {
    let (bottom, top) = extent(&ground.ring, Axis::Y);
    let [below, above] = light_beside(ground, Axis::X, 0.5 * (low + high));
    match (top - high > STAIRS_DEPTH, low - bottom > STAIRS_DEPTH) {
        (true, false) => true,
        (false, true) => false,
        _ => above < below,
    }
}

/// Whether no slice on a side is in the way.
fn is_free(fixed: &[Fixed], is_above: bool, from: f64, to: f64) -> bool {
    fixed.iter().all(|slice| slice.is_above != is_above || slice.to <= from + 0.01 || slice.from >= to - 0.01)
}

/// Stairs at one end of a corridor or more places; as near to them as other slices let them.
fn add_stairs(fixed: &mut Vec<Fixed>, (left, right): (f64, f64), is_above: bool) {
    let length = right - left;
    // At one end, at both of a long corridor, and between them so that no two are far apart.
    let gaps = if length > TWO_STAIRS { (length / STAIRS_APART).ceil() as u32 } else { 0 };
    for number in 0..=gaps {
        let wanted = left + (length - STAIRS_WIDTH) * f64::from(number) / f64::from(gaps.max(1));
        let inwards = if wanted > 0.5 * (left + right) { -1.5 } else { 1.5 };
        // Beyond the ends, for outlines are not quite straight.
        let wanted = match number {
            0 => wanted - 0.1,
            _ if number == gaps => wanted + 0.1,
            _ => wanted,
        };
        let mut places = (0..12).map(|step| wanted + inwards * f64::from(step));
        let place = places.find(|&from| {
            let is_inside = from >= left - 0.2 && from + STAIRS_WIDTH <= right + 0.2;
            is_inside && is_free(fixed, is_above, from, from + STAIRS_WIDTH)
        });
        if let Some(from) = place {
            fixed.push(Fixed {
                is_above,
                from,
                to: from + STAIRS_WIDTH,
                kind: FixedKind::Room(STAIRS_SLICE),
            });
        }
    }
}

/// A lift beside the stairs.
fn add_lift(fixed: &mut Vec<Fixed>, (left, right): (f64, f64), is_above: bool) {
    let stairs = fixed.iter().find(|slice| slice.kind == FixedKind::Room(STAIRS_SLICE)).copied();
    let mut places = stairs.into_iter().flat_map(|slice| [slice.to, slice.from - LIFT.0]);
    let place = places.find(|&from| {
        from >= left - 0.01 && from + LIFT.0 <= right + 0.01 && is_free(fixed, is_above, from, from + LIFT.0)
    });
    fixed.extend(place.map(|from| Fixed {
        is_above,
        from,
        to: from + LIFT.0,
        kind: FixedKind::Room(LIFT_SLICE),
    }));
}

/// Stairs at the corridor, and what is left of a row that is deeper.
fn stairs(ring: Ring, strip: &[Point]) -> (Ring, Option<Ring>) {
    if bounds(&ring).size().y < DEEPEST_STAIRS + LEAST_ROW {
        return (ring, None);
    }
    match at_corridor(&ring, strip, DEEPEST_STAIRS) {
        Some((stairs, rest)) => (stairs, Some(rest)),
        None => (ring, None),
    }
}

/// The part of a room up to some metres from the corridor, and what lies beyond; `None` where either is not one piece.
fn at_corridor(ring: &Ring, strip: &[Point], depth: f64) -> Option<(Ring, Ring)> {
    let border = longest(shared(ring, strip))?.middle();
    let is_above = border.y < bounds(ring).center().y;
    let (below, above) = split(ring, Axis::Y, border.y + if is_above { depth } else { -depth });
    let ([below], [above]) = (<[Ring; 1]>::try_from(below).ok()?, <[Ring; 1]>::try_from(above).ok()?);
    Some(if is_above { (below, above) } else { (above, below) })
}

/// A lift at the corridor, with a shaft behind it where the row is deeper.
fn lift(ring: Ring, strip: &[Point]) -> Option<Vec<Cell>> {
    if bounds(&ring).size().y < LIFT.1 + 0.8 {
        return Some(vec![Cell::shared(ring, "elevator")]);
    }
    let (lift, shaft) = at_corridor(&ring, strip, LIFT.1)?;
    Some(vec![Cell::shared(lift, "elevator"), Cell::shared(shaft, "shaft")])
}

/// A small room of a row.
#[derive(Clone, Copy)]
struct SmallRoom<'a> {
    /// Its type, and the square metres that are wanted of it.
    wanted: (&'a str, f64),
    /// Metres of the row that it takes.
    width: f64,
}

/// The small rooms that are wanted and have a place in a row, the first that has none ends them.
fn small_rooms<'a>(task: &mut Task<'a>, row: &Row) -> Option<Vec<SmallRoom<'a>>> {
    // As far as the row goes; in a lit row of a hotel or a school at most a third of it.
    let is_lit = row.light_between(row.from, row.to) >= 1.0;
    let most = if is_lit { row.length() / 3.0 } else { row.length() };
    let mut used = 0.0;
    let mut small = Vec::new();
    while let Some(&(room_type, wanted)) = task.services.first() {
        let needs = task.kind.typologies.rooms.get(room_type)?;
        let least = (wanted / row.depth()).max(needs.width + 0.2);
        let good = (row.depth() / SLENDEREST).min(MOST_SERVICE * wanted / row.depth()).max(least);
        let width = if used + good > most { least } else { good };
        if used + width > most {
            break;
        }
        used += width;
        small.push(SmallRoom { wanted: task.services.remove(0), width });
    }
    Some(small)
}

/// The rooms of a row.
fn row_cells(
    task: &mut Task<'_>,
    ground: &Ground,
    row: &Row,
    strip: &[Point],
    left_over: &mut Vec<Ring>,
) -> Option<Vec<Cell>> {
    let small = small_rooms(task, row)?;
    let mut kinds: Vec<(String, f64)> =
        small.iter().map(|room| (room.wanted.0.to_owned(), room.width)).collect();
    let used: f64 = small.iter().map(|room| room.width).sum();
    let left = row.length() - used;
    let module = task.stream.between(task.module.0, task.module.1);
    let is_dark = row.light_between(row.from, row.to) < 1.0;
    let count = room_count(task, if is_dark { f64::INFINITY } else { row.depth() }, left, module);
    for _ in 0..count {
        let room_type = if is_dark { dark_type(task) } else { lit_type(task) };
        kinds.push((room_type.to_owned(), left / count as f64));
    }
    if kinds.is_empty() {
        left_over.push(Ring::clone(&row.ring));
        return Some(Vec::new());
    }
    if count == 0 {
        let scale = row.length() / used;
        kinds.iter_mut().for_each(|(_, width)| *width *= scale);
    }
    let mut at = row.from;
    let places: Vec<f64> = kinds[..kinds.len() - 1]
        .iter()
        .map(|(_, width)| {
            at += width;
            (at * 100.0).round() / 100.0
        })
        .collect();
    let (rings, crumbs) = row.cut(&places);
    left_over.extend(crumbs);
    let mut cells = Vec::new();
    for (index, ((room_type, _), ring)) in kinds.into_iter().zip(rings).enumerate() {
        if ring.is_empty() {
            task.services.extend(small.get(index).map(|room| room.wanted));
            continue;
        }
        let has_light = ground.light(&ring).iter().any(|piece| piece.length() >= 1.0);
        let fitting = fitting_type(task, &room_type, &ring, has_light);
        // A small room that is none of its type here is wanted in another row.
        let lost = small.get(index).filter(|_| fitting != room_type);
        task.services.extend(lost.map(|room| room.wanted));
        let room_type = fitting;
        cells.extend(room_cells(task, ground, Cell { ring, room_type, unit: None }, strip, index)?);
    }
    Some(cells)
}

/// How many rooms of about a module's width a stretch of a row is parted into. Where the row is too shallow for a bed behind a bath, the
/// bed stands beside it, in a room that is wide enough for both.
fn room_count(task: &Task<'_>, depth: f64, stretch: f64, module: f64) -> usize {
    let width = task.kind.typologies.rooms.get(task.main).map_or(0.0, |needs| needs.width);
    let is_beside = task.main == HOTEL_ROOM && depth < BATH.0 + width;
    let count = if is_beside {
        (stretch / (BATH.1 + width + BESIDE_BATH)).floor()
    } else {
        (stretch / module).round()
    };
    (count as usize).max(usize::from(stretch > 1.2))
}

/// The type of a room at an outer wall: the building's main one, or another for some.
fn lit_type<'a>(task: &mut Task<'a>) -> &'a str {
    let mut others = task.kind.brief.typology.others.iter();
    let other = others.find(|(_, weight)| task.stream.unit() < **weight);
    other.map_or(task.main, |(room_type, _)| room_type)
}

/// The type of a room without windows: a store, or another of the building's that needs none, one or the other for half of them.
fn dark_type<'a>(task: &mut Task<'a>) -> &'a str {
    let rooms = &task.kind.typologies.rooms;
    let needs_none =
        |room_type: &str| rooms.get(room_type).is_some_and(|needs| needs.light != Light::Required);
    let mut others = task.kind.brief.typology.others.keys().map(String::as_str);
    let is_store = task.stream.unit() < STORES;
    others.find(|other| needs_none(other)).filter(|_| !is_store).unwrap_or("storeroom")
}

/// The type of a room where it is wide and light enough for it; else another of the building's in a lit room, else a store.
fn fitting_type(task: &Task<'_>, room_type: &str, ring: &Ring, has_light: bool) -> String {
    let needs = task.kind.typologies.rooms.get(room_type);
    let needs_light = needs.is_none_or(|needs| needs.light == Light::Required);
    if is_fit_for(task, room_type, ring) && (!needs_light || has_light) {
        return room_type.to_owned();
    }
    let mut others = task.kind.brief.typology.others.keys().filter(|_| has_light);
    others.find(|other| is_fit_for(task, other, ring)).map_or("storeroom", String::as_str).to_owned()
}

/// A room of a row: a flat with its rooms, a hotel room with its bath, or the room alone.
fn room_cells(
    task: &mut Task<'_>,
    ground: &Ground,
    cell: Cell,
    strip: &[Point],
    index: usize,
) -> Option<Vec<Cell>> {
    let Cell { ring, room_type, .. } = cell;
    if task.kind.brief.typology.plan == PlanKind::CorridorFlats && room_type == task.main {
        let border = longest(shared(&ring, strip))?;
        let flat = ground.part(ring);
        let cells = flat_at(&flat, border, task.kind, task.stream)?;
        task.unit += 1;
        return Some(cells.into_iter().map(|cell| Cell { unit: Some(task.unit), ..cell }).collect());
    }
    let is_hotel = room_type == HOTEL_ROOM;
    let bath = if is_hotel { with_bath(task, &ring, strip, index.is_multiple_of(2)) } else { None };
    if let Some((room, bath)) = bath {
        return Some(vec![Cell::shared(room, HOTEL_ROOM), Cell::shared(bath, "hotel_bathroom")]);
    }
    Some(vec![Cell { ring, room_type, unit: None }])
}

/// Whether a room is as wide as its type needs.
fn is_fit_for(task: &Task<'_>, room_type: &str, ring: &Ring) -> bool {
    task.kind.typologies.rooms.get(room_type).is_none_or(|needs| is_as_wide_as(ring, needs.width))
}

/// A hotel room that is wide enough beside its bath, which is at the corridor, on one side of the way into the room or on the other.
fn with_bath(task: &Task<'_>, ring: &Ring, strip: &[Point], is_left: bool) -> Option<(Ring, Ring)> {
    let border = longest(shared(ring, strip))?.vector();
    // At the end of a corridor it runs across the row.
    let is_across = border.y.abs() > border.x.abs();
    let framed = |ring: &[Point]| if is_across { turned(ring) } else { ring.to_vec() };
    let back = |ring: Ring| if is_across { turned_ring_back(&ring) } else { ring };
    let (ring, strip) = (framed(ring), framed(strip));
    let mut ways = [is_left, !is_left].into_iter().filter_map(|is_left| cut_bath(&ring, &strip, is_left));
    let is_fit =
        |(room, bath): &(Ring, Ring)| is_fit_for(task, HOTEL_ROOM, room) && is_as_wide_as(bath, LEAST_BATH);
    let (room, bath) = ways.find(is_fit)?;
    Some((back(room), back(bath)))
}

/// A room and a bath at its border on the corridor.
fn cut_bath(ring: &Ring, strip: &[Point], is_left: bool) -> Option<(Ring, Ring)> {
    let border = longest(shared(ring, strip))?;
    let (low, high) = (border.start.x.min(border.end.x), border.start.x.max(border.end.x));
    if high - low < BATH.1 + DOOR_STRETCH {
        return None;
    }
    let (front, room) = at_corridor(ring, strip, BATH.0)?;
    let (mut left, mut right) = split(&front, Axis::X, if is_left { low + BATH.1 } else { high - BATH.1 });
    if left.len() != 1 || right.len() != 1 {
        return None;
    }
    let (bath, way) = if is_left { (left.pop()?, right.pop()?) } else { (right.pop()?, left.pop()?) };
    Some((join(&room, &way)?, bath))
}
