//! Checkouts of shops: belts 0.4 to 0.5 m wide, 0.8 to 0.9 m over the floor; the cashier sits before a recess.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, across, legs_at_corners, slab_top, turned_forward};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Share of the height at which belt and scanner lie.
const WORK: f64 = 0.84;
/// Metres of the kick plate.
const KICK: f64 = 0.08;

/// A till place: a belt, a scanner, a bay to pack in and a screen on a post; a counter with panels and scales; rollers in a
/// frame; two boxes and a board.
pub(in super::super) static CHECKOUT: Recipe =
    Recipe::furniture("checkout", [2.2, 1.0, 0.95]).every_set(checkout);

fn checkout(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    match draft.set() {
        GeometrySet::Plain => {
            with_belt(builder, [Slot::Laminate, Slot::PaintedAccent, Slot::Metal, Slot::Wood][look])
        }
        GeometrySet::Traditional => panelled(builder, look),
        GeometrySet::Industrial => rollers(builder),
        GeometrySet::Budget => boxes(builder, look),
    }
}

fn with_belt(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let work = bay.height() * WORK;
    builder.cuboid(Slot::PlasticDark, bay.with_y([0.0, KICK + SINK]).inset(0.04, 0.0, 0.04));
    let body = bay.with_y([KICK, work]);
    let recess = [bay.width() * 0.02, bay.width() * 0.02 + body.width() * 0.26];
    counter(builder, slot, body, recess);
    let belt = Bay::new(
        [body.low.x + 0.03, recess[0] - 0.06],
        [work - SINK, work + 0.012],
        [bay.low.z + 0.08, bay.low.z + bay.depth() * 0.56],
    );
    conveyor(builder, belt, work);
    builder.cuboid(
        Slot::Metal,
        Bay::new([recess[0] - 0.04, recess[1] * 0.8], [work - SINK, work + 0.006], belt.z()),
    );
    builder.cuboid(
        Slot::Screen,
        Bay::new([recess[0], recess[1] * 0.62], [work + 0.005, work + 0.009], belt.inset(0.0, 0.0, 0.06).z()),
    );
    shopping(builder, belt, work);
    // The packing bay slopes to its end.
    let chute = [
        (recess[1] + 0.04, work + 0.05),
        (body.high.x - 0.03, work + 0.004),
        (body.high.x - 0.03, work - 0.01),
        (recess[1] + 0.04, work - 0.01),
    ]
    .map(DVec2::from);
    builder.add(Slot::Metal, extrude(&chute, Axis::Z, [bay.low.z + 0.07, bay.high.z - 0.07]));
    let post = DVec3::new(recess[1] * 0.7, work, bay.low.z + bay.depth() * 0.66);
    screen_on_post(builder, post, bay.high.y);
}

/// The body: closed towards the customers, who stand behind, with a recess for the cashier before it.
fn counter(builder: &mut Builder, slot: Slot, body: Bay, recess: [f64; 2]) {
    let bay = builder.bay();
    builder.block(slot, body.without(Side::Front, bay.depth() * 0.42).inset(0.0, 0.0, 0.001), 0.006);
    for ends in [[body.low.x, recess[0]], [recess[1], body.high.x]] {
        let part = body.slab(Side::Front, bay.depth() * 0.42 + 0.02).with_x(ends);
        builder.block(slot, part.inset(0.002, 0.001, 0.0), 0.006);
    }
    let work = body.high.y;
    builder.cuboid(
        Slot::Metal,
        bay.slab(Side::Back, 0.012).with_y([work * 0.3, work * 0.36]).inset(0.001, 0.0, 0.0),
    );
}

/// A belt between two rails.
fn conveyor(builder: &mut Builder, belt: Bay, work: f64) {
    builder.block(Slot::Rubber, belt, 0.004);
    for side in [Side::Front, Side::Back] {
        let rail = belt.slab(side, 0.02).with_y([work - SINK * 0.6, work + 0.03]);
        builder.cuboid(Slot::Metal, rail.inset(-0.01, 0.0, -0.012));
    }
}

