//! Urinals.

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, lathe, loft, sweep};
use crate::recipes::{Recipe, Slot, Symbol};

/// A urinal on a wall: a shell with its flush in the wall, one with a hood and a brass pipe, a trough of steel, or a
/// bowl before a shield with a pipe.
pub(super) static URINAL: Recipe = Recipe::furniture("urinal", [0.4, 0.36, 0.7])
    .symbol(Symbol::Basin)
    .plain(|_, builder| shell(builder))
    .traditional(|_, builder| hooded(builder))
    .industrial(|_, builder| trough(builder))
    .budget(|_, builder| shielded(builder));

/// Slices of a bowl against the wall: at a height, of a share of the half width, reaching a share of the depth out.
fn outside(bay: Bay, y: f64, x: f64, reach: f64) -> Slice {
    let (half, depth) = (bay.width() / 2.0 * x, bay.depth() * reach / 2.0);
    Slice::new(y, half, depth).at(0.0, bay.low.z + depth).softened(half * 0.6)
}

/// The same of its hollow, which begins a share of the depth before the wall.
fn inside(bay: Bay, y: f64, x: f64, [from, to]: [f64; 2]) -> Slice {
    let (half, depth) = (bay.width() / 2.0 * x, bay.depth() * (to - from) / 2.0);
    Slice::new(y, half, depth).at(0.0, bay.low.z + bay.depth() * from + depth).softened(half * 0.5)
}

/// A bowl with a hollow, up to a height.
fn bowl(builder: &mut Builder, bay: Bay, rim: f64) {
    let slices = [
        outside(bay, 0.0, 0.45, 0.5),
        outside(bay, rim * 0.45, 0.85, 0.85),
        outside(bay, rim * 0.9, 1.0, 1.0),
        outside(bay, rim, 1.0, 1.0),
        inside(bay, rim, 0.8, [0.28, 0.9]),
        inside(bay, rim * 0.4, 0.55, [0.28, 0.63]),
    ];
    builder.add(Slot::Ceramic, loft(&Outline::Soft(2), &slices));
}

/// Smooth from below to the top, open to the front and above; a plate with a sensor over it.
fn shell(builder: &mut Builder) {
    let bay = builder.bay();
    let top = bay.height() * 0.84;
    let slices = [
        outside(bay, 0.0, 0.62, 0.66),
        outside(bay, top * 0.3, 0.9, 0.94),
        outside(bay, top * 0.62, 1.0, 1.0),
        outside(bay, top, 0.94, 0.62),
        inside(bay, top - 0.002, 0.8, [0.1, 0.54]),
        inside(bay, top * 0.4, 0.7, [0.16, 0.7]),
        inside(bay, top * 0.26, 0.4, [0.24, 0.6]),
    ];
    builder.add(Slot::Ceramic, loft(&Outline::Soft(2), &slices));
    let plate = bay.slab(Side::Back, 0.012).with_y([top + bay.height() * 0.03, bay.high.y]);
    builder.block(Slot::Chrome, plate.inset(bay.width() * 0.32, 0.0, 0.0), 0.003);
    let eye = Bay::around(DVec3::new(0.0, plate.center().y, plate.high.z), 0.04, 0.02, 0.006);
    builder.cuboid(Slot::Screen, eye);
}

/// A bowl under a tall round hood, a pipe of brass with a valve above.
fn hooded(builder: &mut Builder) {
    let bay = builder.bay();
    let top = bay.height() * 0.8;
    bowl(builder, bay.inset(0.004, 0.0, 0.0), top * 0.5);
    // An arch seen from the front, drawn outwards from the wall; hollow, so a ring of staves.
    let half = bay.width() / 2.0;
    let low = top * 0.45;
    // A half circle, or less high where the box is wide.
    let rise = half.min((top - low) * 0.9);
    let arch = |share: f64, turn: f64| {
        let (sine, cosine) = libm::sincos(turn);
        DVec2::new(half * share * cosine, top - rise + rise * share * sine)
    };
    let turns: Vec<f64> = (0..=8).map(|step| std::f64::consts::PI * f64::from(step) / 8.0).collect();
    let outer = turns.iter().map(|&turn| arch(1.0, turn));
    let inner = turns.iter().rev().map(|&turn| arch(0.84, turn));
    let outline: Vec<DVec2> = [DVec2::new(half, low)]
        .into_iter()
        .chain(outer)
        .chain([DVec2::new(-half, low), DVec2::new(-half * 0.84, low)])
        .chain(inner)
        .chain([DVec2::new(half * 0.84, low)])
        .collect();
    let back = bay.low.z;
    builder.add(Slot::Ceramic, extrude(&outline, Axis::Z, [back + 0.002, back + bay.depth() * 0.62]));
    let field = bay.slab(Side::Back, bay.depth() * 0.12).with_y([low, top - rise * 0.6]);
    builder.cuboid(Slot::Ceramic, field.inset(bay.width() * 0.06, 0.003, 0.0).without(Side::Back, 0.001));
    let z = back + 0.05_f64.min(bay.depth() * 0.2);
    builder.add(Slot::Brass, cylinder(0.012, [top - 0.02, bay.high.y], 8).moved(0.0, 0.0, z));
    let y = top + (bay.high.y - top) * 0.5;
    let valve = [(0.02, -0.02), (0.032, -0.01), (0.032, 0.01), (0.02, 0.02)];
    builder.add(Slot::Brass, lathe(&valve, 8).moved(0.0, y, z));
    builder.cuboid(Slot::Brass, Bay::around(DVec3::new(0.0, y, back), 0.016, 0.014, 0.0).with_z([back, z]));
    builder.add(
        Slot::WoodDark,
        turned_forward(lathe(&[(0.008, 0.0), (0.014, 0.05), (0.008, 0.06)], 8)).moved(0.0, y, z),
    );
}

