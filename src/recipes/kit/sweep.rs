//! Bars and pipes along a path.

use std::f64::consts::TAU;

use glam::DVec3;

use super::solid::{Shading, Solid};

/// Degrees below which the sides of a pipe are one smooth surface: six sides make 60°.
const PIPE_CREASE: f64 = 65.0;

/// A bar of round cross-section through the points of `path` (at least two, none repeated, no bend over a right
/// angle and a half), mitred at the bends and closed at both ends.
pub(crate) fn sweep(path: &[DVec3], radius: f64, sides: usize) -> Solid {
    let segments: Vec<DVec3> =
        path.windows(2).map(|pair| (pair[1] - pair[0]).normalize_or(DVec3::Y)).collect();
    let mut points = first_ring(path[0], segments[0], radius, sides);
    for (index, &direction) in segments.iter().enumerate() {
        // The mitre plane halves the angle between this segment and the next.
        let plane =
            segments.get(index + 1).map_or(direction, |next| (direction + *next).normalize_or(direction));
        let through = path[index + 1];
        for step in 0..sides {
            let start = points[index * sides + step];
            let reach = (through - start).dot(plane) / direction.dot(plane);
            points.push(start + direction * reach);
        }
    }
    let mut triangles = Vec::new();
    for ring in 0..segments.len() {
        for step in 0..sides {
            let next = (step + 1) % sides;
            let [a, b] = [ring * sides + step, ring * sides + next];
            triangles.extend([[a, b, b + sides], [a, b + sides, a + sides]]);
        }
    }
    let last = segments.len() * sides;
    for step in 1..sides - 1 {
        triangles.push([0, step + 1, step]);
        triangles.push([last, last + step, last + step + 1]);
    }
    // Square bars keep their edges.
    let shading = if sides > 4 { Shading::Crease(PIPE_CREASE.to_radians()) } else { Shading::FLAT };
    Solid::new(points, triangles, shading)
}

/// Points of a path whose bends are rounded off, `reach` metres before and after each of them at most, in `steps`.
pub(crate) fn rounded_path(path: &[DVec3], reach: f64, steps: usize) -> Vec<DVec3> {
    let last = path.len() - 1;
    let mut points = vec![path[0]];
    for index in 1..last {
        let (corner, to, from) = (path[index], path[index - 1] - path[index], path[index + 1] - path[index]);
        // Two bends share the piece between them.
        let near = |arm: DVec3| arm.normalize_or(DVec3::Y) * reach.min(arm.length() * 0.45);
        let (start, end) = (corner + near(to), corner + near(from));
        points.extend((0..=steps).map(|step| {
            let share = step as f64 / steps as f64;
            start.lerp(corner, share).lerp(corner.lerp(end, share), share)
        }));
    }
    points.push(path[last]);
    points
}

/// A pipe of six sides along a path with round bends.
pub(crate) fn pipe(path: &[DVec3], radius: f64, bend: f64) -> Solid {
    sweep(&rounded_path(path, bend, 3), radius, 6)
}

fn first_ring(middle: DVec3, direction: DVec3, radius: f64, sides: usize) -> Vec<DVec3> {
    let reference = if direction.y.abs() > 0.9 { DVec3::Z } else { DVec3::Y };
    let across = direction.cross(reference).normalize();
    let up = across.cross(direction);
    // Half a step off, so that a bar of four sides lies flat.
    let corner = |step: usize| {
        let (sine, cosine) = libm::sincos(TAU * (step as f64 + 0.5) / sides as f64);
        middle + (across * cosine + up * sine) * radius
    };
    (0..sides).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    #[test]
    fn a_bent_pipe_is_closed_and_keeps_its_thickness() {
        let path =
            [DVec3::ZERO, DVec3::new(0.0, 1.0, 0.0), DVec3::new(0.3, 1.3, 0.0), DVec3::new(1.0, 1.3, 0.5)];
        let pipe = sweep(&path, 0.02, 8);
        assert_sound(&pipe);
        let length: f64 = path.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let section = 8.0 / 2.0 * 0.02 * 0.02 * libm::sin(TAU / 8.0);
        assert!((pipe.volume() / (length * section) - 1.0).abs() < 0.02);
    }

    #[test]
    fn round_bends_stay_between_the_ends() {
        let path = [DVec3::ZERO, DVec3::Y, DVec3::Y + DVec3::X, DVec3::X];
        let points = rounded_path(&path, 0.8, 3);
        assert_eq!((points[0], points[points.len() - 1], points.len()), (path[0], path[3], 10));
        assert!(points.iter().all(|point| point.y <= 1.0 && point.x <= 1.0));
        assert_sound(&pipe(&path, 0.02, 0.1));
    }

    #[test]
    fn a_square_bar_lies_flat() {
        let bar = sweep(&[DVec3::ZERO, DVec3::X], 0.1, 4);
        assert_sound(&bar);
        let (low, high) = bar.bounds();
        let half = 0.1 * std::f64::consts::FRAC_1_SQRT_2;
        assert!((high.y - half).abs() < 1e-12 && (low.z + half).abs() < 1e-12);
    }
}
