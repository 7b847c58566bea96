//! Bodies through a stack of cross-sections: cylinders, turned legs, basins, mouldings, frames.

use glam::DVec3;

use super::outline::{Outline, Slice};
use super::solid::{Shading, Solid};

/// Degrees below which neighbouring faces of a round loft are one smooth surface: eight corners make 45°.
const ROUND_CREASE: f64 = 50.0;
/// The same for outlines with sharp corners.
const SQUARE_CREASE: f64 = 30.0;

/// A body through convex cross-sections from the first to the last; both ends are closed, by a face or, where the
/// slice is a tip, by that point. The stack may turn back into itself (up the outside of a cup and down
/// its inside). Needs two slices, and a real outline in each but the ends.
pub(crate) fn loft(outline: &Outline, slices: &[Slice]) -> Solid {
    let mut stack = Stack::new(outline, slices);
    for index in 1..slices.len() {
        stack.join(index - 1, index);
    }
    stack.close(0, false);
    stack.close(slices.len() - 1, true);
    stack.into_solid(outline)
}

/// A ring-shaped body: the stack of cross-sections runs up one side of it and down the other, back to the first.
pub(crate) fn loft_ring(outline: &Outline, slices: &[Slice]) -> Solid {
    let mut stack = Stack::new(outline, slices);
    for index in 0..slices.len() {
        stack.join(index, (index + 1) % slices.len());
    }
    stack.into_solid(outline)
}

/// A body of revolution around the y axis through (radius, y) pairs.
pub(crate) fn lathe(profile: &[(f64, f64)], sides: usize) -> Solid {
    let slices: Vec<Slice> = profile.iter().map(|&(radius, y)| Slice::round(y, radius)).collect();
    loft(&Outline::Round(sides), &slices)
}

/// An upright cylinder around the y axis.
pub(crate) fn cylinder(radius: f64, y: [f64; 2], sides: usize) -> Solid {
    lathe(&[(radius, y[0]), (radius, y[1])], sides)
}

struct Stack {
    points: Vec<DVec3>,
    rings: Vec<Vec<usize>>,
    triangles: Vec<[usize; 3]>,
}

impl Stack {
    fn new(outline: &Outline, slices: &[Slice]) -> Self {
        let mut stack = Self { points: Vec::new(), rings: Vec::new(), triangles: Vec::new() };
        for slice in slices {
            let start = stack.points.len();
            if slice.is_tip() {
                stack.points.push(DVec3::new(slice.center.x, slice.y, slice.center.y));
            } else {
                let corners = outline.corners(slice).into_iter();
                stack.points.extend(corners.map(|corner| DVec3::new(corner.x, slice.y, corner.y)));
            }
            stack.rings.push((start..stack.points.len()).collect());
        }
        stack
    }

    fn join(&mut self, lower: usize, upper: usize) {
        let (lower, upper) = (self.rings[lower].clone(), self.rings[upper].clone());
        let count = lower.len().max(upper.len());
        for step in 0..count {
            let next = (step + 1) % count;
            match (lower.len(), upper.len()) {
                (1, _) => self.triangles.push([lower[0], upper[next], upper[step]]),
                (_, 1) => self.triangles.push([lower[step], lower[next], upper[0]]),
                _ => self.triangles.extend([
                    [lower[step], lower[next], upper[next]],
                    [lower[step], upper[next], upper[step]],
                ]),
            }
        }
    }

    /// Closes an end with a fan that zigzags across, so that no triangle is a needle.
    fn close(&mut self, ring: usize, is_last: bool) {
        let ring = self.rings[ring].clone();
        let (mut low, mut high) = (0, ring.len() - 1);
        let mut is_low_turn = true;
        while high > low + 1 {
            let middle = if is_low_turn { low + 1 } else { high - 1 };
            let [a, b, c] = [ring[low], ring[middle], ring[high]];
            self.triangles.push(if is_last { [a, b, c] } else { [a, c, b] });
            if is_low_turn {
                low += 1
            } else {
                high -= 1
            }
            is_low_turn = !is_low_turn;
        }
    }

    fn into_solid(self, outline: &Outline) -> Solid {
        let degrees = if *outline == Outline::Square { SQUARE_CREASE } else { ROUND_CREASE };
        Solid::new(self.points, self.triangles, Shading::FLAT).smooth(degrees)
    }
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_cylinder_has_nearly_the_volume_of_one() {
        let solid = cylinder(0.5, [0.0, 2.0], 64);
        assert_sound(&solid);
        assert!((solid.volume() - PI * 0.5).abs() < 0.01);
    }

    #[test]
    fn tips_close_both_ends() {
        let solid = lathe(&[(0.0, 0.0), (0.3, 0.2), (0.0, 0.5)], 8);
        assert_sound(&solid);
        assert_eq!((solid.points.len(), solid.triangles.len()), (10, 16));
    }

    #[test]
    fn a_cup_is_closed_and_hollow() {
        let cup = lathe(&[(0.03, 0.0), (0.04, 0.1), (0.036, 0.1), (0.027, 0.004)], 12);
        assert_sound(&cup);
        assert!(cup.volume() < 0.3 * PI * 0.04 * 0.04 * 0.1);
    }

    #[test]
    fn a_frame_is_a_ring() {
        let slices = [
            Slice::new(0.0, 0.5, 0.4),
            Slice::new(0.1, 0.5, 0.4),
            Slice::new(0.1, 0.4, 0.3),
            Slice::new(0.0, 0.4, 0.3),
        ];
        let frame = loft_ring(&Outline::Square, &slices);
        assert_sound(&frame);
        assert!((frame.volume() - 0.1 * (0.8 - 0.48)).abs() < 1e-12);
    }

    #[test]
    fn soft_outlines_close() {
        let slices = [Slice::new(0.0, 0.3, 0.2).softened(0.1), Slice::new(0.4, 0.35, 0.25).softened(0.05)];
        assert_sound(&loft(&Outline::Soft(3), &slices));
        assert_sound(&lathe(&[(0.2, 0.0), (0.1, 1.0)], 5));
    }
}
