//! Swivel chairs for work. EN 1335-1: seat 0.40 to 0.51 m high, 0.40 m wide and 0.38 m deep at least; arm rests 0.20
//! to 0.25 m over the seat; foot of five castors, 0.6 to 0.7 m across. Older ones stand on four.

mod budget;
mod industrial;
mod plain;
mod traditional;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use glam::DVec3;

use super::SEAT_HEIGHT;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Solid, Station, cuboid, cylinder, lathe, rounded_box, sheet, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Share of the height at most taken by the seat, where the chair is low.
const SEAT_SHARE: f64 = 0.5;
/// Metres of depth in which the back leans; the shape in the catalogue leaves 0.14.
const BACK_DEPTH: f64 = 0.085;
/// Metres from the rear of the box to the middle of the back at its top.
const BACK_CLEARANCE: f64 = 0.02;
/// Metres of a seat's upholstery.
const PAD: f64 = 0.07;
/// Metres of an arm rest over the seat.
const ARM_RISE: f64 = 0.2;
/// Metres of a castor's radius: 50 mm castors are usual.
const CASTOR: f64 = 0.025;
/// Metres from the floor to the middle of a foot's hub.
const HUB: f64 = 0.09;
/// Metres of a gas spring's radius: its outer tube has 50 mm.
const SPRING: f64 = 0.025;

/// The spokes of a foot on castors.
struct Spokes {
    slot: Slot,
    /// Of the castors.
    wheel: Slot,
    count: u32,
    thickness: f64,
}

/// The measures that all swivel chairs share.
struct Swivel {
    bay: Bay,
    /// Half of its width and depth.
    half: f64,
    /// Metres of the seat over the floor.
    seat: f64,
}

impl Swivel {
    fn new(builder: &Builder) -> Self {
        let bay = builder.bay();
        let half = bay.width().min(bay.depth()) / 2.0;
        Self { bay, half, seat: SEAT_HEIGHT.min(bay.height() * SEAT_SHARE) }
    }

    /// A height at a share of the back, from the seat to the top.
    fn rise(&self, share: f64) -> f64 {
        self.seat + share * (self.bay.high.y - self.seat)
    }

    /// z of the back's middle at a height: it leans backwards.
    fn lean(&self, y: f64) -> f64 {
        let rise = ((y - self.seat) / (self.bay.high.y - self.seat)).clamp(0.0, 1.0);
        self.bay.low.z + BACK_CLEARANCE + (BACK_DEPTH - BACK_CLEARANCE) * (1.0 - rise)
    }

    /// Height of the underside of the seat's upholstery, where the mechanism begins.
    fn under(&self) -> f64 {
        self.seat - PAD
    }

    /// The seat as a board or cushion of a thickness, as wide as a share of the chair.
    fn seat_bay(&self, thickness: f64, share: f64) -> Bay {
        let bay = self.bay.with_y([self.seat - thickness, self.seat]);
        bay.inset(self.half * (1.0 - share), 0.0, self.half * 0.16).without(Side::Back, self.half * 0.04)
    }

    /// A back in one bent sheet through (share of the rise, share of the half width), its edges `wrap` metres before
    /// its middle.
    fn back(&self, profile: &[(f64, f64)], thickness: f64, wrap: f64) -> Solid {
        let station = |&(rise, wide): &(f64, f64)| {
            let y = self.rise(rise);
            Station { at: DVec3::new(0.0, y, self.lean(y)), half_width: self.half * wide, sag: wrap }
        };
        let stations: Vec<Station> = profile.iter().map(station).collect();
        sheet(&stations, DVec3::NEG_X, thickness, 4)
    }

    /// Five spokes on castors around a hub, and the gas spring with the mechanism on it.
    fn five_star(&self, builder: &mut Builder, slot: Slot, spring: Slot) {
        self.spokes(builder, &Spokes { slot, wheel: Slot::Rubber, count: 5, thickness: 0.017 });
        builder.add(slot, lathe(&[(0.045, HUB - 0.025), (0.05, HUB), (SPRING, HUB + 0.035)], 8));
        builder.add(spring, cylinder(SPRING * 0.9, [HUB, self.under() - 0.02], 8));
        self.mechanism(builder, Slot::PlasticDark);
    }

    /// The tilting gear under a seat.
    fn mechanism(&self, builder: &mut Builder, slot: Slot) {
        let middle = DVec3::new(0.0, self.under() - 0.012, -self.half * 0.06);
        builder.cuboid(slot, Bay::around(middle, self.half * 0.55, 0.032, self.half * 0.75));
    }

