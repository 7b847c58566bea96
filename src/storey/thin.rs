//! Parts of rooms that are too thin to stand in: cuts that run close beside a corner of the outline leave them.

use std::collections::BTreeMap;

use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::{BooleanOps, Buffer};

use crate::geometry::{Point, Segment, edges, ring_contains};
use crate::plan::ring_surface;

use super::disc::is_simple;
use super::dwelling::Cell;
use super::links::LEAST_BORDER;
use super::ring::{Axis, Ring, area, bounds, join, shared, shared_length, split, total_length};
use super::typology::Typologies;

/// Metres below which a part of a floor is thin, with a little for rounding.
const THIN: f64 = 0.32;
/// The same of a room up to the middles of its walls, half of which belong to it on either side.
const THIN_ROOM: f64 = 0.46;
/// Metres below which a long part of a room up to the middles of its walls is a strip: nobody walks past what stands in it.
const STRIP: f64 = 0.95;
/// Metres from which on such a part is long; a shorter one is a niche.
const STRIP_LENGTH: f64 = 1.6;
/// Metres below which a part of a room between the faces of its walls is of no use.
pub(super) const SLIVER_WIDTH: f64 = 0.3;
/// Square metres of such a part that a room may have.
const SLIVER_AREA: f64 = 0.045;
/// Square metres by the estimate from pairs of edges, below and above which no closer look is needed.
const SLIVER_DOUBT: (f64, f64) = (0.015, 0.09);
/// Square metres by which what is known of such a part without a closer look is smaller, to be sure.
const SLIVER_MARGIN: f64 = 0.005;
/// Metres of the width of what is left along walls where a round tool goes around a room.
const NOISE: f64 = 0.001;
/// Radians of the pieces of the arcs of that tool.
const ARC: f64 = 0.1;
/// Square metres that a thin part may have.
const LEAST_AREA: f64 = 0.003;
/// Metres of width at which a thin part ends in a corner.
const CORNER: f64 = 0.02;
/// Square metres of thin parts that a room may have.
const MOST_AREA: f64 = 0.06;
/// Two edges enclose a thin part where their directions differ by less than this from opposite ones (cosine of 40 degrees).
const OPPOSITE: f64 = -0.76;
/// The same where a closer look follows: of two wider corners with a neck between them, each is small (cosine of 62 degrees).
const NEARLY_OPPOSITE: f64 = -0.47;
/// Metres of border beyond which a room takes a thin part of its neighbour.
const TAKING_BORDER: f64 = 0.15;
/// Of what a room keeps, the share that it may give away with a thin part, because that alone joined it.
const MOST_GIVEN: f64 = 0.4;
/// Thin parts of one ring that are looked at, at most.
const MOST_PARTS: usize = 12;
/// Corners of a floor or a room beyond which its thin parts stay: each cut of a comb of a thousand teeth leaves as many pieces to be joined.
const MOST_CORNERS: usize = 1_000;

/// A thin part between two edges of a ring.
#[derive(Clone, Copy, Debug)]
struct ThinPart {
    /// From where to where it reaches along the axis.
    from: f64,
    /// See `from`.
    to: f64,
    axis: Axis,
    /// A point in the middle of it.
    middle: Point,
    /// Square metres.
    area: f64,
}

impl ThinPart {
    /// Metres along its axis.
    fn length(&self) -> f64 {
        self.to - self.from
    }
}

/// The thin parts of a ring, the largest first.
fn thin_parts(ring: &[Point], below: f64) -> Vec<ThinPart> {
    thin_parts_between(ring, below, OPPOSITE)
}

/// The thin parts of a ring between edges whose directions have no larger cosine, the largest first.
fn thin_parts_between(ring: &[Point], below: f64, opposite: f64) -> Vec<ThinPart> {
    let all: Vec<(Segment, Point)> = edges(ring).map(|edge| (edge, edge.direction())).collect();
    let mut found: Vec<ThinPart> = Vec::new();
    for (index, &(edge, direction)) in all.iter().enumerate() {
        for &(other, back) in &all[index + 1..] {
            if direction.dot(back) <= opposite {
                found.extend(between(edge, other, below).filter(|part| ring_contains(ring, part.middle)));
            }
        }
    }
    found.sort_by(|a, b| b.area.total_cmp(&a.area));
    found.truncate(MOST_PARTS);
    found
}

