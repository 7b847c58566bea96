//! Plants.

use glam::DVec3;

use super::input::Draft;
use super::parts::{Foliage, grow, pot};
use crate::model::kit::{Builder, Outline, SINK, Slice, loft, sweep};

/// Share of a plant's height that the pot takes.
const POT_SHARE: f64 = 0.27;

/// A plant in a pot on the floor: a palm with a trunk, or a bush of broad leaves.
pub(super) fn plant(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let height = (bay.height() * POT_SHARE).min(0.4);
    let slot = sampler.pick(&["terracotta", "ceramic", "plastic_dark"]);
    pot(builder, slot, (radius * 0.62, height), 12);
    let rise = bay.height() - height;
    let is_palm = bay.height() > 1.0 && sampler.chance(0.5);
    let trunk = if is_palm { rise * sampler.between(0.35, 0.5) } else { 0.0 };
    if is_palm {
        let lean = sampler.between(-0.1, 0.1) * radius;
        let path = [
            DVec3::new(0.0, height * 0.8, 0.0),
            DVec3::new(lean, height + trunk * 0.5, lean),
            DVec3::new(0.0, height + trunk, 0.0),
        ];
        builder.add("wood_dark", sweep(&path, 0.02, 6));
    }
    let foliage = Foliage {
        root: DVec3::new(0.0, height * 0.88 + trunk, 0.0),
        count: if is_palm { 16 } else { 20 },
        spread: radius,
        height: rise - trunk + height * 0.12,
        half_width: radius * if is_palm { 0.13 } else { 0.26 },
        is_fine: true,
    };
    grow(builder, &mut sampler, &foliage);
}

/// A small plant for sills and desks.
pub(super) fn small_plant(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let height = bay.height() * 0.42;
    pot(builder, sampler.pick(&["ceramic", "terracotta", "painted_accent"]), (radius * 0.7, height), 8);
    let foliage = Foliage {
        root: DVec3::new(0.0, height * 0.85, 0.0),
        count: 9,
        spread: radius,
        height: bay.height() - height * 0.85,
        half_width: radius * sampler.between(0.16, 0.26),
        is_fine: false,
    };
    grow(builder, &mut sampler, &foliage);
}

/// A long trough with a row of plants.
pub(super) fn planter(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let height = bay.height() * 0.45;
    let half = bay.extent() / 2.0;
    let wall = 0.03_f64.min(half.x.min(half.z) * 0.2);
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back);
    let trough =
        [slice(0.0, wall * 0.6), slice(height, 0.0), slice(height, wall), slice(height * 0.7, wall * 1.2)];
    builder.add(sampler.pick(&["concrete", "wood", "terracotta"]), loft(&Outline::Square, &trough));
    builder
        .cuboid("soil", bay.with_y([height * 0.7 - SINK, height * 0.9]).inset(wall * 1.25, 0.0, wall * 1.25));
    let count = (bay.width() / bay.depth().max(0.05)).round().clamp(1.0, 5.0) as u32;
    for column in bay.columns(count, 0.0) {
        let spread = column.width().min(bay.depth()) / 2.0;
        let foliage = Foliage {
            root: DVec3::new(column.center().x, height * 0.88, 0.0),
            count: 9,
            spread,
            height: bay.height() - height * 0.88,
            half_width: spread * 0.2,
            is_fine: false,
        };
        grow(builder, &mut sampler, &foliage);
    }
}

/// A vase.
pub(super) fn vase(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let half = bay.extent() / 2.0;
    let belly = sampler.between(0.3, 0.6);
    let neck = sampler.between(0.4, 0.7);
    let slice = |share: f64, shrink: f64| Slice::new(share * bay.height(), half.x * shrink, half.z * shrink);
    let slices = [
        slice(0.0, 0.6),
        slice(belly * 0.6, 0.95),
        slice(belly, 1.0),
        slice(0.85, neck),
        slice(1.0, neck * 1.2),
        slice(1.0, neck),
        slice(0.8, neck * 0.8),
    ];
    builder.add(sampler.pick(&["ceramic", "glass", "terracotta"]), loft(&Outline::Round(12), &slices));
}
