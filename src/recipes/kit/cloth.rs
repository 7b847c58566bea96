//! Cloth that hangs.

use glam::{DVec2, DVec3};

use super::solid::{Shading, Solid};

/// One cross-section of [`hung`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Level {
    /// Metres above the origin.
    pub(crate) at: f64,
    /// Factors along x and z.
    pub(crate) scale: DVec2,
    /// Metres along x and z, after scaling.
    pub(crate) shift: DVec2,
}

/// Degrees below which neighbouring faces of cloth are one smooth surface.
const CREASE: f64 = 75.0;

/// Upright cloth along a line from above, (x, z), of a thickness in z, at two levels or more from its hem to its head, where
/// its front and back meet in one line: nobody looks down on it.
pub(crate) fn hung(line: &[DVec2], thickness: f64, levels: &[Level]) -> Solid {
    let half = DVec2::new(0.0, thickness / 2.0);
    let front = line.iter().map(|&point| point - half);
    let outline: Vec<DVec2> = front.chain(line.iter().rev().map(|&point| point + half)).collect();
    let head = levels.len() - 1;
    let places = levels.iter().enumerate().flat_map(|(index, level)| {
        let outline = if index == head { line } else { &outline };
        outline.iter().map(|&corner| {
            let at = corner * level.scale + level.shift;
            DVec3::new(at.x, level.at, at.y)
        })
    });
    let (count, width) = (outline.len(), line.len());
    let above = |ring: usize, step: usize| match ring + 1 == head {
        true => head * count + step.min(count - 1 - step),
        false => (ring + 1) * count + step,
    };
    let mut triangles = Vec::new();
    for (ring, step) in (0..head).flat_map(|ring| (0..count).map(move |step| (ring, step))) {
        let next = (step + 1) % count;
        let [a, b] = [ring * count + step, ring * count + next];
        let [c, d] = [above(ring, next), above(ring, step)];
        triangles.push([a, b, c]);
        if c != d {
            triangles.push([a, c, d]);
        }
    }
    for step in 0..width - 1 {
        let [a, b, c, d] = [step, step + 1, count - 2 - step, count - 1 - step];
        triangles.extend([[b, a, d], [b, d, c]]);
    }
    Solid::new(places.collect(), triangles, Shading::FLAT).smooth(CREASE)
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    #[test]
    fn cloth_is_closed_and_thin_at_its_head() {
        let line = [(0.0, 0.0), (0.1, 0.05), (0.2, -0.05), (0.3, 0.0)].map(DVec2::from);
        let level = |at: f64| Level { at, scale: DVec2::new(1.0 - at * 0.1, 1.0), shift: DVec2::ZERO };
        for levels in [vec![level(0.0), level(1.0)], vec![level(0.0), level(0.4), level(1.0)]] {
            let solid = hung(&line, 0.01, &levels);
            assert_sound(&solid);
            let (low, high) = solid.bounds();
            assert!(low.distance(DVec3::new(0.0, 0.0, -0.055)) < 1e-9, "{low}");
            assert!(high.distance(DVec3::new(0.3, 1.0, 0.055)) < 1e-9, "{high}");
            let head = solid.points.iter().filter(|point| point.y == 1.0);
            assert_eq!(head.count(), line.len());
        }
    }
}
