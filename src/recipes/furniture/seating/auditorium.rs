//! Fixed seats in rows: 0.50 to 0.60 m from middle to middle, seats 0.44 m high, tipped up or not (EN 12727).

use glam::{DVec2, DVec3};

use super::{depth_slats, seat_height};
use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, SINK, Solid, Station, crowned, extrude, lathe, rounded_box, sheet, sweep,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of the standard between two seats.
const STANDARD: f64 = 0.045;
/// Metres of arm rests over the seat.
const ARM_RISE: f64 = 0.16;
/// Metres of depth in which the back leans.
const LEAN: f64 = 0.14;

/// The measures that all seats in rows share.
struct Seat {
    bay: Bay,
    seat: f64,
    form: usize,
}

impl Seat {
    /// The space between the standards.
    fn inner(&self) -> Bay {
        self.bay.inset(STANDARD + 0.005, 0.0, 0.0)
    }

    /// z of the back's middle at a share of its rise over the seat.
    fn lean(&self, rise: f64) -> f64 {
        self.bay.low.z + 0.026 + LEAN * (1.0 - rise).clamp(0.0, 1.0)
    }

    /// The back in one sheet, through (share of the rise, share of the half width).
    fn back(&self, profile: &[(f64, f64)], thickness: f64, wrap: f64) -> Solid {
        let half = self.inner().width() / 2.0;
        let station = |&(rise, wide): &(f64, f64)| {
            let y = self.seat + rise * (self.bay.high.y - self.seat);
            Station { at: DVec3::new(0.0, y, self.lean(rise)), half_width: half * wide, sag: wrap }
        };
        let stations: Vec<Station> = profile.iter().map(station).collect();
        sheet(&stations, DVec3::NEG_X, thickness, 4)
    }

    /// The seat's board or cushion.
    fn seat_bay(&self, thickness: f64) -> Bay {
        let bay = self.inner().with_y([self.seat - thickness, self.seat]);
        bay.without(Side::Back, LEAN).without(Side::Front, 0.03)
    }

    /// Standards on both sides, drawn from a profile of shares of the depth and metres of height.
    fn standards(&self, builder: &mut Builder, slot: Slot, profile: &[(f64, f64)], thickness: f64) {
        let (low, depth) = (self.bay.low.z, self.bay.depth());
        let profile: Vec<DVec2> =
            profile.iter().map(|&(share, y)| DVec2::new(low + share * depth, y)).collect();
        let x = self.bay.high.x - (STANDARD - thickness) / 2.0;
        builder.add_pair(slot, extrude(&profile, Axis::X, [x - thickness, x]));
    }

    /// Arm rests on the standards, from one share of the depth to another.
    fn arms(&self, builder: &mut Builder, slot: Slot, depth: [f64; 2], edge: f64) {
        let z = depth.map(|share| self.bay.low.z + share * self.bay.depth());
        let y = self.seat + ARM_RISE;
        let rest = Bay::new([self.bay.high.x - STANDARD, self.bay.high.x], [y - 0.03, y], z);
        builder.add_pair(slot, rounded_box(rest, DVec3::splat(edge), 1));
    }

    /// A bar on which the seat turns.
    fn axle(&self, builder: &mut Builder, slot: Slot) {
        let at = DVec3::new(0.0, self.seat - 0.1, self.bay.low.z + LEAN + 0.06);
        builder.cuboid(slot, Bay::around(at, self.inner().width() + 0.02, 0.03, 0.05));
    }
}

/// A fixed seat: upholstered between panels, plush between cast iron, wood on bent steel, or a shell of plastic.
pub(in super::super) static AUDITORIUM_SEAT: Recipe =
    Recipe::furniture("auditorium_seat", [0.55, 0.7, 0.95]).symbol(Symbol::Chair).every_set(auditorium_seat);

fn auditorium_seat(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let seat = Seat { bay, seat: seat_height(bay.height()), form: draft.form() };
    match draft.set() {
        GeometrySet::Plain => plain(&seat, builder),
        GeometrySet::Traditional => traditional(&seat, builder),
        GeometrySet::Industrial => industrial(&seat, builder),
        GeometrySet::Budget => budget(&seat, builder),
    }
}

