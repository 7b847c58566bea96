//! Stools at bars and kitchen islands: seats 0.65 to 0.80 m high, a rest for the feet 0.25 to 0.32 m over the floor
//! (DIN 68881).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::slanted_leg;
use crate::recipes::kit::{Bay, Builder, Station, cuboid, cylinder, lathe, pipe, rounded_box, sheet, sweep};
use crate::recipes::{GeometrySet, Slot};

/// Share of the height at which the feet rest.
const REST: f64 = 0.36;
/// Metres of a tube's radius.
const TUBE: f64 = 0.011;

/// How thick the legs of a stool are, and how far out they begin, as a share.
struct Legs {
    thick: f64,
    top: f64,
}

/// The measures that all bar stools share.
struct BarStool {
    bay: Bay,
    half: f64,
    high: f64,
    form: usize,
}

impl BarStool {
    /// A point at a share of the half width, a height, and a share of the half depth.
    fn at(&self, across: f64, y: f64, forward: f64) -> DVec3 {
        DVec3::new(across * self.half, y, forward * self.half)
    }

    /// Four legs from under the seat outwards, and bars between them at the rest's height.
    fn legs(&self, builder: &mut Builder, slot: Slot, bar: Slot, form: Legs) {
        let Legs { thick, top } = form;
        let out = 1.0 - thick / self.half;
        let high = self.high - 0.026;
        for z in [-1.0, 1.0] {
            let ends = [self.at(out, 0.0, out * z), self.at(top, high, top * z)];
            builder.add_pair(slot, slanted_leg(ends, thick, &[(0.75, 0.0), (1.0, 1.0)], 6));
        }
        let share = out + (top - out) * REST;
        let y = self.high * REST;
        for z in [-1.0, 1.0] {
            builder.add(
                bar,
                sweep(&[self.at(-share, y, share * z), self.at(share, y, share * z)], TUBE * 0.8, 6),
            );
        }
        let side = [self.at(share, y + TUBE, -share), self.at(share, y + TUBE, share)];
        builder.add_pair(bar, sweep(&side, TUBE * 0.8, 6));
    }
}

/// A bar stool of a set and a look, in a square box.
pub(super) fn bar_stool(set: GeometrySet, look: u32, builder: &mut Builder) {
    let bay = builder.bay();
    let half = bay.width().min(bay.depth()) / 2.0;
    let stool = BarStool { bay, half, high: bay.high.y, form: look as usize % 4 };
    match (set, stool.form) {
        (GeometrySet::Plain, 0 | 2) => saddle(&stool, builder),
        (GeometrySet::Plain, 1) => lift(&stool, builder, Slot::Leather),
        (GeometrySet::Plain, _) => lift(&stool, builder, Slot::FabricAccent),
        (GeometrySet::Traditional, _) => turned(&stool, builder),
        (GeometrySet::Industrial, 0 | 1) => pressed(&stool, builder),
        (GeometrySet::Industrial, _) => pipes(&stool, builder),
        (GeometrySet::Budget, 0 | 2) => bucket(&stool, builder),
        (GeometrySet::Budget, _) => stacking(&stool, builder),
    }
}

/// A seat of wood hollowed like a saddle, on slanted legs with a rest of steel.
fn saddle(stool: &BarStool, builder: &mut Builder) {
    let slot = if stool.form == 0 { Slot::Wood } else { Slot::WoodLight };
    let thick = 0.034;
    let station = |share: f64, wide: f64| Station {
        at: DVec3::new(0.0, stool.high - thick / 2.0 - 0.016, share * stool.bay.high.z),
        half_width: stool.half * wide,
        sag: 0.016,
    };
    let path = [station(0.995, 0.8), station(0.8, 0.97), station(-0.8, 0.97), station(-0.995, 0.8)];
    builder.add(slot, sheet(&path, DVec3::NEG_X, thick, 4));
    stool.legs(
        builder,
        if stool.form == 0 { Slot::Wood } else { Slot::MetalDark },
        Slot::MetalDark,
        Legs { thick: 0.018, top: 0.62 },
    );
}

