//! Umbrella stands: 0.22 to 0.28 m thick, 0.45 to 0.60 high; umbrellas 0.80 to 0.90 long, folded 0.06 thick.

use std::f64::consts::TAU;

use glam::DVec3;

use super::parts::slanted_leg;
use crate::recipes::kit::{Builder, Outline, Sampler, Slice, Solid, lathe, loft, loft_ring, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Radius of a folded umbrella as shares, from its tip to where its handle begins.
const FOLDED: [(f64, f64); 5] = [(0.14, 0.0), (0.2, 0.1), (0.95, 0.62), (1.0, 0.74), (0.25, 0.8)];

/// A stand with umbrellas: a slotted cylinder; cast iron with a ring over a drip tray; wire mesh; a square pot of plastic.
pub(super) static UMBRELLA_STAND: Recipe =
    Recipe::accessory("umbrella_stand", [0.25, 0.25, 0.6]).round().every_set(umbrella_stand);

fn umbrella_stand(draft: &Draft, builder: &mut Builder) {
    let mut sampler = draft.sampler();
    match draft.set() {
        GeometrySet::Plain => cylinder_with_ring(builder, &mut sampler),
        GeometrySet::Traditional => cast_iron(builder, &mut sampler),
        GeometrySet::Industrial => mesh(builder, &mut sampler),
        GeometrySet::Budget => square_pot(builder, &mut sampler),
    }
}

/// An umbrella that leans from the middle of the floor in a direction, with a curved handle.
fn umbrella(builder: &mut Builder, slot: Slot, turn: f64, top: f64, is_hooked: bool) {
    let radius = builder.bay().width() / 2.0;
    let (sine, cosine) = libm::sincos(turn);
    let out = DVec3::new(cosine, 0.0, sine);
    // The tips end inside the floor of the stand, at two heights.
    let tip = if is_hooked { 0.013 } else { 0.009 };
    let (foot, head) = (out * -radius * 0.35 + DVec3::Y * tip, out * radius * 0.5 + DVec3::Y * top);
    builder.add(slot, slanted_leg([foot, head], radius * 0.2, &FOLDED, 5));
    let along = |share: f64| foot.lerp(head, share);
    let start = along(0.79);
    if is_hooked {
        let across = DVec3::new(-sine, 0.0, cosine) * radius * 0.34;
        let end = along(1.0) - DVec3::Y * 0.012;
        let hook = [start, along(0.94), end + across * 0.45, along(0.95) + across];
        builder.add(Slot::WoodDark, sweep(&hook, 0.009, 4));
    } else {
        builder.add(Slot::WoodDark, sweep(&[start, along(0.985)], 0.013, 5));
    }
}

/// A round body of sheet, open above, through (share of the radius, height).
fn vessel(profile: &[(f64, f64)], radius: f64, sides: usize) -> Solid {
    let profile: Vec<(f64, f64)> = profile.iter().map(|&(share, y)| (share * radius, y)).collect();
    lathe(&profile, sides)
}

/// A ring around the axis at a height.
fn hoop(outer: f64, inner: f64, y: [f64; 2], sides: usize) -> Solid {
    let slices = [(outer, y[0]), (outer, y[1]), (inner, (y[0] + y[1]) / 2.0)]
        .map(|(radius, y)| Slice::round(y, radius));
    loft_ring(&Outline::Round(sides), &slices)
}

/// Points around the axis at even steps, as unit vectors.
fn around(count: u32, offset: f64) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |step| {
        let (sine, cosine) = libm::sincos(TAU * (f64::from(step) + offset) / f64::from(count));
        DVec3::new(cosine, 0.0, sine)
    })
}

/// A straight cylinder on a dark base, with a bright ring around its rim.
fn cylinder_with_ring(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let (radius, rim) = (bay.width() / 2.0, bay.height() * 0.7);
    let slot = sampler.pick(&[Slot::MetalDark, Slot::Painted, Slot::Metal]);
    builder.add(slot, vessel(&[(0.96, 0.012), (0.96, rim), (0.9, rim), (0.9, 0.03)], radius, 12));
    builder.add(Slot::PlasticDark, vessel(&[(1.0, 0.0), (1.0, 0.014)], radius, 12));
    builder.add(Slot::Chrome, hoop(radius, radius * 0.93, [rim * 0.9, rim * 0.94], 12));
    umbrella(builder, Slot::Fabric, sampler.between(0.0, 3.0), bay.high.y, true);
}

/// A tray on the floor, four bowed bars, and a ring above; ornaments where the bars meet it.
fn cast_iron(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let (radius, rim) = (bay.width() / 2.0, bay.height() * 0.78);
    let slot = sampler.pick(&[Slot::MetalDark, Slot::Brass]);
    let tray = [(0.86, 0.0), (1.0, 0.045), (0.92, 0.045), (0.8, 0.014)];
    builder.add(slot, vessel(&tray, radius, 10));
    builder.add(slot, hoop(radius * 0.9, radius * 0.76, [rim - 0.008, rim + 0.008], 8));
    for out in around(4, 0.5) {
        let at = |share: f64, y: f64| out * radius * share + DVec3::Y * y;
        let bar = [at(0.86, 0.02), at(0.56, rim * 0.45), at(0.82, rim), at(0.98, rim * 0.97)];
        builder.add(slot, sweep(&bar, 0.007, 3));
    }
    umbrella(
        builder,
        sampler.pick(&[Slot::Fabric, Slot::FabricAccent]),
        sampler.between(0.0, 3.0),
        bay.high.y,
        true,
    );
}

/// Wires crosswise between two hoops over a base.
fn mesh(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let (radius, rim) = (bay.width() / 2.0, bay.height() * 0.72);
    builder.add(Slot::MetalDark, vessel(&[(0.94, 0.0), (0.98, 0.02)], radius, 8));
    for (low, wide) in [(rim - 0.014, 1.0), (rim * 0.45, 0.97)] {
        builder.add(Slot::MetalDark, hoop(radius * wide, radius * (wide - 0.07), [low, low + 0.014], 8));
    }
    let wire = 0.0035;
    let places = |lean: f64| around(5, 0.25).zip(around(5, 0.25 + lean));
    for (foot, head) in places(0.9).chain(places(-0.9)) {
        let ends = [foot * radius * 0.9 + DVec3::Y * 0.015, head * radius * 0.92 + DVec3::Y * (rim - 0.004)];
        builder.add(Slot::Metal, sweep(&ends, wire, 3));
    }
    umbrella(builder, Slot::FabricAccent, sampler.between(0.0, 3.0), bay.high.y, true);
}

/// A pot of plastic with round corners, wider above, with a broad rim.
fn square_pot(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let (half, rim) = (bay.width() / 2.0, bay.height() * 0.62);
    let slice = |y: f64, share: f64| Slice::new(y, half * share, half * share).softened(half * share * 0.5);
    let slices = [
        slice(0.0, 0.74),
        slice(rim * 0.93, 0.92),
        slice(rim * 0.93, 1.0),
        slice(rim, 1.0),
        slice(rim, 0.88),
        slice(0.02, 0.68),
    ];
    let slot = sampler.pick(&[Slot::Plastic, Slot::PlasticDark, Slot::PaintedAccent]);
    builder.add(slot, loft(&Outline::Soft(2), &slices));
    let turn = sampler.between(0.0, 3.0);
    umbrella(builder, Slot::Fabric, turn, bay.high.y, true);
    umbrella(builder, Slot::FabricAccent, turn + 2.2, bay.high.y * 0.94, false);
}
