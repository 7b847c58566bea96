//! Profiles drawn along an axis.

use earcut::Earcut;
use glam::{DVec2, DVec3};

use super::solid::{Shading, Solid};

/// The axis a profile is drawn along, and what its coordinates mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    /// Drawn from left to right; the profile is (z, y): the view from the right, front to the right.
    X,
    /// Drawn upwards; the profile is (x, z).
    Y,
    /// Drawn from back to front; the profile is (x, y).
    Z,
}

/// Degrees below which neighbouring sides of a profile are one smooth surface.
const CREASE: f64 = 35.0;

/// A body with the simple outline `profile` (either direction, no three corners in line) between the two ends
/// along an axis.
pub(crate) fn extrude(profile: &[DVec2], axis: Axis, ends: [f64; 2]) -> Solid {
    let count = profile.len();
    let place = |corner: &DVec2, end: f64| match axis {
        Axis::X => DVec3::new(end, corner.y, corner.x),
        Axis::Y => DVec3::new(corner.x, end, corner.y),
        Axis::Z => DVec3::new(corner.x, corner.y, end),
    };
    let points = ends.iter().flat_map(|&end| profile.iter().map(move |corner| place(corner, end))).collect();
    let mut caps: Vec<usize> = Vec::new();
    Earcut::new().earcut(profile.iter().map(|corner| corner.to_array()), &[], &mut caps);
    let direction = if area(profile) > 0.0 { [0, 1] } else { [1, 0] };
    let mut triangles = Vec::new();
    for cap in caps.chunks_exact(3) {
        let cap = counter_clockwise(profile, [cap[0], cap[1], cap[2]]);
        triangles.push([cap[0], cap[2], cap[1]]);
        triangles.push(cap.map(|corner| corner + count));
    }
    for index in 0..count {
        let pair = [index, (index + 1) % count];
        let [a, b] = [pair[direction[0]], pair[direction[1]]];
        triangles.extend([[a, b, b + count], [a, b + count, a + count]]);
    }
    Solid::new(points, triangles, Shading::FLAT).smooth(CREASE)
}

fn area(profile: &[DVec2]) -> f64 {
    let next = |index: usize| profile[(index + 1) % profile.len()];
    profile.iter().enumerate().map(|(index, corner)| corner.perp_dot(next(index))).sum()
}

fn counter_clockwise(profile: &[DVec2], [a, b, c]: [usize; 3]) -> [usize; 3] {
    let is_left = (profile[b] - profile[a]).perp_dot(profile[c] - profile[a]) > 0.0;
    if is_left { [a, b, c] } else { [a, c, b] }
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    fn ell() -> Vec<DVec2> {
        [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from).to_vec()
    }

    #[test]
    fn concave_profiles_close_along_every_axis_in_either_direction() {
        let mut backwards = ell();
        backwards.reverse();
        for profile in [ell(), backwards] {
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                let solid = extrude(&profile, axis, [-0.5, 0.5]);
                assert_sound(&solid);
                assert!((solid.volume() - 3.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_axes_mean_what_they_say() {
        let (low, high) =
            extrude(&[(0.0, 0.0), (3.0, 0.0), (0.0, 2.0)].map(DVec2::from), Axis::X, [0.0, 1.0]).bounds();
        assert_eq!((low, high), (DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0)));
    }
}
