//! Pieces of a storey too deep for one corridor: the rooms at both long sides have corridors of their own, and between these is a
//! core of stairs, stores and whatever else needs no window.
//!
//! ```text
//!   +-----+-----+-----+-----+
//!   |     |     |     |     |   a lit row
//!   +-----+-----+-----+-----+
//!   |       corridor        |   ... and its corridor: an outer strip
//!   +----+--+-----+--+------+
//!   |    |p |     |p |      |   the core; p: passages (`wings.rs`)
//!   +----+--+-----+--+------+
//!   |       corridor        |
//!   +-----+-----+-----+-----+
//!   |     |     |     |     |
//!   +-----+-----+-----+-----+
//! ```

use super::ring::{Axis, Ring, along, area, bounds};
use super::spine::{Ground, in_two};
use super::wings::{across, longer_axis};

/// Metres of depth of a row at an outer wall: as deep as daylight serves a room with usual windows, two and a half times their height.
const LIT_ROW: f64 = 6.8;
/// Metres of depth of the least core: of stairs.
const LEAST_CORE: f64 = 4.3;
/// Metres of depth of each of two rows of a core with a corridor between them; a shallower core lies at one of the outer corridors.
const CORE_ROW: f64 = 4.6;
/// Metres of depth of such a row at most, before there are more corridors in the core.
const DEEPEST_CORE_ROW: f64 = 9.0;
/// Share of a long side that is lit at least, for a row there.
pub(super) const LIT_SIDE: f64 = 0.5;

/// A piece of a storey that is planned along one corridor.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Its outline.
    pub(super) ring: Ring,
    /// Whether it is a lit row with its corridor beside a core.
    pub(super) is_outer: bool,
}

impl Piece {
    fn whole(ring: Ring) -> Self {
        Self { ring, is_outer: false }
    }
}

/// A piece in one, or its outer strips and its core, where corridors of some metres leave enough for that. There is a strip at each
/// long side with light.
pub(super) fn outer_strips(whole: &Ground, ring: Ring, width: f64) -> Vec<Piece> {
    let axis = longer_axis(&ring);
    let extent = bounds(&ring);
    let sides = [extent.low, extent.high].map(|corner| along(corner, across(axis)));
    let depth = area(&ring) / along(extent.size(), axis);
    let is_lit = are_lit(whole, &ring, axis);
    let strip = LIT_ROW + width;
    let with_two_rows = width + 2.0 * CORE_ROW;
    // How many of the strips are cut off: the core, with its corridor, keeps the other where it is too shallow for rows of its own.
    let cut = match is_lit {
        [true, true] if depth >= 2.0 * strip + with_two_rows => [true, true],
        [true, true] if depth >= 2.0 * strip + LEAST_CORE => [true, false],
        [true, false] | [false, true] if depth >= strip + with_two_rows => is_lit,
        _ => return vec![Piece::whole(ring)],
    };
    let mut core = ring;
    let mut outer = Vec::new();
    for (side, inwards) in [(0, strip), (1, -strip)].into_iter().filter(|(side, _)| cut[*side]) {
        if let Some((below, above)) = in_two(&core, across(axis), sides[side] + inwards) {
            let (own, rest) = if side == 0 { (below, above) } else { (above, below) };
            outer.push(Piece { ring: own, is_outer: true });
            core = rest;
        }
    }
    let cores = in_slices(core, across(axis), width + 2.0 * DEEPEST_CORE_ROW);
    cores.into_iter().map(Piece::whole).chain(outer).collect()
}

/// A ring in slices of equal depth, of so many metres at most; fewer where a slice would not be one piece.
fn in_slices(ring: Ring, axis: Axis, most: f64) -> Vec<Ring> {
    let (low, depth) = (along(bounds(&ring).low, axis), along(bounds(&ring).size(), axis));
    let count = (depth / most).ceil().max(1.0);
    let mut rest = ring;
    let mut slices = Vec::new();
    for number in 1..count as u32 {
        if let Some((below, above)) = in_two(&rest, axis, low + depth * f64::from(number) / count) {
            slices.push(below);
            rest = above;
        }
    }
    slices.push(rest);
    slices
}

/// Whether the long sides have light, the lower one first.
fn are_lit(whole: &Ground, ring: &Ring, axis: Axis) -> [bool; 2] {
    let extent = bounds(ring);
    let metres = light_beside(&whole.part(ring.clone()), axis, along(extent.center(), across(axis)));
    metres.map(|metres| metres >= LIT_SIDE * along(extent.size(), axis))
}

/// Metres of outer wall with light below and above a line along an axis.
pub(super) fn light_beside(ground: &Ground, axis: Axis, line: f64) -> [f64; 2] {
    let mut metres = [0.0; 2];
    for piece in ground.light(&ground.ring) {
        if along(piece.direction(), axis).abs() > 0.7 {
            metres[usize::from(along(piece.middle(), across(axis)) > line)] += piece.length();
        }
    }
    metres
}
