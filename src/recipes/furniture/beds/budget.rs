//! Cheap beds: thin boards, thin tube, drawers, pine slats.

use glam::DVec3;

use super::Bed;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Builder, SINK, pipe, sweep};

/// Frame and headboard.
pub(super) fn frame(bed: &Bed, builder: &mut Builder) {
    let head = bed.head;
    match bed.form {
        0 => laminated(bed, builder),
        1 => tube(bed, builder),
        2 => {
            panels(bed, builder, Slot::Painted);
            builder.block(Slot::Painted, head.without(Side::Back, 0.03).without(Side::Below, 0.004), 0.004);
            drawers(bed, builder);
        }
        _ => slatted(bed, builder),
    }
    if bed.form == 0 || bed.form == 2 {
        builder.cuboid(Slot::PlasticDark, head.inset(0.1, 0.0, 0.02).with_y([0.0, 0.03]));
    }
}

/// A frame of pine on posts, the head of three boards.
fn slatted(bed: &Bed, builder: &mut Builder) {
    let (body, head) = (bed.body(), bed.head);
    legs_at_corners(
        builder,
        Slot::WoodLight,
        body.with_y([0.0, bed.frame - 0.004]).inset(0.0155, 0.0, 0.018),
        0.045,
        LegKind::Square,
    );
    bed.rails(builder, Slot::WoodLight, 0.1, 0.022);
    for side in [Side::Left, Side::Right] {
        builder.block(Slot::WoodLight, head.slab(side, 0.045).inset(0.0, 0.0, 0.006), 0.004);
    }
    let boards = head.inset(0.045 - SINK, 0.0, 0.018).with_y([bed.lying * 0.7, head.high.y - 0.02]);
    for row in boards.rows(3, 0.06) {
        builder.block(Slot::WoodLight, row, 0.004);
    }
}

/// Laminated panels, the head with a shelf.
fn laminated(bed: &Bed, builder: &mut Builder) {
    let head = bed.head;
    panels(bed, builder, Slot::Laminate);
    let board = head.without(Side::Back, 0.032).without(Side::Front, 0.01);
    builder.block(
        Slot::Laminate,
        head.slab(Side::Back, 0.018)
            .without(Side::Below, 0.002)
            .without(Side::Above, 0.02 - SINK)
            .inset(0.001, 0.0, 0.0),
        0.003,
    );
    let shelf = head.with_y([head.high.y - 0.02, head.high.y]);
    builder.block(Slot::Laminate, shelf, 0.003);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::Laminate,
            board
                .slab(side, 0.018)
                .inset(0.002, 0.0, 0.0)
                .without(Side::Above, 0.02 - SINK)
                .without(Side::Below, bed.frame),
        );
    }
}

/// Thin boards down to low feet.
fn panels(bed: &Bed, builder: &mut Builder, slot: Slot) {
    bed.rails(builder, slot, bed.frame - 0.03, 0.018);
    let feet = bed.body().with_y([0.0, 0.04]).inset(0.04, 0.0, 0.04);
    legs_at_corners(builder, Slot::PlasticDark, feet, 0.05, LegKind::Square);
}

fn tube(bed: &Bed, builder: &mut Builder) {
    let (head, radius) = (bed.head, 0.0125);
    let body = bed.body();
    let legs = body.with_y([0.0, bed.frame - 0.004]).inset(0.016, 0.0, 0.02);
    legs_at_corners(builder, Slot::Painted, legs, 0.028, LegKind::Round);
    bed.rails(builder, Slot::Painted, 0.035, 0.025);
    let (x, z) = (head.high.x - radius, head.center().z);
    let at = |x: f64, y: f64| DVec3::new(x, y, z);
    let high = head.high.y - radius;
    builder.add(Slot::Painted, pipe(&[at(x, 0.0), at(x, high), at(-x, high), at(-x, 0.0)], radius, 0.05));
    for y in [bed.lying * 0.9, (bed.lying * 0.9 + high) / 2.0] {
        builder.add(Slot::Painted, sweep(&[at(-x, y), at(x, y)], radius * 0.7, 6));
    }
    for column in head.inset(head.width() * 0.2, 0.0, 0.0).columns(3, head.width() * 0.18) {
        builder.add(
            Slot::Painted,
            sweep(&[at(column.center().x, bed.lying * 0.9), at(column.center().x, high)], radius * 0.6, 6),
        );
    }
    for z in [head.low.z, head.high.z - 0.012] {
        for x in [-x, x] {
            builder.add(
                Slot::PlasticDark,
                sweep(&[DVec3::new(x, 0.1, z), DVec3::new(x, 0.1, z + 0.012)], 0.011, 6),
            );
        }
    }
}

/// Fronts of two drawers in either side.
fn drawers(bed: &Bed, builder: &mut Builder) {
    let side = bed.body().with_y([0.05, bed.frame - 0.03]).without(Side::Front, 0.1).without(Side::Back, 0.1);
    for end in [Side::Left, Side::Right] {
        let face = side.slab(end, 0.0145);
        let count = 2.0;
        let length = face.depth() / count - 0.01;
        for index in 0..2 {
            let z = face.low.z + f64::from(index) * (length + 0.02);
            builder.block(Slot::Painted, face.with_z([z, z + length]).inset(0.004, 0.0, 0.0), 0.003);
            let grip = face
                .with_z([z + length * 0.4, z + length * 0.6])
                .with_y([face.high.y - 0.03, face.high.y - 0.015]);
            builder.cuboid(Slot::MetalDark, grip.inset(0.001, 0.0, 0.0));
        }
    }
}
