//! Drip stands: 1.3 to 2.2 m high on five castors, 0.5 to 0.6 across.

use glam::DVec3;

use super::castor;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, lathe, pipe, sweep};
use crate::recipes::{Draft, Recipe, Slot};

/// A stand with bags that hang from hooks: on five castors; on a cast foot, with bottles; on a cross, with two pumps; on three
/// bent feet.
pub(in super::super) static DRIP_STAND: Recipe = Recipe::furniture("drip_stand", [0.45, 0.45, 1.9])
    .plain(chromed)
    .traditional(cast)
    .industrial(with_two_pumps)
    .budget(on_bent_feet);

fn chromed(draft: &Draft, builder: &mut Builder) {
    let high = builder.bay().height();
    star(builder, Slot::Chrome);
    pole(builder, Slot::Chrome);
    hooks(builder, Slot::Chrome, &[1.0, -1.0], 0.0);
    bags(builder, high, draft.form());
    pump(builder, high * 0.54);
}

fn cast(draft: &Draft, builder: &mut Builder) {
    cast_foot(builder);
    pole(builder, Slot::Painted);
    hooks(builder, Slot::Brass, &[1.0, -1.0], 0.0);
    bottles(builder, draft.form());
}

fn with_two_pumps(draft: &Draft, builder: &mut Builder) {
    let high = builder.bay().height();
    cross(builder);
    pole(builder, Slot::Metal);
    hooks(builder, Slot::Metal, &[1.0, -1.0], 0.0);
    hooks(builder, Slot::Metal, &[1.0, -1.0], std::f64::consts::FRAC_PI_2);
    bags(builder, high, draft.form());
    pump(builder, high * 0.6);
    pump(builder, high * 0.47);
    push_ring(builder);
}

fn on_bent_feet(draft: &Draft, builder: &mut Builder) {
    let high = builder.bay().height();
    three_feet(builder);
    pole(builder, Slot::Metal);
    hooks(builder, Slot::Plastic, &[1.0, -1.0], 0.0);
    bags(builder, high, draft.form() & 1);
}

/// Height of a stand's foot.
fn hub(bay: Bay) -> f64 {
    0.12_f64.min(bay.height() * 0.1)
}

/// Five legs on castors.
fn star(builder: &mut Builder, metal: Slot) {
    let bay = builder.bay();
    let (half, hub) = (bay.extent() / 2.0, hub(bay));
    for leg in 0..5 {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * (f64::from(leg) / 5.0 + 0.25));
        let end = DVec3::new(cosine * (half.x - 0.028), hub * 0.6, sine * (half.z - 0.028));
        builder.add(metal, sweep(&[DVec3::new(0.0, hub, 0.0), end], 0.014, 6));
        castor(builder, DVec3::new(end.x, 0.0, end.z), hub * 0.55);
    }
    // The bounds of a star of five: a foot bar across closes the box.
    builder.cuboid(metal, Bay::around(DVec3::Y * hub * 0.9, bay.width(), 0.014, 0.02));
    builder.cuboid(metal, Bay::around(DVec3::Y * hub * 0.9, 0.0198, 0.0136, bay.depth()));
}

/// A heavy round foot.
fn cast_foot(builder: &mut Builder) {
    let (bay, hub) = (builder.bay(), hub(builder.bay()));
    let profile = [(1.0, 0.0), (1.0, 0.1), (0.8, 0.3), (0.35, 0.55), (0.14, 0.9), (0.1, 1.3)];
    let foot = lathe(&profile.map(|(share, y)| (share * 0.5, y * hub)), 20);
    builder.add(Slot::MetalDark, foot.stretched(DVec3::new(bay.width(), 1.0, bay.depth())));
}

/// Two bars across each other, on four castors.
fn cross(builder: &mut Builder) {
    let (bay, hub) = (builder.bay(), hub(builder.bay()));
    let height = hub * 0.62;
    let bar = bay.with_y([height - 0.002, height + 0.03]);
    builder.cuboid(Slot::Metal, bar.with_z([-0.02, 0.02]));
    builder.cuboid(Slot::Metal, bar.with_x([-0.0198, 0.0198]).moved(0.0, 0.0005, 0.0));
    let reach = bay.extent() / 2.0 - DVec3::splat(0.04);
    for at in [DVec3::X * reach.x, DVec3::NEG_X * reach.x, DVec3::Z * reach.z, DVec3::NEG_Z * reach.z] {
        castor(builder, at, height);
    }
    builder.block(
        Slot::MetalDark,
        bar.with_x([-0.05, 0.05]).with_z([-0.05, 0.05]).moved(0.0, 0.025, 0.0),
        0.006,
    );
}

/// Three bent feet with caps of rubber.
fn three_feet(builder: &mut Builder) {
    let (bay, hub) = (builder.bay(), hub(builder.bay()));
    let half = bay.extent() / 2.0;
    let top = hub * 2.4;
    for (x, z) in [(0.0, 1.0), (-0.97, -0.95), (0.97, -0.95)] {
        let end = DVec3::new(x * (half.x - 0.012), 0.012, z * (half.z - 0.012));
        let knee = DVec3::new(end.x * 0.5, hub * 0.9, end.z * 0.5);
        builder.add(Slot::Metal, pipe(&[DVec3::new(0.0, top, 0.0), knee, end], 0.011, 0.1));
        builder.add(Slot::Rubber, cylinder(0.014, [0.0, 0.026], 8).moved(end.x * 0.99, 0.0, end.z * 0.99));
    }
    builder.add(Slot::Plastic, cylinder(0.024, [top - 0.05, top + 0.02], 10));
}

