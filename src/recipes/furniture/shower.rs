//! Showers.

use glam::DVec3;

use super::parts::wall_mixer;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// A shower tray between two walls (behind and on the left) with glass or a curtain on the other sides.
pub(super) static SHOWER: Recipe =
    Recipe::furniture("shower", [0.9, 0.9, 2.0]).symbol(Symbol::Shower).every_set(shower);

fn shower(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let set = draft.set();
    let tray = if set == GeometrySet::Plain { 0.035 } else { 0.1_f64 }.min(bay.height() * 0.1);
    let half = bay.extent() / 2.0;
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(0.02 + back);
    let slices = [
        slice(0.0, 0.0),
        slice(tray * 0.9, 0.0),
        slice(tray, 0.004),
        slice(tray, 0.05),
        slice(tray * 0.5, 0.075),
    ];
    let slot = match (set, draft.input.look % 2) {
        (GeometrySet::Industrial, _) => Slot::Concrete,
        (GeometrySet::Plain, 1) => Slot::Stone,
        _ => Slot::Ceramic,
    };
    builder.add(slot, loft(&Outline::Soft(2), &slices));
    let drain =
        lathe(&[(0.05, tray * 0.5 - SINK), (0.05, tray * 0.5 + 0.003), (0.03, tray * 0.5 + 0.006)], 12);
    builder.add(Slot::Chrome, drain);
    let walls = bay.inset(0.006, 0.0, 0.006).with_y([tray - 0.002, bay.high.y]);
    match (set, draft.input.look % 4) {
        (GeometrySet::Budget, 0 | 2) => curtain(draft, builder, walls),
        (GeometrySet::Plain, _) => frameless(draft, builder, walls),
        _ => framed(draft, builder, walls),
    }
    let rail = -bay.width() * 0.12;
    riser(draft, builder, rail);
}

/// Panes without frames, held by clamps, with an upright bar as handle.
fn frameless(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let pane = 0.008;
    builder.cuboid(Slot::Glass, bay.slab(Side::Right, pane));
    let front = bay.slab(Side::Front, pane).without(Side::Right, pane + 0.001).without(Side::Above, 0.002);
    let door = [0.5, 0.62, 0.0, 0.55][draft.form()];
    let fixed =
        front.slab(Side::Right, front.width() * (1.0 - door) * if door > 0.0 { 1.0 } else { 0.55 } - 0.004);
    builder.cuboid(Slot::Glass, fixed);
    for y in [0.12, 0.9] {
        let clamp = bay.slab(Side::Right, 0.045).slab(Side::Front, 0.022).moved(0.004, 0.0, 0.004);
        let y = bay.low.y + bay.height() * y;
        builder.cuboid(Slot::Chrome, clamp.with_y([y, y + 0.045]));
    }
    let stay = [
        DVec3::new(fixed.low.x + 0.03, bay.high.y - 0.02, front.center().z),
        DVec3::new(fixed.low.x + 0.03, bay.high.y - 0.02, builder.bay().low.z),
    ];
    builder.add(Slot::Chrome, sweep(&stay, 0.008, 6));
    if door > 0.0 {
        let leaf = front.slab(Side::Left, front.width() * door);
        builder.cuboid(Slot::Glass, leaf.without(Side::Below, 0.012));
        let (x, y) = (leaf.high.x - 0.06, (bay.height() * 0.5).min(1.05));
        let (out, back) = (leaf.high.z - 0.003, leaf.high.z - 0.045);
        let bar = [
            DVec3::new(x, y - 0.15, out),
            DVec3::new(x, y - 0.15, back),
            DVec3::new(x, y + 0.15, back),
            DVec3::new(x, y + 0.15, out),
        ];
        builder.add(Slot::Chrome, sweep(&bar, 0.008, 6));
        for y in [0.15, 0.85] {
            let y = bay.low.y + bay.height() * y;
            builder.cuboid(
                Slot::Chrome,
                leaf.slab(Side::Left, 0.05)
                    .inset(0.0, 0.0, -0.004)
                    .moved(0.001, 0.0, 0.0)
                    .with_y([y, y + 0.06]),
            );
        }
    }
}