    /// Spokes that slope from the hub to castors, the first to the front.
    fn spokes(&self, builder: &mut Builder, spokes: &Spokes) {
        let &Spokes { slot, wheel, count, thickness } = spokes;
        let reach = self.half - CASTOR;
        let bar = [DVec3::new(0.0, HUB, 0.02), DVec3::new(0.0, CASTOR * 2.2, reach)];
        for spoke in 0..count {
            let angle = TAU * f64::from(spoke) / f64::from(count);
            builder.add(slot, sweep(&bar, thickness, 4).turned_y(angle));
            let castor = cylinder(CASTOR, [-0.02, 0.02], 8).turned_z(FRAC_PI_2);
            builder.add(wheel, castor.moved(0.0, CASTOR, reach).turned_y(angle));
        }
    }

    /// Arm rests on posts that come from under the seat.
    fn t_arms(&self, builder: &mut Builder, post: Slot, pad: Slot) {
        let (x, top, y) = (self.bay.high.x - 0.028, self.seat + ARM_RISE, self.under() - 0.008);
        let path =
            [DVec3::new(self.half * 0.2, y, 0.0), DVec3::new(x, y, 0.0), DVec3::new(x, top - 0.02, 0.0)];
        builder.add_pair(post, sweep(&path, 0.015, 4));
        let rest = Bay::around(DVec3::new(x, top - 0.012, 0.0), 0.056, 0.026, self.half * 0.8);
        builder.add_pair(pad, rounded_box(rest, DVec3::splat(0.009), 1));
    }

    /// A bar from the mechanism backwards and up to a share of the back.
    fn spine(&self, builder: &mut Builder, slot: Slot, share: f64, thickness: f64) {
        let (y, end) = (self.under() - 0.012, self.rise(share));
        let heel = self.lean(self.seat) - 0.03;
        let path = [
            DVec3::new(0.0, y, -self.half * 0.3),
            DVec3::new(0.0, y, heel),
            DVec3::new(0.0, end, self.lean(end) - thickness * 0.7),
        ];
        builder.add(slot, sweep(&path, thickness, 4));
    }

    /// Four straight legs from a hub under the seat to the corners of the box, with a ring for the feet.
    fn four_legs(&self, builder: &mut Builder, slot: Slot, thickness: f64) {
        let foot = self.half - thickness;
        let high = self.under() - 0.03;
        for (x, z) in [(1.0, 1.0), (1.0, -1.0)] {
            let path = [
                DVec3::new(foot * x, thickness * 0.4, foot * z),
                DVec3::new(foot * 0.62 * x, high * 0.72, foot * 0.62 * z),
                DVec3::new(0.02 * x, high, 0.02 * z),
            ];
            builder.add_pair(slot, sweep(&path, thickness, 4));
        }
        let ring: Vec<DVec3> = (0..=8)
            .map(|step| {
                let (sine, cosine) = libm::sincos(FRAC_PI_4 * (f64::from(step) * 0.999 + 0.003));
                DVec3::new(cosine, 0.0, sine) * self.half * 0.95 + DVec3::Y * high * 0.42
            })
            .collect();
        builder.add(slot, sweep(&ring, thickness * 0.5, 6));
    }
}

/// A swivel chair.
pub(in super::super) static OFFICE_CHAIR: Recipe = Recipe::furniture("office_chair", [0.62, 0.62, 1.05])
    .round()
    .symbol(Symbol::Chair)
    .every_set(office_chair);

fn office_chair(draft: &Draft, builder: &mut Builder) {
    let chair = Swivel::new(builder);
    let forms: [fn(&Swivel, &mut Builder); 4] = match draft.set() {
        GeometrySet::Plain => [plain::mesh_back, plain::padded_shell, plain::executive, plain::bent_ply],
        GeometrySet::Traditional => [
            traditional::spindle_back,
            traditional::buttoned,
            traditional::slat_back,
            traditional::framed_back,
        ],
        GeometrySet::Industrial => {
            [industrial::machinist, industrial::planks, industrial::leather_stool, industrial::perforated]
        }
        GeometrySet::Budget => [budget::typist, budget::loop_arms, budget::plastic_shell, budget::two_pads],
    };
    forms[draft.form()](&chair, builder);
}

/// A flat bar between two points, as wide along x as given.
fn flat_bar([from, to]: [DVec3; 2], width: f64, thickness: f64) -> Solid {
    let along = to - from;
    let bar =
        Bay::new([-width / 2.0, width / 2.0], [0.0, along.length()], [-thickness / 2.0, thickness / 2.0]);
    cuboid(bar).turned_x(libm::atan2(along.z, along.y)).moved(from.x, from.y, from.z)
}