/// A padded seat on a gas spring, with a hoop for the feet.
fn lift(stool: &BarStool, builder: &mut Builder, slot: Slot) {
    let (half, high) = (stool.half, stool.high);
    let pad = Bay::around(DVec3::new(0.0, high - 0.035, 0.0), half * 1.9, 0.07, half * 1.8);
    builder.add(slot, rounded_box(pad, DVec3::new(0.05, 0.03, 0.05), 2));
    let foot = [(half, 0.0), (half * 0.98, 0.01), (half * 0.3, 0.024), (0.026, 0.05)];
    builder.add(Slot::Chrome, lathe(&foot, 16));
    builder.add(Slot::Chrome, cylinder(0.025, [0.03, high * 0.62], 8));
    builder.add(Slot::MetalDark, cylinder(0.015, [high * 0.6, high - 0.06], 8));
    let y = high * REST;
    let hoop = [
        DVec3::new(0.0, y, 0.0),
        DVec3::new(-half * 0.5, y, half * 0.1),
        DVec3::new(-half * 0.5, y, half * 0.7),
        DVec3::new(half * 0.5, y, half * 0.7),
        DVec3::new(half * 0.5, y, half * 0.1),
        DVec3::new(0.001, y, 0.0),
    ];
    builder.add(Slot::Chrome, pipe(&hoop, 0.009, 0.03));
}

/// An upholstered drum over turned legs, a rail of brass for the feet.
fn turned(stool: &BarStool, builder: &mut Builder) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::WoodDark, Slot::Wood][stool.form];
    let cloth = [Slot::Leather, Slot::FabricAccent, Slot::Leather, Slot::FabricLight][stool.form];
    let radius = stool.half;
    let high = stool.high;
    let drum = [
        (radius * 0.96, high - 0.06),
        (radius, high - 0.05),
        (radius, high - 0.02),
        (radius * 0.9, high - 0.004),
        (radius * 0.4, high),
    ];
    builder.add(cloth, lathe(&drum, 16));
    builder.add(
        slot,
        lathe(
            &[(radius * 0.86, high - 0.1), (radius * 0.95, high - 0.085), (radius * 0.95, high - 0.058)],
            16,
        ),
    );
    let legs = [
        (0.6, 0.0),
        (0.8, 0.03),
        (0.55, 0.07),
        (0.7, 0.3),
        (1.1, 0.34),
        (1.1, 0.4),
        (0.6, 0.44),
        (1.0, 0.7),
        (0.6, 0.76),
        (0.95, 0.8),
        (0.95, 1.0),
    ];
    for z in [-1.0, 1.0] {
        let ends = [stool.at(0.68, 0.0, 0.68 * z), stool.at(0.58, high - 0.09, 0.58 * z)];
        builder.add_pair(slot, slanted_leg(ends, 0.022, &legs, 8));
    }
    let (y, share) = (high * REST, 0.645);
    for z in [-1.0, 1.0] {
        builder.add(
            Slot::Brass,
            sweep(&[stool.at(-share, y, share * z), stool.at(share, y, share * z)], 0.008, 6),
        );
    }
    let side = [stool.at(share, y + 0.002, -share), stool.at(share, y + 0.002, share)];
    builder.add_pair(slot, sweep(&side, 0.0085, 6));
}

/// Sheet steel: a square seat with a hole to carry it, legs of channels that widen upwards.
fn pressed(stool: &BarStool, builder: &mut Builder) {
    let slot = [Slot::MetalDark, Slot::PaintedAccent][stool.form];
    let (half, high) = (stool.half, stool.high);
    let seat = Bay::around(DVec3::new(0.0, high - 0.02, 0.0), half * 1.56, 0.04, half * 1.56);
    builder.add(slot, rounded_box(seat, DVec3::new(0.03, 0.012, 0.03), 1));
    let hole = Bay::around(DVec3::new(0.0, high - 0.001, 0.0), half * 0.3, 0.003, half * 0.08);
    builder.cuboid(Slot::PlasticDark, hole);
    for z in [-1.0, 1.0] {
        let ends = [stool.at(0.94, 0.0, 0.94 * z), stool.at(0.68, high - 0.02, 0.68 * z)];
        builder.add_pair(slot, slanted_leg(ends, 0.03, &[(0.6, 0.0), (1.2, 1.0)], 4));
    }
    let (y, share) = (high * REST, 0.85);
    for z in [-1.0, 1.0] {
        let bar = Bay::around(stool.at(0.0, y, share * z), half * share * 2.0, 0.024, 0.005);
        builder.cuboid(slot, bar);
    }
    let side = Bay::around(stool.at(share, y + 0.002, 0.0), 0.005, 0.0236, half * share * 2.0);
    builder.add_pair(slot, cuboid(side));
}

