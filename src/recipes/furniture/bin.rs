//! Waste bins.

use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, Solid, lathe, loft, loft_ring};
use crate::recipes::{Draft, Recipe, Slot};

/// Corners of a bin.
const ROUND: Outline = Outline::Round(16);

/// Corners of what is coarser.
const COARSE: Outline = Outline::Round(12);

/// A waste bin: with a pedal and a flat lid, on a foot with a domed lid, a drum with hoops, or a bucket, some with a
/// swing top. The look chooses its material.
pub(super) static BIN: Recipe = Recipe::accessory("bin", [0.3, 0.3, 0.4])
    .round()
    .plain(|draft, builder| with_pedal(builder, form(draft)))
    .traditional(|draft, builder| on_foot(builder, form(draft)))
    .industrial(|draft, builder| drum(builder, form(draft)))
    .budget(|draft, builder| bucket(builder, form(draft)));

fn form(draft: &Draft) -> usize {
    draft.sampler().count(0, 2) as usize
}

/// A slice of a bin at a share of its height, of a share of its width.
fn slice(bay: Bay, rise: f64, share: f64) -> Slice {
    Slice::new(bay.height() * rise, bay.width() / 2.0 * share, bay.depth() / 2.0 * share)
}

fn body(bay: Bay, outline: &Outline, profile: &[(f64, f64)]) -> Solid {
    let slices: Vec<Slice> = profile.iter().map(|&(rise, share)| slice(bay, rise, share)).collect();
    loft(outline, &slices)
}

fn with_pedal(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let slot = [Slot::Metal, Slot::Painted, Slot::PlasticDark][form];
    builder.add(slot, body(bay, &ROUND, &[(0.02, 0.94), (0.86, 0.94)]));
    builder.add(Slot::PlasticDark, body(bay, &ROUND, &[(0.0, 0.9), (0.02 + SINK, 0.9)]));
    let lid = body(bay, &ROUND, &[(0.87, 0.94), (0.98, 0.94), (1.0, 0.88)]);
    builder.add(if form == 0 { Slot::PlasticDark } else { slot }, lid);
    builder.add(Slot::MetalDark, body(bay, &ROUND, &[(0.86 - SINK, 0.9), (0.87 + SINK, 0.9)]));
    pedal(builder, bay);
}

/// On a foot, under a domed lid with a knob.
fn on_foot(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let slot = [Slot::Brass, Slot::WoodDark, Slot::Painted][form];
    let profile = [(0.0, 0.8), (0.05, 0.8), (0.1, 0.66), (0.4, 0.82), (0.7, 1.0), (0.76, 1.0)];
    builder.add(slot, body(bay, &COARSE, &profile));
    builder.add(slot, body(bay, &COARSE, &[(0.755, 0.92), (0.8, 0.9), (0.89, 0.5), (0.91, 0.2)]));
    let radius = bay.width() * 0.09;
    let (low, high) = (bay.height() * 0.9, bay.height());
    let knob = [(radius * 0.4, low), (radius, (low + high) / 2.0), (radius * 0.5, high)];
    builder.add(Slot::Brass, lathe(&knob, 6));
}

/// An open drum with hoops.
fn drum(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let slot = [Slot::Metal, Slot::MetalDark, Slot::PaintedAccent][form];
    builder.add(slot, body(bay, &COARSE, &[(0.0, 0.93), (1.0, 0.93), (1.0, 0.88), (0.04, 0.88)]));
    for rise in [0.3, 0.9] {
        let hoop =
            [(rise, 0.91), (rise, 1.0), (rise + 0.04, 0.91)].map(|(rise, share)| slice(bay, rise, share));
        builder.add(if form == 2 { Slot::Metal } else { slot }, loft_ring(&COARSE, &hoop));
    }
}

/// A bucket with a rim, the first with a lid that swings.
fn bucket(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let slot = if form == 1 { Slot::PlasticDark } else { Slot::Plastic };
    let top = if form == 0 { 0.74 } else { 1.0 };
    let (rim, open) = ([(top - 0.05, 0.97), (top - 0.05, 1.0)], [(top, 1.0), (top, 0.93)]);
    builder.add(slot, body(bay, &COARSE, &[&[(0.0, 0.7)][..], &rim, &open, &[(0.03, 0.65)]].concat()));
    if form == 0 {
        let lid = body(bay, &COARSE, &[(top - 0.01, 0.95), (0.92, 0.6), (1.0, 0.2)]);
        builder.add(Slot::PlasticDark, lid);
    }
}

/// What opens the lid, at the foot.
fn pedal(builder: &mut Builder, bay: Bay) {
    let (half, height) = (bay.depth() / 2.0, bay.height());
    builder.cuboid(
        Slot::MetalDark,
        Bay::new([-0.03, 0.03], [height * 0.03, height * 0.06], [half * 0.85, half]),
    );
}