/// What lies on the belt.
fn shopping(builder: &mut Builder, belt: Bay, work: f64) {
    for (index, slot) in [Slot::Paper, Slot::Book, Slot::Leaf, Slot::FabricAccent].into_iter().enumerate() {
        let x = belt.low.x + 0.15 + 0.17 * index as f64;
        let z = belt.center().z + 0.06 * (index % 2) as f64;
        let item = Bay::around(DVec3::new(x, 0.0, z), 0.1, 0.1, 0.07);
        if item.high.x < belt.high.x {
            builder.cuboid(slot, item.with_y([work + 0.012 - SINK, work + 0.07 + 0.03 * (index % 3) as f64]));
        }
    }
}

/// A screen whose upper edge is at `high`, on a post from a point of the counter.
fn screen_on_post(builder: &mut Builder, post: DVec3, high: f64) {
    let pole = cylinder(0.016, [post.y - SINK, high - 0.03], 8);
    builder.add(Slot::MetalDark, pole.moved(post.x, 0.0, post.z));
    let screen = Bay::around(DVec3::new(post.x, high - 0.1, post.z + 0.02), 0.28, 0.2, 0.025);
    let screen = screen.with_y([high - 0.19, high]);
    builder.block(Slot::PlasticDark, screen, 0.005);
    builder.cuboid(
        Slot::Screen,
        screen.inset(0.012, 0.012, 0.0).with_z([screen.high.z - SINK, screen.high.z + 0.002]),
    );
}

/// A counter with panels of wood, a raised board of marble towards the customers and a rail of brass; a pair of scales.
fn panelled(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let wood = [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][look];
    let work = bay.height() * WORK;
    builder.block(
        wood,
        bay.with_y([0.0, KICK + 0.02]).inset(0.006, 0.0, 0.0).without(Side::Front, 0.02),
        0.01,
    );
    let body = bay.with_y([KICK, work - 0.03]).inset(0.025, 0.0, 0.025);
    builder.cuboid(wood, body.without(Side::Front, bay.depth() * 0.38));
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            wood,
            body.slab(side, body.width() * 0.3).inset(0.001, 0.001, 0.0).without(Side::Back, 0.02),
        );
    }
    let face = body.slab(Side::Back, 0.001).inset(0.03, 0.04, 0.0);
    for panel in face.columns((bay.width() / 0.5).round().clamp(2.0, 6.0) as u32, 0.06) {
        let field = panel.with_z([body.low.z - 0.012, body.low.z + SINK]);
        builder.block(wood, field, 0.008);
        builder.block(wood, field.inset(0.06, 0.06, 0.0).moved(0.0, 0.0, -0.008), 0.006);
    }
    slab_top(builder, wood, bay.with_y([work - 0.03 - SINK, work]).inset(0.002, 0.0, 0.0), true);
    let ledge = bay.slab(Side::Back, bay.depth() * 0.24).with_y([bay.high.y - 0.03, bay.high.y]);
    builder.block(Slot::Stone, ledge.inset(0.05, 0.0, 0.01), 0.008);
    builder.cuboid(wood, ledge.inset(0.1, 0.0, 0.05).with_y([work - SINK, ledge.low.y + SINK]));
    let rail = [bay.low.x + 0.02, bay.high.x - 0.02].map(|x| DVec3::new(x, 0.2, bay.low.z + 0.016));
    builder.add(Slot::Brass, sweep(&rail, 0.016, 8));
    for share in [-0.42, 0.0, 0.42] {
        let at = DVec3::new(share * bay.width(), 0.2, bay.low.z + 0.03);
        builder.cuboid(Slot::Brass, Bay::around(at, 0.02, 0.02, 0.03));
    }
    let at = DVec3::new(bay.low.x + bay.width() * 0.22, work, bay.center().z + 0.1);
    builder.add(
        Slot::Brass,
        lathe(&[(0.05, -SINK), (0.05, 0.012), (0.012, 0.03), (0.01, 0.09)], 10).moved(at.x, at.y, at.z),
    );
    builder.cuboid(Slot::Brass, Bay::around(at + DVec3::Y * 0.088, 0.26, 0.008, 0.012));
    for x in [-0.12, 0.12] {
        let pan = lathe(&[(0.03, 0.0), (0.065, 0.014), (0.061, 0.015), (0.028, 0.004)], 10);
        builder.add(Slot::Brass, pan.moved(at.x + x, at.y + 0.06, at.z));
        builder.cuboid(Slot::Brass, Bay::around(at + DVec3::new(x, 0.0755, 0.0), 0.006, 0.03, 0.006));
    }
    let roll = across(0.05, [-0.14, 0.14], 10);
    builder.add(Slot::Paper, roll.moved(bay.width() * 0.26, work + 0.06, bay.center().z + 0.12));
}