/// Panes in frames: with bars across in the industrial set, brass in the traditional, broad in the budget set.
fn framed(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let (slot, thick) = match draft.set() {
        GeometrySet::Industrial => (Slot::MetalDark, 0.025),
        GeometrySet::Traditional => ([Slot::Brass, Slot::Chrome][draft.input.look as usize % 2], 0.022),
        _ => ([Slot::Painted, Slot::Metal][draft.input.look as usize / 2 % 2], 0.035),
    };
    let front = bay.slab(Side::Front, thick).without(Side::Right, thick + SINK);
    let share = [0.5, 0.6, 0.45, 0.55][draft.form()];
    let leaf = front.slab(Side::Left, front.width() * share);
    pane(
        draft,
        builder,
        slot,
        thick,
        front.slab(Side::Right, front.width() * (1.0 - share) - 0.004).inset(0.0, 0.001, 0.0),
    );
    pane(draft, builder, slot, thick, leaf.inset(0.0, 0.001, 0.001));
    let knob = DVec3::new(leaf.high.x - thick * 0.5, (bay.height() * 0.5).min(1.05), bay.high.z);
    builder.cuboid(slot, Bay::around(knob, 0.014, 0.16, 0.012));
    // The side is built like the front and turned.
    let mut side = builder.empty();
    let flat = Bay::new([-bay.depth() / 2.0, bay.depth() / 2.0], bay.y(), [-thick / 2.0, thick / 2.0]);
    pane(draft, &mut side, slot, thick, flat);
    for (slot, solid) in side.into_parts() {
        let middle = bay.high.x - thick / 2.0;
        builder.add(slot, solid.turned_y(std::f64::consts::FRAC_PI_2).moved(middle, 0.0, bay.center().z));
    }
}

/// One pane in its frame.
fn pane(draft: &Draft, builder: &mut Builder, slot: Slot, thick: f64, bay: Bay) {
    builder.cuboid(Slot::Glass, bay.inset(thick * 0.5, thick * 0.5, (bay.depth() - 0.006) / 2.0));
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, thick));
    }
    let inner = bay.inset(thick - SINK, 0.0002, 0.0002);
    for side in [Side::Below, Side::Above] {
        builder.cuboid(slot, inner.slab(side, thick));
    }
    let bars = match (draft.set(), draft.input.look % 2) {
        (GeometrySet::Industrial, look) => 3 + look,
        (GeometrySet::Traditional, 1) => 1,
        _ => 0,
    };
    for bar in 1..=bars {
        let y = bay.low.y + bay.height() * f64::from(bar) / f64::from(bars + 1);
        builder.cuboid(slot, inner.with_y([y - 0.007, y + 0.007]).inset(0.0, 0.0, thick * 0.12));
    }
}

/// A curtain in folds on a rail around the corner.
fn curtain(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let y = bay.high.y - 0.012;
    let (x, z) = (bay.high.x - 0.02, bay.high.z - 0.02);
    let rail = [
        DVec3::new(bay.low.x - 0.006, y, z),
        DVec3::new(x - 0.12, y, z),
        DVec3::new(x - 0.035, y, z - 0.035),
        DVec3::new(x, y, z - 0.12),
        DVec3::new(x, y, bay.low.z - 0.006),
    ];
    builder.add(Slot::Chrome, sweep(&rail, 0.012, 8));
    let slot = [Slot::FabricLight, Slot::Linen, Slot::FabricAccent, Slot::Linen][draft.form()];
    let cloth = Bay::new([bay.low.x + bay.width() * 0.42, x - 0.1], [0.12, y], [z - 0.05, z + 0.02]);
    builder.add(slot, super::windows::folds(cloth, 6));
    let mut side = builder.empty();
    let length = bay.depth() * 0.8;
    side.add(
        slot,
        super::windows::folds(Bay::new([-length / 2.0, length / 2.0], [0.12, y], [-0.03, 0.03]), 8),
    );
    for (slot, solid) in side.into_parts() {
        builder.add(
            slot,
            solid.turned_y(std::f64::consts::FRAC_PI_2).moved(x, 0.0, bay.low.z + length / 2.0 + 0.02),
        );
    }
}

