//! A strip that people walk along, with rows of rooms on one or both sides of it.
//!
//! ```text
//!   +------+---------+-----+        t
//!   | room |  room   |     |  row   ^
//!   +------+------+--+ end |        |
//!   |  hall (strip)  | bit |        +--> s, along the strip
//!   +----+-----+---+-+-----+
//!   |    |bath | v |  room |  row   v: a way in (port), or stairs: fixed slices of a row
//!   +----+-----+---+-------+
//! ```
//!
//! Works in a frame whose x axis runs along the strip; [`Ground::turned`] makes the other one.

use std::rc::Rc;

use crate::geometry::{Point, Segment, edges};

use super::facade::{Facade, Span};
use super::ring::{self, Axis, Ring, along, area, bounds, join, split, turned, turned_back, turned_point};

/// Rows below this many square metres are given to their neighbours.
const LEAST_ROW: f64 = 2.0;
/// Places at which the depth of a row is measured.
const SAMPLES: usize = 32;

/// A piece of a storey that is planned on its own, such as a flat.
#[derive(Clone, Debug)]
pub(super) struct Ground {
    /// Its outline, on the middles of its walls and on the inner faces of outer walls.
    pub(super) ring: Ring,
    /// What lies before the outer walls.
    pub(super) facade: Facade,
    /// Metres of outer wall.
    pub(super) wall: f64,
}

impl Ground {
    /// The same in a frame that is turned by a quarter.
    pub(super) fn turned(&self) -> Self {
        let line = |line: Segment| Segment::new(turned_point(line.start), turned_point(line.end));
        let spans = self.facade.spans.iter().map(|span| Span::new(line(span.line), span.class, span.sight));
        let spans = spans.collect();
        let entrance = self.facade.entrance.map(|(span, point)| (span, turned_point(point)));
        Self { ring: turned(&self.ring), facade: Facade { spans, entrance }, wall: self.wall }
    }

    /// A part of it: with the walls near that alone, for the rest would be looked at in vain.
    pub(super) fn part(&self, ring: Ring) -> Self {
        let reach = bounds(&ring).inflated(self.wall + 0.5);
        let spans = &self.facade.spans;
        let near = spans.iter().filter(|span| span.line.bounds().touches(reach)).copied().collect();
        Self { ring, facade: Facade { spans: near, entrance: None }, wall: self.wall }
    }

    /// The pieces of a ring's border that light may come through.
    pub(super) fn light(&self, ring: &[Point]) -> Vec<Segment> {
        let free = |edge: Segment| {
            let before = self.facade.before(edge, (self.wall, self.wall));
            before.filter(|(span, _)| span.class.is_free()).map(|(_, piece)| piece)
        };
        edges(ring).flat_map(free).collect()
    }
}

/// Turns rings back that were made in a turned frame.
pub(super) fn turned_ring_back(ring: &[Point]) -> Ring {
    ring.iter().map(|corner| turned_back(*corner)).collect()
}

/// A slice of a row that is set before the rooms are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fixed {
    /// Whether it is in the row above the strip.
    pub(super) is_above: bool,
    /// From where to where along the strip.
    pub(super) from: f64,
    /// See `from`.
    pub(super) to: f64,
    /// What it is.
    pub(super) kind: FixedKind,
}

/// What a fixed slice is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FixedKind {
    /// A part of the hall, up to a way in.
    Port,
    /// A room of the caller, by its number.
    Room(usize),
}

/// A row of the strip, or what fixed slices leave of it: many ways of dividing a ground have the same, each beside another form of
/// the strip.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// Its outline.
    pub(super) ring: Rc<Ring>,
    /// From where to where it reaches along the strip.
    pub(super) from: f64,
    /// See `from`.
    pub(super) to: f64,
    /// Square metres up to each of [`SAMPLES`] places, evenly along the row.
    sums: Rc<[f64]>,
    /// Where light comes in: from where to where along the strip, and metres of wall.
    light: Rc<[(f64, f64, f64)]>,
    /// Where it borders on the strip.
    contact: Vec<(f64, f64)>,
    /// Whether it lies at an end of the strip: its rooms are as deep as the ground is wide there.
    is_end: bool,
}

impl Row {
    fn of(ring: Ring, ground: &Ground, strip: &[Point]) -> Self {
        let contact = contact(&ring, strip);
        Self::new(ring, ground, contact, false)
    }

    /// A row at an end of a strip, with a door to it in the stretch from where to where.
    pub(super) fn at_end(ring: Ring, ground: &Ground, contact: (f64, f64)) -> Self {
        Self::new(ring, ground, vec![contact], true)
    }

