//! What lies before the outer walls of a building: open air, a neighbour's wall, a gap too narrow for windows.

use rstar::{AABB, RTree, RTreeObject};

use crate::geometry::{Bounds, Intervals, Point, Segment, ring_contains};

use super::footprint::{Footprint, Site};
use super::ring::Ring;

/// Metres between the places of a wall from which one looks out.
const STEP: f64 = 1.0;
/// Places on one edge at most: a wall of 100 m is looked at every 2 m.
const MOST_PLACES: usize = 48;
/// A neighbour within this many metres stands wall to wall.
const PARTY_GAP: f64 = 0.4;
/// Metres of free sight that a window needs.
pub(super) const WINDOW_SIGHT: f64 = 2.0;
/// Metres that one looks; what is farther is as good as nothing.
const FARTHEST: f64 = 25.0;
/// Metres from a wall to the street that it is entered from, at most.
const STREET_REACH: f64 = 50.0;
/// Metres before a wall at which looking begins: outlines of neighbours overlap a little.
const OVERLAP: f64 = 0.3;
/// Metres beside a window over which its sight is free too.
const SIGHT_MARGIN: f64 = 0.05;
/// Metres between an entrance of the map and the wall it is in, at most.
const ENTRANCE_REACH: f64 = 1.5;

/// What a piece of an outer wall looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum EdgeClass {
    /// The open air on the side of the entrance.
    Street,
    /// The open air elsewhere.
    Yard,
    /// A courtyard of the building itself.
    Court,
    /// A neighbour wall to wall.
    Party,
    /// A neighbour, or the building itself, so near that a window would look at a wall.
    Blocked,
}

impl EdgeClass {
    /// Whether windows may look out.
    pub(super) fn is_free(self) -> bool {
        matches!(self, Self::Street | Self::Yard | Self::Court)
    }
}

/// A piece of an outer wall that looks at one thing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    /// On the outer face, with the building on the left; in the frame of the building.
    pub(super) line: Segment,
    /// Along it, of length 1.
    direction: Point,
    /// What it looks at.
    pub(super) class: EdgeClass,
    /// Metres to what stands before it, [`FARTHEST`] at most.
    pub(super) sight: f64,
}

impl Span {
    pub(super) fn new(line: Segment, class: EdgeClass, sight: f64) -> Self {
        Self { line, direction: line.direction(), class, sight }
    }
}

/// All outer walls of a building.
#[derive(Clone, Debug, Default)]
pub(super) struct Facade {
    /// The spans, edge by edge.
    pub(super) spans: Vec<Span>,
    /// Where people come in: a point of a span, if any span is free.
    pub(super) entrance: Option<(usize, Point)>,
}

/// The footprints and streets of a site by place.
#[derive(Debug)]
pub(crate) struct Neighbourhood<'a> {
    footprints: &'a [Footprint],
    tree: RTree<Place>,
    /// The straight pieces of all streets.
    pieces: Vec<[Point; 2]>,
    streets: RTree<Place>,
}

#[derive(Clone, Copy, Debug)]
struct Place {
    bounds: Bounds,
    index: usize,
}

impl RTreeObject for Place {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.bounds.low.into(), self.bounds.high.into())
    }
}

impl<'a> Neighbourhood<'a> {
    /// Of all footprints and streets of a site.
    pub(crate) fn new(site: &'a Site) -> Self {
        let footprints = &site.footprints;
        let tree = places(footprints.iter().map(|footprint| footprint.region.outline.bounds()));
        let pieces: Vec<[Point; 2]> =
            site.streets.iter().flat_map(|street| street.windows(2)).map(|pair| [pair[0], pair[1]]).collect();
        let streets = places(pieces.iter().map(|piece| Bounds::around(*piece)));
        Self { footprints, tree, pieces, streets }
    }

