//! Texture coordinates in metres, projected along the axes of the model's box.

use glam::{DVec2, DVec3};

use super::solid::Solid;

/// How texture coordinates lie on a part.
///
/// Every face is seen along the axis that it faces most, and its image lies upright and unmirrored on it; one unit is
/// one metre. The grain, which runs along `u`, follows the longest side of the part, as boards are cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    /// Axes from the part's longest extent to its shortest.
    by_length: [usize; 3],
    /// Shifts the image, so that parts of equal boards do not show equal knots.
    offset: DVec2,
}

/// Shares of a metre by which the images of one part after another are shifted: the golden ratio spreads them evenly.
const SHIFT: DVec2 = DVec2::new(0.618_034, 0.381_966);

impl Projection {
    /// For a part of a model, the `number`-th of its slot.
    pub(super) fn of_part(solid: &Solid, number: usize) -> Self {
        let (low, high) = solid.bounds();
        let extent = high - low;
        let mut by_length = [0, 1, 2];
        // Stable: of equal extents the earlier axis counts as longer.
        by_length.sort_by(|&a, &b| extent[b].total_cmp(&extent[a]));
        Self { by_length, offset: (SHIFT * number as f64).fract() }
    }

    /// The signed axis that a face looks along, as 0 to 5.
    pub(super) fn axis(normal: DVec3) -> usize {
        let strength = normal.abs();
        let axis = if strength.x >= strength.y && strength.x >= strength.z {
            0
        } else if strength.y >= strength.z {
            1
        } else {
            2
        };
        2 * axis + usize::from(normal[axis] < 0.0)
    }

    /// Texture coordinates of a point on a face along a signed axis.
    pub(super) fn coordinates(&self, point: DVec3, axis: usize) -> DVec2 {
        let grain = if self.by_length[0] == axis / 2 { self.by_length[1] } else { self.by_length[0] };
        let across = DVec3::AXES[grain];
        let facing = DVec3::AXES[axis / 2] * if axis.is_multiple_of(2) { 1.0 } else { -1.0 };
        // Rows of an image go down, so the way up is towards lower `v` (glTF 2.0, 3.8.3).
        DVec2::new(point.dot(across), -point.dot(facing.cross(across))) + self.offset
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Bay, cuboid};
    use super::*;

    /// A board of 2 m, upright.
    fn board() -> Solid {
        cuboid(Bay::new([0.0, 0.3], [0.0, 2.0], [0.0, 0.02]))
    }

    #[test]
    fn one_unit_is_a_metre_along_the_grain_of_every_face() {
        let projection = Projection::of_part(&board(), 3);
        for normal in [DVec3::Z, DVec3::NEG_Z, DVec3::X, DVec3::NEG_X] {
            let axis = Projection::axis(normal);
            let at = |y: f64| projection.coordinates(DVec3::new(0.1, y, 0.01), axis);
            assert!((at(1.5) - at(0.5)).abs().distance(DVec2::X) < 1e-12, "{normal}");
        }
    }

    #[test]
    fn images_are_not_mirrored() {
        let projection = Projection::of_part(&board(), 0);
        for axis in 0..6 {
            let origin = projection.coordinates(DVec3::ZERO, axis);
            let gradient = |towards: DVec3| projection.coordinates(towards, axis) - origin;
            let rows = [gradient(DVec3::X), gradient(DVec3::Y), gradient(DVec3::Z)];
            let direction =
                |component: usize| DVec3::new(rows[0][component], rows[1][component], rows[2][component]);
            let facing = DVec3::AXES[axis / 2] * if axis.is_multiple_of(2) { 1.0 } else { -1.0 };
            assert!(direction(0).cross(-direction(1)).distance(facing) < 1e-12, "axis {axis}");
        }
    }

    #[test]
    fn equal_parts_are_shifted() {
        let at = |number| Projection::of_part(&board(), number).coordinates(DVec3::ZERO, 4);
        assert!(at(0).distance(at(1)) > 0.1);
    }
}
