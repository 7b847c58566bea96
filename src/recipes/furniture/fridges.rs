//! Refrigerators.

use glam::DVec3;

use super::parts::{HandleForm, HandleKind, handle, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of height below which there is one door.
const LOW: f64 = 1.1;

/// A refrigerator: two doors with recessed grips, a round-shouldered one with a lever, one of steel with bars, or a
/// plain white one; one door where it is low.
pub(super) static FRIDGE: Recipe =
    Recipe::furniture("fridge", [0.6, 0.65, 1.9]).symbol(Symbol::Fridge).every_set(fridge);

fn fridge(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (slot, metal) = slots_of(draft);
    let reach = if draft.set() == GeometrySet::Plain { 0.002 } else { 0.035 };
    let foot = 0.04_f64.min(bay.height() * 0.1);
    let feet = bay.slab(Side::Below, foot + SINK).inset(0.01, 0.0, 0.01).without(Side::Front, 0.06);
    builder.cuboid(Slot::PlasticDark, feet);
    let body = bay.without(Side::Below, foot);
    let round = if draft.is_traditional() { 0.07 } else { 0.008 };
    let door = 0.05;
    let case = body.without(Side::Front, reach + door + 0.006 - SINK);
    let segments = if draft.is_traditional() { 3 } else { 1 };
    builder.rounded(slot, case, DVec3::new(round, round, 0.006), segments);
    // The seal between the case and the doors.
    let seal = body.inset(round * 0.6 + 0.008, round * 0.6 + 0.008, 0.0);
    builder.cuboid(Slot::Rubber, seal.with_z([case.high.z - SINK, case.high.z + 0.008]));
    let is_low = bay.height() < LOW;
    let leaves = if is_low { vec![body] } else { two_doors(body, draft.form()) };
    for (index, leaf) in leaves.into_iter().enumerate() {
        let face = leaf.without(Side::Front, reach).slab(Side::Front, door);
        let radii = DVec3::new(round, round, if draft.is_traditional() { 0.04 } else { 0.008 });
        builder.rounded(slot, face, radii, segments);
        if face.height() >= 0.1 {
            grip(draft, builder, metal, face, Grip { reach, is_lower: index == 0 && !is_low });
        }
    }
    extras(draft, builder, body, reach);
}

/// Materials of the body and of what is fitted to it.
fn slots_of(draft: &Draft) -> (Slot, Slot) {
    let look = draft.form();
    match draft.set() {
        GeometrySet::Plain => {
            ([Slot::Metal, Slot::Appliance, Slot::MetalDark, Slot::Painted][look], Slot::MetalDark)
        }
        GeometrySet::Traditional => {
            ([Slot::PaintedAccent, Slot::Appliance, Slot::Painted, Slot::PaintedAccent][look], Slot::Chrome)
        }
        GeometrySet::Industrial => {
            ([Slot::Metal, Slot::Metal, Slot::MetalDark, Slot::Metal][look], Slot::Metal)
        }
        GeometrySet::Budget => {
            (Slot::Appliance, [Slot::Plastic, Slot::Metal, Slot::PlasticDark, Slot::Plastic][look])
        }
    }
}

/// The lower and the upper door; the freezer's is the smaller one.
fn two_doors(body: Bay, look: usize) -> Vec<Bay> {
    let share = [0.34, 0.28, 0.38, 0.24][look];
    let is_freezer_low = look.is_multiple_of(2);
    let cut = body.low.y + body.height() * if is_freezer_low { share } else { 1.0 - share };
    vec![body.with_y([body.low.y, cut - 0.004]), body.with_y([cut + 0.004, body.high.y])]
}

/// Where a door is gripped.
struct Grip {
    /// Metres that the handle stands out.
    reach: f64,
    /// Whether it is reached for from above.
    is_lower: bool,
}

/// The handle of one door.
fn grip(draft: &Draft, builder: &mut Builder, metal: Slot, face: Bay, place: Grip) {
    let Grip { reach, is_lower } = place;
    let surface = face.high.z;
    let length = (face.height() * 0.4).min(0.42);
    let inner = if is_lower { face.high.y - length * 0.6 } else { face.low.y + length * 0.6 };
    match draft.set() {
        GeometrySet::Plain => {
            let x = face.low.x + 0.006;
            let strip = Bay::around(DVec3::new(x + 0.012, inner, surface), 0.024, length, 0.0036);
            builder.cuboid(metal, strip);
        }
        GeometrySet::Traditional => {
            // A lever on a plate.
            let at = DVec3::new(
                face.low.x + 0.09,
                if is_lower {
                    face.high.y - 0.1_f64.min(face.height() * 0.3)
                } else {
                    face.low.y + 0.1_f64.min(face.height() * 0.3)
                },
                surface,
            );
            builder.block(metal, Bay::around(at, 0.05, 0.05, 0.012), 0.003);
            let path = [at, at + DVec3::Z * (reach - 0.0075), at + DVec3::new(0.16, 0.0, reach - 0.0075)];
            builder.add(metal, sweep(&path, 0.0078, 8));
        }
        GeometrySet::Industrial => {
            let at = DVec3::new(face.low.x + 0.05, face.center().y, surface);
            handle(
                builder,
                metal,
                HandleForm { kind: HandleKind::Upright, length: face.height() * 0.78 },
                at,
                reach,
            );
        }
        GeometrySet::Budget => {
            let at = DVec3::new(face.low.x + 0.03, inner, surface);
            let bar = Bay::around(at, 0.028, length * 0.6, 0.0).with_z([surface - SINK, surface + reach]);
            builder.block(metal, bar, 0.008);
        }
    }
}

/// What tells a refrigerator from a cupboard: a badge, a display, notes on the door, a grille.
fn extras(draft: &Draft, builder: &mut Builder, body: Bay, reach: f64) {
    let surface = body.high.z - reach;
    let at = |x: f64, y: f64| DVec3::new(x * body.width(), body.low.y + y * body.height(), surface);
    match draft.set() {
        GeometrySet::Plain if draft.input.look.is_multiple_of(2) => {
            builder.cuboid(
                Slot::Screen,
                Bay::around(at(0.0, 0.68), body.width() * 0.3, body.height() * 0.1, 0.003),
            );
        }
        GeometrySet::Plain => builder.cuboid(Slot::Metal, Bay::around(at(0.2, 0.94), 0.09, 0.014, 0.003)),
        GeometrySet::Traditional => {
            builder.cuboid(Slot::Chrome, Bay::around(at(0.12, 0.86), body.width() * 0.36, 0.02, 0.008))
        }
        GeometrySet::Industrial => {
            for row in 0..4 {
                let y = body.low.y + 0.02 + 0.016 * f64::from(row);
                let slit = Bay::around(DVec3::new(0.0, y, surface), body.width() * 0.7, 0.006, 0.0024);
                builder.cuboid(Slot::MetalDark, slit);
            }
        }
        GeometrySet::Budget => {
            let notes = [
                (-0.1, 0.8, 0.1, 0.14, Slot::Paper),
                (0.14, 0.74, 0.08, 0.08, Slot::FabricAccent),
                (0.2, 0.84, 0.07, 0.1, Slot::Paper),
            ];
            for (x, y, wide, tall, slot) in notes {
                builder.cuboid(slot, Bay::around(at(x, y), wide, tall, 0.0022));
                let pin = turned_forward(cylinder(0.01, [-0.0004, 0.006], 6));
                let middle = at(x, y);
                builder.add(Slot::Book, pin.moved(middle.x, middle.y + tall * 0.4, surface));
            }
        }
    }
}