    /// The footprints near one of them, in the order of the site.
    pub(super) fn near(&self, index: usize) -> Vec<&'a Footprint> {
        let found = within(&self.tree, self.reach(index, FARTHEST));
        found.into_iter().filter(|&other| other != index).map(|other| &self.footprints[other]).collect()
    }

    /// The pieces of streets that a footprint may be entered from, in the order of the site.
    pub(super) fn streets_near(&self, index: usize) -> Vec<[Point; 2]> {
        let found = within(&self.streets, self.reach(index, STREET_REACH));
        found.into_iter().map(|piece| self.pieces[piece]).collect()
    }

    fn reach(&self, index: usize, margin: f64) -> Bounds {
        self.footprints[index].region.outline.bounds().inflated(margin)
    }
}

fn places(boxes: impl Iterator<Item = Bounds>) -> RTree<Place> {
    RTree::bulk_load(boxes.enumerate().map(|(index, bounds)| Place { bounds, index }).collect())
}

/// The numbers of what meets a box, rising.
fn within(tree: &RTree<Place>, reach: Bounds) -> Vec<usize> {
    let envelope = AABB::from_corners(reach.low.into(), reach.high.into());
    let mut found: Vec<usize> =
        tree.locate_in_envelope_intersecting(&envelope).map(|place| place.index).collect();
    found.sort_unstable();
    found
}

/// What stands around a building, in its frame.
pub(super) struct Around {
    /// Outlines of the neighbours.
    pub(super) neighbours: Vec<Ring>,
    /// Entrances that the map shows.
    pub(super) entrances: Vec<Point>,
    /// Straight pieces of streets that the map shows.
    pub(super) streets: Vec<Segment>,
}

/// Looks out of all walls of a building. `outer` and `courts` are rings with the building on their left.
pub(super) fn look_out(outer: &Ring, courts: &[Ring], around: &Around) -> Facade {
    let own: Vec<Segment> = crate::geometry::edges(outer)
        .chain(courts.iter().flat_map(|court| crate::geometry::edges(court)))
        .collect();
    let reach = super::ring::bounds(outer).inflated(FARTHEST);
    let others: Vec<Segment> = around
        .neighbours
        .iter()
        .flat_map(|ring| crate::geometry::edges(ring))
        .filter(|edge| edge.bounds().touches(reach))
        .collect();
    let rings = around.neighbours.iter().map(|ring| (super::ring::bounds(ring), ring.as_slice()));
    let all = Seen { own, faces: others, rings: rings.collect() };
    let mut spans: Vec<Span> = Vec::new();
    for (index, edge) in all.own.iter().enumerate() {
        let open = if index < outer.len() { EdgeClass::Yard } else { EdgeClass::Court };
        let seen = all.near(*edge);
        let found = look_out_of_edge(*edge, open, &seen);
        spans.extend(found.into_iter().flat_map(|span| without_blocked(span, &seen.faces)));
    }
    let entrance = entrance(&spans, around);
    if let Some((front, _)) = entrance {
        let way_out = -spans[front].line.normal();
        for span in spans.iter_mut().filter(|span| span.class == EdgeClass::Yard) {
            if (-span.line.normal()).dot(way_out) > 0.7 {
                span.class = EdgeClass::Street;
            }
        }
    }
    Facade { spans, entrance }
}

/// What may stand before a wall.
struct Seen<'a> {
    /// The outer faces of the building itself.
    own: Vec<Segment>,
    /// The outer faces of neighbours.
    faces: Vec<Segment>,
    /// Their outlines, with their boxes.
    rings: Vec<(Bounds, &'a [Point])>,
}

impl Seen<'_> {
    /// What may be seen from an edge, in the same order: thousands of edges do not look at all others from each of their places.
    fn near(&self, edge: Segment) -> Self {
        let reach = edge.bounds().inflated(FARTHEST + OVERLAP);
        let faces = |all: &[Segment]| -> Vec<Segment> {
            all.iter().copied().filter(|face| face.bounds().touches(reach)).collect()
        };
        let rings = self.rings.iter().copied().filter(|(extent, _)| extent.touches(reach));
        Self { own: faces(&self.own), faces: faces(&self.faces), rings: rings.collect() }
    }
}

