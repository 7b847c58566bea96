//! Tables and desks: 0.72 to 0.75 m high (EN 527, DIN 68890), tops 18 to 40 mm thick.

mod desk;
mod lab_bench;
mod lectern;
mod low;
mod pedestal;

use glam::{DVec2, DVec3};

pub(super) use desk::DESK;
pub(super) use lab_bench::LAB_BENCH;
pub(super) use lectern::LECTERN;
pub(super) use low::{COFFEE_TABLE, CONSOLE_TABLE};
pub(super) use pedestal::ROUND_TABLE;

use super::parts::{LegKind, legs_at_corners, slab_top, slanted_leg};
use super::seating::depth_slats;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, extrude, loft};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a table top.
const TOP: f64 = 0.035;
/// Metres from the corner of a top to where its leg ends: the shapes in the catalogue are cut for it, and chairs stand
/// beside them.
const LEG: f64 = 0.05;
/// Metres by which a top stands over what carries it, so that they share no plane.
const OVERHANG: f64 = 0.004;

/// Thickness of a top in a box of this height.
fn top_of(bay: Bay) -> f64 {
    TOP.min(bay.height() * 0.25)
}

/// A top: a chamfered board, a moulded one, planks, or a thin board whose core shows at its edge.
fn top_board(draft: &Draft, builder: &mut Builder, bay: Bay) {
    match draft.set() {
        GeometrySet::Plain => slab_top(builder, Slot::Wood, bay, false),
        GeometrySet::Traditional => slab_top(builder, Slot::Wood, bay, true),
        GeometrySet::Industrial => {
            let count = (bay.depth() / 0.2).round().clamp(2.0, 7.0) as u32;
            for (index, plank) in depth_slats(bay, count, 0.002).into_iter().enumerate() {
                builder.block(Slot::Wood, plank.inset([0.0, 0.0015][index % 2], 0.0, 0.0), 0.004);
            }
        }
        GeometrySet::Budget => {
            let face = (bay.height() * 0.2).min(0.004);
            builder.cuboid(Slot::WoodLight, bay.inset(0.001, 0.0, 0.001).without(Side::Above, face - SINK));
            builder.cuboid(Slot::Laminate, bay.slab(Side::Above, face));
        }
    }
}

/// A board whose upper edge falls away in a step, so that legs stand near its corners.
fn thumb_moulded(builder: &mut Builder, bay: Bay) {
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let slice =
        |rise: f64, back: f64| Slice::new(bay.low.y + rise * bay.height(), half.x - back, half.z - back);
    let slices =
        [slice(0.0, 0.003), slice(0.12, 0.0), slice(0.48, 0.0), slice(0.56, 0.004), slice(1.0, 0.012)];
    builder.add(Slot::Wood, loft(&Outline::Square, &slices).moved(center.x, 0.0, center.z));
}

/// Four legs at the corners under a top.
pub(super) static TABLE: Recipe = Recipe::furniture("table", [1.4, 0.8, 0.74]).every_set(table);

fn table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.form();
    let top = match (draft.set(), form) {
        (GeometrySet::Budget, 0 | 2) => 0.022,
        (GeometrySet::Plain, 2) => 0.026,
        (GeometrySet::Industrial, 2) => 0.045,
        _ => TOP,
    };
    let top = top.min(top_of(bay) * 1.3);
    if draft.is_traditional() {
        thumb_moulded(builder, bay.slab(Side::Above, top));
    } else {
        top_board(draft, builder, bay.slab(Side::Above, top));
    }
    let under = bay.without(Side::Above, top - SINK).inset(OVERHANG, 0.0, OVERHANG);
    let leg = LEG - OVERHANG;
    let tall = (bay.height() * 0.12).min(0.08);
    match (draft.set(), form) {
        (GeometrySet::Plain, 2) => slanted_legs(builder, under),
        (GeometrySet::Industrial, 3) => gussets(builder, under, leg),
        (GeometrySet::Industrial, 1 | 2) => {
            let (kind, wide) = [(LegKind::Pipe, leg), (LegKind::Hairpin, 0.06)][form - 1];
            corner_plates(builder, under, kind, wide);
        }
        (set, form) => {
            let (slot, kind) = legs_of(set, form);
            legs_at_corners(builder, slot, under, leg, kind);
            let height = if set == GeometrySet::Budget { tall * 0.55 } else { tall };
            if set == GeometrySet::Traditional && form % 2 == 1 {
                shaped_apron(builder, under, leg, tall);
            } else {
                apron(builder, slot, under, leg, height);
            }
        }
    }
}

