//! The floor that a storey has: the footprint without its outer walls, in pieces without holes.

use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::{BooleanOps, Buffer};

use crate::geometry::{Point, Polygon, Segment, edges, ring_contains, signed_area};
use crate::plan::ring_surface;

use super::brief::Measures;
use super::disc::is_simple;
use super::facade::{Around, Facade, look_out};
use super::footprint::Footprint;
use super::frame::Frame;
use super::links::LEAST_BORDER;
use super::ring::{
    Axis, Ring, area, bounds, join, on_grid, shared_length, split, tidy, without_straight_corners,
};
use super::spine::Ground;
use super::thin::without_thin_parts;

/// Corners that stand out farther than this many times the depth of the wall are cut off.
const MITRE_LIMIT: f64 = 4.0;
/// Square metres below which a piece that no other borders on is no floor, and with stairs of its own.
const LEAST_ISLAND: (f64, f64) = (2.0, 15.0);
/// The same as a share of the storey.
const ISLAND_SHARE: f64 = 0.04;
/// Pieces below this many square metres are no floor.
const LEAST_PIECE: f64 = 1.0;
/// Pieces below this many square metres are no room of their own: they join the one that they were cut from.
const LEAST_OWN: f64 = 15.0;
/// Metres of the outer walls of buildings with wings too narrow for thicker ones.
const THIN_WALL: f64 = 0.12;
/// Share of the outline that may be lost with such wings.
const MOST_LOST: f64 = 0.045;

/// A building's outline in its frame.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// Its frame.
    pub(super) frame: Frame,
    /// The outer faces of its walls, counter-clockwise.
    pub(super) outer: Ring,
    /// Its courtyards, counter-clockwise.
    pub(super) courts: Vec<Ring>,
    /// What lies before the walls.
    pub(super) facade: Facade,
}

impl Outline {
    /// A footprint among its neighbours.
    pub(super) fn of(footprint: &Footprint, neighbours: &[&Footprint], streets: &[[Point; 2]]) -> Self {
        let frame = Frame::of(&footprint.region);
        let ring = |polygon: &Polygon| tidy(frame.ring(polygon.corners()));
        let outer = without_straight_corners(&ring(&footprint.region.outline));
        let courts: Vec<Ring> =
            footprint.region.holes.iter().map(|hole| without_straight_corners(&ring(hole))).collect();
        let around = Around {
            neighbours: neighbours.iter().map(|other| frame.ring(other.region.outline.corners())).collect(),
            entrances: footprint.entrances.iter().map(|&door| frame.point(door)).collect(),
            streets: streets
                .iter()
                .map(|street| Segment::new(frame.point(street[0]), frame.point(street[1])))
                .collect(),
        };
        let inside_left: Vec<Ring> =
            courts.iter().map(|court| court.iter().rev().copied().collect()).collect();
        let facade = look_out(&outer, &inside_left, &around);
        Self { frame, outer, courts, facade }
    }

    /// The figures that kinds of buildings are chosen by.
    pub(super) fn measures(&self) -> Measures {
        // The frame lies along the outline.
        let length = bounds(&self.outer).size().x;
        Measures { area: self.area(), depth: self.depth(), length, party: self.party() }
    }

    /// Square metres.
    fn area(&self) -> f64 {
        area(&self.outer) - self.courts.iter().map(|court| area(court)).sum::<f64>()
    }

    /// Metres of the largest disc inside.
    fn depth(&self) -> f64 {
        let rings: Vec<&[Point]> =
            std::iter::once(&self.outer).chain(&self.courts).map(|ring| ring.as_slice()).collect();
        super::disc::largest_disc(&rings, f64::INFINITY).0
    }

    /// Share of the outer walls with a neighbour wall to wall.
    fn party(&self) -> f64 {
        let length = |is_party: fn(super::facade::EdgeClass) -> bool| {
            let spans = self.facade.spans.iter().filter(|span| is_party(span.class));
            spans.map(|span| span.line.length()).sum::<f64>()
        };
        length(|class| class == super::facade::EdgeClass::Party) / length(|_| true).max(0.1)
    }

    /// As [`Self::grounds`]; inside thin walls where those of this thickness leave no floor in a wing.
    pub(super) fn grounds_that_fill(&self, wall: f64, storeys: u32) -> Vec<Ground> {
        let usual = self.grounds(wall, storeys);
        if wall <= THIN_WALL || usual.is_empty() || self.lost(&usual) < MOST_LOST {
            return usual;
        }
        let thin = self.grounds(THIN_WALL, storeys);
        if self.lost(&thin) < MOST_LOST { thin } else { usual }
    }

