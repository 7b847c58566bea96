//! Toilets.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::kit::{
    Bay, Builder, Outline, SINK, Slice, Solid, cylinder, lathe, loft, loft_ring, sweep,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Corners of a bowl.
const ROUND: usize = 16;
/// Metres of a toilet's seat over the floor (VDI 6000: 0.42-0.46).
const SEAT: f64 = 0.43;
/// Metres of seat and lid.
const LID: f64 = 0.018;
/// What carries a bowl.
#[derive(Clone, Copy, PartialEq)]
enum Foot {
    /// Nothing: it hangs on the wall.
    Hung,
    /// A waist under the bowl, with a moulded foot.
    Pedestal,
    /// Straight sides down to the floor and back to the wall.
    Skirted,
}

/// The cover of a toilet.
#[derive(Clone, Copy, PartialEq)]
enum Cover {
    Closed,
    Open,
    None,
}

/// A bowl, its bay (from the floor, as deep as the bowl) and the height of its seat.
struct Bowl {
    bay: Bay,
    outline: Outline,
    seat: f64,
}

impl Bowl {
    fn slice(&self, y: f64, [x, z]: [f64; 2], back: f64) -> Slice {
        let (half, middle) = (self.bay.extent() / 2.0, self.bay.center());
        Slice::new(y, half.x * x, half.z * z).at(middle.x, middle.z - half.z * back)
    }

    /// The body with its hollow and the water in it.
    fn pan(&self, builder: &mut Builder, slot: Slot, foot: Foot) {
        let seat = self.seat;
        let rim = seat - LID * 2.0;
        let at = |share: f64, x: f64, z: f64| self.slice(seat * share, [x, z], 1.0 - z);
        let outside = match foot {
            Foot::Hung => vec![at(0.3, 0.5, 0.55), at(0.42, 0.78, 0.82), at(0.72, 0.96, 0.99)],
            Foot::Skirted => vec![at(0.0, 0.82, 0.9), at(0.55, 0.84, 0.92), at(0.8, 0.96, 0.99)],
            Foot::Pedestal => vec![
                self.slice(0.0, [0.66, 0.72], 0.26),
                self.slice(seat * 0.1, [0.64, 0.7], 0.26),
                self.slice(seat * 0.15, [0.52, 0.64], 0.28),
                self.slice(seat * 0.45, [0.58, 0.68], 0.26),
                self.slice(seat * 0.78, [0.92, 0.97], 0.03),
            ],
        };
        let inside = [
            self.slice(rim, [0.97, 1.0], 0.0),
            self.slice(rim, [0.7, 0.74], 0.0),
            self.slice(seat * 0.62, [0.38, 0.44], 0.05),
        ];
        let slices: Vec<Slice> = outside.into_iter().chain(inside).collect();
        builder.add(slot, loft(&self.outline, &slices));
        let water = [self.slice(seat * 0.6, [0.4, 0.46], 0.05), self.slice(seat * 0.66, [0.43, 0.49], 0.05)];
        builder.add(Slot::Glass, loft(&Outline::Round(8), &water));
    }

    /// The seat, two hinges and a lid.
    fn seat(&self, builder: &mut Builder, slot: Slot, cover: Cover, most: f64) {
        let (low, high) = (self.seat - LID * 2.0, self.seat - LID);
        let ring = [
            self.slice(low - SINK, [0.96, 0.97], -0.01),
            self.slice(low + LID * 0.5, [0.99, 0.99], -0.01),
            self.slice(high, [0.95, 0.96], -0.01),
            self.slice(high - LID * 0.2, [0.62, 0.68], -0.06),
            self.slice(low - SINK, [0.6, 0.66], -0.06),
        ];
        builder.add(slot, loft_ring(&self.outline, &ring));
        let hinge = self.bay.low.z + 0.03;
        let width = self.bay.width();
        for side in [-1.0, 1.0] {
            let at = self.bay.center().x + side * width * 0.2;
            let pin = Bay::new(
                [at - 0.02, at + 0.02],
                [high - SINK, high + LID * 0.7],
                [hinge - 0.01, hinge + 0.01],
            );
            builder.cuboid(Slot::Chrome, pin);
        }
        match cover {
            Cover::None => {}
            Cover::Closed => {
                let lid = [
                    self.slice(high + 0.001, [0.97, 0.98], -0.01),
                    self.slice(high + LID * 0.6, [0.97, 0.98], -0.01),
                    self.slice(self.seat, [0.88, 0.9], -0.01),
                ];
                builder.add(slot, loft(&self.outline, &lid));
            }
            Cover::Open => builder.add(slot, self.open_lid(hinge, most)),
        }
    }

    /// The lid upright over its hinge, leaning back, up to a height.
    fn open_lid(&self, hinge: f64, most: f64) -> Solid {
        let half = self.bay.extent() / 2.0;
        let foot = self.seat - LID * 0.4;
        let long = half.z.min((most - foot) / 2.0);
        let slice = |y: f64, share: f64| Slice::new(y, half.x * 0.97 * share, long * share).at(0.0, long);
        let lid = loft(&self.outline, &[slice(0.0, 1.0), slice(LID * 0.7, 1.0), slice(LID, 0.92)]);
        let upright = lid.turned_x(-std::f64::consts::FRAC_PI_2);
        upright.moved(self.bay.center().x, foot, hinge + LID)
    }
}

