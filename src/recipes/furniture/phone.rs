//! Telephones on desks: 0.18 to 0.22 m wide and deep; receivers are 0.20 to 0.22 m long.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Solid, cuboid, extrude, lathe, rounded_box, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Share of the height that the upper edge of a sloping case takes; the receiver stands over it.
const RISE: f64 = 0.76;
/// Share of the height of its lower edge.
const LIP: f64 = 0.18;

/// A telephone: a sloping case with keys and a screen, one with a dial, a flat one of steel, or a handset in a cradle.
pub(super) static PHONE: Recipe = Recipe::accessory("phone", [0.2, 0.22, 0.1]).every_set(phone);

fn phone(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => {
            desk_phone(builder, [Slot::PlasticDark, Slot::PlasticDark, Slot::Plastic, Slot::MetalDark][form])
        }
        GeometrySet::Traditional => {
            dial_phone(builder, [Slot::PlasticDark, Slot::Book, Slot::Linen, Slot::Leather][form])
        }
        GeometrySet::Industrial => {
            steel_phone(builder, [Slot::Metal, Slot::PaintedAccent, Slot::MetalDark, Slot::Metal][form])
        }
        GeometrySet::Budget => {
            cordless(builder, [Slot::PlasticDark, Slot::Plastic, Slot::PaintedAccent, Slot::Plastic][form])
        }
    }
}

/// A wedge that slopes to the front, and how pieces lie on its slope.
struct Slope {
    low: f64,
    rise: f64,
    angle: f64,
    length: f64,
}

impl Slope {
    fn new(bay: Bay) -> Self {
        let rise = bay.height() * RISE;
        let angle = libm::atan2(rise - bay.height() * LIP, bay.depth());
        Self { low: bay.low.z, rise, angle, length: bay.depth() / libm::cos(angle) }
    }

    /// A solid that was built flat with the top edge of the slope at the origin.
    fn lay(&self, solid: Solid) -> Solid {
        solid.turned_x(self.angle).moved(0.0, self.rise, self.low)
    }

    /// A plate on the slope between shares of its length.
    fn plate(&self, x: [f64; 2], along: [f64; 2], thickness: f64) -> Solid {
        let z = along.map(|share| share * self.length);
        self.lay(cuboid(Bay::new(x, [-SINK * 2.0, thickness], z)))
    }

    /// Four rows of three keys between two ends along x.
    fn keys(&self, builder: &mut Builder, slot: Slot, [left, right]: [f64; 2], thickness: f64) {
        for row in 0..4 {
            let along = 0.45 + 0.12 * f64::from(row);
            for column in 0..3 {
                let x = left + (right - left) * 0.36 * f64::from(column);
                let key = self.plate([x, x + (right - left) * 0.28], [along, along + 0.08], thickness);
                builder.add(slot, key);
            }
        }
    }
}

/// The case of a sloping telephone.
fn case(builder: &mut Builder, slot: Slot) -> Slope {
    let bay = builder.bay();
    let (low, high) = (bay.low.z, bay.high.z);
    let wedge = [(high, 0.0), (high, bay.height() * LIP), (low, bay.height() * RISE), (low, 0.0)];
    builder.add(slot, extrude(&wedge.map(DVec2::from), Axis::X, bay.x()));
    Slope::new(bay)
}

/// Keys under a screen on the right, the receiver along the left.
fn desk_phone(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let slope = case(builder, slot);
    let ends = [-bay.width() * 0.08, bay.high.x - bay.width() * 0.08];
    builder.add(Slot::Screen, slope.plate(ends, [0.1, 0.35], 0.002));
    slope.keys(builder, if slot == Slot::Plastic { Slot::MetalDark } else { Slot::Plastic }, ends, 0.004);
    let receiver = Bay::new(
        [bay.low.x + bay.width() * 0.07, bay.low.x + bay.width() * 0.31],
        [-0.002, bay.height() * 0.27],
        [slope.length * 0.05, slope.length * 0.95],
    );
    builder.add(slot, slope.lay(rounded_box(receiver, DVec3::splat(bay.height() * 0.08), 1)));
}

