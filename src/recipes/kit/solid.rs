//! A closed body of triangles.

use glam::{DQuat, DVec3};

/// A closed body: every edge belongs to exactly two triangles, which are counter-clockwise from outside.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Solid {
    /// Corners, each once.
    pub(crate) points: Vec<DVec3>,
    /// Indices into `points`.
    pub(crate) triangles: Vec<[usize; 3]>,
    /// How normals are made.
    pub(crate) shading: Shading,
}

/// How the normals of a [`Solid`] are made.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shading {
    /// Triangles that meet at a lower angle than this, in radians, share one smooth normal.
    Crease(f64),
    /// One normal for each point.
    Given(Vec<DVec3>),
}

impl Shading {
    /// Every face flat.
    pub(crate) const FLAT: Self = Self::Crease(0.02);
}

/// The most that one axis may be stretched more than another with given normals kept.
const MOST_UNEVEN: f64 = 1.6;
/// Crease angle in degrees of what is stretched more.
const UNEVEN_CREASE: f64 = 40.0;
/// Cosine of the largest angle between a given normal and a triangle: beyond it, rounding may turn it away.
const LEAST_FACING: f64 = 0.001;

impl Solid {
    /// A body from triangles that are all oriented alike; turns them all round if they face inwards.
    pub(crate) fn new(points: Vec<DVec3>, triangles: Vec<[usize; 3]>, shading: Shading) -> Self {
        let mut solid = Self { points, triangles, shading };
        if solid.volume() < 0.0 {
            solid.flip();
        }
        solid
    }

    /// Cubic metres enclosed.
    pub(crate) fn volume(&self) -> f64 {
        let cone = |&[a, b, c]: &[usize; 3]| self.points[a].dot(self.points[b].cross(self.points[c])) / 6.0;
        self.triangles.iter().map(cone).sum()
    }

    /// Lowest and highest corner of the axis-aligned box around it.
    pub(crate) fn bounds(&self) -> (DVec3, DVec3) {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.points.iter().fold(start, |(low, high), &point| (low.min(point), high.max(point)))
    }

    /// Moved by metres.
    pub(crate) fn moved(mut self, x: f64, y: f64, z: f64) -> Self {
        for point in &mut self.points {
            *point += DVec3::new(x, y, z);
        }
        self
    }

    /// Turned about the origin.
    pub(crate) fn turned(mut self, by: DQuat) -> Self {
        for point in &mut self.points {
            *point = by * *point;
        }
        if let Shading::Given(normals) = &mut self.shading {
            for normal in normals {
                *normal = by * *normal;
            }
        }
        self
    }

    /// Turned about the x axis: up goes to the front.
    pub(crate) fn turned_x(self, radians: f64) -> Self {
        self.turned(DQuat::from_rotation_x(radians))
    }

    /// Turned about the y axis: the front goes to the right.
    pub(crate) fn turned_y(self, radians: f64) -> Self {
        self.turned(DQuat::from_rotation_y(radians))
    }

    /// Turned about the z axis: the right goes up.
    pub(crate) fn turned_z(self, radians: f64) -> Self {
        self.turned(DQuat::from_rotation_z(radians))
    }

    /// The mirror image in x.
    pub(crate) fn mirrored(mut self) -> Self {
        let mirror = |point: &mut DVec3| point.x = -point.x;
        self.points.iter_mut().for_each(mirror);
        if let Shading::Given(normals) = &mut self.shading {
            normals.iter_mut().for_each(mirror);
        }
        self.flip();
        self
    }

    /// Stretched about the origin by positive factors; given normals stay at right angles to the surface. Where one
    /// factor is much larger than another, they would leave the flat triangles too far, and are made anew; so they are
    /// where a slanting body is stretched so that one looks away from a triangle.
    pub(crate) fn stretched(mut self, by: DVec3) -> Self {
        let is_uneven = by.max_element() > MOST_UNEVEN * by.min_element();
        if is_uneven && matches!(self.shading, Shading::Given(_)) {
            self = self.smooth(UNEVEN_CREASE);
        }
        for point in &mut self.points {
            *point *= by;
        }
        if let Shading::Given(normals) = &mut self.shading {
            for normal in normals {
                *normal = (*normal / by).normalize();
            }
        }
        if self.looks_away() { self.smooth(UNEVEN_CREASE) } else { self }
    }

    /// Whether a given normal looks away from one of its triangles.
    fn looks_away(&self) -> bool {
        let Shading::Given(normals) = &self.shading else { return false };
        self.triangles.iter().any(|&triangle| {
            let [a, b, c] = triangle.map(|point| self.points[point]);
            let face = (b - a).cross(c - a);
            let least = face.length() * LEAST_FACING;
            triangle.iter().any(|&point| normals[point].dot(face) < least)
        })
    }