/// An outline that is blunt at the back; to the front a circle for a power of one, squarer for less.
fn bowl_outline(power: f64, narrow: f64) -> Outline {
    let bent = |value: f64, power: f64| value.signum() * libm::pow(value.abs(), power);
    let point = |step: usize| {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * step as f64 / ROUND as f64);
        let power = if sine < -1e-9 { 0.55 } else { power };
        let slim = if sine > 0.0 { 1.0 - narrow * sine } else { 1.0 };
        // A quarter turn's sine and cosine are not exactly 0 and 1.
        let [x, z] = [cosine, sine].map(|value| if value.abs() < 1e-9 { 0.0 } else { value });
        DVec2::new(bent(x, power) * slim, bent(z, power))
    };
    Outline::Points((0..ROUND).rev().map(point).collect())
}

/// A toilet: hung on a cistern's case, with a ceramic cistern, a flush pipe, or a cistern of plastic.
pub(super) static TOILET: Recipe =
    Recipe::furniture("toilet", [0.38, 0.68, 0.8]).symbol(Symbol::Toilet).every_set(toilet);

fn toilet(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    toilet_in(bay, draft.set(), draft.input.look, builder);
}

pub(super) fn toilet_in(bay: Bay, set: GeometrySet, look: u32, builder: &mut Builder) {
    let seat = SEAT.min(bay.height() * 0.58);
    let cover = if look % 2 == 1 { Cover::Open } else { Cover::Closed };
    let behind = match set {
        GeometrySet::Plain => (bay.depth() * 0.18).min(0.12),
        GeometrySet::Industrial => (bay.depth() * 0.14).min(0.09),
        _ => (bay.depth() * 0.27).min(0.18),
    };
    let (outline, foot) = bowl_and_foot(set, look);
    let room = bay.without(Side::Back, if set == GeometrySet::Plain { behind - 0.002 } else { behind * 0.8 });
    let bowl = Bowl { bay: room.with_y([bay.low.y, bay.low.y + seat]), outline, seat: bay.low.y + seat };
    let cistern = bay.slab(Side::Back, behind);
    match set {
        GeometrySet::Plain => {
            bowl.pan(builder, Slot::Ceramic, foot);
            bowl.seat(builder, Slot::Plastic, cover, bay.high.y);
            flush_case(builder, cistern, look);
        }
        GeometrySet::Traditional => {
            bowl.pan(builder, Slot::Ceramic, foot);
            bowl.seat(builder, if look % 4 < 2 { Slot::WoodDark } else { Slot::Plastic }, cover, bay.high.y);
            moulded_cistern(builder, cistern, bowl.seat, look);
        }
        GeometrySet::Industrial => {
            bowl.pan(builder, if look % 4 < 2 { Slot::Metal } else { Slot::Ceramic }, foot);
            let cover = if look.is_multiple_of(2) { Cover::None } else { Cover::Open };
            bowl.seat(builder, Slot::PlasticDark, cover, bay.high.y);
            flush_pipe(builder, cistern, bowl.seat);
        }
        GeometrySet::Budget => {
            bowl.pan(builder, Slot::Ceramic, foot);
            bowl.seat(
                builder,
                if look % 4 == 3 { Slot::PlasticDark } else { Slot::Plastic },
                cover,
                bay.high.y,
            );
            plain_cistern(
                builder,
                cistern,
                bowl.seat,
                if look % 4 < 2 { Slot::Ceramic } else { Slot::Plastic },
            );
        }
    }
}

/// The outline of the bowl, and what carries it.
fn bowl_and_foot(set: GeometrySet, look: u32) -> (Outline, Foot) {
    match (set, look % 4) {
        (GeometrySet::Plain, 0 | 1) => (bowl_outline(0.8, 0.0), Foot::Hung),
        (GeometrySet::Plain, _) => (bowl_outline(1.0, 0.1), Foot::Skirted),
        (GeometrySet::Budget, 2 | 3) => (bowl_outline(0.9, 0.0), Foot::Skirted),
        (_, _) => (bowl_outline(1.0, 0.14), Foot::Pedestal),
    }
}

/// The case of a concealed cistern with its flush plate.
fn flush_case(builder: &mut Builder, bay: Bay, look: u32) {
    let slot = [Slot::TileWall, Slot::Painted, Slot::Ceramic, Slot::Wood][look as usize % 4];
    builder.block(slot, bay, 0.004);
    let (width, height) = (bay.width() * 0.6, (bay.height() * 0.2).min(0.15));
    let middle = DVec3::new(bay.center().x, bay.high.y - height * 0.75, bay.high.z);
    let plate = Bay::around(middle, width, height, 0.016);
    builder.block(Slot::Chrome, plate, 0.003);
    for (side, share) in [(-1.0, 0.52), (1.0, 0.3)] {
        let key = middle + DVec3::X * side * width * 0.2;
        let button = Bay::around(key, width * share * 0.75, height * 0.62, 0.022);
        builder.block(if look.is_multiple_of(2) { Slot::Metal } else { Slot::Plastic }, button, 0.002);
    }
}

