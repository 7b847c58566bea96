//! Houses too narrow for a hall with rooms beside it from end to end: the hall is in the middle or at one end, with stairs and small
//! rooms beside it, and the rooms at the ends are as wide as the house.
//!
//! ```text
//!   +-------+------+------+---------+     +----------+------+-----+-------+
//!   |kitchen|toilet|stairs|         |     |          | bath |stairs       |
//!   +-------+------+------+ living  |     | bedroom  +------+-----+  bed- |
//! ->|  hall              |  room   |     |          | landing    |  room |
//!   +--------------------+---------+     +----------+------------+-------+
//! ```
//!
//! Works, as [`super::spine`] does, in a frame whose x axis runs along the strip.

use crate::geometry::Point;

use super::dwelling::{FLUSH, Port};
use super::links::LEAST_BORDER;
use super::ring::{Axis, Ring, shared_length, split};
use super::spine::{Fixed, FixedKind, Ground, Row, extent, largest_of, settle};

/// Metres of the hall: a person with a box passes, and 3.4 m between the outer walls hold stairs beside it.
const HALL_WIDTH: f64 = 1.14;
/// Metres along the strip of stairs that are so many metres deep or deeper, or shallower.
const STAIR_LENGTHS: [(f64, f64); 2] = [(2.2, 2.1), (1.75, 3.2)];
/// Metres of the depth of stairs where small rooms lie at the other side of the hall, and of these rooms at least and at most.
const STAIR_DEPTH: f64 = 2.25;
/// See [`STAIR_DEPTH`].
const OTHER_SIDE: (f64, f64) = (1.1, 4.0);
/// Metres of the depth of rooms beside the strip at most: deeper ones are tubes with a window at one end.
const DEEPEST: f64 = 6.5;
/// Metres that the strip is longer than the stairs at its side: rooms beside them, or none.
const MORE: [f64; 6] = [0.0, 1.15, 1.8, 2.6, 3.6, 5.0];
/// Metres of a room at an end, at least.
const LEAST_END: f64 = 2.6;
/// Metres of such a room before the strip, where the other end is as long as it may be.
const FRONTS: [f64; 4] = [3.0, 3.7, 4.5, 5.6];
/// Metres of the shortest strip.
const SHORTEST: f64 = 1.3;
/// Metres of the half of a way in.
const PORT_HALF: f64 = 0.6;

/// Where a strip with rooms at its ends may lie.
#[derive(Clone, Debug)]
pub(super) struct Middle {
    /// From which height to which the strip lies.
    pub(super) heights: (f64, f64),
    /// From where to where along itself.
    pub(super) reach: (f64, f64),
    /// Where stairs may be beside it; none in a house without.
    pub(super) stairs: Vec<Fixed>,
}

/// The extent of a ground along the strip and across it.
#[derive(Clone, Copy)]
struct Extent {
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
}

impl Extent {
    fn of(ground: &Ground) -> Self {
        let ((left, right), (bottom, top)) = (extent(&ground.ring, Axis::X), extent(&ground.ring, Axis::Y));
        Self { left, right, bottom, top }
    }

    /// Whether the ends before and beyond a strip are rooms, or nothing.
    fn has_rooms_or_nothing_beyond(self, (from, to): (f64, f64)) -> bool {
        [from - self.left, self.right - to].into_iter().all(|end| !(FLUSH..LEAST_END).contains(&end))
    }

    /// Whether a way in leads into the strip or a room at its ends.
    fn leads_in(self, port: Port, heights: (f64, f64), (from, to): (f64, f64)) -> bool {
        let ends = (from - self.left >= LEAST_END, self.right - to >= LEAST_END);
        let Port { at, way } = port;
        if way.x.abs() > way.y.abs() {
            let has_end = if way.x > 0.0 { ends.0 } else { ends.1 };
            return has_end || (heights.0..=heights.1).contains(&at.y);
        }
        let is_at_strip = if way.y > 0.0 { heights.0 < self.bottom } else { heights.1 > self.top };
        (ends.0 && at.x + PORT_HALF < from)
            || (ends.1 && at.x - PORT_HALF > to)
            || (is_at_strip && at.x - PORT_HALF >= from && at.x + PORT_HALF <= to)
    }
}

/// The strips of a level that people come into; with stairs, if the house has any.
pub(super) fn middles(ground: &Ground, port: Port, has_stairs: bool) -> Vec<Middle> {
    let extent = Extent::of(ground);
    let Extent { left, right, .. } = extent;
    let mut found = Vec::new();
    for Across { heights, stairs } in ways_across(extent, has_stairs) {
        let length = stairs.map_or(0.0, |(_, length)| length);
        for more in MORE {
            let long = (length + more).max(SHORTEST);
            let mut starts = vec![left - FLUSH, right - long];
            starts.extend(FRONTS.iter().flat_map(|front| [left + front, right - front - long]));
            if port.way.y.abs() >= port.way.x.abs() {
                starts.extend(MORE.map(|before| port.at.x - PORT_HALF - before));
            }
            for from in starts {
                let to = from.max(left) + long;
                let reach = (from, if right - to < 0.3 { right + FLUSH } else { to });
                // Stairs lie beside the strip with their whole length, on each level.
                if to > right + FLUSH
                    || !extent.has_rooms_or_nothing_beyond(reach)
                    || !extent.leads_in(port, heights, reach)
                {
                    continue;
                }
                let at = |(is_above, length): (bool, f64), from: f64| Fixed {
                    is_above,
                    from,
                    to: from + length,
                    kind: FixedKind::Room(0),
                };
                let mut places: Vec<Fixed> =
                    stairs.into_iter().map(|stairs| at(stairs, from.max(left))).collect();
                if more > 0.0 {
                    places.extend(stairs.map(|stairs| at(stairs, to.min(right) - stairs.1)));
                }
                found.push(Middle { heights, reach, stairs: places });
            }
        }
    }
    found
}

