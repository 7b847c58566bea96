//! Treadmills: belts 0.45 to 0.55 m wide and 1.3 to 1.6 long, 0.1 to 0.2 over the floor (EN ISO 20957-6). One steps on
//! from the front; what one holds stands at the back.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{across, turned_forward};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, pipe, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres of the walking surface over the floor at its ends.
const DECK: f64 = 0.18;
/// Slats of a belt without a motor.
const SLATS: u32 = 24;

/// A treadmill: with a motor and a console; of wood with a belt of slats; a curved one that the runner drives; one that
/// folds up.
pub(in super::super) static TREADMILL: Recipe = Recipe::furniture("treadmill", [0.85, 1.95, 1.45])
    .plain(|_, builder| with_motor(builder))
    .traditional(|_, builder| wooden(builder))
    .industrial(|_, builder| curved(builder))
    .budget(|_, builder| folding(builder));

/// A running belt between two side rails, with a console on posts at its back.
fn with_motor(builder: &mut Builder) {
    let bay = builder.bay();
    let deck = bay.slab(Side::Below, DECK);
    for side in [Side::Left, Side::Right] {
        builder.block(Slot::PlasticDark, deck.slab(side, bay.width() * 0.16), 0.01);
    }
    let belt = deck.inset(bay.width() * 0.15, 0.01, 0.02).without(Side::Above, 0.01);
    builder.cuboid(Slot::Rubber, belt);
    let hood = bay.slab(Side::Back, bay.depth() * 0.2).with_y([0.1, 0.34]).inset(0.06, 0.0, 0.004);
    builder.block(Slot::MetalDark, hood, 0.02);
    let zone = bay.slab(Side::Back, bay.depth() * 0.4);
    for side in [Side::Left, Side::Right] {
        let post =
            zone.slab(side, 0.07).without(Side::Front, zone.depth() * 0.82).with_y([0.17, bay.high.y * 0.8]);
        builder.cuboid(Slot::Metal, post.moved(0.0, 0.0, 0.03));
        let low = bay.high.y * 0.66;
        builder.block(
            Slot::Rubber,
            zone.slab(side, 0.05).with_y([low, low + 0.05]).inset(0.003, 0.0, 0.034),
            0.01,
        );
    }
    let console = zone.slab(Side::Back, 0.16).with_y([bay.high.y * 0.76, bay.high.y]);
    builder.block(Slot::PlasticDark, console.inset(0.02, 0.0, 0.01), 0.02);
    let screen = console.inset(bay.width() * 0.2, console.height() * 0.2, 0.0);
    builder.cuboid(Slot::Screen, screen.with_z([console.high.z - 0.012, console.high.z - 0.006]));
}

/// How a belt of slats sags between its cheeks.
struct Dish {
    /// Metres of the cheeks' thickness.
    cheek: f64,
    /// Metres over the floor at the ends, and in the middle.
    heights: [f64; 2],
}

impl Dish {
    /// Metres over the floor at a share of the depth, −0.5 at the back to 0.5 at the front.
    fn height(&self, share: f64) -> f64 {
        self.heights[1] + (self.heights[0] - self.heights[1]) * 4.0 * share * share
    }

    /// Cheeks with a curved upper edge, and slats between them.
    fn add(&self, builder: &mut Builder, cheek: Slot, slat: Slot) {
        let bay = builder.bay();
        let shares = [0.5, 0.3, 0.1, -0.1, -0.3, -0.5];
        let mut profile: Vec<DVec2> =
            shares.map(|share| DVec2::new(share * bay.depth(), self.height(share) + 0.02)).to_vec();
        profile.extend([DVec2::new(bay.low.z, 0.04), DVec2::new(bay.low.z + 0.05, 0.0)]);
        profile.extend([DVec2::new(bay.high.z - 0.05, 0.0), DVec2::new(bay.high.z, 0.04)]);
        builder.add_pair(cheek, extrude(&profile, Axis::X, [bay.high.x - self.cheek, bay.high.x]));
        let pitch = bay.depth() * 0.92 / f64::from(SLATS);
        for index in 0..SLATS {
            let share = (f64::from(index) + 0.5) / f64::from(SLATS) - 0.5;
            let at = DVec3::new(0.0, self.height(share * 0.92) - 0.012, share * bay.depth() * 0.92);
            builder
                .cuboid(slat, Bay::around(at, bay.width() - (self.cheek - SINK) * 2.0, 0.022, pitch * 0.86));
        }
    }
}

