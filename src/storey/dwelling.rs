//! Plans a flat, or a level of a house: a hall as a strip from the way in, and the rooms of a programme in rows beside it.

use crate::geometry::Point;
use crate::layout::seed::Stream;

use super::disc::{is_as_wide_as, is_simple};
use super::ends::{self, Middle};
use super::fill::{
    DOOR_STRETCH, Filling, Floor, LIGHT_EACH, Slice, WINDOW_STRETCH, Wanted, Wish, fill, needed,
};
use super::hall::Hall;
use super::links::room_at;
use super::ring::{Axis, Ring, area, bounds, join, shared_length, split, total_length};
use super::spine::{
    Band, Fixed, FixedKind, Ground, Row, Spine, StripRoom, extent, settle, trim, turned_ring_back,
};
use super::thin::{Rules, has_thin_parts, trade_strips, trade_thin_parts};
use super::typology::{Light, Programme, RoomNeeds, Typologies};

/// Where the programme of its size does not come out, a smaller one may: so many are tried.
pub(super) const MOST_PROGRAMMES: usize = 4;
/// Ways to fill the rows that are tried for each place of the strip.
const TRIES: u32 = 6;
/// Plans that are drawn of the best fillings until one is sound.
const DRAWN: usize = 8;
/// The same where rooms lie at the ends of the strip: fewer of them are sound, for outlines are narrow and crooked there.
const DRAWN_WITH_ENDS: usize = 24;
/// Metres of the half of a way in.
const PORT_HALF: f64 = 0.7;
/// Metres beyond the ground at which a strip along its edge begins: outlines are not quite straight.
pub(super) const FLUSH: f64 = 0.12;
/// Metres beside a strip that are no row: the strip lies at the edge.
const LEAST_ROW: f64 = 1.3;
/// Depth of stairs that stand in a row, in metres, least and most.
const STAIR_DEPTH: (f64, f64) = (2.2, 4.6);
/// Metres along the strip of stairs that stand in a row.
const STAIR_WIDTH: f64 = 2.1;
/// Metres of a flight beside the hall: its length and its width.
const FLIGHT: (f64, f64) = (3.9, 1.0);
/// Metres within which two ways to divide a ground are one.
const SAME_PLACE: f64 = 0.25;
/// Metres by which it is deeper than its least width.
const MORE_DEPTH: f64 = 0.2;
/// Metres of depth from which on the rest of the row is worth having for the room beside it.
const LEAST_REST: f64 = 1.6;
/// Cost of a room that the programme does not ask for.
const MORE_COST: f64 = 0.8;
/// Cost of each part of the floor that is hall.
const HALL_COST: f64 = 30.0;

/// A room of a storey.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// Its outline.
    pub(super) ring: Ring,
    /// Id of its room type.
    pub(super) room_type: String,
    /// Number of its flat or other unit on the level.
    pub(super) unit: Option<usize>,
}

impl Cell {
    /// A room that belongs to no unit so far.
    pub(super) fn shared(ring: Ring, room_type: &str) -> Self {
        Self { ring, room_type: room_type.to_owned(), unit: None }
    }
}

/// Where people come in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Port {
    /// A point on the border of the ground.
    pub(super) at: Point,
    /// The way in, of length 1.
    pub(super) way: Point,
}

/// How a level of a house is divided, so that others are divided alike.
#[derive(Clone, Debug)]
pub(super) struct Scheme {
    is_turned: bool,
    low: f64,
    high: f64,
    /// From where to where the strip reaches, where rooms lie at its ends.
    reach: Option<(f64, f64)>,
    stairs: Option<Stairs>,
}

/// Where the stairs of a house are.
#[derive(Clone, Copy, Debug)]
enum Stairs {
    /// A slice of a row.
    InRow(Fixed),
    /// A flight in the strip: from where to where along it, on its upper side or its lower.
    InStrip(f64, f64, bool),
}

