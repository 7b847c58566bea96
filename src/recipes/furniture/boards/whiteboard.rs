//! Whiteboards: 1.2 m high, enamel 10 to 20 mm thick, trays 60 to 80 mm deep.

use glam::DVec3;

use super::{frame, inside, moulded_frame};
use crate::geometry::Side;
use crate::recipes::furniture::parts::turned_sideways;
use crate::recipes::kit::{Bay, Builder, SINK, lathe, sweep};
use crate::recipes::{Draft, Recipe, Slot};

/// Colours of pens.
const INKS: [Slot; 3] = [Slot::Book, Slot::PaintedAccent, Slot::PlasticDark];
/// Metres from the middle of a stroke to its edge.
const STROKE: f64 = 0.003;

/// A board to write on: in a slim frame over a tray; in a wooden moulding over a shelf; two panels that slide on rails;
/// a bare sheet with corners of plastic.
pub(in super::super) static WHITEBOARD: Recipe = Recipe::accessory("whiteboard", [1.8, 0.08, 1.2])
    .plain(framed)
    .traditional(wooden)
    .industrial(|_, builder| sliding(builder))
    .budget(|_, builder| sheet(builder));

/// A line of handwriting on a field, from the left, with a number of turns.
fn handwriting(builder: &mut Builder, slot: Slot, field: Bay, turns: u32) {
    let step = (field.width() / f64::from(turns)).min(0.05);
    let rise = (step * 0.5).min(field.height() * 0.1);
    let at = |index: u32| {
        let up = rise * [1.0, -1.0, 0.7, -0.6][index as usize % 4];
        DVec3::new(field.low.x + step * f64::from(index), field.center().y + up, field.high.z)
    };
    builder.add(slot, sweep(&(0..=turns).map(at).collect::<Vec<_>>(), STROKE, 3));
}

/// A pen that lies along x with its cap to the right.
fn pen(builder: &mut Builder, slot: Slot, at: DVec3) {
    let barrel = [(0.008, 0.0), (0.009, 0.09), (0.006, 0.12)];
    builder.add(slot, turned_sideways(lathe(&barrel, 6)).moved(at.x, at.y, at.z));
}

/// A slim frame of aluminium; a tray with a lip, pens and an eraser.
fn framed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let board = bay.without(Side::Below, 0.02).slab(Side::Back, bay.depth() * 0.35);
    let border = 0.022;
    builder.add(Slot::Metal, frame(board, border));
    let enamel = inside(board, border, [0.1, 0.7]);
    builder.cuboid(Slot::Ceramic, enamel);
    let tray = bay.slab(Side::Below, 0.026).inset(bay.width() * 0.2, 0.0, 0.0);
    builder.cuboid(Slot::Metal, tray.slab(Side::Below, 0.008));
    let lip = tray.slab(Side::Front, 0.006).without(Side::Below, 0.008 - SINK);
    builder.cuboid(Slot::Metal, lip.inset(0.001, 0.0, 0.001));
    let mut sampler = draft.sampler();
    let z = bay.high.z - bay.depth() * 0.3;
    for (index, slot) in INKS.into_iter().enumerate().take(2) {
        let x = bay.width() * (0.03 + 0.09 * index as f64) * if sampler.chance(0.5) { 1.0 } else { -1.0 };
        pen(builder, slot, DVec3::new(x, 0.0165, z));
    }
    let eraser = Bay::around(DVec3::new(-bay.width() * 0.22, 0.02, z), 0.11, 0.026, bay.depth() * 0.35);
    builder.cuboid(Slot::Fabric, eraser);
    let lines = enamel.inset(enamel.width() * 0.07, enamel.height() * 0.1, 0.0).rows(6, 0.0);
    for (row, slot) in [(5, INKS[sampler.count(0, 2) as usize]), (4, Slot::PlasticDark)] {
        handwriting(builder, slot, lines[row], sampler.count(7, 10));
    }
}

/// A broad moulding of wood over a shelf on brackets.
fn wooden(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = [Slot::WoodDark, Slot::Wood, Slot::WoodDark, Slot::Wood][draft.form()];
    let shelf = 0.024;
    let board = bay.without(Side::Below, shelf * 1.6).slab(Side::Back, bay.depth() * 0.55);
    let board = board.without(Side::Above, 0.02).without(Side::Back, 0.001).inset(0.014, 0.0, 0.0);
    let border = (bay.height() * 0.06).min(0.075);
    builder.add(slot, moulded_frame(board, border, border * 0.35));
    let enamel = inside(board, border, [0.1, 0.55]);
    builder.cuboid(Slot::Ceramic, enamel);
    builder.block(slot, bay.slab(Side::Above, 0.034).slab(Side::Back, bay.depth() * 0.75), 0.006);
    let plank = bay.with_y([shelf, shelf * 1.7]);
    builder.block(slot, plank, 0.004);
    for x in [-0.36, 0.36] {
        let at = DVec3::new(x * bay.width(), shelf / 2.0 + SINK, bay.low.z + bay.depth() * 0.35);
        builder.cuboid(slot, Bay::around(at, 0.03, shelf + SINK * 2.0, bay.depth() * 0.7));
    }
    let z = bay.high.z - bay.depth() * 0.25;
    for (index, slot) in INKS.into_iter().enumerate().take(2) {
        pen(builder, slot, DVec3::new(0.16 * index as f64 - 0.3, shelf * 1.7 + 0.0085, z));
    }
    let lines = enamel.inset(enamel.width() * 0.1, enamel.height() * 0.1, 0.0).rows(5, 0.0);
    handwriting(builder, Slot::PlasticDark, lines[4], 9);
}

