//! Portable computers, open: 0.3 to 0.36 m wide, their base 0.21 to 0.25 deep.

use glam::{DVec2, DVec3};

use super::parts::across;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Solid, cuboid, extrude, rounded_box};
use crate::recipes::{Recipe, Slot};

/// How far the lid leans back: 20° from upright (ISO 9241-5 wants screens at right angles to the look).
const LEAN: f64 = 0.36;
/// The most of the depth that the lid may take.
const MOST_LEAN: f64 = 0.3;

/// An open portable computer: a thin wedge; a thick one of the nineties on its dock; one for building sites with a
/// carrying handle and bumpers; a round one of plastic with a wide border and a barrel for a hinge.
pub(super) static LAPTOP: Recipe = Recipe::accessory("laptop", [0.34, 0.28, 0.24])
    .plain(|_, builder| wedge(builder))
    .traditional(|_, builder| docked(builder))
    .industrial(|_, builder| rugged(builder))
    .budget(|draft, builder| round(builder, draft.form()));

/// An open lid. Pieces of it are given in its own frame: x to the right, y up from its lower edge, z out of its face.
struct Lid {
    /// Of the lower edge of its face.
    foot: DVec2,
    /// Radians by which it leans back.
    angle: f64,
    /// Metres from the lower edge to the upper.
    length: f64,
    thickness: f64,
}

impl Lid {
    /// One that starts at a height and reaches the top and the back of a bay.
    fn new(bay: Bay, low: f64, thickness: f64) -> Self {
        let rise = bay.height() - low;
        let run = (rise * LEAN).min(bay.depth() * MOST_LEAN);
        let length = libm::sqrt(rise * rise + run * run);
        let back = run + thickness * rise / length;
        Self { foot: DVec2::new(bay.low.z + back, low), angle: -libm::atan2(run, rise), length, thickness }
    }

    fn placed(&self, solid: Solid) -> Solid {
        solid.turned_x(self.angle).moved(0.0, self.foot.y, self.foot.x)
    }

    /// The whole lid between two ends along x.
    fn body(&self, x: [f64; 2]) -> Bay {
        Bay::new(x, [0.0, self.length], [-self.thickness, 0.0])
    }

    /// What is lit, `border` metres within the lid, more below.
    fn screen(&self, builder: &mut Builder, x: [f64; 2], border: f64, chin: f64) {
        let glass = self.body(x).inset(border, border, 0.0).without(Side::Below, chin);
        builder.add(Slot::Screen, self.placed(cuboid(glass.with_z([-SINK, 0.001]))));
    }
}

/// Keys and a field to point with, on a deck.
fn keys(builder: &mut Builder, deck: Bay, wide: f64, lift: f64) {
    let top = deck.high.y;
    let keys = deck.slab(Side::Back, deck.depth() * 0.6).inset(deck.width() * wide, 0.0, deck.depth() * 0.06);
    builder.cuboid(Slot::PlasticDark, keys.with_y([top - SINK, top + lift]));
}

fn pad(builder: &mut Builder, slot: Slot, deck: Bay, half: f64) {
    let top = deck.high.y;
    let pad = deck.slab(Side::Front, deck.depth() * 0.32).inset(
        deck.width() * (0.5 - half),
        0.0,
        deck.depth() * 0.03,
    );
    builder.cuboid(slot, pad.with_y([top - SINK, top + 0.0008]));
}

