//! What stands on tables.

use glam::DVec3;

use super::input::Draft;
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft, sweep};

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
    let slices: Vec<Slice> = profile.iter().map(|&(share, shrink)| ring(bay, share, shrink)).collect();
    loft(&Outline::Round(SIDES), &slices)
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
pub(super) fn glass(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    if bay.height() > bay.width() * 2.2 {
        let stem = [
            (0.0, 0.8),
            (0.02, 0.75),
            (0.05, 0.12),
            (0.45, 0.12),
            (0.55, 0.6),
            (0.75, 1.0),
            (1.0, 0.8),
            (1.0, 0.76),
            (0.75, 0.94),
            (0.58, 0.55),
        ];
        builder.add("glass", turned(bay, &stem));
    } else {
        builder.add("glass", turned(bay, &[(0.0, 0.8), (1.0, 1.0), (1.0, 0.93), (0.08, 0.73)]));
    }
}

/// A bottle with a label and a cap.
pub(super) fn bottle(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let shoulder = sampler.between(0.5, 0.62);
    let body = [
        (0.0, 0.9),
        (0.03, 0.98),
        (shoulder, 0.98),
        (shoulder + 0.14, 0.4),
        (0.93, 0.32),
        (0.94, 0.36),
        (0.97, 0.36),
    ];
    builder.add(sampler.pick(&["glass", "leaf", "plastic"]), turned(bay, &body));
    builder.add(
        "paper",
        turned(
            bay,
            &[(0.18, 0.99), (0.18 + SINK, 1.0), (shoulder * 0.8, 1.0), (shoulder * 0.8 + SINK, 0.99)],
        ),
    );
    builder.add(sampler.pick(&["metal_dark", "book"]), turned(bay, &[(0.94, 0.4), (1.0, 0.4)]));
}

/// A cup with a handle on the right.
pub(super) fn cup(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let handle = (bay.width() * 0.22).min(0.03);
    let body = bay.without(Side::Right, handle);
    let slot = draft.sampler().pick(&["ceramic", "painted_accent"]);
    builder.add(
        slot,
        turned(body, &[(0.0, 0.75), (0.15, 0.9), (0.6, 1.0), (1.0, 1.0), (1.0, 0.92), (0.12, 0.78)]),
    );
    let radius = handle * 0.16;
    let (left, right) = (body.high.x - handle * 0.25, bay.high.x - radius);
    let point = |x: f64, share: f64| DVec3::new(x, bay.height() * share, 0.0);
    let path = [
        point(left, 0.78),
        point(right - radius, 0.72),
        point(right, 0.52),
        point(right - radius * 2.0, 0.32),
        point(left, 0.24),
    ];
    builder.add(slot, sweep(&path, radius, 6));
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

/// A woven basket with two handles.
pub(super) fn basket(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let grip = bay.height() * 0.18;
    let body = bay.without(Side::Above, grip);
    let slot = draft.sampler().pick(&["wood_light", "fabric_light"]);
    builder.add(
        slot,
        turned(
            body,
            &[
                (0.0, 0.78),
                (0.3, 0.9),
                (0.32, 0.88),
                (0.62, 0.97),
                (0.64, 0.95),
                (1.0, 1.0),
                (1.0, 0.92),
                (0.06, 0.7),
            ],
        ),
    );
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
    builder.add_pair("wood", sweep(&bow, radius, 6));
}