/// What an edge looks at, in pieces.
fn look_out_of_edge(edge: Segment, open: EdgeClass, around: &Seen<'_>) -> Vec<Span> {
    let Seen { own, faces: others, rings: neighbours } = around;
    let mut spans = Vec::new();
    let length = edge.length();
    let count = ((length / STEP).round() as usize).clamp(1, MOST_PLACES);
    let out = -edge.normal();
    let mut begun: Option<(usize, EdgeClass, f64)> = None;
    let span = |from: usize, to: usize, class, sight| {
        let [start, end] = [from, to].map(|place| edge.at(place as f64 / count as f64));
        Span::new(Segment::new(start, end), class, sight)
    };
    for place in 0..count {
        let eye = edge.at((place as f64 + 0.5) / count as f64);
        let to_others = nearest_hit(eye - out * OVERLAP, out, others).map(|hit| hit - OVERLAP);
        let to_self = nearest_hit(eye + out * 0.01, out, own);
        let class = match (to_others, to_self) {
            // Outlines of maps may lie in each other.
            _ if neighbours
                .iter()
                .any(|(extent, ring)| extent.contains(eye) && ring_contains(ring, eye + out * OVERLAP)) =>
            {
                EdgeClass::Party
            }
            (Some(gap), _) if gap <= PARTY_GAP => EdgeClass::Party,
            (Some(gap), _) | (None, Some(gap)) if gap < WINDOW_SIGHT => EdgeClass::Blocked,
            (_, Some(gap)) if gap < WINDOW_SIGHT => EdgeClass::Blocked,
            _ => open,
        };
        let sight = to_others.unwrap_or(FARTHEST).min(to_self.unwrap_or(FARTHEST)).max(0.0);
        begun = match begun {
            Some((from, known, least)) if known == class => Some((from, known, least.min(sight))),
            Some((from, known, least)) => {
                spans.push(span(from, place, known, least));
                Some((place, class, sight))
            }
            None => Some((place, class, sight)),
        };
    }
    if let Some((from, class, sight)) = begun {
        spans.push(span(from, count, class, sight));
    }
    spans
}

/// A span that is free, in pieces where an outer face of a neighbour reaches into the sight before it.
fn without_blocked(span: Span, others: &[Segment]) -> Vec<Span> {
    let length = span.line.length();
    let (mut free, mut blocked) = (Intervals::new(0.0, length), Intervals::new(0.0, length));
    if span.class.is_free() {
        let found = others.iter().filter_map(|other| blocked_by(span.line, *other));
        found.for_each(|(from, to)| free.subtract(from, to));
    }
    free.as_slice().iter().for_each(|&(from, to)| blocked.subtract(from, to));
    let pieces = |intervals: &Intervals, class: EdgeClass| -> Vec<Span> {
        let line = |from: f64, to: f64| Segment::new(span.line.at(from / length), span.line.at(to / length));
        intervals.as_slice().iter().map(|&(from, to)| Span { line: line(from, to), class, ..span }).collect()
    };
    [pieces(&free, span.class), pieces(&blocked, EdgeClass::Blocked)].concat()
}

/// From where to where along an outer wall an outer face of a neighbour stands too near before it.
fn blocked_by(wall: Segment, other: Segment) -> Option<(f64, f64)> {
    let direction = wall.direction();
    let place = |point: Point| {
        let from = point - wall.start;
        (from.dot(direction), -wall.normal().dot(from))
    };
    let ((from, near), (to, far)) = (place(other.start), place(other.end));
    let (least, most) = (-OVERLAP, WINDOW_SIGHT);
    if near.max(far) <= least || near.min(far) >= most {
        return None;
    }
    let change = far - near;
    let share =
        |depth: f64| if change.abs() < 1e-9 { 0.0 } else { ((depth - near) / change).clamp(0.0, 1.0) };
    // Which share of the other face is in reach.
    let (first, last) = match change.abs() < 1e-9 {
        true => (0.0, 1.0),
        false => (share(least).min(share(most)), share(least).max(share(most))),
    };
    let ends = [first, last].map(|share| from + (to - from) * share);
    let (low, high) = (ends[0].min(ends[1]) - SIGHT_MARGIN, ends[0].max(ends[1]) + SIGHT_MARGIN);
    (high > 0.0 && low < wall.length()).then_some((low, high))
}

