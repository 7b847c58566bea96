//! Benches without and with a back.

use super::{depth_slats, seat_height};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, leg};
use crate::recipes::kit::{Bay, Builder, SINK};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A bench of boards on two trestles, with a back where the box is high enough.
pub(in super::super) static BENCH: Recipe = Recipe::furniture("bench", [1.2, 0.4, 0.45]).every_set(bench);

fn bench(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let has_back = bay.height() > 0.65;
    let seat_top = if has_back { seat_height(bay.height()) } else { bay.height() };
    let board = 0.03_f64.min(seat_top * 0.2);
    let seat =
        bay.with_y([seat_top - board, seat_top]).without(Side::Back, if has_back { 0.04 } else { 0.0 });
    for slat in depth_slats(seat, sampler.count(2, 4), 0.012) {
        builder.cuboid(Slot::Wood, slat);
    }
    let inset = (bay.width() * 0.12).min(0.2);
    let (slot, kind) = legs_of(draft);
    trestles(builder, slot, kind, seat.with_y([0.0, seat.low.y + SINK]).inset(inset, 0.0, 0.02));
    if has_back {
        back(builder, inset, seat.y());
    }
}

/// Material and kind of a set's legs.
fn legs_of(draft: &Draft) -> (Slot, LegKind) {
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => {
            ([Slot::MetalDark, Slot::Wood, Slot::Painted, Slot::Wood][form], LegKind::Tapered)
        }
        GeometrySet::Traditional => {
            (Slot::WoodDark, [LegKind::Turned, LegKind::Baluster, LegKind::Spade, LegKind::Turned][form])
        }
        GeometrySet::Industrial => {
            (Slot::MetalDark, [LegKind::Angle, LegKind::Pipe, LegKind::Hairpin, LegKind::Square][form])
        }
        GeometrySet::Budget => {
            ([Slot::Metal, Slot::Plastic, Slot::Painted, Slot::WoodLight][form], LegKind::Square)
        }
    }
}

/// Two pairs of legs under bars, at the ends of a frame.
fn trestles(builder: &mut Builder, slot: Slot, kind: LegKind, frame: Bay) {
    for side in [Side::Left, Side::Right] {
        let trestle = frame.slab(side, 0.05);
        let bar = trestle.slab(Side::Above, 0.04).without(Side::Above, 0.001);
        builder.cuboid(slot, bar.inset(0.0015, 0.0, 0.0015));
        for end in [Side::Front, Side::Back] {
            leg(builder, slot, trestle.slab(end, 0.05), kind);
        }
    }
}

/// Two boards on posts behind a seat between two heights.
fn back(builder: &mut Builder, inset: f64, [seat_low, seat_top]: [f64; 2]) {
    let bay = builder.bay();
    for side in [Side::Left, Side::Right] {
        let post = bay.inset(inset, 0.0, 0.0).slab(side, 0.05).slab(Side::Back, 0.025);
        builder.cuboid(Slot::MetalDark, post.with_y([seat_low - 0.05, bay.high.y - 0.02]));
    }
    let boards = bay.slab(Side::Back, 0.045).without(Side::Back, 0.025 - SINK);
    for row in boards.with_y([seat_top + 0.1, bay.high.y]).rows(2, 0.03) {
        builder.cuboid(Slot::Wood, row);
    }
}
