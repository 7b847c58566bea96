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

use super::storey::{Border, Storey};
use super::thickness::THIN_SHEET;
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
/// Metres along the wall in which its depth changes where a room behind begins or ends: its side does not lie in the plane
/// of that room's own wall.
const RAMP: f64 = 1e-3;
/// Metres by which a point may lie off a line and count as one of it.
const STRAIGHT: f64 = 5e-5;

/// The outer face of a wall from its start to its end, never farther than halfway to a room behind it; none where the
/// corners alone limit it.
pub(super) fn clipped(storey: &Storey<'_>, wall: &Wall, quad: Quad) -> Option<Vec<Behind>> {
    let ground = Ground::behind(storey, wall, quad);
    let sectors = quad.sectors();
    if !sectors.iter().any(|sector| ground.limits(sector)) {
        return None;
    }
    let mut profiles = sectors.map(|sector| ground.profile(&sector));
    join(&mut profiles);
    let points = sectors.iter().zip(&profiles).flat_map(|(sector, profile)| {
        profile.iter().map(|&[at, depth]| Behind { inner: sector.inner(at), outer: sector.point(at, depth) })
    });
    Some(mitred(straightened(points.collect())))
}

/// The same face where its ends lean over the inner face: a mitre is the end of the wall, no part of its outer face.
fn mitred(mut back: Vec<Behind>) -> Vec<Behind> {
    if let [first, second, _, ..] = &mut back[..]
        && first.outer.y < STRAIGHT
    {
        second.inner = first.inner;
        back.remove(0);
    }
    if let [.., _, second, last] = &mut back[..]
        && last.outer.y < STRAIGHT
    {
        second.inner = last.inner;
        back.pop();
    }
    back
}

/// The least depth of a wall between two places along it: at most `thickness`.
pub(super) fn least_depth(storey: &Storey<'_>, wall: &Wall, stretch: [f64; 2], thickness: f64) -> f64 {
    let quad = Quad { length: wall.length(), outer: stretch, thickness };
    let ground = Ground::behind(storey, wall, quad);
    let sector = Sector { corner: None, from: stretch[0], to: stretch[1], thickness };
    ground.profile(&sector).iter().map(|&[_, depth]| depth).fold(thickness, f64::min)
}

/// A family of rays: parallel ones, or those through a corner.
#[derive(Clone, Copy, Debug)]
struct Sector {
    /// The corner, along the wall.
    corner: Option<f64>,
    /// Where the first and the last ray are at the depth of the wall's thickness.
    from: f64,
    to: f64,
    thickness: f64,
}

impl Sector {
    /// The place on the inner face where a ray begins.
    fn inner(&self, at: f64) -> f64 {
        self.corner.unwrap_or(at)
    }

    /// Metres along the wall for each metre behind it.
    fn slope(&self, at: f64) -> f64 {
        self.corner.map_or(0.0, |corner| (at - corner) / self.thickness)
    }

    fn point(&self, at: f64, depth: f64) -> Point {
        Point::new(self.inner(at) + self.slope(at) * depth, depth)
    }

    /// The ray through a point behind the wall.
    fn ray_of(&self, point: Point) -> f64 {
        self.corner.map_or(point.x, |corner| corner + (point.x - corner) * self.thickness / point.y)
    }
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

/// A line that limits the depth: to a share of the way to it.
#[derive(Clone, Copy, Debug)]
struct Line {
    ends: [Point; 2],
    share: f64,
}

impl Line {
    /// The part between two depths.
    fn between(&self, low: f64, high: f64) -> Option<Self> {
        let [a, b] = self.ends;
        let at = |depth: f64| a + (b - a) * ((depth - a.y) / (b.y - a.y));
        let cut = |end: Point| {
            if end.y < low {
                at(low)
            } else if end.y > high {
                at(high)
            } else {
                end
            }
        };
        let is_between = a.y.max(b.y) > low && a.y.min(b.y) < high;
        is_between.then(|| Self { ends: [cut(a), cut(b)], ..*self })
    }

    /// The depth that it leaves to a ray, on the line as if it had no ends.
    fn depth_at(&self, sector: &Sector, at: f64) -> f64 {
        let [a, b] = self.ends;
        let along = b - a;
        let ray = Point::new(sector.slope(at), 1.0);
        let across = ray.perp_dot(along);
        let foot = Point::new(sector.inner(at), 0.0);
        if across.abs() < f64::EPSILON {
            0.0
        } else {
            ((a - foot).perp_dot(along) / across).max(0.0) * self.share
        }
    }

    fn rays(&self, sector: &Sector) -> [f64; 2] {
        let [one, two] = self.ends.map(|end| sector.ray_of(end));
        [one.min(two), one.max(two)]
    }
}

/// What lies behind a wall.
struct Ground<'s, 'l> {
    storey: &'s Storey<'l>,
    wall: &'s Wall,
    /// Borders through which a ray may enter a room or doorway.
    rooms: Vec<Line>,
    /// Indices of the rooms nearby.
    near: Vec<usize>,
    mitres: Vec<Line>,
}

impl<'s, 'l> Ground<'s, 'l> {
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
            // Halfway to a room, where its own wall begins, and up to a doorway.
            let share = if border.room.is_some() { 0.5 } else { 1.0 };
            let line = Line { ends: [local(border.start), local(border.end)], share };
            line.between(TOUCHING, (quad.thickness - SLACK) / share)
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
        is_wide
            && (self.rooms.iter().any(is_met)
                || self.is_inside(sector, f64::midpoint(sector.from, sector.to)))
    }

