//! Kitchen units.

use glam::DVec3;

use super::ovens::{hob, hob_height, oven_front};
use super::parts::{Fittings, LegKind, REVEAL, Tap, legs_at_corners, slab_top, tap};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft, loft_ring};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a worktop (usual ones: 0.02-0.04).
const TOP: f64 = 0.04;
/// Metres of a toe kick's height and depth (EN 1116: 0.10-0.15 high, 0.05 deep).
const TOE: [f64; 2] = [0.1, 0.05];
/// Metres of a working surface over the floor, where a box is higher for a tap's sake.
const WORKING_HEIGHT: f64 = 0.9;
/// Metres by which the rim of a basin stands over the top.
const RIM: f64 = 0.004;
/// Boxes over this height, in metres, have their working surface below the top.
const HIGH_FROM: f64 = 1.0;
/// Metres from the top down to where a carcass with a basin in it begins.
const BASIN_ROOM: f64 = 0.21;
/// Metres of the groove over fronts without handles.
const GROOVE: f64 = 0.025;

/// Fronts, worktop and handles of a kitchen of a set and look.
struct Kitchen {
    fittings: Fittings,
    top: Slot,
    carcass: Slot,
    thickness: f64,
}

fn kitchen(draft: &Draft) -> Kitchen {
    let look = draft.form();
    let fittings = |front, handle, reach, is_traditional| Fittings { front, handle, reach, is_traditional };
    match draft.set() {
        GeometrySet::Plain => Kitchen {
            fittings: fittings(
                [Slot::Laminate, Slot::Painted, Slot::Wood, Slot::Painted][look],
                Slot::MetalDark,
                0.0,
                false,
            ),
            top: [Slot::Stone, Slot::Wood, Slot::Stone, Slot::Concrete][look],
            carcass: Slot::Laminate,
            thickness: [0.03, 0.04, 0.02, 0.04][look],
        },
        GeometrySet::Traditional => Kitchen {
            fittings: fittings(
                [Slot::Painted, Slot::Wood, Slot::PaintedAccent, Slot::WoodDark][look],
                Slot::Brass,
                0.024,
                true,
            ),
            top: [Slot::Wood, Slot::Stone, Slot::WoodDark, Slot::Stone][look],
            carcass: [Slot::Painted, Slot::Wood, Slot::PaintedAccent, Slot::WoodDark][look],
            thickness: 0.04,
        },
        GeometrySet::Industrial => Kitchen {
            fittings: fittings(
                [Slot::Wood, Slot::Metal, Slot::WoodDark, Slot::MetalDark][look],
                Slot::MetalDark,
                0.03,
                false,
            ),
            top: [Slot::Wood, Slot::Metal, Slot::WoodDark, Slot::Concrete][look],
            carcass: Slot::MetalDark,
            thickness: [0.05, 0.03, 0.06, 0.05][look],
        },
        GeometrySet::Budget => Kitchen {
            fittings: fittings(
                [Slot::Laminate, Slot::Plastic, Slot::WoodLight, Slot::Laminate][look],
                Slot::Metal,
                0.022,
                false,
            ),
            top: [Slot::Laminate, Slot::WoodLight, Slot::Laminate, Slot::Stone][look],
            carcass: Slot::Laminate,
            thickness: 0.028,
        },
    }
}

/// A base unit of a kitchen: carcass, toe kick, front and top; with a `sink`, a `hob`, an `oven` or `drawers`, or a
/// `filler` between a unit and a wall.
/// Handleless, with framed fronts, an open frame of steel, or of thin board with an edge strip.
pub(super) static WORKTOP: Recipe = Recipe::furniture("worktop", [0.9, 0.6, 0.9])
    .with(&[("drawers", 0.0), ("filler", 0.0), ("hob", 0.0), ("oven", 0.0), ("sink", 0.0)])
    .symbol_where("sink", Symbol::Basin)
    .every_set(worktop);

