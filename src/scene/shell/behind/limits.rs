//! Rays from the inner face of a wall, and what limits their depth.

use crate::geometry::Point;
use crate::scene::shell::thickness::THIN_SHEET;

/// A family of rays: parallel ones, or those through a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sector {
    /// The corner, along the wall.
    pub(super) corner: Option<f64>,
    /// Where the first and the last ray are at the depth of the wall's thickness.
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) thickness: f64,
}

impl Sector {
    /// The place on the inner face where a ray begins.
    pub(super) fn inner(&self, at: f64) -> f64 {
        self.corner.unwrap_or(at)
    }

    /// Metres along the wall for each metre behind it.
    pub(super) fn slope(&self, at: f64) -> f64 {
        self.corner.map_or(0.0, |corner| (at - corner) / self.thickness)
    }

    pub(super) fn point(&self, at: f64, depth: f64) -> Point {
        Point::new(self.inner(at) + self.slope(at) * depth, depth)
    }

    /// The ray through a point behind the wall.
    pub(super) fn ray_of(&self, point: Point) -> f64 {
        self.corner.map_or(point.x, |corner| corner + (point.x - corner) * self.thickness / point.y)
    }
}

/// A line that limits the depth: to a share of the way to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) ends: [Point; 2],
    pub(super) share: f64,
}

impl Line {
    /// The part between two depths.
    pub(super) fn between(&self, low: f64, high: f64) -> Option<Self> {
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
    pub(super) fn depth_at(&self, sector: &Sector, at: f64) -> f64 {
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

    pub(super) fn rays(&self, sector: &Sector) -> [f64; 2] {
        let [one, two] = self.ends.map(|end| sector.ray_of(end));
        [one.min(two), one.max(two)]
    }
}

/// The limit of the depth of some neighbouring rays.
pub(super) struct Limits<'g> {
    pub(super) rooms: Vec<&'g Line>,
    pub(super) mitres: Vec<&'g Line>,
    /// Whether the rays begin in another room.
    pub(super) is_inside: bool,
}

impl Limits<'_> {
    pub(super) fn depth(&self, sector: &Sector, at: f64) -> f64 {
        let least = |lines: &[&Line]| {
            lines.iter().map(|line| line.depth_at(sector, at)).fold(sector.thickness, f64::min)
        };
        let free = if self.is_inside { 0.0 } else { least(&self.rooms) };
        // Where two rooms touch, there still is a wall: so long a piece of each ray.
        let sheet = THIN_SHEET / (1.0 + sector.slope(at).abs());
        least(&self.mitres).min(free.max(sheet))
    }

    /// The rays at which a mitre and the border of a room, or the outer face, are about equally far.
    pub(super) fn crossings(&self, sector: &Sector, [from, to]: [f64; 2]) -> Vec<f64> {
        let depths = |line: Option<&&Line>| {
            [from, to].map(|at| line.map_or(sector.thickness, |line| line.depth_at(sector, at)))
        };
        let rooms: Vec<[f64; 2]> =
            self.rooms.iter().map(|line| depths(Some(line))).chain([depths(None)]).collect();
        let crossing = |one: [f64; 2], two: [f64; 2]| {
            let (start, end) = (one[0] - two[0], one[1] - two[1]);
            (start * end < 0.0).then(|| from + (to - from) * start / (start - end))
        };
        let mitres = self.mitres.iter().map(|line| depths(Some(line)));
        mitres.flat_map(|mitre| rooms.iter().filter_map(move |&room| crossing(mitre, room))).collect()
    }
}

/// Whether a ray enters a room through its border: the room is on the left of a border, which the wall's frame mirrors.
pub(super) fn enters(line: &Line, sector: &Sector, at: f64) -> bool {
    let along = line.ends[1] - line.ends[0];
    along.y * sector.slope(at) - along.x > 0.0
}
