//! Round tables on one column. The foot is half as wide as the top and at most 8 cm high, so that feet find room.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use super::top_of;
use crate::recipes::kit::Bay;
use crate::recipes::kit::{Builder, Outline, SINK, Slice, cuboid, cylinder, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A round top on a column with a foot of the set.
pub(in super::super) static ROUND_TABLE: Recipe =
    Recipe::furniture("round_table", [1.1, 1.1, 0.74]).every_set(round_table);

fn round_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let top = if draft.set() == GeometrySet::Budget { top_of(bay) * 0.7 } else { top_of(bay) };
    round_top(draft, builder, top);
    let foot = Foot { radius: half.x.min(half.z) * 0.5, end: bay.height() - top * 0.5 };
    match draft.set() {
        GeometrySet::Plain => plain(&foot, builder, draft.form()),
        GeometrySet::Traditional => traditional(&foot, builder, draft.form()),
        GeometrySet::Industrial => industrial(&foot, builder, draft.form()),
        GeometrySet::Budget => budget(&foot, builder, draft.form()),
    }
}

/// A top of a thickness: chamfered, moulded, bound in steel, or a thin board.
fn round_top(draft: &Draft, builder: &mut Builder, top: f64) {
    let (half, height, form) = (builder.bay().extent() / 2.0, builder.bay().height(), draft.form());
    // From the upper side downwards in thicknesses, and metres in from the edge.
    let slice = |down: f64, back: f64| Slice::new(height - top * down, half.x - back, half.z - back);
    let (slot, slices) = match draft.set() {
        GeometrySet::Traditional => {
            (Slot::Wood, vec![slice(1.0, 0.015), slice(0.5, 0.0), slice(0.2, 0.0), slice(0.0, 0.006)])
        }
        GeometrySet::Plain if form == 2 => {
            (Slot::Stone, vec![slice(0.6, 0.03), slice(0.25, 0.0), slice(0.0, 0.002)])
        }
        GeometrySet::Budget => (
            [Slot::Laminate, Slot::Plastic, Slot::Laminate, Slot::WoodLight][form],
            vec![slice(1.0, 0.002), slice(0.75, 0.0), slice(0.0, 0.0)],
        ),
        _ => (Slot::Wood, vec![slice(1.0, 0.004), slice(0.7, 0.0), slice(0.0, 0.0)]),
    };
    builder.add(slot, loft(&Outline::Round(28), &slices));
    if draft.set() == GeometrySet::Industrial && form.is_multiple_of(2) {
        let band = [slice(0.9, 0.0), slice(0.25, 0.0)];
        let band = band.map(|slice| Slice { half: slice.half * 1.003, ..slice });
        builder.add(Slot::MetalDark, loft(&Outline::Round(28), &band));
    }
}

/// The arms of a foot, each a rod of so many sides.
struct Arms {
    slot: Slot,
    count: u32,
    thickness: f64,
    sides: usize,
}

struct Foot {
    /// Metres from the middle to the end of the foot.
    radius: f64,
    /// Metres of the column's top.
    end: f64,
}

impl Foot {
    fn turned(&self, shares: &[(f64, f64)], sides: usize) -> crate::recipes::kit::Solid {
        let profile: Vec<(f64, f64)> = shares
            .iter()
            .map(|&(share, y)| (share * self.radius, if y < 0.0 { self.end + y + 1.0 } else { y }))
            .collect();
        lathe(&profile, sides)
    }

    /// Arms around the column through (radius as a share, height).
    fn arms(&self, builder: &mut Builder, form: &Arms, path: &[(f64, f64)]) {
        let &Arms { slot, count, thickness, sides } = form;
        for step in 0..count {
            let angle = TAU * f64::from(step) / f64::from(count) + 0.4;
            let points: Vec<DVec3> =
                path.iter().map(|&(out, y)| DVec3::new(0.0, y, out * self.radius)).collect();
            builder.add(slot, sweep(&points, thickness, sides).turned_y(angle));
        }
    }

    /// A plate under the top that the column ends in.
    fn plate(&self, builder: &mut Builder, slot: Slot) {
        let share = 0.55;
        let low = self.end - 0.03;
        builder.add(slot, lathe(&[(self.radius * share, low), (self.radius * share, self.end)], 12));
    }
}

