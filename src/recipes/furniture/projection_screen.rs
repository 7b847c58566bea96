//! Screens for pictures on walls: 1.8 to 2.4 m wide, 16 to 10 or 4 to 3.

use glam::{DVec2, DVec3};

use super::parts::{across, slab_top, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, extrude, loft_ring, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres of the dark border around the picture.
const BORDER: f64 = 0.05;

/// A screen for pictures: from a flat case with a round edge; under a wooden one with a cornice; laced into a frame of
/// tubes; from an open roll on two brackets.
pub(super) static PROJECTION_SCREEN: Recipe = Recipe::accessory("projection_screen", [2.4, 0.1, 1.8])
    .plain(|_, builder| from_case(builder))
    .traditional(|_, builder| under_cornice(builder))
    .industrial(|_, builder| laced(builder))
    .budget(|_, builder| from_roll(builder));

/// Cloth with its picture, which begins `foot` metres over its lower edge.
fn hang(builder: &mut Builder, cloth: Bay, z: f64, foot: f64) {
    builder.cuboid(Slot::MetalDark, cloth.with_z([z - 0.002, z + 0.002]));
    let picture = cloth.inset(BORDER, 0.0, 0.0).without(Side::Below, foot).without(Side::Above, BORDER);
    builder.cuboid(Slot::Paper, picture.with_z([z + 0.001, z + 0.004]));
}

/// A slim case, round below at its front, as those with a motor have, and a bar at the cloth's lower edge.
fn from_case(builder: &mut Builder) {
    let bay = builder.bay();
    let (depth, z) = (bay.depth(), bay.center().z);
    let case = (bay.height() * 0.08).min(0.1);
    let at = |share: f64, drop: f64| DVec2::new(bay.low.z + share * depth, bay.high.y - case * drop);
    let section = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 0.55), at(0.9, 0.85), at(0.7, 1.0), at(0.0, 1.0)];
    builder.add(Slot::Painted, extrude(&section, Axis::X, bay.x()));
    let cloth = bay.inset(bay.width() * 0.02, 0.0, 0.0).with_y([0.012, bay.high.y - case + SINK]);
    hang(builder, cloth, z, BORDER);
    let bar = cloth.with_y([0.0, 0.025]).inset(-0.01, 0.0, 0.0);
    builder.cuboid(Slot::Metal, bar.with_z([z - 0.012, z + 0.012]));
}

/// A high case of wood with a cornice and a rail below, a lath at the cloth's lower edge and a cord to pull it by.
fn under_cornice(builder: &mut Builder) {
    let bay = builder.bay();
    let (depth, z) = (bay.depth(), bay.center().z);
    let case = (bay.height() * 0.14).min(0.24);
    let cornice = bay.slab(Side::Above, case * 0.28);
    slab_top(builder, Slot::WoodDark, cornice, true);
    let body = bay.slab(Side::Above, case).without(Side::Above, case * 0.28 - SINK);
    let body = body.inset(bay.width() * 0.012, 0.0, 0.0).without(Side::Front, depth * 0.22);
    builder.cuboid(Slot::WoodDark, body);
    let rail = body.slab(Side::Below, case * 0.16).moved(0.0, -0.001, 0.001);
    builder.cuboid(Slot::WoodDark, rail.inset(-0.008, 0.0, 0.0).without(Side::Front, -depth * 0.1));
    let cloth = bay.inset(bay.width() * 0.05, 0.0, 0.0).with_y([0.06, bay.high.y - case + SINK]);
    hang(builder, cloth, z, BORDER + 0.06);
    let lath = cloth.with_y([0.05, 0.1]).inset(-0.006, 0.0, 0.0);
    builder.cuboid(Slot::WoodDark, lath.with_z([z - 0.01, z + 0.01]));
    let cord = [DVec3::new(0.0, 0.055, z), DVec3::new(0.0, 0.02, z)];
    builder.add(Slot::Linen, sweep(&cord, 0.004, 4));
    builder.cuboid(Slot::Brass, Bay::around(DVec3::new(0.0, 0.014, z), 0.022, 0.028, 0.016));
}

/// A frame of square tube on brackets; the cloth is held by straps all around, and one sees the wall between.
fn laced(builder: &mut Builder) {
    let bay = builder.bay();
    let (width, height) = (bay.width(), bay.height());
    let tube = (width.min(height) * 0.04).min(bay.depth() * 0.5);
    let front = bay.slab(Side::Front, tube);
    let slice = |z: f64, back: f64| Slice::new(z, width / 2.0 - back, height / 2.0 - back);
    let [back, face] = front.z();
    let ring = [slice(back, 0.0), slice(face, 0.0), slice(face, tube), slice(back, tube)];
    let frame = turned_forward(loft_ring(&Outline::Square, &ring));
    builder.add(Slot::Metal, frame.moved(0.0, bay.center().y, 0.0));
    let gap = tube * 0.9;
    let cloth = bay.inset(tube + gap, tube + gap, 0.0);
    let z = front.center().z;
    hang(builder, cloth, z, BORDER);
    let strap = [z - tube * 0.08, z + tube * 0.08];
    let reach = gap + tube * 0.5;
    for column in cloth.columns(2, cloth.width() * 0.4) {
        let x = [column.center().x - tube * 0.4, column.center().x + tube * 0.4];
        for y in [cloth.low.y - reach + 0.004, cloth.high.y - 0.004] {
            builder.cuboid(Slot::Rubber, cloth.with_x(x).with_y([y, y + reach]).with_z(strap));
        }
    }
    let level = [cloth.center().y - tube * 0.4, cloth.center().y + tube * 0.4];
    for x in [cloth.low.x - reach + 0.004, cloth.high.x - 0.004] {
        builder.cuboid(Slot::Rubber, cloth.with_y(level).with_x([x, x + reach]).with_z(strap));
    }
    for side in [-1.0, 1.0] {
        let x = side * width * 0.3;
        let bracket = bay.with_x([x - tube, x + tube]).slab(Side::Above, tube * 2.2);
        builder.cuboid(Slot::MetalDark, bracket.with_z([bay.low.z, back + SINK]).inset(0.0, 0.002, 0.0));
    }
}

/// A spring roll that one sees, between two brackets, and a round bar at the cloth's lower edge with a handle.
fn from_roll(builder: &mut Builder) {
    let bay = builder.bay();
    let (depth, z) = (bay.depth(), bay.center().z);
    let radius = (depth * 0.36).min(bay.height() * 0.04);
    let y = bay.high.y - radius * 1.2;
    let roll = bay.inset(0.006, 0.0, 0.0);
    builder.add(Slot::MetalDark, across(radius, roll.x(), 8).moved(0.0, y, z));
    for side in [Side::Left, Side::Right] {
        let bracket = bay.slab(side, 0.014).slab(Side::Above, radius * 2.4);
        builder.cuboid(Slot::Plastic, bracket);
    }
    // The cloth comes off the roll behind, so that it hangs close to the wall.
    let (cloth, back) = (roll.inset(bay.width() * 0.03, 0.0, 0.0), z - radius * 0.85);
    hang(builder, cloth.with_y([0.03, y]), back, BORDER * 2.0);
    let bar = cloth.inset(-0.012, 0.0, 0.0).x();
    builder.add(Slot::Plastic, across(0.016, bar, 6).moved(0.0, 0.034, back));
    let handle = Bay::around(DVec3::new(0.0, 0.012, back), 0.1, 0.024, 0.012);
    builder.cuboid(Slot::PlasticDark, handle);
}