/// The thin part to the left of an edge and of another that runs the other way, more or less.
fn between(edge: Segment, other: Segment, below: f64) -> Option<ThinPart> {
    let direction = edge.direction();
    let place = |point: Point| ((point - edge.start).dot(direction), edge.normal().dot(point - edge.start));
    // The other edge runs back: from its end to its start is along this one.
    let ((near, near_width), (far, far_width)) = (place(other.end), place(other.start));
    let (low, high) = (near.max(0.0), far.min(edge.length()));
    if high - low < 0.05 {
        return None;
    }
    let slope = (far_width - near_width) / (far - near);
    let width = |at: f64| near_width + slope * (at - near);
    // Where the width is that of a thin part, and not below zero.
    let (mut from, mut to) = (low, high);
    for (limit, is_upper) in [(below, true), (0.0, false)] {
        let is_within = |at: f64| if is_upper { width(at) <= limit } else { width(at) >= limit - 1e-6 };
        match (is_within(from), is_within(to)) {
            (true, true) => {}
            (false, false) => return None,
            (is_first, _) => {
                let crossing = near + (limit - near_width) / slope;
                if is_first { to = crossing } else { from = crossing }
            }
        }
    }
    let is_corner = width(from).min(width(to)) < CORNER;
    let area = if is_corner && width(from).max(width(to)) > below - CORNER {
        beyond_disc(0.5 * below, libm::acos((-direction.dot(other.direction())).clamp(-1.0, 1.0)))
    } else {
        (to - from) * 0.5 * (width(from) + width(to))
    };
    if area < LEAST_AREA {
        return None;
    }
    let axis = if direction.x.abs() >= direction.y.abs() { Axis::X } else { Axis::Y };
    let at = |place: f64| super::ring::along(edge.start + direction * place, axis);
    let middle = 0.5 * (from + to);
    Some(ThinPart {
        from: at(from).min(at(to)),
        to: at(from).max(at(to)),
        axis,
        middle: edge.start + direction * middle + edge.normal() * (0.5 * width(middle)),
        area,
    })
}

/// Square metres of a corner of an angle in radians that a disc of a radius does not reach.
fn beyond_disc(radius: f64, angle: f64) -> f64 {
    radius * radius * (1.0 / libm::tan(0.5 * angle).max(1e-3) - 0.5 * (std::f64::consts::PI - angle))
}

/// A ring cut at the ends of a thin part: that part, and what is left.
fn cut_off(ring: &[Point], part: ThinPart) -> Option<(Ring, Vec<Ring>)> {
    let (mut rests, beyond) = split(ring, part.axis, part.from);
    let mut spur = None;
    for piece in beyond {
        let (inside, after) = split(&piece, part.axis, part.to);
        rests.extend(after);
        for piece in inside {
            if spur.is_none() && ring_contains(&piece, part.middle) {
                spur = Some(piece);
            } else {
                rests.push(piece);
            }
        }
    }
    // Where the cut did not part it from a room, it is no part by itself.
    let spur = spur.filter(|spur| area(spur) < 3.0 * part.area + LEAST_AREA)?;
    rests.sort_by(|a, b| area(b).total_cmp(&area(a)));
    Some((spur, rests))
}

/// The first of some pieces with those that border on it, and the others.
pub(super) fn joined_to_largest(mut rests: Vec<Ring>) -> Option<(Ring, Vec<Ring>)> {
    let mut whole = (!rests.is_empty()).then(|| rests.remove(0))?;
    while let Some((index, ring)) =
        rests.iter().enumerate().find_map(|(index, rest)| Some((index, join(&whole, rest)?)))
    {
        whole = ring;
        rests.remove(index);
    }
    Some((whole, rests))
}

/// Whether parts of a ring are too thin.
pub(super) fn has_thin_parts(ring: &[Point]) -> bool {
    thin_area(ring, THIN_ROOM) > MOST_AREA
}

/// Whether cutting a room and small ones out of a whole leaves thin parts that the whole has not, or a small room with any.
pub(super) fn leave_thin_parts(whole: &[Point], room: &[Point], small: &[Ring]) -> bool {
    let thin = |ring: &[Point]| thin_area(ring, THIN_ROOM);
    thin(room) > thin(whole) + MOST_AREA || small.iter().any(|ring| has_thin_parts(ring))
}

