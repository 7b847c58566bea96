//! Legs.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{
    Bay, Builder, Outline, SINK, Slice, Solid, Station, cylinder, lathe, loft, sheet, sweep,
};

/// The forms of a leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum LegKind {
    /// The same square from top to bottom.
    Square,
    /// Square, thinner towards the floor.
    Tapered,
    /// A round rod.
    Round,
    /// Turned on a lathe under a square block.
    Turned,
    /// Turned like a vase, with a bun foot.
    Baluster,
    /// Square and tapered, standing on a small block.
    Spade,
    /// An angle of steel, its edge outwards.
    Angle,
    /// Two thin rods that meet at the floor.
    Hairpin,
    /// A pipe with a flange above and a rubber foot.
    Pipe,
}

/// Share of a tapered leg's thickness that is left at the floor.
const TAPER: f64 = 0.6;
/// Where the turned part of a leg ends and the square block begins.
const BLOCK_FROM: f64 = 0.78;
/// Radius as a share of half the thickness, at a share of the leg's height.
const TURNED: [(f64, f64); 10] = [
    (0.5, 0.0),
    (0.7, 0.03),
    (0.5, 0.07),
    (0.42, 0.1),
    (0.8, 0.55),
    (0.9, 0.66),
    (0.55, 0.7),
    (0.85, 0.725),
    (0.85, 0.75),
    (0.6, BLOCK_FROM),
];
const BALUSTER: [(f64, f64); 10] = [
    (0.55, 0.0),
    (0.8, 0.05),
    (0.55, 0.1),
    (0.42, 0.13),
    (0.95, 0.28),
    (0.9, 0.36),
    (0.42, 0.6),
    (0.4, 0.68),
    (0.8, 0.72),
    (0.55, BLOCK_FROM),
];
/// Corners of a turned leg.
const SIDES: usize = 8;

/// A leg that fills a bay and ends flush with its top.
pub(in super::super) fn leg(builder: &mut Builder, slot: Slot, bay: Bay, kind: LegKind) {
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let radius = half.x.min(half.z);
    let at_rise = |rise: f64| bay.low.y + rise * bay.height();
    match kind {
        LegKind::Square => builder.cuboid(slot, bay),
        LegKind::Tapered => tapered(builder, slot, bay, &[(TAPER, 0.0), (1.0, 1.0)]),
        LegKind::Spade => tapered(
            builder,
            slot,
            bay,
            &[(0.62, 0.0), (0.8, 0.02), (0.8, 0.11), (0.55, 0.13), (1.0, 0.8), (1.0, 1.0)],
        ),
        LegKind::Round => {
            builder.add(slot, cylinder(radius, bay.y(), SIDES).moved(center.x, 0.0, center.z));
        }
        LegKind::Turned | LegKind::Baluster => {
            let shares = if kind == LegKind::Turned { TURNED } else { BALUSTER };
            let profile = shares.map(|(share, rise)| (share * radius, at_rise(rise)));
            builder.add(slot, lathe(&profile, SIDES).moved(center.x, 0.0, center.z));
            builder.block(slot, bay.without(Side::Below, BLOCK_FROM * bay.height() - SINK), 0.003);
        }
        LegKind::Angle => angle(builder, slot, bay),
        LegKind::Hairpin => hairpin(builder, slot, bay),
        LegKind::Pipe => {
            let top = bay.slab(Side::Above, (bay.height() * 0.1).min(0.008));
            builder.add(slot, cylinder(radius, top.y(), 10).moved(center.x, 0.0, center.z));
            let low = bay.low.y + (bay.height() * 0.1).min(0.015);
            let rod = cylinder(radius * 0.62, [low - SINK, top.low.y + SINK], SIDES);
            builder.add(slot, rod.moved(center.x, 0.0, center.z));
            let foot = cylinder(radius * 0.75, [bay.low.y, low], SIDES);
            builder.add(Slot::Rubber, foot.moved(center.x, 0.0, center.z));
        }
    }
}

fn tapered(builder: &mut Builder, slot: Slot, bay: Bay, shares: &[(f64, f64)]) {
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let slice = |&(share, rise): &(f64, f64)| {
        Slice::new(bay.low.y + rise * bay.height(), half.x * share, half.z * share)
    };
    let slices: Vec<Slice> = shares.iter().map(slice).collect();
    builder.add(slot, loft(&Outline::Square, &slices).moved(center.x, 0.0, center.z));
}

