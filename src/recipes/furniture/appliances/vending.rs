//! Vending machines: 0.75 to 0.95 m wide, 0.70 to 0.85 deep, 1.83 high (EVA standards of most makers).

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners, turned_forward};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Sampler, extrude, lathe};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of the plinth or the feet.
const FOOT: f64 = 0.06;

/// A machine that sells: snacks behind glass, bottles under a rounded crown, coffee behind steel, or drinks by button.
pub(in super::super) static VENDING_MACHINE: Recipe = Recipe::furniture("vending_machine", [0.9, 0.8, 1.85])
    .symbol(Symbol::Diagonal)
    .every_set(vending_machine);

fn vending_machine(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    let mut sampler = draft.sampler();
    let bay = builder.bay();
    let feet = bay.with_y([0.0, FOOT + 3.0 * SINK]).inset(0.03, 0.0, 0.03);
    legs_at_corners(builder, Slot::MetalDark, feet, 0.06, LegKind::Square);
    let body = bay.without(Side::Below, FOOT);
    match draft.set() {
        GeometrySet::Plain => snacks(builder, &mut sampler, body, form),
        GeometrySet::Traditional => crowned(builder, body, form),
        GeometrySet::Industrial => coffee(builder, body, form),
        GeometrySet::Budget => buttons(builder, body, form),
    }
}

/// A plate on a front, standing out of it by `out` metres.
fn plate(builder: &mut Builder, slot: Slot, field: Bay, surface: f64, out: f64) {
    builder.cuboid(slot, field.with_z([surface - 0.003, surface + out]));
}

/// Spirals of goods on five shelves behind a pane, keys beside it.
fn snacks(builder: &mut Builder, sampler: &mut Sampler, body: Bay, form: usize) {
    let slot = [Slot::MetalDark, Slot::PaintedAccent, Slot::Painted, Slot::Metal][form];
    let window = body
        .slab(Side::Left, body.width() * 0.68)
        .inset(body.width() * 0.05, 0.0, 0.0)
        .without(Side::Above, body.height() * 0.06)
        .without(Side::Below, body.height() * 0.22);
    let depth = (body.depth() * 0.3).min(0.25);
    builder.cuboid(slot, body.without(Side::Front, depth).inset(0.0005, 0.0005, 0.0));
    // The front is a frame around the window.
    let front = body.slab(Side::Front, depth + SINK).without(Side::Front, 0.004);
    builder.cuboid(slot, front.with_x([body.low.x, window.low.x]));
    builder.cuboid(slot, front.with_x([window.high.x, body.high.x]));
    let between = front.with_x([window.low.x - SINK, window.high.x + SINK]).without(Side::Front, 0.002);
    builder.cuboid(slot, between.with_y([window.high.y, body.high.y - 0.0012]));
    builder.cuboid(slot, between.with_y([body.low.y + 0.0012, window.low.y]));
    let glass = window.slab(Side::Front, 0.016).without(Side::Front, 0.01).inset(-SINK, -SINK, 0.0);
    builder.cuboid(Slot::Glass, glass);
    let niche = front.with_x(window.x()).with_y(window.y()).without(Side::Front, 0.05);
    for shelf in niche.rows(5, 0.0) {
        let board = shelf.slab(Side::Below, 0.015).inset(-SINK, 0.0, 0.002);
        builder.cuboid(Slot::Metal, board.moved(0.0, SINK, 0.0));
        let goods = shelf.without(Side::Below, 0.015).inset(0.02, 0.0, 0.03);
        for column in goods.columns(5, goods.width() * 0.06) {
            let tall = goods.height() * sampler.between(0.5, 0.8);
            let slot = sampler.pick(&[Slot::Book, Slot::Paper, Slot::PaintedAccent, Slot::Leaf, Slot::Brass]);
            builder.cuboid(slot, column.slab(Side::Below, tall).moved(0.0, SINK * 0.5, 0.0));
        }
    }
    let surface = front.high.z;
    let panel = front.with_x([window.high.x + 0.04, body.high.x - 0.04]);
    plate(builder, Slot::Screen, panel.with_y([body.height() * 0.52, body.height() * 0.7]), surface, 0.002);
    let slit = panel.with_y([body.height() * 0.4, body.height() * 0.44]).inset(panel.width() * 0.2, 0.0, 0.0);
    plate(builder, Slot::Metal, slit, surface, 0.004);
    let flap = between.with_y([body.low.y + 0.12, window.low.y - 0.1]).inset(0.06, 0.0, 0.0);
    plate(builder, Slot::PlasticDark, flap, between.high.z, 0.003);
}

