//! Lockers. DIN 4547 and EN 16121: a compartment 0.30 m wide, 1.80 high and 0.50 deep; doors with slots for air at both
//! ends, on a plinth, on legs or on a bench.

use glam::{DVec2, DVec3};

use super::{PLINTH, REACH};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    HandleForm, HandleKind, LegKind, REVEAL, cornice, handle, legs_at_corners, slab_top, turned_forward,
};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, extrude, lathe};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a compartment's width.
const COMPARTMENT: f64 = 0.32;
/// Metres of a door's sheet or board.
const DOOR: f64 = 0.018;
/// Metres by which locks and grips stand out.
const GRIP: f64 = REACH * 0.6;

/// Metres from slat to slat of a louvred door.
const SLAT: f64 = 0.07;

/// What all lockers are made from: the box, how many doors stand side by side, and the look.
struct Row {
    bay: Bay,
    count: u32,
    form: usize,
}

/// Lockers with `doors` side by side: flush, of louvred wood, of wire, or of thin coloured sheet.
pub(in super::super) static LOCKER: Recipe = Recipe::furniture("locker", [0.9, 0.5, 1.9])
    .with(&[("doors", 0.0)])
    .symbol(Symbol::Doors)
    .every_set(locker);

fn locker(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let count = draft.count_along("doors", bay.width(), COMPARTMENT, 6);
    let row = Row { bay, count, form: draft.form() };
    match draft.set() {
        GeometrySet::Plain => plain(&row, builder),
        GeometrySet::Traditional => traditional(&row, builder),
        GeometrySet::Industrial => industrial(&row, builder),
        GeometrySet::Budget => budget(&row, builder),
    }
}

/// The body behind doors; gives the space of the doors.
fn body(builder: &mut Builder, slot: Slot, case: Bay) -> Bay {
    builder.cuboid(slot, case.without(Side::Front, GRIP + DOOR - SINK));
    case.without(Side::Front, GRIP).slab(Side::Front, DOOR).inset(REVEAL, REVEAL, 0.0)
}

/// Dark strips on a door, in a band from a share of its height upwards.
fn vents(builder: &mut Builder, door: Bay, from: f64, count: u32) {
    let field = door.inset(door.width() * 0.25, 0.0, 0.0);
    let low = door.low.y + from * door.height();
    let field = field.with_y([low, low + 0.022 * f64::from(count)]);
    for strip in field.rows(count, 0.012) {
        builder.cuboid(Slot::MetalDark, strip.with_z([door.high.z - 0.003, door.high.z + 0.001]));
    }
}

/// A number on a plate.
fn plate(builder: &mut Builder, slot: Slot, door: Bay, share: f64) {
    let at = DVec3::new(door.center().x, door.low.y + share * door.height(), door.high.z);
    builder.cuboid(slot, Bay::around(at, 0.05, 0.03, 0.003));
}

/// A round lock.
fn lock(builder: &mut Builder, door: Bay, share: f64) {
    let knob = turned_forward(lathe(&[(0.017, -SINK), (0.017, GRIP * 0.6), (0.011, GRIP)], 8));
    let at = DVec3::new(door.high.x - 0.035, door.low.y + share * door.height(), door.high.z);
    builder.add(Slot::MetalDark, knob.moved(at.x, at.y, at.z));
}

/// Flush doors: full height, in two rows of wood, in the form of a Z, or cubes with a niche for the shoes below.
fn plain(row: &Row, builder: &mut Builder) {
    let plinth = PLINTH.min(row.bay.height() * 0.1);
    builder.cuboid(
        Slot::MetalDark,
        row.bay
            .slab(Side::Below, plinth + SINK)
            .inset(0.004, 0.0, 0.0)
            .without(Side::Front, 0.05)
            .without(Side::Back, 0.002),
    );
    let doors = body(builder, Slot::Painted, row.bay.without(Side::Below, plinth));
    let (slot, rows) =
        [(Slot::PaintedAccent, 1), (Slot::Wood, 2), (Slot::PaintedAccent, 1), (Slot::WoodLight, 4)][row.form];
    if row.form == 2 {
        doors.columns(row.count, REVEAL).into_iter().for_each(|column| z_doors(builder, slot, column));
        return;
    }
    for line in doors.rows(rows, REVEAL) {
        for door in line.columns(row.count, REVEAL) {
            builder.cuboid(slot, door);
            lock(builder, door, if rows > 2 { 0.5 } else { 0.56 });
            plate(builder, Slot::Metal, door, 0.9);
            if rows == 1 {
                vents(builder, door, 0.05, 2);
            }
        }
    }
}

