//! Barber chairs: seats 0.5 m wide and 0.5 to 0.65 over the floor, on a pump; 1.0 to 1.1 m over all with the head rest.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{across, ball, turned_sideways};
use crate::recipes::kit::{
    Axis, Bay, Builder, SINK, Station, crowned, cylinder, extrude, lathe, pipe, sheet, sweep,
};
use crate::recipes::{Recipe, Slot, Symbol};

/// A padded seat with arms and foot rest on a column: plain with a head rest; round and tufted on a cast base; ribbed pads in
/// a frame of pipe; a shell on a star.
pub(in super::super) static BARBER_CHAIR: Recipe = Recipe::furniture("barber_chair", [0.65, 0.95, 1.05])
    .symbol(Symbol::Chair)
    .plain(|draft, builder| plain(builder, draft.sampler().pick(&[Slot::Leather, Slot::Fabric])))
    .traditional(|_, builder| tufted(builder))
    .industrial(|_, builder| framed(builder))
    .budget(|_, builder| shell(builder));

fn plain(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (high, depth) = (bay.high.y, bay.depth());
    builder.add(Slot::Chrome, cylinder(bay.width() * 0.4, [0.0, 0.04], 20));
    builder.add(Slot::Chrome, cylinder(0.06, [0.04 - SINK, high * 0.36], 14));
    let seat =
        bay.with_y([high * 0.35, high * 0.48]).without(Side::Front, depth * 0.25).inset(0.08, 0.0, 0.0);
    builder.cushion(slot, seat, 0.04);
    let back = seat.slab(Side::Back, 0.13).with_y([high * 0.46, high * 0.84]);
    builder.cushion(slot, back, 0.04);
    builder.cushion(slot, back.inset(bay.width() * 0.16, 0.0, 0.01).with_y([high * 0.86, high]), 0.03);
    builder.cuboid(Slot::Chrome, back.inset(bay.width() * 0.32, 0.0, 0.05).with_y([high * 0.8, high * 0.9]));
    for side in [Side::Left, Side::Right] {
        let arm = bay.slab(side, 0.09).with_z([seat.low.z + 0.05, seat.high.z - 0.05]);
        builder.cushion(Slot::PlasticDark, arm.with_y([high * 0.56, high * 0.62]), 0.02);
        builder.cuboid(Slot::Chrome, arm.inset(0.025, 0.0, 0.15).with_y([high * 0.4, high * 0.57]));
    }
    let rest = bay.slab(Side::Front, 0.16).with_y([high * 0.14, high * 0.18]).inset(0.12, 0.0, 0.0);
    builder.block(Slot::Metal, rest, 0.006);
    let stay = Bay::new([-0.03, 0.03], [high * 0.15, high * 0.38], [bay.high.z - 0.3, bay.high.z - 0.14]);
    builder.cuboid(Slot::Chrome, stay);
}

/// A round seat and a tufted back between scrolled arms, on a cast base with a stepped column; a grille for the feet.
fn tufted(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, half) = (bay.high.y, bay.high.x);
    let middle = bay.low.z + bay.depth() * 0.42;
    let base = [(0.9, 0.0), (0.9, 0.03), (0.5, 0.07), (0.26, 0.12), (0.22, 0.26), (0.34, 0.3), (0.34, 0.34)]
        .map(|(share, y)| (share * half, y * high));
    builder.add(Slot::Ceramic, lathe(&base, 20).moved(0.0, 0.0, middle));
    let frame = cylinder(half * 0.8, [high * 0.33, high * 0.37], 16);
    builder.add(Slot::Chrome, frame.moved(0.0, 0.0, middle));
    let seat = [(0.74, 0.365), (0.8, 0.39), (0.8, 0.44), (0.7, 0.475), (0.35, 0.485), (0.0, 0.487)]
        .map(|(share, y)| (share * half, y * high));
    builder.add(Slot::Leather, lathe(&seat, 16).moved(0.0, 0.0, middle));
    let back = Bay::new(
        [-half * 0.66, half * 0.66],
        [high * 0.46, high * 0.86],
        [bay.low.z + 0.03, bay.low.z + 0.13],
    );
    builder.block(
        Slot::WoodDark,
        back.slab(Side::Back, 0.04).inset(-0.02, -0.02, 0.0).moved(0.0, 0.0, -0.02),
        0.015,
    );
    builder.cushion(Slot::Leather, back, 0.04);
    for row in back.inset(0.03, 0.05, 0.0).rows(3, 0.02) {
        for cell in row.columns(3, 0.02) {
            let at = DVec3::new(cell.center().x, cell.center().y, back.high.z);
            builder.cuboid(Slot::Brass, Bay::around(at, 0.016, 0.016, 0.008));
        }
    }
    let roll = across(high * 0.06, [-half * 0.42, half * 0.42], 12);
    builder.add(Slot::Leather, roll.moved(0.0, high * 0.94, bay.low.z + 0.09));
    builder.add_pair(
        Slot::Brass,
        across(0.025, [half * 0.41, half * 0.46], 8).moved(0.0, high * 0.94, bay.low.z + 0.09),
    );
    let prop = Bay::new([-0.025, 0.025], [high * 0.84, high * 0.92], [bay.low.z + 0.052, bay.low.z + 0.08]);
    builder.cuboid(Slot::Brass, prop);
    scrolled_arms(builder, middle);
    grille(builder, middle);
}

