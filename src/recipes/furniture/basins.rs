//! Washbasins and vanities.

use glam::DVec3;

use super::parts::{Fittings, LegKind, REVEAL, Tap, legs_at_corners, slab_top, tap};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a rim over the floor where a box is higher for the tap's sake is the box less this share of its
/// height, and at most [`TAP`].
const TAP_SHARE: f64 = 0.3;
/// Metres of a basin's tap.
const TAP: f64 = 0.13;
/// Metres under a basin from which something carries it from the floor.
const CARRIED_FROM: f64 = 0.3;

/// The tap on the ledge behind a basin.
fn ledge_tap(draft: &Draft, builder: &mut Builder, rim: f64, height: f64) {
    let bay = builder.bay();
    let foot = DVec3::new(0.0, rim, bay.low.z + 0.05_f64.min(bay.depth() * 0.14));
    tap(builder, draft.set(), Tap { foot, height, reach: (bay.depth() * 0.3).min(0.15) });
}

/// A basin: on a pedestal, over a trap, on legs, or on a bracket, by set and look.
pub(super) static WASHBASIN: Recipe =
    Recipe::furniture("washbasin", [0.55, 0.45, 0.95]).symbol(Symbol::Basin).every_set(washbasin);

fn washbasin(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let tap_height = (bay.height() * TAP_SHARE).min(TAP);
    let rim = bay.high.y - tap_height;
    let depth = (rim * 0.5).min(0.16);
    let (slot, corner) = bowl_of(draft);
    let body = bay.with_y([rim - depth, rim]);
    basin(builder, slot, body, corner, 0.22);
    if draft.is_traditional() {
        // No deeper than what stands on the rim keeps off the wall.
        let splash =
            body.slab(Side::Back, 0.0045).with_y([rim - 0.02, rim + 0.035_f64.min(tap_height * 0.3)]);
        let round = bay.width().min(bay.depth()) / 2.0 * corner;
        builder.cuboid(Slot::Ceramic, splash.inset(round, 0.0, 0.0004));
    }
    ledge_tap(draft, builder, rim, tap_height);
    let low = rim - depth;
    if low >= CARRIED_FROM {
        carrier(draft, builder, low, depth);
    } else if low > 0.01 {
        waste(builder, DVec3::new(0.0, low + depth * 0.1, 0.0), bay.low.z, Slot::Chrome);
    }
}

/// Material of a bowl, and how round its corners are: 1 for a round bowl.
fn bowl_of(draft: &Draft) -> (Slot, f64) {
    let look = draft.form();
    match draft.set() {
        GeometrySet::Industrial => ([Slot::Metal, Slot::Concrete, Slot::Metal, Slot::Stone][look], 0.02),
        GeometrySet::Budget => (Slot::Ceramic, [0.75, 0.4, 0.6, 0.2][look]),
        GeometrySet::Traditional => (Slot::Ceramic, [0.3, 0.6, 0.3, 0.6][look]),
        GeometrySet::Plain => (Slot::Ceramic, [0.08, 0.9, 0.08, 0.5][look]),
    }
}

/// What carries a bowl whose underside is at a height, or the pipes under one that the wall carries.
fn carrier(draft: &Draft, builder: &mut Builder, low: f64, depth: f64) {
    let under = builder.bay().with_y([0.0, low + depth * 0.3]);
    match (draft.set(), draft.form()) {
        (GeometrySet::Plain, 0 | 1) | (GeometrySet::Budget, 0 | 1) => pedestal(builder, under, depth),
        (GeometrySet::Traditional, 0 | 1) => turned_pedestal(builder, under),
        (GeometrySet::Plain, 2) => console(builder, under, Slot::MetalDark, LegKind::Square),
        (GeometrySet::Traditional, _) => console(builder, under, Slot::Brass, LegKind::Round),
        (GeometrySet::Industrial, _) => frame(builder, under),
        (GeometrySet::Budget, _) => bare_pipes(builder, Slot::Plastic, low, depth),
        (GeometrySet::Plain, _) => bare_pipes(builder, Slot::Chrome, low, depth),
    }
}

