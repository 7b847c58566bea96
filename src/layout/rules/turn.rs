//! How an agent turns at its parent (section 3.2: parallel, with a random offset, or towards the centre).

use std::f64::consts::{FRAC_PI_2, PI};

use crate::catalog::{Orientation, Turn};
use crate::geometry::Point;
use crate::layout::seed::Stream;

/// The facts that a turn depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bearing {
    /// The parent's angle.
    pub(crate) parent_angle: f64,
    /// Unit vector out of the side that is touched; zero above and below.
    pub(crate) outward: Point,
}

/// The angle of a unit vector as a front: at zero a front points to −y.
pub(crate) fn angle_of_front(front: Point) -> f64 {
    libm::atan2(front.y, front.x) + FRAC_PI_2
}

/// The angle that an orientation asks for. [`Turn::TowardsCenter`] is parallel here and corrected by
/// [`towards`] once the position is known.
pub(crate) fn angle(orientation: &Orientation, bearing: &Bearing, stream: &mut Stream) -> f64 {
    let straight = match orientation.turn {
        Turn::Parallel | Turn::TowardsCenter => bearing.parent_angle,
        Turn::AroundCorner => bearing.parent_angle - FRAC_PI_2,
        Turn::Facing if bearing.outward == Point::ZERO => bearing.parent_angle + PI,
        Turn::Facing => angle_of_front(-bearing.outward),
        Turn::Away if bearing.outward == Point::ZERO => bearing.parent_angle,
        Turn::Away => angle_of_front(bearing.outward),
        Turn::Quarter => bearing.parent_angle + FRAC_PI_2 * stream.below(4) as f64,
        Turn::Any => stream.between(0.0, 2.0 * PI),
    };
    straight + offset(orientation, stream)
}

/// The angle of an agent at `position` that looks at `center`, with its random offset.
pub(crate) fn towards(orientation: &Orientation, position: Point, center: Point, stream: &mut Stream) -> f64 {
    angle_of_front((center - position).normalize_or(Point::NEG_Y)) + offset(orientation, stream)
}

fn offset(orientation: &Orientation, stream: &mut Stream) -> f64 {
    if orientation.jitter > 0.0 { orientation.jitter * stream.signed() } else { 0.0 }
}
