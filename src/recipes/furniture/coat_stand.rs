//! Stands for coats: 1.70 to 1.85 m high, 0.4 to 0.5 m across, hooks from 1.4 m upwards.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use super::parts::slanted_leg;
use crate::recipes::kit::{Bay, Builder, Solid, cuboid, cylinder, lathe, pipe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Pieces around a post: how many, and radians of the first from the front.
struct Ring {
    count: u32,
    first: f64,
}

/// A stand drawn in a circle and stretched where its box is not square.
struct Stand {
    radius: f64,
    high: f64,
    stretch: DVec3,
}

impl Stand {
    fn place(&self, builder: &mut Builder, slot: Slot, solid: Solid) {
        builder.add(slot, solid.stretched(self.stretch));
    }

    /// `count` copies of a piece around the middle, the first turned by `first` radians.
    fn around(&self, builder: &mut Builder, slot: Slot, ring: Ring, piece: &Solid) {
        let Ring { count, first } = ring;
        for step in 0..count {
            let turn = TAU * f64::from(step) / f64::from(count) + first;
            self.place(builder, slot, piece.clone().turned_y(turn));
        }
    }

    /// A point in front of the middle.
    fn at(&self, rise: f64, reach: f64) -> DVec3 {
        DVec3::new(0.0, self.high * rise, self.radius * reach)
    }
}

/// A stand with hooks: of slim poles, bentwood, pipe, or thin tube.
pub(super) static COAT_RACK: Recipe = Recipe::furniture("coat_rack", [0.5, 0.5, 1.8]).every_set(coat_rack);

fn coat_rack(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let stretch = DVec3::new(1.0, 1.0, bay.depth() / bay.width());
    let stand = Stand { radius: bay.width() / 2.0, high: bay.high.y, stretch };
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => match form {
            0 => leaning_poles(&stand, builder),
            1 => pegs_on_a_post(&stand, builder, Slot::WoodLight),
            2 => disc_and_loops(&stand, builder),
            _ => pegs_on_a_post(&stand, builder, Slot::Painted),
        },
        GeometrySet::Traditional => bentwood(&stand, builder, form),
        GeometrySet::Industrial => pipes(&stand, builder, form),
        GeometrySet::Budget => thin_tube(&stand, builder, form),
    }
}

/// Three poles that cross high up, with a peg on each.
fn leaning_poles(stand: &Stand, builder: &mut Builder) {
    let pole = 0.016;
    let foot = stand.at(0.0, 1.0) - DVec3::Z * pole;
    let top = DVec3::new(0.03, stand.high, -stand.radius * 0.55);
    let shape = slanted_leg([foot, top], pole, &[(0.75, 0.0), (1.0, 0.5), (0.75, 1.0)], 8);
    stand.around(builder, Slot::Wood, Ring { count: 4, first: 0.0 }, &shape);
    for rise in [0.82, 0.95] {
        let at = foot.lerp(top, rise);
        let peg = sweep(&[at, at + DVec3::new(0.02, 0.05, -0.1)], 0.009, 6);
        stand.around(builder, Slot::MetalDark, Ring { count: 4, first: 0.0 }, &peg);
    }
    stand.place(builder, Slot::MetalDark, cylinder(0.055, [stand.high * 0.66, stand.high * 0.675], 10));
}

/// A square post on a cross, with round pegs that climb around it.
fn pegs_on_a_post(stand: &Stand, builder: &mut Builder, slot: Slot) {
    let half = 0.02;
    stand.place(builder, slot, cuboid(Bay::new([-half, half], [0.03, stand.high], [-half, half])));
    let foot = Bay::new([-0.024, 0.024], [0.0, 0.045], [-stand.radius, stand.radius]);
    stand.place(builder, slot, cuboid(foot));
    let across = Bay::new([-stand.radius, stand.radius], [0.0006, 0.046], [-0.0236, 0.0236]);
    stand.place(builder, slot, cuboid(across));
    for step in 0..8 {
        let rise = 0.72 + 0.03 * f64::from(step);
        let peg = sweep(&[stand.at(rise, 0.04), stand.at(rise + 0.018, 0.5)], 0.011, 6);
        stand.place(builder, Slot::Wood, peg.turned_y(FRAC_PI_2 * f64::from(step)));
    }
}