/// Water pipe with tees and flanges under a thick round of wood.
fn pipes(stool: &BarStool, builder: &mut Builder) {
    let (half, high) = (stool.half, stool.high);
    let thick = 0.04;
    builder.add(
        if stool.form == 2 { Slot::Wood } else { Slot::WoodDark },
        lathe(
            &[
                (half * 0.98, high - thick),
                (half, high - thick * 0.8),
                (half, high - 0.004),
                (half * 0.97, high),
            ],
            16,
        ),
    );
    let post = 0.6;
    let tube = 0.014;
    for z in [-1.0, 1.0] {
        let at = stool.at(post, 0.0, post * z);
        builder.add_pair(
            Slot::MetalDark,
            cylinder(tube, [0.012, high - thick + 0.001], 8).moved(at.x, 0.0, at.z),
        );
        builder.add_pair(
            Slot::Metal,
            cylinder(tube * 2.2, [high - thick - 0.006, high - thick + 0.002], 8).moved(at.x, 0.0, at.z),
        );
        builder.add_pair(Slot::Rubber, cylinder(tube * 1.2, [0.0, 0.02], 8).moved(at.x, 0.0, at.z));
        let y = high * REST;
        builder.add(
            Slot::MetalDark,
            sweep(&[stool.at(-post, y, post * z), stool.at(post, y, post * z)], tube * 0.9, 6),
        );
        builder.add_pair(Slot::Metal, cylinder(tube * 1.5, [y - 0.02, y + 0.02], 6).moved(at.x, 0.0, at.z));
    }
    let y = high * REST * 0.6;
    let side = [stool.at(post, y, -post), stool.at(post, y, post)];
    builder.add_pair(Slot::MetalDark, sweep(&side, tube * 0.9, 6));
}

/// A low shell of plastic on a chromed column.
fn bucket(stool: &BarStool, builder: &mut Builder) {
    let slot = if stool.form == 0 { Slot::PaintedAccent } else { Slot::PlasticDark };
    let (half, high) = (stool.half, stool.high);
    let seat = high * 0.86;
    let station = |z: f64, y: f64, wide: f64, sag: f64| Station {
        at: DVec3::new(0.0, y, z * half),
        half_width: half * wide,
        sag,
    };
    let path = [
        station(0.98, seat - 0.03, 0.78, 0.0),
        station(0.8, seat, 0.92, 0.02),
        station(0.0, seat - 0.01, 0.99, 0.05),
        station(-0.64, seat - 0.004, 0.96, 0.055),
        station(-0.86, seat + 0.04, 0.9, 0.04),
        station(-0.95, high - 0.003, 0.78, 0.02),
    ];
    builder.add(slot, sheet(&path, DVec3::NEG_X, 0.012, 4));
    let foot = [(half, 0.0), (half * 0.97, 0.012), (half * 0.24, 0.03), (0.024, 0.06)];
    builder.add(Slot::Chrome, lathe(&foot, 16));
    builder.add(Slot::Chrome, cylinder(0.0235, [0.03, seat * 0.6], 8));
    builder.add(Slot::PlasticDark, cylinder(0.015, [seat * 0.58, seat - 0.02], 8));
    let y = high * REST;
    let step = [DVec3::new(-half * 0.5, y, half * 0.5), DVec3::new(half * 0.5, y, half * 0.5)];
    builder.add(Slot::Chrome, sweep(&step, 0.01, 6));
    for x in [-0.3, 0.3] {
        let stay = [DVec3::new(0.0, y - 0.01, 0.0), DVec3::new(x * half, y, half * 0.5)];
        builder.add(Slot::Chrome, sweep(&stay, 0.007, 5));
    }
}

/// A thin round pad on four bent tubes.
fn stacking(stool: &BarStool, builder: &mut Builder) {
    let (slot, frame) =
        if stool.form == 1 { (Slot::Plastic, Slot::Metal) } else { (Slot::Leaf, Slot::Chrome) };
    let radius = stool.half * 0.9;
    let high = stool.high;
    builder.add(
        slot,
        lathe(
            &[
                (radius * 0.96, high - 0.03),
                (radius, high - 0.02),
                (radius, high - 0.008),
                (radius * 0.92, high),
            ],
            16,
        ),
    );
    let plate = stool.bay.slab(Side::Above, 0.04).without(Side::Above, 0.026);
    builder.cuboid(frame, plate.inset(stool.half * 0.5, 0.0, stool.half * 0.5));
    stool.legs(builder, frame, frame, Legs { thick: TUBE, top: 0.56 });
}
