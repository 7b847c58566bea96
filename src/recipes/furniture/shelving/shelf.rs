//! Open racks.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, fill_with_books, legs_at_corners, slab_top};
use crate::recipes::furniture::storage::fill_with_boxes;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a moulded board on top, and of a steel plate under a post.
const CROWN: f64 = 0.03;
const FOOT: f64 = 0.08;

/// An open rack with boxes: slim, of wood under a moulded board, of steel with a cross, or of thick
/// moulded trays on posts.
pub(in super::super) static SHELF: Recipe =
    Recipe::furniture("shelf", [0.9, 0.4, 1.8]).symbol(Symbol::Shelf).every_set(shelf);

fn shelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let (set, form) = (draft.set(), draft.form());
    let post = 0.035_f64.min(bay.width() * 0.1).min(bay.depth() * 0.2);
    let (slot, kind, board) = posts_and_boards(draft);
    let frame = frame(set, builder, slot);
    legs_at_corners(builder, slot, frame, post, kind);
    let count = (bay.height() / [0.42, 0.36, 0.48, 0.4][form]).round().clamp(2.0, 7.0) as u32;
    let thick = [0.048, 0.04, 0.025, 0.025][set as usize];
    let boards = if set == GeometrySet::Budget { bay } else { frame.inset(post * 0.22, 0.0, post * 0.22) };
    let rows = boards.without(Side::Above, 0.02).without(Side::Below, 0.06).rows(count, 0.0);
    for (index, row) in rows.into_iter().enumerate() {
        let plate = row.slab(Side::Below, thick);
        if set == GeometrySet::Budget {
            tray(builder, board, plate);
        } else {
            builder.block(board, plate, 0.003);
        }
        let side = frame.low.x - bay.low.x + post;
        let space = row.without(Side::Below, thick - SINK).inset(side, 0.0, 0.02);
        if row.height() < 0.12 {
            continue;
        }
        if (index + form).is_multiple_of(3) && set != GeometrySet::Industrial {
            fill_with_books(builder, &mut sampler, space.without(Side::Back, 0.02), 0.6, 9);
        } else {
            fill_with_boxes(builder, &mut sampler, space.without(Side::Above, 0.03));
        }
    }
}

/// Material and kind of the posts, and material of the boards.
fn posts_and_boards(draft: &Draft) -> (Slot, LegKind, Slot) {
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => (
            [Slot::Metal, Slot::Painted, Slot::Wood, Slot::MetalDark][form],
            LegKind::Square,
            [Slot::Metal, Slot::Painted, Slot::Wood, Slot::Wood][form],
        ),
        GeometrySet::Traditional => (
            [Slot::Wood, Slot::WoodDark][form % 2],
            [LegKind::Round, LegKind::Square][form / 2],
            [Slot::Wood, Slot::WoodDark][form % 2],
        ),
        GeometrySet::Industrial => (
            Slot::MetalDark,
            [LegKind::Angle, LegKind::Pipe, LegKind::Angle, LegKind::Square][form],
            [Slot::Wood, Slot::Wood, Slot::Metal, Slot::MetalDark][form],
        ),
        GeometrySet::Budget => (
            [Slot::Plastic, Slot::Metal, Slot::WoodLight, Slot::PlasticDark][form],
            [LegKind::Round, LegKind::Round, LegKind::Square, LegKind::Round][form],
            [Slot::Plastic, Slot::Laminate, Slot::WoodLight, Slot::PlasticDark][form],
        ),
    }
}

/// A moulded board with round corners.
fn tray(builder: &mut Builder, slot: Slot, plate: Bay) {
    let (half, middle) = (plate.extent() / 2.0, plate.center());
    let slice = |y| Slice::new(y, half.x, half.z).softened(0.03);
    builder.add(slot, loft(&Outline::Soft(1), &plate.y().map(slice)).moved(middle.x, 0.0, middle.z));
}

/// What a set adds to posts and boards: a moulded board on top, a cross behind and plates under the feet. Gives where the
/// posts stand: within them, or in from the edges of moulded trays.
fn frame(set: GeometrySet, builder: &mut Builder, slot: Slot) -> Bay {
    let bay = builder.bay();
    match set {
        GeometrySet::Plain => bay,
        GeometrySet::Traditional => {
            slab_top(builder, slot, bay.slab(Side::Above, CROWN), true);
            bay.inset(0.014, 0.0, 0.014).without(Side::Above, CROWN - SINK)
        }
        GeometrySet::Industrial => {
            let frame = bay.inset(FOOT * 0.25, 0.0, FOOT * 0.25);
            let feet = bay.slab(Side::Below, 0.006);
            for side in [Side::Left, Side::Right] {
                for end in [Side::Back, Side::Front] {
                    builder.cuboid(slot, feet.slab(side, FOOT).slab(end, FOOT));
                }
            }
            let x = frame.high.x - 0.012;
            for (turn, back) in [(1.0, 0.006), (-1.0, 0.014)] {
                let at = |x: f64, share: f64| DVec3::new(x * turn, share * bay.height(), frame.low.z + back);
                builder.add(Slot::Metal, sweep(&[at(-x, 0.1), at(x, 0.9)], 0.005, 4));
            }
            frame.without(Side::Below, 0.006 - SINK)
        }
        GeometrySet::Budget => bay.inset(0.03, 0.0, 0.03),
    }
}