    /// Share of the outline that is neither floor nor wall around it; about where little is.
    fn lost(&self, grounds: &[Ground]) -> f64 {
        let wall = grounds.first().map_or(0.0, |ground| ground.wall);
        if let [ground] = grounds {
            let walls: f64 = edges(&ground.ring).map(|edge| edge.length() * wall).sum();
            let about = 1.0 - (area(&ground.ring) + walls) / self.area();
            if about < 0.5 * MOST_LOST {
                return about;
            }
        }
        let pieces: Vec<geo::Polygon<f64>> =
            grounds.iter().map(|ground| ring_surface(&ground.ring)).collect();
        let style = BufferStyle::new(wall).line_join(LineJoin::Miter(std::f64::consts::FRAC_PI_6));
        let built = geo::unary_union(&pieces).buffer_with_style(style);
        1.0 - geo::Area::unsigned_area(&built) / self.area()
    }

    /// The floor of each of so many storeys inside walls of this thickness, in pieces that are joined by nothing but cuts, the
    /// largest first.
    pub(super) fn grounds(&self, wall: f64, storeys: u32) -> Vec<Ground> {
        let holes: Vec<Ring> = self.courts.iter().flat_map(|court| moved(court, wall)).collect();
        let mut pieces: Vec<Ring> = Vec::new();
        for ring in moved(&self.outer, -wall) {
            for (ring, own) in with_courts(ring, &holes) {
                pieces.extend(opened(ring, own, 0).into_iter().flat_map(without_thin_parts));
            }
        }
        pieces.retain(|ring| area(ring) >= LEAST_PIECE && is_simple(ring));
        pieces.sort_by(|a, b| area(b).total_cmp(&area(a)));
        let pieces = without_small_islands(pieces, if storeys > 1 { LEAST_ISLAND.1 } else { LEAST_ISLAND.0 });
        let ground = |ring| Ground { ring, facade: self.facade.clone(), wall };
        pieces.into_iter().map(ground).collect()
    }
}

/// The pieces that people can walk between, and of the others those that are worth a door of their own.
fn without_small_islands(pieces: Vec<Ring>, least: f64) -> Vec<Ring> {
    let least = least.max(ISLAND_SHARE * pieces.iter().map(|ring| area(ring)).sum::<f64>());
    let mut kept: Vec<Ring> = Vec::new();
    for ring in pieces {
        let is_beside = |other: &Ring| shared_length(&ring, other) >= LEAST_BORDER;
        let with = |other: &Ring| join(other, &ring).filter(|whole| is_simple(whole));
        let is_small = area(&ring) < LEAST_OWN;
        let joined = kept
            .iter()
            .enumerate()
            .filter(|_| is_small)
            .find_map(|(index, other)| Some((index, with(other)?)));
        if let Some((index, whole)) = joined {
            kept[index] = whole;
        } else if kept.is_empty() || area(&ring) >= least || kept.iter().any(is_beside) {
            kept.push(ring);
        }
    }
    kept
}

/// A floor with the courts in it; without those that reach through its outline, where it ends at them.
fn with_courts(ring: Ring, holes: &[Ring]) -> Vec<(Ring, Vec<Ring>)> {
    let corners_inside = |hole: &Ring| hole.iter().filter(|corner| ring_contains(&ring, **corner)).count();
    let own: Vec<Ring> = holes.iter().filter(|hole| corners_inside(hole) > 0).cloned().collect();
    let crosses = |hole: &Ring| {
        corners_inside(hole) < hole.len() || ring.iter().any(|corner| ring_contains(hole, *corner))
    };
    if !own.iter().any(crosses) {
        return vec![(ring, own)];
    }
    let courts: Vec<geo::Polygon<f64>> = own.iter().map(|hole| ring_surface(hole)).collect();
    let floor = ring_surface(&ring).difference(&geo::unary_union(&courts));
    let ring_of = |line: &geo::LineString<f64>| {
        let mut corners: Ring = line.0.iter().map(|coord| on_grid(Point::new(coord.x, coord.y))).collect();
        corners.pop();
        without_straight_corners(&tidy(corners))
    };
    let is_sound = |ring: &Ring| ring.len() > 2 && is_simple(ring);
    let parts = floor.0.iter().map(|part| {
        let courts = part.interiors().iter().map(ring_of).map(|mut court| {
            // Courts run counter-clockwise, as outlines do.
            if signed_area(&court) < 0.0 {
                court.reverse();
            }
            court
        });
        (ring_of(part.exterior()), courts.filter(is_sound).collect())
    });
    parts.filter(|(ring, _)| is_sound(ring)).collect()
}

