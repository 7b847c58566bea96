//! Luggage racks of hotel rooms: 0.6 to 0.75 m wide, 0.4 to 0.5 deep and 0.45 to 0.5 high, so that a suitcase of 0.7 m
//! opens on them without stooping.

use glam::DVec3;

use super::parts::{across, slanted_leg};
use super::seating::depth_slats;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, rounded_path, sweep};
use crate::recipes::{Recipe, Slot};

/// Share of the height at which a suitcase lies on a rack with a board behind it.
const LYING_SHARE: f64 = 0.86;
/// Radius of a turned leg of a folding stand as a share of its thickest, at a share of its height.
const TURNED: [(f64, f64); 6] = [(0.6, 0.0), (0.9, 0.18), (0.6, 0.25), (1.0, 0.5), (0.6, 0.75), (0.8, 1.0)];

/// A rack for a suitcase: a slatted bench; crossed turned legs with straps; planks on pipes; a folding stand of tube.
pub(super) static LUGGAGE_RACK: Recipe = Recipe::furniture("luggage_rack", [0.7, 0.45, 0.5])
    .plain(|draft, builder| bench(builder, draft.form()))
    .traditional(|draft, builder| crossed_legs(builder, draft.form()))
    .industrial(|draft, builder| planks_on_pipes(builder, draft.form()))
    .budget(|draft, builder| tube_stand(builder, draft.form()));

/// A bench of slats between two frames, with a board behind that keeps suitcases off the wall, and a shelf for shoes.
fn bench(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (frame, slats) = [
        (Slot::MetalDark, Slot::Wood),
        (Slot::WoodLight, Slot::WoodLight),
        (Slot::MetalDark, Slot::WoodDark),
        (Slot::Brass, Slot::WoodDark),
    ][look];
    let (tube, lying) = (0.025, bay.high.y * LYING_SHARE);
    for side in [Side::Left, Side::Right] {
        let end = bay.slab(side, tube);
        for depth in [Side::Front, Side::Back] {
            let high = if depth == Side::Back { bay.high.y } else { lying };
            builder.cuboid(frame, end.slab(depth, tube).with_y([0.0, high]));
        }
        let rung = end.inset(0.002, 0.0, tube - SINK);
        for y in [bay.high.y * 0.12, lying - 0.03] {
            builder.cuboid(frame, rung.with_y([y, y + tube]));
        }
    }
    let inner = bay.inset(tube - SINK, 0.0, 0.001);
    let shelf = inner.with_y([bay.high.y * 0.12 + 0.003, bay.high.y * 0.12 + 0.018]);
    for slat in depth_slats(shelf.inset(0.0, 0.0, tube), 3, 0.06) {
        builder.cuboid(slats, slat);
    }
    let top = inner.with_y([lying - 0.024, lying - 0.002]).without(Side::Back, tube);
    if look == 3 {
        builder.block(Slot::Leather, top, 0.008);
    } else {
        for slat in depth_slats(top, 5, 0.018) {
            builder.cuboid(slats, slat);
        }
    }
    builder.cuboid(slats, inner.slab(Side::Back, 0.018).with_y([lying - 0.03, bay.high.y - 0.002]));
}

/// A folding stand: turned legs that cross at both sides, and straps of leather between two rails.
fn crossed_legs(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::WoodDark, Slot::Wood, Slot::WoodDark, Slot::Wood][look];
    let (radius, rail) = (0.018, 0.015);
    let top = bay.high.y - rail;
    let near = bay.high.z - radius;
    for (index, foot) in [near, -near].into_iter().enumerate() {
        // Two pairs of legs go past each other.
        let x = bay.high.x - 0.022 - 0.038 * index as f64;
        let at = |share: f64, x: f64| DVec3::new(x, top * share, foot * (1.0 - 2.0 * share));
        builder.add_pair(slot, slanted_leg([at(0.0, x), at(1.0, x)], radius, &TURNED, 6));
        let bar = |half: f64, radius: f64, at: DVec3| across(radius, [-half, half], 6).moved(0.0, at.y, at.z);
        builder.add(slot, bar(bay.high.x - 0.0005 * index as f64, rail, at(1.0, 0.0)));
        builder.add(slot, bar(x, 0.009, at(0.2, 0.0)));
    }
    let belts = bay.inset(bay.width() * 0.12, 0.0, 0.004).with_y([bay.high.y - 0.006, bay.high.y - 0.001]);
    for belt in belts.columns(4, bay.width() * 0.12) {
        builder.cuboid(if look < 2 { Slot::Leather } else { Slot::Fabric }, belt);
    }
}