/// Rounded shoulders, a door with a narrow pane over bottles, a chromed lever, a bottle catch.
fn crowned(builder: &mut Builder, body: Bay, form: usize) {
    let slot = [Slot::Book, Slot::PaintedAccent, Slot::Leaf, Slot::Book][form];
    let front = body.high.z - 0.02;
    let (half, top) = (body.width() / 2.0, body.high.y);
    let radius = (half * 0.36).min(body.height() * 0.2);
    let mut profile = vec![DVec2::new(-half, body.low.y), DVec2::new(half, body.low.y)];
    for step in 0..=5 {
        let (sine, cosine) = libm::sincos(std::f64::consts::FRAC_PI_2 * f64::from(step) / 5.0);
        profile.push(DVec2::new(half - radius + radius * cosine, top - radius + radius * sine));
    }
    for step in 0..=5 {
        let (sine, cosine) = libm::sincos(std::f64::consts::FRAC_PI_2 * f64::from(step) / 5.0);
        profile.push(DVec2::new(-half + radius - radius * sine, top - radius + radius * cosine));
    }
    builder.add(slot, extrude(&profile, Axis::Z, [body.low.z, front]));
    let face = body.inset(body.width() * 0.08, 0.0, 0.0).with_y([body.low.y + 0.1, top - radius * 1.1]);
    plate(builder, Slot::Linen, face.slab(Side::Above, face.height() * 0.2), front, 0.01);
    let door = face.without(Side::Above, face.height() * 0.22);
    builder.block(slot, door.with_z([front - SINK, front + 0.012]), 0.005);
    let pane = door.slab(Side::Left, door.width() * 0.3).inset(0.03, 0.06, 0.0);
    plate(builder, Slot::MetalDark, pane, front + 0.012, 0.0012);
    for cell in pane.inset(pane.width() * 0.2, 0.01, 0.0).rows(7, 0.02) {
        let cap = turned_forward(lathe(&[(cell.height() * 0.4, -0.002), (cell.height() * 0.34, 0.006)], 8));
        builder.add(Slot::Leaf, cap.moved(cell.center().x, cell.center().y, front + 0.0125));
    }
    let right = door.slab(Side::Right, door.width() * 0.52);
    let coin = right.with_y([right.center().y, right.center().y + 0.16]).inset(right.width() * 0.3, 0.0, 0.0);
    plate(builder, Slot::Chrome, coin, front + 0.012, 0.006);
    builder.cuboid(
        Slot::Chrome,
        Bay::around(DVec3::new(door.high.x - 0.025, door.center().y, front + 0.014), 0.022, 0.3, 0.012),
    );
    let catch = right.with_y([right.low.y + 0.06, right.low.y + 0.24]).inset(right.width() * 0.2, 0.0, 0.0);
    plate(builder, Slot::PlasticDark, catch, front + 0.012, 0.004);
}

