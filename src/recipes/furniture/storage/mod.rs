//! Cupboards, chests and what else has doors or drawers.

mod cabinets;
mod case;
mod chests;
mod filing;
mod locker;

pub(super) use cabinets::{CABINET, WALL_CABINET, WARDROBE};
pub(super) use chests::{DRESSER, NIGHTSTAND, SHOE_CABINET, SIDEBOARD, TV_STAND};
pub(super) use filing::FILING_CABINET;
pub(super) use locker::LOCKER;

use super::parts::{Fronts, REVEAL};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Sampler};
use crate::recipes::{Draft, GeometrySet, Slot};

/// Metres by which handles stand out.
const REACH: f64 = 0.022;
/// Metres of a plinth's height.
const PLINTH: f64 = 0.07;
/// Metres of a moulded top or cornice.
const CORNICE: f64 = 0.07;
/// Metres by which a cornice stands over the body.
const CORNICE_OVERHANG: f64 = 0.035;
/// Metres by which a plain top stands over the body.
const OVERHANG: f64 = 0.003;
/// The usual width of a door in metres.
const DOOR: f64 = 0.5;

/// Material of the body of a piece.
fn body_slot(draft: &Draft) -> Slot {
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => [Slot::Painted, Slot::Wood, Slot::Wood, Slot::WoodLight][form],
        GeometrySet::Traditional => [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][form],
        GeometrySet::Industrial => [Slot::Metal, Slot::MetalDark, Slot::MetalDark, Slot::PaintedAccent][form],
        GeometrySet::Budget => [Slot::Laminate, Slot::Painted, Slot::WoodLight, Slot::Laminate][form],
    }
}

fn fronts(draft: &Draft) -> Fronts {
    let form = draft.form();
    let (front, handle) = match draft.set() {
        GeometrySet::Plain => (
            [Slot::Painted, Slot::Wood, Slot::Painted, Slot::WoodLight][form],
            [Slot::Metal, Slot::MetalDark, Slot::Leather, Slot::Metal][form],
        ),
        GeometrySet::Traditional => {
            (body_slot(draft), [Slot::Brass, Slot::Brass, Slot::WoodDark, Slot::MetalDark][form])
        }
        GeometrySet::Industrial => {
            ([Slot::Metal, Slot::MetalDark, Slot::MetalDark, Slot::PaintedAccent][form], Slot::MetalDark)
        }
        GeometrySet::Budget => (
            [Slot::Laminate, Slot::Painted, Slot::Laminate, Slot::PaintedAccent][form],
            [Slot::PlasticDark, Slot::Metal, Slot::Metal, Slot::WoodLight][form],
        ),
    };
    Fronts::new(draft, front, handle, REACH)
}

/// Doors side by side, hinged in pairs so that handles meet in the middle.
fn doors(builder: &mut Builder, fittings: &Fronts, bay: Bay, count: u32, rise: f64) {
    let face = bay.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0);
    for (index, column) in face.columns(count, REVEAL).into_iter().enumerate() {
        let hinge = if index.is_multiple_of(2) { Side::Left } else { Side::Right };
        let hinge = if count == 1 { Side::Right } else { hinge };
        fittings.door(builder, column, hinge, rise);
    }
}

fn drawers(builder: &mut Builder, fittings: &Fronts, bay: Bay, count: u32) {
    for row in bay.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0).rows(count, REVEAL) {
        fittings.drawer(builder, row);
    }
}

/// Two cheeks, a back and a bottom; open to the front, closed above by what stands on it.
fn open_box(builder: &mut Builder, slot: Slot, bay: Bay, board: f64) {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, board));
    }
    let inner = bay.inset(board - SINK, 0.0, 0.002);
    builder.cuboid(slot, inner.slab(Side::Below, board).moved(0.0, SINK * 2.0, 0.0));
    builder.cuboid(
        slot,
        inner
            .slab(Side::Back, board * 0.5)
            .without(Side::Below, board)
            .moved(0.0, 0.0, SINK * 2.0)
            .without(Side::Above, SINK * 2.0),
    );
}

/// Boxes of goods, as seen on racks and in lockers, from the left along the floor of a bay.
pub(super) fn fill_with_boxes(builder: &mut Builder, sampler: &mut Sampler, bay: Bay) {
    let mut left = bay.low.x + 0.01;
    for _ in 0..6 {
        let width = sampler.between(0.16, 0.36).min(bay.width() * 0.6);
        if left + width > bay.high.x {
            return;
        }
        let height = bay.height() * sampler.between(0.4, 0.85);
        let depth = bay.depth() * sampler.between(0.7, 0.95);
        let carton = bay.with_x([left, left + width]).slab(Side::Below, height).slab(Side::Front, depth);
        builder.cuboid(sampler.pick(&[Slot::Paper, Slot::Plastic, Slot::PaintedAccent]), carton);
        left += width + sampler.between(0.01, 0.12);
    }
}
