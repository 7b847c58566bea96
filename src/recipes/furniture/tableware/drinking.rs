//! Glasses, cups and bottles.

use glam::DVec3;

use super::{Profile, ring, turned, turned_coarse};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, Solid, loft_ring, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A drinking glass: a tumbler, or a wine glass where it is tall.
pub(in super::super) static GLASS: Recipe = Recipe::accessory("glass", [0.07, 0.07, 0.12]).every_set(glass);

fn glass(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
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
        builder.add(Slot::Glass, turned(bay, &stem));
        let wine = [(0.585, 0.48), (0.7, 0.84), (0.71, 0.3)];
        builder.add([Slot::Book, Slot::Brass, Slot::Book, Slot::FabricAccent][look], turned(bay, &wine));
        return;
    }
    builder.add(Slot::Glass, turned(bay, tumbler(draft.set(), look)));
    let drink = [(0.215, 0.6), (0.5, 0.68), (0.52, 0.3)];
    builder.add([Slot::Leather, Slot::FabricAccent, Slot::Brass, Slot::Leaf][look], turned(bay, &drink));
}

/// The outline of a low glass: plain ones; on a heavy foot, where there is no room for a stem; jars and beakers; stacking
/// ones with ledges and rims.
fn tumbler(set: GeometrySet, look: usize) -> Profile {
    let profiles: [Profile; 4] = match set {
        GeometrySet::Plain => [
            &[(0.0, 0.8), (1.0, 1.0), (1.0, 0.93), (0.08, 0.73)],
            &[(0.0, 0.98), (1.0, 1.0), (1.0, 0.92), (0.14, 0.88)],
            &[(0.0, 0.72), (0.08, 0.62), (0.14, 0.78), (0.5, 0.96), (1.0, 1.0), (1.0, 0.93), (0.2, 0.7)],
            &[(0.0, 0.7), (0.3, 0.92), (0.6, 1.0), (1.0, 0.9), (1.0, 0.83), (0.12, 0.64)],
        ],
        GeometrySet::Traditional => [
            &[(0.0, 0.9), (0.06, 0.78), (0.2, 0.84), (1.0, 1.0), (1.0, 0.93), (0.2, 0.74)],
            &[(0.0, 0.8), (0.08, 0.64), (0.18, 0.9), (0.6, 0.92), (1.0, 1.0), (1.0, 0.93), (0.2, 0.74)],
            &[(0.0, 0.86), (0.1, 0.7), (0.22, 0.7), (0.4, 0.9), (1.0, 1.0), (1.0, 0.93), (0.2, 0.64)],
            &[(0.0, 0.94), (0.1, 0.94), (0.2, 0.78), (0.7, 1.0), (1.0, 0.96), (1.0, 0.89), (0.2, 0.68)],
        ],
        GeometrySet::Industrial => [
            &[(0.0, 0.94), (0.06, 1.0), (0.72, 1.0), (0.8, 0.84), (1.0, 0.84), (1.0, 0.77), (0.1, 0.88)],
            &[(0.0, 0.76), (0.55, 0.82), (0.62, 0.96), (1.0, 1.0), (1.0, 0.93), (0.1, 0.68)],
            &[(0.0, 0.66), (0.6, 0.88), (0.7, 1.0), (0.8, 0.92), (1.0, 0.96), (1.0, 0.89), (0.1, 0.6)],
            &[(0.0, 0.84), (0.05, 0.9), (0.88, 0.88), (1.0, 1.0), (1.0, 0.9), (0.86, 0.8), (0.08, 0.82)],
        ],
        GeometrySet::Budget => [
            &[(0.0, 0.66), (0.94, 0.9), (0.94, 1.0), (1.0, 1.0), (1.0, 0.86), (0.06, 0.62)],
            &[(0.0, 0.72), (0.45, 0.8), (0.48, 0.9), (0.96, 0.96), (1.0, 1.0), (1.0, 0.9), (0.07, 0.67)],
            &[
                (0.0, 0.86),
                (0.3, 0.86),
                (0.34, 1.0),
                (0.74, 1.0),
                (0.78, 0.94),
                (1.0, 0.94),
                (1.0, 0.87),
                (0.1, 0.78),
            ],
            &[(0.0, 0.62), (0.12, 0.68), (1.0, 1.0), (1.0, 0.92), (0.14, 0.62)],
        ],
    };
    profiles[look]
}

/// A bottle with a label and a cap: for wine, for beer or sauce, a flask with a broad shoulder, a carafe with a cork.
pub(in super::super) static BOTTLE: Recipe = Recipe::accessory("bottle", [0.08, 0.08, 0.3]).every_set(bottle);