/// What a dwelling's level is planned from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Task<'a> {
    /// The ground.
    pub(super) ground: &'a Ground,
    /// The way in; none of an upper level of a house.
    pub(super) port: Option<Port>,
    /// Needs of rooms.
    pub(super) typologies: &'a Typologies,
    /// The wished rooms.
    pub(super) programme: &'a Programme,
    /// Room type of the hall.
    pub(super) hall: &'a str,
    /// Metres of its width.
    pub(super) hall_width: f64,
    /// Whether stairs go up.
    pub(super) has_stairs: bool,
}

/// A level of a dwelling.
#[derive(Clone, Debug)]
pub(super) struct Planned {
    /// Its rooms, the hall first.
    pub(super) cells: Vec<Cell>,
    /// How it is divided.
    pub(super) scheme: Scheme,
    /// How far it is from what was wished for.
    pub(super) cost: f64,
}

/// A way to divide a ground, with the spine that it makes; any programme may fill it.
#[derive(Clone, Debug)]
pub(super) struct Division {
    scheme: Scheme,
    spine: Spine,
}

/// A ground, seen from both sides, and how it is cut along strips so far: ways in at other places mean the same cuts.
pub(super) struct Strips<'a> {
    ground: &'a Ground,
    turned: Ground,
    bands: Vec<((bool, f64, f64), Option<Band>)>,
}

impl<'a> Strips<'a> {
    /// Of a ground that is not cut yet.
    pub(super) fn of(ground: &'a Ground) -> Self {
        Self { ground, turned: ground.turned(), bands: Vec::new() }
    }

    fn side(&self, is_turned: bool) -> &Ground {
        if is_turned { &self.turned } else { self.ground }
    }

    fn spine(&mut self, scheme: &Scheme, ports: &[Fixed]) -> Option<Spine> {
        let key = (scheme.is_turned, scheme.low, scheme.high);
        let index = self.bands.iter().position(|(known, _)| *known == key).unwrap_or_else(|| {
            let band = Band::cut(self.side(scheme.is_turned), (scheme.low, scheme.high));
            self.bands.push((key, band));
            self.bands.len() - 1
        });
        let ground = if scheme.is_turned { &self.turned } else { self.ground };
        spine_of(ground, self.bands[index].1.as_mut()?, scheme, ports)
    }

    /// All ways to divide the ground of a task; they are the same for all programmes.
    pub(super) fn divisions(&mut self, task: Task<'_>) -> Vec<Division> {
        let mut found = Vec::new();
        for is_turned in [false, true] {
            let port = task.port.map(|port| if is_turned { port.turned() } else { port });
            for (scheme, ports) in schemes(self.side(is_turned), port, task, is_turned) {
                let spine = self.spine(&scheme, &ports);
                found.extend(spine.map(|spine| Division { scheme, spine }));
            }
        }
        found
    }

    /// The ways to divide the ground of a task with rooms at the ends of a strip.
    pub(super) fn divisions_with_ends(&self, task: Task<'_>) -> Vec<Division> {
        let mut found = Vec::new();
        for is_turned in [false, true] {
            let port = task.port.map(|port| if is_turned { port.turned() } else { port });
            let middles = port.map(|port| ends::middles(self.side(is_turned), port, task.has_stairs));
            let divided = |middle: &Middle| self.divided(middle, is_turned);
            found.extend(middles.unwrap_or_default().iter().flat_map(divided));
        }
        found
    }

    /// How levels may be divided that are above one.
    fn divisions_above(&mut self, below: &Scheme) -> Vec<Division> {
        match (below.reach, below.stairs) {
            (Some(_), Some(Stairs::InRow(stairs))) => {
                let middles = ends::alike(self.side(below.is_turned), (below.low, below.high), stairs);
                middles.iter().flat_map(|middle| self.divided(middle, below.is_turned)).collect()
            }
            _ => {
                let spine = self.spine(below, &[]);
                spine.map(|spine| Division { scheme: below.clone(), spine }).into_iter().collect()
            }
        }
    }

