//! Finds how deep a wall may be: its body ends halfway to the room behind it.
//!
//! Everything is in the frame of a wall: `x` along its inner face from its start, `y` away from its room.
//!
//! ```text
//!        fan  |       strip        | fan          y
//!         \ | |  |  |  |  |  |  |  | | /          ^
//!          \| |  |  |  |  |  |  |  | |/           |
//!           +-------inner face-------+            +--> x
//! ```
//!
//! Rays go out from the inner face, and in a fan round each corner that the outer face reaches past. Between two corners of
//! the rooms behind, the same border is the first that the rays meet, so that its ends tell the rest.

mod limits;
mod profile;

use limits::{Limits, Line, Sector, enters};
use profile::{RAMP, STRAIGHT, Step, join, without_jumps};

use super::storey::{Border, Storey};
use crate::geometry::{Bounds, Point};
use crate::plan::Wall;

/// A point of a wall's outer face, and the place on its inner face that it stands behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Behind {
    /// Metres along the inner face.
    pub inner: f64,
    /// Metres along the inner face and behind it.
    pub outer: Point,
}

/// A wall's body as its corners alone would have it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quad {
    /// Length of the inner face.
    pub length: f64,
    /// Where the outer face begins and ends along the wall.
    pub outer: [f64; 2],
    /// From inner to outer face.
    pub thickness: f64,
}

/// Metres before a border or behind an inner face that are none: rounding.
const TOUCHING: f64 = 1e-5;
/// Metres by which a body may be deeper than half of the way to the room behind: walls that are drawn as thick as that.
const SLACK: f64 = 5e-4;

/// The outer face of a wall from its start to its end, never farther than halfway to a room behind it; none where the
/// corners alone limit it.
pub(super) fn clipped(storey: &Storey<'_>, wall: &Wall, quad: Quad) -> Option<Vec<Behind>> {
    let neighbourhood = Neighbourhood::behind(storey, wall, quad);
    let sectors = quad.sectors();
    if !sectors.iter().any(|sector| neighbourhood.limits(sector)) {
        return None;
    }
    let mut profiles = sectors.map(|sector| neighbourhood.profile(&sector));
    join(&mut profiles);
    let points = sectors.iter().zip(&profiles).flat_map(|(sector, profile)| {
        profile.iter().map(|&[at, depth]| Behind { inner: sector.inner(at), outer: sector.point(at, depth) })
    });
    Some(mitred(straightened(points.collect())))
}

/// The same face where its ends lean over the inner face: a mitre is the end of the wall, no part of its outer face.
/// Beside a hollow it stays one: the wall is built in pieces without hollows.
fn mitred(mut back: Vec<Behind>) -> Vec<Behind> {
    if let [first, second, third, ..] = &mut back[..]
        && first.outer.y < STRAIGHT
        && is_bulge([first, second, third])
    {
        second.inner = first.inner;
        back.remove(0);
    }
    if let [.., third, second, last] = &mut back[..]
        && last.outer.y < STRAIGHT
        && is_bulge([third, second, last])
    {
        second.inner = last.inner;
        back.pop();
    }
    back
}

/// Whether an outer face bends towards the inner one at the second of three points.
fn is_bulge([one, two, three]: [&Behind; 3]) -> bool {
    (two.outer - one.outer).perp_dot(three.outer - two.outer) < 0.0
}

/// The least depth of a wall between two places along it: at most `thickness`.
pub(super) fn least_depth(storey: &Storey<'_>, wall: &Wall, stretch: [f64; 2], thickness: f64) -> f64 {
    let quad = Quad { length: wall.length(), outer: stretch, thickness };
    let neighbourhood = Neighbourhood::behind(storey, wall, quad);
    let sector = Sector { corner: None, from: stretch[0], to: stretch[1], thickness };
    neighbourhood.profile(&sector).iter().map(|&[_, depth]| depth).fold(thickness, f64::min)
}

impl Quad {
    fn sectors(&self) -> [Sector; 3] {
        let Self { length, outer: [from, to], thickness } = *self;
        let fan = |corner: f64, from: f64, to: f64| Sector { corner: Some(corner), from, to, thickness };
        [
            fan(0.0, from.min(0.0), 0.0),
            Sector { corner: None, from: 0.0, to: length, thickness },
            fan(length, length, to.max(length)),
        ]
    }

    /// The ends of the body where they lean over the inner face.
    fn mitres(&self) -> impl Iterator<Item = Line> {
        let Self { length, outer: [from, to], thickness } = *self;
        let line = |foot: f64, top: f64| Line {
            ends: [Point::new(foot, 0.0), Point::new(top, thickness)],
            share: 1.0,
        };
        let start = (from > TOUCHING).then(|| line(0.0, from));
        start.into_iter().chain((to < length - TOUCHING).then(|| line(length, to)))
    }
}

/// The room or open air behind a wall.
struct Neighbourhood<'s, 'l> {
    storey: &'s Storey<'l>,
    wall: &'s Wall,
    /// Borders through which a ray may enter a room or doorway.
    rooms: Vec<Line>,
    /// Indices of the rooms nearby.
    near: Vec<usize>,
    mitres: Vec<Line>,
}

