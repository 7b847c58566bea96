//! Printers for desks: A4 machines are 0.36 to 0.45 m wide, 0.30 to 0.42 deep, 0.15 to 0.40 high with a scanner.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{HandleForm, HandleKind, handle};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude};
use crate::recipes::{Recipe, Slot};

/// Width of paper in metres: A4.
const PAPER: f64 = 0.21;

/// A printer: one with a scanner over its tray, a laser printer with rounded shoulders, a matrix printer on a stand
/// with folded paper, or a small one that takes paper from behind.
pub(in super::super) static PRINTER: Recipe = Recipe::furniture("printer", [0.5, 0.45, 0.4])
    .plain(|draft, builder| scanner_over_tray(builder, draft.form()))
    .traditional(|draft, builder| laser(builder, draft.form()))
    .industrial(|draft, builder| matrix(builder, draft.form()))
    .budget(|draft, builder| rear_fed(builder, draft.form()));

/// Half of the width of paper in a box.
fn half_paper(bay: Bay) -> f64 {
    (PAPER / 2.0).min(bay.width() * 0.36)
}

/// A cassette, the engine with an open tray, and a scanner with its lid above.
fn scanner_over_tray(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let shell = [Slot::Plastic, Slot::PlasticDark, Slot::Plastic, Slot::PlasticDark][form];
    let high = bay.height();
    let body = bay.without(Side::Front, 0.012);
    let cassettes = if form < 2 { 1 } else { 2 };
    let cassette = high * if cassettes == 1 { 0.26 } else { 0.36 };
    builder.cuboid(shell, body.slab(Side::Below, cassette).without(Side::Front, 0.004));
    for row in body.slab(Side::Below, cassette).inset(0.01, 0.006, 0.0).rows(cassettes, 0.004) {
        builder.cuboid(shell, row.slab(Side::Front, 0.008));
        let grip = DVec3::new(0.0, row.center().y, body.high.z);
        handle(
            builder,
            Slot::MetalDark,
            HandleForm { kind: HandleKind::Level, length: bay.width() * 0.3 },
            grip,
            0.012,
        );
    }
    let engine = body.with_y([cassette - SINK, high * 0.7]).inset(0.003, 0.0, 0.003);
    let (back, left) = (engine.depth() * 0.45, bay.width() * 0.16);
    builder.cuboid(shell, engine.slab(Side::Back, back));
    let before = engine.without(Side::Back, back - SINK);
    builder.cuboid(shell, before.slab(Side::Left, left).inset(0.0005, 0.0, 0.0));
    let mouth = before.without(Side::Left, left - SINK);
    builder.cuboid(Slot::MetalDark, mouth.slab(Side::Below, high * 0.05).inset(0.001, 0.001, 0.001));
    builder.cuboid(Slot::MetalDark, mouth.slab(Side::Back, 0.004).inset(0.002, 0.002, 0.0));
    let half = half_paper(bay);
    let sheet = Bay::new([mouth.center().x - half, mouth.center().x + half], [0.0, 0.004], mouth.z());
    builder.cuboid(Slot::Paper, sheet.inset(0.0, 0.0, 0.006).moved(0.0, mouth.low.y + high * 0.052, 0.0));
    let scanner = body.with_y([high * 0.7 - SINK, high * 0.88]);
    builder.block(shell, scanner, 0.006);
    builder.block(
        Slot::MetalDark,
        scanner.inset(0.014, 0.0, 0.014).with_y([high * 0.88 - SINK, high]),
        0.006,
    );
    let panel = scanner.slab(Side::Right, bay.width() * 0.36).inset(0.02, scanner.height() * 0.16, 0.0);
    builder.cuboid(Slot::Screen, panel.with_z([scanner.high.z - SINK, scanner.high.z + 0.004]));
}