/// Panels to the floor, cushions before a shell of wood.
fn plain(seat: &Seat, builder: &mut Builder) {
    let slot = [Slot::FabricAccent, Slot::Fabric, Slot::Leather, Slot::FabricAccent][seat.form];
    let panel = [Slot::Painted, Slot::Wood, Slot::MetalDark, Slot::WoodLight][seat.form];
    let top = seat.seat + ARM_RISE - 0.03 + SINK;
    if seat.form.is_multiple_of(2) {
        let profile = [(0.1, 0.012), (0.78, 0.012), (0.78, top), (0.1, top)];
        seat.standards(builder, panel, &profile, STANDARD * 0.7);
        let shoe = seat.bay.slab(Side::Right, STANDARD).slab(Side::Below, 0.015);
        let shoe = shoe.inset(0.002, 0.0, 0.0).with_z([seat.bay.low.z + 0.04, seat.bay.high.z - 0.12]);
        builder.add_pair(Slot::MetalDark, rounded_box(shoe, DVec3::splat(0.004), 1));
    } else {
        let profile = [(0.3, 0.0), (0.62, 0.0), (0.56, 0.03), (0.52, top), (0.36, top), (0.38, 0.03)];
        seat.standards(builder, panel, &profile, STANDARD * 0.8);
    }
    seat.arms(builder, Slot::WoodDark, [0.08, 0.84], 0.006);
    builder.cushion(slot, seat.seat_bay(0.09).without(Side::Front, -0.03), 0.03);
    builder.add(
        slot,
        seat.back(&[(-0.04, 0.9), (0.04, 0.98), (0.6, 0.98), (0.88, 0.96), (0.97, 0.8)], 0.07, 0.012),
    );
    let shell = seat.back(&[(-0.06, 0.9), (0.5, 1.0), (0.995, 0.84)], 0.012, 0.006);
    builder.add(Slot::Wood, shell.moved(0.0, 0.0, -0.0195));
    seat.axle(builder, Slot::MetalDark);
}

/// Cast iron with scrolls, plush with a rounded top in a frame of wood.
fn traditional(seat: &Seat, builder: &mut Builder) {
    let top = seat.seat + ARM_RISE - 0.03 + SINK;
    let slot = [Slot::FabricAccent, Slot::Leather, Slot::FabricAccent, Slot::Fabric][seat.form];
    let iron = if seat.form == 2 { Slot::Brass } else { Slot::MetalDark };
    let profile = [
        (0.16, 0.0),
        (0.78, 0.0),
        (0.8, 0.035),
        (0.6, 0.07),
        (0.52, 0.16),
        (0.66, 0.27),
        (0.78, 0.34),
        (0.72, top),
        (0.12, top),
        (0.2, 0.32),
        (0.3, 0.2),
        (0.3, 0.08),
        (0.16, 0.035),
    ];
    seat.standards(builder, iron, &profile, STANDARD * 0.6);
    seat.arms(builder, Slot::WoodDark, [0.06, 0.8], 0.012);
    let wide = seat.seat_bay(0.1).without(Side::Front, -0.03);
    builder.add(slot, crowned(wide, 0.03, 0.035));
    builder.block(Slot::WoodDark, wide.slab(Side::Below, 0.03).moved(0.0, -0.02, 0.0), 0.008);
    let arch = [(-0.02, 0.9), (0.1, 0.96), (0.7, 0.94), (0.86, 0.82), (0.94, 0.6), (0.965, 0.4)];
    builder.add(slot, seat.back(&arch, 0.07, 0.0));
    let frame = [(-0.08, 0.92), (0.1, 1.0), (0.72, 1.0), (0.9, 0.88), (0.98, 0.62), (0.997, 0.36)];
    builder.add(Slot::WoodDark, seat.back(&frame, 0.024, 0.0).moved(0.0, 0.0, -0.0135));
    seat.axle(builder, iron);
    if seat.form % 2 == 1 {
        for (across, rise) in [(-0.5, 0.4), (0.0, 0.4), (0.5, 0.4), (-0.25, 0.62), (0.25, 0.62)] {
            let button = lathe(&[(0.012, -0.01), (0.012, 0.002), (0.006, 0.006)], 6);
            let y = seat.seat + rise * (seat.bay.high.y - seat.seat);
            let at = DVec3::new(across * seat.inner().width() / 2.0, y, seat.lean(rise) + 0.035);
            builder.add(Slot::Brass, button.turned_x(std::f64::consts::FRAC_PI_2).moved(at.x, at.y, at.z));
        }
    }
}