/// Two doors that share one column, each wide where the other is narrow.
fn z_doors(builder: &mut Builder, slot: Slot, column: Bay) {
    let (low, high, middle) = (column.low, column.high, column.center());
    let (step, split) = (column.height() * 0.16, middle.x);
    let lower = [
        (low.x, low.y),
        (high.x, low.y),
        (high.x, middle.y - step),
        (split, middle.y - step),
        (split, middle.y + step),
        (low.x, middle.y + step),
    ];
    let upper = [
        (high.x, high.y),
        (low.x, high.y),
        (low.x, middle.y + step + REVEAL),
        (split + REVEAL, middle.y + step + REVEAL),
        (split + REVEAL, middle.y - step + REVEAL),
        (high.x, middle.y - step + REVEAL),
    ];
    for (profile, is_lower) in [(lower, true), (upper, false)] {
        builder.add(slot, extrude(&profile.map(DVec2::from), Axis::Z, column.z()));
        let y = middle.y + if is_lower { -step } else { step } * 1.6;
        let knob = turned_forward(lathe(&[(0.017, -SINK), (0.017, GRIP * 0.6), (0.011, GRIP)], 8));
        let x = if is_lower { high.x - 0.035 } else { low.x + 0.035 };
        builder.add(Slot::MetalDark, knob.moved(x, y, column.high.z));
    }
}

/// Louvred doors of wood between stiles, under a cornice; brass numbers.
fn traditional(row: &Row, builder: &mut Builder) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][row.form];
    let bay = row.bay;
    let (crown, foot) = (0.06_f64.min(bay.height() * 0.08), 0.08_f64.min(bay.height() * 0.1));
    cornice(builder, slot, bay.slab(Side::Above, crown), 0.025);
    slab_top(
        builder,
        slot,
        bay.slab(Side::Below, foot)
            .inset(0.008, 0.0, 0.0)
            .without(Side::Front, 0.004)
            .without(Side::Back, 0.001),
        true,
    );
    let case = bay.inset(0.025, 0.0, 0.0).without(Side::Back, 0.002).without(Side::Front, 0.008);
    let doors =
        body(builder, slot, case.without(Side::Above, crown - SINK).without(Side::Below, foot - SINK));
    let rows = if row.form == 3 { 2 } else { 1 };
    for line in doors.inset(0.016, 0.01, 0.0).rows(rows, 0.02) {
        for door in line.columns(row.count, 0.014) {
            louvred(builder, slot, door, row.form);
            let knob = DVec3::new(door.high.x - 0.025, door.low.y + door.height() * 0.52, door.high.z);
            handle(builder, Slot::Brass, HandleForm { kind: HandleKind::Knob, length: 0.0 }, knob, GRIP);
            plate(builder, Slot::Brass, door, 0.94);
        }
    }
}

/// A frame around slats that shed the view; panels in the lower half of some.
fn louvred(builder: &mut Builder, slot: Slot, door: Bay, form: usize) {
    let stile = 0.045_f64.min(door.width() * 0.2);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, door.slab(side, stile));
    }
    let inner = door.inset(stile - SINK, 0.0, 0.0012);
    let middle = door.low.y + door.height() * 0.5;
    let rail = stile * 1.3;
    for low in [door.low.y + 0.0006, middle - rail / 2.0, door.high.y - rail - 0.0006] {
        builder.cuboid(slot, inner.with_y([low, low + rail]));
    }
    for (index, field) in
        [[door.low.y + rail, middle - rail / 2.0], [middle + rail / 2.0, door.high.y - rail]]
            .iter()
            .enumerate()
    {
        let field = inner.with_y(*field);
        if index == 0 && form == 1 {
            builder.cuboid(slot, field.inset(0.014, 0.016, 0.004));
            continue;
        }
        let count = (field.height() / SLAT).round().clamp(3.0, 12.0) as u32;
        for slat in field.rows(count, 0.0) {
            let (y, z) = (slat.low.y, slat.z());
            let profile = [
                (z[1] - 0.002, y),
                (z[1] - 0.002, y + 0.007),
                (z[0] + 0.001, y + slat.height() * 0.9),
                (z[0] + 0.001, y + slat.height() * 0.7),
            ];
            builder.add(slot, extrude(&profile.map(DVec2::from), Axis::X, field.x()));
        }
    }
}

