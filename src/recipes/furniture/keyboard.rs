//! Keyboards and mice: boards 0.43 to 0.45 m wide, 0.13 to 0.15 deep, keys 19 mm apart (ISO 9995).

use glam::{DVec2, DVec3};

use super::seating::depth_slats;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, extrude};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A keyboard with rows of keys, and a mouse where the box is wide: a flat board; a deep wedge with blocks of keys; tall keys
/// on a plate; one with round ends and a rest for the wrists.
pub(super) static KEYBOARD: Recipe = Recipe::accessory("keyboard", [0.45, 0.15, 0.03]).every_set(keyboard);

fn keyboard(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let has_mouse = bay.width() > bay.depth() * 3.4 || bay.width() > 0.52;
    let board = if has_mouse { bay.slab(Side::Left, bay.width() * 0.78) } else { bay };
    match draft.set() {
        GeometrySet::Plain => flat(builder, board),
        GeometrySet::Traditional => wedge(builder, board),
        GeometrySet::Industrial => plate(builder, board),
        GeometrySet::Budget => rounded(builder, board),
    }
    if has_mouse {
        let pad = bay.slab(Side::Right, bay.width() * 0.16);
        let mouse = Bay::around(pad.center(), pad.width(), bay.height(), (bay.depth() * 0.8).min(0.11));
        let slot = if draft.is_traditional() { Slot::FabricLight } else { Slot::PlasticDark };
        builder.rounded(slot, mouse, mouse.extent() * DVec3::new(0.4, 0.45, 0.4), 1);
    }
}

/// A row with a long key in its middle.
fn space_row(builder: &mut Builder, slot: Slot, row: Bay) {
    let width = row.width();
    let middle = row.without(Side::Left, width * 0.27).without(Side::Right, width * 0.32);
    for key in [row.slab(Side::Left, width * 0.25), middle, row.slab(Side::Right, width * 0.3)] {
        builder.cuboid(slot, key);
    }
}

fn flat(builder: &mut Builder, board: Bay) {
    let base = board.height() * 0.6;
    builder.block(Slot::PlasticDark, board.with_y([0.0, base]), base * 0.25);
    let keys = board.with_y([base - SINK, board.high.y]);
    let keys = keys.inset(board.width() * 0.02, 0.0, board.depth() * 0.06);
    for (index, row) in depth_slats(keys, 5, keys.depth() * 0.04).into_iter().enumerate() {
        if index == 4 {
            space_row(builder, Slot::Plastic, row);
        } else {
            row.columns(3, row.width() * 0.02).into_iter().for_each(|key| builder.cuboid(Slot::Plastic, key));
        }
    }
}

/// A deep case that rises to the back in a step, with letters, a block of numbers and a coiled cable.
fn wedge(builder: &mut Builder, board: Bay) {
    let (back, high) = (board.low.z, board.height());
    let depth = board.depth();
    let at = |z: f64, y: f64| DVec2::new(back + z * depth, y * high);
    let case = [
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(1.0, 0.34),
        at(0.94, 0.42),
        at(0.28, 0.7),
        at(0.22, 1.0),
        at(0.0, 1.0),
    ];
    builder.add(Slot::FabricLight, extrude(&case, Axis::X, board.x()));
    let (low, top) = (at(0.92, 0.43), at(0.3, 0.69));
    let (run, rise) = (low.x - top.x, top.y - low.y);
    let (slope, length) = (libm::atan2(rise, run), libm::sqrt(run * run + rise * rise));
    let field =
        board.inset(board.width() * 0.02, 0.0, 0.0).with_z([0.0, length]).with_y([-SINK * 2.0, high * 0.2]);
    let mut key = |slot: Slot, bay: Bay| {
        builder.add(slot, cuboid(bay).turned_x(slope).moved(0.0, top.y, top.x));
    };
    let letters = field.slab(Side::Left, field.width() * 0.74);
    let numbers = field.slab(Side::Right, field.width() * 0.22);
    for (index, row) in depth_slats(letters, 4, length * 0.03).into_iter().enumerate() {
        let width = row.width();
        if index == 3 {
            key(Slot::Linen, row.inset(width * 0.22, 0.0, 0.0));
            continue;
        }
        let side = width * (0.1 + 0.03 * index as f64);
        key(Slot::Plastic, row.slab(Side::Left, side));
        key(Slot::Linen, row.without(Side::Left, side + 0.004).without(Side::Right, width * 0.14 + 0.004));
        key(Slot::Plastic, row.slab(Side::Right, width * 0.14));
    }
    for row in depth_slats(numbers, 3, length * 0.03) {
        row.columns(2, 0.003).into_iter().for_each(|bay| key(Slot::Linen, bay));
    }
    let lamps = Bay::new(
        [board.high.x * 0.6, board.high.x * 0.8],
        [high - 0.002, high - 0.0006],
        [back + depth * 0.08, back + depth * 0.14],
    );
    builder.cuboid(Slot::Leaf, lamps.moved(0.0, 0.0008, 0.0));
}