/// A trough of sheet with a high back and a bare pipe.
fn trough(builder: &mut Builder) {
    let bay = builder.bay();
    let (low, high) = (bay.low.z, bay.high.z);
    let at = |depth: f64, rise: f64| DVec2::new(low + (high - low) * depth, bay.height() * rise);
    let side = [
        at(0.0, 0.0),
        at(0.5, 0.0),
        at(1.0, 0.36),
        at(1.0, 0.44),
        at(0.42, 0.62),
        at(0.12, 0.86),
        at(0.0, 0.86),
    ];
    let wide = bay.width() / 2.0;
    for end in [-1.0, 1.0] {
        let mut ends = [end * wide, end * (wide - 0.014)];
        ends.sort_by(f64::total_cmp);
        builder.add(Slot::Metal, extrude(&side, Axis::X, ends));
    }
    // The sheet between the sides, bent like them.
    let bent = [
        at(0.02, 0.02),
        at(0.48, 0.02),
        at(0.97, 0.37),
        at(0.97, 0.42),
        at(0.9, 0.42),
        at(0.9, 0.4),
        at(0.44, 0.08),
        at(0.1, 0.16),
        at(0.08, 0.84),
        at(0.02, 0.84),
    ];
    builder.add(Slot::Metal, extrude(&bent, Axis::X, [SINK * 2.0 - wide + 0.01, wide - 0.01 - SINK * 2.0]));
    let z = low + 0.03;
    let pipe = [
        DVec3::new(0.0, bay.high.y, z),
        DVec3::new(0.0, bay.height() * 0.74, z),
        DVec3::new(0.0, bay.height() * 0.7, z + bay.depth() * 0.16),
    ];
    builder.add(Slot::Chrome, sweep(&pipe, 0.012, 6));
    let button = turned_forward(lathe(&[(0.026, 0.0), (0.026, 0.03), (0.016, 0.04)], 8));
    builder.add(Slot::MetalDark, button.moved(0.0, bay.height() * 0.93, z));
}

/// A bowl before a shield with wings, a short pipe above.
fn shielded(builder: &mut Builder) {
    let bay = builder.bay();
    let (back, depth) = (bay.low.z, bay.depth());
    let top = bay.high.y - (bay.height() * 0.1).min(0.07);
    let rim = top * 0.42;
    bowl(builder, bay, rim);
    let shield = bay.slab(Side::Back, depth * 0.3).with_y([rim * 0.8, top]);
    builder.cushion(Slot::Ceramic, shield.inset(bay.width() * 0.02, 0.0, 0.001), 0.05_f64.min(depth * 0.1));
    for side in [Side::Left, Side::Right] {
        let wing = bay
            .slab(side, bay.width() * 0.12)
            .with_y([rim * 0.85, top - 0.02])
            .slab(Side::Back, depth * 0.55);
        builder.cushion(Slot::Ceramic, wing.inset(0.004, 0.0, 0.004), 0.02);
    }
    let pipe = [
        DVec3::new(0.0, top - 0.01, back + 0.04),
        DVec3::new(0.0, bay.high.y - 0.02, back + 0.04),
        DVec3::new(0.0, bay.high.y - 0.02, back),
    ];
    builder.add(Slot::Chrome, sweep(&pipe, 0.014, 6));
    builder
        .add(Slot::Chrome, cylinder(0.022, [bay.high.y - 0.04, bay.high.y], 8).moved(0.0, 0.0, back + 0.04));
}
