//! Leaves: thin closed bodies along a bent rib.

use glam::DVec3;

use super::solid::{Shading, Solid};

/// A leaf to be made by [`blade`].
#[derive(Clone, Debug)]
pub(crate) struct Blade<'a> {
    /// Points of the rib: the first and last are tips, at least one between.
    pub(crate) rib: &'a [DVec3],
    /// Half the width at each point between the tips.
    pub(crate) half_widths: &'a [f64],
    /// Metres at the rib at least.
    pub(crate) thickness: f64,
    /// Share of the half width by which the rib lies higher than the edges.
    pub(crate) fold: f64,
}

/// Degrees below which the faces of a leaf are one smooth surface; its rim stays sharp.
const LEAF_CREASE: f64 = 80.0;

/// A leaf with a ridge along its rib, level below: 6 triangles at the tips and 6 for each further point of the rib.
pub(crate) fn blade(leaf: &Blade) -> Solid {
    let last = leaf.rib.len() - 1;
    let mut points = vec![leaf.rib[0]];
    for index in 1..last {
        let along = (leaf.rib[index + 1] - leaf.rib[index - 1]).normalize_or(DVec3::Y);
        let sideways = along.cross(DVec3::Y).normalize_or(DVec3::X);
        let up = sideways.cross(along);
        let (middle, half_width) = (leaf.rib[index], leaf.half_widths[index - 1]);
        let ridge = up * (half_width * leaf.fold).max(leaf.thickness) / 2.0;
        points.push(middle + sideways * half_width - ridge);
        points.push(middle + ridge);
        points.push(middle - sideways * half_width - ridge);
    }
    points.push(leaf.rib[last]);
    let tip = points.len() - 1;
    let mut triangles = Vec::new();
    for step in 0..3 {
        let next = (step + 1) % 3;
        triangles.push([0, 1 + next, 1 + step]);
        for ring in 0..last - 2 {
            let [a, b] = [1 + 3 * ring + step, 1 + 3 * ring + next];
            triangles.extend([[a, b, b + 3], [a, b + 3, a + 3]]);
        }
        triangles.push([tip, tip - 3 + step, tip - 3 + next]);
    }
    Solid::new(points, triangles, Shading::Crease(LEAF_CREASE.to_radians()))
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    #[test]
    fn leaves_are_closed() {
        let rib =
            [DVec3::ZERO, DVec3::new(0.1, 0.1, 0.0), DVec3::new(0.2, 0.12, 0.0), DVec3::new(0.3, 0.05, 0.01)];
        for fold in [0.0, 0.3] {
            let leaf = blade(&Blade { rib: &rib, half_widths: &[0.03, 0.04], thickness: 0.003, fold });
            assert_sound(&leaf);
            assert_eq!(leaf.triangles.len(), 12);
        }
    }

    #[test]
    fn an_upright_rib_still_gives_a_leaf() {
        let rib = [DVec3::ZERO, DVec3::Y, DVec3::Y * 2.0];
        assert_sound(&blade(&Blade { rib: &rib, half_widths: &[0.1], thickness: 0.01, fold: 0.0 }));
    }
}