/// Cheeks, posts and rails of wood around slats of wood; a board for a book, with a dial.
fn wooden(builder: &mut Builder) {
    let bay = builder.bay();
    let board = 0.05;
    Dish { cheek: board, heights: [0.16, 0.12] }.add(builder, Slot::Wood, Slot::WoodLight);
    let (back, high) = (bay.low.z, bay.high.y);
    let reach = bay.depth() * 0.42;
    let x = [bay.high.x - board * 0.9, bay.high.x - board * 0.1];
    let post =
        [(back + 0.2, 0.1), (back + 0.28, 0.1), (back + 0.09, high - 0.03), (back + 0.02, high - 0.03)];
    builder.add_pair(Slot::Wood, extrude(&post.map(DVec2::from), Axis::X, x));
    let (stand, rail) = (back + reach - 0.06, high * 0.64);
    let short = [(stand, 0.1), (stand + 0.05, 0.1), (stand + 0.05, rail), (stand, rail)];
    builder.add_pair(Slot::Wood, extrude(&short.map(DVec2::from), Axis::X, x));
    let grip = Bay::new(x, [rail - SINK, rail + 0.045], [back + 0.1, back + reach]).inset(-0.004, 0.0, 0.0);
    for side in [1.0, -1.0] {
        let ends = if side > 0.0 { grip.x() } else { [-grip.high.x, -grip.low.x] };
        builder.block(Slot::WoodDark, grip.with_x(ends), 0.012);
    }
    let inner = bay.inset(board * 0.8, 0.0, 0.0);
    builder.block(
        Slot::Wood,
        inner.with_y([high - 0.11, high - 0.04]).with_z([back + 0.04, back + 0.075]),
        0.006,
    );
    let desk =
        [(back + 0.0, high), (back + 0.02, high), (back + 0.24, high - 0.16), (back + 0.22, high - 0.18)];
    builder.add(Slot::WoodLight, extrude(&desk.map(DVec2::from), Axis::X, inner.inset(0.1, 0.0, 0.0).x()));
    let ledge =
        Bay::new(inner.inset(0.1, 0.0, 0.0).x(), [high - 0.19, high - 0.13], [back + 0.215, back + 0.24]);
    builder.block(Slot::Wood, ledge.inset(-0.01, 0.0, 0.0), 0.004);
    let dial = turned_forward(cylinder(0.05, [0.0, 0.02], 12)).moved(0.0, high - 0.24, back + 0.07);
    builder.add(Slot::Brass, dial);
    builder.cuboid(
        Slot::Wood,
        Bay::new([-0.03, 0.03], [high - 0.3, high - 0.09], [back + 0.045, back + 0.07 + SINK]),
    );
}

