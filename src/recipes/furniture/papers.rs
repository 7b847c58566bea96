//! Papers on desks: A4 sheets of 0.21 by 0.297 m, folders, pads, rolled plans.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Solid, cuboid, cylinder, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a pencil's radius.
const PENCIL: f64 = 0.004;

/// Papers: in a folder, a letter with a fountain pen on a blotter, a clipboard or a rolled plan, a pad with notes.
pub(super) static PAPERS: Recipe = Recipe::accessory("papers", [0.22, 0.3, 0.02]).every_set(papers);

fn papers(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    let turn = draft.sampler().between(-0.14, 0.14);
    let bay = builder.bay();
    match draft.set() {
        GeometrySet::Plain => folder(builder, bay, form, turn),
        GeometrySet::Traditional => blotter(builder, bay, form, turn),
        GeometrySet::Industrial if form.is_multiple_of(2) => clipboard(builder, bay, form),
        GeometrySet::Industrial => plans(builder, bay, form),
        GeometrySet::Budget => pad(builder, bay, form, turn),
    }
}

/// A sheet that takes shares of the box's plan, between shares of its height.
fn sheet(bay: Bay, share: f64, [low, high]: [f64; 2], turn: f64) -> Solid {
    let y = [low, high].map(|rise| bay.low.y + rise * bay.height());
    cuboid(bay.inset(bay.width() * (0.5 - share / 2.0), 0.0, bay.depth() * (0.5 - share / 2.0)).with_y(y))
        .turned_y(turn)
}

/// Lines of writing on a sheet, as dark strips, in the lower-left part of the box.
fn lines(builder: &mut Builder, bay: Bay, y: f64, count: u32) {
    let field = bay.inset(bay.width() * 0.2, 0.0, bay.depth() * 0.2);
    for step in 0..count {
        let share = (f64::from(step) + 0.5) / f64::from(count);
        let z = field.low.z + share * field.depth();
        let width = field.width() * if step % 3 == 2 { 0.6 } else { 1.0 };
        let line =
            Bay::new([field.low.x, field.low.x + width], [y - SINK, y + 0.0006], [z - 0.002, z + 0.002]);
        builder.cuboid(Slot::MetalDark, line);
    }
}

/// A pen or pencil that lies across.
fn pencil(builder: &mut Builder, slot: Slot, [from, to]: [DVec3; 2]) {
    builder.add(slot, sweep(&[from, to], PENCIL, 6));
}

/// Sheets half out of a coloured folder, a few loose ones on top.
fn folder(builder: &mut Builder, bay: Bay, form: usize, turn: f64) {
    let slot = [Slot::PaintedAccent, Slot::Leather, Slot::Fabric, Slot::WoodLight][form];
    builder.add(slot, sheet(bay, 1.0, [0.0, 0.3], 0.0));
    builder.add(Slot::Paper, sheet(bay, 0.9, [0.28, 0.62], turn * 0.3));
    builder.add(Slot::Paper, sheet(bay, 0.82, [0.6, if form == 1 { 1.0 } else { 0.8 }], turn));
    if form != 1 {
        let y = bay.low.y + bay.height() * 0.8;
        lines(builder, bay, y, 5);
        let top = (bay.high.y - y).max(0.002);
        let pen = Bay::new(
            [bay.width() * 0.2, bay.width() * 0.2 + 0.008],
            [y - SINK, y + top],
            [-bay.depth() * 0.25, bay.depth() * 0.25],
        );
        builder.cuboid(Slot::MetalDark, pen);
    }
}

/// A letter on a blotter with leather corners, and a pen beside it.
fn blotter(builder: &mut Builder, bay: Bay, form: usize, turn: f64) {
    builder.add(
        [Slot::Leaf, Slot::Book, Slot::Leather, Slot::WoodDark][form],
        sheet(bay, 1.0, [0.0, 0.26], 0.0),
    );
    let y = [bay.low.y + bay.height() * 0.2, bay.low.y + bay.height() * 0.32];
    let side = (bay.width() * 0.14).min(bay.depth() * 0.3);
    for x in [Side::Left, Side::Right] {
        for z in [Side::Front, Side::Back] {
            let corner = bay.inset(0.0008, 0.0, 0.0008).slab(x, side).slab(z, side);
            builder.cuboid(if form == 0 { Slot::Leather } else { Slot::Brass }, corner.with_y(y));
        }
    }
    builder.add(Slot::Linen, sheet(bay, 0.7, [0.24, 0.44], turn));
    let top = bay.low.y + bay.height() * 0.44;
    lines(builder, bay.inset(bay.width() * 0.1, 0.0, bay.depth() * 0.1), top, 6);
    let rest = (bay.high.y - top) / 2.0;
    let at = |x: f64, z: f64| DVec3::new(x * bay.width(), top + rest - SINK, z * bay.depth());
    builder.add(Slot::MetalDark, sweep(&[at(0.3, -0.2), at(0.24, 0.2)], rest.max(0.0015), 6));
    builder.add(Slot::Brass, sweep(&[at(0.2415, 0.19), at(0.232, 0.25)], rest.max(0.0015) * 0.7, 6));
}

