//! Bodies that a box of metres by a few centimetres has flattened.

use glam::DVec3;

use super::solid::{Shading, Solid};
use super::{Bay, THINNEST, cuboid};

/// Square metres that every triangle has, with the positions that are written, which are rounded.
const LEAST_AREA: f64 = 2e-9;
/// Metres of height over its longest side that every triangle has: below it, rounding may turn the triangle over.
const LEAST_HEIGHT: f64 = 2e-6;

/// A body that may be written: as it is; as the box around it where it has triangles like needles; none where even that
/// box is too thin.
///
/// Recipes divide the box of their class, and users may ask for any box. What is curved and has to be a hundred times as
/// long as wide has corners that nearly fall in line, and leaves that are stretched to the side may turn inside out.
pub(super) fn mended(mut solid: Solid) -> Option<Solid> {
    if matches!(solid.shading, Shading::Crease(_)) && solid.volume() < 0.0 {
        solid.flip();
    }
    if is_sound(&solid) {
        return Some(solid);
    }
    let (low, high) = solid.bounds();
    ((high - low).min_element() > THINNEST).then(|| cuboid(Bay { low, high }))
}

/// Whether every triangle has an area and the whole a volume.
pub(super) fn is_sound(solid: &Solid) -> bool {
    let has_area = |&triangle: &[usize; 3]| {
        let [a, b, c] = triangle.map(|point| rounded(solid.points[point]));
        let doubled = (b - a).cross(c - a).length();
        let longest = (b - a).length_squared().max((c - a).length_squared()).max((c - b).length_squared());
        doubled > LEAST_AREA * 2.0 && doubled * doubled > LEAST_HEIGHT * LEAST_HEIGHT * longest
    };
    solid.volume() > 0.0 && solid.triangles.iter().all(has_area)
}

/// A point as files hold it.
fn rounded(point: DVec3) -> DVec3 {
    point.as_vec3().as_dvec3()
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::super::{cylinder, lathe, rounded_box};
    use super::*;

    #[test]
    fn what_is_sound_stays_as_it_is() {
        let solid = cylinder(0.1, [0.0, 1.0], 12);
        assert_eq!(mended(solid.clone()), Some(solid));
    }

    #[test]
    fn what_is_inside_out_is_turned_round() {
        let mut solid = cylinder(0.1, [0.0, 1.0], 12);
        solid.flip();
        assert_sound(&mended(solid).unwrap());
    }

    #[test]
    fn needles_become_the_box_around_them() {
        let cone = |tip: f64| lathe(&[(tip, 0.0), (0.3, 0.2), (0.0, 0.5)], 8);
        let boxed = mended(cone(1e-9)).unwrap();
        assert_eq!((boxed.triangles.len(), boxed.bounds()), (12, cone(1e-9).bounds()));
        assert_eq!(mended(cone(1e-3)), Some(cone(1e-3)));
    }

    #[test]
    fn what_is_too_thin_for_a_box_goes() {
        let sheet = |thickness: f64| {
            rounded_box(Bay::new([0.0, 1.0], [0.0, 1.0], [0.0, thickness]), DVec3::splat(9.0), 1)
        };
        assert_eq!(mended(sheet(1e-6)), None);
        assert_eq!(mended(sheet(1e-2)), Some(sheet(1e-2)));
    }
}
