//! Microwave ovens: 0.44 to 0.51 m wide, 0.26 to 0.31 high, those for canteens of steel.

use glam::{DVec2, DVec3};

use super::parts::{HandleForm, HandleKind, handle, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, lathe, loft, loft_ring,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres that handles and knobs stand out, and that a door does.
const REACH: f64 = 0.018;
const DOOR: f64 = 0.004;

/// A microwave oven: all glass in front with one dial; a round one with a ring around its window and two dials; of steel
/// with keys over a door that falls open; of sheet with a bowed door, two knobs and a push button.
pub(super) static MICROWAVE: Recipe = Recipe::accessory("microwave", [0.5, 0.38, 0.3]).every_set(microwave);

fn microwave(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    match draft.set() {
        GeometrySet::Plain => {
            glass(builder, [Slot::Metal, Slot::Appliance, Slot::PlasticDark, Slot::Metal][look])
        }
        GeometrySet::Traditional => {
            round(builder, [Slot::PaintedAccent, Slot::Appliance, Slot::Painted, Slot::Metal][look]);
        }
        GeometrySet::Industrial => {
            steel(builder, [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::MetalDark][look])
        }
        GeometrySet::Budget => {
            sheet(builder, [Slot::Appliance, Slot::Plastic, Slot::Appliance, Slot::PlasticDark][look])
        }
    }
}

/// Two runners under a case; gives the case.
fn on_runners(builder: &mut Builder, share: f64) -> Bay {
    let bay = builder.bay();
    let foot = bay.height() * share;
    let low = bay.slab(Side::Below, foot + SINK).inset(0.03, 0.0, 0.03).without(Side::Front, REACH);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Rubber, low.slab(side, 0.025));
    }
    bay.without(Side::Front, REACH).without(Side::Below, foot)
}

/// The ends along z of what stands out of a front.
fn out(front: f64, by: f64) -> [f64; 2] {
    [front - SINK, front + by]
}

/// A front of dark glass from side to side with a dial and a display; a slim handle between them and the window.
fn glass(builder: &mut Builder, slot: Slot) {
    let case = on_runners(builder, 0.03);
    builder.cuboid(slot, case);
    let front = case.high.z;
    let pane = case.inset(0.006, 0.006, 0.0).with_z(out(front, DOOR));
    builder.cuboid(Slot::Screen, pane);
    let window =
        pane.slab(Side::Left, pane.width() * 0.7).inset(pane.width() * 0.06, pane.height() * 0.16, 0.0);
    builder.cuboid(Slot::MetalDark, window.with_z(out(front, DOOR + 0.0008)));
    let face = front + DOOR;
    let grip = DVec3::new(pane.low.x + pane.width() * 0.73, pane.center().y, face);
    handle(
        builder,
        Slot::Metal,
        HandleForm { kind: HandleKind::Upright, length: pane.height() * 0.86 },
        grip,
        REACH - DOOR,
    );
    let keys = pane.slab(Side::Right, pane.width() * 0.24);
    let radius = (keys.width() * 0.32).min(keys.height() * 0.2);
    let dial = turned_forward(lathe(&[(radius, -SINK), (radius * 0.92, REACH * 0.6)], 10));
    builder.add(Slot::Metal, dial.moved(keys.center().x, keys.low.y + keys.height() * 0.3, face));
    let display =
        keys.inset(keys.width() * 0.16, keys.height() * 0.4, 0.0).moved(0.0, keys.height() * 0.26, 0.0);
    builder.cuboid(Slot::PlasticDark, display.with_z(out(face, 0.0012)));
}

/// A case with large round edges as in the fifties, a bright ring around the window, two dials and a lever.
fn round(builder: &mut Builder, slot: Slot) {
    let case = on_runners(builder, 0.07);
    let edge = (case.height() * 0.16).min(case.width() * 0.1);
    builder.rounded(slot, case, DVec3::new(edge, edge, edge * 0.5), 2);
    let front = case.high.z;
    let face = case.inset(edge * 0.8, edge * 0.8, 0.0);
    let door = face.slab(Side::Left, face.width() * 0.72);
    let (half, middle) = (door.extent() / 2.0, door.center());
    let slice = |z: f64, back: f64| {
        Slice::new(z, half.x - back, half.y - back).softened((half.y * 0.5 - back).max(0.004))
    };
    let border = (half.y * 0.14).min(0.016);
    let ring = [slice(-SINK, 0.0), slice(0.008, border * 0.4), slice(-SINK, border)];
    let place = |solid: crate::recipes::kit::Solid| turned_forward(solid).moved(middle.x, middle.y, front);
    builder.add(Slot::Chrome, place(loft_ring(&Outline::Soft(1), &ring)));
    let pane = [slice(-SINK, border * 0.9), slice(0.0022, border * 0.7)];
    builder.add(Slot::Screen, place(loft(&Outline::Soft(1), &pane)));
    let grip = DVec3::new(door.high.x - half.x * 0.22, middle.y, front + 0.002);
    handle(
        builder,
        Slot::Chrome,
        HandleForm { kind: HandleKind::Upright, length: half.y * 1.1 },
        grip,
        REACH - 0.002,
    );
    let keys = face.slab(Side::Right, face.width() * 0.25);
    let radius = (keys.width() * 0.42).min(keys.height() * 0.2);
    for y in [0.72, 0.26] {
        let dial = [(radius, -SINK), (radius * 0.7, 0.013)];
        let at = DVec3::new(keys.center().x, keys.low.y + keys.height() * y, front);
        builder.add(Slot::Chrome, turned_forward(lathe(&dial, 8)).moved(at.x, at.y, at.z));
    }
}