/// A curved belt of rubber slats in cheeks of steel, under rails of bent pipe.
fn curved(builder: &mut Builder) {
    let bay = builder.bay();
    Dish { cheek: 0.09, heights: [0.2, 0.08] }.add(builder, Slot::MetalDark, Slot::Rubber);
    let (back, high, tube) = (bay.low.z, bay.high.y, 0.024);
    let x = bay.high.x - 0.045;
    let at = |x: f64, y: f64, share: f64| DVec3::new(x, high * y, back + bay.depth() * share);
    let rail = [
        at(x, 0.1, 0.42),
        at(x, 0.66, 0.36),
        at(x, 0.72, 0.2),
        at(x, 0.98, 0.1),
        at(x, 0.98, 0.02),
        at(x, 0.06, 0.02),
    ];
    builder.add_pair(Slot::Metal, pipe(&rail, tube, 0.12));
    for (y, share) in [(0.97, 0.06), (0.5, 0.0199), (0.24, 0.02)] {
        let [left, right] = [-x, x].map(|x| at(x, y, share));
        builder.add(Slot::Metal, sweep(&[left, right], tube * 0.9, 8));
    }
    let wedge = [(0.03, 0.86), (0.05, 0.86), (0.09, 0.99), (0.03, 0.99)]
        .map(|(share, y)| DVec2::new(back + bay.depth() * share, high * y));
    builder.add(Slot::PlasticDark, extrude(&wedge, Axis::X, [-0.15, 0.15]));
    for z in [bay.low.z + 0.02, bay.high.z - 0.1] {
        let foot = Bay::new([bay.high.x - 0.08, bay.high.x - 0.01], [0.0, 0.03], [z, z + 0.08]);
        builder.cuboid(Slot::Rubber, foot.moved(0.0, 0.0005, 0.0));
        builder.cuboid(Slot::Rubber, foot.with_x([-foot.high.x, -foot.low.x]).moved(0.0, 0.0005, 0.0));
    }
    // The flywheel of the belt shows at both sides.
    for z in [-0.36, 0.36] {
        let hub = across(0.045, [bay.high.x - 0.02, bay.high.x + 0.004], 10);
        builder.add_pair(Slot::PaintedAccent, hub.moved(0.0, 0.085, z * bay.depth()));
    }
}

/// A thin deck hinged in a bent frame on rollers, with a strut and a small console.
fn folding(builder: &mut Builder) {
    let bay = builder.bay();
    let (back, high, tube) = (bay.low.z, bay.high.y, 0.018);
    let deck = bay.with_y([0.04, 0.12]).inset(0.09, 0.0, 0.0).without(Side::Back, 0.2);
    for side in [Side::Left, Side::Right] {
        builder.block(Slot::Plastic, deck.slab(side, 0.07), 0.012);
    }
    builder.cuboid(Slot::Rubber, deck.inset(0.07 - SINK, 0.01, 0.012).moved(0.0, 0.004, 0.0));
    let hood = deck.slab(Side::Back, 0.3).with_y([0.05, 0.2]).inset(0.012, 0.0, 0.0).moved(0.0, 0.0, -0.06);
    builder.cushion(Slot::PlasticDark, hood, 0.04);
    let x = bay.high.x - tube;
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, back + z);
    let frame = [at(x, tube, 0.62), at(x, tube, 0.1), at(x, 0.6, 0.2), at(x, high * 0.8, 0.05)];
    builder.add_pair(Slot::Metal, pipe(&frame, tube, 0.08));
    let bow = [
        at(-x, high * 0.62, 0.52),
        at(-x, high * 0.72, 0.1),
        at(x, high * 0.72, 0.1),
        at(x, high * 0.62, 0.52),
    ];
    builder.add(Slot::Rubber, pipe(&bow, tube * 1.1, 0.1));
    builder.add(Slot::Metal, sweep(&[at(-x, tube, 0.12), at(x, tube, 0.12)], tube * 0.9, 6));
    builder.add(Slot::Chrome, sweep(&[at(0.2, 0.16, 0.5), at(x * 0.98, 0.62, 0.19)], 0.012, 6));
    let console = [(0.0, high * 0.77), (0.09, high * 0.76), (0.19, high * 0.79), (0.05, high)];
    let profile = console.map(|(z, y)| DVec2::new(back + z, y));
    builder.add(Slot::PlasticDark, extrude(&profile, Axis::X, [-x * 0.62, x * 0.62]));
    for y in [0.77, 0.8] {
        builder.add(Slot::Metal, sweep(&[at(-x, high * y, 0.055), at(x, high * y, 0.055)], tube * 0.8, 6));
    }
    for z in [0.05, 0.58] {
        let wheel = across(0.05, [bay.high.x - 0.06, bay.high.x], 10);
        builder.add_pair(Slot::Rubber, wheel.moved(0.0, 0.05, back + z));
    }
}