/// A pole that slides in another, with a clamp.
fn pole(builder: &mut Builder, metal: Slot) {
    let (hub, height) = (hub(builder.bay()), builder.bay().height());
    builder.add(metal, cylinder(0.022, [hub * 0.7, hub * 1.5], 10));
    builder.add(metal, cylinder(0.015, [hub, height * 0.62], 8));
    builder.add(metal, cylinder(0.01, [height * 0.6, height - 0.03], 8));
    builder.add(Slot::PlasticDark, cylinder(0.026, [height * 0.59, height * 0.63], 8));
}

/// Hooks at the top, to the sides and turned by an angle.
fn hooks(builder: &mut Builder, metal: Slot, sides: &[f64], turn: f64) {
    let height = builder.bay().height();
    for side in sides {
        let hook = |x: f64, y: f64| DVec3::new(side * x, height + y, 0.0);
        let path = [hook(0.004, -0.05), hook(0.1, -0.05), hook(0.13, -0.02), hook(0.13, -0.007)];
        builder.add(metal, sweep(&path, 0.007, 6).turned_y(turn).moved(0.0, -turn * 0.006, 0.0));
    }
}

/// Bottles that hang upside down in wire, with hoses of rubber.
fn bottles(builder: &mut Builder, look: usize) {
    let height = builder.bay().height();
    for bottle in 0..=look % 2 {
        let x = if bottle == 0 { 0.1 } else { -0.1 };
        let top = height - 0.075;
        let profile = [(0.014, -0.28), (0.016, -0.24), (0.045, -0.2), (0.045, -0.02), (0.03, 0.0)];
        let glass = lathe(&profile.map(|(radius, y)| (radius, top + y)), 10);
        builder.add(Slot::Glass, glass.moved(x, 0.0, 0.0));
        builder.add(Slot::Rubber, cylinder(0.017, [top - 0.3, top - 0.262], 8).moved(x, 0.0, 0.0));
        let bow = [(-0.046, -0.06), (-0.046, 0.01), (0.046, 0.01), (0.046, -0.06)];
        let bow = bow.map(|(side, y)| DVec3::new(x + side, top + y, 0.0));
        builder.add(Slot::Brass, sweep(&bow, 0.003, 4));
        let hose = [(1.0, -0.29), (1.0, -0.7), (0.4, -0.95), (0.5, -1.1)];
        let hose = hose.map(|(share, y)| DVec3::new(x * share, top + y * height * 0.55, 0.012));
        builder.add(Slot::Rubber, sweep(&hose, 0.004, 4));
    }
}

/// A ring to push by.
fn push_ring(builder: &mut Builder) {
    let bay = builder.bay();
    let y = bay.height() * 0.4;
    let at = |share: f64| {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * share);
        DVec3::new(cosine * 0.13, y, sine * 0.13)
    };
    let ring: Vec<DVec3> = (0..=10).map(|step| at(f64::from(step) / 10.6)).collect();
    builder.add(Slot::Rubber, sweep(&ring, 0.011, 6));
    builder.add(Slot::Metal, sweep(&[at(0.0), DVec3::new(0.0, y, 0.0), at(0.47)], 0.008, 6));
}

/// One or two bags on the hooks, each with its hose.
fn bags(builder: &mut Builder, height: f64, look: usize) {
    for bag in 0..=look % 2 {
        let x = if bag == 0 { 0.1 } else { -0.1 };
        let hung = Bay::around(DVec3::new(x, height - 0.2, 0.0), 0.12, 0.26, 0.035);
        builder.rounded(
            if look < 2 { Slot::Glass } else { Slot::Plastic },
            hung,
            DVec3::new(0.03, 0.03, 0.016),
            2,
        );
        builder.cuboid(
            Slot::Paper,
            hung.inset(0.02, 0.07, 0.0).slab(Side::Front, 0.003).moved(0.0, 0.0, 0.0012),
        );
        let hose = [
            DVec3::new(x, height - 0.32, 0.0),
            DVec3::new(x, height * 0.66, 0.01),
            DVec3::new(x * 0.4, height * 0.5, 0.03),
            DVec3::new(x * 0.5, height * 0.38, 0.03),
        ];
        builder.add(Slot::Plastic, sweep(&hose, 0.004, 4));
    }
}

/// A pump on the pole at a height: a screen over three keys.
fn pump(builder: &mut Builder, height: f64) {
    let pump = Bay::around(DVec3::new(0.0, height, 0.055), 0.14, 0.17, 0.1);
    builder.block(Slot::Plastic, pump, 0.01);
    let front = pump.with_z([pump.high.z - SINK, pump.high.z + 0.003]);
    builder.cuboid(
        Slot::Screen,
        front.inset(0.02, 0.0, 0.0).with_y([pump.center().y + 0.01, pump.high.y - 0.02]),
    );
    for key in front.inset(0.02, 0.0, 0.0).with_y([pump.low.y + 0.02, pump.low.y + 0.05]).columns(3, 0.012) {
        builder.cuboid(Slot::PaintedAccent, key);
    }
}
