//! Ticket machines: 0.6 to 0.9 m wide, 0.4 to 0.6 deep, 1.8 to 2.0 high; screens 0.8 to 1.4 m over the floor
//! (EN 301549).

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, pipe};
use crate::recipes::{Recipe, Slot};

/// A machine that sells tickets: a leaning screen between cheeks; an arched cabinet with rows of buttons; a bolted
/// cabinet of steel under a roof; a terminal on two legs.
pub(super) static TICKET_MACHINE: Recipe = Recipe::furniture("ticket_machine", [0.8, 0.6, 1.85])
    .plain(|draft, builder| leaning(builder, draft.form()))
    .traditional(|draft, builder| arched(builder, draft.form()))
    .industrial(|draft, builder| bolted(builder, draft.form()))
    .budget(|draft, builder| on_legs(builder, draft.form()));

/// A thin plate on a front at shares of a face: (left, right), (low, high).
fn plate(face: Bay, x: [f64; 2], y: [f64; 2], out: f64) -> Bay {
    let across = |share: f64| face.low.x + share * face.width();
    let up = |share: f64| face.low.y + share * face.height();
    Bay::new(x.map(across), y.map(up), [face.high.z - SINK, face.high.z + out])
}

/// A tray that stands out of a face, with a dark opening above it.
fn tray(builder: &mut Builder, slot: Slot, face: Bay, x: [f64; 2], y: [f64; 2]) {
    let front = builder.bay().high.z;
    let opening = plate(face, x, y, 0.004);
    builder.cuboid(Slot::PlasticDark, opening);
    let lip = opening.slab(Side::Below, opening.height() * 0.4).inset(-0.01, 0.0, 0.0);
    builder.block(slot, lip.with_z([face.high.z - SINK, front]).moved(0.0, -0.004, 0.0), 0.004);
}

/// A grid of keys on a plate.
fn keys(builder: &mut Builder, slot: Slot, field: Bay, [columns, rows]: [u32; 2]) {
    let gap = (field.width() / f64::from(columns) * 0.3).min(field.height() / f64::from(rows) * 0.3);
    for row in field.rows(rows, gap) {
        for key in row.columns(columns, gap) {
            builder.cuboid(slot, key);
        }
    }
}

/// A screen that leans back between two cheeks, a reader and a tray below, a lit sign over it.
fn leaning(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (height, depth) = (bay.height(), bay.depth());
    let slot = [Slot::PaintedAccent, Slot::Appliance, Slot::MetalDark, Slot::Painted][look];
    let at = |z: f64, y: f64| DVec2::new(bay.low.z + z * depth, y * height);
    let (foot, head) = (at(0.9, 0.46), at(0.64, 0.86));
    let body = [at(0.02, 0.04), at(0.82, 0.04), at(0.9, 0.12), foot, head, at(0.02, 0.86)];
    builder.add(Slot::Appliance, extrude(&body, Axis::X, bay.inset(0.03, 0.0, 0.0).x()));
    let cheek = [at(0.0, 0.0), at(0.8, 0.0), at(0.97, 0.1), at(0.97, 0.46), at(0.74, 0.88), at(0.0, 0.88)];
    for x in [[bay.low.x, bay.low.x + 0.035], [bay.high.x - 0.035, bay.high.x]] {
        builder.add(slot, extrude(&cheek, Axis::X, x));
    }
    let out = (head - foot).normalize().perp() * -1.0;
    let on_slope = |builder: &mut Builder, slot, (low, high): (f64, f64), thick: f64, x: [f64; 2]| {
        let (a, b) = (foot.lerp(head, low), foot.lerp(head, high));
        let quad = [a - out * 0.004, a + out * thick, b + out * thick, b - out * 0.004];
        builder.add(slot, extrude(&quad, Axis::X, x));
    };
    let half = bay.width() / 2.0;
    on_slope(builder, Slot::PlasticDark, (0.16, 0.94), 0.006, [-half * 0.72, half * 0.72]);
    on_slope(builder, Slot::Screen, (0.2, 0.9), 0.01, [-half * 0.66, half * 0.66]);
    for row in 0..3 {
        let low = 0.28 + 0.16 * f64::from(row);
        on_slope(
            builder,
            Slot::Lamp,
            (low, low + 0.09),
            0.0115,
            [-half * 0.55, half * [0.1, 0.3, -0.1][row as usize]],
        );
    }
    let face = bay
        .with_y([height * 0.12, height * 0.46])
        .with_z([bay.low.z, bay.low.z + depth * 0.9])
        .inset(0.04, 0.0, 0.0);
    tray(builder, Slot::Metal, face, [0.3, 0.7], [0.16, 0.36]);
    builder.cuboid(Slot::PlasticDark, plate(face, [0.62, 0.86], [0.56, 0.88], 0.02));
    builder.cuboid(Slot::Lamp, plate(face, [0.66, 0.82], [0.6, 0.64], 0.022));
    builder.cuboid(Slot::Metal, plate(face, [0.14, 0.34], [0.6, 0.86], 0.008));
    builder.cuboid(Slot::PlasticDark, plate(face, [0.22, 0.26], [0.66, 0.8], 0.0095));
    let sign =
        bay.with_y([height * 0.88 - SINK, height]).with_z([bay.low.z + 0.004, bay.low.z + depth * 0.72]);
    builder.block(slot, sign.inset(0.004, 0.0, 0.0), 0.02);
    builder.cuboid(Slot::Lamp, plate(sign, [0.1, 0.9], [0.26, 0.74], 0.004));
}

