//! Wings of a storey: pieces that a straight corridor serves, and how their corridors meet.

use crate::geometry::{Point, Segment};

use super::deep::Piece;
use super::dwelling::Port;
use super::ring::{Axis, Ring, along, area, bounds, inner_corners, longest, shared, total_length};
use super::spine::in_two;

/// Wings below this many square metres are not cut off.
const LEAST_WING: f64 = 45.0;
/// Wings narrower than this many metres are not cut off.
const NARROWEST_WING: f64 = 4.5;
/// Metres of border over which corridors meet.
const MEETING: f64 = 2.0;
/// Wings of a storey at most.
const MOST_WINGS: usize = 40;
/// Metres of border for each place where two corridors meet that run along it.
const MEETING_EVERY: f64 = 15.0;

/// A wing with a corridor along its longer axis.
#[derive(Clone, Debug)]
pub(super) struct Wing {
    /// Its outline.
    pub(super) ring: Ring,
    /// The axis of its corridor.
    pub(super) axis: Axis,
    /// Where the middle of its corridor is, across the axis.
    pub(super) middle: f64,
    /// Where its corridor meets others; the first is where that of its parent does, if it has one.
    pub(super) ports: Vec<Port>,
    /// Further places where it meets the same others: those beside which it runs, all along.
    pub(super) passages: Vec<Port>,
    /// Where it meets its parent: the first port and those of its passages.
    pub(super) joined: Vec<Point>,
    /// The number of the wing that it is joined to; the root has none.
    pub(super) parent: Option<usize>,
}

/// Cuts a ring at its inner corners until all pieces are compact; where there is no such corner, `with_halves` cuts large pieces
/// that are not in halves across their longer axis: triangles and slanted legs have a corridor in a part of them.
pub(super) fn compact(ring: Ring, with_halves: bool, found: &mut Vec<Ring>) {
    let fill = area(&ring) / (bounds(&ring).size().x * bounds(&ring).size().y);
    if fill > 0.93 || area(&ring) < 2.0 * LEAST_WING || found.len() >= MOST_WINGS {
        return found.push(ring);
    }
    let mut best: Option<(f64, Ring, Ring)> = None;
    let corners: Vec<Point> = inner_corners(&ring).take(24).collect();
    for corner in corners {
        for axis in [Axis::X, Axis::Y] {
            let Some((first, second)) = in_two(&ring, axis, along(corner, axis)) else { continue };
            if !is_wing(&first) || !is_wing(&second) {
                continue;
            }
            let chord: f64 = total_length(&shared(&first, &second));
            if best.as_ref().is_none_or(|(known, ..)| chord < *known - 1e-9) {
                best = Some((chord, first, second));
            }
        }
    }
    let halves = || {
        let axis = longer_axis(&ring);
        in_two(&ring, axis, along(bounds(&ring).center(), axis))
            .filter(|(first, second)| with_halves && [first, second].into_iter().all(is_wing))
    };
    match best.map(|(_, first, second)| (first, second)).or_else(halves) {
        Some((first, second)) => {
            compact(first, with_halves, found);
            compact(second, with_halves, found);
        }
        None => found.push(ring),
    }
}

/// Whether a piece is a wing of its own.
fn is_wing(ring: &Ring) -> bool {
    area(ring) >= LEAST_WING && bounds(ring).size().min_element() >= NARROWEST_WING
}

/// Wings whose corridors form a tree: the first is the root, and each other comes with the number of the one it is joined to.
/// `None` where a wing borders on no other.
pub(super) fn tree(pieces: Vec<Piece>, entrance: Option<Point>) -> Option<Vec<Wing>> {
    let mut open = pieces;
    let worth = |Piece { ring, is_outer }: &Piece| {
        let near =
            entrance.is_some_and(|at| bounds(ring).gap(crate::geometry::Bounds::around_point(at, 0.1)) < 0.8);
        // Stairs take no light in a core.
        let share = if *is_outer { 0.0 } else { 1.0 };
        area(ring) * share * if near { 3.0 } else { 1.0 }
    };
    open.sort_by(|a, b| worth(b).total_cmp(&worth(a)));
    let mut wings = vec![wing(open.remove(0).ring)];
    while !open.is_empty() {
        let joined = wings.iter().enumerate().find_map(|(parent, wing)| {
            let meets =
                |(child, piece): (usize, &Piece)| Some((parent, child, meeting(&wing.ring, &piece.ring)?));
            open.iter().enumerate().find_map(meets)
        });
        let (parent, child, border) = joined?;
        let mut child = Wing { parent: Some(parent), ..wing(open.remove(child).ring) };
        join_wings(&mut wings[parent], &mut child, border);
        wings.push(child);
    }
    Some(wings)
}

