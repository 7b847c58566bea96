//! What stands on tables.

use glam::DVec3;

use super::input::{Draft, GeometrySet};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft, loft_ring, sweep};

/// Corners of plates, cups and bowls.
const SIDES: usize = 12;

/// A slice of a round body that fills a box, at a share of its height.
fn ring(bay: Bay, share: f64, shrink: f64) -> Slice {
    let half = bay.extent() / 2.0;
    let middle = bay.center();
    Slice::new(bay.low.y + share * bay.height(), half.x * shrink, half.z * shrink).at(middle.x, middle.z)
}

/// A round body through (share of the height, share of the radius) pairs.
fn turned(bay: Bay, profile: &[(f64, f64)]) -> crate::model::kit::Solid {
    turned_coarse(bay, profile, SIDES)
}

/// The same of another number of corners.
fn turned_coarse(bay: Bay, profile: &[(f64, f64)], sides: usize) -> crate::model::kit::Solid {
    let slices: Vec<Slice> = profile.iter().map(|&(share, shrink)| ring(bay, share, shrink)).collect();
    loft(&Outline::Round(sides), &slices)
}

/// A place setting on a mat: plate, fork on the left, knife on the right.
pub(super) fn plate(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let thick = (bay.height() * 0.12).min(0.003);
    let mat = draft.sampler().pick(&["fabric_light", "fabric_accent", "linen"]);
    builder.cuboid(mat, bay.slab(Side::Below, thick));
    let above = bay.without(Side::Below, thick - SINK);
    let side = bay.depth().min(bay.width() * 0.72) * 0.88;
    let dish = Bay::around(above.center(), side, above.height(), side);
    let profile = [(0.0, 0.55), (0.9, 0.98), (1.0, 1.0), (0.95, 0.94), (0.45, 0.66), (0.4, 0.6)];
    builder.add("ceramic", turned(dish, &profile));
    let rest = (bay.width() - side) / 2.0 - 0.004;
    let length = (side * 0.8).min(0.22);
    let place =
        above.slab(Side::Below, thick + SINK).with_z([-length / 2.0, length / 2.0]).inset(0.004, 0.0, 0.0);
    cutlery(builder, place.slab(Side::Left, rest), place.slab(Side::Right, rest));
}

/// A fork and a knife with their handles to the front.
fn cutlery(builder: &mut Builder, left: Bay, right: Bay) {
    let (length, thick) = (left.depth(), left.height());
    let fork = left.inset(left.width() * 0.28, 0.0, 0.0);
    let head = fork.slab(Side::Back, length * 0.34);
    let grip = fork.without(Side::Back, length * 0.34 - SINK).inset(fork.width() * 0.34, thick * 0.05, 0.0);
    builder.cuboid("chrome", grip);
    builder.cuboid("chrome", head.slab(Side::Front, length * 0.1));
    let tines = head.without(Side::Front, length * 0.1 - SINK).inset(0.0004, thick * 0.05, 0.0);
    tines.columns(3, fork.width() * 0.16).into_iter().for_each(|tine| builder.cuboid("chrome", tine));
    let knife = right.inset(right.width() * 0.3, 0.0, 0.0);
    builder.cuboid("chrome", knife.slab(Side::Front, length * 0.42).inset(knife.width() * 0.2, 0.0, 0.0));
    builder.cuboid("chrome", knife.without(Side::Front, length * 0.42 - SINK).inset(0.0, thick * 0.1, 0.0));
}

/// A drinking glass: a tumbler, or a wine glass where it is tall.
pub(super) fn glass(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    if bay.height() > bay.width() * 2.2 || (draft.is_traditional() && bay.height() > bay.width() * 1.6) {
        let stem = [
            (0.0, 0.8),
            (0.05, 0.12),
            (0.42, 0.12),
            (0.54, 0.6),
            (0.74, 1.0),
            (1.0, 0.8),
            (1.0, 0.76),
            (0.74, 0.94),
            (0.58, 0.5),
        ];
        builder.add("glass", turned(bay, &stem));
        let wine = [(0.585, 0.48), (0.7, 0.84), (0.71, 0.3)];
        builder.add(["book", "brass", "book", "fabric_accent"][look], turned(bay, &wine));
        return;
    }
    let profile: &[(f64, f64)] = match look {
        0 => &[(0.0, 0.8), (1.0, 1.0), (1.0, 0.93), (0.08, 0.73)],
        1 => &[(0.0, 0.98), (1.0, 1.0), (1.0, 0.92), (0.14, 0.88)],
        2 => &[(0.0, 0.72), (0.08, 0.62), (0.14, 0.78), (0.5, 0.96), (1.0, 1.0), (1.0, 0.93), (0.2, 0.7)],
        _ => &[(0.0, 0.7), (0.3, 0.92), (0.6, 1.0), (1.0, 0.9), (1.0, 0.83), (0.12, 0.64)],
    };
    builder.add("glass", turned(bay, profile));
    let drink = [(0.215, 0.6), (0.5, 0.68), (0.52, 0.3)];
    builder.add(["leather", "fabric_accent", "brass", "leaf"][look], turned(bay, &drink));
}