/// Doors of wire or of sheet with holes before dark compartments, on legs, under a sloping top.
fn industrial(row: &Row, builder: &mut Builder) {
    let bay = row.bay;
    let (leg, slope) = (0.14_f64.min(bay.height() * 0.12), 0.12_f64.min(bay.height() * 0.1));
    let front = bay.high.z - GRIP - 0.002;
    legs_at_corners(
        builder,
        Slot::MetalDark,
        bay.slab(Side::Below, leg + SINK).without(Side::Front, GRIP + 0.002),
        0.035,
        LegKind::Angle,
    );
    let case =
        bay.without(Side::Below, leg).without(Side::Above, if row.form == 3 { 0.0 } else { slope - SINK });
    if row.form != 3 {
        let (y, back) = (case.high.y - SINK, bay.low.z);
        let roof = [(front, y), (front, y + 0.012), (back, bay.high.y), (back, y)].map(DVec2::from);
        builder.add(Slot::MetalDark, extrude(&roof, Axis::X, bay.x()));
    }
    let is_wire = row.form.is_multiple_of(2);
    let shell = if row.form == 1 { Slot::PaintedAccent } else { Slot::Metal };
    let doors = body(
        builder,
        if is_wire { Slot::MetalDark } else { shell },
        case.inset(0.002, 0.0, 0.0).without(Side::Back, 0.001),
    );
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            shell,
            case.without(Side::Front, GRIP + 0.001).inset(0.001, 0.001, 0.0005).slab(side, 0.012),
        );
    }
    let rows = if row.form == 2 { 2 } else { 1 };
    for line in doors.inset(0.01, 0.006, 0.0).rows(rows, 0.012) {
        for door in line.columns(row.count, 0.012) {
            if is_wire {
                wire(builder, door)
            } else {
                pressed(builder, shell, door)
            }
            hasp(builder, door);
        }
    }
}

/// A frame of flat bar around a grid of rods.
fn wire(builder: &mut Builder, door: Bay) {
    let bar = 0.022;
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Metal, door.slab(side, bar));
    }
    let inner = door.inset(bar - SINK, 0.0, 0.0);
    for side in [Side::Above, Side::Below] {
        builder.cuboid(Slot::Metal, inner.inset(0.0, 0.0005, 0.0012).slab(side, bar));
    }
    let field = inner.inset(0.0, bar - SINK, 0.0);
    let (across, up) =
        ((field.width() / 0.05).round().max(3.0) as u32, (field.height() / 0.17).round().max(3.0) as u32);
    for rod in field.columns(across, 0.0) {
        builder.cuboid(Slot::Metal, Bay::around(rod.center() + DVec3::Z * 0.003, 0.006, rod.height(), 0.006));
    }
    for rod in field.rows(up, 0.0) {
        builder.cuboid(Slot::Metal, Bay::around(rod.center() + DVec3::Z * 0.006, rod.width(), 0.008, 0.005));
    }
}

/// Folded sheet with fields of slots at both ends.
fn pressed(builder: &mut Builder, slot: Slot, door: Bay) {
    builder.block(slot, door, 0.004);
    vents(builder, door, 0.06, 5);
    vents(builder, door, 0.82, 5);
    plate(builder, Slot::Brass, door, 0.72);
}

/// A hasp with its padlock.
fn hasp(builder: &mut Builder, door: Bay) {
    let at = DVec3::new(door.high.x - 0.03, door.low.y + door.height() * 0.54, door.high.z);
    builder.cuboid(Slot::MetalDark, Bay::around(at + DVec3::Z * 0.0025, 0.05, 0.022, 0.006));
    let body = Bay::around(at + DVec3::new(0.0, -0.03, GRIP * 0.5 - 0.001), 0.034, 0.036, GRIP);
    builder.block(Slot::Brass, body, 0.004);
}

/// Thin coloured doors on round feet: three slots, sheet or plastic, full height or in rows.
fn budget(row: &Row, builder: &mut Builder) {
    let bay = row.bay;
    let foot = 0.1_f64.min(bay.height() * 0.08);
    legs_at_corners(
        builder,
        Slot::PlasticDark,
        bay.slab(Side::Below, foot + SINK).inset(0.02, 0.0, 0.03),
        0.03,
        LegKind::Round,
    );
    let (shell, slots, rows): (_, [Slot; 2], _) = [
        (Slot::Metal, [Slot::PaintedAccent, Slot::PaintedAccent], 1),
        (Slot::Plastic, [Slot::Plastic, Slot::PaintedAccent], 2),
        (Slot::Metal, [Slot::Metal, Slot::Metal], 1),
        (Slot::Laminate, [Slot::Laminate, Slot::PaintedAccent], 3),
    ][row.form];
    let doors = body(builder, shell, bay.without(Side::Below, foot));
    for (level, line) in doors.inset(0.004, 0.004, 0.0).rows(rows, 0.008).into_iter().enumerate() {
        for (index, door) in line.columns(row.count, 0.008).into_iter().enumerate() {
            builder.cuboid(slots[(level + index) % 2], door);
            let at = DVec3::new(door.high.x - 0.03, door.low.y + door.height() * 0.5, door.high.z);
            let grip = Bay::around(at + DVec3::Z * (GRIP / 2.0 - SINK), 0.022, 0.07, GRIP + SINK);
            builder.cuboid(Slot::PlasticDark, grip);
            if shell == Slot::Metal {
                vents(builder, door, 0.86, 3);
            } else {
                let hole = Bay::around(
                    DVec3::new(door.center().x, door.high.y - 0.04, door.high.z),
                    0.07,
                    0.014,
                    0.002,
                );
                builder.cuboid(Slot::PlasticDark, hole);
            }
        }
    }
}