/// A trap, and the pipes of the tap, which come up from the floor.
fn bare_pipes(builder: &mut Builder, slot: Slot, low: f64, depth: f64) {
    let bay = builder.bay();
    waste(builder, DVec3::new(0.0, low + depth * 0.2, bay.depth() * 0.1), bay.low.z, slot);
    for x in [-0.04, 0.04] {
        let z = bay.low.z + 0.03;
        let pipe = cylinder(0.008, [0.001, low + depth * 0.5], 6);
        builder.add(slot, pipe.moved(x, 0.0, z));
        builder.add(slot, cylinder(0.016, [0.0, 0.012], 6).moved(x, 0.0, z));
    }
}

/// A bottle trap under a drain, and its pipe into the wall.
fn waste(builder: &mut Builder, drain: DVec3, wall: f64, slot: Slot) {
    let fall = (drain.y * 0.4).min(0.2);
    let bottle = drain.y - fall;
    builder.add(slot, cylinder(0.016, [bottle + 0.02, drain.y], 8).moved(drain.x, 0.0, drain.z));
    let cup =
        [(0.02, bottle - 0.05), (0.032, bottle - 0.04), (0.032, bottle + 0.02), (0.018, bottle + 0.035)];
    let cup = cup.map(|(radius, y)| (radius, y.max(radius * 0.1)));
    builder.add(slot, lathe(&cup, 10).moved(drain.x, 0.0, drain.z));
    let pipe = [DVec3::new(drain.x, bottle, drain.z), DVec3::new(drain.x, bottle, wall)];
    builder.add(slot, sweep(&pipe, 0.015, 8));
}

fn pedestal(builder: &mut Builder, under: Bay, depth: f64) {
    let (x, z) = (under.width() * 0.17, under.depth() * 0.22);
    let top = under.high.y;
    let slices = [
        Slice::new(0.0, x * 1.1, z),
        Slice::new(top * 0.04, x, z * 0.96),
        Slice::new(top * 0.55, x * 0.72, z * 0.85),
        Slice::new(top - depth * 0.3, x * 1.1, z * 1.05),
        Slice::new(top + depth * 0.1, x * 1.3, z * 1.1),
    ];
    let slices = slices.map(|slice| slice.at(0.0, under.low.z + z * 1.12));
    builder.add(Slot::Ceramic, loft(&Outline::Round(14), &slices));
}

/// A pedestal with a moulded foot and neck and eight sides.
fn turned_pedestal(builder: &mut Builder, under: Bay) {
    let (x, z) = (under.width() * 0.2, under.depth() * 0.24);
    let top = under.high.y;
    let profile = [
        (0.0, 1.1),
        (0.06, 1.1),
        (0.08, 0.95),
        (0.11, 0.95),
        (0.14, 0.66),
        (0.72, 0.56),
        (0.8, 0.62),
        (0.83, 0.8),
        (0.87, 0.8),
        (1.0, 1.2),
    ];
    let slices = profile
        .map(|(rise, share)| Slice::new(rise * top, x * share, z * share).at(0.0, under.low.z + z * 1.25));
    builder.add(Slot::Ceramic, loft(&Outline::Round(8), &slices).smooth(20.0));
}

/// Two legs before the wall with a rail for towels, and the waste.
fn console(builder: &mut Builder, under: Bay, slot: Slot, kind: LegKind) {
    let thick = 0.022;
    let room = under.inset(under.width() * 0.08, 0.0, 0.0).without(Side::Front, under.depth() * 0.1);
    let front = room.slab(Side::Front, thick);
    for side in [Side::Left, Side::Right] {
        super::parts::leg(builder, slot, front.slab(side, thick), kind);
        let stay = room.slab(side, thick * 0.6).without(Side::Front, thick * 0.5);
        let y = under.high.y * 0.86;
        builder.cuboid(
            slot,
            stay.moved(if side == Side::Left { 0.004 } else { -0.004 }, 0.0, 0.0)
                .with_y([y, y + thick * 0.6]),
        );
    }
    let (y, z) = (under.high.y * 0.7, front.center().z);
    let rail = [DVec3::new(front.low.x + 0.004, y, z), DVec3::new(front.high.x - 0.004, y, z)];
    builder.add(slot, sweep(&rail, 0.007, 6));
    waste(builder, DVec3::new(0.0, under.high.y, under.depth() * 0.08), under.low.z, slot);
}