/// A bottle with a label and a cap: for wine, for beer or sauce, a flask with a broad shoulder, a carafe with a cork.
pub(super) fn bottle(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    // Below the shoulder, at the shoulder, the neck, all as (share of the height, share of the radius).
    let body: [(f64, f64); 7] = [
        [(0.0, 0.92), (0.02, 1.0), (0.58, 1.0), (0.66, 0.82), (0.74, 0.4), (0.94, 0.34), (0.97, 0.4)],
        [(0.0, 0.88), (0.03, 0.96), (0.4, 1.0), (0.56, 0.9), (0.8, 0.42), (0.93, 0.34), (0.95, 0.42)],
        [(0.0, 0.9), (0.02, 1.0), (0.7, 1.0), (0.78, 0.84), (0.8, 0.44), (0.9, 0.42), (0.92, 0.5)],
        [(0.0, 0.7), (0.06, 0.92), (0.22, 1.0), (0.4, 0.86), (0.62, 0.4), (0.86, 0.36), (0.92, 0.52)],
    ][look];
    // A label stands out a little.
    let body = body.map(|(share, shrink)| (share, shrink * if look == 3 { 1.0 } else { 0.984 }));
    let slots = match draft.set() {
        GeometrySet::Traditional => ["leaf", "glass", "terracotta", "glass"],
        GeometrySet::Industrial => ["glass", "metal", "glass", "metal_dark"],
        GeometrySet::Budget => ["plastic", "leaf", "plastic", "glass"],
        GeometrySet::Plain => ["leaf", "glass", "ceramic", "glass"],
    };
    builder.add(slots[look], turned(bay, &body));
    if look != 3 {
        let label = [(0.14, 1.0), (body[2].0 * 0.82, 1.0)];
        builder.add(["paper", "fabric_light", "paper"][look], turned(bay, &label));
    }
    let (rim, wide) = body[6];
    let cap = ["book", "metal", "brass", "wood_light"][look];
    builder.add(cap, turned(bay, &[(rim - 0.06, wide + 0.03), (0.99, wide + 0.03), (1.0, wide - 0.02)]));
}

/// A cup with a handle on the right: a mug, a tapered cup, one with a belly, or one of enamel with a dark rim.
pub(super) fn cup(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let handle = (bay.width() * 0.22).min(0.03);
    let body = bay.without(Side::Right, handle);
    let profile: [(f64, f64); 6] = [
        [(0.0, 0.94), (0.04, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.92), (0.08, 0.9)],
        [(0.0, 0.55), (0.06, 0.56), (0.4, 0.82), (1.0, 1.0), (1.0, 0.94), (0.12, 0.5)],
        [(0.0, 0.7), (0.2, 0.96), (0.5, 1.0), (1.0, 0.86), (1.0, 0.78), (0.12, 0.66)],
        [(0.0, 0.9), (0.02, 0.93), (0.5, 0.95), (1.0, 1.0), (1.0, 0.93), (0.06, 0.87)],
    ][look];
    let slots = match draft.set() {
        GeometrySet::Industrial => ["metal", "painted", "concrete", "painted_accent"],
        GeometrySet::Traditional => ["ceramic", "ceramic", "terracotta", "painted"],
        GeometrySet::Budget => ["plastic", "ceramic", "painted_accent", "plastic"],
        GeometrySet::Plain => ["ceramic", "painted_accent", "ceramic", "painted"],
    };
    builder.add(slots[look], turned(body, &profile));
    builder.add("soil", turned_coarse(body, &[(0.7, 0.6), (0.76, 0.66), (0.77, 0.3)], 8));
    if look == 3 {
        let rim = turned_rim(body);
        builder.add("metal_dark", rim);
    }
    let radius = handle * 0.16;
    let (left, right) =
        (body.high.x - body.width() * (1.0 - profile[2].1) * 0.5 - handle * 0.25, bay.high.x - radius);
    let point = |x: f64, share: f64| DVec3::new(x, bay.height() * share, 0.0);
    let path = [
        point(left, 0.78),
        point(right - radius, 0.74),
        point(right, 0.54),
        point(right - radius * 2.0, 0.36),
        point(left - handle * 0.2, 0.28),
    ];
    builder.add(slots[look], sweep(&path, radius, 6));
}