fn bottle(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let body = flask(draft.set(), look);
    // A label stands out a little.
    let body = body.map(|(share, shrink)| (share, shrink * if look == 3 { 1.0 } else { 0.984 }));
    let slots = match draft.set() {
        GeometrySet::Traditional => [Slot::Leaf, Slot::Glass, Slot::Terracotta, Slot::Glass],
        GeometrySet::Industrial => [Slot::Glass, Slot::Metal, Slot::Glass, Slot::MetalDark],
        GeometrySet::Budget => [Slot::Plastic, Slot::Leaf, Slot::Plastic, Slot::Glass],
        GeometrySet::Plain => [Slot::Leaf, Slot::Glass, Slot::Ceramic, Slot::Glass],
    };
    builder.add(slots[look], turned(bay, &body));
    if look != 3 {
        let label = [(0.14, 1.0), (body[2].0 * 0.82, 1.0)];
        builder.add([Slot::Paper, Slot::FabricLight, Slot::Paper][look], turned(bay, &label));
    }
    let (rim, wide) = body[6];
    let cap = [Slot::Book, Slot::Metal, Slot::Brass, Slot::WoodLight][look];
    builder.add(cap, turned(bay, &[(rim - 0.06, wide + 0.03), (0.99, wide + 0.03), (1.0, wide - 0.02)]));
}

/// The outline of a bottle: below the shoulder, at the shoulder, the neck. Straight from the second to the third pair but in
/// the fourth look, for a label; bottles for wine and water, those of chemists and decanters, jugs and canisters, and what
/// is blown of plastic.
fn flask(set: GeometrySet, look: usize) -> [(f64, f64); 7] {
    let flasks: [[(f64, f64); 7]; 4] = match set {
        GeometrySet::Plain => [
            [(0.0, 0.92), (0.02, 1.0), (0.58, 1.0), (0.66, 0.82), (0.74, 0.4), (0.94, 0.34), (0.97, 0.4)],
            [(0.0, 0.88), (0.03, 0.96), (0.4, 1.0), (0.56, 0.9), (0.8, 0.42), (0.93, 0.34), (0.95, 0.42)],
            [(0.0, 0.9), (0.02, 1.0), (0.7, 1.0), (0.78, 0.84), (0.8, 0.44), (0.9, 0.42), (0.92, 0.5)],
            [(0.0, 0.7), (0.06, 0.92), (0.22, 1.0), (0.4, 0.86), (0.62, 0.4), (0.86, 0.36), (0.92, 0.52)],
        ],
        GeometrySet::Traditional => [
            [(0.0, 0.94), (0.02, 1.0), (0.4, 1.0), (0.56, 0.74), (0.72, 0.42), (0.94, 0.34), (0.97, 0.42)],
            [(0.0, 0.96), (0.03, 1.0), (0.34, 1.0), (0.46, 0.7), (0.6, 0.36), (0.9, 0.32), (0.93, 0.5)],
            [(0.0, 0.92), (0.02, 1.0), (0.52, 1.0), (0.62, 0.8), (0.66, 0.5), (0.88, 0.48), (0.92, 0.6)],
            [(0.0, 0.9), (0.05, 1.0), (0.14, 0.98), (0.5, 0.5), (0.66, 0.34), (0.86, 0.34), (0.92, 0.56)],
        ],
        GeometrySet::Industrial => [
            [(0.0, 0.95), (0.02, 1.0), (0.66, 1.0), (0.78, 0.8), (0.84, 0.5), (0.93, 0.48), (0.96, 0.56)],
            [(0.0, 0.95), (0.02, 1.0), (0.76, 1.0), (0.8, 0.9), (0.82, 0.5), (0.92, 0.48), (0.95, 0.55)],
            [(0.0, 0.9), (0.02, 1.0), (0.5, 1.0), (0.62, 0.84), (0.7, 0.64), (0.9, 0.64), (0.94, 0.74)],
            [(0.0, 0.94), (0.03, 1.0), (0.6, 1.0), (0.74, 0.92), (0.8, 0.7), (0.88, 0.68), (0.92, 0.72)],
        ],
        GeometrySet::Budget => [
            [(0.0, 0.8), (0.05, 1.0), (0.54, 1.0), (0.7, 0.9), (0.84, 0.44), (0.94, 0.3), (0.97, 0.36)],
            [(0.0, 0.9), (0.03, 0.98), (0.62, 1.0), (0.72, 0.96), (0.8, 0.6), (0.93, 0.4), (0.95, 0.46)],
            [(0.0, 0.8), (0.06, 1.0), (0.42, 1.0), (0.6, 0.78), (0.8, 0.6), (0.9, 0.5), (0.92, 0.6)],
            [(0.0, 0.6), (0.1, 0.8), (0.3, 1.0), (0.56, 1.0), (0.74, 0.6), (0.86, 0.5), (0.92, 0.6)],
        ],
    };
    flasks[look]
}