    /// The ways to divide the ground by a strip with rooms at its ends: one for each place of stairs, or one without.
    fn divided(&self, middle: &Middle, is_turned: bool) -> Vec<Division> {
        let ground = self.side(is_turned);
        let Middle { heights: (low, high), reach, stairs } = middle;
        let cut = ends::Parts::cut(ground, *reach).and_then(|parts| {
            let band = Band::cut(&parts.middle, (*low, *high))?;
            let rows = parts.rows(band.strip(), ground)?;
            Some((parts, band, rows))
        });
        let Some((parts, mut band, ends)) = cut else { return Vec::new() };
        let is_without = stairs.is_empty().then_some(None);
        let places = stairs.iter().copied().map(Some).chain(is_without);
        let divided = |stairs: Option<Fixed>| {
            let (is_turned, low, high, reach) = (is_turned, *low, *high, Some(*reach));
            let scheme = Scheme { is_turned, low, high, reach, stairs: stairs.map(Stairs::InRow) };
            let mut spine = spine_of(&parts.middle, &mut band, &scheme, &[])?;
            spine.rows.extend(ends.iter().cloned());
            Some(Division { scheme, spine })
        };
        places.filter_map(divided).collect()
    }
}

impl Scheme {
    /// Whether levels above both are the same: with rooms at the ends of the strip, the place of the stairs says what they may be.
    fn is_alike(&self, other: &Self) -> bool {
        let place = |scheme: &Self| match (scheme.reach, scheme.stairs) {
            (Some(_), Some(Stairs::InRow(stairs))) => Some((scheme.is_turned, scheme.low, stairs)),
            _ => None,
        };
        place(self).is_some() && place(self) == place(other)
    }
}

/// The best plans of a level, the best first, so many at most; empty if none is sound.
pub(super) fn plan(
    task: Task<'_>,
    divisions: &[Division],
    wanted: usize,
    stream: &mut Stream,
) -> Vec<Planned> {
    let wishes = wishes(task);
    let wanted_rooms = with_and_without_last(&wishes);
    let mut drafts = Vec::new();
    for division in divisions {
        let spine = &division.spine;
        let hall = hall_of(task, &division.scheme);
        if let Some(filling) = fill_or_more(Floor { rows: &spine.rows, hall }, &wanted_rooms, TRIES, stream) {
            let strip_cost = match hall {
                Some(_) => filling.hall_cost,
                None => HALL_COST * area(&spine.strip) / area(&task.ground.ring),
            };
            drafts.push((filling.cost + strip_cost, division, filling));
        }
    }
    draw_best(task, drafts, &wishes, wanted)
}

/// The hall, where it may end before the strip does: stairs of a house stand in the same strip on all levels.
fn hall_of<'a>(task: Task<'a>, scheme: &Scheme) -> Option<Hall<'a>> {
    if task.has_stairs {
        return None;
    }
    let port = task.port.map(|port| if scheme.is_turned { port.turned() } else { port });
    let width = scheme.high - scheme.low;
    Some(Hall {
        room_type: task.hall,
        port: port.map(|Port { at, .. }| (at.x - PORT_HALF, at.x + PORT_HALF)),
        per_metre: HALL_COST * width / area(&task.ground.ring),
    })
}

/// The level above or below one that is planned: with the same strip and stairs.
pub(super) fn plan_alike(
    task: Task<'_>,
    scheme: &Scheme,
    strips: &mut Strips<'_>,
    stream: &mut Stream,
) -> Vec<Planned> {
    let wishes = wishes(task);
    let rooms = with_and_without_last(&wishes);
    let divisions = strips.divisions_above(scheme);
    let mut drafts = Vec::new();
    for division in &divisions {
        let floor = Floor { rows: &division.spine.rows, hall: None };
        let tries = if division.scheme.reach.is_some() { TRIES } else { 4 * TRIES };
        let filling = fill_or_more(floor, &rooms, tries, stream);
        drafts.extend(filling.map(|filling| (filling.cost, division, filling)));
    }
    draw_best(task, drafts, &wishes, 1)
}