/// The dark edge of an enamel cup.
fn turned_rim(bay: Bay) -> crate::model::kit::Solid {
    let slices = [(0.965, 1.0), (0.985, 1.012), (0.985, 0.9), (0.965, 0.9)]
        .map(|(share, shrink)| ring(bay, share, shrink));
    loft_ring(&Outline::Round(6), &slices)
}

/// A bowl, with fruit where the look says so.
pub(super) fn bowl(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let has_fruit = sampler.chance(0.6);
    let dish = if has_fruit { bay.without(Side::Above, bay.height() * 0.25) } else { bay };
    let slot = sampler.pick(&["ceramic", "wood", "glass"]);
    builder.add(
        slot,
        turned(
            dish,
            &[(0.0, 0.45), (0.1, 0.45), (0.5, 0.85), (1.0, 1.0), (1.0, 0.95), (0.5, 0.8), (0.14, 0.4)],
        ),
    );
    if has_fruit {
        let radius = dish.width().min(dish.depth()) * 0.19;
        let places = [(0.42, 0.0), (-0.3, 0.4), (-0.25, -0.42)];
        for (index, (x, z)) in places.into_iter().enumerate() {
            let y = bay.high.y - radius * if index == 0 { 1.0 } else { 1.25 };
            let round = [(0.0, -1.0), (0.75, -0.65), (1.0, 0.0), (0.75, 0.65), (0.0, 1.0)];
            let fruit = lathe(&round.map(|(share, rise)| (share * radius, rise * radius)), 6);
            let slot = ["fabric_accent", "leaf", "book"][index];
            builder.add(slot, fruit.moved(x * dish.width() / 2.0, y, z * dish.depth() / 2.0));
        }
    }
}

/// A tray with a rim and two grips.
pub(super) fn tray(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let wall = 0.012_f64.min(half.x.min(half.z) * 0.2);
    let slice = |share: f64, back: f64| {
        Slice::new(height * share, half.x - back, half.z - back)
            .softened((half.x.min(half.z) * 0.25 - back).max(0.004))
    };
    let slices = [slice(0.0, wall), slice(1.0, 0.0), slice(1.0, wall * 0.7), slice(0.25, wall * 1.6)];
    let slot = draft.sampler().pick(&["wood", "metal", "plastic_dark"]);
    builder.add(slot, loft(&Outline::Soft(2), &slices));
}

/// A basket with two handles: woven, of wire or sheet, of plastic; with cloth in it where it is high, for laundry.
pub(super) fn basket(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let grip = bay.height() * 0.18;
    let body = bay.without(Side::Above, grip);
    let slot = match draft.set() {
        GeometrySet::Plain => ["wood_light", "fabric_light", "fabric", "wood_light"],
        GeometrySet::Traditional => ["wood_light", "wood", "wood_light", "wood_dark"],
        GeometrySet::Industrial => ["metal", "metal_dark", "metal", "wood"],
        GeometrySet::Budget => ["plastic", "painted_accent", "plastic_dark", "plastic"],
    }[look];
    let profile: &[(f64, f64)] = match draft.set() {
        GeometrySet::Budget => {
            &[(0.0, 0.8), (0.86, 0.95), (0.88, 1.0), (1.0, 1.0), (1.0, 0.92), (0.05, 0.76)]
        }
        GeometrySet::Industrial => {
            &[(0.0, 0.86), (0.04, 0.9), (0.93, 0.96), (0.94, 1.0), (1.0, 1.0), (1.0, 0.94), (0.05, 0.84)]
        }
        _ => &[
            (0.0, 0.78),
            (0.3, 0.9),
            (0.32, 0.88),
            (0.62, 0.97),
            (0.64, 0.95),
            (1.0, 1.0),
            (1.0, 0.92),
            (0.06, 0.7),
        ],
    };
    builder.add(slot, turned(body, profile));
    if bay.height() > bay.width() {
        let heap = [(0.7, 0.82), (0.92, 0.9), (1.02, 0.6), (1.06, 0.2)];
        builder.add("linen", turned_coarse(body, &heap, 6));
    }
    let radius = 0.007_f64.min(bay.width() * 0.04);
    let x = bay.high.x * 0.96 - radius;
    let (z, low) = (bay.depth() * 0.16, body.high.y - grip * 0.4);
    let point = |z: f64, y: f64| DVec3::new(x * 0.985, y, z);
    let bow = [
        point(-z, low),
        point(-z * 0.7, bay.high.y - radius),
        point(z * 0.7, bay.high.y - radius),
        point(z, low),
    ];
    let metal = if matches!(draft.set(), GeometrySet::Industrial) { "metal_dark" } else { "wood" };
    builder.add_pair(if draft.set() == GeometrySet::Budget { slot } else { metal }, sweep(&bow, radius, 4));
}