/// A ring whose edges move outwards by some metres, inwards if below zero; several where it falls apart, none if nothing is left.
fn moved(ring: &Ring, by: f64) -> Vec<Ring> {
    if let Some(mitred) = mitred(ring, by) {
        return vec![mitred];
    }
    let style = BufferStyle::new(by).line_join(LineJoin::Miter(std::f64::consts::FRAC_PI_6));
    let parts = ring_surface(ring).buffer_with_style(style);
    let rings = parts.0.iter().map(|part| {
        let corners: Ring =
            part.exterior().0.iter().map(|coord| on_grid(Point::new(coord.x, coord.y))).collect();
        without_straight_corners(&tidy(corners))
    });
    rings.filter(|ring| ring.len() > 2 && area(ring) > 0.0).collect()
}

/// The simple way: each corner moves to where its edges meet again. `None` where an edge would vanish.
fn mitred(ring: &Ring, by: f64) -> Option<Ring> {
    let count = ring.len();
    let mut corners = Vec::with_capacity(count);
    for index in 0..count {
        let before = Segment::new(ring[(index + count - 1) % count], ring[index]).direction();
        let after = Segment::new(ring[index], ring[(index + 1) % count]).direction();
        let (left, right) = (before.perp(), after.perp());
        let scale = 1.0 + left.dot(right);
        let shift = (left + right) * (-by / scale);
        if scale < 0.05 || shift.length() > MITRE_LIMIT * by.abs() {
            return None;
        }
        corners.push(on_grid(ring[index] + shift));
    }
    let keeps_direction =
        edges(ring).zip(edges(&corners)).all(|(old, new)| old.vector().dot(new.vector()) > 0.0);
    (keeps_direction && is_simple(&corners)).then(|| without_straight_corners(&corners))
}

/// A ring with holes as rings without: cut through the middle of each hole.
fn opened(ring: Ring, mut holes: Vec<Ring>, depth: u32) -> Vec<Ring> {
    let Some(hole) = holes.first() else { return vec![ring] };
    if depth > 24 {
        return vec![ring];
    }
    let extent = bounds(hole);
    let middle = extent.center();
    // The shorter cut: across the narrower part of the building.
    let axis = if extent.size().x > extent.size().y { Axis::X } else { Axis::Y };
    let at = super::ring::along(on_grid(middle), axis);
    let (below, above) = split(&ring, axis, at);
    let halves: Vec<(Vec<Ring>, Vec<Ring>)> = holes.drain(..).map(|hole| split(&hole, axis, at)).collect();
    let mut pieces = Vec::new();
    for (is_above, side) in [(false, below), (true, above)] {
        for piece in side {
            let (piece, whole) = without_halves(piece, &halves, is_above);
            pieces.extend(opened(piece, whole, depth + 1));
        }
    }
    pieces
}

/// A piece without the halves of the holes that were cut on its side, and the holes inside it that were not.
fn without_halves(mut piece: Ring, halves: &[(Vec<Ring>, Vec<Ring>)], is_above: bool) -> (Ring, Vec<Ring>) {
    let mut whole = Vec::new();
    for (low, high) in halves {
        let is_cut = !low.is_empty() && !high.is_empty();
        for half in if is_above { high } else { low } {
            let reversed: Ring = half.iter().rev().copied().collect();
            match join(&piece, &reversed).filter(|_| is_cut) {
                Some(rest) => piece = rest,
                None if !is_cut && ring_contains(&piece, super::disc::inner_point(half)) => {
                    whole.push(half.clone())
                }
                None => {}
            }
        }
    }
    (piece, whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Bounds;

    fn rectangle(x: f64, y: f64, width: f64, depth: f64) -> Ring {
        Bounds::new(Point::new(x, y), Point::new(x + width, y + depth)).corners().into()
    }

    #[test]
    fn a_piece_too_small_for_a_room_joins_the_floor_that_it_was_cut_from() {
        let pieces = vec![rectangle(0., 0., 12., 10.), rectangle(0., 10., 4.4, 0.7)];
        let kept = without_small_islands(pieces, LEAST_ISLAND.1);
        assert_eq!(kept.len(), 1);
        assert!((area(&kept[0]) - 123.08).abs() < 1e-9, "{}", area(&kept[0]));
    }

    #[test]
    fn of_pieces_that_stand_apart_the_smallest_are_no_floor() {
        let with = |depth: f64| {
            let pieces = vec![rectangle(0., 0., 20., 10.), rectangle(25., 0., 3., depth)];
            without_small_islands(pieces, LEAST_ISLAND.0).len()
        };
        assert_eq!((with(2.0), with(3.0)), (1, 2));
    }
}