/// Sloping shoulders, paper on top, a tray folded out below.
fn laser(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let shell = [Slot::Linen, Slot::Plastic, Slot::Linen, Slot::PlasticDark][form];
    let (high, back) = (bay.height(), bay.low.z);
    let front = bay.high.z - bay.depth() * 0.22;
    let at = |depth: f64, rise: f64| DVec2::new(back + depth * (front - back), rise * high);
    let profile = [
        at(0.0, 0.02),
        at(1.0, 0.02),
        at(1.0, 0.62),
        at(0.86, 0.72),
        at(0.6, 0.76),
        at(0.34, 0.84),
        at(0.0, 0.84),
    ];
    builder.add(shell, extrude(&profile, Axis::X, bay.inset(0.0, 0.0, 0.0).x()));
    let half = half_paper(bay);
    let slot = [at(0.36, 0.83), at(0.36, 0.845), at(0.62, 0.765), at(0.62, 0.75)];
    builder.add(Slot::MetalDark, extrude(&slot, Axis::X, [-half - 0.012, half + 0.012]));
    // Sheets that came out lie against the rest at the back.
    let sheets = [at(0.6, 0.76), at(0.58, 0.79), at(0.08, 1.0), at(0.04, 0.985)];
    builder.add(Slot::Paper, extrude(&sheets, Axis::X, [-half, half]));
    let rest = [at(0.3, 0.82), at(0.0, 0.96), at(0.0, 0.985), at(0.02, 0.985), at(0.34, 0.84)];
    builder.add(shell, extrude(&rest, Axis::X, [-half * 0.5, half * 0.5]));
    let tray = Bay::new([-half - 0.01, half + 0.01], [0.12 * high, 0.15 * high], [front - 0.01, bay.high.z]);
    builder.cuboid(shell, tray);
    if form.is_multiple_of(2) {
        builder.cuboid(Slot::Paper, tray.inset(0.01, 0.0, 0.006).moved(0.0, 0.018 * high, -0.004));
    }
    builder.cuboid(
        Slot::MetalDark,
        Bay::new(tray.x(), [0.18 * high, 0.25 * high], [front - 0.004, front + 0.002]),
    );
    keys(builder, front, form);
    vents(
        builder,
        bay.slab(Side::Right, 0.002).with_y([0.3 * high, 0.5 * high]).with_z([back + 0.03, back + 0.14]),
    );
    builder.cuboid(
        Slot::Rubber,
        bay.slab(Side::Below, 0.03 * high).inset(0.02, 0.0, 0.02).without(Side::Front, bay.depth() * 0.2),
    );
}

/// A dark panel with four keys at the right of the front.
fn keys(builder: &mut Builder, front: f64, form: usize) {
    let bay = builder.bay();
    let high = bay.height();
    let panel = Bay::new(
        [bay.high.x - 0.12, bay.high.x - 0.03],
        [0.4 * high, 0.54 * high],
        [front - 0.004, front + 0.003],
    );
    builder.cuboid(Slot::MetalDark, panel);
    for key in panel.inset(0.008, panel.height() * 0.3, 0.0).columns(4, 0.006) {
        builder.cuboid([Slot::Leaf, Slot::PaintedAccent][form % 2], key.with_z([front, front + 0.006]));
    }
}

/// Slots in the right side, as dark strips on it.
fn vents(builder: &mut Builder, field: Bay) {
    for strip in field.rows(4, field.height() * 0.14) {
        builder.cuboid(Slot::MetalDark, strip.moved(-0.0006, 0.0, 0.0));
    }
}

/// Endless paper from a box below through a flat machine, with a roller's knob on the right.
fn matrix(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let shell = [Slot::Metal, Slot::MetalDark, Slot::PaintedAccent, Slot::Metal][form];
    let (high, half) = (bay.height(), half_paper(bay) * 1.1);
    let stand = high * 0.42;
    four_posts(builder, stand);
    let stack =
        Bay::new([-half, half], [0.002, stand * 0.62], [bay.low.z + 0.02, bay.low.z + bay.depth() * 0.6]);
    for (index, fold) in stack.rows(4, -SINK).into_iter().enumerate() {
        builder.cuboid(Slot::Paper, fold.inset([0.0, 0.002][index % 2], 0.0, [0.0, 0.003][index % 2]));
    }
    let knob = 0.022;
    let body = bay.with_y([stand, high * 0.86]).without(Side::Right, knob).without(Side::Front, 0.003);
    let (low, top) = (body.low, body.high);
    let profile = [
        (low.z, low.y),
        (top.z, low.y),
        (top.z, low.y + body.height() * 0.5),
        (top.z - body.depth() * 0.3, top.y),
        (low.z, top.y),
    ];
    builder.add(shell, extrude(&profile.map(DVec2::from), Axis::X, body.x()));
    let z = body.center().z - body.depth() * 0.06;
    let web = [(z, top.y - 0.004), (z + 0.004, top.y - 0.004), (z - 0.03, high), (z - 0.034, high)]
        .map(DVec2::from);
    builder.add(Slot::Paper, extrude(&web, Axis::X, [-half, half]));
    let back = [
        (low.z + 0.02, stack.high.y - 0.004),
        (low.z + 0.024, stack.high.y - 0.004),
        (low.z + 0.012, top.y - 0.02),
        (low.z + 0.008, top.y - 0.02),
    ];
    builder.add(Slot::Paper, extrude(&back.map(DVec2::from), Axis::X, [-half * 0.99, half * 0.99]));
    builder.cuboid(
        Slot::PlasticDark,
        Bay::new([-half - 0.02, half + 0.02], [top.y - 0.012, top.y + 0.012], [z - 0.012, z + 0.016]),
    );
    let wheel = cylinder(high * 0.075, [-SINK, knob], 10).turned_z(-std::f64::consts::FRAC_PI_2);
    builder.add(Slot::PlasticDark, wheel.moved(body.high.x, top.y - high * 0.07, z));
    let panel = Bay::new(
        [body.high.x - 0.12, body.high.x - 0.02],
        [low.y + 0.012, low.y + body.height() * 0.36],
        [top.z - 0.004, top.z + 0.002],
    );
    builder.cuboid(Slot::PlasticDark, panel.moved(0.0, 0.0, -0.001));
    for key in panel.inset(0.01, panel.height() * 0.3, 0.0).columns(3, 0.01) {
        builder.cuboid(Slot::PaintedAccent, key.with_z([top.z - 0.003, top.z + 0.003]));
    }
}

