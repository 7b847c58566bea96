//! Notice boards: cork, felt or wire, sheets of A4 and smaller pinned to them.

use glam::DVec3;

use super::{frame, inside, moulded_frame};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Sampler, cuboid, sweep};
use crate::recipes::{Draft, Recipe, Slot};

/// Metres of a cell for a note: an A4 sheet and some room.
const CELL: [f64; 2] = [0.28, 0.36];
/// Metres of a note's thickness with its air.
const NOTE: f64 = 0.002;

/// A board with notes: felt in a slim frame; cork in a moulding; a grid of wire with clips; tiles of cork.
pub(in super::super) static NOTICE_BOARD: Recipe = Recipe::accessory("notice_board", [1.2, 0.04, 0.9])
    .plain(felt)
    .traditional(cork)
    .industrial(wire)
    .budget(tiles);

/// What holds the notes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Holder {
    Pin,
    Clip,
}

/// Notes in cells of a field on its front, `most` at most, each a little crooked, and what holds them.
fn notes(builder: &mut Builder, sampler: &mut Sampler, field: Bay, most: usize, holder: Holder) {
    let count = |length: f64, cell: f64| (length / cell).round().clamp(1.0, 4.0) as u32;
    let (columns, rows) = (count(field.width(), CELL[0]), count(field.height(), CELL[1]).min(2));
    let cells = field.rows(rows, 0.03).into_iter().flat_map(|row| row.columns(columns, 0.03));
    for cell in cells.take(most) {
        if sampler.chance(0.12) {
            continue;
        }
        let (wide, high) = (sampler.between(0.5, 0.84), sampler.between(0.6, 0.88));
        let slot = sampler.pick(&[Slot::Paper, Slot::Paper, Slot::FabricLight, Slot::PaintedAccent]);
        let turn = if holder == Holder::Pin { sampler.between(-0.06, 0.06) } else { 0.0 };
        let middle = cell.center();
        let (width, height) = (cell.width() * wide, cell.height() * high);
        let sheet = cuboid(Bay::around(DVec3::ZERO, width, height, NOTE + SINK)).turned_z(turn);
        builder.add(slot, sheet.moved(middle.x, middle.y, field.high.z + (NOTE - SINK) / 2.0));
        let top = DVec3::new(middle.x, middle.y + height * 0.46, field.high.z + NOTE);
        match holder {
            Holder::Pin => builder.cuboid(Slot::Book, Bay::around(top, 0.014, 0.014, 0.014)),
            Holder::Clip => {
                let clip = Bay::around(top + DVec3::Y * height * 0.04, 0.06, 0.03, 0.014);
                builder.cuboid(Slot::MetalDark, clip);
            }
        }
    }
}

/// Felt in a slim frame of aluminium.
fn felt(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    builder.add(Slot::Metal, frame(bay, 0.012));
    let felt = inside(bay, 0.012, [0.1, 0.7]);
    builder.cuboid(sampler.pick(&[Slot::Fabric, Slot::FabricAccent, Slot::FabricLight]), felt);
    notes(builder, &mut sampler, felt.inset(0.04, 0.04, 0.0), 8, Holder::Pin);
}

/// Cork in a moulding of wood with a plaque.
fn cork(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let slot = sampler.pick(&[Slot::WoodDark, Slot::Wood]);
    let border = (bay.width().min(bay.height()) * 0.08).min(0.06);
    let board = bay.inset(0.012, 0.012, 0.0).without(Side::Back, 0.001).without(Side::Front, 0.003);
    builder.add(slot, moulded_frame(board, border, border * 0.4));
    for side in [Side::Above, Side::Below] {
        builder.cuboid(slot, bay.slab(side, 0.026).without(Side::Front, bay.depth() * 0.2));
    }
    let cork = inside(board, border, [0.1, 0.5]);
    builder.cuboid(Slot::Terracotta, cork);
    let top = DVec3::new(0.0, board.high.y - border * 0.6, board.high.z);
    builder.cuboid(Slot::Brass, Bay::around(top, bay.width() * 0.22, border * 0.5, 0.006));
    notes(builder, &mut sampler, cork.inset(0.03, 0.03, 0.0), 8, Holder::Pin);
}

/// A grid of wire in a frame of rod, held off the wall; notes hang from clips.
fn wire(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let rim = bay.with_z([bay.center().z, bay.high.z - 0.012]);
    builder.add(Slot::MetalDark, frame(rim, 0.014));
    let (radius, z) = (0.004, rim.center().z);
    let inner = rim.inset(0.01, 0.01, 0.0);
    for column in inner.columns(7, 0.0).iter().skip(1) {
        let at = |y: f64| DVec3::new(column.low.x, y, z);
        builder.add(Slot::MetalDark, sweep(&[at(inner.low.y), at(inner.high.y)], radius, 3));
    }
    for row in inner.rows(5, 0.0).iter().skip(1) {
        let at = |x: f64| DVec3::new(x, row.low.y, z + radius);
        builder.add(Slot::MetalDark, sweep(&[at(inner.low.x), at(inner.high.x)], radius, 3));
    }
    for x in [-0.45, 0.45] {
        let at = DVec3::new(x * bay.width(), bay.high.y - 0.02, 0.0);
        let stud = Bay::around(at, 0.016, 0.016, 1.0).with_z([bay.low.z, z]);
        builder.cuboid(Slot::Metal, stud);
    }
    let field = inner.inset(0.04, 0.04, 0.0).with_z([z, z + radius * 2.0]);
    notes(builder, &mut sampler, field, 6, Holder::Clip);
    let grip = Bay::around(DVec3::new(bay.low.x + 0.09, bay.high.y - 0.03, 0.0), 0.05, 0.04, 1.0);
    builder.cuboid(Slot::Metal, grip.with_z([z - 0.001, bay.high.z]));
}

/// Tiles of cork beside each other on the wall.
fn tiles(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let columns = if bay.width() > bay.height() * 1.2 { 3 } else { 2 };
    let cork = bay.slab(Side::Back, bay.depth() * 0.5);
    for (row, tiles) in cork.rows(2, 0.012).into_iter().enumerate() {
        for (column, tile) in tiles.columns(columns, 0.012).into_iter().enumerate() {
            let slot = if (row + column) % 2 == 0 { Slot::Terracotta } else { Slot::WoodLight };
            builder.cuboid(slot, tile);
        }
    }
    notes(builder, &mut sampler, cork.inset(0.04, 0.05, 0.0), 7, Holder::Pin);
    let spare = Bay::around(bay.center(), 0.014, 0.014, 1.0).with_z([cork.high.z - SINK, bay.high.z]);
    builder.cuboid(Slot::Book, spare.moved(bay.width() * 0.46, -bay.height() * 0.46, 0.0));
}
