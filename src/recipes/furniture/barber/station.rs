//! Places before a mirror at the hairdresser's: boards 0.75 to 0.8 m over the floor, mirrors 1.0 to 1.2 m tall.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    HandleForm, HandleKind, LegKind, ball, cornice, handle, leg, slab_top, turned_forward,
};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Share of the height at which bottles and combs lie.
const BOARD: f64 = 0.42;

/// A tall mirror over a narrow board: on a panel; arched over a console; in a frame of pipe; without a frame, with a lamp.
pub(in super::super) static MIRROR_STATION: Recipe =
    Recipe::furniture("mirror_station", [1.0, 0.35, 1.9]).symbol(Symbol::Basin).every_set(mirror_station);

fn mirror_station(draft: &Draft, builder: &mut Builder) {
    match draft.set() {
        GeometrySet::Plain => {
            let wood = draft.sampler().pick(&[Slot::WoodDark, Slot::Painted]);
            panel(builder, wood);
        }
        GeometrySet::Traditional => {
            console(builder, [Slot::WoodDark, Slot::Wood][draft.input.look as usize % 2])
        }
        GeometrySet::Industrial => pipes(builder),
        GeometrySet::Budget => frameless(builder),
    }
    let bay = builder.bay();
    for (place, slot) in [(-0.3, Slot::Plastic), (-0.2, Slot::PaintedAccent), (0.3, Slot::Glass)] {
        let bottle = cylinder(0.025, [-SINK, 0.16], 10);
        let board = bay.without(Side::Back, 0.04).center();
        builder.add(slot, bottle.moved(bay.width() * place, bay.high.y * BOARD, board.z));
    }
}

fn panel(builder: &mut Builder, wood: Slot) {
    let bay = builder.bay();
    let panel = bay.slab(Side::Back, 0.04);
    builder.block(wood, panel, 0.004);
    let glass = panel.inset(0.06, 0.0, 0.0).with_y([bay.high.y * 0.45, bay.high.y - 0.06]);
    builder.cuboid(Slot::Mirror, glass.with_z([panel.high.z - SINK, panel.high.z + 0.005]));
    let top = bay.high.y * BOARD;
    let board = bay.with_y([top - 0.04, top]).without(Side::Back, 0.04 - SINK);
    builder.block(wood, board, 0.006);
    let drawer = board.inset(0.03, 0.0, 0.0).without(Side::Front, 0.06);
    builder.block(Slot::Painted, drawer.with_y([board.low.y - 0.14, board.low.y + SINK]), 0.004);
}

/// An arched mirror between pilasters, over a console on turned legs with two drawers; lamps at both sides.
fn console(builder: &mut Builder, wood: Slot) {
    let bay = builder.bay();
    let (high, top) = (bay.high.y, bay.high.y * BOARD);
    slab_top(builder, wood, bay.with_y([top - 0.03, top]).without(Side::Back, 0.001), true);
    let apron = bay.inset(0.05, 0.0, 0.02).with_y([top - 0.17, top - 0.03 + SINK]);
    builder.cuboid(wood, apron);
    for drawer in apron.inset(0.02, 0.016, 0.0).columns(2, 0.02) {
        let front = drawer.with_z([apron.high.z - SINK, apron.high.z + 0.008]);
        builder.block(Slot::Wood, front, 0.004);
        let at = DVec3::new(front.center().x, front.center().y, front.high.z);
        handle(builder, Slot::Brass, HandleForm { kind: HandleKind::Knob, length: 0.0 }, at, 0.011);
    }
    let legs = apron.with_y([0.0, apron.low.y + SINK]).inset(0.004, 0.0, 0.004);
    for x in [[legs.low.x, legs.low.x + 0.06], [legs.high.x - 0.06, legs.high.x]] {
        leg(builder, wood, legs.with_x(x).slab(Side::Front, 0.06), LegKind::Turned);
        builder.cuboid(wood, legs.with_x(x).slab(Side::Back, 0.05).inset(0.004, 0.0, 0.0));
    }
    let back = bay.slab(Side::Back, 0.05).with_y([top - SINK, high]);
    let crown = 0.06;
    cornice(builder, wood, back.slab(Side::Above, crown), 0.02);
    let field = back.without(Side::Above, crown - SINK).inset(0.025, 0.0, 0.0);
    builder.cuboid(wood, field.slab(Side::Back, 0.02).inset(0.002, 0.0, 0.0).moved(0.0, 0.0, 0.001));
    for side in [Side::Left, Side::Right] {
        builder.block(wood, field.slab(side, 0.07).without(Side::Back, 0.002), 0.008);
    }
    arched_glass(builder, field.inset(0.11, 0.03, 0.0), field.low.z + 0.02);
    for x in [-0.44, 0.44] {
        let at = DVec3::new(x * bay.width(), high * 0.74, back.high.z);
        let arm = [at, at + DVec3::new(0.0, -0.03, 0.05), at + DVec3::new(0.0, 0.04, 0.07)];
        builder.add(Slot::Brass, sweep(&arm, 0.006, 6));
        let bulb = ball(0.035, 8);
        builder.add(Slot::Lamp, bulb.moved(at.x, at.y + 0.07, at.z + 0.07));
    }
}

/// A mirror with a round head, in a moulding of brass.
fn arched_glass(builder: &mut Builder, field: Bay, surface: f64) {
    let arch = |inset: f64| {
        let half = field.width() / 2.0 - inset;
        // A wide field has a flat arch.
        let rise = (field.width() / 2.0).min(field.height() * 0.5);
        let spring = field.high.y - rise;
        let mut profile = vec![DVec2::new(half, field.low.y + inset), DVec2::new(half, spring)];
        profile.extend((1..8).map(|step| {
            let (sine, cosine) = libm::sincos(std::f64::consts::PI * f64::from(step) / 8.0);
            DVec2::new(cosine * half, spring + sine * (rise - inset))
        }));
        profile.extend([DVec2::new(-half, spring), DVec2::new(-half, field.low.y + inset)]);
        profile
    };
    builder.add(Slot::Brass, extrude(&arch(0.0), Axis::Z, [surface - SINK, surface + 0.016]));
    builder.add(Slot::Mirror, extrude(&arch(0.02), Axis::Z, [surface - SINK, surface + 0.019]));
}