    /// Depth by ray, as corners of a line that goes on without a step.
    fn profile(&self, sector: &Sector) -> Vec<[f64; 2]> {
        let mut events = vec![sector.from, sector.to];
        let lines = self.rooms.iter().chain(&self.mitres);
        events.extend(lines.flat_map(|line| line.rays(sector)));
        events.retain(|at| (sector.from..=sector.to).contains(at));
        events.sort_by(f64::total_cmp);
        events.dedup_by(|later, earlier| *later - *earlier < TOUCHING);
        let steps: Vec<Step> = events.windows(2).map(|pair| self.step(sector, [pair[0], pair[1]])).collect();
        without_jumps(&steps, sector)
    }

    /// The depths at both ends of a stretch in which rays meet the same borders.
    fn step(&self, sector: &Sector, ends: [f64; 2]) -> Step {
        let middle = f64::midpoint(ends[0], ends[1]);
        let is_met = |line: &&Line| {
            let [low, high] = line.rays(sector);
            low < middle && middle < high
        };
        let rooms: Vec<&Line> =
            self.rooms.iter().filter(is_met).filter(|line| enters(line, sector, middle)).collect();
        let mitres: Vec<&Line> = self.mitres.iter().filter(is_met).collect();
        let is_inside = self.is_inside(sector, middle);
        let least = |lines: &[&Line], at: f64| {
            lines.iter().map(|line| line.depth_at(sector, at)).fold(sector.thickness, f64::min)
        };
        let depths = ends.map(|at| {
            let free = if is_inside { 0.0 } else { least(&rooms, at) };
            // Where two rooms touch, there still is a wall: so long a piece of each ray.
            let sheet = THIN_SHEET / (1.0 + sector.slope(at).abs());
            least(&mitres, at).min(free.max(sheet))
        });
        Step { ends, depths }
    }

    /// Whether a ray begins in another room, as where rooms overlap.
    fn is_inside(&self, sector: &Sector, at: f64) -> bool {
        let point = sector.point(at, 2.0 * TOUCHING);
        let place = self.wall.start + self.wall.direction() * point.x - self.wall.normal() * point.y;
        self.near.iter().any(|&room| {
            let region = &self.storey.level.rooms[room].region;
            region.outline.bounds().contains(place) && region.contains(place)
        })
    }
}

/// Whether a ray enters a room through its border: the room is on the left of a border, which the wall's frame mirrors.
fn enters(line: &Line, sector: &Sector, at: f64) -> bool {
    let along = line.ends[1] - line.ends[0];
    along.y * sector.slope(at) - along.x > 0.0
}

/// A stretch with the depths at its ends.
#[derive(Clone, Copy, Debug)]
struct Step {
    ends: [f64; 2],
    depths: [f64; 2],
}

/// The corners of a line below all steps: where two meet at unlike depths, the deeper one slopes down to the other.
fn without_jumps(steps: &[Step], sector: &Sector) -> Vec<[f64; 2]> {
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else {
        return vec![[sector.from, sector.thickness], [sector.to, sector.thickness]];
    };
    let node = |before: Option<&Step>, after: Option<&Step>| {
        let depths = [before.map(|step| step.depths[1]), after.map(|step| step.depths[0])];
        depths.into_iter().flatten().fold(sector.thickness, f64::min)
    };
    let mut line = vec![[first.ends[0], node(None, Some(first))]];
    for (index, step) in steps.iter().enumerate() {
        let low = line.last().map_or(0.0, |corner| corner[1]);
        let high = node(Some(step), steps.get(index + 1));
        let ([from, to], [start, end]) = (step.ends, step.depths);
        let at = |place: f64| start + (end - start) * (place - from) / (to - from);
        if to - from > 2.0 * RAMP {
            line.extend((start > low + STRAIGHT).then(|| [from + RAMP, at(from + RAMP)]));
            line.extend((end > high + STRAIGHT).then(|| [to - RAMP, at(to - RAMP)]));
        }
        line.push([to, high]);
    }
    debug_assert!(
        line.last().is_some_and(|corner| corner[0] == last.ends[1]),
        "a line ends where its steps do"
    );
    line
}

/// Gives neighbouring sectors the same depth at the ray that they share; sectors without rays become empty.
fn join(profiles: &mut [Vec<[f64; 2]>; 3]) {
    let is_empty =
        |profile: &Vec<[f64; 2]>| profile.first().map(|at| at[0]) == profile.last().map(|at| at[0]);
    let [start, strip, end] = profiles;
    for (fan, is_start) in [(start, true), (end, false)] {
        if is_empty(fan) {
            fan.clear();
            continue;
        }
        let ends = if is_start { (fan.len() - 1, 0) } else { (0, strip.len() - 1) };
        let depth = fan[ends.0][1].min(strip[ends.1][1]);
        lower_end(fan, ends.0, depth);
        lower_end(strip, ends.1, depth);
    }
}

/// Lowers the first or last corner of a line; the rest of the line stays, but for a ramp.
fn lower_end(line: &mut Vec<[f64; 2]>, index: usize, depth: f64) {
    let next = if index == 0 { 1 } else { index - 1 };
    let ([at, old], [next_at, next_depth]) = (line[index], line[next]);
    line[index][1] = depth;
    let distance = next_at - at;
    if old > depth + STRAIGHT && distance.abs() > 2.0 * RAMP {
        let share = RAMP / distance.abs();
        line.insert(index.max(next), [at + distance * share, old + (next_depth - old) * share]);
    }
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