/// Joins the corridors of two wings: at one place, and in passages where both run along their border.
fn join_wings(parent: &mut Wing, child: &mut Wing, border: Segment) {
    let at = meet(parent, child, border);
    let runs_along = if border.vector().x.abs() > border.vector().y.abs() { Axis::X } else { Axis::Y };
    let are_parallel = parent.axis == runs_along && child.axis == runs_along;
    let count = if are_parallel { (border.length() / MEETING_EVERY).ceil().max(1.0) as usize } else { 1 };
    // Each in the middle of its share of the border.
    let places = (0..count).map(|place| border.at((place as f64 + 0.5) / count as f64));
    let mut places: Vec<Point> = if count == 1 { vec![at] } else { places.collect() };
    let first = places.swap_remove(count / 2);
    child.joined = std::iter::once(first).chain(places.iter().copied()).collect();
    // The border has the parent on its left: its normal leads into the parent.
    for (wing, way) in [(parent, border.normal()), (child, -border.normal())] {
        wing.ports.push(Port { at: first, way });
        wing.passages.extend(places.iter().map(|&at| Port { at, way }));
    }
}

fn wing(ring: Ring) -> Wing {
    let axis = longer_axis(&ring);
    let middle = along(bounds(&ring).center(), across(axis));
    Wing {
        ring,
        axis,
        middle: (middle * 1000.0).round() / 1000.0,
        ports: Vec::new(),
        passages: Vec::new(),
        joined: Vec::new(),
        parent: None,
    }
}

/// The axis along which a ring is longer.
pub(super) fn longer_axis(ring: &Ring) -> Axis {
    let size = bounds(ring).size();
    if size.x >= size.y { Axis::X } else { Axis::Y }
}

pub(super) fn across(axis: Axis) -> Axis {
    if axis == Axis::X { Axis::Y } else { Axis::X }
}

fn meeting(parent: &Ring, child: &Ring) -> Option<Segment> {
    let longest = longest(shared(parent, child))?;
    (longest.length() >= MEETING).then_some(longest)
}

/// Where the corridors of two wings meet on their border: at the end of one that arrives there, else at its middle.
fn meet(parent: &Wing, child: &mut Wing, border: Segment) -> Point {
    let runs_along = if border.vector().x.abs() > border.vector().y.abs() { Axis::X } else { Axis::Y };
    let (from, to) = (along(border.start, runs_along), along(border.end, runs_along));
    let (low, high) = (from.min(to), from.max(to));
    let margin = 1.2f64.min((high - low) / 2.0);
    let place = if parent.axis != runs_along {
        parent.middle
    } else if child.axis != runs_along {
        child.middle
    } else {
        0.5 * (low + high)
    }
    // Not `clamp`: the two ends may be one place but for rounding.
    .max(low + margin)
    .min(high - margin);
    if child.axis != runs_along {
        child.middle = place;
    }
    let share = (place - from) / (to - from);
    border.at(share)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(corners: &[(f64, f64)], with_halves: bool) -> Vec<f64> {
        let mut found = Vec::new();
        compact(corners.iter().copied().map(Point::from).collect(), with_halves, &mut found);
        found.iter().map(|ring| area(ring)).collect()
    }

    #[test]
    fn legs_are_parted_though_an_edge_is_not_quite_parallel_to_the_axes() {
        let leg = |slant: f64| {
            [(0.0, 0.0), (12.0, 0.0), (12.0, 12.0), (30.0, 12.0 - slant), (30.0, 24.0), (0.0, 24.0)]
        };
        assert_eq!(pieces(&leg(0.0), false).len(), 2);
        let slanted = pieces(&leg(0.04), false);
        assert_eq!(slanted.len(), 2, "{slanted:?}");
        assert!((slanted.iter().sum::<f64>() - area(&leg(0.04).map(Point::from))).abs() < 0.01);
    }

    #[test]
    fn a_triangle_is_halved_where_that_is_asked_for() {
        let triangle = [(0.0, 0.0), (30.0, 0.0), (0.0, 24.0)];
        assert_eq!(pieces(&triangle, false).len(), 1);
        let halves = pieces(&triangle, true);
        assert!(halves.len() > 1 && halves.iter().all(|&area| area >= LEAST_WING), "{halves:?}");
        assert!((halves.iter().sum::<f64>() - 360.0).abs() < 0.1);
    }
}