/// Two flat bars at a right angle, their edge away from the middle of the piece of furniture.
fn angle(builder: &mut Builder, slot: Slot, bay: Bay) {
    let thickness = (bay.width().min(bay.depth()) * 0.16).max(0.004);
    let [across, along] = outer_sides(bay);
    builder.cuboid(slot, bay.slab(across, thickness));
    let rest = bay.without(across, thickness - SINK).inset(0.0, 3.0 * SINK, 0.0);
    builder.cuboid(slot, rest.without(along, 2.0 * SINK).slab(along, thickness));
}

/// The sides of a bay that look away from the middle of the box.
fn outer_sides(bay: Bay) -> [Side; 2] {
    let center = bay.center();
    let across = if center.x < 0.0 { Side::Left } else { Side::Right };
    [across, if center.z < 0.0 { Side::Back } else { Side::Front }]
}

fn hairpin(builder: &mut Builder, slot: Slot, bay: Bay) {
    let rod = (bay.width().min(bay.depth()) * 0.12).clamp(0.003, 0.006);
    let [across, along] = outer_sides(bay);
    let inner = bay.inset(rod, 0.0, rod);
    let x = if across == Side::Left { inner.x() } else { [inner.high.x, inner.low.x] };
    let z = if along == Side::Back { inner.z() } else { [inner.high.z, inner.low.z] };
    let low = bay.low.y + rod;
    let path = [
        DVec3::new(x[0], bay.high.y, z[1]),
        DVec3::new(x[0], low, z[0] * 0.9 + z[1] * 0.1),
        DVec3::new(x[0] * 0.9 + x[1] * 0.1, low, z[0]),
        DVec3::new(x[1], bay.high.y, z[0]),
    ];
    builder.add(slot, sweep(&path, rod, 6));
}

/// Four legs of a thickness in the corners of a bay.
pub(in super::super) fn legs_at_corners(
    builder: &mut Builder,
    slot: Slot,
    bay: Bay,
    thickness: f64,
    kind: LegKind,
) {
    let thickness = thickness.min(bay.width() * 0.4).min(bay.depth() * 0.4);
    for x in [[bay.low.x, bay.low.x + thickness], [bay.high.x - thickness, bay.high.x]] {
        for z in [[bay.low.z, bay.low.z + thickness], [bay.high.z - thickness, bay.high.z]] {
            leg(builder, slot, Bay::new(x, bay.y(), z), kind);
        }
    }
}

/// Radius and rise of a slanted leg, as shares.
pub(in super::super) const CONE: [(f64, f64); 2] = [(0.55, 0.0), (1.0, 1.0)];
/// The same for one turned on a lathe.
pub(in super::super) const SPINDLE: [(f64, f64); 8] =
    [(0.6, 0.0), (0.75, 0.12), (0.95, 0.3), (0.55, 0.36), (0.9, 0.4), (1.0, 0.55), (0.55, 0.86), (0.6, 1.0)];

/// A round leg from a foot up to a point, with radii as shares of `radius` at shares of its height.
pub(in super::super) fn slanted_leg(
    [foot, top]: [DVec3; 2],
    radius: f64,
    profile: &[(f64, f64)],
    sides: usize,
) -> Solid {
    let slice = |&(share, rise): &(f64, f64)| {
        let at = foot.lerp(top, rise);
        Slice::round(at.y, radius * share).at(at.x, at.z)
    };
    let slices: Vec<Slice> = profile.iter().map(slice).collect();
    loft(&Outline::Round(sides), &slices)
}

/// A curved board along x, as wide as given, `bow` metres deeper in the middle than at its ends, around a middle.
pub(in super::super) fn bowed_board(middle: DVec3, extent: DVec3, bow: f64) -> Solid {
    let station = |step: i32| {
        let share = f64::from(step) / 3.0;
        let at = middle + DVec3::new(share * extent.x / 2.0, 0.0, bow * (share * share - 0.5));
        Station { at, half_width: extent.y / 2.0 * (1.0 - 0.12 * share * share), sag: 0.0 }
    };
    let stations: Vec<Station> = (-3..=3).map(station).collect();
    sheet(&stations, DVec3::Y, extent.z, 1)
}