/// A thin tube on a disc of steel, its ends bent to loops.
fn disc_and_loops(stand: &Stand, builder: &mut Builder) {
    let slot = Slot::MetalDark;
    let disc = [(stand.radius, 0.0), (stand.radius, 0.012), (stand.radius * 0.96, 0.016)];
    stand.place(builder, slot, lathe(&disc, 20));
    stand.place(builder, slot, cylinder(0.014, [0.01, stand.high - 0.02], 8));
    for (rise, first) in [(0.94, 0.0), (0.84, 0.8)] {
        let bow = [
            stand.at(rise, 0.02),
            stand.at(rise - 0.02, 0.34),
            stand.at(rise + 0.025, 0.6),
            stand.at(rise + 0.04, 0.3),
        ];
        stand.around(builder, slot, Ring { count: 3, first }, &pipe(&bow, 0.008, 0.04));
    }
    stand.place(
        builder,
        Slot::Wood,
        lathe(
            &[
                (0.0, stand.high - 0.05),
                (0.02, stand.high - 0.03),
                (0.02, stand.high - 0.01),
                (0.012, stand.high),
            ],
            8,
        ),
    );
}

/// A turned column, and one with more rings: (share of its radius, share of its height).
const PLAIN_COLUMN: [(f64, f64); 9] = [
    (0.9, 0.06),
    (1.0, 0.3),
    (1.35, 0.32),
    (0.9, 0.34),
    (0.8, 0.93),
    (1.2, 0.95),
    (0.6, 0.965),
    (1.1, 0.982),
    (0.4, 1.0),
];
const RICH_COLUMN: [(f64, f64); 9] = [
    (1.3, 0.05),
    (0.8, 0.08),
    (1.3, 0.2),
    (0.7, 0.36),
    (1.1, 0.4),
    (0.8, 0.45),
    (0.75, 0.92),
    (1.3, 0.96),
    (0.3, 1.0),
];

/// A turned column on four bent legs, with double hooks in the form of an S and a ring for umbrellas (Thonet).
fn bentwood(stand: &Stand, builder: &mut Builder, form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::WoodDark, Slot::Wood][form];
    let column = if form.is_multiple_of(2) { &PLAIN_COLUMN } else { &RICH_COLUMN };
    let column: Vec<(f64, f64)> = column.iter().map(|&(r, rise)| (r * 0.021, rise * stand.high)).collect();
    stand.place(builder, slot, lathe(&column, 8));
    let leg = [stand.at(0.24, 0.06), stand.at(0.14, 0.3), stand.at(0.09, 0.62), stand.at(0.008, 0.95)];
    stand.around(builder, slot, Ring { count: 4, first: 0.0 }, &sweep(&leg, 0.0125, 6));
    let hook = [
        stand.at(0.8, 0.06),
        stand.at(0.785, 0.3),
        stand.at(0.82, 0.5),
        stand.at(0.885, 0.46),
        stand.at(0.92, 0.62),
        stand.at(0.965, 0.78),
    ];
    stand.around(
        builder,
        slot,
        Ring { count: if form < 2 { 4 } else { 6 }, first: 0.0 },
        &sweep(&hook, 0.01, 6),
    );
    if form != 1 {
        let ring: Vec<DVec3> = (0..=10)
            .map(|step| {
                let (sine, cosine) = libm::sincos(TAU * (f64::from(step) * 0.0995 + 0.001));
                DVec3::new(cosine * stand.radius * 0.5, stand.high * 0.33, sine * stand.radius * 0.5)
            })
            .collect();
        stand.place(builder, slot, sweep(&ring, 0.008, 6));
        for turn in [0.0, FRAC_PI_2] {
            let spoke = sweep(&[stand.at(0.33, -0.5), stand.at(0.33, 0.5)], 0.006, 4);
            stand.place(builder, slot, spoke.turned_y(turn).moved(0.0, turn * 0.003, 0.0));
        }
    }
}