/// A frame of pipe on flanges with a thick plank, a mirror that hangs in it and bare bulbs above.
fn pipes(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, top, tube) = (bay.high.y, bay.high.y * BOARD, 0.021);
    let (x, back) = (bay.high.x - 0.045, bay.low.z + 0.045);
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let upright = [at(x, 0.004, back), at(x, high - tube, back)];
    builder.add_pair(Slot::MetalDark, sweep(&upright, tube, 8));
    builder
        .add(Slot::MetalDark, sweep(&[at(-x, high - tube, back), at(x, high - tube, back)], tube * 0.96, 8));
    builder.add_pair(Slot::MetalDark, cylinder(0.045, [0.0, 0.012], 10).moved(x, 0.0, back));
    let front = bay.high.z - 0.045;
    let bracket = [at(x, 0.004, front), at(x, top - 0.07, front), at(x, top - 0.07, back)];
    builder.add_pair(Slot::MetalDark, sweep(&bracket, tube * 0.98, 8));
    builder.add_pair(Slot::MetalDark, cylinder(0.045, [0.0, 0.012], 10).moved(x, 0.0, front));
    let plank = bay.with_y([top - 0.05, top]);
    builder.block(Slot::Wood, plank, 0.006);
    let glass = Bay::new([-x * 0.78, x * 0.78], [high * 0.48, high * 0.9], [back - 0.012, back + 0.012]);
    builder.block(Slot::MetalDark, glass.inset(-0.015, -0.015, 0.0), 0.004);
    builder.cuboid(Slot::Mirror, glass.with_z([glass.high.z - SINK, glass.high.z + 0.003]));
    for side in [-1.0, 1.0] {
        for y in [0.55, 0.83] {
            let ends = [at(side * x, high * y, back), at(side * x * 0.79, high * y, back)];
            builder.add(Slot::Metal, sweep(&ends, 0.01, 6));
        }
    }
    for share in [-0.6, -0.2, 0.2, 0.6] {
        let lamp = lathe(&[(0.016, 0.0), (0.016, 0.035), (0.03, 0.07), (0.0, 0.1)], 8);
        let at = DVec3::new(x * share, high - tube * 2.6, back + 0.05);
        builder.add(Slot::Lamp, turned_forward(lamp).moved(at.x, at.y, at.z - 0.04));
        builder.cuboid(Slot::Brass, Bay::around(DVec3::new(at.x, at.y, back + 0.012), 0.04, 0.05, 0.03));
    }
    let rod = [at(-x, top * 0.45, back), at(x, top * 0.45, back)];
    builder.add(Slot::MetalDark, sweep(&rod, tube * 0.8, 6));
}

/// A mirror with round corners without a frame, a bar of light over it, a thin shelf with a holder for the dryer.
fn frameless(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, top) = (bay.high.y, bay.high.y * BOARD);
    let wall = bay.slab(Side::Back, 0.018);
    builder.block(Slot::Laminate, wall.inset(bay.width() * 0.08, 0.0, 0.0), 0.003);
    let glass =
        Bay::new([-0.34, 0.34], [high * 0.47, high * 0.93], [wall.high.z - SINK, wall.high.z + 0.012]);
    let glass = glass.with_x([-bay.width() * 0.34, bay.width() * 0.34]);
    builder.rounded(Slot::Mirror, glass, DVec3::new(0.12, 0.12, 0.004), 3);
    let lamp = bay.slab(Side::Above, 0.05).with_z([wall.high.z - SINK, wall.high.z + 0.05]);
    builder.block(Slot::Metal, lamp.slab(Side::Above, 0.02).inset(bay.width() * 0.14, 0.0, 0.0), 0.003);
    let tube = lamp.inset(bay.width() * 0.16, 0.0, 0.01).without(Side::Above, 0.02 - SINK);
    builder.cushion(Slot::Lamp, tube, 0.012);
    let shelf = bay.with_y([top - 0.018, top]).without(Side::Back, wall.depth() - SINK);
    builder.block(Slot::Laminate, shelf, 0.002);
    for side in [Side::Left, Side::Right] {
        let gusset = shelf.inset(bay.width() * 0.18, 0.0, 0.0).slab(side, 0.016);
        let (back, front) = (shelf.low.z, shelf.low.z + shelf.depth() * 0.8);
        let profile = [(back, top - 0.2), (front, top - 0.018 + SINK), (back, top - 0.018 + SINK)];
        builder.add(Slot::Metal, extrude(&profile.map(DVec2::from), Axis::X, gusset.x()));
    }
    let ring = DVec3::new(bay.width() * 0.4, top - 0.03, bay.high.z - 0.08);
    let bow = [(-0.05, 0.0), (-0.05, -0.06), (0.05, -0.06), (0.05, 0.0)]
        .map(|(x, y)| ring + DVec3::new(x, y + 0.02, 0.0));
    builder.add(Slot::Metal, sweep(&bow, 0.005, 6));
    let rest = bay
        .slab(Side::Below, 0.12)
        .inset(bay.width() * 0.26, 0.0, 0.0)
        .with_z([wall.high.z - SINK, bay.high.z - 0.06]);
    builder.cuboid(Slot::Metal, rest.slab(Side::Above, 0.02));
}