/// Arms of cast metal on a turned post, rolled at the front, with a pad of wood.
fn scrolled_arms(builder: &mut Builder, middle: f64) {
    let bay = builder.bay();
    let (high, x) = (bay.high.y, bay.high.x - 0.045);
    let at = |y: f64, z: f64| DVec3::new(x, high * y, z);
    let (back, front) = (bay.low.z + 0.1, middle + bay.high.x * 0.8);
    let arm = [at(0.66, back), at(0.62, middle), at(0.62, front), at(0.56, front + 0.03), at(0.5, front)];
    builder.add_pair(Slot::Chrome, pipe(&arm, 0.02, 0.05));
    builder.add_pair(Slot::Chrome, turned_sideways(ball(0.035, 10)).moved(x, high * 0.5, front - 0.01));
    let pad = Bay::new([x - 0.035, x + 0.045], [high * 0.625, high * 0.655], [middle - 0.08, front + 0.01]);
    for ends in [pad.x(), [-pad.high.x, -pad.low.x]] {
        builder.cushion(Slot::WoodDark, pad.with_x(ends), 0.012);
    }
    let post = [(0.018, 0.35), (0.03, 0.4), (0.016, 0.44), (0.028, 0.5), (0.016, 0.56), (0.022, 0.62)]
        .map(|(radius, y)| (radius, y * high));
    builder.add_pair(Slot::Chrome, lathe(&post, 8).moved(x - 0.03, 0.0, middle));
    builder
        .add_pair(Slot::Chrome, sweep(&[at(0.355, middle), DVec3::new(0.1, high * 0.355, middle)], 0.016, 6));
}

/// A foot rest with bars in a frame, on an arm from the seat.
fn grille(builder: &mut Builder, middle: f64) {
    let bay = builder.bay();
    let (high, front) = (bay.high.y, bay.high.z);
    let (low, rest) = (high * 0.1, bay.slab(Side::Front, 0.2).inset(0.14, 0.0, 0.0));
    for edge in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Chrome, rest.slab(edge, 0.02).with_y([low, low + 0.02]));
    }
    let count = 7;
    let pitch = (rest.depth() - 0.014) / f64::from(count - 1);
    for index in 0..count {
        let z = rest.low.z + f64::from(index) * pitch;
        let bar = rest.with_y([low + 0.004, low + 0.016]).with_z([z, z + 0.014]).inset(0.019, 0.0, 0.0);
        builder.cuboid(Slot::Chrome, bar.inset(0.0, 0.0, 0.001));
    }
    let arm = [(middle + 0.1, high * 0.34), (front - 0.12, high * 0.3), (front - 0.1, low + 0.012)];
    for x in [-0.08, 0.08] {
        let path = arm.map(|(z, y)| DVec3::new(x, y, z));
        builder.add(Slot::Chrome, pipe(&path, 0.014, 0.06));
    }
}

/// Pads with ribs in a frame of bent pipe, on a square plate.
fn framed(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, low, tube) = (bay.high.y, bay.low.z, 0.02);
    let middle = low + bay.depth() * 0.42;
    let plate = Bay::around(DVec3::new(0.0, 0.015, middle), 0.56, 0.03, 0.56);
    builder.block(Slot::MetalDark, plate, 0.006);
    for x in [-0.22, 0.22] {
        for z in [-0.22, 0.22] {
            builder.add(Slot::Metal, cylinder(0.016, [0.03 - SINK, 0.042], 6).moved(x, 0.0, middle + z));
        }
    }
    builder.add(Slot::MetalDark, cylinder(0.075, [0.03 - SINK, high * 0.2], 12).moved(0.0, 0.0, middle));
    builder.add(Slot::Metal, cylinder(0.05, [high * 0.19, high * 0.37], 12).moved(0.0, 0.0, middle));
    ribbed_pads(builder, middle);
    let x = bay.high.x - tube;
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, high * y, z);
    let side = [
        at(x, 0.38, middle + 0.2),
        at(x, 0.62, middle + 0.26),
        at(x, 0.62, low + 0.06),
        at(x, 0.38, low + 0.14),
        at(x, 0.38, middle + 0.2 - 0.001),
    ];
    builder.add_pair(Slot::MetalDark, pipe(&side[..4], tube, 0.06));
    let pad = Bay::new([x - 0.028, x + 0.02], [high * 0.632, high * 0.66], [low + 0.14, middle + 0.18]);
    for ends in [pad.x(), [-pad.high.x, -pad.low.x]] {
        builder.block(Slot::Wood, pad.with_x(ends), 0.008);
    }
    for (y, z) in [(0.38, middle + 0.19), (0.375, low + 0.16), (0.62, low + 0.07)] {
        builder.add(Slot::MetalDark, sweep(&[at(-x, y, z), at(x, y, z)], tube * 0.8, 6));
    }
    let bow = [
        at(-0.2, 0.37, middle + 0.2),
        at(-0.2, 0.12, bay.high.z - tube),
        at(0.2, 0.12, bay.high.z - tube),
        at(0.2, 0.37, middle + 0.2),
    ];
    builder.add(Slot::MetalDark, pipe(&bow, tube, 0.06));
    let tread = [at(-0.195, 0.16, bay.high.z - 0.075), at(0.195, 0.16, bay.high.z - 0.075)];
    builder.add(Slot::Metal, sweep(&tread, tube * 0.9, 8));
}

