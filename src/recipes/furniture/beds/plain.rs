//! Plain modern beds: soft headboards, boards on slanted legs, platforms.

use super::Bed;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Builder, SINK, cuboid};

/// Frame and headboard.
pub(super) fn frame(bed: &Bed, builder: &mut Builder) {
    let slot = if bed.form == 3 { Slot::Fabric } else { Slot::Wood };
    let foot = [0.14_f64, 0.16, 0.02, 0.06][bed.form as usize].min(bed.frame * 0.5);
    let body = bed.body();
    match bed.form {
        2 => {
            let base = body.with_y([0.0, bed.frame * 0.6]).inset(body.width() * 0.12, 0.0, 0.0);
            builder.cuboid(
                Slot::WoodDark,
                base.without(Side::Front, body.depth() * 0.1).without(Side::Back, 0.1),
            );
        }
        _ => {
            let legs = body.with_y([0.0, bed.frame - 0.02]).inset(0.02, 0.0, 0.025);
            legs_at_corners(
                builder,
                if bed.form == 3 { Slot::WoodDark } else { Slot::Wood },
                legs,
                0.055,
                LegKind::Tapered,
            );
        }
    }
    bed.rails(
        builder,
        slot,
        (bed.frame - foot).min([0.13, 0.12, 0.1, 0.3][bed.form as usize]),
        [0.03, 0.04, 0.05, 0.06][bed.form as usize],
    );
    headboard(bed, builder);
}

fn headboard(bed: &Bed, builder: &mut Builder) {
    let head = bed.head;
    let low = bed.frame * 0.6;
    match bed.form {
        0 => {
            builder.cuboid(
                Slot::Wood,
                head.slab(Side::Back, 0.02).inset(0.01, 0.0, 0.0).without(Side::Above, 0.02),
            );
            let pads = head.without(Side::Back, 0.02 - SINK).without(Side::Below, low);
            for column in pads.columns((head.width() / 0.22).round().clamp(3.0, 9.0) as u32, 0.003) {
                builder.cushion(Slot::Fabric, column, 0.018);
            }
        }
        1 => {
            for side in [Side::Left, Side::Right] {
                let post = head.inset(0.12, 0.0, 0.006).slab(side, 0.05).without(Side::Above, 0.04);
                builder.add(Slot::Wood, cuboid(post.without(Side::Front, 0.02)));
            }
            builder.block(
                Slot::Wood,
                head.without(Side::Below, bed.lying * 0.8).without(Side::Back, 0.025),
                0.012,
            );
        }
        2 => {
            let boards = head.without(Side::Below, low);
            for row in boards.rows(3, 0.022) {
                builder.block(Slot::Wood, row.without(Side::Back, 0.018), 0.006);
            }
            for column in head.inset(head.width() * 0.14, 0.0, 0.0).columns(2, head.width() * 0.62) {
                builder.cuboid(Slot::Wood, column.slab(Side::Back, 0.02).without(Side::Above, 0.012));
            }
        }
        _ => {
            builder.cushion(Slot::Fabric, head.without(Side::Below, 0.03), 0.028);
            for side in [Side::Left, Side::Right] {
                builder.cuboid(
                    Slot::WoodDark,
                    head.inset(0.04, 0.0, 0.01).slab(side, 0.04).slab(Side::Below, 0.05),
                );
            }
            let seams =
                head.without(Side::Below, bed.lying).without(Side::Above, 0.03).slab(Side::Front, 0.004);
            for row in seams.inset(0.03, 0.04, 0.0).rows(2, 0.01) {
                builder.block(Slot::Fabric, row.moved(0.0, 0.0, 0.003), 0.003);
            }
        }
    }
}