/// Whether a part of a room between its inner faces is too narrow for any use.
pub(super) fn has_slivers(faces: &[Segment]) -> bool {
    let ring: Ring = faces.iter().map(|face| face.start).collect();
    let is_surely = || total_area(&thin_parts(&ring, SLIVER_WIDTH)) > SLIVER_DOUBT.1;
    let estimated = total_area(&thin_parts_between(&ring, SLIVER_WIDTH, NEARLY_OPPOSITE));
    let is_possible = || !is_narrow_in_small_corners_only(&ring) && largest_sliver(&ring) > SLIVER_AREA;
    estimated > SLIVER_DOUBT.0 && (is_surely() || is_possible())
}

/// Whether a disc as wide as the narrowest part of use reaches all of a room but its corners, none of which is large.
///
/// Where no two edges that are no neighbours come as near as the disc is wide, it touches two edges at a corner alone: then it may
/// roll into each corner as far as that is wide enough, and beyond it leaves what [`beyond_disc`] says.
fn is_narrow_in_small_corners_only(ring: &[Point]) -> bool {
    let all: Vec<Segment> = edges(ring).collect();
    let count = all.len();
    // Of a triangle all edges are neighbours.
    if count < 4 {
        return false;
    }
    let is_small = |index: usize| {
        let (edge, next) = (all[index].direction(), all[(index + 1) % count].direction());
        let angle = libm::acos((-edge.dot(next)).clamp(-1.0, 1.0));
        edge.perp_dot(next) <= 0.0 || beyond_disc(0.5 * SLIVER_WIDTH, angle) < SLIVER_AREA - SLIVER_MARGIN
    };
    let are_apart = |first: usize, second: usize| {
        let is_neighbour = second == first + 1 || (first == 0 && second + 1 == count);
        is_neighbour || distance(all[first], all[second]) > SLIVER_WIDTH + 2.0 * NOISE
    };
    (0..count).all(is_small)
        && (0..count).all(|first| (first + 1..count).all(|second| are_apart(first, second)))
}

/// Metres between two edges that do not cross.
fn distance(first: Segment, second: Segment) -> f64 {
    let ends = [
        first.distance_squared(second.start),
        first.distance_squared(second.end),
        second.distance_squared(first.start),
        second.distance_squared(first.end),
    ];
    ends.into_iter().fold(f64::INFINITY, f64::min).sqrt()
}

/// Square metres of the largest part that no disc as wide as the narrowest part of use reaches: what an opening by that disc takes
/// off (Serra, Image Analysis and Mathematical Morphology, 1982).
fn largest_sliver(ring: &[Point]) -> f64 {
    let room = geo::MultiPolygon::new(vec![ring_surface(ring)]);
    let moved = |shape: &geo::MultiPolygon<f64>, by: f64| {
        shape.buffer_with_style(BufferStyle::new(by).line_join(LineJoin::Round(ARC)))
    };
    let opened = moved(&moved(&room, -0.5 * SLIVER_WIDTH), 0.5 * SLIVER_WIDTH);
    let largest =
        |parts: &geo::MultiPolygon<f64>| parts.0.iter().map(geo::Area::unsigned_area).fold(0.0, f64::max);
    let rest = room.difference(&opened);
    // Without the noise it is no larger.
    let most = largest(&rest);
    if most < SLIVER_AREA - SLIVER_MARGIN { most } else { largest(&moved(&moved(&rest, -NOISE), NOISE)) }
}

/// Square metres of all thin parts.
fn thin_area(ring: &[Point], below: f64) -> f64 {
    total_area(&thin_parts(ring, below))
}

fn total_area(parts: &[ThinPart]) -> f64 {
    parts.iter().map(|part| part.area).sum()
}

/// A floor without the parts of it that are too thin for any room: several pieces where one of them joined these.
pub(super) fn without_thin_parts(ring: Ring) -> Vec<Ring> {
    if ring.len() > MOST_CORNERS {
        return vec![ring];
    }
    let mut open = vec![ring];
    let mut done = Vec::new();
    for _ in 0..4 * MOST_PARTS {
        let Some(ring) = open.pop() else { break };
        let cut = thin_parts(&ring, THIN).into_iter().find_map(|part| cut_off(&ring, part));
        match cut {
            Some((_, rests)) => {
                let (whole, others) = joined_to_largest(rests).unwrap_or_default();
                open.extend(std::iter::once(whole).chain(others).filter(|ring| !ring.is_empty()));
            }
            None => done.push(ring),
        }
    }
    done.extend(open);
    done
}