    fn new(ring: Ring, ground: &Ground, contact: Vec<(f64, f64)>, is_end: bool) -> Self {
        let extent = bounds(&ring);
        let (from, to) = (extent.low.x, extent.high.x);
        let step = (to - from) / SAMPLES as f64;
        let mut sums = [0.0; SAMPLES + 1];
        let lines: Vec<SlopedLine> = edges(&ring).filter_map(SlopedLine::of).collect();
        for sample in 0..SAMPLES {
            let place = from + step * (sample as f64 + 0.5);
            let depth: f64 = lines.iter().map(|line| line.depth_at(place)).sum();
            sums[sample + 1] = sums[sample] + depth * step;
        }
        let span =
            |piece: Segment| (piece.start.x.min(piece.end.x), piece.start.x.max(piece.end.x), piece.length());
        let light = ground.light(&ring).into_iter().map(span).collect();
        Self { ring: Rc::new(ring), from, to, sums: Rc::new(sums), light, contact, is_end }
    }

    /// Square metres.
    pub(super) fn area(&self) -> f64 {
        self.sums[SAMPLES]
    }

    /// Metres along the strip.
    pub(super) fn length(&self) -> f64 {
        self.to - self.from
    }

    /// Metres away from the strip: the mean, or the most where a room takes the whole of it.
    pub(super) fn depth(&self) -> f64 {
        let mean = self.area() / self.length().max(0.01);
        if !self.is_end {
            return mean;
        }
        let step = self.length().max(0.01) / SAMPLES as f64;
        self.sums.windows(2).map(|pair| (pair[1] - pair[0]) / step).fold(mean, f64::max)
    }

    /// Metres away from the strip of a slice, as of [`Self::depth`].
    pub(super) fn depth_between(&self, from: f64, to: f64) -> f64 {
        if self.is_end {
            (self.area_up_to(to) - self.area_up_to(from)) / (to - from).max(0.01)
        } else {
            self.depth()
        }
    }

    /// Square metres up to a place.
    fn area_up_to(&self, place: f64) -> f64 {
        let steps = SAMPLES as f64 * ((place - self.from) / self.length().max(0.01)).clamp(0.0, 1.0);
        let index = (steps as usize).min(SAMPLES - 1);
        self.sums[index] + (steps - index as f64) * (self.sums[index + 1] - self.sums[index])
    }

    /// The place up to which so many square metres lie.
    pub(super) fn place_of(&self, area: f64) -> f64 {
        let step = self.length() / SAMPLES as f64;
        let index = self.sums.partition_point(|&sum| sum < area).clamp(1, SAMPLES);
        let (low, high) = (self.sums[index - 1], self.sums[index]);
        let share = if high > low { ((area - low) / (high - low)).clamp(0.0, 1.0) } else { 1.0 };
        self.from + step * (index as f64 - 1.0 + share)
    }

    /// Metres of wall with light between two places.
    pub(super) fn light_between(&self, from: f64, to: f64) -> f64 {
        let part = |&(low, high, length): &(f64, f64, f64)| {
            if high - low < 0.05 {
                return if low >= from - 0.05 && high <= to + 0.05 { length } else { 0.0 };
            }
            length * ((high.min(to) - low.max(from)).max(0.0) / (high - low))
        };
        self.light.iter().map(part).sum()
    }

    /// Metres of the longest border with the strip between two places, and where it is.
    pub(super) fn contact_between(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        let part = |&(low, high): &(f64, f64)| (low.max(from), high.min(to));
        let parts = self.contact.iter().map(part).filter(|(low, high)| high > low);
        parts.reduce(|best, next| if next.1 - next.0 > best.1 - best.0 { next } else { best })
    }

    /// Cuts the row at places along the strip, in rising order: one piece for each interval, and what was left over.
    pub(super) fn cut(&self, places: &[f64]) -> (Vec<Ring>, Vec<Ring>) {
        cut_along(std::slice::from_ref(&*self.ring), places)
    }
}

/// Cuts rings at places along the x axis, in rising order: the largest piece of each interval, and all others.
pub(super) fn cut_along(rings: &[Ring], places: &[f64]) -> (Vec<Ring>, Vec<Ring>) {
    let (mut slices, mut left_over) = (Vec::new(), Vec::new());
    let mut rest: Vec<Ring> = rings.to_vec();
    for &place in places {
        let (mut slice, mut beyond) = (Vec::new(), Vec::new());
        for ring in &rest {
            let (below, above) = split(ring, Axis::X, place);
            slice.extend(below);
            beyond.extend(above);
        }
        take_largest(slice, &mut slices, &mut left_over);
        rest = beyond;
    }
    take_largest(rest, &mut slices, &mut left_over);
    (slices, left_over)
}