/// A ceramic cistern with a moulded lid and a lever.
fn moulded_cistern(builder: &mut Builder, bay: Bay, seat: f64, look: u32) {
    let tank = bay.with_y([seat * 0.86, bay.high.y]);
    let (half, middle) = (tank.extent() / 2.0, tank.center());
    let slice = |share: f64, back: f64| {
        let y = tank.low.y + share * tank.height();
        Slice::new(y, half.x - back, half.z - back / 2.0).at(middle.x, middle.z - back / 2.0).softened(0.02)
    };
    let slices = [
        slice(0.0, 0.04),
        slice(0.12, 0.02),
        slice(0.86, 0.012),
        slice(0.87, 0.0),
        slice(0.92, 0.0),
        slice(0.93, 0.008),
        slice(1.0, 0.02),
    ];
    builder.add(Slot::Ceramic, loft(&Outline::Soft(1), &slices));
    let slot = if look % 4 < 2 { Slot::Brass } else { Slot::Chrome };
    let (y, z) = (tank.low.y + tank.height() * 0.72, tank.high.z - 0.012);
    let x = middle.x - half.x * 0.55;
    let lever = [
        DVec3::new(x, y, z - 0.01),
        DVec3::new(x, y, z + 0.012),
        DVec3::new(x + half.x * 0.4, y - 0.012, z + 0.012),
    ];
    builder.add(slot, sweep(&lever, 0.006, 6));
    let neck = bay.inset(bay.width() * 0.3, 0.0, 0.0).with_y([seat * 0.45, tank.low.y + 0.02]);
    builder.cuboid(Slot::Ceramic, neck.without(Side::Back, 0.004).without(Side::Front, -0.03));
}

/// A pipe from the wall's height to the bowl with a valve that closes by itself.
fn flush_pipe(builder: &mut Builder, bay: Bay, seat: f64) {
    let (x, z) = (bay.center().x, bay.center().z);
    let radius = (bay.depth() * 0.25).min(0.018);
    let foot = seat * 0.62;
    let path = [
        DVec3::new(x, bay.high.y, z),
        DVec3::new(x, foot + radius * 2.0, z),
        DVec3::new(x, foot, z + radius * 2.0),
        DVec3::new(x, foot, bay.high.z + 0.03),
    ];
    builder.add(Slot::Chrome, sweep(&path, radius, 8));
    let valve = bay.low.y + seat + (bay.high.y - seat) * 0.62;
    let body = lathe(
        &[
            (radius * 1.5, valve - 0.04),
            (radius * 1.9, valve - 0.02),
            (radius * 1.9, valve + 0.03),
            (radius * 1.2, valve + 0.05),
        ],
        8,
    );
    builder.add(Slot::Metal, body.moved(x, 0.0, z));
    let lever =
        [DVec3::new(x, valve, z), DVec3::new(x, valve, z + 0.05), DVec3::new(x, valve - 0.035, z + 0.09)];
    builder.add(Slot::MetalDark, sweep(&lever, 0.007, 6));
    for y in [seat + 0.02, bay.high.y - 0.06] {
        let clamp =
            Bay::new([x - radius * 1.3, x + radius * 1.3], [y, y + 0.02], [bay.low.z, z + radius * 1.25]);
        builder.cuboid(Slot::MetalDark, clamp);
    }
}

/// A cistern of plain boxes with a round button.
fn plain_cistern(builder: &mut Builder, bay: Bay, seat: f64, slot: Slot) {
    let tank = bay.with_y([seat * 0.86, bay.high.y]);
    let lid = 0.03;
    let body = tank.without(Side::Above, lid - SINK).inset(0.012, 0.0, 0.0).without(Side::Front, 0.012);
    builder.block(slot, body, 0.014);
    builder.block(slot, tank.slab(Side::Above, lid).without(Side::Above, 0.005), 0.008);
    let button = cylinder(0.022, [bay.high.y - 0.006, bay.high.y], 8);
    builder.add(Slot::Chrome, button.moved(tank.center().x, 0.0, tank.center().z));
    let neck = bay.inset(bay.width() * 0.28, 0.0, 0.0).with_y([seat * 0.4, tank.low.y + 0.02]);
    builder.cuboid(Slot::Ceramic, neck.without(Side::Back, 0.004).without(Side::Front, -0.03));
    let hose = [
        DVec3::new(body.high.x - 0.03, tank.low.y + 0.01, bay.low.z + 0.03),
        DVec3::new(body.high.x - 0.03, seat * 0.4, bay.low.z + 0.03),
        DVec3::new(body.high.x - 0.03, seat * 0.4, bay.low.z),
    ];
    builder.add(Slot::Chrome, sweep(&hose, 0.006, 6));
}