/// The rail with its hand shower and hose, the mixer, and a head over it.
fn riser(draft: &Draft, builder: &mut Builder, x: f64) {
    let bay = builder.bay();
    let set = draft.set();
    let slot = match set {
        GeometrySet::Traditional => Slot::Brass,
        GeometrySet::Industrial => Slot::MetalDark,
        _ => Slot::Chrome,
    };
    let (z, reach) = (bay.low.z, (bay.depth() * 0.35).min(0.35));
    let (low, high) = (bay.height() * 0.52, bay.height() * 0.95);
    let out = z + 0.055;
    wall_mixer(builder, set, DVec3::new(x, low, out), z);
    let has_head = set != GeometrySet::Budget;
    let top = if has_head { high } else { bay.height() * 0.92 };
    let rail = if has_head {
        vec![DVec3::new(x, low, out), DVec3::new(x, high, out), DVec3::new(x, high, out + reach)]
    } else {
        vec![DVec3::new(x, low + 0.1, out), DVec3::new(x, top, out)]
    };
    builder.add(slot, sweep(&rail, 0.011, 8));
    for y in [low + 0.16, top - 0.06] {
        builder.cuboid(slot, Bay::new([x - 0.012, x + 0.012], [y, y + 0.025], [z, out + 0.012]));
    }
    if has_head {
        let drop = 0.05;
        let head: Vec<(f64, f64)> = match set {
            GeometrySet::Plain => vec![(0.125, 0.0), (0.125, 0.01), (0.02, 0.018), (0.014, drop)],
            GeometrySet::Traditional => {
                vec![(0.1, 0.0), (0.1, 0.008), (0.06, 0.03), (0.02, 0.04), (0.014, drop)]
            }
            _ => vec![(0.075, 0.0), (0.075, 0.03), (0.03, 0.035), (0.014, drop)],
        };
        builder.add(slot, lathe(&head, 14).moved(x, high - drop, out + reach - 0.012));
    }
    hand_shower(builder, slot, [x, low, out]);
}

/// A hand shower on its holder, and the hose down to the mixer at a height.
fn hand_shower(builder: &mut Builder, slot: Slot, [x, low, out]: [f64; 3]) {
    let bay = builder.bay();
    let holder = DVec3::new(x, bay.height() * 0.72, out);
    builder.cuboid(slot, Bay::around(holder, 0.03, 0.04, 0.04));
    let hand = cylinder(0.01, [-0.09, 0.07], 8).turned_x(0.35);
    builder.add(slot, hand.moved(holder.x, holder.y, holder.z + 0.032));
    let rose = lathe(&[(0.042, 0.0), (0.045, 0.012), (0.02, 0.025)], 10).turned_x(-1.1);
    builder.add(slot, rose.moved(holder.x, holder.y + 0.078, holder.z + 0.078));
    let hang = |dx: f64, y: f64, dz: f64| DVec3::new(x + dx, y, out + dz);
    let hose = [
        hang(0.0, holder.y - 0.08, 0.004),
        hang(0.03, holder.y - 0.2, 0.02),
        hang(0.06, low - 0.22, 0.03),
        hang(0.035, low - 0.3, 0.03),
        hang(0.005, low - 0.2, 0.015),
        hang(0.0, low - 0.01, 0.0),
    ];
    builder.add(Slot::Metal, sweep(&hose, 0.007, 6));
}