fn take_largest(pieces: Vec<Ring>, taken: &mut Vec<Ring>, left_over: &mut Vec<Ring>) {
    let (largest, others) = largest_of(pieces).unwrap_or_default();
    taken.push(largest);
    left_over.extend(others);
}

/// The largest of some pieces, and the others, the larger first.
pub(super) fn largest_of(mut pieces: Vec<Ring>) -> Option<(Ring, Vec<Ring>)> {
    pieces.sort_by(|a, b| area(b).total_cmp(&area(a)));
    let mut pieces = pieces.into_iter();
    Some((pieces.next()?, pieces.collect()))
}

/// From where to where along a strip a ring borders on it.
fn contact(ring: &[Point], strip: &[Point]) -> Vec<(f64, f64)> {
    let reach = |piece: Segment| (piece.start.x.min(piece.end.x), piece.start.x.max(piece.end.x));
    ring::shared(ring, strip).into_iter().map(reach).collect()
}

/// An edge of a ring that does not run across the strip.
struct SlopedLine {
    from: f64,
    to: f64,
    /// Height at `from`, and how it changes: below zero where the inside is above the edge.
    height: f64,
    slope: f64,
}

impl SlopedLine {
    fn of(edge: Segment) -> Option<Self> {
        // Edges above run west, those below run east.
        let (low, high, sign) = match edge.start.x > edge.end.x {
            true => (edge.end, edge.start, 1.0),
            false => (edge.start, edge.end, -1.0),
        };
        if high.x <= low.x {
            return None;
        }
        let slope = (high.y - low.y) / (high.x - low.x);
        Some(Self { from: low.x, to: high.x, height: sign * low.y, slope: sign * slope })
    }

    /// What it adds to the metres of the ring across the strip at a place along it.
    fn depth_at(&self, place: f64) -> f64 {
        let is_over = place >= self.from && place < self.to;
        if is_over { self.height + (place - self.from) * self.slope } else { 0.0 }
    }
}

/// A room inside a strip, at one side of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StripRoom {
    /// From where to where along the strip.
    pub(super) from: f64,
    /// See `from`.
    pub(super) to: f64,
    /// The height at which it ends towards the hall.
    pub(super) edge: f64,
    /// Whether it lies above that height.
    pub(super) is_above: bool,
}

/// A ground that is cut along a strip between two heights, before anything is taken out of its rows: many ways of dividing it begin
/// with the same cuts, which are made once.
#[derive(Clone, Debug)]
pub(super) struct Band {
    strip: Ring,
    /// Below the strip and above it.
    sides: [Side; 2],
    left_over: Vec<Ring>,
    /// Rooms that were cut out of the strip so far.
    insides: Vec<(StripRoom, Option<Inside>)>,
    /// The strips that ports were joined to so far: what they were made of, and what they became.
    joined: Vec<(Parts, Option<Ring>)>,
}

/// A room that is cut out of a strip, and the ports that are joined to what is left.
type Parts = (Option<StripRoom>, Vec<Ring>);

/// What is left of a strip, and the room that was cut out of it.
type Inside = (Ring, Ring);

/// What is at one side of a strip.
#[derive(Clone, Debug)]
struct Side {
    rings: Vec<Ring>,
    /// Without slices, and with those that were taken out of it so far.
    cuts: Vec<(Vec<Fixed>, Option<SideCut>)>,
}

/// A side of a strip without slices that are taken out of it.
#[derive(Clone, Debug)]
struct SideCut {
    taken: Vec<(Fixed, Ring)>,
    rows: Vec<Row>,
    /// What is too small for a row.
    left_over: Vec<Ring>,
}

impl Band {
    /// `None` where the strip is no single piece.
    pub(super) fn cut(ground: &Ground, (low, high): (f64, f64)) -> Option<Self> {
        let (below, rest) = split(&ground.ring, Axis::Y, low);
        let mut above = Vec::new();
        let mut strips = Vec::new();
        for ring in rest {
            let (strip, beyond) = split(&ring, Axis::Y, high);
            strips.extend(strip);
            above.extend(beyond);
        }
        let (strip, left_over) = largest_of(strips)?;
        // A second strip of any size is a wing of its own.
        if left_over.iter().map(|ring| area(ring)).sum::<f64>() > LEAST_ROW {
            return None;
        }
        let sides = [below, above].map(|rings| Side { rings, cuts: Vec::new() });
        Some(Self { strip, sides, left_over, insides: Vec::new(), joined: Vec::new() })
    }