/// Material and kind of legs that stand under an apron.
fn legs_of(set: GeometrySet, form: usize) -> (Slot, LegKind) {
    match set {
        GeometrySet::Plain => [
            (Slot::Wood, LegKind::Tapered),
            (Slot::Wood, LegKind::Square),
            (Slot::Wood, LegKind::Round),
            (Slot::Painted, LegKind::Tapered),
        ][form],
        GeometrySet::Traditional => {
            (Slot::Wood, [LegKind::Turned, LegKind::Baluster, LegKind::Spade, LegKind::Turned][form])
        }
        GeometrySet::Industrial => (Slot::MetalDark, LegKind::Angle),
        GeometrySet::Budget => [
            (Slot::Chrome, LegKind::Pipe),
            (Slot::Laminate, LegKind::Square),
            (Slot::MetalDark, LegKind::Square),
            (Slot::Plastic, LegKind::Tapered),
        ][form],
    }
}

/// Round legs that lean outwards within the corners.
fn slanted_legs(builder: &mut Builder, under: Bay) {
    for (z, inwards) in [(under.low.z, 1.0), (under.high.z, -1.0)] {
        // At the height of seats they end where upright ones do.
        let at = |y: f64, off: f64| DVec3::new(under.high.x - off, y, z + inwards * off);
        let ends = [at(0.0, 0.014), at(under.high.y, 0.037)];
        builder.add_pair(Slot::Wood, slanted_leg(ends, 0.021, &[(0.6, 0.0), (1.0, 0.85), (0.95, 1.0)], 10));
    }
    let rail = under.slab(Side::Above, 0.03).without(Side::Above, SINK * 3.0).inset(0.06, 0.0, 0.06);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::Wood, rail.slab(side, 0.02).inset(0.012, 0.0, 0.0));
    }
}

/// Steel tube with gussets under the top.
fn gussets(builder: &mut Builder, under: Bay, leg: f64) {
    legs_at_corners(builder, Slot::MetalDark, under, leg, LegKind::Square);
    let band = under.slab(Side::Above, 0.04).without(Side::Above, 2.0 * SINK).inset(0.003, 0.0, 0.003);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::MetalDark, band.slab(side, 0.03).inset(leg - 0.004, 0.0, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::MetalDark, band.slab(side, 0.03).inset(0.0, 0.0, leg - 0.004));
    }
    let (x, y) = (under.high.x - leg + SINK, band.low.y + SINK);
    let reach = 0.035;
    let plate = [(x, y), (x - reach, y), (x, y - reach * 1.6)].map(DVec2::from);
    for z in [under.low.z + 0.012, under.high.z - 0.016] {
        builder.add_pair(Slot::Metal, extrude(&plate, Axis::Z, [z, z + 0.004]));
    }
}

/// Legs under plates with bolts, no apron.
fn corner_plates(builder: &mut Builder, under: Bay, kind: LegKind, wide: f64) {
    let plate = (under.high.y * 0.1).min(0.006);
    legs_at_corners(builder, Slot::MetalDark, under.without(Side::Above, plate), wide, kind);
    let top = under.slab(Side::Above, plate + SINK);
    for x in [Side::Left, Side::Right] {
        for z in [Side::Front, Side::Back] {
            builder.cuboid(Slot::MetalDark, top.inset(0.002, 0.0, 0.002).slab(x, 0.085).slab(z, 0.085));
        }
    }
}

/// Aprons whose lower edge swings up between the legs.
fn shaped_apron(builder: &mut Builder, under: Bay, leg: f64, height: f64) {
    let profile = |half: f64| {
        let high = under.high.y - 2.0 * SINK;
        // Deep beside the legs only: knees need the rest.
        let low = height * 0.42;
        let swing = [
            (half, height),
            (half - 0.026, height * 0.9),
            (half * 0.66, low),
            (half * 0.3, low * 0.8),
            (half * 0.1, low * 0.95),
        ];
        let right = swing.iter().map(|&(x, y)| DVec2::new(x, high - y));
        let left = swing.iter().rev().map(|&(x, y)| DVec2::new(-x, high - y));
        let mut points = vec![DVec2::new(half, high)];
        points.extend(right.chain(left));
        points.push(DVec2::new(-half, high));
        points
    };
    let (half_x, half_z) = (under.width() / 2.0 - leg + 0.002, under.depth() / 2.0 - leg + 0.002);
    let inset = leg * 0.25;
    for (from, to) in [
        (under.low.z + inset, under.low.z + inset + 0.018),
        (under.high.z - inset - 0.018, under.high.z - inset),
    ] {
        builder.add(Slot::Wood, extrude(&profile(half_x), Axis::Z, [from, to]));
    }
    builder.add_pair(
        Slot::Wood,
        extrude(&profile(half_z), Axis::X, [under.high.x - inset - 0.018, under.high.x - inset]),
    );
}

/// Four boards under a top, between legs of a thickness.
fn apron(builder: &mut Builder, slot: Slot, under: Bay, leg: f64, height: f64) {
    let board = 0.018;
    let band =
        under.without(Side::Above, SINK * 2.0).slab(Side::Above, height).inset(leg * 0.25, 0.0, leg * 0.25);
    let reach = leg * 0.75 - SINK;
    for side in [Side::Front, Side::Back] {
        builder.cuboid(slot, band.slab(side, board).inset(reach, 0.0, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, band.slab(side, board).inset(0.0, 0.0, reach));
    }
}