fn plain(foot: &Foot, builder: &mut Builder, form: usize) {
    match form {
        0 => builder.add(
            Slot::MetalDark,
            foot.turned(
                &[
                    (1.0, 0.0),
                    (1.0, 0.012),
                    (0.2, 0.026),
                    (0.13, 0.05),
                    (0.13, -1.05),
                    (0.5, -1.02),
                    (0.5, -1.0),
                ],
                16,
            ),
        ),
        1 | 2 => {
            let slot = if form == 1 { Slot::Painted } else { Slot::Metal };
            let cone = [
                (1.0, 0.0),
                (0.98, 0.01),
                (0.62, 0.045),
                (0.3, 0.08),
                (0.17, 0.2),
                (0.15, foot.end * 0.5),
                (0.19, foot.end * 0.8),
                (0.36, -1.0),
            ];
            builder.add(slot, foot.turned(&cone, 20));
        }
        _ => {
            builder.add(Slot::Wood, foot.turned(&[(0.16, 0.03), (0.18, foot.end * 0.5), (0.16, -1.0)], 12));
            foot.arms(
                builder,
                &Arms { slot: Slot::Wood, count: 4, thickness: 0.022, sides: 4 },
                &[(0.05, 0.055), (0.6, 0.045), (1.0, 0.0175)],
            );
            let rail = Bay::new(
                [-foot.radius * 0.9, foot.radius * 0.9],
                [foot.end - 0.04, foot.end - 0.004],
                [-0.02, 0.02],
            );
            builder.add(Slot::Wood, cuboid(rail));
            builder.add(Slot::Wood, cuboid(rail).moved(0.0, -0.001, 0.0).turned_y(FRAC_PI_2));
        }
    }
}

fn traditional(foot: &Foot, builder: &mut Builder, form: usize) {
    let slot = if form.is_multiple_of(2) { Slot::Wood } else { Slot::WoodDark };
    let vase = vase(foot.end, form);
    builder.add(slot, foot.turned(&vase, 14));
    match form {
        0 => foot.arms(
            builder,
            &Arms { slot, count: 3, thickness: 0.024, sides: 6 },
            &[(0.1, 0.1), (0.45, 0.085), (0.8, 0.035), (1.02, 0.02)],
        ),
        1 => builder.add(
            slot,
            foot.turned(&[(0.92, 0.0), (1.0, 0.02), (0.95, 0.035), (0.6, 0.05), (0.3, 0.062)], 16),
        ),
        2 => foot.arms(
            builder,
            &Arms { slot, count: 4, thickness: 0.026, sides: 4 },
            &[(0.1, 0.09), (0.5, 0.08), (0.75, 0.03), (1.0, 0.022)],
        ),
        _ => {
            let plate = foot.radius * 0.72;
            builder.block(slot, Bay::new([-plate, plate], [0.018, 0.05], [-plate, plate]), 0.012);
            for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let bun = lathe(&[(0.022, 0.0), (0.03, 0.01), (0.02, 0.0195)], 8);
                builder.add(slot, bun.moved(x * plate * 0.8, 0.0, z * plate * 0.8));
            }
        }
    }
}

/// The profile of a turned column that ends at a height: (share of the foot's radius, height).
fn vase(end: f64, form: usize) -> [(f64, f64); 9] {
    match form {
        0 | 3 => [
            (0.26, 0.03),
            (0.3, 0.09),
            (0.18, 0.12),
            (0.2, end * 0.3),
            (0.34, end * 0.48),
            (0.2, end * 0.7),
            (0.16, end * 0.8),
            (0.3, end * 0.84),
            (0.42, end),
        ],
        _ => [
            (0.26, 0.03),
            (0.26, 0.1),
            (0.36, 0.14),
            (0.36, end * 0.34),
            (0.2, end * 0.4),
            (0.24, end * 0.6),
            (0.26, end * 0.85),
            (0.38, end * 0.9),
            (0.5, end),
        ],
    }
}