    /// With another crease angle, in degrees.
    pub(crate) fn smooth(mut self, degrees: f64) -> Self {
        self.shading = Shading::Crease(degrees.to_radians());
        self
    }

    /// Every triangle the other way round.
    pub(super) fn flip(&mut self) {
        for triangle in &mut self.triangles {
            triangle.swap(1, 2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Bay, cuboid, rounded_box};
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn brick() -> Bay {
        Bay::new([0.0, 1.0], [0.0, 2.0], [0.0, 3.0])
    }

    #[test]
    fn a_body_given_inside_out_is_turned_round() {
        let solid = cuboid(brick());
        let flipped = solid.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
        let mended = Solid::new(solid.points.clone(), flipped, Shading::FLAT);
        assert!((mended.volume() - 6.0).abs() < 1e-9);
    }

    #[test]
    fn moving_turning_and_mirroring_keep_the_volume() {
        let solid = rounded_box(brick(), DVec3::splat(0.2), 2);
        let volume = solid.volume();
        let changed = solid.moved(1.0, -2.0, 0.5).turned_y(0.7).mirrored().turned_x(0.2).turned_z(1.0);
        assert!((changed.volume() - volume).abs() < 1e-9);
    }

    #[test]
    fn quarter_turns_go_where_the_names_say() {
        let up = cuboid(Bay::new([-0.1, 0.1], [0.9, 1.1], [-0.1, 0.1]));
        let (low, high) = up.turned_x(FRAC_PI_2).bounds();
        assert!(((low + high) / 2.0).distance(DVec3::Z) < 1e-12);
        let front = cuboid(Bay::new([-0.1, 0.1], [-0.1, 0.1], [0.9, 1.1]));
        let (low, high) = front.turned_y(FRAC_PI_2).bounds();
        assert!(((low + high) / 2.0).distance(DVec3::X) < 1e-12);
    }

    #[test]
    fn stretching_keeps_given_normals_at_right_angles_to_the_surface() {
        let solid = rounded_box(brick(), DVec3::splat(0.3), 3).stretched(DVec3::new(1.3, 1.0, 0.9));
        let Shading::Given(normals) = &solid.shading else { panic!("rounded boxes give normals") };
        for &[a, b, c] in &solid.triangles {
            let face = (solid.points[b] - solid.points[a]).cross(solid.points[c] - solid.points[a]);
            assert!(normals[a].dot(face.normalize()) > 0.5);
        }
    }

    #[test]
    fn given_normals_that_stretching_turns_away_are_made_anew() {
        let leaning = |radius: f64| {
            let board = Bay::new([-0.17, 0.17], [0.0, 0.2], [-0.008, 0.0]);
            let soft = rounded_box(board, DVec3::new(radius, radius, radius * 0.12), 1).turned_x(-1.3);
            soft.stretched(DVec3::new(1.0, 1.5, 1.0))
        };
        assert!(matches!(leaning(0.004).shading, Shading::Crease(_)));
        let upright = rounded_box(brick(), DVec3::splat(0.3), 1).stretched(DVec3::new(1.0, 1.5, 1.0));
        assert!(matches!(upright.shading, Shading::Given(_)));
    }
}

/// The requirements on every solid of the kit.
#[cfg(test)]
pub(crate) mod checks {
    use super::*;
    use std::collections::BTreeMap;

    /// Square metres below which a triangle counts as having none.
    const SMALLEST_AREA: f64 = 1e-10;

    /// Panics unless the solid is closed, faces outwards, and has neither flat triangles nor unused points.
    pub(crate) fn assert_sound(solid: &Solid) {
        let mut edges: BTreeMap<(usize, usize), i32> = BTreeMap::new();
        let mut is_used = vec![false; solid.points.len()];
        for &triangle in &solid.triangles {
            let [a, b, c] = triangle.map(|point| solid.points[point]);
            assert!((b - a).cross(c - a).length() / 2.0 > SMALLEST_AREA, "flat triangle {a} {b} {c}");
            for step in 0..3 {
                *edges.entry((triangle[step], triangle[(step + 1) % 3])).or_default() += 1;
                is_used[triangle[step]] = true;
            }
        }
        for (&(from, to), &count) in &edges {
            assert_eq!(count, 1, "edge {from}-{to} is used {count} times");
            assert!(edges.contains_key(&(to, from)), "edge {from}-{to} is open");
        }
        assert!(is_used.iter().all(|&used| used), "a point belongs to no triangle");
        assert!(solid.volume() > 0.0, "volume {}", solid.volume());
    }
}
