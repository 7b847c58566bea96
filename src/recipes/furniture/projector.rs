//! Projectors; their lenses look to the front.

use glam::DVec3;

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft};
use crate::recipes::{Recipe, Slot};

/// A projector: a flat box; one for slides with its round tray; a case of sheet with a large lens and grips; a rounded one.
pub(super) static PROJECTOR: Recipe = Recipe::accessory("projector", [0.35, 0.3, 0.12])
    .plain(|_, builder| flat(builder))
    .traditional(|_, builder| for_slides(builder))
    .industrial(|_, builder| large(builder))
    .budget(|_, builder| rounded(builder));

/// A lens of a radius around a point of the front, standing `reach` metres out of it.
fn lens(builder: &mut Builder, slot: Slot, at: DVec3, radius: f64, reach: f64) {
    let ring = [(radius, -0.004), (radius, reach), (radius * 0.8, reach), (radius * 0.6, reach * 0.5)];
    builder.add(slot, turned_forward(lathe(&ring, 8)).moved(at.x, at.y, at.z));
    let glass = turned_forward(cylinder(radius * 0.7, [0.001, reach * 0.66], 8));
    builder.add(Slot::Screen, glass.moved(at.x, at.y, at.z));
}

/// Slots for air in a field of a front.
fn vents(builder: &mut Builder, field: Bay, count: u32, surface: f64) {
    for strip in field.rows(count, field.height() / f64::from(count * 2)) {
        builder.cuboid(Slot::PlasticDark, strip.with_z([surface - 0.002, surface + 0.001]));
    }
}

/// Two small bars under a body.
fn feet(builder: &mut Builder, body: Bay) {
    let feet = body.with_y([0.0, body.low.y + SINK]).inset(0.02, 0.0, 0.02);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::Rubber, feet.slab(side, 0.016));
    }
}

fn flat(builder: &mut Builder) {
    let bay = builder.bay();
    let body = bay.without(Side::Front, bay.depth() * 0.06).without(Side::Below, bay.height() * 0.06);
    builder.block(Slot::Plastic, body, bay.height() * 0.1);
    let at = DVec3::new(bay.width() * 0.22, body.center().y, bay.high.z - bay.depth() * 0.09);
    lens(builder, Slot::PlasticDark, at, bay.height() * 0.28, bay.depth() * 0.09);
    let field = body.slab(Side::Left, bay.width() * 0.4).inset(bay.width() * 0.05, bay.height() * 0.2, 0.0);
    vents(builder, field, 4, body.high.z);
    feet(builder, body);
}

/// A low body under a ring of slides, with a tube for the lens.
fn for_slides(builder: &mut Builder) {
    let bay = builder.bay();
    let high = bay.height();
    let body = bay.with_y([high * 0.05, high * 0.52]).without(Side::Front, bay.depth() * 0.12);
    builder.block(Slot::PlasticDark, body, high * 0.06);
    builder.cuboid(
        Slot::Metal,
        body.with_y([high * 0.34, high * 0.42])
            .slab(Side::Front, 0.003)
            .inset(0.012, 0.0, 0.0)
            .moved(0.0, 0.0, 0.002),
    );
    let radius = (bay.width().min(bay.depth()) * 0.46).min(bay.width() / 2.0 - 0.002);
    let middle = DVec3::new(bay.low.x + radius + 0.01, 0.0, bay.low.z + radius + 0.004);
    let tray = [(1.0, 0.5), (1.0, 0.9), (0.7, 0.7), (0.35, 0.7), (0.3, 1.0), (0.0, 1.0)];
    let tray = lathe(&tray.map(|(share, y)| (share * radius, y * high)), 10);
    builder.add(Slot::PlasticDark, tray.moved(middle.x, 0.0, middle.z));
    for slide in 0..2 {
        let turn = 0.5 + 1.5 * f64::from(slide);
        let mount = Bay::around(DVec3::new(radius * 0.86, high * 0.93, 0.0), radius * 0.2, high * 0.1, 0.006);
        let mount = crate::recipes::kit::cuboid(mount).turned_y(turn);
        builder.add(Slot::Linen, mount.moved(middle.x, 0.0, middle.z));
    }
    let at = DVec3::new(bay.width() * 0.26, high * 0.3, body.high.z - 0.004);
    lens(builder, Slot::Metal, at, high * 0.2, bay.high.z - at.z);
    feet(builder, body);
}

/// A case of sheet with a broad lens in its middle, fins at its sides and grips to lift it by.
fn large(builder: &mut Builder) {
    let bay = builder.bay();
    let high = bay.height();
    let body =
        bay.without(Side::Front, bay.depth() * 0.1).without(Side::Below, high * 0.05).inset(0.022, 0.0, 0.0);
    builder.block(Slot::MetalDark, body.without(Side::Above, high * 0.03), 0.004);
    builder.cuboid(Slot::Metal, body.slab(Side::Above, high * 0.03 + SINK).inset(0.02, 0.0, 0.02));
    let at = DVec3::new(0.0, body.center().y, body.high.z);
    lens(builder, Slot::Metal, at, high * 0.36, bay.depth() * 0.1);
    for side in [Side::Left, Side::Right] {
        let fins =
            bay.slab(side, 0.022 + SINK).with_y([high * 0.2, high * 0.8]).inset(0.0, 0.0, bay.depth() * 0.12);
        builder.cuboid(Slot::Metal, fins.slab(Side::Above, 0.014));
        builder.cuboid(Slot::Metal, fins.slab(Side::Below, 0.014));
        let post = fins.inset(0.004, 0.013, 0.0);
        builder.cuboid(Slot::MetalDark, post.slab(Side::Front, 0.016).inset(0.0, 0.0, 0.0008));
        builder.cuboid(Slot::MetalDark, post.slab(Side::Back, 0.016).inset(0.0, 0.0, 0.0008));
    }
    let field = body.slab(Side::Left, body.width() * 0.2).inset(0.012, high * 0.14, 0.0);
    vents(builder, field, 3, body.high.z);
    feet(builder, body);
}

/// A body like a pebble with the lens at its left.
fn rounded(builder: &mut Builder) {
    let bay = builder.bay();
    let (half, high) = (bay.extent() / 2.0, bay.height());
    let slice = |y: f64, back: f64| {
        Slice::new(y * high, half.x - back, half.z - 0.012 - back).softened(0.07).at(0.0, -0.012)
    };
    let body =
        [slice(0.06, 0.03), slice(0.28, 0.004), slice(0.55, 0.0), slice(0.86, 0.012), slice(1.0, 0.06)];
    builder.add(Slot::Plastic, loft(&Outline::Soft(2), &body).smooth(60.0));
    let at = DVec3::new(-bay.width() * 0.2, high * 0.5, bay.high.z - 0.034);
    lens(builder, Slot::PaintedAccent, at, high * 0.3, 0.034);
    let keys = Bay::around(DVec3::new(0.0, high + 0.0002, -0.04), 0.09, 0.003, 0.02);
    builder.cuboid(Slot::PaintedAccent, keys.with_y([high - 0.002, high + 0.0015]));
    let body = bay.with_y([high * 0.07, high]).inset(0.05, 0.0, 0.05);
    feet(builder, body);
}