/// Two panels, one before the other, that hang between rails.
fn sliding(builder: &mut Builder) {
    let bay = builder.bay();
    let (depth, rail) = (bay.depth(), (bay.height() * 0.05).min(0.055));
    for side in [Side::Above, Side::Below] {
        builder.cuboid(Slot::MetalDark, bay.slab(side, rail).without(Side::Front, depth * 0.12));
        let lip = bay.slab(side, rail * 0.4).inset(0.001, 0.0, 0.0).slab(Side::Front, depth * 0.2);
        builder.cuboid(Slot::MetalDark, lip.inset(0.0, 0.001, 0.0));
        for x in [-0.4, 0.4] {
            let bolt = bay.slab(side, rail).center();
            let at = DVec3::new(x * bay.width(), bolt.y, bay.high.z - depth * 0.12);
            builder.cuboid(Slot::Metal, Bay::around(at, rail * 0.3, rail * 0.3, depth * 0.1));
        }
    }
    let between = bay.inset(bay.width() * 0.02, rail * 0.7, 0.0);
    let layer = |low: f64, high: f64| [bay.low.z + depth * low, bay.low.z + depth * high];
    let far = between.slab(Side::Left, bay.width() * 0.55).with_z(layer(0.1, 0.34));
    let near = between.slab(Side::Right, bay.width() * 0.5).inset(0.0, 0.002, 0.0).with_z(layer(0.5, 0.74));
    for panel in [far, near] {
        builder.cuboid(Slot::Ceramic, panel);
        let grip = panel.slab(Side::Left, 0.022).inset(0.0, 0.003, 0.0).moved(-0.001, 0.0, 0.0);
        builder.cuboid(Slot::Metal, grip.with_z([panel.low.z - 0.001, panel.high.z + depth * 0.1]));
    }
    let words = near.inset(near.width() * 0.16, near.height() * 0.12, 0.0).rows(6, 0.0);
    handwriting(builder, Slot::PlasticDark, words[5], 8);
    handwriting(builder, Slot::Book, words[4], 6);
}

/// A sheet of enamel held off the wall by its corners; a clip with a pen, magnets with a note.
fn sheet(builder: &mut Builder) {
    let bay = builder.bay();
    let depth = bay.depth();
    let layer = |low: f64, high: f64| [bay.low.z + depth * low, bay.low.z + depth * high];
    let sheet = bay.inset(0.004, 0.004, 0.0).with_z(layer(0.3, 0.44));
    builder.cuboid(Slot::Ceramic, sheet);
    let corner = (bay.height() * 0.06).min(0.07);
    for side in [Side::Left, Side::Right] {
        for edge in [Side::Above, Side::Below] {
            let cap = bay.slab(side, corner).slab(edge, corner).with_z(layer(0.0, 0.62));
            builder.cuboid(Slot::PlasticDark, cap);
        }
    }
    let clip = bay.slab(Side::Below, 0.02).inset(bay.width() * 0.38, 0.0, 0.0).moved(0.0, 0.05, 0.0);
    builder.cuboid(Slot::Plastic, clip.with_z(layer(0.4, 1.0)));
    pen(builder, Slot::Book, DVec3::new(clip.low.x + 0.03, clip.high.y + 0.008, bay.high.z - depth * 0.2));
    let middle = DVec3::new(bay.width() * 0.28, bay.height() * 0.66, sheet.high.z);
    let note = Bay::around(middle, 0.21, 0.297, 0.0);
    builder.cuboid(Slot::Paper, note.with_z([sheet.high.z - SINK, sheet.high.z + 0.001]));
    for (x, y, slot) in
        [(-0.08, 0.13, Slot::Book), (0.08, 0.13, Slot::PaintedAccent), (0.2, 0.1, Slot::PlasticDark)]
    {
        let at = middle + DVec3::new(x, y, 0.0);
        builder.cuboid(slot, Bay::around(at, 0.028, 0.028, 0.016));
    }
    let lines = sheet.inset(bay.width() * 0.1, bay.height() * 0.14, 0.0).rows(5, 0.0);
    handwriting(builder, Slot::PaintedAccent, lines[4], 8);
}