fn worktop(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let kitchen = kitchen(draft);
    let work = if bay.height() > HIGH_FROM { WORKING_HEIGHT } else { bay.height() };
    // What lies on the top is part of the box.
    let work = if draft.is_set("hob") {
        work - hob_height(draft.set())
    } else if draft.is_set("sink") {
        work - RIM
    } else {
        work
    };
    let top = bay.with_y([work - kitchen.thickness.min(TOP.max(kitchen.thickness)).min(work * 0.2), work]);
    if draft.is_set("sink") {
        sink(draft, builder, kitchen.top, top, bay);
    } else {
        board(draft, builder, kitchen.top, top);
    }
    if draft.is_set("hob") {
        hob(draft, builder, top);
    }
    if draft.is_set("filler") {
        return filler(builder, &kitchen, bay.with_y([0.0, top.low.y + SINK]));
    }
    if draft.set() == GeometrySet::Industrial && !draft.is_set("oven") {
        open_unit(draft, builder, &kitchen, bay.with_y([0.0, top.low.y + SINK]));
        return;
    }
    let toe = TOE[0].min(work * 0.2);
    let body = bay.with_y([toe, top.low.y + SINK]).inset(0.001, 0.0, 0.001);
    foot(draft, builder, &kitchen, body, toe);
    // The basin hangs in the carcass, which is lower there.
    let room = BASIN_ROOM.min(work * 0.3);
    if draft.is_set("sink") {
        kitchen.fittings.carcass(builder, kitchen.carcass, body.without(Side::Above, room - 0.01));
        apron(builder, &kitchen, body, room);
    } else {
        kitchen.fittings.carcass(builder, kitchen.carcass, body);
    }
    unit_fronts(draft, builder, &kitchen.fittings, body);
}

/// A panel in line with the fronts, over a toe kick.
fn filler(builder: &mut Builder, kitchen: &Kitchen, bay: Bay) {
    let toe = TOE[0].min(bay.height() * 0.2);
    // Narrower than the board above by less than one sees: its ends and theirs would lie in one plane.
    let front = bay.without(Side::Front, kitchen.fittings.reach).inset(0.0004, 0.0, 0.0);
    let thickness = kitchen.fittings.depth() - kitchen.fittings.reach;
    builder.cuboid(kitchen.fittings.front, front.with_y([toe, bay.high.y]).slab(Side::Front, thickness));
    builder.cuboid(
        Slot::PlasticDark,
        bay.with_y([0.0, toe + SINK]).without(Side::Front, TOE[1]).slab(Side::Front, thickness),
    );
}

/// The worktop: chamfered, moulded, or with an edge strip.
fn board(draft: &Draft, builder: &mut Builder, slot: Slot, top: Bay) {
    if draft.set() == GeometrySet::Budget {
        builder.cuboid(slot, top.without(Side::Front, 0.003 - SINK).inset(0.0, 0.0, 0.0));
        builder.block(Slot::PlasticDark, top.slab(Side::Front, 0.003).inset(0.0, 0.0004, 0.0), 0.0008);
        return;
    }
    slab_top(builder, slot, top, draft.is_traditional());
}

/// The toe kick, or a plinth with blocks at its ends.
fn foot(draft: &Draft, builder: &mut Builder, kitchen: &Kitchen, body: Bay, toe: f64) {
    let kick = body.with_y([0.0, toe + SINK]).without(Side::Front, TOE[1]).inset(0.002, 0.0, 0.002);
    let slot = if draft.set() == GeometrySet::Budget { Slot::Laminate } else { Slot::PlasticDark };
    builder.cuboid(if draft.is_traditional() { kitchen.carcass } else { slot }, kick);
    if draft.is_traditional() {
        let front = body.with_y([0.001, toe + SINK]).without(Side::Front, 0.03).slab(Side::Front, 0.05);
        for side in [Side::Left, Side::Right] {
            builder.block(kitchen.carcass, front.slab(side, 0.05).inset(0.001, 0.0, 0.0), 0.006);
        }
    }
}

/// The parts of a carcass around a basin: a rail in front, sides and a back.
fn apron(builder: &mut Builder, kitchen: &Kitchen, body: Bay, room: f64) {
    let slot = kitchen.carcass;
    let apron = body
        .inset(0.0004, 0.0, 0.0)
        .without(Side::Back, 0.0004)
        .slab(Side::Above, room)
        .without(Side::Front, kitchen.fittings.depth() - SINK);
    builder.cuboid(slot, apron.slab(Side::Front, 0.02).inset(SINK, 0.0, 0.0));
    for side in [Side::Left, Side::Right, Side::Back] {
        let (inset, behind) = if side == Side::Back { (0.0155, 0.0) } else { (0.0, 0.0003) };
        let piece = apron.without(Side::Front, 0.02 - SINK).slab(side, 0.016).without(Side::Back, behind);
        builder.cuboid(slot, piece.inset(inset, SINK / 2.0, 0.0));
    }
}