    /// Its strip.
    pub(super) fn strip(&self) -> &[Point] {
        &self.strip
    }

    /// The strip with ports joined to it, which many places of stairs leave as they are; `None` where one does not border on it.
    fn with_ports(&mut self, strip: Ring, parts: Parts) -> Option<Ring> {
        if parts.1.is_empty() {
            return Some(strip);
        }
        let known = self.joined.iter().position(|(known, _)| *known == parts).unwrap_or_else(|| {
            let joined = parts.1.iter().try_fold(strip, |strip, port| join(&strip, port));
            self.joined.push((parts, joined));
            self.joined.len() - 1
        });
        self.joined[known].1.clone()
    }

    /// The strip without a room in it, and the room; `None` where it has no place there.
    fn inside(&mut self, room: StripRoom) -> Option<&Inside> {
        let known = self.insides.iter().position(|(known, _)| *known == room).unwrap_or_else(|| {
            self.insides.push((room, cut_out(&self.strip, room)));
            self.insides.len() - 1
        });
        self.insides[known].1.as_ref()
    }
}

impl Side {
    /// Without some slices; `None` where one has no place.
    fn without(&mut self, slices: Vec<Fixed>, ground: &Ground, strip: &[Point]) -> Option<&SideCut> {
        let known = self.cuts.iter().position(|(known, _)| *known == slices).unwrap_or_else(|| {
            let mut left_over = Vec::new();
            let cut =
                take_fixed(self.rings.clone(), &slices, &mut left_over).map(|FixedCut { taken, kept }| {
                    let rows = kept.into_iter().map(|ring| Row::of(ring, ground, strip)).collect();
                    SideCut { taken, rows, left_over }
                });
            self.cuts.push((slices, cut));
            self.cuts.len() - 1
        });
        self.cuts[known].1.as_ref()
    }
}

/// A ground with its strip and rows.
#[derive(Clone, Debug)]
pub(super) struct Spine {
    /// The strip, with the ports that belong to it.
    pub(super) strip: Ring,
    /// The rows, without fixed slices.
    pub(super) rows: Vec<Row>,
    /// The fixed rooms by number, with their outlines.
    pub(super) fixed: Vec<(usize, Ring)>,
    /// Pieces that are nobody's yet.
    pub(super) left_over: Vec<Ring>,
}

impl Spine {
    /// Cuts a ground along a strip between two heights. `None` where the strip is no single piece, or a fixed slice has no
    /// place.
    pub(super) fn new(ground: &Ground, low: f64, high: f64, fixed: &[Fixed]) -> Option<Self> {
        Self::of_band(ground, &mut Band::cut(ground, (low, high))?, fixed, None)
    }

    /// As [`Self::new`], of a ground that is cut; a room, number 0, is cut out of the strip.
    pub(super) fn of_band(
        ground: &Ground,
        band: &mut Band,
        fixed: &[Fixed],
        inside: Option<StripRoom>,
    ) -> Option<Self> {
        let mut strip = band.strip.clone();
        let mut left_over = band.left_over.clone();
        let mut rooms = Vec::new();
        if let Some(room) = inside {
            let (rest, ring) = band.inside(room)?;
            strip.clone_from(rest);
            rooms.push((0, ring.clone()));
        }
        let (mut rows, mut ports) = (Vec::new(), Vec::new());
        for (index, side) in band.sides.iter_mut().enumerate() {
            let own = fixed.iter().filter(|slice| slice.is_above == (index == 1)).copied().collect();
            let cut = side.without(own, ground, &band.strip)?;
            left_over.extend(cut.left_over.iter().cloned());
            rows.extend(cut.rows.iter().cloned());
            for (slice, ring) in &cut.taken {
                match slice.kind {
                    FixedKind::Port => ports.push(ring.clone()),
                    FixedKind::Room(number) => rooms.push((number, ring.clone())),
                }
            }
        }
        let strip = band.with_ports(strip, (inside, ports))?;
        if strip != band.strip {
            rows.iter_mut().for_each(|row| row.contact = contact(&row.ring, &strip));
        }
        Some(Self { strip, rows, fixed: rooms, left_over })
    }
}