/// A board with a clip of steel over a form.
fn clipboard(builder: &mut Builder, bay: Bay, form: usize) {
    builder.add(if form == 0 { Slot::Wood } else { Slot::Metal }, sheet(bay, 1.0, [0.0, 0.3], 0.0));
    builder.add(Slot::Paper, sheet(bay, 0.9, [0.28, 0.42], 0.01));
    lines(builder, bay, bay.low.y + bay.height() * 0.42, 7);
    let clip = bay.slab(Side::Back, bay.depth() * 0.1).inset(bay.width() * 0.26, 0.0, 0.0);
    builder.cuboid(
        Slot::Chrome,
        clip.inset(0.0, 0.0, 0.0006).with_y([bay.low.y + bay.height() * 0.26, bay.high.y]),
    );
    let y = bay.low.y + bay.height() * 0.42 + PENCIL * 0.8;
    let side = bay.width() * 0.4;
    pencil(
        builder,
        Slot::PaintedAccent,
        [DVec3::new(side, y, -bay.depth() * 0.2), DVec3::new(side, y, bay.depth() * 0.2)],
    );
}

/// A plan that is rolled out under two rolls.
fn plans(builder: &mut Builder, bay: Bay, form: usize) {
    builder.add(if form == 1 { Slot::PaintedAccent } else { Slot::Paper }, sheet(bay, 1.0, [0.0, 0.16], 0.0));
    let y = bay.low.y + bay.height() * 0.16;
    let field = bay.inset(bay.width() * 0.1, 0.0, bay.depth() * 0.14);
    let strokes = [
        (-0.3, -0.3, 0.4, 0.012),
        (-0.3, 0.24, 0.4, 0.012),
        (-0.5, -0.03, 0.012, 0.56),
        (-0.1, -0.03, 0.012, 0.55),
        (0.2, -0.1, 0.3, 0.012),
    ];
    // Each a little higher than the one that it crosses.
    for (rise, (x, z, wide, deep)) in (2..).zip(strokes) {
        let at = DVec3::new(x * field.width(), y, z * field.depth());
        let line = Bay::around(at, wide * field.width(), 0.0006 * f64::from(rise), deep * field.depth());
        builder.cuboid(Slot::MetalDark, line);
    }
    let radius = (bay.high.y - y) / 2.0;
    let roll =
        cylinder(radius, [-bay.depth() * 0.46, bay.depth() * 0.46], 8).turned_x(std::f64::consts::FRAC_PI_2);
    for (share, turn) in [(0.42, 0.06), (0.24, -0.05)] {
        builder.add(
            if share > 0.3 { Slot::Paper } else { Slot::Linen },
            roll.clone().turned_y(turn).moved(share * bay.width(), y + radius - SINK, 0.0),
        );
    }
}

/// A squared pad bound at its head, coloured notes, a pen of plastic.
fn pad(builder: &mut Builder, bay: Bay, form: usize, turn: f64) {
    builder.add(Slot::WoodLight, sheet(bay, 1.0, [0.0, 0.12], 0.0));
    builder.add(Slot::Paper, sheet(bay, 0.985, [0.1, 0.5], 0.0));
    let head = bay.slab(Side::Back, bay.depth() * 0.08).inset(0.0005, 0.0, 0.0005);
    builder.cuboid(
        [Slot::PaintedAccent, Slot::Book, Slot::Leaf, Slot::MetalDark][form],
        head.with_y([bay.low.y, bay.low.y + bay.height() * 0.62]).inset(0.0, 0.0004, 0.0),
    );
    let y = bay.low.y + bay.height() * 0.5;
    lines(builder, bay.without(Side::Back, bay.depth() * 0.1), y, 6);
    let note = Bay::around(
        DVec3::new(bay.width() * 0.22, (y + bay.high.y) / 2.0, bay.depth() * 0.24),
        bay.width() * 0.34,
        bay.high.y - y + SINK,
        bay.width() * 0.34,
    );
    builder.add(
        [Slot::Brass, Slot::Leaf, Slot::PaintedAccent, Slot::Brass][form],
        cuboid(note).turned_y(turn * 0.5),
    );
    let pen = Bay::new(
        [-bay.width() * 0.3, -bay.width() * 0.3 + 0.008],
        [y - SINK, y + 0.006],
        [-bay.depth() * 0.2, bay.depth() * 0.26],
    );
    builder.add(Slot::Book, cuboid(pen).turned_y(0.2));
}
