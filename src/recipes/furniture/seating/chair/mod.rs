//! Chairs: four forms in each geometry set. Seats are 0.45 m high (EN 1729, DIN 68878); the back stays within
//! 0.11 m of the rear, as the shape in the catalogue has it, which leans it by the usual 10 to 15 degrees.

mod budget;
mod garden;
mod industrial;
mod plain;
mod school;
mod traditional;

pub(in super::super) use garden::GARDEN_CHAIR;
pub(in super::super) use school::SCHOOL_CHAIR;

use glam::DVec3;

use super::seat_height;

use crate::geometry::Side;

use crate::recipes::kit::{Bay, Builder, Solid, Station, sheet};

use crate::recipes::furniture::parts::slanted_leg;
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of depth in which a chair's back leans.
const BACK_DEPTH: f64 = 0.09;

/// Metres of a tube's radius: steel tube of 22 mm.
const TUBE: f64 = 0.011;

/// The measures that all chairs share.
pub(super) struct Chair {
    /// The box.
    pub(super) bay: Bay,
    /// Half of its width.
    pub(super) half: f64,
    /// Metres of the seat over the floor.
    pub(super) seat: f64,
}

impl Chair {
    fn new(builder: &Builder) -> Self {
        let bay = builder.bay();
        Self { bay, half: bay.width() / 2.0, seat: seat_height(bay.height()) }
    }

    /// A point at a share of the half width, a height, and a share of the depth from back to front.
    fn at(&self, across: f64, y: f64, forward: f64) -> DVec3 {
        DVec3::new(across * self.half, y, self.bay.low.z + forward * self.bay.depth())
    }

    /// z of the back's middle plane at a height: it leans backwards.
    fn lean(&self, y: f64) -> f64 {
        let rise = ((y - self.seat) / (self.bay.high.y - self.seat)).clamp(0.0, 1.0);
        self.bay.low.z + 0.012 + (BACK_DEPTH.min(self.bay.depth() * 0.2) - 0.014) * (1.0 - rise)
    }

    /// The seat as a board or cushion of a thickness.
    fn seat_bay(&self, thickness: f64) -> Bay {
        self.bay.with_y([self.seat - thickness, self.seat]).without(Side::Back, 0.03)
    }

    /// A share of the height of the back over the seat.
    fn rise(&self, share: f64) -> f64 {
        self.seat + share * (self.bay.high.y - self.seat)
    }

    /// Four slanted legs from under the seat to the corners of the box.
    fn slanted_legs(&self, builder: &mut Builder, slot: Slot, radius: f64, profile: &[(f64, f64)]) {
        let top = self.seat - 0.032;
        for (x, z, end) in [(1.0, 1.0, 0.82), (1.0, 0.0, 0.2)] {
            let inset = radius * 0.6;
            let foot = self.at(x, 0.0, z) + DVec3::new(-inset * x, 0.0, if z > 0.5 { -inset } else { inset });
            let leg = slanted_leg([foot, self.at(0.72, top, end)], radius, profile, 8);
            builder.add_pair(slot, leg);
        }
    }

    /// Seat and back in one bent sheet of a thickness.
    fn shell(&self, thickness: f64, sag: f64, waist: f64) -> Solid {
        let half = self.half * 0.98;
        let z = |y: f64| self.lean(y) + thickness * 0.25;
        let front = self.bay.high.z;
        let back = self.bay.low.z + BACK_DEPTH;
        let seat = self.seat - thickness;
        let station = |z: f64, y: f64, share: f64, sag: f64| Station {
            at: DVec3::new(0.0, y, z),
            half_width: half * share,
            sag,
        };
        let (low, middle, high) = (self.rise(0.18), self.rise(0.5), self.bay.high.y);
        let stations = [
            station(front - 0.004, seat - 0.035, 0.9, sag * 0.3),
            station(front - 0.02, seat - 0.006, 0.97, sag * 0.6),
            station(front - 0.1, seat - sag * 0.5, 1.0, sag),
            station(back + 0.14, seat - sag, 0.98, sag),
            station(back + 0.045, seat - sag * 0.6, 0.9, sag),
            station(back - 0.015 - thickness * 0.5, seat + 0.035, waist, sag * 0.8),
            station(z(low), low, waist, sag * 0.5),
            station(z(middle), middle, 0.92, sag * 0.5),
            station(z(high - 0.05), high - 0.05, 0.9, sag * 0.5),
            station(z(high - 0.004), high - 0.004, 0.7, sag * 0.4),
        ];
        sheet(&stations, DVec3::NEG_X, thickness, 4)
    }
}

/// A chair.
pub(in super::super) static CHAIR: Recipe =
    Recipe::furniture("chair", [0.45, 0.5, 0.88]).symbol(Symbol::Chair).every_set(chair);

fn chair(draft: &Draft, builder: &mut Builder) {
    let chair = Chair::new(builder);
    let forms: [fn(&Chair, &mut Builder); 4] = match draft.set() {
        GeometrySet::Plain => [plain::bent_ply, plain::upholstered, plain::curved_rail, plain::padded_sled],
        GeometrySet::Traditional => [
            traditional::spindle_back,
            traditional::splat_back,
            traditional::ladder_back,
            traditional::framed_back,
        ],
        GeometrySet::Industrial => [
            industrial::sheet_metal,
            industrial::pipe_and_planks,
            industrial::lattice,
            industrial::screw_seat,
        ],
        GeometrySet::Budget => [budget::plastic_shell, budget::stacking, budget::monobloc, budget::folding],
    };
    forms[draft.form()](&chair, builder);
}