/// Metres from an eye to the first edge it sees, if one is within reach.
fn nearest_hit(eye: Point, way: Point, edges: &[Segment]) -> Option<f64> {
    let hit = |edge: &Segment| {
        let (across, offset) = (edge.vector(), edge.start - eye);
        let scale = way.perp_dot(across);
        if scale.abs() < 1e-9 {
            return None;
        }
        let (distance, share) = (offset.perp_dot(across) / scale, offset.perp_dot(way) / scale);
        ((0.0..=FARTHEST).contains(&distance) && (0.0..=1.0).contains(&share)).then_some(distance)
    };
    edges.iter().filter_map(hit).reduce(f64::min)
}

/// Where people come in: at an entrance of the map, else the middle of the free wall that is nearest to a street, else of the
/// longest with much air before it.
fn entrance(spans: &[Span], around: &Around) -> Option<(usize, Point)> {
    let free = || spans.iter().enumerate().filter(|(_, span)| span.class.is_free());
    let drawn = around.entrances.iter().flat_map(|&door| {
        free().map(move |(index, span)| (span.line.distance(door), index, span.line.nearest(door)))
    });
    let nearest =
        drawn.filter(|(gap, ..)| *gap < ENTRANCE_REACH).reduce(|a, b| if b.0 < a.0 { b } else { a });
    if let Some((_, index, point)) = nearest {
        return Some((index, point));
    }
    let to_street = |span: &Span| {
        let middle = span.line.middle();
        let gaps = around.streets.iter().map(|street| street.nearest(middle) - middle);
        // A street behind the building does not count.
        let before = gaps.filter(|gap| gap.dot(-span.line.normal()) > 0.0).map(|gap| gap.length());
        before.reduce(f64::min).filter(|gap| *gap < STREET_REACH)
    };
    let worth = |span: &Span| {
        let court = if span.class == EdgeClass::Court { 0.1 } else { 1.0 };
        let near_street = to_street(span).map_or(1.0, |gap| 60.0 / (10.0 + gap));
        court * near_street * span.line.length().min(20.0) * (2.0 + span.sight)
    };
    let best =
        free().map(|(index, span)| (worth(span), index)).reduce(|a, b| if b.0 > a.0 + 1e-9 { b } else { a });
    // What has no free wall is entered through a gap between buildings, or else through a neighbour.
    let walled = || {
        let rank = |span: &Span| (span.class == EdgeClass::Blocked, span.line.length());
        let all = spans.iter().enumerate().map(|(index, span)| (rank(span), index));
        all.reduce(|a, b| if b.0 > a.0 { b } else { a }).map(|(_, index)| index)
    };
    let index = best.map(|(_, index)| index).or_else(walled)?;
    Some((index, spans[index].line.middle()))
}

impl Facade {
    /// The spans that the piece of a room's border lies behind, within these metres of their outer face.
    /// Each comes with the piece of the border before it.
    pub(super) fn before(
        &self,
        border: Segment,
        (least, most): (f64, f64),
    ) -> impl Iterator<Item = (&Span, Segment)> {
        let direction = border.direction();
        self.spans.iter().filter_map(move |span| {
            if span.direction.dot(direction) < 0.9998 {
                return None;
            }
            // Its inner face is as deep behind the outer one as the wall is thick: other cuts may run near it.
            let gap = span.direction.perp().dot(border.start - span.line.start);
            if gap < least - 0.06 || gap > most + 0.06 {
                return None;
            }
            let from = (span.line.start - border.start).dot(direction).max(0.0);
            let to = (span.line.end - border.start).dot(direction).min(border.length());
            (to - from > 0.05)
                .then(|| (span, Segment::new(border.start + direction * from, border.start + direction * to)))
        })
    }
}
