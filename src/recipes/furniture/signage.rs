//! Signs on walls: 0.15 to 0.4 m tall, pictograms of 0.1 m and more (ISO 7001).

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, loft};
use crate::recipes::{Recipe, Slot};

/// A sign with a pictogram and lines of text: a plate; an oval of enamel in a moulding; an arrow of bolted sheet; a sheet of paper
/// in a holder.
pub(super) static SIGNAGE: Recipe = Recipe::accessory("signage", [0.6, 0.03, 0.2])
    .plain(|_, builder| plate(builder))
    .traditional(|_, builder| enamel(builder))
    .industrial(|_, builder| arrow(builder))
    .budget(|_, builder| holder(builder));

/// A person, in a field of a surface.
fn person(builder: &mut Builder, slot: Slot, field: Bay) {
    let middle = field.center();
    let radius = field.width().min(field.height()) / 2.0;
    let head = turned_forward(cylinder(radius * 0.28, [0.0, field.depth()], 10));
    builder.add(slot, head.moved(middle.x, middle.y + radius * 0.7, field.low.z));
    let body = middle - DVec3::Y * radius * 0.35;
    builder.cuboid(slot, Bay::around(body, radius * 0.7, radius * 1.2, field.depth()));
}

/// Two lines of words.
fn text(builder: &mut Builder, slot: Slot, field: Bay) {
    for (index, line) in field.rows(2, field.height() * 0.25).into_iter().enumerate() {
        let words = if index == 0 { line.slab(Side::Left, line.width() * 0.6) } else { line };
        for word in words.columns(3 - u32::from(index == 0), words.width() * 0.05) {
            builder.cuboid(slot, word.inset(0.0, word.height() * 0.15, 0.0));
        }
    }
}

fn plate(builder: &mut Builder) {
    let bay = builder.bay();
    let plate = bay.without(Side::Front, bay.depth() * 0.2);
    builder.block(Slot::PaintedAccent, plate, bay.depth() * 0.15);
    let z = [plate.high.z - SINK, bay.high.z];
    let letters = bay.inset(bay.width() * 0.06, bay.height() * 0.2, 0.0).with_z(z);
    let sign = letters.slab(Side::Left, letters.height().min(letters.width() * 0.3));
    person(builder, Slot::Paper, sign);
    text(builder, Slot::Paper, letters.without(Side::Left, sign.width() + bay.width() * 0.06));
}

/// A bowed oval in a rim of brass.
fn enamel(builder: &mut Builder) {
    let bay = builder.bay();
    let (half, depth) = (bay.extent() / 2.0, bay.depth());
    let at = |share: f64, z: f64| Slice::new(z * depth, half.x * share, half.y * share);
    let oval =
        |slices: &[Slice]| turned_forward(loft(&Outline::Round(16), slices)).moved(0.0, half.y, bay.low.z);
    builder.add(Slot::Brass, oval(&[at(1.0, 0.0), at(1.0, 0.4), at(0.95, 0.7), at(0.9, 0.5)]));
    builder.add(Slot::Ceramic, oval(&[at(0.91, 0.1), at(0.91, 0.56), at(0.6, 0.74)]));
    let letters = bay
        .inset(half.x * 0.56, half.y * 0.62, 0.0)
        .with_z([bay.low.z + depth * 0.7, bay.low.z + depth * 0.86]);
    text(builder, Slot::PlasticDark, letters.slab(Side::Above, letters.height()));
}

/// A plate cut to an arrow, on two rails, with bolts.
fn arrow(builder: &mut Builder) {
    let bay = builder.bay();
    let (x, y, depth) = (bay.x(), bay.y(), bay.depth());
    let tip = (bay.height() * 0.5).min(bay.width() * 0.4);
    let outline = [
        (x[0], y[0] + bay.height() * 0.12),
        (x[1] - tip, y[0] + bay.height() * 0.12),
        (x[1] - tip, y[0]),
        (x[1], bay.center().y),
        (x[1] - tip, y[1]),
        (x[1] - tip, y[1] - bay.height() * 0.12),
        (x[0], y[1] - bay.height() * 0.12),
    ];
    let z = [bay.low.z + depth * 0.5, bay.low.z + depth * 0.7];
    builder.add(Slot::MetalDark, extrude(&outline.map(DVec2::from), Axis::Z, z));
    for height in [0.3, 0.66] {
        let rail = bay.inset(bay.width() * 0.04, 0.0, 0.0).without(Side::Right, tip * 1.1);
        let rail = rail.with_y([bay.height() * height, bay.height() * (height + 0.05)]);
        builder.cuboid(Slot::Metal, rail.with_z([bay.low.z, z[0] + SINK]));
    }
    let face = bay.with_z([z[1] - SINK, bay.low.z + depth * 0.82]).without(Side::Right, tip * 0.9);
    let face = face.inset(bay.width() * 0.05, bay.height() * 0.28, 0.0);
    let sign = face.slab(Side::Left, face.height().min(face.width() * 0.3));
    person(builder, Slot::Brass, sign);
    text(builder, Slot::Brass, face.without(Side::Left, sign.width() + bay.width() * 0.05));
    for (share, height) in [(0.03, 0.2), (0.03, 0.8), (0.6, 0.2), (0.6, 0.8)] {
        let bolt = turned_forward(cylinder(depth * 0.28, [z[1] - SINK - bay.low.z, depth], 6));
        builder.add(Slot::Metal, bolt.moved(x[0] + share * bay.width(), bay.height() * height, bay.low.z));
    }
}

/// A sheet behind a pane between two clips.
fn holder(builder: &mut Builder) {
    let bay = builder.bay();
    let depth = bay.depth();
    let layer = |low: f64, high: f64| [bay.low.z + depth * low, bay.low.z + depth * high];
    let clip = bay.height() * 0.12;
    builder.cuboid(
        Slot::Plastic,
        bay.with_z(layer(0.05, 0.3)).inset(bay.width() * 0.02, bay.height() * 0.02, 0.0),
    );
    let sheet = bay.inset(bay.width() * 0.05, bay.height() * 0.06, 0.0).with_z(layer(0.3, 0.36));
    builder.cuboid(Slot::Paper, sheet.with_z([sheet.low.z - SINK, sheet.high.z]));
    for side in [Side::Above, Side::Below] {
        builder.block(Slot::PlasticDark, bay.slab(side, clip), depth * 0.2);
    }
    let field = sheet.inset(sheet.width() * 0.06, clip, 0.0).with_z(layer(0.35, 0.4));
    let head = field.slab(Side::Above, field.height() * 0.3);
    builder.cuboid(Slot::Book, head);
    let rest = field.without(Side::Above, field.height() * 0.4);
    let sign = rest.slab(Side::Left, rest.width() * 0.26);
    person(builder, Slot::PlasticDark, sign);
    text(
        builder,
        Slot::PlasticDark,
        rest.without(Side::Left, rest.width() * 0.34).inset(0.0, rest.height() * 0.08, 0.0),
    );
    for x in [-0.4, 0.4] {
        let hole = turned_forward(cylinder(depth * 0.22, [depth * 0.9, depth * 1.0], 6));
        builder
            .add(Slot::Metal, hole.moved(x * bay.width(), bay.high.y - clip / 2.0, bay.low.z + depth * 0.06));
    }
}
