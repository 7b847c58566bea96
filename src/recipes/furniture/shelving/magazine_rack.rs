//! Racks for magazines: covers of 0.21 by 0.28 m stand to the front, 0.25 to 0.32 m over each other.

use glam::{DVec2, DVec3};

use super::BOARD;
use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, cornice, legs_at_corners, slab_top};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Sampler, extrude, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres from row to row.
const ROW: f64 = 0.32;
/// Metres of a cover's width with the gap beside it.
const COVER: f64 = 0.24;
/// Metres of a ledge's height.
const LEDGE: f64 = 0.03;

/// How the rows of a rack are made.
struct Rows {
    /// The plates that lean; none for wire.
    plate: Slot,
    ledge: Slot,
    is_wire: bool,
    /// Share of the depth at the floor by which the rows above step back.
    stagger: f64,
}

/// Sloping shelves between cheeks, in a bookcase, in a frame of steel, or of wire.
pub(in super::super) static MAGAZINE_RACK: Recipe =
    Recipe::furniture("magazine_rack", [0.8, 0.35, 1.4]).symbol(Symbol::Shelf).every_set(magazine_rack);

fn magazine_rack(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    let (space, rows) = match draft.set() {
        GeometrySet::Plain => plain(builder, form),
        GeometrySet::Traditional => traditional(builder, form),
        GeometrySet::Industrial => industrial(builder, form),
        GeometrySet::Budget => budget(builder, form),
    };
    let mut sampler = draft.sampler();
    let count = (space.height() / ROW).round().clamp(1.0, 6.0) as u32;
    for (index, row) in space.rows(count, 0.0).into_iter().enumerate() {
        let back = rows.stagger * row.depth() * index as f64 / f64::from(count);
        magazines(builder, &mut sampler, row.without(Side::Front, back), &rows);
    }
}

/// Cheeks: straight, cut at a slope so that rows step back, or none but a back board on a foot.
fn plain(builder: &mut Builder, form: usize) -> (Bay, Rows) {
    let bay = builder.bay();
    let slot = [Slot::Wood, Slot::Painted, Slot::WoodLight, Slot::MetalDark][form];
    let board = BOARD.min(bay.width() * 0.1);
    let rows = |stagger| Rows { plate: slot, ledge: slot, is_wire: false, stagger };
    if form % 2 == 1 {
        let (low, high) = (bay.low, bay.high);
        let cheek = [(high.z, 0.0), (high.z, 0.12), (low.z + 0.16, high.y), (low.z, high.y), (low.z, 0.0)];
        let profile = cheek.map(DVec2::from);
        builder.add_pair(slot, extrude(&profile, Axis::X, [high.x - board, high.x]));
        let inner = bay.inset(board - SINK, 0.0, 0.003);
        builder.cuboid(slot, inner.slab(Side::Back, 0.012).inset(0.0, 0.003, 0.0));
        return (
            inner.without(Side::Back, 0.0115).without(Side::Below, 0.05).without(Side::Above, 0.004),
            rows(0.62),
        );
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, board));
    }
    let inner = bay.inset(board - SINK, 0.0, 0.003);
    builder.cuboid(slot, inner.slab(Side::Back, 0.012).inset(0.0, 0.003, 0.0));
    (inner.without(Side::Back, 0.0115).without(Side::Below, 0.04), rows(0.0))
}

/// A case with cornice and plinth, brass rails before the covers.
fn traditional(builder: &mut Builder, form: usize) -> (Bay, Rows) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Wood, Slot::WoodDark][form];
    let bay = builder.bay();
    let (crown, base) =
        (0.05_f64.min(bay.height() * 0.08), [0.09, 0.24, 0.09, 0.24_f64][form].min(bay.height() * 0.2));
    cornice(builder, slot, bay.slab(Side::Above, crown), 0.025);
    slab_top(
        builder,
        slot,
        bay.slab(Side::Below, base)
            .inset(0.01, 0.0, 0.0)
            .without(Side::Back, 0.002)
            .without(Side::Front, 0.012),
        true,
    );
    if base > 0.15 {
        for door in bay.inset(0.05, 0.0, 0.0).columns(2, 0.03) {
            let front = door.with_y([0.05, base - 0.05]).slab(Side::Front, 0.014).without(Side::Front, 0.004);
            builder.block(slot, front, 0.003);
            builder.cuboid(Slot::Brass, Bay::around(front.center().with_z(front.high.z), 0.07, 0.012, 0.008));
        }
    }
    let body = bay.inset(0.025, 0.0, 0.002).without(Side::Front, 0.02);
    let body = body.with_y([base - SINK, bay.high.y - crown + SINK]);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, body.slab(side, 0.03));
    }
    let inner = body.inset(0.03 - SINK, 0.0, 0.0);
    builder.cuboid(slot, inner.slab(Side::Back, 0.012).inset(0.0, 0.003, 0.0).moved(0.0, 0.0, 0.002));
    let space = inner
        .without(Side::Back, 0.0135)
        .without(Side::Below, 0.02)
        .without(Side::Front, 0.004)
        .without(Side::Above, 0.006);
    (
        space,
        Rows { plate: slot, ledge: Slot::Brass, is_wire: false, stagger: if form >= 2 { 0.3 } else { 0.0 } },
    )
}

