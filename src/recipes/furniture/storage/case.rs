//! Plinths and feet of tall and wide pieces, and the boards on top of them.

use super::{CORNICE, CORNICE_OVERHANG, PLINTH, REACH};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, cornice, legs_at_corners, slab_top};
use crate::recipes::kit::{Bay, Builder, SINK};
use crate::recipes::{Draft, GeometrySet, Slot};

/// The box of a tall or wide piece: what it stands on and what crowns it, by set. Gives the bay of the body from back
/// wall to handle tips.
pub(super) fn case(draft: &Draft, builder: &mut Builder, slot: Slot) -> Bay {
    let bay = builder.bay();
    let plinth = PLINTH.min(bay.height() * 0.15);
    let form = draft.input.look % 4;
    match (draft.set(), form) {
        (GeometrySet::Traditional, _) => return crowned_case(draft, builder, slot, plinth),
        (GeometrySet::Industrial, 1 | 2) => return framed_case(builder, bay, plinth),
        (GeometrySet::Plain, 2) | (GeometrySet::Industrial, _) | (GeometrySet::Budget, 1) => {
            let (legs, kind) = match draft.set() {
                GeometrySet::Plain => (Slot::Wood, LegKind::Tapered),
                GeometrySet::Industrial => (Slot::MetalDark, LegKind::Square),
                _ => (Slot::PlasticDark, LegKind::Round),
            };
            let feet = bay.slab(Side::Below, plinth + SINK).inset(0.03, 0.0, 0.0);
            let feet = feet.without(Side::Front, 0.06).without(Side::Back, 0.01);
            legs_at_corners(builder, legs, feet, 0.04, kind);
        }
        _ => {
            let kick = bay.slab(Side::Below, plinth + SINK).inset(0.004, 0.0, 0.0);
            builder.cuboid(slot, kick.without(Side::Front, 0.06).without(Side::Back, 0.002));
        }
    }
    let body = bay.without(Side::Below, plinth);
    if draft.set() == GeometrySet::Industrial || form.is_multiple_of(2) {
        return body;
    }
    // Sides and top stand as boards around the fronts.
    let board = 0.018;
    for side in [Side::Left, Side::Right] {
        let end = body.slab(side, board).without(Side::Front, REACH * 0.5).without(Side::Back, 0.001);
        builder.block(slot, end.without(Side::Above, board - SINK), 0.003);
    }
    builder.block(slot, body.slab(Side::Above, board).without(Side::Front, REACH * 0.4), 0.003);
    body.inset(board - SINK, 0.0, 0.0).without(Side::Above, board - SINK).without(Side::Back, 0.003)
}

/// A cornice above and a plinth, or feet, below.
fn crowned_case(draft: &Draft, builder: &mut Builder, slot: Slot, plinth: f64) -> Bay {
    let bay = builder.bay();
    let crown = CORNICE.min(bay.height() * 0.12);
    let overhang = CORNICE_OVERHANG.min(bay.width() * 0.05).min(bay.depth() * 0.1);
    cornice(builder, slot, bay.slab(Side::Above, crown), overhang);
    let body = bay.inset(overhang, 0.0, 0.0).without(Side::Front, overhang * 0.6).without(Side::Back, 0.002);
    let base =
        bay.slab(Side::Below, plinth).inset(overhang * 0.4, 0.0, 0.0).without(Side::Front, overhang * 0.3);
    if draft.input.look.is_multiple_of(2) {
        slab_top(builder, slot, base, true);
    } else {
        slab_top(builder, slot, base.slab(Side::Above, plinth * 0.35), true);
        legs_at_corners(
            builder,
            slot,
            base.inset(0.01, 0.0, 0.01).without(Side::Above, plinth * 0.3),
            0.07,
            LegKind::Spade,
        );
    }
    body.without(Side::Above, crown - SINK).without(Side::Below, plinth - SINK)
}

/// Angles of steel at the corners, under and over the body.
fn framed_case(builder: &mut Builder, bay: Bay, plinth: f64) -> Bay {
    let iron = 0.032_f64.min(bay.width() * 0.08);
    let frame = bay.without(Side::Front, REACH * 0.6);
    legs_at_corners(builder, Slot::MetalDark, frame, iron, LegKind::Angle);
    let board = 0.025;
    builder.block(
        Slot::Wood,
        frame.inset(0.006, 0.0, 0.006).slab(Side::Above, board).moved(0.0, -0.003, 0.0),
        0.004,
    );
    let body = bay.inset(iron * 0.25, 0.0, 0.0).without(Side::Back, iron * 0.25);
    body.without(Side::Below, plinth).without(Side::Above, board + 0.002)
}