/// Tall keys apart from each other on a plate with bevelled ends, with a knob and accents.
fn plate(builder: &mut Builder, board: Bay) {
    let base = board.height() * 0.3;
    let (half, x) = (board.depth() / 2.0, board.x());
    let cut = board.depth().min(board.width()) * 0.12;
    let middle = board.center().z;
    let outline = [
        (x[0] + cut, middle - half),
        (x[1] - cut, middle - half),
        (x[1], middle - half + cut),
        (x[1], middle + half - cut),
        (x[1] - cut, middle + half),
        (x[0] + cut, middle + half),
        (x[0], middle + half - cut),
        (x[0], middle - half + cut),
    ];
    builder.add(Slot::Metal, extrude(&outline.map(DVec2::from), Axis::Y, [0.0, base]));
    let keys = board.with_y([base - SINK, board.high.y - 0.001]).inset(
        board.width() * 0.05,
        0.0,
        board.depth() * 0.08,
    );
    for (index, row) in depth_slats(keys, 4, keys.depth() * 0.09).into_iter().enumerate() {
        if index == 3 {
            space_row(builder, Slot::PlasticDark, row.inset(0.0, 0.0, 0.0));
            continue;
        }
        for (place, key) in row.columns(5, row.width() * 0.035).into_iter().enumerate() {
            let is_corner = (index, place) == (0, 0) || (index, place) == (2, 4);
            if (index, place) == (0, 4) {
                let side = key.width().min(key.depth()) * 0.9;
                let knob = Bay::around(key.center(), side, key.height(), side);
                builder.cuboid(Slot::Chrome, knob.with_y([base - SINK, board.high.y]));
            } else {
                builder.cuboid(if is_corner { Slot::PaintedAccent } else { Slot::PlasticDark }, key);
            }
        }
    }
}

/// A low case with round ends, a rest for the wrists at the front, a strip of extra keys.
fn rounded(builder: &mut Builder, board: Bay) {
    let base = board.height() * 0.62;
    let rest = board.slab(Side::Front, board.depth() * 0.34);
    builder.rounded(Slot::PlasticDark, rest.with_y([0.0, base * 0.7]), DVec3::new(0.03, 0.006, 0.02), 1);
    let case = board.without(Side::Front, board.depth() * 0.24).with_y([0.0, base]);
    builder.rounded(Slot::PlasticDark, case, DVec3::new(0.04, base * 0.3, 0.03), 1);
    let top = case.with_y([base - SINK, board.high.y]).inset(board.width() * 0.07, 0.0, case.depth() * 0.1);
    for row in depth_slats(top.without(Side::Back, case.depth() * 0.16), 4, top.depth() * 0.03) {
        row.columns(2, board.width() * 0.02).into_iter().for_each(|key| builder.cuboid(Slot::Plastic, key));
    }
    let strip = top.slab(Side::Back, case.depth() * 0.1).with_y([base - SINK, base + 0.002]);
    for key in strip.inset(board.width() * 0.1, 0.0, 0.0).columns(4, board.width() * 0.06) {
        builder.cuboid(Slot::PaintedAccent, key);
    }
}