fn draw_best(
    task: Task<'_>,
    mut drafts: Vec<(f64, &Division, Filling)>,
    wishes: &[Wish<'_>],
    wanted: usize,
) -> Vec<Planned> {
    drafts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut plans: Vec<Planned> = Vec::new();
    let has_ends = drafts.iter().any(|(_, division, _)| division.scheme.reach.is_some());
    let mut rest = wanted.max(if has_ends { DRAWN_WITH_ENDS } else { DRAWN });
    for (_, division, filling) in drafts {
        if plans.len() >= wanted || rest == 0 {
            break;
        }
        if plans.iter().any(|known| known.scheme.is_alike(&division.scheme)) {
            continue;
        }
        rest -= 1;
        plans.extend(draw(task, division.clone(), &filling, wishes));
    }
    plans.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    plans
}

/// The programmes for a ground that fit a floor of so many square metres, the largest first, without those that it has not windows
/// enough for.
pub(super) fn fitting<'a>(
    programmes: &'a [Programme],
    floor: f64,
    ground: &Ground,
    typologies: &Typologies,
) -> Vec<&'a Programme> {
    let light: f64 = total_length(&ground.light(&ground.ring));
    let needs_light = |room_type: &String| {
        typologies.rooms.get(room_type).is_some_and(|needs| needs.light == Light::Required)
    };
    let is_lit = |programme: &&Programme| {
        let rooms = programme.rooms.iter().filter(|(room_type, _)| needs_light(room_type));
        let needing: usize = rooms.map(|(_, areas)| areas.all().len()).sum();
        light >= LIGHT_EACH * needing as f64
    };
    let smaller = programmes.iter().rev().filter(|programme| programme.from <= floor);
    smaller.take(MOST_PROGRAMMES).filter(is_lit).collect()
}

/// The rooms of the programme in the rows; where there are more rows than that, with a storeroom, which is the last wish.
fn fill_or_more(
    floor: Floor<'_>,
    [programme, all]: &[Wanted<'_>; 2],
    tries: u32,
    stream: &mut Stream,
) -> Option<Filling> {
    fill(floor, programme, tries, stream).or_else(|| {
        let mut filling = fill(floor, all, tries / 2, stream)?;
        filling.cost += MORE_COST;
        Some(filling)
    })
}

/// Wishes without the last, and all of them.
fn with_and_without_last<'a>(wishes: &'a [Wish<'a>]) -> [Wanted<'a>; 2] {
    [Wanted::of(&wishes[..wishes.len().saturating_sub(1)]), Wanted::of(wishes)]
}

/// The rooms of the programme, and a storeroom that it may do without.
fn wishes<'a>(task: Task<'a>) -> Vec<Wish<'a>> {
    let rooms = task.programme.rooms.iter().filter_map(|(room_type, areas)| {
        let needs = task.typologies.rooms.get(room_type)?;
        Some(areas.all().iter().map(move |&area| Wish { room_type, area, needs }))
    });
    let store = task.typologies.rooms.get_key_value("storeroom");
    let store = store.map(|(room_type, needs)| Wish { room_type, area: 2.5, needs });
    rooms.flatten().chain(store).collect()
}

impl Port {
    fn turned(self) -> Self {
        Self { at: super::ring::turned_point(self.at), way: super::ring::turned_point(self.way) }
    }
}