fn unit_fronts(draft: &Draft, builder: &mut Builder, fittings: &Fittings, body: Bay) {
    let face = body.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0).without(Side::Above, REVEAL);
    if draft.is_set("oven") {
        oven_front(draft, builder, face);
        return;
    }
    let is_handleless = draft.set() == GeometrySet::Plain;
    let face = if is_handleless { face.without(Side::Above, GROOVE) } else { face };
    if is_handleless {
        groove(builder, fittings, face.with_y([face.high.y, face.high.y + GROOVE]));
    }
    if draft.is_set("drawers") {
        drawers(draft, builder, fittings, face);
        return;
    }
    let count = (body.width() / 0.5).round().clamp(1.0, 6.0) as u32;
    let has_drawer = !draft.is_set("sink") && draft.input.look.is_multiple_of(2);
    let doors = if has_drawer { face.without(Side::Above, 0.15) } else { face };
    for (index, column) in doors.columns(count, REVEAL).into_iter().enumerate() {
        let hinge = if index % 2 == 0 { Side::Left } else { Side::Right };
        fittings.door(builder, column, hinge, 0.85);
        if has_drawer {
            let drawer =
                column.with_y([doors.high.y + if is_handleless { GROOVE } else { REVEAL }, face.high.y]);
            fittings.drawer(builder, drawer);
        }
    }
    if has_drawer && is_handleless {
        groove(builder, fittings, face.with_y([doors.high.y, doors.high.y + GROOVE]));
    }
}

/// A dark hollow to reach into behind the upper edge of fronts.
fn groove(builder: &mut Builder, fittings: &Fittings, bay: Bay) {
    let back = bay.without(Side::Front, fittings.depth() - 0.004).slab(Side::Front, 0.008);
    builder.cuboid(Slot::MetalDark, back.inset(0.001, -0.001, 0.0));
}

/// Drawers: the lower ones deeper.
fn drawers(draft: &Draft, builder: &mut Builder, fittings: &Fittings, face: Bay) {
    let count = draft.count("drawers", 3);
    let gap = if draft.set() == GeometrySet::Plain { GROOVE } else { REVEAL };
    let wide = face.width() > 1.2;
    for column in face.columns(if wide { 2 } else { 1 }, REVEAL) {
        let rows = column.rows(count, gap);
        for (index, row) in rows.iter().enumerate() {
            // Half of the top row's share goes to the lowest one.
            let give = if count == 3 { row.height() * 0.3 } else { 0.0 };
            let row = match (index, count) {
                (0, 3) => row.with_y([row.low.y, row.high.y + give]),
                (1, 3) => row.moved(0.0, give, 0.0),
                (2, 3) => row.with_y([row.low.y + give, row.high.y]),
                _ => *row,
            };
            fittings.drawer(builder, row);
            if gap > REVEAL && index > 0 {
                groove(builder, fittings, row.with_y([row.low.y - GROOVE, row.low.y]));
            }
        }
    }
}

/// A frame of square steel with a shelf of slats, boxes or pots on it, and a drawer under the top.
fn open_unit(draft: &Draft, builder: &mut Builder, kitchen: &Kitchen, bay: Bay) {
    let thick = 0.04_f64.min(bay.width() * 0.1);
    let look = draft.form();
    let frame = bay.inset(0.008, 0.0, 0.012);
    legs_at_corners(builder, kitchen.carcass, frame, thick, LegKind::Square);
    let shelves: &[f64] = if look.is_multiple_of(2) { &[0.16] } else { &[0.16, 0.48] };
    for &rise in shelves {
        let y = bay.high.y * rise;
        for side in [Side::Front, Side::Back] {
            let rail = frame.slab(side, thick * 0.8).inset(0.002, 0.0, 0.001);
            builder.cuboid(kitchen.carcass, rail.with_y([y - thick * 0.8, y]));
        }
        let shelf = frame.inset(thick * 0.3, 0.0, 0.003).with_y([y - SINK, y + 0.016]);
        let slats = (shelf.width() / 0.12).round().clamp(2.0, 14.0) as u32;
        for slat in shelf.columns(slats, 0.014) {
            builder.cuboid(if look == 1 { Slot::Metal } else { Slot::Wood }, slat);
        }
        pots(
            builder,
            shelf.with_y([shelf.high.y, bay.high.y * (rise + 0.26)]).inset(thick, 0.0, thick),
            look,
        );
    }
    if draft.is_set("sink") {
        return;
    }
    let drawer =
        frame.slab(Side::Above, 0.15).inset(thick - 0.004, 0.0, 0.0).without(Side::Back, thick + 0.01);
    builder.cuboid(
        kitchen.carcass,
        drawer
            .without(Side::Front, kitchen.fittings.depth() - SINK)
            .without(Side::Above, 0.004)
            .without(Side::Below, 0.004),
    );
    let count = (drawer.width() / 0.6).round().clamp(1.0, 4.0) as u32;
    let face = drawer.inset(0.006, 0.0, 0.0).without(Side::Above, 0.006);
    face.columns(count, 0.006).into_iter().for_each(|column| kitchen.fittings.drawer(builder, column));
}