/// Rollers in a frame of square tube on feet, with a plank to pack on and a hand scanner.
fn rollers(builder: &mut Builder) {
    let bay = builder.bay();
    let work = bay.height() * WORK;
    let (tube, high) = (0.05, work - 0.02);
    let frame = bay.with_y([0.0, high]).inset(0.004, 0.0, 0.004);
    legs_at_corners(builder, Slot::MetalDark, frame, tube, LegKind::Square);
    legs_at_corners(builder, Slot::MetalDark, frame.with_x([-tube, tube]), tube * 0.9, LegKind::Square);
    for y in [0.14, high - tube - 0.002] {
        for side in [Side::Front, Side::Back] {
            let rail = frame.slab(side, tube).inset(0.003, 0.0, 0.003).with_y([y, y + tube - 0.004]);
            builder.cuboid(Slot::MetalDark, rail);
        }
        for side in [Side::Left, Side::Right] {
            let rail =
                frame.slab(side, tube).inset(0.004, 0.0, tube - SINK).with_y([y + 0.001, y + tube - 0.006]);
            builder.cuboid(Slot::MetalDark, rail);
        }
    }
    builder.cuboid(Slot::Metal, frame.inset(0.02, 0.0, 0.02).with_y([0.15, 0.17]));
    let lane = frame.slab(Side::Left, bay.width() * 0.56).inset(0.01, 0.0, tube);
    let lane = lane.without(Side::Front, bay.depth() * 0.3);
    let count = (lane.width() / 0.085).round().clamp(6.0, 18.0) as u32;
    for cell in lane.columns(count, 0.0) {
        let roller = turned_forward(cylinder(0.03, [lane.low.z, lane.high.z], 8));
        builder.add(Slot::Metal, roller.moved(cell.center().x, work - 0.03, 0.0));
    }
    let side = Bay::new(lane.x(), [work - 0.05, work + 0.03], [lane.high.z - SINK, lane.high.z + 0.012]);
    builder.cuboid(Slot::PaintedAccent, side);
    builder.cuboid(Slot::PaintedAccent, side.with_z([lane.low.z - 0.012, lane.low.z + SINK]));
    let plank = bay.slab(Side::Right, bay.width() * 0.42).with_y([work - 0.04, work]);
    builder.block(Slot::Wood, plank, 0.005);
    let near = Bay::new([bay.low.x, plank.low.x + SINK], plank.y(), [side.high.z - SINK, bay.high.z]);
    builder.block(Slot::Wood, near.inset(0.0, 0.0006, 0.0), 0.005);
    let post = DVec3::new(plank.low.x + 0.1, work, bay.low.z + bay.depth() * 0.66);
    screen_on_post(builder, post, bay.high.y);
    let holder = Bay::around(post + DVec3::new(0.3, 0.04, 0.06), 0.07, 0.082, 0.05);
    builder.block(Slot::PlasticDark, holder, 0.012);
    let grip = [
        post + DVec3::new(0.3, 0.07, 0.06),
        post + DVec3::new(0.3, 0.1, 0.0),
        post + DVec3::new(0.3, 0.092, -0.06),
    ];
    builder.add(Slot::PlasticDark, sweep(&grip, 0.02, 6));
}