/// Where the strip may run, with the way in to it.
fn schemes(
    ground: &Ground,
    port: Option<Port>,
    task: Task<'_>,
    is_turned: bool,
) -> Vec<(Scheme, Vec<Fixed>)> {
    let (bottom, top) = extent(&ground.ring, Axis::Y);
    let width = task.hall_width;
    let mut lows: Vec<(f64, Vec<Fixed>)> = Vec::new();
    match port {
        // At an end of the strip.
        Some(Port { at, way }) if way.x.abs() >= way.y.abs() => {
            for offset in [0.5, 0.25, 0.75] {
                let low = at.y - PORT_HALF - (width - 2.0 * PORT_HALF).max(0.0) * offset;
                lows.push((low, Vec::new()));
            }
        }
        // At the side of a row, with a slice of it as a part of the hall; or at the strip itself.
        Some(Port { at, way }) => {
            let is_above = way.y < 0.0;
            let slice =
                Fixed { is_above, from: at.x - PORT_HALF, to: at.x + PORT_HALF, kind: FixedKind::Port };
            let flush = if is_above { top - width } else { bottom };
            lows.push((flush, Vec::new()));
            let height = top - bottom;
            for depth in [1.7, 2.3, 3.0, 4.0, 0.5 * (height - width), height - width] {
                if depth < height - width + FLUSH {
                    lows.push((if is_above { top - depth - width } else { bottom + depth }, vec![slice]));
                }
            }
        }
        None => lows.push((0.5 * (bottom + top - width), Vec::new())),
    }
    let snapped = lows.into_iter().map(|(low, ports)| {
        // What is left beside the strip is a row, or nothing.
        let strip = if top - (low + width) < LEAST_ROW {
            (top - width, top + FLUSH)
        } else if low - bottom < LEAST_ROW {
            (bottom - FLUSH, bottom + width)
        } else {
            (low, low + width)
        };
        (strip, ports)
    });
    let mut strips: Vec<((f64, f64), Vec<Fixed>)> = Vec::new();
    for (strip, ports) in snapped {
        let is_known = |(other, known): &((f64, f64), Vec<Fixed>)| {
            (other.0 - strip.0).abs() < SAME_PLACE && *known == ports
        };
        if !strips.iter().any(is_known) {
            strips.push((strip, ports));
        }
    }
    let ground_extent = extent(&ground.ring, Axis::X);
    let mut found = Vec::new();
    for ((low, high), ports) in strips {
        if !task.has_stairs {
            found.push((Scheme { is_turned, low, high, reach: None, stairs: None }, ports));
            continue;
        }
        let entry = port.map_or(ground_extent.0, |port| port.at.x);
        for (high, stairs) in stairs_beside((low, high), (bottom, top), ground_extent, entry) {
            found.push((Scheme { is_turned, low, high, reach: None, stairs: Some(stairs) }, ports.clone()));
        }
    }
    found
}

/// Where stairs may be beside or in a strip, and where it ends with them.
fn stairs_beside(
    (low, high): (f64, f64),
    (bottom, top): (f64, f64),
    (left, right): (f64, f64),
    entry: f64,
) -> Vec<(f64, Stairs)> {
    let mut found = Vec::new();
    let middle = 0.5 * (left + right);
    let mut places: Vec<f64> = [left, right - STAIR_WIDTH, middle - STAIR_WIDTH / 2.0].into();
    places.extend([entry + PORT_HALF, entry - PORT_HALF - STAIR_WIDTH]);
    places.retain(|from| *from >= left - 0.01 && from + STAIR_WIDTH <= right + 0.01);
    for (is_above, depth) in [(false, low - bottom), (true, top - high)] {
        if !(STAIR_DEPTH.0..=STAIR_DEPTH.1).contains(&depth) {
            continue;
        }
        let mut known: Vec<Fixed> = Vec::new();
        for &from in &places {
            // A strip less than a room wide before the stairs goes to them.
            let from = if from - left < 1.0 { left - FLUSH } else { from };
            let to = if right - from - STAIR_WIDTH < 1.0 { right + FLUSH } else { from + STAIR_WIDTH };
            if known.iter().all(|other| (other.from - from).abs() > SAME_PLACE) {
                known.push(Fixed { is_above, from, to, kind: FixedKind::Room(0) });
            }
        }
        found.extend(known.into_iter().map(|fixed| (high, Stairs::InRow(fixed))));
    }
    let high = high + FLIGHT.1;
    if right - left > FLIGHT.0 + 2.2 && high < top + FLUSH {
        let places = [left + 1.4, right - FLIGHT.0 - 1.2, middle - FLIGHT.0 / 2.0];
        for from in places {
            for is_above in [false, true] {
                found.push((high, Stairs::InStrip(from, from + FLIGHT.0, is_above)));
            }
        }
    }
    found
}