/// A cup with a handle on the right: a mug, a tapered cup, one with a belly, or one of enamel with a dark rim.
pub(in super::super) static CUP: Recipe = Recipe::accessory("cup", [0.1, 0.08, 0.09]).every_set(cup);

fn cup(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let handle = (bay.width() * 0.22).min(0.03);
    let body = bay.without(Side::Right, handle);
    let profile = mug(draft.set(), look);
    let slots = match draft.set() {
        GeometrySet::Industrial => [Slot::Metal, Slot::Painted, Slot::Concrete, Slot::PaintedAccent],
        GeometrySet::Traditional => [Slot::Ceramic, Slot::Ceramic, Slot::Terracotta, Slot::Painted],
        GeometrySet::Budget => [Slot::Plastic, Slot::Ceramic, Slot::PaintedAccent, Slot::Plastic],
        GeometrySet::Plain => [Slot::Ceramic, Slot::PaintedAccent, Slot::Ceramic, Slot::Painted],
    };
    builder.add(slots[look], turned(body, &profile));
    builder.add(Slot::Soil, turned_coarse(body, &[(0.7, 0.6), (0.76, 0.66), (0.77, 0.3)], 8));
    if look == 3 {
        let rim = turned_rim(body);
        builder.add(Slot::MetalDark, rim);
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

/// The outline of a cup, six pairs of which the third is halfway up: mugs; bells and tulips on a foot; straight and
/// chamfered ones; stacking ones with a step.
fn mug(set: GeometrySet, look: usize) -> [(f64, f64); 6] {
    let mugs: [[(f64, f64); 6]; 4] = match set {
        GeometrySet::Plain => [
            [(0.0, 0.94), (0.04, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.92), (0.08, 0.9)],
            [(0.0, 0.55), (0.06, 0.56), (0.4, 0.82), (1.0, 1.0), (1.0, 0.94), (0.12, 0.5)],
            [(0.0, 0.7), (0.2, 0.96), (0.5, 1.0), (1.0, 0.86), (1.0, 0.78), (0.12, 0.66)],
            [(0.0, 0.9), (0.02, 0.93), (0.5, 0.95), (1.0, 1.0), (1.0, 0.93), (0.06, 0.87)],
        ],
        GeometrySet::Traditional => [
            [(0.0, 0.54), (0.08, 0.44), (0.5, 0.86), (1.0, 1.0), (1.0, 0.95), (0.14, 0.38)],
            [(0.0, 0.5), (0.1, 0.44), (0.45, 0.92), (1.0, 1.0), (1.0, 0.94), (0.16, 0.4)],
            [(0.0, 0.6), (0.06, 0.5), (0.55, 0.76), (1.0, 1.0), (1.0, 0.94), (0.12, 0.42)],
            [(0.0, 0.66), (0.12, 0.62), (0.5, 0.92), (1.0, 1.0), (1.0, 0.93), (0.16, 0.56)],
        ],
        GeometrySet::Industrial => [
            [(0.0, 1.0), (0.06, 1.0), (0.5, 0.94), (1.0, 0.88), (1.0, 0.8), (0.08, 0.9)],
            [(0.0, 0.92), (0.05, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.92), (0.1, 0.9)],
            [(0.0, 0.72), (0.18, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.86), (0.2, 0.8)],
            [(0.0, 1.0), (0.04, 1.0), (0.5, 0.88), (1.0, 1.0), (1.0, 0.93), (0.06, 0.7)],
        ],
        GeometrySet::Budget => [
            [(0.0, 0.72), (0.36, 0.76), (0.44, 0.96), (1.0, 1.0), (1.0, 0.92), (0.1, 0.66)],
            [(0.0, 0.72), (0.05, 0.74), (0.5, 0.88), (1.0, 1.0), (1.0, 0.93), (0.08, 0.66)],
            [(0.0, 1.0), (0.3, 1.0), (0.5, 0.9), (1.0, 0.9), (1.0, 0.82), (0.1, 0.78)],
            [(0.0, 0.68), (0.28, 0.7), (0.36, 0.92), (1.0, 1.0), (1.0, 0.93), (0.08, 0.6)],
        ],
    };
    mugs[look]
}

/// The dark edge of an enamel cup.
fn turned_rim(bay: Bay) -> Solid {
    let slices = [(0.965, 1.0), (0.985, 1.012), (0.985, 0.9), (0.965, 0.9)]
        .map(|(share, shrink)| ring(bay, share, shrink));
    loft_ring(&Outline::Round(6), &slices)
}