/// A base that is thin in front, and a thin lid with a narrow border.
fn wedge(builder: &mut Builder) {
    let bay = builder.bay();
    let base = (bay.height() * 0.08).min(0.018);
    let thick = 0.006_f64.min(bay.depth() * 0.04);
    let lid = Lid::new(bay, base * 0.6, thick);
    let deck = bay.with_y([0.0, base]).with_z([lid.foot.x - thick, bay.high.z]);
    let section = [(0.0, 0.0), (0.7, 0.0), (1.0, 0.65), (1.0, 1.0), (0.0, 1.0)]
        .map(|(z, y)| DVec2::new(deck.low.z + z * deck.depth(), y * base));
    builder.add(Slot::Metal, extrude(&section, Axis::X, deck.x()));
    let top = deck.without(Side::Back, thick * 1.5);
    keys(builder, top, 0.06, 0.0015);
    pad(builder, Slot::MetalDark, top, 0.2);
    let x = bay.inset(0.001, 0.0, 0.0).x();
    builder.add(Slot::Metal, lid.placed(cuboid(lid.body(x))));
    lid.screen(builder, x, bay.width() * 0.02, base * 0.7);
}

/// A thick one with block hinges, buttons before its keys and a red nub among them; the dock behind it lifts its back.
fn docked(builder: &mut Builder) {
    let bay = builder.bay();
    let (width, height) = (bay.width(), bay.height());
    let [foot, top] = [0.06, 0.19].map(|share| (height * share).min(0.26 * share));
    let thick = (bay.depth() * 0.06).min(0.016);
    let lid = Lid::new(bay, top - SINK, thick);
    let deck = bay.with_y([foot, top]).with_z([lid.foot.x - thick * 1.4, bay.high.z]).inset(0.008, 0.0, 0.0);
    let (back, depth) = (deck.low.z, deck.depth());
    // Its front is bevelled below.
    let section = [(0.0, 0.0), (0.88, 0.0), (1.0, 0.5), (1.0, 1.0), (0.0, 1.0)]
        .map(|(z, y)| DVec2::new(back + z * depth, foot + y * (top - foot)));
    builder.add(Slot::PlasticDark, extrude(&section, Axis::X, deck.x()));
    let behind = lid.foot.x - thick * 1.5;
    let dock = [
        (bay.low.z, 0.0),
        (back + depth * 0.8, 0.0),
        (back + depth * 0.8, foot * 0.3),
        (behind, foot + SINK),
        (behind, top * 0.8),
        (bay.low.z, top * 0.8),
    ];
    builder.add(Slot::Rubber, extrude(&dock.map(DVec2::from), Axis::X, bay.x()));
    let top = deck.without(Side::Back, thick * 1.6);
    let field = top.slab(Side::Back, top.depth() * 0.58).inset(width * 0.03, 0.0, top.depth() * 0.03);
    builder.cuboid(Slot::MetalDark, field.with_y([deck.high.y - SINK, deck.high.y + 0.003]));
    let nub = Bay::around(field.center(), 0.009, 0.0, 0.009);
    builder.cuboid(Slot::Book, nub.with_y([deck.high.y, deck.high.y + 0.006]));
    let buttons = top.slab(Side::Front, top.depth() * 0.36).slab(Side::Back, top.depth() * 0.08);
    builder.cuboid(
        Slot::MetalDark,
        buttons.inset(width * 0.36, 0.0, 0.0).with_y([deck.high.y - SINK, deck.high.y + 0.002]),
    );
    for side in [-1.0, 1.0] {
        let hinge = Bay::around(DVec3::X * side * width * 0.34, width * 0.09, 0.0, 0.0);
        let hinge = hinge.with_y([deck.high.y - SINK, deck.high.y + thick * 0.9]);
        builder.cuboid(Slot::Metal, hinge.with_z([lid.foot.x - thick * 1.3, lid.foot.x + thick * 0.3]));
    }
    let x = deck.inset(0.001, 0.0, 0.0).x();
    builder.add(Slot::PlasticDark, lid.placed(cuboid(lid.body(x))));
    lid.screen(builder, x, width * 0.06, height * 0.02);
}

