//! Legs.

use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft};

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
}

/// Share of a tapered leg's thickness that is left at the floor.
const TAPER: f64 = 0.6;
/// Where the turned part of a leg ends and the square block begins.
const BLOCK_FROM: f64 = 0.78;
/// Radius as a share of half the thickness, at a share of the leg's height.
const TURNED: [(f64, f64); 6] =
    [(0.55, 0.0), (0.8, 0.05), (0.45, 0.12), (0.85, 0.6), (0.95, 0.68), (0.6, BLOCK_FROM)];
/// Corners of a turned leg.
const SIDES: usize = 8;

/// A leg that fills a bay and ends flush with its top.
pub(in super::super) fn leg(builder: &mut Builder, slot: &'static str, bay: Bay, kind: LegKind) {
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let radius = half.x.min(half.z);
    match kind {
        LegKind::Square => builder.cuboid(slot, bay),
        LegKind::Tapered => {
            let slices = [
                Slice::new(bay.low.y, half.x * TAPER, half.z * TAPER),
                Slice::new(bay.high.y, half.x, half.z),
            ];
            builder.add(slot, loft(&Outline::Square, &slices).moved(center.x, 0.0, center.z));
        }
        LegKind::Round => {
            builder.add(slot, cylinder(radius, bay.y(), SIDES).moved(center.x, 0.0, center.z));
        }
        LegKind::Turned => {
            let profile = TURNED.map(|(share, rise)| (share * radius, bay.low.y + rise * bay.height()));
            builder.add(slot, lathe(&profile, SIDES).moved(center.x, 0.0, center.z));
            builder.cuboid(slot, bay.without(crate::catalog::Side::Below, BLOCK_FROM * bay.height() - SINK));
        }
    }
}

/// Four legs of a thickness in the corners of a bay.
pub(in super::super) fn legs_at_corners(
    builder: &mut Builder,
    slot: &'static str,
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