/// A box of steel: keys and a display in a strip along the top, a door below that falls open by the bar along its edge.
fn steel(builder: &mut Builder, slot: Slot) {
    let case = on_runners(builder, 0.1);
    let front = case.high.z;
    builder.cuboid(slot, case);
    let strip =
        case.slab(Side::Above, case.height() * 0.24).inset(0.008, 0.006, 0.0).with_z(out(front, 0.002));
    builder.cuboid(Slot::PlasticDark, strip);
    let keys = strip.inset(strip.width() * 0.03, strip.height() * 0.2, 0.0);
    builder.cuboid(Slot::Screen, keys.slab(Side::Left, keys.width() * 0.3).with_z(out(strip.high.z, 0.001)));
    let field = keys.slab(Side::Right, keys.width() * 0.64);
    for key in field.columns(5, field.width() * 0.03) {
        builder.cuboid(Slot::Plastic, key.with_z(out(strip.high.z, 0.002)));
    }
    let door = case.without(Side::Above, case.height() * 0.24).inset(0.008, 0.008, 0.0);
    builder.cuboid(slot, door.with_z(out(front, 0.007)));
    let face = front + 0.007;
    let window =
        door.without(Side::Above, door.height() * 0.3).inset(door.width() * 0.12, door.height() * 0.08, 0.0);
    builder.cuboid(Slot::Screen, window.with_z(out(face, 0.001)));
    let grip = DVec3::new(door.center().x, door.high.y - door.height() * 0.15, face);
    handle(
        builder,
        Slot::Metal,
        HandleForm { kind: HandleKind::Level, length: door.width() * 0.9 },
        grip,
        REACH - 0.007,
    );
}

/// A case of thin sheet with a door that bows out, knobs with a bar across and a long button that opens.
fn sheet(builder: &mut Builder, slot: Slot) {
    let case = on_runners(builder, 0.05);
    let front = case.high.z;
    builder.cuboid(slot, case);
    let face = case.inset(0.006, 0.008, 0.0);
    let door = face.slab(Side::Left, face.width() * 0.74);
    let at = |share: f64, by: f64| DVec2::new(door.low.x + share * door.width(), front + by);
    let bowed = |inset: f64, lift: f64| {
        [
            (inset, -SINK),
            (1.0 - inset, -SINK),
            (1.0 - inset, 0.004),
            (0.8, 0.010),
            (0.5, 0.013),
            (0.2, 0.010),
            (inset, 0.004),
        ]
        .map(|(share, by)| at(share, if by > 0.0 { by + lift } else { by }))
    };
    builder.add(slot, extrude(&bowed(0.0, 0.0), Axis::Y, door.y()));
    let window = door.inset(0.0, door.height() * 0.18, 0.0).y();
    builder.add(Slot::Screen, extrude(&bowed(0.1, 0.001), Axis::Y, window));
    let keys = face.slab(Side::Right, face.width() * 0.24);
    let radius = (keys.width() * 0.32).min(keys.height() * 0.15);
    for y in [0.8, 0.48] {
        let middle = DVec3::new(keys.center().x, keys.low.y + keys.height() * y, front);
        let disc = turned_forward(cylinder(radius, [-SINK, 0.004], 8));
        builder.add(Slot::MetalDark, disc.moved(middle.x, middle.y, middle.z));
        let bar = Bay::around(middle, radius * 0.4, radius * 1.7, 0.0);
        builder.cuboid(Slot::Plastic, bar.with_z(out(front + 0.004, REACH - 0.004)));
    }
    let button = keys.slab(Side::Below, keys.height() * 0.2).inset(keys.width() * 0.08, 0.0, 0.0);
    builder.cuboid(Slot::MetalDark, button.with_z(out(front, 0.006)));
}
