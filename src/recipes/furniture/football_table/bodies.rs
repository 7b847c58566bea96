//! The bodies and legs of football tables. Each gives the height of the body's underside.

use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3};

use super::{WALL, boards};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{CONE, LegKind, legs_at_corners, slanted_leg};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, cylinder, extrude, lathe, sweep};

/// Radius of a turned leg as a share of its thickest, at a share of its height.
const TURNED: [(f64, f64); 7] =
    [(0.55, 0.0), (0.75, 0.06), (0.45, 0.12), (0.8, 0.6), (1.0, 0.74), (0.6, 0.8), (0.95, 0.86)];

/// A shallow body on four round legs that stand apart.
pub(super) fn splayed(builder: &mut Builder, body: Bay, look: usize) -> f64 {
    let (slot, wood) = [
        (Slot::Painted, Slot::Wood),
        (Slot::Wood, Slot::Wood),
        (Slot::PaintedAccent, Slot::WoodLight),
        (Slot::WoodDark, Slot::MetalDark),
    ][look];
    let low = body.high.y - 0.21;
    boards(builder, slot, body, [low, body.high.y]);
    let inner = body.inset(WALL, 0.0, WALL - 2.0 * SINK).with_y([low + 0.002, low + 0.025]);
    builder.cuboid(slot, inner);
    for z in [-1.0, 1.0] {
        let foot = DVec3::new(body.high.x - 0.03, 0.0, z * (body.high.z - 0.03));
        let top = DVec3::new(body.high.x - 0.16, low + 0.004, z * (body.high.z - 0.09));
        builder.add_pair(wood, slanted_leg([foot, top], 0.032, &CONE, 8));
    }
    low
}

/// A cabinet with a rim and a base moulding and brass on its corners, on turned legs with stretchers.
pub(super) fn cabinet(builder: &mut Builder, body: Bay, look: usize) -> f64 {
    let slot = [Slot::WoodDark, Slot::Wood, Slot::WoodDark, Slot::Wood][look];
    let low = body.high.y - 0.33;
    boards(builder, slot, body, [low, body.high.y - 0.02]);
    let around = |out: f64, y: [f64; 2]| body.inset(-out, 0.0, -out).with_y(y);
    let moulding = |builder: &mut Builder, out: f64, y: [f64; 2]| {
        let ring = around(out, y);
        for side in [Side::Front, Side::Back] {
            builder.block(slot, ring.slab(side, WALL + out + 0.002), 0.006);
        }
        for side in [Side::Left, Side::Right] {
            builder.cuboid(
                slot,
                ring.slab(side, WALL * 1.6 + out + 0.001).inset(0.0, 0.001, WALL + out - 2.0 * SINK),
            );
        }
    };
    moulding(builder, 0.03, [body.high.y - 0.021, body.high.y]);
    moulding(builder, 0.012, [low - 0.012, low + 0.012]);
    for side in [Side::Left, Side::Right] {
        for end in [Side::Front, Side::Back] {
            let corner = around(0.003, [low + 0.06, body.high.y - 0.06]).slab(side, 0.05).slab(end, 0.05);
            builder.cuboid(Slot::Brass, corner);
        }
    }
    let (x, z) = (body.high.x - 0.06, body.high.z - 0.06);
    let thick = 0.042;
    for z in [-z, z] {
        let profile = TURNED.map(|(share, rise)| (thick * share, rise * low));
        builder.add_pair(slot, lathe(&profile, 6).moved(x, 0.0, z));
        let block = Bay::around(DVec3::new(x, low * 0.92, z), thick * 2.0, low * 0.16, thick * 2.0);
        builder.add_pair(slot, cuboid(block.with_y([low * 0.85, low])));
    }
    let y = low * 0.2;
    for x in [-x, x] {
        builder.add(slot, sweep(&[DVec3::new(x, y, -z), DVec3::new(x, y, z)], 0.02, 4));
    }
    builder.add(slot, sweep(&[DVec3::new(-x, y, 0.0), DVec3::new(x, y, 0.0)], 0.0195, 4));
    low
}

/// Two planks a side between angles of steel that are the legs, with crossed bars at the ends.
pub(super) fn planks(builder: &mut Builder, body: Bay, look: usize) -> f64 {
    let (slot, steel) = [
        (Slot::Wood, Slot::MetalDark),
        (Slot::WoodDark, Slot::MetalDark),
        (Slot::WoodLight, Slot::Metal),
        (Slot::Metal, Slot::MetalDark),
    ][look];
    let low = body.high.y - 0.28;
    let walls = body.inset(0.009, 0.0, 0.009);
    for row in walls.with_y([low, body.high.y]).rows(2, 0.008) {
        boards(builder, slot, walls, row.y());
    }
    builder.cuboid(slot, walls.inset(WALL, 0.0, WALL - 2.0 * SINK).with_y([low + 0.002, low + 0.025]));
    legs_at_corners(builder, steel, body.with_y([0.0, body.high.y - 0.004]), 0.058, LegKind::Angle);
    let (x, z) = (body.high.x - 0.022, body.high.z - 0.03);
    for (lower, shift) in [(-z, 0.0), (z, 0.012)] {
        let bar = [DVec3::new(x - shift, 0.12, lower), DVec3::new(x - shift, low - 0.04, -lower)];
        builder.add_pair(steel, sweep(&bar, 0.011, 4));
    }
    let y = 0.1;
    for z in [-z, z] {
        builder.add(steel, sweep(&[DVec3::new(-x, y, z), DVec3::new(x, y, z)], 0.014, 4));
    }
    low
}

/// A box on two panels with an arch between their feet, a board between them, cups at the ends.
pub(super) fn panels(builder: &mut Builder, body: Bay, look: usize) -> f64 {
    let (slot, dark) = [
        (Slot::Laminate, Slot::PlasticDark),
        (Slot::WoodLight, Slot::PlasticDark),
        (Slot::PlasticDark, Slot::MetalDark),
        (Slot::PaintedAccent, Slot::PlasticDark),
    ][look];
    let low = body.high.y - 0.26;
    boards(builder, slot, body, [low, body.high.y]);
    let half = body.high.z - 0.012;
    let arch = half * 0.62;
    let foot = 0.025;
    let panel = [
        (-half, foot),
        (-arch, foot),
        (-arch * 0.8, low * 0.5),
        (arch * 0.8, low * 0.5),
        (arch, foot),
        (half, foot),
        (half, low + 0.03),
        (-half, low + 0.03),
    ]
    .map(DVec2::from);
    let x = [body.high.x - 0.15, body.high.x - 0.115];
    builder.add_pair(slot, extrude(&panel, Axis::X, x));
    for z in [-half + 0.04, half - 0.04] {
        let glide = cylinder(0.025, [0.0, foot + SINK], 6);
        builder.add_pair(dark, glide.moved((x[0] + x[1]) / 2.0, 0.0, z));
    }
    let stretcher = Bay::new([-x[0] - SINK, x[0] + SINK], [low * 0.55, low * 0.8], [-0.01, 0.01]);
    builder.cuboid(slot, stretcher);
    for side in [-1.0, 1.0] {
        let cup = lathe(&[(0.03, 0.0), (0.036, 0.09), (0.032, 0.09), (0.026, 0.01)], 8);
        let at = DVec3::new(side * (body.high.x - 0.006), low + 0.1, body.high.z - 0.09);
        builder.add(dark, cup.turned_y(FRAC_PI_2 / 2.0).moved(at.x, at.y, at.z));
    }
    low
}