/// Two boxes of laminate beside a gap to sit in, joined by a thin board, with a hopper of sheet and a screen of acrylic glass.
fn boxes(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::Laminate, Slot::Painted, Slot::WoodLight, Slot::Laminate][look];
    let work = bay.height() * WORK;
    for (side, share) in [(Side::Left, 0.34), (Side::Right, 0.3)] {
        let case =
            bay.slab(side, bay.width() * share).with_y([0.0, work - 0.022 + SINK]).inset(0.012, 0.0, 0.02);
        builder.cuboid(Slot::PlasticDark, case.slab(Side::Below, 0.06).inset(0.01, 0.0, 0.02));
        builder.cuboid(slot, case.without(Side::Below, 0.06 - SINK));
        let door = case.without(Side::Below, 0.075).without(Side::Above, 0.03).inset(0.012, 0.0, 0.0);
        for leaf in door.columns(2, 0.006) {
            builder.cuboid(Slot::PaintedAccent, leaf.with_z([case.high.z - SINK, case.high.z + 0.014]));
        }
    }
    builder.cuboid(
        slot,
        bay.slab(Side::Back, 0.016)
            .with_y([work * 0.4, work - 0.021])
            .inset(0.1, 0.0, 0.0)
            .moved(0.0, 0.0, 0.03),
    );
    builder.block(slot, bay.with_y([work - 0.022, work]), 0.002);
    let tray = bay
        .slab(Side::Right, bay.width() * 0.3)
        .inset(0.03, 0.0, 0.0)
        .with_z([bay.low.z + 0.12, bay.low.z + 0.62]);
    for side in [Side::Left, Side::Right, Side::Back] {
        builder.cuboid(
            Slot::Metal,
            tray.slab(side, 0.012)
                .with_y([work - SINK, work + if side == Side::Back { 0.05 } else { 0.0512 }]),
        );
    }
    builder.cuboid(
        Slot::Metal,
        tray.inset(0.011, 0.0, 0.0).with_y([work - SINK, work + 0.004]).inset(0.0, 0.0, 0.002),
    );
    screen_and_scanner(builder, work);
}

/// A screen of acrylic glass, a scanner in the board, and a rack of small goods.
fn screen_and_scanner(builder: &mut Builder, work: f64) {
    let bay = builder.bay();
    let pane =
        bay.slab(Side::Back, 0.008).with_y([work - SINK, bay.high.y]).inset(bay.width() * 0.3, 0.0, 0.0);
    builder.cuboid(Slot::Glass, pane.moved(0.0, 0.0, 0.08));
    for side in [Side::Left, Side::Right] {
        let foot = pane
            .slab(side, 0.02)
            .with_y([work - SINK, work + 0.03])
            .moved(0.0, 0.0, 0.08)
            .inset(-0.002, 0.0, -0.03);
        builder.cuboid(Slot::Metal, foot);
    }
    let scanner = Bay::around(DVec3::new(0.0, work + 0.006, bay.center().z - 0.1), 0.3, 0.014, 0.3);
    builder.cuboid(Slot::Metal, scanner.with_y([work - SINK, work + 0.008]));
    builder.cuboid(Slot::Screen, scanner.inset(0.07, 0.0, 0.07).with_y([work + 0.007, work + 0.01]));
    let rack =
        Bay::around(DVec3::new(bay.low.x + bay.width() * 0.17, work, bay.low.z + 0.14), 0.4, 0.1, 0.12);
    for (index, row) in
        rack.with_y([work - SINK, bay.high.y - 0.01]).columns(5, 0.012).into_iter().enumerate()
    {
        builder.cuboid(
            [Slot::Book, Slot::Leaf, Slot::Brass, Slot::FabricAccent, Slot::Paper][index],
            row.without(Side::Above, 0.01 * (index % 3) as f64),
        );
    }
}
