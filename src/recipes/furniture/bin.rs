//! Waste bins.

use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft, loft_ring};
use crate::recipes::{Draft, GeometrySet, Recipe};

/// Corners of a bin.
const ROUND: Outline = Outline::Round(16);

/// A waste bin: with a pedal and a flat lid, on a foot with a domed lid, a drum with hoops, or a bucket, some with a
/// swing top. The look chooses its material.
pub(super) static BIN: Recipe = Recipe::accessory("bin", [0.3, 0.3, 0.4]).round().every_set(bin);

fn bin(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.sampler().count(0, 2) as usize;
    let slice = |rise: f64, share: f64| {
        Slice::new(bay.height() * rise, bay.width() / 2.0 * share, bay.depth() / 2.0 * share)
    };
    match draft.set() {
        GeometrySet::Plain => {
            let slot = ["metal", "painted", "plastic_dark"][form];
            builder.add(slot, loft(&ROUND, &[slice(0.02, 0.94), slice(0.86, 0.94)]));
            builder.add("plastic_dark", loft(&ROUND, &[slice(0.0, 0.9), slice(0.02 + SINK, 0.9)]));
            let lid = [slice(0.87, 0.94), slice(0.98, 0.94), slice(1.0, 0.88)];
            builder.add(if form == 0 { "plastic_dark" } else { slot }, loft(&ROUND, &lid));
            builder.add("metal_dark", loft(&ROUND, &[slice(0.86 - SINK, 0.9), slice(0.87 + SINK, 0.9)]));
            pedal(builder, bay);
        }
        GeometrySet::Traditional => {
            let slot = ["brass", "wood_dark", "painted"][form];
            let body = [
                slice(0.0, 0.8),
                slice(0.05, 0.8),
                slice(0.1, 0.66),
                slice(0.4, 0.82),
                slice(0.7, 1.0),
                slice(0.76, 1.0),
            ];
            builder.add(slot, loft(&Outline::Round(12), &body));
            let lid = [slice(0.755, 0.92), slice(0.8, 0.9), slice(0.89, 0.5), slice(0.91, 0.2)];
            builder.add(slot, loft(&Outline::Round(12), &lid));
            let radius = bay.width() * 0.09;
            let (low, high) = (bay.height() * 0.9, bay.height());
            let knob = [(radius * 0.4, low), (radius, (low + high) / 2.0), (radius * 0.5, high)];
            builder.add("brass", lathe(&knob, 6));
        }
        GeometrySet::Industrial => {
            let slot = ["metal", "metal_dark", "painted_accent"][form];
            let open = [slice(0.0, 0.93), slice(1.0, 0.93), slice(1.0, 0.88), slice(0.04, 0.88)];
            builder.add(slot, loft(&Outline::Round(12), &open));
            for rise in [0.3, 0.9] {
                let hoop = [slice(rise, 0.91), slice(rise, 1.0), slice(rise + 0.04, 0.91)];
                builder.add(if form == 2 { "metal" } else { slot }, loft_ring(&Outline::Round(12), &hoop));
            }
        }
        GeometrySet::Budget => {
            let slot = ["plastic", "plastic_dark", "plastic"][form];
            let top = if form == 0 { 0.74 } else { 1.0 };
            let open = [
                slice(0.0, 0.7),
                slice(top - 0.05, 0.97),
                slice(top - 0.05, 1.0),
                slice(top, 1.0),
                slice(top, 0.93),
                slice(0.03, 0.65),
            ];
            builder.add(slot, loft(&Outline::Round(12), &open));
            if form == 0 {
                let lid = [slice(top - 0.01, 0.95), slice(0.92, 0.6), slice(1.0, 0.2)];
                builder.add("plastic_dark", loft(&Outline::Round(12), &lid));
            }
        }
    }
}

/// What opens the lid, at the foot.
fn pedal(builder: &mut Builder, bay: Bay) {
    let (half, height) = (bay.depth() / 2.0, bay.height());
    builder
        .cuboid("metal_dark", Bay::new([-0.03, 0.03], [height * 0.03, height * 0.06], [half * 0.85, half]));
}