/// A cabinet of wood with an arched head, a clock in it, a plate of brass with rows of buttons and a slot for coins.
fn arched(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (height, half) = (bay.height(), bay.width() / 2.0);
    let slot = [Slot::WoodDark, Slot::PaintedAccent, Slot::Wood, Slot::WoodDark][look];
    let plinth = height * 0.09;
    builder.block(slot, bay.slab(Side::Below, plinth).without(Side::Front, 0.012), 0.01);
    let body = bay.inset(0.016, 0.0, 0.0).with_z([bay.low.z + 0.002, bay.high.z - 0.05]);
    let spring = height * 0.84;
    let arc = |half: f64, spring: f64, rise: f64| {
        (0..=10).map(move |step| {
            let (sine, cosine) = libm::sincos(std::f64::consts::PI * f64::from(step) / 10.0);
            DVec2::new(cosine * half, spring + sine * rise)
        })
    };
    let outline = |half: f64, low: f64, spring: f64, rise: f64| {
        let mut outline: Vec<DVec2> = arc(half, spring, rise).collect();
        outline.extend([DVec2::new(-half, low), DVec2::new(half, low)]);
        outline
    };
    let front = body.high.z;
    let shell = outline(half - 0.016, plinth - SINK, spring, height - spring);
    builder.add(slot, extrude(&shell, Axis::Z, body.z()));
    let field = outline(half * 0.82, plinth + 0.05, spring, (height - spring) * 0.72);
    builder.add(Slot::Brass, extrude(&field, Axis::Z, [front - SINK, front + 0.008]));
    let inner = outline(half * 0.78, plinth + 0.065, spring, (height - spring) * 0.66);
    builder.add(Slot::Painted, extrude(&inner, Axis::Z, [front, front + 0.012]));
    let face = Bay::new([-half * 0.78, half * 0.78], [plinth + 0.065, spring], [body.low.z, front + 0.012]);
    let dial = |radius: f64, out: f64| {
        turned_forward(cylinder(radius, [face.high.z - SINK, face.high.z + out], 16)).moved(
            0.0,
            spring - 0.01,
            0.0,
        )
    };
    builder.add(Slot::Brass, dial(half * 0.32, 0.012));
    builder.add(Slot::Ceramic, dial(half * 0.28, 0.015));
    for (x, y, wide, tall, out) in
        [(0.0, half * 0.1, 0.012, half * 0.24, 0.016), (half * 0.07, 0.0, half * 0.18, 0.011, 0.0165)]
    {
        let hand = Bay::around(DVec3::new(x, spring - 0.01 + y, face.high.z + out), wide, tall, 0.004);
        builder.cuboid(Slot::PlasticDark, hand);
    }
    builder.cuboid(Slot::Screen, plate(face, [0.14, 0.86], [0.7, 0.82], 0.006));
    keys(builder, Slot::Brass, plate(face, [0.1, 0.62], [0.36, 0.66], 0.012), [4, 6]);
    builder.block(Slot::Brass, plate(face, [0.7, 0.92], [0.44, 0.66], 0.01), 0.003);
    builder.cuboid(Slot::PlasticDark, plate(face, [0.79, 0.83], [0.52, 0.62], 0.0115));
    let knob = turned_forward(cylinder(0.018, [0.0, 0.03], 8));
    builder.add(Slot::Brass, knob.moved(face.high.x * 0.62, face.low.y + face.height() * 0.475, face.high.z));
    tray(builder, Slot::Brass, face, [0.3, 0.7], [0.14, 0.26]);
}