/// What trading must leave as it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules<'a> {
    /// What doors may join.
    typologies: &'a Typologies,
    /// A type of room that keeps its outline.
    fixed: Option<&'a str>,
    /// Metres below which a part is thin.
    below: f64,
}

impl<'a> Rules<'a> {
    /// For rooms up to the middles of their walls.
    pub(super) fn of_rooms(typologies: &'a Typologies) -> Self {
        Self { typologies, fixed: None, below: THIN_ROOM }
    }

    /// The same where rooms of one type keep their outlines.
    pub(super) fn with_fixed(self, room_type: &'a str) -> Self {
        Self { fixed: Some(room_type), ..self }
    }

    /// The same for parts that are thin below so many metres.
    pub(super) fn below(self, below: f64) -> Self {
        Self { below, ..self }
    }

    fn is_fixed(self, cell: &Cell) -> bool {
        self.fixed == Some(cell.room_type.as_str())
    }

    /// Whether a door may join two rooms.
    fn may_meet(self, first: &Cell, second: &Cell) -> bool {
        let leads = |from: &Cell, to: &Cell| {
            self.typologies
                .rooms
                .get(&from.room_type)
                .is_some_and(|needs| needs.doors.contains(&to.room_type))
        };
        leads(first, second) || leads(second, first)
    }
}

/// Gives the thin parts of rooms to neighbours in which they are not thin.
pub(super) fn trade_thin_parts(cells: &mut [Cell], rules: Rules<'_>) {
    trade(cells, rules, |_| true);
}

/// Gives the strips of rooms to neighbours that they make wider.
pub(super) fn trade_strips(cells: &mut [Cell], rules: Rules<'_>) {
    // Not the tips of wedges, which are no strips but corners.
    let is_strip = |part: &ThinPart| part.length() >= STRIP_LENGTH && part.area >= THIN_ROOM * part.length();
    trade(cells, rules.below(STRIP), is_strip);
}

fn trade(cells: &mut [Cell], rules: Rules<'_>, is_meant: impl Fn(&ThinPart) -> bool) {
    for giver in 0..cells.len() {
        if rules.is_fixed(&cells[giver]) || cells[giver].ring.len() > MOST_CORNERS {
            continue;
        }
        for _ in 0..MOST_PARTS {
            let parts = thin_parts(&cells[giver].ring, rules.below);
            let before = total_area(&parts);
            let mut meant = parts.into_iter().filter(&is_meant);
            if !meant.any(|part| is_traded(cells, (giver, before), part, rules)) {
                break;
            }
        }
    }
}

/// Gives one thin part away, of a room with so many square metres of them; `false` where nobody may take it.
fn is_traded(cells: &mut [Cell], (giver, before): (usize, f64), part: ThinPart, rules: Rules<'_>) -> bool {
    let Some((spur, rests)) = cut_off(&cells[giver].ring, part) else { return false };
    let Some((rest, others)) = joined_to_largest(rests) else { return false };
    let is_whole = others.iter().map(|ring| area(ring)).sum::<f64>() < MOST_GIVEN * area(&rest);
    if !is_whole || !is_simple(&rest) || thin_area(&rest, rules.below) > before - 0.5 * part.area {
        return false;
    }
    let mut taken: BTreeMap<usize, Ring> = BTreeMap::new();
    for piece in std::iter::once(spur).chain(others) {
        if !is_given(cells, &mut taken, (giver, &piece), part.axis, rules) {
            return false;
        }
    }
    let thin = |ring: &Ring| thin_area(ring, rules.below);
    let grown: f64 = taken.iter().map(|(&taker, ring)| thin(ring) - thin(&cells[taker].ring)).sum();
    if grown > 0.5 * part.area || !taken.values().all(|ring| is_simple(ring)) {
        return false;
    }
    // Where a door may be needed, one stays possible.
    let has_door = |ring: &[Point], other: usize| {
        let beside = taken.get(&other).unwrap_or(&cells[other].ring);
        shared_length(ring, beside) >= LEAST_BORDER
    };
    let keeps_doors = (0..cells.len())
        .filter(|&other| other != giver && rules.may_meet(&cells[giver], &cells[other]))
        .filter(|&other| shared_length(&cells[giver].ring, &cells[other].ring) >= LEAST_BORDER)
        .all(|other| has_door(&rest, other));
    if !keeps_doors {
        return false;
    }
    cells[giver].ring = rest;
    taken.into_iter().for_each(|(taker, ring)| cells[taker].ring = ring);
    true
}