/// A thick one in a case of cast metal: a handle before its base, rubber on the corners of its lid.
fn rugged(builder: &mut Builder) {
    let bay = builder.bay();
    let (width, base) = (bay.width(), (bay.height() * 0.19).min(0.045));
    let thick = (bay.depth() * 0.08).min(0.022);
    let lid = Lid::new(bay, base * 0.8, thick);
    let reach = (bay.depth() * 0.14).min(0.036);
    let deck =
        bay.with_y([0.0, base]).with_z([lid.foot.x - thick, bay.high.z - reach]).inset(0.003, 0.0, 0.0);
    builder.cuboid(Slot::Metal, deck);
    let [half, front] = [width * 0.36, deck.high.z];
    let bar = reach * 0.45;
    let handle = [
        (-half, front - SINK),
        (-half, front + reach * 0.6),
        (-half + reach * 0.4, front + reach),
        (half - reach * 0.4, front + reach),
        (half, front + reach * 0.6),
        (half, front - SINK),
        (half - bar, front - SINK),
        (half - bar, front + reach - bar),
        (bar - half, front + reach - bar),
        (bar - half, front - SINK),
    ];
    builder.add(Slot::PlasticDark, extrude(&handle.map(DVec2::from), Axis::Y, [base * 0.3, base * 0.78]));
    let top = deck.without(Side::Back, thick * 1.5);
    keys(builder, top, 0.08, 0.003);
    pad(builder, Slot::Rubber, top, 0.14);
    let x = deck.inset(0.001, 0.0, 0.0).x();
    let body = lid.body(x);
    builder.add(Slot::Metal, lid.placed(cuboid(body.without(Side::Above, 0.002))));
    lid.screen(builder, x, width * 0.075, base * 0.3);
    let size = (width * 0.1).min(lid.length * 0.5);
    for side in [Side::Left, Side::Right] {
        let around = body.slab(side, size).without(side, -0.004).inset(0.0, 0.0, -0.0025);
        builder.add(Slot::Rubber, lid.placed(cuboid(around.slab(Side::Above, size * 0.7))));
        let low = around.slab(Side::Below, size * 0.7 + base * 0.3).without(Side::Below, base * 0.3);
        builder.add(Slot::Rubber, lid.placed(cuboid(low)));
    }
    let latch = body.with_x([-size * 0.35, size * 0.35]).slab(Side::Above, size * 0.3);
    builder.add(Slot::PlasticDark, lid.placed(cuboid(latch.inset(0.0, 0.0, -0.004).moved(0.0, -0.001, 0.0))));
}

/// A low-priced one with round corners: a barrel of a hinge between base and lid, keys with a block of numbers.
fn round(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::Plastic, Slot::PlasticDark, Slot::PaintedAccent, Slot::Plastic][look];
    let (width, base) = (bay.width(), (bay.height() * 0.12).min(0.028));
    let thick = (bay.depth() * 0.06).min(0.016);
    let lid = Lid::new(bay, base * 0.7, thick);
    let deck = bay.with_y([0.0, base]).with_z([lid.foot.x, bay.high.z]);
    let soft = |bay: Bay, thin: DVec3| rounded_box(bay, thin * (width * 0.055), 1);
    builder.add(slot, soft(deck, DVec3::new(1.0, 0.3, 1.0)));
    let barrel = across(base * 0.55, bay.inset(width * 0.1, 0.0, 0.0).x(), 6);
    builder.add(Slot::MetalDark, barrel.moved(0.0, base * 0.72, lid.foot.x - thick * 0.4));
    let top = deck.without(Side::Back, base * 0.6).inset(width * 0.06, 0.0, 0.0);
    let field = top.slab(Side::Back, top.depth() * 0.56).with_y([base - SINK, base + 0.0022]);
    builder.cuboid(Slot::Rubber, field.slab(Side::Left, field.width() * 0.74));
    builder.cuboid(Slot::Rubber, field.slab(Side::Right, field.width() * 0.22));
    pad(builder, Slot::MetalDark, top, 0.16);
    let body = lid.body(bay.x()).without(Side::Below, base * 0.3);
    builder.add(slot, lid.placed(soft(body, DVec3::new(1.0, 1.0, 0.12))));
    lid.screen(builder, bay.x(), width * 0.075, base * 0.7);
}