impl<'s, 'l> Neighbourhood<'s, 'l> {
    fn behind(storey: &'s Storey<'l>, wall: &'s Wall, quad: Quad) -> Self {
        let (along, outward) = (wall.direction(), -wall.normal());
        let local =
            |point: Point| Point::new((point - wall.start).dot(along), (point - wall.start).dot(outward));
        let reach = 2.0 * quad.thickness;
        let (from, to) = (quad.outer[0].min(0.0), quad.outer[1].max(quad.length));
        // A ray of a fan goes twice as far along the wall at twice the depth.
        let (from, to) = (2.0 * from, quad.length + 2.0 * (to - quad.length));
        let corners = [(from, 0.0), (to, 0.0), (from, reach), (to, reach)];
        let corners = corners.map(|(x, y)| wall.start + along * x + outward * y);
        let borders = storey.borders_near(Bounds::around(corners));
        let line = |border: &Border| {
            // Halfway to a room, where its own wall begins, and up to a doorway. Flat rays of a fan go far in little depth.
            let (share, slack) = if border.room.is_some() { (0.5, SLACK) } else { (1.0, 0.0) };
            let line = Line { ends: [local(border.start), local(border.end)], share };
            line.between(TOUCHING, (quad.thickness - slack) / share)
        };
        let rooms = borders.iter().filter_map(line).collect();
        let mut near: Vec<usize> = borders.iter().filter_map(|border| border.room).collect();
        near.dedup();
        let mitres = quad.mitres().filter_map(|line| line.between(0.0, reach)).collect();
        Self { storey, wall, rooms, near, mitres }
    }

    /// Whether a room ends the rays of a sector before the wall's own thickness does.
    fn limits(&self, sector: &Sector) -> bool {
        let is_wide = sector.to - sector.from > RAMP;
        let is_met = |line: &Line| {
            let [low, high] = line.rays(sector);
            // A border along the rays, as the sides of a doorway in the wall itself, is beside them.
            high - low > TOUCHING && low < sector.to - TOUCHING && high > sector.from + TOUCHING
        };
        // A border that begins at the corner of a fan lies along one ray: those on one side of it begin in its room.
        let begins_inside = |ends: [f64; 2]| {
            ends[1] - ends[0] > RAMP && self.is_inside(sector, f64::midpoint(ends[0], ends[1]))
        };
        is_wide
            && (self.rooms.iter().any(is_met)
                || stretches(sector, self.rooms.iter()).into_iter().any(begins_inside))
    }

    /// Depth by ray, as corners of a line that goes on without a step.
    fn profile(&self, sector: &Sector) -> Vec<[f64; 2]> {
        let stretches = stretches(sector, self.rooms.iter().chain(&self.mitres));
        let steps: Vec<Step> = stretches.into_iter().flat_map(|ends| self.steps(sector, ends)).collect();
        without_jumps(&steps, sector)
    }

    /// The depths along a stretch in which rays meet the same borders: two steps where another border is the nearest at
    /// its end than at its start.
    fn steps(&self, sector: &Sector, ends: [f64; 2]) -> Vec<Step> {
        let limits = self.limits_at(sector, f64::midpoint(ends[0], ends[1]));
        let step = |ends: [f64; 2]| Step { ends, depths: ends.map(|at| limits.depth(sector, at)) };
        let whole = step(ends);
        let [from, to] = ends;
        let crossings = limits.crossings(sector, ends);
        let deepest = crossings.into_iter().filter(|at| from + TOUCHING < *at && *at < to - TOUCHING).max_by(
            |one, two| {
                let above = |at: f64| limits.depth(sector, at) - whole.at(at);
                above(*one).total_cmp(&above(*two))
            },
        );
        deepest.map_or_else(|| vec![whole], |at| vec![step([from, at]), step([at, to])])
    }

    /// The limits of the rays beside one of them.
    fn limits_at(&self, sector: &Sector, at: f64) -> Limits<'_> {
        let is_met = |line: &&Line| {
            let [low, high] = line.rays(sector);
            low < at && at < high
        };
        let rooms = self.rooms.iter().filter(is_met).filter(|line| enters(line, sector, at));
        Limits {
            rooms: rooms.collect(),
            mitres: self.mitres.iter().filter(is_met).collect(),
            is_inside: self.is_inside(sector, at),
        }
    }

    /// Whether a ray begins in another room, as where rooms overlap.
    fn is_inside(&self, sector: &Sector, at: f64) -> bool {
        let point = sector.point(at, 2.0 * TOUCHING);
        let place = self.wall.after(point.x) - self.wall.normal() * point.y;
        self.near.iter().any(|&room| {
            let region = &self.storey.level.rooms[room].region;
            region.outline.bounds().contains(place) && region.contains(place)
        })
    }
}

/// The stretches of a sector between the rays through the ends of some lines.
fn stretches<'l>(sector: &Sector, lines: impl Iterator<Item = &'l Line>) -> Vec<[f64; 2]> {
    let mut events = vec![sector.from, sector.to];
    events.extend(lines.flat_map(|line| line.rays(sector)));
    events.retain(|at| (sector.from..=sector.to).contains(at));
    events.sort_by(f64::total_cmp);
    events.dedup_by(|later, earlier| *later - *earlier < TOUCHING);
    events.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Without points in the middle of straight lines, on which outer and inner place go on alike.
fn straightened(points: Vec<Behind>) -> Vec<Behind> {
    let mut kept: Vec<Behind> = Vec::with_capacity(points.len());
    for point in points {
        while let [.., one, two] = kept[..]
            && is_between(&one, &two, &point)
        {
            kept.pop();
        }
        kept.push(point);
    }
    kept.dedup();
    kept
}

fn is_between(one: &Behind, two: &Behind, three: &Behind) -> bool {
    let whole = three.outer - one.outer;
    let (length, share) = (whole.length(), (two.outer - one.outer).dot(whole) / whole.length_squared());
    let is_alike = one.inner == three.inner || (one.inner < two.inner && two.inner < three.inner);
    let inner = one.inner + (three.inner - one.inner) * share;
    length > STRAIGHT
        && is_alike
        && (0.0..=1.0).contains(&share)
        && whole.perp_dot(two.outer - one.outer).abs() < STRAIGHT * length
        && (inner - two.inner).abs() < STRAIGHT
}

#[cfg(test)]
mod tests;
