//! Water taps.

use glam::DVec3;

use crate::model::kit::{Builder, SINK, cylinder, sweep};

/// Corners of the pipe.
const SIDES: usize = 6;

/// A mixer tap that stands on a surface at `foot`, is `height` metres high and reaches `reach` metres to the
/// front, with a lever on top.
pub(in super::super) fn tap(builder: &mut Builder, foot: DVec3, height: f64, reach: f64) {
    let radius = (height * 0.09).min(reach * 0.12);
    let lever = height * 0.06;
    let bend = height - lever * 2.0 - radius;
    let point = |y: f64, z: f64| foot + DVec3::new(0.0, y, z);
    let drop = bend - height * 0.14;
    let path =
        [point(-SINK, 0.0), point(bend, 0.0), point(bend, reach - radius), point(drop, reach - radius)];
    builder.add("chrome", sweep(&path, radius, SIDES));
    let stem = cylinder(radius * 0.6, [bend + radius * 0.5, height - lever + SINK], SIDES);
    builder.add("chrome", stem.moved(foot.x, foot.y, foot.z));
    let bar = crate::model::kit::Bay::around(
        point(height - lever / 2.0, reach * 0.15),
        radius * 1.4,
        lever,
        reach * 0.5,
    );
    builder.cuboid("chrome", bar);
}