/// Sheet with a niche for the cup, rows of keys, pipes and gauges.
fn coffee(builder: &mut Builder, body: Bay, form: usize) {
    let slot = [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::MetalDark][form];
    let front = body.high.z - 0.025;
    builder.block(slot, body.with_z([body.low.z, front]), 0.008);
    let panel = body.inset(body.width() * 0.08, body.height() * 0.05, 0.0);
    plate(builder, Slot::Wood, panel.slab(Side::Above, panel.height() * 0.3), front, 0.008);
    let cup = DVec3::new(-panel.width() * 0.14, panel.high.y - panel.height() * 0.15, front + 0.008);
    let sign = [(0.07, -SINK), (0.11, 0.0), (0.11, 0.006), (0.09, 0.01)];
    builder
        .add(Slot::Ceramic, turned_forward(lathe(&sign.map(|(r, y)| (r, y)), 12)).moved(cup.x, cup.y, cup.z));
    let niche = Bay::new(
        [-body.width() * 0.32, body.width() * 0.05],
        [body.height() * 0.34, body.height() * 0.58],
        panel.z(),
    );
    plate(builder, Slot::PlasticDark, niche.inset(-0.004, -0.004, 0.0), front, 0.0012);
    for side in [Side::Left, Side::Right] {
        plate(builder, Slot::Chrome, niche.inset(-0.02, -0.0195, 0.0).slab(side, 0.02), front, 0.014);
    }
    for side in [Side::Above, Side::Below] {
        plate(builder, Slot::Chrome, niche.inset(-0.001, -0.02, 0.0).slab(side, 0.02), front, 0.022);
    }
    let spout = lathe(&[(0.012, 0.0), (0.02, 0.05), (0.02, 0.08)], 8);
    builder.add(Slot::Chrome, spout.moved(niche.center().x, niche.high.y - 0.075, front + 0.012));
    let keys = Bay::new(
        [body.width() * 0.12, body.width() * 0.4],
        [body.height() * 0.36, body.height() * 0.62],
        panel.z(),
    );
    for row in keys.rows(4, 0.03) {
        for key in row.columns(2, 0.04) {
            plate(builder, if form < 2 { Slot::Brass } else { Slot::PaintedAccent }, key, front, 0.01);
        }
    }
    let flap = panel.slab(Side::Below, panel.height() * 0.2).inset(panel.width() * 0.1, 0.02, 0.0);
    plate(builder, Slot::MetalDark, flap, front, 0.006);
    for x in [panel.low.x - 0.02, panel.high.x + 0.02] {
        for y in [panel.low.y, panel.center().y, panel.high.y] {
            let bolt = turned_forward(lathe(&[(0.012, -0.003), (0.012, 0.005), (0.007, 0.008)], 6));
            builder.add(Slot::MetalDark, bolt.moved(x, y, front));
        }
    }
}

/// A printed front that is lit, a column of buttons, a slot below.
fn buttons(builder: &mut Builder, body: Bay, form: usize) {
    let slot = [Slot::PlasticDark, Slot::Painted, Slot::PaintedAccent, Slot::Plastic][form];
    let front = body.high.z - 0.012;
    builder.cuboid(slot, body.with_z([body.low.z, front]));
    let picture = body.slab(Side::Left, body.width() * 0.72).inset(body.width() * 0.05, 0.0, 0.0);
    let picture = picture.with_y([body.height() * 0.32, body.high.y - 0.08]);
    plate(
        builder,
        [Slot::PaintedAccent, Slot::Leaf, Slot::Paper, Slot::PaintedAccent][form],
        picture,
        front,
        0.008,
    );
    let can = picture.inset(picture.width() * 0.3, picture.height() * 0.22, 0.0);
    plate(builder, [Slot::Paper, Slot::Paper, Slot::Book, Slot::Linen][form], can, front + 0.008, 0.0012);
    let band = can.inset(0.002, can.height() * 0.36, 0.0);
    plate(
        builder,
        [Slot::Book, Slot::PaintedAccent, Slot::Paper, Slot::Leaf][form],
        band,
        front + 0.0095,
        0.001,
    );
    let column = body.slab(Side::Right, body.width() * 0.24).inset(body.width() * 0.03, 0.0, 0.0);
    for (index, key) in
        column.with_y([body.height() * 0.52, body.high.y - 0.12]).rows(8, 0.02).into_iter().enumerate()
    {
        plate(builder, [Slot::PaintedAccent, Slot::Paper, Slot::Leaf][index % 3], key, front, 0.01);
    }
    plate(builder, Slot::Metal, column.with_y([body.height() * 0.4, body.height() * 0.47]), front, 0.006);
    let slot = picture.with_y([body.low.y + 0.14, body.low.y + 0.36]).inset(0.04, 0.0, 0.0);
    plate(builder, Slot::MetalDark, slot.inset(-0.02, -0.02, 0.0), front, 0.006);
    plate(builder, Slot::PlasticDark, slot, front + 0.006, 0.0012);
}
