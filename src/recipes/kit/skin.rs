//! Bodies through freely shaped cross-sections: cloth, shells, bent plywood.

use glam::DVec3;

use super::solid::{Shading, Solid};

/// A body through rings of equally many points, at least three each; each end is closed by a fan around its
/// middle, which has to see the whole ring. Faces that meet at less than `crease` degrees are one smooth surface.
pub(crate) fn skin(rings: &[Vec<DVec3>], crease: f64) -> Solid {
    let count = rings[0].len();
    let mut points = rings.concat();
    let mut triangles = joined(rings.len(), count);
    let ends = [(0, true), (rings.len() - 1, false)];
    for (ring, is_first) in ends {
        let middle = points.len();
        points.push(rings[ring].iter().sum::<DVec3>() / count as f64);
        for step in 0..count {
            let [a, b] = [ring * count + step, ring * count + (step + 1) % count];
            triangles.push(if is_first { [b, a, middle] } else { [a, b, middle] });
        }
    }
    Solid::new(points, triangles, Shading::FLAT).smooth(crease)
}

/// The sides between neighbouring rings.
fn joined(rings: usize, count: usize) -> Vec<[usize; 3]> {
    let side = |ring: usize, step: usize| {
        let [a, b] = [ring * count + step, ring * count + (step + 1) % count];
        [[a, b, b + count], [a, b + count, a + count]]
    };
    (0..rings - 1).flat_map(|ring| (0..count).flat_map(move |step| side(ring, step))).collect()
}

/// One cross-section of a [`sheet`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Station {
    /// Its middle.
    pub(crate) at: DVec3,
    /// Metres from the middle to either edge.
    pub(crate) half_width: f64,
    /// Metres by which the edges stand over the middle.
    pub(crate) sag: f64,
}

/// Degrees below which neighbouring faces of a sheet are one smooth surface; its rim stays sharp.
const SHEET_CREASE: f64 = 42.0;

/// A bent sheet of a thickness through stations, `sideways` wide (a unit vector across the path) in `across` strips.
pub(crate) fn sheet(stations: &[Station], sideways: DVec3, thickness: f64, across: usize) -> Solid {
    let last = stations.len() - 1;
    let ring = |index: usize| {
        let station = stations[index];
        let along = stations[(index + 1).min(last)].at - stations[index.saturating_sub(1)].at;
        let up = along.cross(sideways).normalize_or(DVec3::Y);
        let at = |step: usize, side: f64| {
            let share = 2.0 * step as f64 / across as f64 - 1.0;
            let lift = station.sag * share * share + side * thickness / 2.0;
            station.at + sideways * station.half_width * share + up * lift
        };
        let over = (0..=across).map(move |step| at(step, 1.0));
        let under = (0..=across).rev().map(move |step| at(step, -1.0));
        over.chain(under).collect::<Vec<DVec3>>()
    };
    let rings: Vec<Vec<DVec3>> = (0..=last).map(ring).collect();
    let count = 2 * (across + 1);
    let mut triangles = joined(rings.len(), count);
    for (start, is_first) in [(0, true), (last * count, false)] {
        for step in 0..across {
            let [a, b] = [start + step, start + step + 1];
            let [c, d] = [start + count - 2 - step, start + count - 1 - step];
            let cap = [[b, a, d], [b, d, c]];
            triangles.extend(if is_first { cap } else { cap.map(|[a, b, c]| [a, c, b]) });
        }
    }
    Solid::new(rings.concat(), triangles, Shading::FLAT).smooth(SHEET_CREASE)
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    fn station(y: f64, z: f64, sag: f64) -> Station {
        Station { at: DVec3::new(0.0, y, z), half_width: 0.2, sag }
    }

    #[test]
    fn bent_sheets_are_closed_and_keep_their_thickness() {
        let flat = sheet(&[station(0.0, 0.0, 0.0), station(0.0, 0.5, 0.0)], DVec3::X, 0.01, 3);
        assert_sound(&flat);
        assert!((flat.volume() - 0.4 * 0.5 * 0.01).abs() < 1e-12);
        let bent = sheet(
            &[station(0.0, 0.0, 0.02), station(0.02, 0.4, 0.03), station(0.4, 0.5, 0.05)],
            DVec3::X,
            0.01,
            4,
        );
        assert_sound(&bent);
    }

    #[test]
    fn skins_are_closed_whichever_way_their_rings_turn() {
        let ring = |z: f64, size: f64| {
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x * size, y, z)).to_vec()
        };
        let mut rings = vec![ring(0.0, 1.0), ring(1.0, 1.5), ring(2.0, 1.0)];
        assert_sound(&skin(&rings, 30.0));
        rings.reverse();
        assert_sound(&skin(&rings, 30.0));
    }
}