/// A seat and a back of ribs.
fn ribbed_pads(builder: &mut Builder, middle: f64) {
    let bay = builder.bay();
    let (high, low) = (bay.high.y, bay.low.z);
    let seat = Bay::new([-0.24, 0.24], [high * 0.36, high * 0.47], [low + 0.16, middle + 0.28]);
    builder.cuboid(Slot::MetalDark, seat.slab(Side::Below, 0.03).inset(0.02, 0.0, 0.03));
    let pitch = seat.depth() / 4.0;
    for index in 0..4 {
        let z = seat.low.z + f64::from(index) * pitch;
        builder.cushion(Slot::Leather, seat.with_z([z, z + pitch * 0.97]).without(Side::Below, 0.028), 0.025);
    }
    let back = Bay::new([-0.22, 0.22], [high * 0.48, high], [low, low + 0.08]);
    for (index, pad) in back.rows(5, 0.006).into_iter().enumerate() {
        let lean = 0.018 * (4 - index) as f64;
        builder.cushion(Slot::Leather, pad.moved(0.0, 0.0, lean), 0.025);
    }
}

/// A shell that runs from the seat into the back, with loops for arms, on a star of five.
fn shell(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, low, tube) = (bay.high.y, bay.low.z, 0.014);
    let middle = low + bay.depth() * 0.4;
    let reach = bay.high.x * 0.96;
    for leg in 0..5 {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * (f64::from(leg) / 5.0 + 0.25));
        let end = DVec3::new(cosine * reach, 0.022, middle + sine * reach);
        builder.add(Slot::Chrome, sweep(&[DVec3::new(0.0, high * 0.09, middle), end], 0.02, 6));
        builder.add(
            Slot::PlasticDark,
            cylinder(0.026, [0.0, 0.03], 8).moved(end.x * 0.97, 0.0, middle + sine * reach * 0.97),
        );
    }
    builder.add(Slot::Chrome, cylinder(0.034, [high * 0.06, high * 0.37], 10).moved(0.0, 0.0, middle));
    let station = |y: f64, z: f64, half_width: f64| Station {
        at: DVec3::new(0.0, high * y, z),
        half_width,
        sag: 0.035,
    };
    let stations = [
        station(0.4, middle + 0.27, 0.2),
        station(0.425, middle + 0.2, 0.23),
        station(0.4, middle + 0.02, 0.24),
        station(0.4, low + 0.2, 0.235),
        station(0.45, low + 0.12, 0.23),
        station(0.7, low + 0.06, 0.22),
        station(0.96, low + 0.025, 0.17),
    ];
    builder.add(Slot::Plastic, sheet(&stations, DVec3::X, 0.022, 4));
    let pad = Bay::new([-0.19, 0.19], [high * 0.4, high * 0.46], [low + 0.2, middle + 0.22]);
    builder.add(Slot::FabricAccent, crowned(pad, 0.03, 0.015));
    let rest = [(0.0, 0.86), (0.03, 0.82), (0.09, 0.84), (0.1, 0.97), (0.05, 1.0), (0.01, 0.98)]
        .map(|(z, y)| DVec2::new(low + z, y * high));
    builder.add(Slot::FabricAccent, extrude(&rest, Axis::X, [-0.14, 0.14]));
    builder.cuboid(Slot::Chrome, Bay::around(DVec3::new(0.0, high * 0.37, middle), 0.3, 0.03, 0.24));
    let x = bay.high.x - tube;
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, high * y, z);
    let arm =
        [at(0.12, 0.37, middle), at(x, 0.4, middle), at(x, 0.62, middle + 0.16), at(x, 0.64, low + 0.16)];
    builder.add_pair(Slot::Chrome, pipe(&arm, tube, 0.05));
    let grip = [at(x, 0.63, middle + 0.09), at(x, 0.64, low + 0.18)];
    builder.add_pair(Slot::PlasticDark, sweep(&grip, tube + 0.006, 8).moved(-0.006, 0.0, 0.0));
    let front = bay.high.z - tube;
    let stay = [at(0.0, 0.37, middle + 0.1), at(0.0, 0.34, middle + 0.3), at(0.0, 0.12, front)];
    builder.add(Slot::Chrome, pipe(&stay, tube * 1.2, 0.06));
    builder.add(Slot::PlasticDark, across(0.02, [-0.17, 0.17], 8).moved(0.0, high * 0.12, front - 0.006));
}