fn spine_of(ground: &Ground, band: &mut Band, scheme: &Scheme, ports: &[Fixed]) -> Option<Spine> {
    let mut fixed = ports.to_vec();
    let mut flight = None;
    match scheme.stairs {
        Some(Stairs::InRow(slice)) => {
            let meets = |port: &Fixed| {
                port.is_above == slice.is_above && port.from < slice.to - 0.01 && slice.from < port.to - 0.01
            };
            if ports.iter().any(meets) {
                return None;
            }
            fixed.push(slice);
        }
        Some(Stairs::InStrip(from, to, is_above)) => flight = Some((from, to, is_above)),
        None => {}
    }
    Spine::of_band(
        ground,
        band,
        &fixed,
        flight.map(|(from, to, is_above)| StripRoom {
            from,
            to,
            edge: if is_above { scheme.high - FLIGHT.1 } else { scheme.low + FLIGHT.1 },
            is_above,
        }),
    )
}

/// Cuts the rooms of a filling out of its rows, and trims the hall to what it is needed for.
fn draw(
    task: Task<'_>,
    Division { scheme, spine }: Division,
    filling: &Filling,
    wishes: &[Wish<'_>],
) -> Option<Planned> {
    let Spine { strip, rows, fixed, mut left_over } = spine;
    let mut cells: Vec<(Ring, String)> = Vec::new();
    let mut slices = filling.slices.iter().peekable();
    for (index, row) in rows.iter().enumerate() {
        let mut own = Vec::new();
        while let Some(slice) = slices.next_if(|slice| slice.row == index) {
            own.push(slice);
        }
        let places: Vec<f64> = own.iter().take(own.len().saturating_sub(1)).map(|slice| slice.to).collect();
        let (rings, rest) = row.cut(&places);
        left_over.extend(rest);
        if rings.iter().any(|ring| ring.is_empty()) {
            return None;
        }
        let rings = carved(rings, &own, wishes, (scheme.low, scheme.high));
        cells.extend(
            rings.into_iter().zip(own).map(|(ring, slice)| (ring, wishes[slice.wish].room_type.to_owned())),
        );
    }
    let stairs: Vec<Ring> = fixed.into_iter().map(|(_, ring)| ring).collect();
    let port = task.port.map(|port| if scheme.is_turned { port.turned() } else { port });
    let (mut hall, ends) = trimmed_hall(&strip, &rows, filling, &stairs, port)?;
    let rooms = cells.len();
    let mut rings: Vec<Ring> = cells.iter().map(|(ring, _)| ring.clone()).collect();
    // Ends of the hall make rooms larger that people like to be in; what is left goes to whom it borders on.
    let lit = |index: usize| weight_of_end(&task.typologies.rooms[&cells[index].1]);
    for end in ends {
        if !settle(vec![end.clone()], &mut rings, lit).is_empty() {
            hall = join(&hall, &end)?;
        }
    }
    rings.push(hall);
    let rest = settle(left_over, &mut rings, |_| 1.0);
    if rest.iter().map(|ring| area(ring)).sum::<f64>() > 0.05 {
        return None;
    }
    let hall = rings.pop()?;
    let back = |ring: &Ring| if scheme.is_turned { turned_ring_back(ring) } else { ring.clone() };
    let mut planned = vec![Cell::shared(back(&hall), task.hall)];
    let named = rings.iter().zip(&cells).take(rooms);
    planned.extend(named.map(|(ring, (_, room_type))| Cell::shared(back(ring), room_type)));
    planned.extend(stairs.iter().map(|ring| Cell::shared(back(ring), "stairs")));
    // Stairs of a house stand beside other rooms on each level.
    let rules = Rules::of_rooms(task.typologies);
    let rules = if task.has_stairs { rules.with_fixed("stairs") } else { rules };
    trade_thin_parts(&mut planned, rules);
    trade_strips(&mut planned, rules);
    if !are_sound(task.ground, task.typologies, &planned) || !leads_on(task, &planned) {
        return None;
    }
    let hall_share = area(&hall) / area(&task.ground.ring);
    let cost = filling.cost + HALL_COST * hall_share;
    Some(Planned { cells: planned, scheme, cost })
}

/// Whether people come into a room from which they may go on.
fn leads_on(task: Task<'_>, cells: &[Cell]) -> bool {
    let Some(room) = task.port.and_then(|port| room_at(cells, port)) else { return true };
    let room_type = &cells[room].room_type;
    room_type == task.hall || task.typologies.rooms.get(room_type).is_none_or(|needs| needs.passage)
}

/// Rooms of a row, of which small ones that may do without an outer wall end where they have what was wished for: a room beside
/// them takes the rest. Baths as deep as the rooms beside them would be twice as large as people build them.
fn carved(mut rings: Vec<Ring>, own: &[&Slice], wishes: &[Wish<'_>], (low, high): (f64, f64)) -> Vec<Ring> {
    let wish = |index: usize| &wishes[own[index].wish];
    for index in 0..rings.len() {
        let Wish { needs, area: wanted, .. } = wish(index);
        if !needs.inner || !own[index].is_at_strip {
            continue;
        }
        let extent = bounds(&rings[index]);
        let is_above = extent.center().y > 0.5 * (low + high);
        let depth = if is_above { extent.high.y - high } else { low - extent.low.y };
        let kept = (wanted / extent.size().x).max(needs.width + 2.0 * MORE_DEPTH);
        if depth - kept < LEAST_REST {
            continue;
        }
        let at = if is_above { high + kept } else { low - kept };
        let (below, above) = split(&rings[index], Axis::Y, (at * 100.0).round() / 100.0);
        let (inner, rest) = if is_above { (below, above) } else { (above, below) };
        let ([inner], [rest]) = (inner.as_slice(), rest.as_slice()) else { continue };
        // The smaller of its neighbours, beside what was wished for.
        let beside = [index.checked_sub(1), Some(index + 1).filter(|&next| next < rings.len())];
        let outer = beside.into_iter().flatten().filter(|&next| !wish(next).needs.inner);
        let ratio = |next: usize| area(&rings[next]) / wish(next).area;
        let taker = outer.reduce(|a, b| if ratio(b) < ratio(a) { b } else { a });
        if let Some((taker, ring)) = taker.and_then(|taker| Some((taker, join(&rings[taker], rest)?))) {
            rings[taker] = ring;
            rings[index] = inner.clone();
        }
    }
    rings
}

/// How gladly a room takes an end of the hall that nobody needs.
fn weight_of_end(needs: &RoomNeeds) -> f64 {
    match needs.light {
        Light::Required if needs.passage => 6.0,
        Light::Required => 2.0,
        _ => 1.0,
    }
}

/// Whether every room is as wide and as light as it must be.
fn are_sound(ground: &Ground, typologies: &Typologies, cells: &[Cell]) -> bool {
    cells.iter().all(|cell| {
        let Some(needs) = typologies.rooms.get(&cell.room_type) else { return true };
        let is_light = || ground.light(&cell.ring).iter().any(|piece| piece.length() >= WINDOW_STRETCH);
        is_simple(&cell.ring)
            && !has_thin_parts(&cell.ring)
            && is_as_wide_as(&cell.ring, needs.width)
            && (needs.light != Light::Required || is_light())
    })
}

/// The hall between the first and the last place where it is needed, and what it was cut off.
fn trimmed_hall(
    strip: &Ring,
    rows: &[Row],
    filling: &Filling,
    stairs: &[Ring],
    port: Option<Port>,
) -> Option<(Ring, Vec<Ring>)> {
    let (mut low, mut high) = filling.hall.or_else(|| needed(rows, &filling.slices))?;
    let mut reach = |from: f64, to: f64| {
        low = low.min(from);
        high = high.max(to);
    };
    if let Some(port) = port {
        reach(port.at.x - PORT_HALF, port.at.x + PORT_HALF);
    }
    for ring in stairs {
        let shared = super::ring::shared(strip, ring);
        let longest = shared.iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
        if longest.length() < 0.8 {
            return None;
        }
        let (from, to) = (longest.start.x.min(longest.end.x), longest.start.x.max(longest.end.x));
        reach(to - DOOR_STRETCH.min(to - from), from + DOOR_STRETCH.min(to - from));
    }
    Some(trim(strip.clone(), low, high))
}

/// A flat of one room and a bath at its way in, for grounds on which nothing else has a place.
pub(super) fn studio(ground: &Ground, port: Port, typologies: &Typologies) -> Option<Vec<Cell>> {
    let whole = ground;
    let is_turned = port.way.x.abs() >= port.way.y.abs();
    let turned = ground.turned();
    let (ground, port) = if is_turned { (&turned, port.turned()) } else { (ground, port) };
    let size = bounds(&ground.ring).size();
    let (left, right) = extent(&ground.ring, Axis::X);
    let (bottom, top) = extent(&ground.ring, Axis::Y);
    let (width, depth) = (1.9f64.min(size.x / 2.5), 2.4f64.min(size.y / 2.0));
    let corners =
        [left + width, right - width].into_iter().flat_map(|x| [bottom + depth, top - depth].map(|y| (x, y)));
    let mut best: Option<(f64, Ring, Ring)> = None;
    for (x, y) in corners {
        let is_left = x < 0.5 * (left + right);
        let is_low = y < 0.5 * (bottom + top);
        let (before, after) = split(&ground.ring, Axis::X, x);
        let (side, mut rest) = if is_left { (before, after) } else { (after, before) };
        let Some(column) = side.first() else { continue };
        let (below, above) = split(column, Axis::Y, y);
        let (mut bath, others) = if is_low { (below, above) } else { (above, below) };
        if bath.is_empty() || rest.is_empty() {
            continue;
        }
        let bath = bath.swap_remove(0);
        let mut room = vec![rest.swap_remove(0)];
        let open = settle(
            others.into_iter().chain(rest).chain(side.into_iter().skip(1)).collect(),
            &mut room,
            |_| 1.0,
        );
        let keeps_port =
            super::ring::bounds(&bath).gap(crate::geometry::Bounds::around_point(port.at, PORT_HALF)) > 0.0;
        if !open.is_empty() || !keeps_port || shared_length(&room[0], &bath) < DOOR_STRETCH {
            continue;
        }
        let light: f64 = total_length(&ground.light(&bath));
        if best.as_ref().is_none_or(|(known, ..)| light < *known) {
            best = Some((light, room.swap_remove(0), bath));
        }
    }
    let (_, room, bathroom) = best?;
    let back = |ring: Ring| if is_turned { turned_ring_back(&ring) } else { ring };
    let mut cells = vec![Cell::shared(back(room), "studio"), Cell::shared(back(bathroom), "bathroom")];
    trade_thin_parts(&mut cells, Rules::of_rooms(typologies));
    are_sound(whole, typologies, &cells).then_some(cells)
}
