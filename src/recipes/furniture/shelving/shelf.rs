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
    let form = draft.input.look as usize % 4;
    let post = 0.035_f64.min(bay.width() * 0.1).min(bay.depth() * 0.2);
    let (slot, kind, board) = match draft.set() {
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
    };
    let frame = frame(draft.set(), builder, slot);
    legs_at_corners(builder, slot, frame, post, kind);
    let count = (bay.height() / [0.42, 0.36, 0.48, 0.4][form]).round().clamp(2.0, 7.0) as u32;
    let thick = match draft.set() {
        GeometrySet::Plain | GeometrySet::Traditional => 0.025,
        GeometrySet::Industrial => 0.04,
        GeometrySet::Budget => 0.048,
    };
    let back = if draft.set() == GeometrySet::Budget { 0.0 } else { post * 0.22 };
    let boards = if draft.set() == GeometrySet::Budget { bay } else { frame }.inset(back, 0.0, back);
    for (index, row) in
        boards.without(Side::Above, 0.02).without(Side::Below, 0.06).rows(count, 0.0).into_iter().enumerate()
    {
        let plate = row.slab(Side::Below, thick);
        if draft.set() == GeometrySet::Budget {
            let (half, middle) = (plate.extent() / 2.0, plate.center());
            let slice = |y| Slice::new(y, half.x, half.z).softened(0.03);
            builder.add(board, loft(&Outline::Soft(1), &plate.y().map(slice)).moved(middle.x, 0.0, middle.z));
        } else {
            builder.block(board, plate, 0.003);
        }
        let side = frame.low.x - bay.low.x + post;
        let space = row.without(Side::Below, thick - SINK).inset(side, 0.0, 0.02);
        if row.height() < 0.12 {
            continue;
        }
        if (index + form).is_multiple_of(3) && draft.set() != GeometrySet::Industrial {
            fill_with_books(builder, &mut sampler, space.without(Side::Back, 0.02), 0.6, 9);
        } else {
            fill_with_boxes(builder, &mut sampler, space.without(Side::Above, 0.03));
        }
    }
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
