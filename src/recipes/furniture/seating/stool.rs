//! Backless seats: 0.45 m at tables, 0.65 at kitchen islands, 0.75 to 0.80 at bars (DIN 68881).

use glam::DVec3;

use super::bar_stool::bar_stool;
use crate::recipes::furniture::parts::{CONE, SPINDLE, slanted_leg};
use crate::recipes::kit::{Bay, Builder, SINK, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres from which a stool is one for a bar.
const BAR_FROM: f64 = 0.63;

/// A backless seat: round for square boxes, on legs of the set; one for a bar where it is high.
pub(in super::super) static STOOL: Recipe =
    Recipe::furniture("stool", [0.36, 0.36, 0.65]).round().every_set(stool);

fn stool(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    if bay.height() > BAR_FROM {
        bar_stool(draft.set(), draft.input.look, builder);
        return;
    }
    let form = draft.form();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let thickness = [0.05_f64, 0.035, 0.06, 0.03][form].min(bay.height() * 0.2);
    let profile =
        [(0.94, -1.0), (1.0, -0.7), (1.0, -0.3), (0.9, -0.02), (0.4, if form == 3 { -0.3 } else { 0.0 })];
    let slot = match draft.set() {
        GeometrySet::Plain => [Slot::FabricAccent, Slot::Wood, Slot::Leather, Slot::WoodLight][form],
        GeometrySet::Traditional => [Slot::Wood, Slot::FabricLight, Slot::Leather, Slot::WoodDark][form],
        GeometrySet::Industrial => [Slot::Wood, Slot::MetalDark, Slot::Leather, Slot::Wood][form],
        GeometrySet::Budget => [Slot::Plastic, Slot::PaintedAccent, Slot::PlasticDark, Slot::Plastic][form],
    };
    let seat = lathe(&profile.map(|(share, rise)| (share * radius, rise * thickness)), 16);
    let stretch = DVec3::new(bay.width(), radius * 2.0, bay.depth()) / (radius * 2.0);
    builder.add(slot, seat.stretched(stretch).moved(0.0, bay.high.y, 0.0));
    let under = bay.with_y([0.0, bay.high.y - thickness + SINK]);
    if form == 2 && draft.set() != GeometrySet::Traditional {
        stool_column(draft, builder, under, radius);
    } else {
        stool_legs(draft, builder, under, form);
    }
}

/// A column on a disc, with a ring for the feet on high ones.
fn stool_column(draft: &Draft, builder: &mut Builder, under: Bay, radius: f64) {
    let slot = if draft.set() == GeometrySet::Plain { Slot::Chrome } else { Slot::MetalDark };
    let high = under.high.y;
    let foot = [
        (radius * 0.98, 0.0),
        (radius * 0.96, 0.012),
        (radius * 0.25, 0.03),
        (0.022, 0.05),
        (0.022, high * 0.55),
        (0.016, high * 0.56),
        (0.016, high - 0.02),
        (radius * 0.4, high),
    ];
    builder.add(slot, lathe(&foot, 12));
    if high > 0.55 {
        let y = high * 0.35;
        builder.add(
            slot,
            lathe(&[(radius * 0.6, y - 0.008), (radius * 0.66, y), (radius * 0.6, y + 0.008)], 12),
        );
    }
}

/// Four slanted legs with stretchers.
fn stool_legs(draft: &Draft, builder: &mut Builder, under: Bay, form: usize) {
    let (slot, profile, thick): (_, &[(f64, f64)], _) = match draft.set() {
        GeometrySet::Plain => ([Slot::Wood, Slot::Wood, Slot::Wood, Slot::MetalDark][form], &CONE, 0.019),
        GeometrySet::Traditional => {
            ([Slot::Wood, Slot::Wood, Slot::WoodDark, Slot::WoodDark][form], &SPINDLE, 0.021)
        }
        GeometrySet::Industrial => (Slot::MetalDark, &[(1.0, 0.0), (1.0, 1.0)], 0.014),
        GeometrySet::Budget => (
            [Slot::Chrome, Slot::Metal, Slot::PlasticDark, Slot::Plastic][form],
            &[(1.0, 0.0), (1.0, 1.0)],
            [0.01, 0.01, 0.01, 0.02][form],
        ),
    };
    let spread = [0.95, 0.8, 0.9, 0.86][form] * std::f64::consts::FRAC_1_SQRT_2;
    let (x, z) = (under.high.x, under.high.z);
    let at = |share: f64, y: f64, end: f64| DVec3::new(x * share, y, end * z * share);
    for end in [-1.0, 1.0] {
        let ends = [at(spread, 0.0, end), at(spread * 0.66, under.high.y, end)];
        builder.add_pair(slot, slanted_leg(ends, thick, profile, 8));
    }
    let rise = if under.high.y > 0.55 { 0.34 } else { 0.45 };
    let share = spread * (1.0 - 0.34 * rise);
    let y = under.high.y * rise;
    let bar = thick * 0.55;
    for end in [-1.0, 1.0] {
        builder.add(slot, sweep(&[at(-share, y, end), at(share, y, end)], bar, 6));
        let side = y + thick * 1.5;
        builder.add(
            slot,
            sweep(
                &[
                    DVec3::new(end * x * share, side, -z * share),
                    DVec3::new(end * x * share, side, z * share),
                ],
                bar,
                6,
            ),
        );
    }
}
