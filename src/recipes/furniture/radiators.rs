//! Radiators.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A radiator with pipes and a valve: panels, cast columns, pipes with fins, or ribs of sheet steel. Usual ones are
/// 0.4-0.6 m high and 0.1 m deep; columns stand 0.05-0.06 apart.
pub(super) static RADIATOR: Recipe = Recipe::furniture("radiator", [1.0, 0.1, 0.6]).every_set(radiator);

fn radiator(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let lift = (bay.height() * 0.14).min(0.1);
    let body = bay.without(Side::Below, lift).without(Side::Right, 0.055);
    match draft.set() {
        GeometrySet::Traditional => {
            columns(builder, [Slot::Painted, Slot::MetalDark, Slot::Brass, Slot::Painted][look], body, look)
        }
        GeometrySet::Industrial if look.is_multiple_of(2) => serpentine(builder, body),
        GeometrySet::Industrial => columns(builder, [Slot::Metal, Slot::MetalDark][look / 2], body, look),
        GeometrySet::Budget if look == 3 => tubes(builder, body),
        GeometrySet::Budget => panel(builder, body, 18),
        GeometrySet::Plain => match look {
            0 => panel(builder, body, 0),
            1 => tubes(builder, body),
            2 => slats(builder, body),
            _ => panel(builder, body, 10),
        },
    }
    pipes(draft, builder, body);
}

fn panel(builder: &mut Builder, body: Bay, ribs: u32) {
    let plate = body.slab(Side::Front, body.depth() * 0.24);
    builder.block(Slot::Painted, plate.without(Side::Front, if ribs == 0 { 0.0 } else { 0.004 }), 0.005);
    if ribs > 0 {
        for rib in plate.inset(0.02, 0.025, 0.0).columns(ribs, body.width() * 0.018) {
            builder.cuboid(Slot::Painted, rib.with_z([plate.high.z - 0.006, plate.high.z]));
        }
    }
    builder.block(Slot::Painted, body.slab(Side::Back, body.depth() * 0.24), 0.005);
    let cover = body.slab(Side::Above, 0.014).inset(0.003, 0.0, 0.0065).moved(0.0, -0.002, 0.0);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::Painted, cover.slab(side, body.depth() * 0.3));
    }
    for bar in cover.inset(0.004, 0.001, 0.003).columns(12, body.width() * 0.05) {
        builder.cuboid(Slot::Painted, bar);
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::Painted,
            body.slab(side, 0.004).inset(0.0, 0.006, 0.012).moved(
                if side == Side::Left { 0.002 } else { -0.002 },
                0.0,
                0.0,
            ),
        );
    }
}

/// Cast columns with bulges at their ends, joined below and above.
fn columns(builder: &mut Builder, slot: Slot, body: Bay, look: usize) {
    let count = (body.width() / 0.06).round().clamp(3.0, 18.0) as u32;
    for column in body.columns(count, 0.006) {
        let (half, middle) = (column.extent() / 2.0, column.center());
        let y = |share: f64| column.low.y + share * column.height();
        let slice = |share: f64, x: f64, z: f64| {
            Slice::new(y(share), half.x * x, half.z * z).at(middle.x, middle.z).softened(half.x * x * 0.8)
        };
        let waist = if look.is_multiple_of(2) { 0.8 } else { 0.62 };
        let slices = [
            slice(0.0, 0.5, 0.6),
            slice(0.06, 0.95, 0.98),
            slice(0.14, 1.0, 1.0),
            slice(0.2, waist, 0.94),
            slice(0.8, waist, 0.94),
            slice(0.86, 1.0, 1.0),
            slice(0.94, 0.95, 0.98),
            slice(1.0, 0.5, 0.6),
        ];
        builder.add(slot, loft(&Outline::Soft(1), &slices));
    }
    for share in [0.1, 0.9] {
        let y = body.low.y + share * body.height();
        let hub = [DVec3::new(body.low.x + 0.01, y, 0.0), DVec3::new(body.high.x - 0.01, y, 0.0)];
        builder.add(slot, sweep(&hub, 0.016, 6));
    }
    for x in [body.low.x + 0.03, body.high.x - 0.03] {
        let foot = lathe(
            &[(0.02, 0.0), (0.018, body.low.y * 0.3), (0.01, body.low.y * 0.7), (0.016, body.low.y + 0.03)],
            6,
        );
        builder.add(slot, foot.moved(x, 0.0, 0.0));
    }
}

