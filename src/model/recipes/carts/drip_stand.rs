//! Drip stands: 1.3 to 2.2 m high on five castors, 0.5 to 0.6 across.

use glam::DVec3;

use super::castor;
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, cylinder, sweep};
use crate::model::recipes::input::{Draft, GeometrySet};

/// A stand with bags that hang from hooks over five castors.
pub(in super::super) fn drip_stand(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let metal = if draft.set() == GeometrySet::Traditional { "painted" } else { "chrome" };
    let hub = 0.12_f64.min(height * 0.1);
    for leg in 0..5 {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * (f64::from(leg) / 5.0 + 0.25));
        let end = DVec3::new(cosine * (half.x - 0.028), hub * 0.6, sine * (half.z - 0.028));
        builder.add(metal, sweep(&[DVec3::new(0.0, hub, 0.0), end], 0.014, 6));
        castor(builder, DVec3::new(end.x, 0.0, end.z), hub * 0.55);
    }
    // The bounds of a star of five: a foot bar across closes the box.
    builder.cuboid(metal, Bay::around(DVec3::Y * hub * 0.9, bay.width(), 0.014, 0.02));
    builder.cuboid(metal, Bay::around(DVec3::Y * hub * 0.9, 0.0198, 0.0136, bay.depth()));
    builder.add(metal, cylinder(0.022, [hub * 0.7, hub * 1.5], 10));
    builder.add(metal, cylinder(0.015, [hub, height * 0.62], 8));
    builder.add(metal, cylinder(0.01, [height * 0.6, height - 0.03], 8));
    builder.add("plastic_dark", cylinder(0.026, [height * 0.59, height * 0.63], 8));
    for side in [-1.0, 1.0] {
        let hook = |x: f64, y: f64| DVec3::new(side * x, height + y, 0.0);
        let path = [hook(0.004, -0.05), hook(0.1, -0.05), hook(0.13, -0.02), hook(0.13, -0.007)];
        builder.add(metal, sweep(&path, 0.007, 6));
    }
    bags(builder, height, look);
    pump(builder, height);
}

/// One or two bags on the hooks, each with its hose.
fn bags(builder: &mut Builder, height: f64, look: usize) {
    for bag in 0..=look % 2 {
        let x = if bag == 0 { 0.1 } else { -0.1 };
        let hung = Bay::around(DVec3::new(x, height - 0.2, 0.0), 0.12, 0.26, 0.035);
        builder.rounded(if look < 2 { "glass" } else { "plastic" }, hung, DVec3::new(0.03, 0.03, 0.016), 2);
        builder.cuboid("paper", hung.inset(0.02, 0.07, 0.0).slab(Side::Front, 0.003).moved(0.0, 0.0, 0.0012));
        let hose = [
            DVec3::new(x, height - 0.32, 0.0),
            DVec3::new(x, height * 0.66, 0.01),
            DVec3::new(x * 0.4, height * 0.5, 0.03),
            DVec3::new(x * 0.5, height * 0.38, 0.03),
        ];
        builder.add("plastic", sweep(&hose, 0.004, 4));
    }
}

/// A pump on the pole: a screen over three keys.
fn pump(builder: &mut Builder, height: f64) {
    let pump = Bay::around(DVec3::new(0.0, height * 0.54, 0.055), 0.14, 0.17, 0.1);
    builder.block("plastic", pump, 0.01);
    let front = pump.with_z([pump.high.z - SINK, pump.high.z + 0.003]);
    builder
        .cuboid("screen", front.inset(0.02, 0.0, 0.0).with_y([pump.center().y + 0.01, pump.high.y - 0.02]));
    for key in front.inset(0.02, 0.0, 0.0).with_y([pump.low.y + 0.02, pump.low.y + 0.05]).columns(3, 0.012) {
        builder.cuboid("painted_accent", key);
    }
}