/// Where a strip may lie across the ground.
#[derive(Clone, Copy)]
struct Across {
    heights: (f64, f64),
    /// Whether stairs are above the strip, and their metres along it.
    stairs: Option<(bool, f64)>,
}

/// At the edges of the ground; or where stairs are as deep as they must be, with other rooms at the other side.
fn ways_across(Extent { bottom, top, .. }: Extent, has_stairs: bool) -> Vec<Across> {
    let edges = [(bottom - FLUSH, bottom + HALL_WIDTH), (top - HALL_WIDTH, top + FLUSH)];
    let rest = top - bottom - HALL_WIDTH;
    if rest > DEEPEST {
        return Vec::new();
    }
    if !has_stairs {
        return edges.map(|heights| Across { heights, stairs: None }).into();
    }
    let length = STAIR_LENGTHS.iter().find(|(least, _)| rest >= *least).map(|(_, length)| *length);
    let Some(length) = length else { return Vec::new() };
    let mut found: Vec<Across> = edges
        .into_iter()
        .zip([true, false])
        .map(|(heights, is_above)| Across { heights, stairs: Some((is_above, length)) })
        .collect();
    if (OTHER_SIDE.0..=OTHER_SIDE.1).contains(&(rest - STAIR_DEPTH)) {
        let (above, below) = (top - STAIR_DEPTH, bottom + STAIR_DEPTH);
        found.push(Across { heights: (above - HALL_WIDTH, above), stairs: Some((true, length)) });
        found.push(Across { heights: (below, below + HALL_WIDTH), stairs: Some((false, length)) });
    }
    found
}

/// The strips of a level above one, beside the same stairs.
pub(super) fn alike(ground: &Ground, heights: (f64, f64), stairs: Fixed) -> Vec<Middle> {
    let extent = Extent::of(ground);
    let Extent { left, right, .. } = extent;
    // Not the longest of them: above, no kitchen lies beside the hall.
    let starts = MORE.iter().take(5).map(|more| stairs.from - more).chain([left - FLUSH]);
    let stops: Vec<f64> = MORE.iter().take(5).map(|more| stairs.to + more).chain([right + FLUSH]).collect();
    let reaches = starts.flat_map(|from| stops.iter().map(move |&to| (from, to)));
    let may_be = |reach: &(f64, f64)| extent.has_rooms_or_nothing_beyond(*reach);
    reaches.filter(may_be).map(|reach| Middle { heights, reach, stairs: vec![stairs] }).collect()
}

/// What lies before a strip, along it and beyond it.
pub(super) struct Parts {
    /// The ground along the strip.
    pub(super) middle: Ground,
    /// What lies before it and beyond it.
    ends: [Option<Ring>; 2],
}

impl Parts {
    /// `None` where one of them is no single piece.
    pub(super) fn cut(ground: &Ground, (from, to): (f64, f64)) -> Option<Self> {
        let (before, rest) = split(&ground.ring, Axis::X, from);
        let (mut middles, mut beyonds) = (Vec::new(), Vec::new());
        for ring in rest {
            let (middle, beyond) = split(&ring, Axis::X, to);
            middles.extend(middle);
            beyonds.extend(beyond);
        }
        let mut crumbs = Vec::new();
        let mut largest = |pieces: Vec<Ring>| {
            let (first, others) = largest_of(pieces)?;
            crumbs.extend(others);
            Some(first)
        };
        let (before, middle, beyond) = (largest(before), largest(middles)?, largest(beyonds));
        let has_ends = [before.is_some(), beyond.is_some()];
        let mut rings: Vec<Ring> = [Some(middle), before, beyond].into_iter().flatten().collect();
        if !settle(crumbs, &mut rings, |_| 1.0).is_empty() {
            return None;
        }
        let mut rings = rings.into_iter();
        let middle = ground.part(rings.next()?);
        let ends = has_ends.map(|is_there| if is_there { rings.next() } else { None });
        Some(Self { middle, ends })
    }

    /// The rows at the ends of a strip; `None` where one does not border on it.
    pub(super) fn rows(&self, strip: &[Point], ground: &Ground) -> Option<Vec<Row>> {
        let mut rows = Vec::new();
        for (ring, is_before) in self.ends.iter().zip([true, false]) {
            let Some(ring) = ring else { continue };
            let border = shared_length(ring, strip);
            if border < LEAST_BORDER {
                return None;
            }
            let (from, to) = extent(ring, Axis::X);
            // A door to the strip is one of the slice that is nearest to it.
            let contact = if is_before { (to - border, to) } else { (from, from + border) };
            rows.push(Row::at_end(ring.clone(), ground, contact));
        }
        Some(rows)
    }
}