/// Water pipe on a flange or on four legs of pipe, with tees as hooks and a valve wheel on top of some.
fn pipes(stand: &Stand, builder: &mut Builder, form: usize) {
    let slot = [Slot::MetalDark, Slot::Metal, Slot::MetalDark, Slot::Metal][form];
    let tube = 0.017;
    let head = if form.is_multiple_of(2) { 0.03 } else { 0.0 };
    stand.place(builder, slot, cylinder(tube, [0.02, stand.high - head], 8));
    if form < 2 {
        let disc = [(stand.radius, 0.0), (stand.radius, 0.025)];
        stand.place(builder, [Slot::Wood, Slot::MetalDark][form], lathe(&disc, [16, 8][form]));
        stand.place(builder, slot, lathe(&[(0.06, 0.02), (0.06, 0.032), (0.03, 0.036), (0.03, 0.06)], 10));
    }
    if form >= 2 {
        let leg = [stand.at(0.1, 0.05), stand.at(0.1, 0.86), stand.at(0.0, 0.93)];
        stand.around(builder, slot, Ring { count: 4, first: 0.0 }, &pipe(&leg, tube * 0.95, 0.05));
    }
    for (rise, first) in [(0.92, 0.0), (0.82, FRAC_PI_2)] {
        let arm = [stand.at(rise, 0.03), stand.at(rise, 0.62), stand.at(rise + 0.035, 0.62)];
        stand.around(builder, slot, Ring { count: 2, first }, &pipe(&arm, tube * 0.8, 0.02));
        let tee = cylinder(tube * 1.5, [stand.high * (rise - 0.018), stand.high * (rise + 0.018)], 8);
        stand.place(builder, slot, tee);
    }
    if head > 0.0 {
        let wheel = [
            (0.02, stand.high - 0.035),
            (0.055, stand.high - 0.02),
            (0.062, stand.high - 0.008),
            (0.05, stand.high),
            (0.012, stand.high - 0.01),
        ];
        stand.place(builder, Slot::PaintedAccent, lathe(&wheel, 10));
    }
}

/// Chromed or painted tube with hooks that end in plastic balls, on a small foot.
fn thin_tube(stand: &Stand, builder: &mut Builder, form: usize) {
    let slot = [Slot::Chrome, Slot::MetalDark, Slot::Painted, Slot::Chrome][form];
    let tip = [Slot::PlasticDark, Slot::Plastic, Slot::PaintedAccent, Slot::Plastic][form];
    stand.place(builder, slot, cylinder(0.013, [0.02, stand.high - 0.02], 8));
    if form.is_multiple_of(2) {
        let disc =
            [(stand.radius, 0.0), (stand.radius * 0.98, 0.015), (stand.radius * 0.2, 0.03), (0.02, 0.05)];
        stand.place(builder, if form == 0 { Slot::PlasticDark } else { slot }, lathe(&disc, 16));
    } else {
        let leg = [stand.at(0.16, 0.03), stand.at(0.06, 0.5), stand.at(0.006, 0.96)];
        stand.around(builder, slot, Ring { count: 4, first: 0.0 }, &sweep(&leg, 0.009, 6));
    }
    let count = 4;
    for (rise, first, reach) in [(0.9, 0.0, 0.5), (0.8, 0.78, 0.66)] {
        let hook =
            [stand.at(rise - 0.03, 0.04), stand.at(rise - 0.015, reach * 0.7), stand.at(rise + 0.03, reach)];
        stand.around(builder, slot, Ring { count, first }, &sweep(&hook, 0.006, 5));
        let end = stand.at(rise + 0.03, reach);
        let ball = lathe(&[(0.009, -0.016), (0.017, 0.0), (0.009, 0.016)], 6).moved(0.0, end.y, end.z);
        stand.around(builder, tip, Ring { count, first }, &ball);
    }
    let knob = [(0.012, stand.high - 0.03), (0.022, stand.high - 0.014), (0.012, stand.high)];
    stand.place(builder, tip, lathe(&knob, 8));
}
