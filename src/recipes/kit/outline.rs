//! Cross-sections of lofts, seen from above.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec2;

/// The form of a cross-section. Points are counter-clockwise seen from above with x to the right and the
/// second coordinate towards the front.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outline {
    /// A rectangle.
    Square,
    /// A circle or ellipse of this many corners; multiples of four touch all four sides.
    Round(usize),
    /// A rectangle with round corners of [`Slice::radius`], each cut into this many segments.
    Soft(usize),
    /// Corners of a convex outline between −1 and 1.
    Points(Vec<DVec2>),
}

/// One cross-section at a height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slice {
    /// Metres above the underside.
    pub(crate) y: f64,
    /// Half of width and depth; both zero for a tip.
    pub(crate) half: DVec2,
    /// Middle, x and z.
    pub(crate) center: DVec2,
    /// Metres of a corner's rounding, for [`Outline::Soft`] only.
    pub(crate) radius: f64,
    /// Likewise at the back.
    pub(crate) back_radius: f64,
}

/// The least radius of a soft corner, in metres; below it its points would fall together.
const LEAST_RADIUS: f64 = 0.001;

impl Slice {
    /// A cross-section around the y axis.
    pub(crate) fn new(y: f64, half_width: f64, half_depth: f64) -> Self {
        let (half, center) = (DVec2::new(half_width, half_depth), DVec2::ZERO);
        Self { y, half, center, radius: LEAST_RADIUS, back_radius: LEAST_RADIUS }
    }

    /// A circle around the y axis.
    pub(crate) fn round(y: f64, radius: f64) -> Self {
        Self::new(y, radius, radius)
    }

    /// Somewhere else.
    pub(crate) fn at(self, x: f64, z: f64) -> Self {
        Self { center: DVec2::new(x, z), ..self }
    }

    /// With soft corners.
    pub(crate) fn softened(self, radius: f64) -> Self {
        Self { radius, back_radius: radius, ..self }
    }

    /// With other corners at the back than at the front: what stands flush with a wall.
    pub(crate) fn softened_behind(self, back_radius: f64) -> Self {
        Self { back_radius, ..self }
    }

    /// Whether it is a single point.
    pub(super) fn is_tip(&self) -> bool {
        self.half.max_element() <= 0.0
    }
}

impl Outline {
    /// The corners of a slice, x and z.
    pub(super) fn corners(&self, slice: &Slice) -> Vec<DVec2> {
        let unit: Vec<DVec2> = match self {
            Self::Square => [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)].map(DVec2::from).to_vec(),
            Self::Round(count) => {
                (0..*count).map(|step| direction(TAU * step as f64 / *count as f64)).collect()
            }
            Self::Points(points) => points.clone(),
            Self::Soft(segments) => return soft_corners(slice, *segments),
        };
        unit.iter().map(|&point| slice.center + point * slice.half).collect()
    }
}

fn direction(angle: f64) -> DVec2 {
    let (sine, cosine) = libm::sincos(angle);
    DVec2::new(cosine, -sine)
}

fn soft_corners(slice: &Slice, segments: usize) -> Vec<DVec2> {
    let most = slice.half.min_element() * 0.98;
    let signs = [(1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(DVec2::from);
    let corner = |(quarter, sign): (usize, DVec2)| {
        let wanted = if sign.y < 0.0 { slice.back_radius } else { slice.radius };
        let radius = wanted.max(LEAST_RADIUS).min(most);
        let inner = slice.half - DVec2::splat(radius);
        (0..=segments).map(move |step| {
            let share = step as f64 / segments as f64;
            slice.center + sign * inner + direction(FRAC_PI_2 * (quarter as f64 + share)) * radius
        })
    };
    signs.into_iter().enumerate().flat_map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outlines_turn_one_way_and_touch_their_sides() {
        let slice = Slice::new(0.0, 0.5, 0.25).softened(0.1).at(1.0, 2.0);
        for outline in [Outline::Square, Outline::Round(12), Outline::Soft(2)] {
            let corners = outline.corners(&slice);
            let area: f64 = (0..corners.len())
                .map(|index| corners[index].perp_dot(corners[(index + 1) % corners.len()]))
                .sum();
            assert!(area < 0.0, "{outline:?}: x to the right, z to the front is left-handed");
            let high = corners.iter().fold(DVec2::NEG_INFINITY, |high, &corner| high.max(corner));
            assert!(high.distance(DVec2::new(1.5, 2.25)) < 1e-12, "{outline:?} {high}");
        }
    }

    #[test]
    fn corners_at_the_back_may_be_other_than_at_the_front() {
        let slice = Slice::new(0.0, 0.5, 0.25).softened(0.2).softened_behind(0.01);
        let nearest = |corner: DVec2| {
            let corners = Outline::Soft(3).corners(&slice);
            corners.iter().map(|point| point.distance(corner)).fold(f64::INFINITY, f64::min)
        };
        for x in [-0.5, 0.5] {
            assert!(nearest(DVec2::new(x, -0.25)) < 0.01, "z to the front: the back is at -0.25");
            assert!(nearest(DVec2::new(x, 0.25)) > 0.05);
        }
    }

    #[test]
    fn soft_corners_never_fall_together() {
        let corners = Outline::Soft(3).corners(&Slice::new(0.0, 0.01, 0.02).softened(9.0));
        for (index, corner) in corners.iter().enumerate() {
            assert!(corner.distance(corners[(index + 1) % corners.len()]) > 1e-5);
        }
    }
}