/// Posts at the corners, up to a height.
fn four_posts(builder: &mut Builder, stand: f64) {
    let bay = builder.bay();
    for x in [bay.low.x + 0.012, bay.high.x - 0.03] {
        for z in [bay.low.z + 0.012, bay.high.z - 0.03] {
            builder.cuboid(Slot::MetalDark, Bay::new([x, x + 0.018], [0.0, stand + SINK], [z, z + 0.018]));
        }
    }
}

/// A low box: paper stands in a feeder at the back and lands on a tray before it.
fn rear_fed(builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let shell = [Slot::PlasticDark, Slot::Plastic, Slot::PlasticDark, Slot::Plastic][form];
    let (high, half) = (bay.height(), half_paper(bay));
    let body = bay
        .with_y([0.0, high * 0.5])
        .inset(0.004, 0.0, 0.0)
        .without(Side::Front, bay.depth() * 0.3)
        .without(Side::Back, bay.depth() * 0.16);
    builder.block(shell, body, 0.016);
    let lid = body.with_y([high * 0.5 - SINK, high * 0.53]).inset(0.02, 0.0, 0.02);
    builder.cuboid(if form == 1 { Slot::PaintedAccent } else { Slot::Metal }, lid);
    let (foot, head) = (body.low.z + 0.012, bay.low.z);
    let leaning = |low: f64, top: f64, off: f64, thick: f64| {
        let at = |share: f64| (foot + (head - foot) * share, high * (0.4 + 0.6 * share));
        let (a, b) = (at(low), at(top));
        [(a.0 + off, a.1), (a.0 + off + thick, a.1), (b.0 + off + thick, b.1), (b.0 + off, b.1)]
            .map(DVec2::from)
    };
    builder.add(shell, extrude(&leaning(0.0, 0.86, 0.0, 0.006), Axis::X, [-half - 0.016, half + 0.016]));
    builder.add(Slot::Paper, extrude(&leaning(0.06, 1.0, 0.0055, 0.008), Axis::X, [-half, half]));
    let tray =
        Bay::new([-half - 0.01, half + 0.01], [high * 0.06, high * 0.09], [body.high.z - 0.01, bay.high.z]);
    builder.cuboid(shell, tray);
    builder.cuboid(
        Slot::MetalDark,
        Bay::new(tray.x(), [high * 0.1, high * 0.24], [body.high.z - 0.01, body.high.z + 0.001]),
    );
    if form < 2 {
        builder.cuboid(
            Slot::Paper,
            tray.inset(0.01, 0.0, 0.0).with_z([tray.low.z + 0.004, tray.high.z - 0.03]).moved(
                0.0,
                high * 0.022,
                0.0,
            ),
        );
    }
    let wing = body.width() / 2.0 - 0.016;
    let panel =
        Bay::new([wing - 0.09, wing], [high * 0.3, high * 0.42], [body.high.z - 0.004, body.high.z + 0.003]);
    builder.cuboid(Slot::Screen, panel);
    let light = Bay::around(DVec3::new(wing - 0.11, high * 0.36, body.high.z), 0.014, 0.014, 0.006);
    builder.cuboid(Slot::PaintedAccent, light);
    let ears = bay.with_y([high * 0.12, high * 0.4]).inset(0.0, 0.0, bay.depth() * 0.4);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(shell, ears.slab(side, 0.01));
    }
}