/// A frame of square steel with a shelf of wood, and the waste.
fn frame(builder: &mut Builder, under: Bay) {
    let thick = 0.025;
    let room = under.inset(under.width() * 0.04, 0.0, 0.01);
    legs_at_corners(builder, Slot::MetalDark, room, thick, LegKind::Square);
    let y = under.high.y * 0.24;
    let shelf = room.inset(0.004, 0.0, 0.004).with_y([y, y + 0.02]);
    builder.cuboid(Slot::Wood, shelf);
    for side in [Side::Left, Side::Right] {
        let bar = room.slab(side, thick * 0.8).inset(0.0, 0.0, thick * 0.5);
        let inward = if side == Side::Left { 0.002 } else { -0.002 };
        builder.cuboid(Slot::MetalDark, bar.moved(inward, 0.0, 0.0).with_y([y - 0.018, y + 0.002]));
    }
    waste(builder, DVec3::new(0.0, under.high.y, under.depth() * 0.05), under.low.z, Slot::Chrome);
}

/// A basin with a hollow, an overflow, a drain and a ledge for the tap behind it, filling a bay; `corner` is the share of
/// its half depth by which its front is round, `floor` the share of the height at which the hollow ends.
fn basin(builder: &mut Builder, slot: Slot, bay: Bay, corner: f64, floor: f64) {
    let (half, middle) = (bay.extent() / 2.0, bay.center());
    let ledge = (bay.depth() * 0.2).min(0.1);
    let corner = (half.x.min(half.z) * corner).max(0.012);
    let y = |share: f64| bay.low.y + share * bay.height();
    let slice = |share: f64, shrink: f64| {
        Slice::new(y(share), half.x * shrink, half.z * shrink)
            .at(0.0, middle.z - half.z * (1.0 - shrink))
            .softened(corner * shrink)
            .softened_behind(0.012 * shrink)
    };
    let border = (bay.width() * 0.07).min(0.04);
    let hollow = |share: f64, shrink: f64| {
        let (x, z) = ((half.x - border) * shrink, (half.z - ledge / 2.0 - border * 0.6) * shrink);
        Slice::new(y(share), x, z).at(0.0, middle.z + ledge / 2.0).softened(corner * 0.8 * shrink)
    };
    let slices = [
        slice(0.0, 0.55),
        slice(0.4, 0.9),
        slice(0.7, 0.99),
        slice(0.96, 1.0),
        slice(1.0, 0.985),
        hollow(1.0, 1.0),
        hollow(0.92, 0.97),
        hollow(0.45 + floor * 0.5, 0.9),
        hollow(floor, if floor > 0.5 { 0.66 } else { 0.5 }),
    ];
    builder.add(slot, loft(&Outline::Soft(3), &slices));
    let drain = hollow(floor, 0.5);
    let radius = 0.022_f64.min(half.x * 0.15);
    let disc =
        lathe(&[(radius, drain.y - SINK), (radius, drain.y + 0.002), (radius * 0.6, drain.y + 0.005)], 10);
    builder.add(Slot::Chrome, disc.moved(drain.center.x, 0.0, drain.center.y));
}

/// A basin let into a cabinet: flush drawers on a plinth, framed doors on turned feet, an open frame, or plain doors.
pub(super) static VANITY: Recipe =
    Recipe::furniture("vanity", [0.8, 0.5, 0.95]).symbol(Symbol::Basin).every_set(vanity);

