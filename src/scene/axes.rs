//! The crossing from plan axes to glTF axes, where (x, y, z) becomes (x, z, −y), and the way back.
//!
//! A turn by an angle counter-clockwise about the plan's z is a turn by the same angle about glTF's Y, so
//! that angles cross unchanged. A front that faces −y (south) at angle zero faces +Z afterwards.

use glam::{DQuat, DVec3, Quat, Vec3};

use crate::geometry::Point;

/// A place in the plan frame of a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    /// Metres.
    pub position: Point,
    /// Metres above the level's floor.
    pub elevation: f64,
    /// Radians counter-clockwise.
    pub angle: f64,
}

/// Angles closer to zero than this (radians) are no turn: below a tenth of a millimetre on 100 m.
const NO_TURN: f64 = 1e-6;

impl Pose {
    /// A place on the floor.
    pub(crate) fn on_floor(position: Point, angle: f64) -> Self {
        Self { position, elevation: 0.0, angle }
    }

    /// The same place as seen from `parent`, itself a place in the level.
    pub(crate) fn relative_to(&self, parent: &Self) -> Self {
        let (across, forth) = axes_at(parent.angle);
        let offset = self.position - parent.position;
        Self {
            position: Point::new(offset.dot(across), offset.dot(forth)),
            elevation: self.elevation - parent.elevation,
            angle: self.angle - parent.angle,
        }
    }

    /// The translation in glTF axes.
    pub(crate) fn translation(&self) -> Vec3 {
        cross(self.position, self.elevation)
    }

    /// The rotation in glTF axes, with `w ≥ 0`; exactly the identity where nothing turns, and exactly half a turn where it is one.
    pub(crate) fn rotation(&self) -> Quat {
        let turn = wrapped(self.angle);
        if turn.abs() < NO_TURN {
            return Quat::IDENTITY;
        }
        let (sine, cosine) = libm::sincos(turn / 2.0);
        // Half a turn has no cosine, whatever is left of it in the last digits.
        let cosine = if cosine.abs() < NO_TURN { 0.0 } else { cosine };
        Quat::from_xyzw(0.0, narrow(sine), 0.0, narrow(cosine))
    }
}

/// The plan's unit vectors of a frame turned by `angle`: its x (east at zero) and its y (north at zero).
pub(crate) fn axes_at(angle: f64) -> (Point, Point) {
    let (sine, cosine) = libm::sincos(angle);
    (Point::new(cosine, sine), Point::new(-sine, cosine))
}

/// The angle at which a front faces along `direction` (not zero).
pub(crate) fn angle_facing(direction: Point) -> f64 {
    libm::atan2(direction.x, -direction.y)
}

/// The angle at which a frame's x runs along `direction` (not zero).
pub(crate) fn angle_along(direction: Point) -> f64 {
    libm::atan2(direction.y, direction.x)
}

/// A plan point at a height above the floor, in glTF axes.
pub(crate) fn cross(point: Point, elevation: f64) -> Vec3 {
    Vec3::new(narrow(point.x), narrow(elevation), narrow(-point.y))
}

/// A point in glTF axes as one in those of the plan, z above the floor: the way back from [`cross`].
pub(crate) fn plan_point(point: DVec3) -> DVec3 {
    DVec3::new(point.x, -point.z, point.y)
}

/// The angle of a node that stands upright and whose x axis, in glTF axes, is `across`: the way back from [`Pose::rotation`].
pub(crate) fn plan_angle(across: DVec3) -> f64 {
    angle_along(plan_point(across).truncate())
}

/// Any turn in glTF axes as the same turn in those of the plan; `None` if it is no turn.
pub(crate) fn plan_rotation(rotation: DQuat) -> Option<DQuat> {
    let axis = plan_point(DVec3::new(rotation.x, rotation.y, rotation.z));
    let turned = DQuat::from_xyzw(axis.x, axis.y, axis.z, rotation.w);
    (turned.length_squared() > 0.0).then(|| turned.normalize())
}

/// To single precision, without a negative zero.
pub(crate) fn narrow(value: f64) -> f32 {
    value as f32 + 0.0
}

/// The same angle between −π (excluded) and π.
fn wrapped(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    let rest = angle.rem_euclid(TAU);
    if rest > PI { rest - TAU } else { rest }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    #[test]
    fn east_and_north_become_x_and_minus_z() {
        assert_eq!(cross(Point::new(1.0, 2.0), 3.0), Vec3::new(1.0, 3.0, -2.0));
        assert!(cross(Point::ZERO, 0.0).z.is_sign_positive());
    }

    #[test]
    fn a_front_to_the_south_faces_z_and_quarter_turns_follow() {
        let faces = |angle: f64| Pose::on_floor(Point::ZERO, angle).rotation() * Vec3::Z;
        let fronts = [
            (0.0, Vec3::Z),                 // south
            (FRAC_PI_2, Vec3::X),           // counter-clockwise: east
            (PI, Vec3::NEG_Z),              // north
            (3.0 * FRAC_PI_2, Vec3::NEG_X), // west
        ];
        for (angle, front) in fronts {
            assert!(faces(angle).distance(front) < 1e-6, "{angle}: {}", faces(angle));
        }
    }

    #[test]
    fn angle_facing_inverts_the_front() {
        for step in 0..16 {
            let angle = f64::from(step) * TAU / 16.0;
            let (_, north) = axes_at(angle);
            let found = angle_facing(-north);
            assert!(wrapped(found - angle).abs() < 1e-12, "{angle} {found}");
            let (east, _) = axes_at(angle);
            assert!(wrapped(angle_along(east) - angle).abs() < 1e-12);
        }
    }

    #[test]
    fn the_way_back_gives_the_pose() {
        let pose = Pose { position: Point::new(3.0, -1.0), elevation: 0.7, angle: 2.1 };
        assert!(plan_point(pose.translation().as_dvec3()).distance(DVec3::new(3.0, -1.0, 0.7)) < 1e-6);
        let rotation = pose.rotation().as_dquat();
        assert!((plan_angle(rotation * DVec3::X) - pose.angle).abs() < 1e-6);
        let turned = plan_rotation(rotation).unwrap() * DVec3::X;
        assert!(turned.truncate().distance(axes_at(pose.angle).0) < 1e-6 && turned.z.abs() < 1e-6);
        assert_eq!(plan_rotation(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)), None);
    }

    #[test]
    fn parent_and_relative_pose_give_the_pose_back() {
        let parent = Pose { position: Point::new(3.0, -1.0), elevation: 0.7, angle: 2.1 };
        let child = Pose { position: Point::new(3.4, -1.9), elevation: 0.9, angle: -0.4 };
        let relative = child.relative_to(&parent);
        let found = parent.translation() + parent.rotation() * relative.translation();
        assert!(found.distance(child.translation()) < 1e-5);
        let turned = parent.rotation() * relative.rotation();
        assert!(turned.dot(child.rotation()).abs() > 1.0 - 1e-6);
    }

    #[test]
    fn full_turns_are_no_turn() {
        assert_eq!(Pose::on_floor(Point::ZERO, TAU).rotation(), Quat::IDENTITY);
        assert_eq!(Pose::on_floor(Point::ZERO, -2.0 * TAU).rotation(), Quat::IDENTITY);
    }
}