/// Round tubes side by side.
fn tubes(builder: &mut Builder, body: Bay) {
    let count = (body.width() / 0.048).round().clamp(3.0, 22.0) as u32;
    for column in body.columns(count, 0.018) {
        let radius = column.width() / 2.0;
        for z in [body.low.z + radius, body.high.z - radius] {
            builder.add(Slot::Painted, cylinder(radius, column.y(), 8).moved(column.center().x, 0.0, z));
        }
    }
    for share in [0.06, 0.94] {
        let y = body.low.y + share * body.height();
        builder.block(Slot::Painted, body.inset(0.003, 0.0, 0.012).with_y([y - 0.014, y + 0.014]), 0.006);
    }
}

/// Broad flat bars, one above another.
fn slats(builder: &mut Builder, body: Bay) {
    for row in body.rows(5, body.height() * 0.035) {
        builder.block(Slot::Painted, row.slab(Side::Front, body.depth() * 0.3), 0.004);
    }
    for side in [Side::Left, Side::Right] {
        let post = body.inset(0.03, 0.004, 0.0).slab(side, 0.04);
        builder.cuboid(Slot::Painted, post.without(Side::Front, body.depth() * 0.3 - SINK));
    }
}

/// A thick pipe that goes to and fro.
fn serpentine(builder: &mut Builder, body: Bay) {
    let rows = (body.height() / 0.11).round().clamp(2.0, 6.0) as u32;
    let radius = (body.depth() * 0.3).min(body.height() / f64::from(rows) * 0.36);
    let bays = body.rows(rows, 0.0);
    for (index, row) in bays.iter().enumerate() {
        let y = row.center().y
            + if index == 0 {
                radius * 1.25 - row.height() / 2.0
            } else if index + 1 == bays.len() {
                row.height() / 2.0 - radius * 1.25
            } else {
                0.0
            };
        builder.add(
            Slot::MetalDark,
            sweep(
                &[DVec3::new(body.low.x + radius, y, 0.0), DVec3::new(body.high.x - radius, y, 0.0)],
                radius * 1.03,
                8,
            ),
        );
        let end = if index % 2 == 0 { body.low.x + radius } else { body.high.x - radius };
        if index > 0 && index + 1 < bays.len() || index == 0 {
            let next = bays.get(index + 1).map_or(y, |next| next.center().y);
            builder.add(
                Slot::MetalDark,
                sweep(
                    &[DVec3::new(end, y - radius * 0.4, 0.0), DVec3::new(end, next + radius * 0.6, 0.0)],
                    radius * 1.08,
                    6,
                ),
            );
        }
        for fin in 0..6 {
            let x = body.low.x + body.width() * (0.12 + 0.15 * f64::from(fin));
            let ring = cylinder(radius * 1.35, [-0.003, 0.003], 8).turned_z(std::f64::consts::FRAC_PI_2);
            builder.add(Slot::Metal, ring.moved(x, y, 0.0));
        }
    }
    for side in [Side::Left, Side::Right] {
        let stay = body.inset(body.width() * 0.08, 0.0, 0.0).slab(side, 0.02);
        builder.cuboid(Slot::Metal, stay.with_z([body.low.z, -radius * 0.6]));
        builder.cuboid(
            Slot::Metal,
            stay.inset(0.003, 0.0, 0.0)
                .with_z([radius * 0.6, body.high.z])
                .with_y([body.low.y + 0.01, body.low.y + 0.03]),
        );
    }
}

/// Supply at the right with a valve, and where the pipes go into the floor.
fn pipes(draft: &Draft, builder: &mut Builder, body: Bay) {
    let bay = builder.bay();
    let slot = if draft.set() == GeometrySet::Traditional { Slot::Brass } else { Slot::Metal };
    let x = bay.high.x - 0.028;
    let y = body.low.y + body.height() * 0.1;
    let pipe = [DVec3::new(body.high.x - 0.026, y, 0.0), DVec3::new(x, y, 0.0), DVec3::new(x, 0.0, 0.0)];
    builder.add(slot, sweep(&pipe, 0.009, 6));
    if draft.is_traditional() {
        let wheel =
            [(0.006, y), (0.006, y + 0.04), (0.026, y + 0.044), (0.026, y + 0.052), (0.008, y + 0.058)];
        builder.add(Slot::WoodDark, lathe(&wheel, 8).moved(x, 0.0, 0.0));
    } else {
        let head = [(0.014, y + 0.004), (0.022, y + 0.014), (0.022, y + 0.058), (0.016, y + 0.064)];
        builder.add(Slot::Plastic, lathe(&head, 10).moved(x, 0.0, 0.0));
    }
    builder.cuboid(slot, Bay::new([x, bay.high.x], [y - 0.006, y + 0.006], [-0.0062, 0.0062]));
}