/// Thick planks on four legs of pipe with flanges, with a bow behind them and a rail below.
fn planks_on_pipes(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let wood = [Slot::Wood, Slot::WoodDark, Slot::WoodLight, Slot::Wood][look];
    let (pipe, flange) = (0.013, 0.032);
    let lying = bay.high.y * LYING_SHARE;
    let (x, z) = (bay.high.x - flange, bay.high.z - flange);
    let under = lying - 0.035;
    // The hind legs are the ends of the bow.
    let bow = [(x, 0.004), (x, bay.high.y - pipe), (-x, bay.high.y - pipe), (-x, 0.004)]
        .map(|(x, y)| DVec3::new(x, y, -z));
    builder.add(Slot::MetalDark, sweep(&rounded_path(&bow, 0.05, 2), pipe, 6));
    let leg = sweep(&[DVec3::new(x, 0.004, z), DVec3::new(x, under + SINK, z)], pipe, 6);
    builder.add_pair(Slot::MetalDark, leg);
    for z in [-z, z] {
        builder.add_pair(Slot::MetalDark, cylinder(flange, [0.0, 0.008], 8).moved(x, 0.0, z));
    }
    let low = bay.high.y * 0.22;
    for y in [low, under - pipe * 0.8] {
        builder.add_pair(Slot::MetalDark, sweep(&[DVec3::new(x, y, -z), DVec3::new(x, y, z)], pipe * 0.9, 6));
    }
    for z in [-z * 0.3, z * 0.3] {
        builder.add(Slot::MetalDark, sweep(&[DVec3::new(-x, low, z), DVec3::new(x, low, z)], pipe * 0.9, 6));
    }
    for plank in depth_slats(bay.with_y([under, lying]).without(Side::Back, flange + 0.02), 3, 0.008) {
        builder.block(wood, plank, 0.004);
    }
}

/// Two bows of tube that cross before and behind, with broad belts from one to the other and plastic feet.
fn tube_stand(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let metal = [Slot::Chrome, Slot::MetalDark, Slot::Metal, Slot::Chrome][look];
    let tube = 0.011;
    let top = bay.high.y - tube;
    let wide = bay.high.x - tube;
    for (index, side) in [-1.0, 1.0].into_iter().enumerate() {
        // One bow goes round the other.
        let z = bay.high.z - tube - 0.026 * index as f64;
        let [head, foot] = [side * wide, -side * (wide - 0.004)];
        let path = [(foot, 0.01, z), (head, top, z), (head, top, -z), (foot, 0.01, -z)].map(DVec3::from);
        builder.add(metal, sweep(&rounded_path(&path, 0.05, 2), tube, 6));
        let rung = top * 0.14;
        let at = |z: f64| DVec3::new(foot + (head - foot) * 0.14, rung, z);
        builder.add(metal, sweep(&[at(-z), at(z)], tube * 0.7, 6));
        for end in [-z, z] {
            let shoe = Bay::around(DVec3::new(foot, 0.015, end), 0.03, 0.03, 0.03);
            builder.cuboid(Slot::Rubber, shoe.with_x(shoe.x().map(|x| x.clamp(bay.low.x, bay.high.x))));
        }
    }
    let slot = if look.is_multiple_of(2) { Slot::PlasticDark } else { Slot::FabricAccent };
    let belts = bay.inset(0.006, 0.0, 0.055).with_y([bay.high.y - 0.006, bay.high.y]);
    for belt in depth_slats(belts, 3, 0.035) {
        builder.cuboid(slot, belt);
    }
}