fn vanity(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let tap_height = (bay.height() * 0.18).min(0.14);
    let rim = bay.high.y - tap_height;
    let depth = 0.16_f64.min(rim * 0.25);
    let slot = if draft.set() == GeometrySet::Industrial { Slot::Stone } else { Slot::Ceramic };
    basin(builder, slot, bay.with_y([rim - depth, rim]), 0.12, 0.6);
    ledge_tap(draft, builder, rim, tap_height);
    let toe = (rim * 0.15).min(0.12);
    let body = bay.with_y([toe, rim - depth * 0.45]).inset(0.012, 0.0, 0.004);
    if draft.set() == GeometrySet::Industrial {
        open_vanity(draft, builder, body.with_y([0.0, body.high.y]));
        return;
    }
    let wood = match draft.set() {
        GeometrySet::Traditional => [Slot::Painted, Slot::WoodDark, Slot::PaintedAccent, Slot::Wood],
        GeometrySet::Budget => [Slot::Laminate, Slot::Painted, Slot::WoodLight, Slot::Laminate],
        _ => [Slot::Wood, Slot::Painted, Slot::WoodDark, Slot::Laminate],
    }[draft.form()];
    let fittings = match draft.set() {
        GeometrySet::Plain => {
            Fittings { front: wood, handle: Slot::MetalDark, reach: 0.0, is_traditional: false }
        }
        _ => Fittings {
            front: wood,
            handle: Slot::Chrome,
            reach: 0.022,
            is_traditional: draft.is_traditional(),
        },
    };
    let top = body.slab(Side::Above, 0.02).without(Side::Front, 0.002);
    let stone = if draft.set() == GeometrySet::Traditional { Slot::Stone } else { wood };
    slab_top(builder, stone, top, draft.is_traditional());
    let body = body.without(Side::Above, 0.02 - SINK).inset(SINK, 0.0, 0.0);
    fittings.carcass(builder, wood, body);
    let legs = body.with_y([0.0, toe + SINK]).inset(0.01, 0.0, 0.01).without(Side::Front, 0.04);
    match draft.set() {
        GeometrySet::Plain => builder
            .cuboid(Slot::PlasticDark, legs.without(Side::Front, legs.depth() * 0.3).inset(0.05, 0.0, 0.0)),
        GeometrySet::Traditional => legs_at_corners(builder, wood, legs, 0.05, LegKind::Tapered),
        _ => legs_at_corners(builder, Slot::Chrome, legs, 0.03, LegKind::Round),
    }
    vanity_fronts(draft, builder, &fittings, body.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0));
}

fn vanity_fronts(draft: &Draft, builder: &mut Builder, fittings: &Fittings, face: Bay) {
    let look = draft.input.look % 4;
    if draft.set() == GeometrySet::Plain {
        // A dark groove over each front to reach into instead of a handle.
        let rows = if look.is_multiple_of(2) { 2 } else { 1 };
        let columns = if look < 2 { 1 } else { 2 };
        for row in face.rows(rows, 0.0) {
            let groove = row.slab(Side::Above, 0.02).slab(Side::Front, 0.004);
            builder.cuboid(Slot::PlasticDark, groove.moved(0.0, -0.002, -0.0138).inset(0.001, 0.0, 0.0));
            for column in row.without(Side::Above, 0.024).columns(columns, REVEAL) {
                fittings.panel(builder, column);
            }
        }
        return;
    }
    if look.is_multiple_of(2) && face.width() < 0.85 {
        face.rows(2, REVEAL).into_iter().for_each(|row| fittings.drawer(builder, row));
        return;
    }
    let count = (face.width() / 0.42).round().clamp(1.0, 4.0) as u32;
    let doors = if look > 1 { face.without(Side::Below, face.height() * 0.3 + REVEAL) } else { face };
    if look > 1 {
        fittings.drawer(builder, face.slab(Side::Below, face.height() * 0.3));
    }
    for (index, column) in doors.columns(count, REVEAL).into_iter().enumerate() {
        fittings.door(builder, column, if index % 2 == 0 { Side::Left } else { Side::Right }, 0.75);
    }
}

/// A steel frame with a board under the basin, one near the floor, and the waste between.
fn open_vanity(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let thick = 0.03;
    let wood = [Slot::Wood, Slot::WoodDark, Slot::WoodLight, Slot::Metal][draft.form()];
    builder.block(wood, bay.slab(Side::Above, 0.04), 0.003);
    let room = bay.without(Side::Above, 0.04 - SINK).inset(0.01, 0.0, 0.01);
    legs_at_corners(builder, Slot::MetalDark, room, thick, LegKind::Square);
    for rise in [0.16, 0.5].into_iter().take(1 + draft.input.look as usize % 2) {
        let y = bay.high.y * rise;
        builder.cuboid(wood, room.inset(0.003, 0.0, 0.003).with_y([y, y + 0.025]));
        for side in [Side::Left, Side::Right] {
            let bar = room.slab(side, thick * 0.7).inset(0.0, 0.0, thick * 0.5);
            let inward = if side == Side::Left { 0.002 } else { -0.002 };
            builder.cuboid(Slot::MetalDark, bar.moved(inward, 0.0, 0.0).with_y([y - 0.025, y + 0.003]));
        }
    }
    if draft.input.look.is_multiple_of(2) {
        waste(builder, DVec3::new(0.0, bay.high.y - 0.02, 0.02), bay.low.z, Slot::Chrome);
    }
}