fn industrial(foot: &Foot, builder: &mut Builder, form: usize) {
    let slot = Slot::MetalDark;
    foot.plate(builder, slot);
    match form {
        0 => {
            builder.add(slot, foot.turned(&[(0.15, 0.03), (0.15, -1.02)], 10));
            foot.arms(
                builder,
                &Arms { slot, count: 4, thickness: 0.02, sides: 4 },
                &[(0.05, 0.05), (0.7, 0.05), (1.0, 0.012)],
            );
        }
        1 => {
            builder.add(
                slot,
                foot.turned(
                    &[
                        (1.0, 0.0),
                        (1.0, 0.014),
                        (0.95, 0.018),
                        (0.28, 0.02),
                        (0.28, 0.04),
                        (0.11, 0.042),
                        (0.11, -1.02),
                    ],
                    20,
                ),
            );
            for y in [0.12, foot.end - 0.09] {
                builder.add(Slot::Metal, cylinder(foot.radius * 0.18, [y, y + 0.04], 8));
            }
        }
        2 => screw(foot, builder),
        _ => rods(foot, builder),
    }
}

/// Four bent rods, held by a ring.
fn rods(foot: &Foot, builder: &mut Builder) {
    let slot = Slot::MetalDark;
    for step in 0..4 {
        let angle = TAU * (f64::from(step) + 0.5) / 4.0;
        let at = |out: f64, y: f64| DVec3::new(0.0, y, foot.radius * out);
        builder.add(
            slot,
            sweep(&[at(1.0, 0.012), at(0.24, 0.05), at(0.24, foot.end - 0.02)], 0.012, 6).turned_y(angle),
        );
    }
    let ring = cylinder(foot.radius * 0.32, [foot.end * 0.5, foot.end * 0.5 + 0.02], 12);
    builder.add(Slot::Metal, ring);
}

/// A screw on three arms.
fn screw(foot: &Foot, builder: &mut Builder) {
    let slot = Slot::MetalDark;
    builder.add(Slot::Metal, foot.turned(&[(0.13, 0.1), (0.13, -1.02)], 8));
    for step in 1..9 {
        let y = foot.end * (0.25 + 0.075 * f64::from(step));
        builder.add(Slot::Metal, cylinder(foot.radius * 0.16, [y, y + 0.008], 8));
    }
    builder.add(slot, foot.turned(&[(0.22, 0.03), (0.24, 0.1), (0.24, 0.16), (0.16, 0.18)], 10));
    foot.arms(
        builder,
        &Arms { slot, count: 3, thickness: 0.024, sides: 6 },
        &[(0.1, 0.08), (0.5, 0.07), (1.0, 0.02)],
    );
}

fn budget(foot: &Foot, builder: &mut Builder, form: usize) {
    match form {
        0 => {
            builder.add(Slot::Chrome, foot.turned(&[(0.12, 0.03), (0.12, -1.0)], 10));
            builder.add(Slot::Chrome, foot.turned(&[(1.0, 0.0), (0.97, 0.008), (0.2, 0.036)], 18));
            foot.plate(builder, Slot::MetalDark);
        }
        1 => builder.add(
            Slot::Plastic,
            foot.turned(
                &[(1.0, 0.0), (0.9, 0.02), (0.4, 0.06), (0.22, 0.16), (0.2, foot.end * 0.7), (0.4, -1.0)],
                16,
            ),
        ),
        2 => {
            builder.add(Slot::MetalDark, foot.turned(&[(0.11, 0.03), (0.11, -1.0)], 8));
            foot.arms(
                builder,
                &Arms { slot: Slot::MetalDark, count: 4, thickness: 0.017, sides: 4 },
                &[(0.02, 0.045), (1.0, 0.014)],
            );
            foot.plate(builder, Slot::MetalDark);
        }
        _ => {
            for step in 0..3 {
                let angle = TAU * f64::from(step) / 3.0;
                let at = |out: f64, y: f64| DVec3::new(0.0, y, foot.radius * out);
                builder.add(
                    Slot::WoodLight,
                    sweep(&[at(0.98, 0.01), at(0.3, 0.06), at(0.18, foot.end - SINK)], 0.014, 6)
                        .turned_y(angle),
                );
            }
            foot.plate(builder, Slot::WoodLight);
        }
    }
}