/// Bent plywood or slats on loops of flat steel.
fn industrial(seat: &Seat, builder: &mut Builder) {
    let slot = [Slot::Wood, Slot::Wood, Slot::Metal, Slot::WoodDark][seat.form];
    let (low, depth) = (seat.bay.low.z, seat.bay.depth());
    let x = seat.bay.high.x - STANDARD / 2.0;
    let at = |share: f64, y: f64| DVec3::new(x, y, low + share * depth);
    let arm = seat.seat + ARM_RISE - 0.018;
    let bow =
        [at(0.12, 0.012), at(0.84, 0.012), at(0.84, arm), at(0.1, arm), at(0.06, seat.bay.high.y * 0.9)];
    builder.add_pair(Slot::MetalDark, sweep(&bow, 0.014, 4));
    seat.arms(builder, Slot::Wood, [0.3, 0.86], 0.006);
    for z in [0.34, 0.72] {
        let bar = Bay::around(at(z, seat.seat - 0.04) - DVec3::X * x, x * 2.0, 0.024, 0.03);
        builder.cuboid(Slot::MetalDark, bar);
    }
    let board = seat.seat_bay(0.026).without(Side::Front, -0.03);
    if seat.form % 2 == 1 {
        for slat in depth_slats(board, 5, 0.012) {
            builder.cuboid(slot, slat);
        }
        for rise in [0.26, 0.48, 0.7, 0.915] {
            let y = seat.seat + rise * (seat.bay.high.y - seat.seat);
            let tall = (seat.bay.high.y - seat.seat) * 0.15;
            let middle = DVec3::new(0.0, y, seat.lean(rise));
            builder.cuboid(slot, Bay::around(middle, seat.inner().width() + 0.03, tall, 0.018));
        }
    } else {
        builder.add(slot, rounded_box(board, DVec3::splat(0.01), 1));
        let ply = [(0.14, 0.9), (0.2, 1.0), (0.6, 1.02), (0.92, 1.0), (0.995, 0.86)];
        builder.add(slot, seat.back(&ply, 0.014, 0.012));
    }
    let top = Bay::around(at(0.06, seat.bay.high.y * 0.84) - DVec3::X * x, x * 2.0, 0.03, 0.02);
    builder.cuboid(Slot::MetalDark, top.moved(0.0, 0.0, -0.02));
}

/// A moulded shell as in stadiums, on one post or on a rail, with a number on its back.
fn budget(seat: &Seat, builder: &mut Builder) {
    let slot = [Slot::Plastic, Slot::PaintedAccent, Slot::PlasticDark, Slot::PaintedAccent][seat.form];
    let half = seat.bay.width() / 2.0;
    let front = seat.bay.high.z;
    let thickness = 0.014;
    let station = |z: f64, y: f64, wide: f64, sag: f64| Station {
        at: DVec3::new(0.0, y, z),
        half_width: half * wide,
        sag,
    };
    let upper = |rise: f64, wide: f64| {
        let y = seat.seat + rise * (seat.bay.high.y - seat.seat);
        station(seat.lean(rise), y, wide, 0.04)
    };
    let (y, heel) = (seat.seat - 0.02, seat.lean(0.0));
    let high = if seat.form < 2 { 0.97 } else { 0.995 };
    let stations = [
        station(front - 0.01, y - 0.05, 0.86, 0.0),
        station(front - 0.03, y - 0.008, 0.96, 0.012),
        station(front - 0.16, y - 0.01, 0.998, 0.03),
        station(heel + 0.12, y - 0.02, 0.998, 0.045),
        station(heel + 0.01, y + 0.03, 0.96, 0.045),
        upper(0.3, 0.94),
        upper(high - 0.12, 0.94),
        upper(high, 0.7),
    ];
    builder.add(slot, sheet(&stations, DVec3::NEG_X, thickness, 4));
    if seat.form < 2 {
        let lip =
            Bay::around(DVec3::new(0.0, seat.bay.high.y - 0.02, seat.lean(1.0) - 0.012), half, 0.04, 0.03);
        builder.block(slot, lip, 0.01);
    }
    let number = DVec3::new(0.0, seat.seat + 0.72 * (seat.bay.high.y - seat.seat), seat.lean(0.72) + 0.006);
    builder.cuboid(Slot::Paper, Bay::around(number, 0.08, 0.05, 0.006));
    post_or_rail(seat, builder, y);
    builder.cuboid(
        Slot::Metal,
        Bay::around(DVec3::new(0.0, y - 0.034, -0.01), half * 0.9, 0.03, seat.bay.depth() * 0.4),
    );
    let brace = [
        DVec3::new(0.0, y - 0.045, heel - 0.01),
        DVec3::new(0.0, seat.bay.high.y * 0.7, seat.lean(0.42) - 0.018),
    ];
    builder.add(Slot::Metal, sweep(&brace, 0.012, 6));
}

/// One post on a plate, or a rail on two posts.
fn post_or_rail(seat: &Seat, builder: &mut Builder, y: f64) {
    let half = seat.bay.width() / 2.0;
    if seat.form.is_multiple_of(2) {
        let foot = Bay::new([-0.03, 0.03], [0.004, y - 0.02], [-0.08, -0.02]);
        builder.cuboid(Slot::Metal, foot);
        builder.cuboid(Slot::Metal, Bay::around(DVec3::new(0.0, 0.006, -0.05), half * 0.8, 0.012, 0.2));
    } else {
        for x in [-0.55, 0.55] {
            let at = DVec3::new(x * half, 0.0, -0.04);
            builder.cuboid(
                Slot::Metal,
                Bay::new([at.x - 0.02, at.x + 0.02], [0.0, y - 0.06], [at.z - 0.03, at.z + 0.03]),
            );
        }
        builder.cuboid(
            Slot::Metal,
            Bay::around(DVec3::new(0.0, y - 0.06, -0.04), seat.bay.width() * 0.97, 0.05, 0.05),
        );
    }
}