/// A cabinet of sheet steel with bolts along its door, a roof, a hooded screen, a keypad, louvres and a guard of pipe.
fn bolted(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (height, depth) = (bay.height(), bay.depth());
    let slot = [Slot::Metal, Slot::MetalDark, Slot::PaintedAccent, Slot::Metal][look];
    let body = bay
        .inset(0.02, 0.0, 0.0)
        .with_y([0.06, height * 0.93])
        .with_z([bay.low.z + 0.012, bay.high.z - 0.11]);
    builder.cuboid(slot, body);
    builder.cuboid(Slot::MetalDark, body.with_y([0.0, 0.06 + SINK]).inset(0.03, 0.0, 0.03));
    let at = |z: f64, y: f64| DVec2::new(bay.low.z + z * depth, y * height);
    let roof = [at(0.0, 0.925), at(0.92, 0.915), at(0.92, 0.94), at(0.0, 1.0)];
    builder.add(Slot::MetalDark, extrude(&roof, Axis::X, bay.x()));
    let door = body.inset(0.03, 0.03, 0.0).with_z([body.high.z - SINK, body.high.z + 0.008]);
    builder.cuboid(slot, door);
    for y in [0.03, 0.27, 0.5, 0.73, 0.97] {
        for x in [-0.47, 0.47] {
            let bolt = turned_forward(cylinder(0.011, [door.high.z - SINK, door.high.z + 0.008], 6));
            builder.add(Slot::Metal, bolt.moved(x * door.width(), door.low.y + y * door.height(), 0.0));
        }
    }
    builder.cuboid(Slot::Screen, plate(door, [0.16, 0.84], [0.66, 0.88], 0.006));
    let hood = plate(door, [0.13, 0.87], [0.885, 0.9], 0.09);
    builder.cuboid(Slot::MetalDark, hood);
    for x in [[0.125, 0.14], [0.86, 0.875]] {
        builder.cuboid(Slot::MetalDark, plate(door, x, [0.65, 0.898], 0.05));
    }
    builder.block(Slot::MetalDark, plate(door, [0.56, 0.86], [0.44, 0.62], 0.012), 0.003);
    keys(builder, Slot::Chrome, plate(door, [0.6, 0.82], [0.46, 0.6], 0.018), [3, 4]);
    builder.block(Slot::MetalDark, plate(door, [0.16, 0.46], [0.48, 0.6], 0.02), 0.004);
    builder.cuboid(Slot::Lamp, plate(door, [0.2, 0.42], [0.535, 0.55], 0.022));
    tray(builder, Slot::Metal, door.with_z([door.low.z, door.high.z]), [0.26, 0.74], [0.28, 0.38]);
    for slat in plate(door, [0.2, 0.8], [0.06, 0.2], 0.012).rows(6, 0.014) {
        builder.cuboid(Slot::MetalDark, slat);
    }
    let radius = 0.022;
    let (x, z, y) = (bay.high.x - radius * 2.4, bay.high.z - radius, height * 0.2);
    let rail = [DVec3::new(-x, 0.0, z), DVec3::new(-x, y, z), DVec3::new(x, y, z), DVec3::new(x, 0.0, z)];
    builder.add(Slot::PaintedAccent, pipe(&rail, radius, 0.09));
}

/// A flat cabinet between two legs of pipe on plates, with a screen, a reader, a slot, and a sign on top.
fn on_legs(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let height = bay.height();
    let slot = [Slot::Plastic, Slot::PaintedAccent, Slot::Appliance, Slot::Plastic][look];
    let radius = 0.03;
    let middle = bay.center().z - bay.depth() * 0.1;
    for side in [-1.0, 1.0] {
        let x = side * (bay.high.x - radius - 0.05);
        builder.add(Slot::Metal, cylinder(radius, [0.012 - SINK, height * 0.985], 10).moved(x, 0.0, middle));
        let foot = Bay::around(DVec3::new(x, 0.0, 0.0), radius * 2.0 + 0.1, 1.0, bay.depth());
        builder.block(Slot::MetalDark, foot.with_y([0.0, 0.014]), 0.004);
    }
    let cabinet = bay.inset(0.11, 0.0, 0.0).with_y([height * 0.4, height * 0.84]);
    let cabinet = cabinet.with_z([middle - bay.depth() * 0.26, middle + bay.depth() * 0.26]);
    builder.block(slot, cabinet.inset(-0.03, 0.0, 0.0), 0.016);
    let face = cabinet;
    builder.cuboid(Slot::PlasticDark, plate(face, [0.06, 0.94], [0.48, 0.94], 0.006));
    builder.cuboid(Slot::Screen, plate(face, [0.1, 0.9], [0.52, 0.9], 0.009));
    builder.cuboid(Slot::Lamp, plate(face, [0.16, 0.5], [0.74, 0.84], 0.0105));
    builder.block(Slot::PlasticDark, plate(face, [0.62, 0.92], [0.14, 0.4], 0.03), 0.006);
    keys(builder, Slot::Plastic, plate(face, [0.66, 0.88], [0.17, 0.3], 0.034), [3, 4]);
    builder.block(Slot::Metal, plate(face, [0.1, 0.46], [0.28, 0.4], 0.012), 0.004);
    builder.cuboid(Slot::PlasticDark, plate(face, [0.14, 0.42], [0.33, 0.35], 0.0135));
    let bin = plate(face, [0.1, 0.46], [0.04, 0.2], 0.06);
    builder.block(slot, bin, 0.008);
    builder.cuboid(
        Slot::PlasticDark,
        bin.inset(0.02, 0.0, 0.012).with_y([bin.high.y - 0.004, bin.high.y + 0.001]),
    );
    let sign =
        bay.with_y([height * 0.88, height]).inset(0.02, 0.0, 0.0).with_z([middle - 0.05, middle + 0.05]);
    builder.block(Slot::PaintedAccent, sign, 0.012);
    builder.cuboid(Slot::Paper, plate(sign, [0.08, 0.92], [0.22, 0.78], 0.003));
}
