//! Small refrigerators of hotel rooms: 30 to 40 litres, 0.40 to 0.45 m wide and deep, 0.55 high.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    Fronts, HandleForm, HandleKind, LegKind, handle, legs_at_corners, slab_top,
};
use crate::recipes::kit::{Bay, Builder, SINK, sweep};
use crate::recipes::{Draft, Recipe, Slot, Symbol};

/// Metres by which handles stand out.
const REACH: f64 = 0.025;
/// Metres of a door with its insulation.
const DOOR: f64 = 0.04;

/// A minibar: flush, in a cabinet of wood, of pressed steel with a lever, or white with a grip in its edge.
pub(in super::super) static MINIBAR: Recipe = Recipe::furniture("minibar", [0.5, 0.5, 0.75])
    .symbol(Symbol::Fridge)
    .plain(|draft, builder| plain(builder, draft.form()))
    .traditional(|draft, builder| traditional(draft, builder, draft.form()))
    .industrial(|draft, builder| industrial(builder, draft.form()))
    .budget(|draft, builder| budget(builder, draft.form()));

/// The body on feet, with the space of its door before it.
fn body(builder: &mut Builder, slot: Slot, reach: f64) -> Bay {
    let bay = builder.bay();
    let foot = bay.height() * 0.04;
    let feet = bay.with_y([0.0, foot + SINK]).inset(0.02, 0.0, 0.02).without(Side::Front, 0.05);
    legs_at_corners(builder, Slot::Rubber, feet, 0.04, LegKind::Square);
    let case = bay.without(Side::Below, foot).without(Side::Front, reach);
    builder.block(slot, case.without(Side::Front, DOOR + 0.003), 0.004);
    case.slab(Side::Front, DOOR)
}

/// A pane of dark or mirroring glass over the whole front, bottles behind it in some.
fn plain(builder: &mut Builder, form: usize) {
    let slot = [Slot::PlasticDark, Slot::Metal, Slot::PlasticDark, Slot::Wood][form];
    let door = body(builder, slot, 0.0);
    builder.cuboid(
        Slot::PlasticDark,
        door.inset(0.006, 0.006, 0.0).slab(Side::Back, 0.006).moved(0.0, 0.0, -0.004),
    );
    if form != 2 {
        let pane = if form == 0 { Slot::Screen } else { slot };
        builder.block(pane, door, 0.004);
        let grip = door.slab(Side::Left, 0.016).slab(Side::Front, 0.006);
        builder.cuboid(Slot::MetalDark, grip.inset(0.0, door.height() * 0.3, -0.0012).moved(0.004, 0.0, 0.0));
        return;
    }
    let frame = 0.025;
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, door.slab(side, frame));
    }
    for side in [Side::Above, Side::Below] {
        builder.cuboid(slot, door.inset(frame - SINK, 0.0006, 0.0006).slab(side, frame));
    }
    let opening = door.inset(frame - SINK, frame - SINK, 0.0);
    builder.cuboid(Slot::Glass, opening.inset(0.0, 0.0, 0.016));
    builder.cuboid(Slot::Linen, opening.slab(Side::Back, 0.004).inset(-SINK, -SINK, 0.0));
    for (index, cell) in opening.inset(0.02, 0.0, 0.0).columns(4, 0.02).into_iter().enumerate() {
        let bottle =
            cell.with_y([opening.low.y, opening.low.y + opening.height() * [0.5, 0.36, 0.5, 0.4][index]]);
        let slot = [Slot::Leaf, Slot::PaintedAccent, Slot::Leather, Slot::Brass][index];
        builder.cuboid(slot, bottle.with_z([opening.low.z + 0.003, opening.low.z + 0.012]));
    }
}

/// A cabinet with a panelled door and a moulded top.
fn traditional(draft: &Draft, builder: &mut Builder, form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::WoodDark, Slot::Wood][form];
    let bay = builder.bay();
    let (top, base) = (bay.height() * 0.06, bay.height() * 0.1);
    slab_top(builder, slot, bay.slab(Side::Above, top), true);
    slab_top(builder, slot, bay.slab(Side::Below, base).inset(0.004, 0.0, 0.004), true);
    let case = bay.inset(0.015, 0.0, 0.015).with_y([base - SINK, bay.high.y - top + SINK]);
    let fittings = Fronts::new(draft, slot, Slot::Brass, 0.012);
    fittings.carcass(builder, slot, case);
    fittings.door(builder, case.inset(0.012, 0.008, 0.0), Side::Right, 0.6);
}

/// Rounded steel with a lever and a badge, as of the fifties.
fn industrial(builder: &mut Builder, form: usize) {
    let slot = [Slot::PaintedAccent, Slot::Metal, Slot::MetalDark, Slot::PaintedAccent][form];
    let door = body(builder, slot, REACH);
    builder.cushion(slot, door.inset(0.002, 0.002, 0.0).without(Side::Back, -0.006), 0.025);
    let (x, y, z) = (door.low.x + 0.06, door.center().y + door.height() * 0.18, door.high.z);
    let lever = [
        DVec3::new(x, y, z - SINK),
        DVec3::new(x, y, z + REACH - 0.008),
        DVec3::new(x, y - 0.13, z + REACH - 0.008),
        DVec3::new(x, y - 0.15, z + REACH * 0.4),
    ];
    builder.add(Slot::Chrome, sweep(&lever, 0.008, 6));
    let plate = Bay::around(DVec3::new(x, y, z), 0.034, 0.06, 0.006);
    builder.cuboid(Slot::Chrome, plate);
    if form.is_multiple_of(2) {
        for row in [-0.02, 0.0, 0.02] {
            let strip =
                Bay::around(DVec3::new(0.0, door.low.y + 0.1 + row, z), door.width() * 0.8, 0.008, 0.004);
            builder.cuboid(Slot::Chrome, strip);
        }
    }
    let badge = Bay::around(DVec3::new(door.width() * 0.16, door.high.y - 0.07, z), 0.12, 0.018, 0.004);
    builder.cuboid(Slot::Chrome, badge);
}

/// A white or dark box with a thick door, a grip cut into its upper edge, a worktop of plastic.
fn budget(builder: &mut Builder, form: usize) {
    let slot = [Slot::Appliance, Slot::PlasticDark, Slot::Appliance, Slot::Metal][form];
    let door = body(builder, slot, if form == 3 { 0.014 } else { 0.0 });
    let is_split = form == 2;
    let split = if is_split { door.height() * 0.3 } else { 0.0 };
    let lower = door.without(Side::Above, split + 0.03);
    builder.cuboid(slot, lower);
    if is_split {
        builder.cuboid(slot, door.slab(Side::Above, split));
    } else {
        builder.cuboid(Slot::PlasticDark, door.slab(Side::Above, 0.026).inset(0.002, 0.0, 0.002));
    }
    if form == 3 {
        let at = DVec3::new(door.low.x + 0.04, lower.center().y, door.high.z);
        handle(builder, Slot::PlasticDark, HandleForm { kind: HandleKind::Upright, length: 0.16 }, at, 0.014);
    }
    let badge = Bay::around(DVec3::new(0.0, lower.high.y - 0.03, door.high.z), 0.07, 0.012, 0.002);
    builder.cuboid(Slot::MetalDark, badge);
}