/// Joins a piece to the rooms beside it: to one, or in slices to several; the rooms as they would be then are in `taken`.
fn is_given(
    cells: &[Cell],
    taken: &mut BTreeMap<usize, Ring>,
    (giver, piece): (usize, &Ring),
    axis: Axis,
    rules: Rules<'_>,
) -> bool {
    let reach = bounds(piece).inflated(0.01);
    let is_beside = |taker: &usize| {
        *taker != giver && !rules.is_fixed(&cells[*taker]) && bounds(&cells[*taker].ring).touches(reach)
    };
    let mut takers: Vec<(f64, usize, Vec<Segment>)> = (0..cells.len())
        .filter(is_beside)
        .map(|taker| (taker, shared(piece, &cells[taker].ring)))
        .map(|(taker, border)| (total_length(&border), taker, border))
        .filter(|(length, ..)| *length > TAKING_BORDER)
        .collect();
    takers.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    // The ends of the rooms along the piece part it into slices, one for each.
    let ends = takers.iter().flat_map(|(.., border)| border).flat_map(|border| [border.start, border.end]);
    let mut places: Vec<f64> = ends.map(|end| super::ring::along(end, axis)).collect();
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() < THIN);
    let mut slices = vec![piece.clone()];
    for place in places {
        slices = slices
            .into_iter()
            .flat_map(|slice| {
                let (below, above) = split(&slice, axis, place);
                below.into_iter().chain(above)
            })
            .collect();
    }
    let mut give = |slice: &Ring| {
        let mut order: Vec<(f64, usize)> = takers
            .iter()
            .map(|&(_, taker, _)| (total_length(&shared(slice, &cells[taker].ring)), taker))
            .collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let joined = order.into_iter().find_map(|(_, taker)| {
            Some((taker, join(taken.get(&taker).unwrap_or(&cells[taker].ring), slice)?))
        });
        joined.map(|(taker, ring)| taken.insert(taker, ring)).is_some()
    };
    slices.iter().all(&mut give)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring<const N: usize>(corners: [(f64, f64); N]) -> Ring {
        corners.map(Point::from).into()
    }

    #[test]
    fn a_jog_beside_a_cut_goes_to_the_room_beyond_it() {
        // The outline steps back by 1 m at x = 2.8; the rooms are cut at x = 3.
        let left = ring([(0., 0.), (3., 0.), (3., 5.), (2.8, 5.), (2.8, 4.), (0., 4.)]);
        let right = ring([(3., 0.), (6., 0.), (6., 5.), (3., 5.)]);
        let mut cells = vec![Cell::shared(left, "bedroom"), Cell::shared(right, "room")];
        trade_thin_parts(&mut cells, Rules::of_rooms(&Typologies::default()));
        assert!((area(&cells[0].ring) - 12.0).abs() < 1e-9, "{:?}", cells[0].ring);
        assert!((area(&cells[1].ring) - 15.2).abs() < 1e-9, "{:?}", cells[1].ring);
        assert!(cells.iter().all(|cell| thin_parts(&cell.ring, THIN_ROOM).is_empty()));
    }

    #[test]
    fn a_strip_beside_a_corridor_makes_it_wider_and_a_niche_stays() {
        // The bathroom goes on beside the corridor, 0.65 m wide, for as many metres.
        let bathroom = |length: f64| {
            ring([(1.35, 0.), (2., 0.), (2., length), (4., length), (4., length + 2.), (1.35, length + 2.)])
        };
        let corridor = |length: f64| ring([(0., 0.), (1.35, 0.), (1.35, length + 2.), (0., length + 2.)]);
        let areas = |length: f64| {
            let mut cells =
                vec![Cell::shared(bathroom(length), "bathroom"), Cell::shared(corridor(length), "corridor")];
            trade_strips(&mut cells, Rules::of_rooms(&Typologies::default()));
            cells.iter().map(|cell| area(&cell.ring)).collect::<Vec<f64>>()
        };
        let widened = areas(5.0);
        assert!(
            (widened[0] - 2.65 * 2.0).abs() < 1e-9 && (widened[1] - (1.35 * 7.0 + 0.65 * 5.0)).abs() < 1e-9
        );
        assert_eq!(areas(1.5), [bathroom(1.5), corridor(1.5)].map(|ring| area(&ring)));
    }

    #[test]
    fn fixed_rooms_keep_what_they_have() {
        let left = ring([(0., 0.), (3., 0.), (3., 5.), (2.8, 5.), (2.8, 4.), (0., 4.)]);
        let right = ring([(3., 0.), (6., 0.), (6., 5.), (3., 5.)]);
        let mut cells = vec![Cell::shared(left, "stairs"), Cell::shared(right, "room")];
        let typologies = Typologies::default();
        trade_thin_parts(&mut cells, Rules::of_rooms(&typologies).with_fixed("stairs"));
        assert!((area(&cells[0].ring) - 12.2).abs() < 1e-9);
    }

    #[test]
    fn a_spur_of_the_outline_is_no_floor() {
        let spur = ring([(0., 0.), (8., 0.), (8., 6.), (5., 6.), (5., 9.), (4.8, 9.), (4.8, 6.), (0., 6.)]);
        let pieces = without_thin_parts(spur);
        assert_eq!(pieces.len(), 1);
        assert!((area(&pieces[0]) - 48.0).abs() < 1e-9, "{pieces:?}");
        let sharp = ring([(0., 0.), (20., 0.), (20., 3.)]);
        let blunt = without_thin_parts(sharp.clone());
        assert!(
            area(&blunt[0]) > 29.0
                && area(&blunt[0]) < area(&sharp)
                && thin_parts(&blunt[0], THIN).is_empty()
        );
    }

    #[test]
    fn a_neck_between_two_halls_parts_them() {
        let neck = ring([
            (0., 0.),
            (4., 0.),
            (4., 2.),
            (6., 2.),
            (6., 0.),
            (9., 0.),
            (9., 5.),
            (6., 5.),
            (6., 2.2),
            (4., 2.2),
            (4., 5.),
            (0., 5.),
        ]);
        let mut areas: Vec<f64> = without_thin_parts(neck).iter().map(|piece| area(piece)).collect();
        areas.sort_by(f64::total_cmp);
        assert_eq!(areas, [15.0, 20.0]);
    }

    #[test]
    fn what_two_corners_and_a_neck_leave_is_a_sliver() {
        // Each alone is less than a sliver: a corner of 45 degrees, and the neck at the inner corner before it.
        let corridor =
            ring([(0., 3.89), (0., 0.), (1.22, 0.), (1.22, 4.55), (2.52, 4.55), (2.52, 5.86), (0.45, 3.89)]);
        // A bit of 0.2 m beside the end of an oblique wall.
        let living_room = ring([
            (-4.343, -4.851),
            (-1.34, -1.831),
            (-1.149, -1.947),
            (-1.149, -1.62),
            (-2.97, -1.62),
            (-2.97, 0.575),
            (-8.33, 0.575),
            (-8.33, -2.091),
        ]);
        let oblique = ring([(0., 0.), (4., 0.), (4., 3.), (0., 1.)]);
        let faces = |ring: &Ring| edges(ring).collect::<Vec<Segment>>();
        assert!(has_slivers(&faces(&corridor)) && has_slivers(&faces(&living_room)));
        assert!(!has_slivers(&faces(&oblique)));
    }

    #[test]
    fn plain_rooms_have_no_thin_parts() {
        assert!(!has_thin_parts(&ring([(0., 0.), (3., 0.), (3., 2.), (0., 2.)])));
        assert!(!has_thin_parts(&ring([(0., 0.), (6., 0.), (6., 2.), (2., 2.), (2., 8.), (0., 8.)])));
    }

    #[test]
    fn a_room_that_is_narrow_in_small_corners_only_has_no_sliver() {
        // Corners of 50 and of 30 degrees, and a bay that is 0.25 m wide beside one of 50.
        let leaning = |tip: f64| ring([(0., 0.), (tip, 0.), (4., 3.), (0., 3.)]);
        let bay = ring([(0., 0.), (6.5, 0.), (4., 3.), (3., 3.), (3., 4.), (2.75, 4.), (2.75, 3.), (0., 3.)]);
        let (small, sharp) = (leaning(6.5), leaning(9.2));
        assert!(is_narrow_in_small_corners_only(&small) && largest_sliver(&small) < SLIVER_AREA);
        assert!(!is_narrow_in_small_corners_only(&sharp) && largest_sliver(&sharp) > SLIVER_AREA);
        assert!(!is_narrow_in_small_corners_only(&bay) && largest_sliver(&bay) > SLIVER_AREA);
        assert!(!is_narrow_in_small_corners_only(&small[..3]), "of a triangle nothing is known");
    }
}