/// A strip without a room in it, and the room.
fn cut_out(strip: &[Point], room: StripRoom) -> Option<(Ring, Ring)> {
    let StripRoom { from, to, edge, is_above } = room;
    let (slices, crumbs) = cut_along(&[strip.to_vec()], &[from, to]);
    let [before, middle, after] = slices.try_into().ok()?;
    let (mut below, mut above) = split(&middle, Axis::Y, edge);
    let is_simple = crumbs.is_empty() && below.len() == 1 && above.len() == 1;
    if !is_simple {
        return None;
    }
    let (rest, room) = if is_above { (below.pop()?, above.pop()?) } else { (above.pop()?, below.pop()?) };
    let mut strip = rest;
    for end in [before, after].into_iter().filter(|end| !end.is_empty()) {
        strip = join(&strip, &end)?;
    }
    Some((strip, room))
}

struct FixedCut {
    taken: Vec<(Fixed, Ring)>,
    kept: Vec<Ring>,
}

/// Cuts fixed slices out of the rings of a row.
fn take_fixed(mut rings: Vec<Ring>, fixed: &[Fixed], left_over: &mut Vec<Ring>) -> Option<FixedCut> {
    let mut taken = Vec::new();
    for slice in fixed {
        let mut found: Option<Ring> = None;
        let mut others = Vec::new();
        for ring in rings {
            let (before, rest) = split(&ring, Axis::X, slice.from);
            others.extend(before);
            for ring in rest {
                let (inside, after) = split(&ring, Axis::X, slice.to);
                others.extend(after);
                for piece in inside {
                    match &found {
                        Some(known) if area(known) >= area(&piece) => left_over.push(piece),
                        _ => left_over.extend(found.replace(piece)),
                    }
                }
            }
        }
        let found = found?;
        let width = bounds(&found).size().x;
        if width < (slice.to - slice.from) * 0.75 {
            return None;
        }
        taken.push((*slice, found));
        rings = others;
    }
    let (kept, small): (Vec<Ring>, Vec<Ring>) = rings.into_iter().partition(|ring| is_row(ring));
    left_over.extend(small);
    Some(FixedCut { taken, kept })
}

fn is_row(ring: &[Point]) -> bool {
    let size = bounds(ring).size();
    area(ring) >= LEAST_ROW && size.min_element() >= 0.8
}

/// Cuts the ends of a strip off that nobody needs: keeps what lies between two places, and returns the cut ends.
pub(super) fn trim(strip: Ring, from: f64, to: f64) -> (Ring, Vec<Ring>) {
    let mut ends = Vec::new();
    let (before, rest) = split(&strip, Axis::X, from);
    ends.extend(before);
    let mut kept: Vec<Ring> = Vec::new();
    for ring in rest {
        let (inside, after) = split(&ring, Axis::X, to);
        ends.extend(after);
        kept.extend(inside);
    }
    let Some((main, others)) = largest_of(kept) else { return (strip, Vec::new()) };
    ends.extend(others);
    (main, ends)
}

/// What lies below and above a coordinate, where either is one piece but for crumbs, which the other side takes: edges are not quite
/// parallel to the axes. `None` where it is not.
pub(super) fn in_two(ring: &[Point], axis: Axis, at: f64) -> Option<(Ring, Ring)> {
    let (below, above) = split(ring, axis, (at * 1000.0).round() / 1000.0);
    let ((first, mut crumbs), (second, others)) = (largest_of(below)?, largest_of(above)?);
    crumbs.extend(others);
    let are_small = crumbs.iter().map(|ring| area(ring)).sum::<f64>() < LEAST_ROW;
    let mut sides = [first, second];
    (are_small && settle(crumbs, &mut sides, |_| 1.0).is_empty()).then(|| sides.into())
}

/// Gives pieces that are nobody's to the ring beside which they lie longest, by a weight for each; what finds none comes back.
pub(super) fn settle(pieces: Vec<Ring>, rings: &mut [Ring], weight: impl Fn(usize) -> f64) -> Vec<Ring> {
    let mut open = pieces;
    // Each round gives away one piece or more, or ends.
    loop {
        let count = open.len();
        let mut rest = Vec::new();
        for piece in open {
            let mut order: Vec<(f64, usize)> = (0..rings.len())
                .map(|index| (ring::shared_length(&piece, &rings[index]) * weight(index), index))
                .filter(|(length, _)| *length > 0.02)
                .collect();
            order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            let joined = order.iter().find_map(|&(_, index)| Some((index, join(&rings[index], &piece)?)));
            match joined {
                Some((index, ring)) => rings[index] = ring,
                None => rest.push(piece),
            }
        }
        open = rest;
        if open.len() == count || open.is_empty() {
            return open;
        }
    }
}

/// The extent of a ring along an axis.
pub(super) fn extent(ring: &[Point], axis: Axis) -> (f64, f64) {
    let places = ring.iter().map(|corner| along(*corner, axis));
    places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)))
}