/// A case that narrows upwards, a dial with its stop, and a receiver across the top.
fn dial_phone(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (high, back) = (bay.height() * 0.66, bay.low.z);
    let profile = [
        (bay.high.z, 0.0),
        (bay.high.z, bay.height() * 0.1),
        (back + bay.depth() * 0.46, high),
        (back + bay.depth() * 0.1, high),
        (back, bay.height() * 0.1),
        (back, 0.0),
    ];
    let half = bay.width() * 0.46;
    builder.add(slot, extrude(&profile.map(DVec2::from), Axis::X, [-half, half]));
    let rise = high - bay.height() * 0.1;
    let run = bay.depth() * 0.54;
    let angle = libm::atan2(rise, run);
    let middle = DVec3::new(0.0, high - rise * 0.52, back + bay.depth() * 0.46 + run * 0.52);
    let radius = (bay.width() * 0.3).min(run * 0.48);
    let place = |solid: Solid| solid.turned_x(angle).moved(middle.x, middle.y, middle.z);
    builder.add(Slot::Linen, place(lathe(&[(radius, -0.002), (radius, 0.003)], 10)));
    builder.add(
        Slot::Brass,
        place(lathe(&[(radius * 0.86, 0.0025), (radius * 0.8, 0.006), (radius * 0.3, 0.0075)], 10)),
    );
    for hole in 0..6 {
        let (sine, cosine) = libm::sincos(0.7 + 0.8 * f64::from(hole));
        let at = DVec3::new(cosine, 0.0, sine) * radius * 0.6 + DVec3::Y * 0.006;
        builder.add(Slot::MetalDark, place(cuboid(Bay::around(at, radius * 0.2, 0.005, radius * 0.2))));
    }
    let (y, z) = (bay.high.y - bay.height() * 0.12, back + bay.depth() * 0.28);
    let end = bay.high.x - bay.width() * 0.13;
    let grip = [
        DVec3::new(-end, y - bay.height() * 0.06, z),
        DVec3::new(-end * 0.6, y, z),
        DVec3::new(end * 0.6, y, z),
        DVec3::new(end, y - bay.height() * 0.06, z),
    ];
    builder.add(slot, sweep(&grip, bay.height() * 0.12, 6));
    let cup = bay.width() * 0.13;
    let ear =
        lathe(&[(cup * 0.7, high - 0.002), (cup, high + 0.006), (cup * 0.7, y + bay.height() * 0.06)], 6);
    builder.add_pair(slot, ear.moved(end, 0.0, z));
}

/// A box of sheet with large keys and a row of lamps, a straight receiver on the left.
fn steel_phone(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let slope = case(builder, slot);
    let ends = [-bay.width() * 0.1, bay.high.x - bay.width() * 0.06];
    slope.keys(builder, Slot::MetalDark, ends, 0.006);
    for lamp in 0..4 {
        let x = ends[0] + (ends[1] - ends[0]) * 0.25 * f64::from(lamp);
        let slot = [Slot::PaintedAccent, Slot::Leaf, Slot::Brass, Slot::Book][lamp as usize];
        builder.add(slot, slope.plate([x, x + (ends[1] - ends[0]) * 0.18], [0.2, 0.32], 0.004));
    }
    let middle = bay.low.x + bay.width() * 0.19;
    let wide = bay.width() * 0.1;
    let grip = Bay::new(
        [middle - wide * 0.7, middle + wide * 0.7],
        [0.006, bay.height() * 0.22],
        [slope.length * 0.08, slope.length * 0.92],
    );
    builder.add(Slot::Rubber, slope.lay(cuboid(grip)));
    for end in [Side::Back, Side::Front] {
        let ear = grip
            .inset(-wide * 0.3, 0.0, 0.0)
            .slab(end, slope.length * 0.24)
            .with_y([-0.001, bay.height() * 0.24]);
        let out = if end == Side::Back { -0.002 } else { 0.002 };
        builder.add(Slot::PlasticDark, slope.lay(cuboid(ear.moved(0.0, 0.0, out))));
    }
}

/// A handset that leans in a low cradle.
fn cordless(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let base = bay.height() * 0.3;
    builder.add(slot, rounded_box(bay.with_y([0.0, base]), DVec3::splat(base * 0.3), 1));
    let (foot, head) = (bay.low.z + bay.depth() * 0.62, bay.low.z + bay.depth() * 0.2);
    let thick = bay.depth() * 0.14;
    let half = bay.width() * 0.17;
    let leaning = |low: f64, top: f64, off: f64, thick: f64| {
        let at = |share: f64| (foot + (head - foot) * share, base * 0.5 + (bay.high.y - base * 0.5) * share);
        let (a, b) = (at(low), at(top));
        [(a.0 + off, a.1), (a.0 + off + thick, a.1), (b.0 + off + thick, b.1), (b.0 + off, b.1)]
            .map(DVec2::from)
    };
    builder.add(Slot::MetalDark, extrude(&leaning(0.0, 1.0, 0.0, thick), Axis::X, [-half, half]));
    let face = [-half * 0.8, half * 0.8];
    builder.add(Slot::Screen, extrude(&leaning(0.66, 0.9, thick - 0.001, 0.003), Axis::X, face));
    for row in 0..3 {
        let low = 0.36 + 0.09 * f64::from(row);
        for column in 0..3 {
            let x = face[0] + (face[1] - face[0]) * 0.36 * f64::from(column);
            let key = leaning(low, low + 0.06, thick - 0.001, 0.004);
            builder.add(Slot::Plastic, extrude(&key, Axis::X, [x, x + (face[1] - face[0]) * 0.28]));
        }
    }
    let lamp = Bay::around(DVec3::new(bay.width() * 0.34, base, bay.depth() * 0.3), 0.014, 0.006, 0.014);
    builder.cuboid(Slot::Leaf, lamp);
}