/// Pots and a crate on a shelf.
fn pots(builder: &mut Builder, room: Bay, look: usize) {
    let radius = (room.width() * 0.16).min(room.depth() * 0.36).min(0.12);
    let tall = room.height().min(radius * 1.3);
    for (index, share) in [-0.3, 0.08].into_iter().enumerate() {
        let size = if index == 0 { 1.0 } else { 0.78 };
        let (radius, tall, y) = (radius * size, tall * size, room.low.y - SINK);
        let pot = [
            (radius * 0.94, y),
            (radius, y + tall * 0.06),
            (radius, y + tall),
            (radius * 0.94, y + tall),
            (radius * 0.9, y + tall * 0.1),
        ];
        let x = share * room.width();
        builder.add([Slot::Metal, Slot::Ceramic][(look / 2 + index) % 2], lathe(&pot, 12).moved(x, 0.0, 0.0));
        let grip = Bay::around(DVec3::new(x, y + tall * 0.8, 0.0), radius * 2.4, 0.012, radius * 0.4);
        builder.cuboid(Slot::MetalDark, grip);
    }
    let crate_bay =
        Bay::around(DVec3::new(room.width() * 0.36, 0.0, 0.0), room.width() * 0.2, 1.0, room.depth() * 0.8);
    builder.block(
        Slot::WoodLight,
        crate_bay.with_y([room.low.y - SINK * 0.6, room.low.y + tall * 0.8]),
        0.004,
    );
}

/// A worktop with a basin and a drainer let into it, and a tap where the box reaches over the top.
fn sink(draft: &Draft, builder: &mut Builder, slot: Slot, top: Bay, bay: Bay) {
    let half = top.extent() / 2.0;
    let hole = [half.x * 0.5, (half.z - 0.09).max(half.z * 0.4)];
    let side = if draft.input.look.is_multiple_of(2) { -1.0 } else { 1.0 };
    let (across, forward) = (side * half.x * 0.3, 0.02);
    let inner = |y: f64| Slice::new(y, hole[0], hole[1]).at(across, forward);
    let outer = |y: f64| Slice::new(y, half.x, half.z);
    let slices = [outer(top.low.y), outer(top.high.y), inner(top.high.y), inner(top.low.y)];
    builder.add(slot, loft_ring(&Outline::Square, &slices));
    let depth = 0.16_f64.min(bay.height() * 0.18);
    let rim = |y: f64, x: f64| Slice::new(y, hole[0] + x, hole[1] + x).at(across, forward).softened(0.03);
    let high = top.high.y + RIM;
    let low = high - depth + 0.004;
    // Down the outside, over the rim onto the top, and down the inside.
    let basin = [
        rim(high - depth, -0.012),
        rim(top.high.y - 0.001, -0.001),
        rim(top.high.y - SINK, 0.012),
        rim(high, 0.012),
        rim(high, -0.004),
        rim(low + 0.02, -0.016),
        rim(low, -0.035),
    ];
    let metal = if draft.is_traditional() { Slot::Ceramic } else { Slot::Metal };
    builder.add(metal, loft(&Outline::Soft(2), &basin));
    let strainer = [(0.04, low - SINK), (0.04, low + 0.002), (0.02, low + 0.004)];
    builder.add(Slot::Chrome, lathe(&strainer, 10).moved(across, 0.0, forward));
    drainer(builder, metal, top, [across + side * hole[0], side, hole[1]], forward);
    if bay.high.y - top.high.y > 0.08 {
        let foot = DVec3::new(0.0, top.high.y, forward - hole[1] - 0.035);
        let height = bay.high.y - top.high.y;
        tap(builder, draft.set(), Tap { foot, height, reach: bay.depth() * 0.2 });
    }
}

/// Grooves beside a basin; `edge` is where the basin ends, which way the drainer lies, and half its depth.
fn drainer(builder: &mut Builder, slot: Slot, top: Bay, [_, side, deep]: [f64; 3], forward: f64) {
    let (inner, outer) = (top.width() * 0.5 * 0.24, top.width() * 0.5 - 0.02);
    let x = if side < 0.0 { [inner, outer] } else { [-outer, -inner] };
    let y = top.high.y;
    let plate = Bay::new(x, [y - SINK, y + RIM * 0.4], [forward - deep, forward + deep]);
    builder.cuboid(slot, plate);
    for rib in plate.inset(0.015, 0.0, 0.02).columns(5, plate.width() * 0.09) {
        builder.cuboid(slot, rib.with_y([y, y + RIM * 0.85]));
    }
}