/// Plates of sheet between posts of angle or of pipe.
fn industrial(builder: &mut Builder, form: usize) -> (Bay, Rows) {
    let bay = builder.bay();
    let post = 0.035_f64.min(bay.width() * 0.08);
    let kind = [LegKind::Angle, LegKind::Pipe, LegKind::Angle, LegKind::Square][form];
    legs_at_corners(builder, Slot::MetalDark, bay, post, kind);
    let inner = bay.inset(post * 0.5, 0.0, post * 0.3).without(Side::Below, 0.1).without(Side::Above, 0.03);
    builder.cuboid(
        Slot::MetalDark,
        bay.inset(post * 0.4, 0.0, post * 0.4).slab(Side::Above, 0.03).without(Side::Above, 0.01),
    );
    let plate = [Slot::Metal, Slot::Wood, Slot::Metal, Slot::Wood][form];
    (inner, Rows { plate, ledge: Slot::MetalDark, is_wire: form == 2, stagger: 0.0 })
}

/// Wire on two bent tubes, or plates of plastic on a thin frame.
fn budget(builder: &mut Builder, form: usize) -> (Bay, Rows) {
    let bay = builder.bay();
    let tube = 0.012;
    let x = bay.high.x - tube;
    let (front, back) = (bay.high.z - tube, bay.low.z + tube);
    let path = [
        DVec3::new(x, tube, front),
        DVec3::new(x, tube, back),
        DVec3::new(x, bay.high.y - tube, back + 0.02),
        DVec3::new(x, bay.high.y - tube, back + 0.1),
        DVec3::new(x, 0.08, front - 0.002),
    ];
    let slot = [Slot::Chrome, Slot::MetalDark, Slot::PlasticDark, Slot::Chrome][form];
    builder.add_pair(slot, sweep(&path, tube, 6));
    let inner = bay.inset(tube * 1.4, 0.0, 0.014).without(Side::Below, 0.06).without(Side::Above, 0.014);
    builder.cuboid(
        slot,
        inner.slab(Side::Below, 0.02).moved(0.0, -0.05, 0.0).slab(Side::Back, 0.02).inset(-0.01, 0.0, 0.0),
    );
    let plate = [Slot::Metal, Slot::Plastic, Slot::Plastic, Slot::Laminate][form];
    (inner, Rows { plate, ledge: plate, is_wire: form == 0, stagger: 0.55 })
}

/// One row: a plate or wires that lean, a ledge, and covers of varied height.
fn magazines(builder: &mut Builder, sampler: &mut Sampler, row: Bay, rows: &Rows) {
    let (back, front, low, high) = (row.low.z, row.high.z, row.low.y, row.high.y - LEDGE);
    builder.cuboid(rows.ledge, Bay::new(row.x(), [low, low + LEDGE], [front - 0.012, front]));
    // The plate reaches from behind the ledge to the back of the row.
    let leaning = |from: f64, to: f64, off: f64, thick: f64| {
        let at =
            |share: f64| (front - 0.018 + (back - front + 0.018) * share, low + 0.002 + (high - low) * share);
        let (foot, head) = (at(from), at(to));
        [
            (foot.0 + off, foot.1),
            (foot.0 + off + thick, foot.1),
            (head.0 + off + thick, head.1),
            (head.0 + off, head.1),
        ]
        .map(DVec2::from)
    };
    if rows.is_wire {
        for wire in row.inset(0.01, 0.0, 0.0).columns(5, (row.width() - 0.05) / 5.0) {
            builder.add(rows.plate, extrude(&leaning(0.0, 1.0, 0.0, 0.006), Axis::X, wire.x()));
        }
    } else {
        builder.add(rows.plate, extrude(&leaning(0.0, 1.0, 0.0, 0.007), Axis::X, row.x()));
    }
    let columns = (row.width() / COVER).round().clamp(1.0, 6.0) as u32;
    for column in row.inset(0.015, 0.0, 0.0).columns(columns, 0.02) {
        let slot = sampler.pick(&[Slot::Paper, Slot::Book, Slot::PaintedAccent, Slot::Leaf]);
        let cover = leaning(0.02, sampler.between(0.72, 0.9), 0.0068, 0.009);
        builder.add(slot, extrude(&cover, Axis::X, column.x()));
    }
}
