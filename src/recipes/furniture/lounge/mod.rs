//! Upholstered seats: sofas and easy chairs. A seat takes 0.55 to 0.65 m of width, is 0.42 to 0.45 m high and about
//! as deep as 0.55 m before its back cushion (typical of makers' catalogues).

mod budget;
mod industrial;
mod plain;
mod traditional;

use std::f64::consts::FRAC_PI_2;

use super::seating::seat_height;

use crate::geometry::Side;

use crate::recipes::kit::{Bay, Builder, SINK, crowned};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres that one person takes on a sofa.
const PERSON: f64 = 0.65;

/// Metres of air between neighbouring cushions.
const SEAM: f64 = 0.004;

/// A sofa; `seats` cushions, or as many as its width holds.
pub(super) static SOFA: Recipe =
    Recipe::furniture("sofa", [2.2, 0.9, 0.82]).with(&[("seats", 0.0)]).symbol(Symbol::Sofa).every_set(sofa);

fn sofa(draft: &Draft, builder: &mut Builder) {
    let arm = arm_width(builder.bay());
    let width = builder.bay().width() - 2.0 * arm;
    let choice = (width / PERSON).round().clamp(1.0, 6.0) as u32;
    upholstered(draft, builder, draft.count("seats", choice).min(6));
}

/// A sofa for one.
pub(super) static ARMCHAIR: Recipe =
    Recipe::furniture("armchair", [0.85, 0.85, 0.82]).symbol(Symbol::Sofa).every_set(armchair);

fn armchair(draft: &Draft, builder: &mut Builder) {
    upholstered(draft, builder, 1);
}

fn arm_width(bay: Bay) -> f64 {
    (bay.width() * 0.16).min(0.18)
}

/// The measures and materials of one sofa.
struct Sofa {
    bay: Bay,
    slot: Slot,
    seats: u32,
    /// Metres of the seat over the floor.
    seat: f64,
    /// Metres of an arm's width.
    arm: f64,
    /// Metres of the back's depth with its cushions.
    back: f64,
    form: u32,
}

fn upholstered(draft: &Draft, builder: &mut Builder, seats: u32) {
    let bay = builder.bay();
    let form = draft.input.look % 4;
    let slot = match (draft.set(), form) {
        (GeometrySet::Industrial, 0..=2) | (GeometrySet::Traditional, 1) | (GeometrySet::Plain, 2) => {
            Slot::Leather
        }
        (GeometrySet::Plain | GeometrySet::Budget, 3) => Slot::FabricAccent,
        _ => Slot::Fabric,
    };
    let back = (bay.depth() * 0.24).min(0.22);
    let sofa = Sofa { bay, slot, seats, seat: seat_height(bay.height()), arm: arm_width(bay), back, form };
    match draft.set() {
        GeometrySet::Plain => plain::plain(&sofa, builder),
        GeometrySet::Traditional => traditional::traditional(&sofa, builder),
        GeometrySet::Industrial => industrial::industrial(&sofa, builder),
        GeometrySet::Budget => budget::budget(&sofa, builder),
    }
}

impl Sofa {
    /// The space between arms of a width.
    fn between(&self, arm: f64) -> Bay {
        self.bay.inset(arm + SEAM, 0.0, 0.0)
    }

    /// Height of arm rests: 0.2 m over the seat or less.
    fn arm_top(&self) -> f64 {
        self.seat + (self.bay.height() * 0.22).min(0.18)
    }

    /// Seat cushions side by side, from `low` to the seat's height.
    fn seat_cushions(&self, builder: &mut Builder, inner: Bay, low: f64, crown: f64) {
        let bay = inner.with_y([low, self.seat - 0.008]).without(Side::Back, self.back * 0.85);
        for column in bay.columns(self.seats, SEAM) {
            builder.add(self.slot, crowned(column, 0.035, crown + 0.018));
        }
    }

    /// Back cushions, bulging to the front, from the seat up to `high`, that lean against something `behind` deep.
    fn back_cushions(&self, builder: &mut Builder, inner: Bay, high: f64, behind: f64) {
        let z = [self.bay.low.z + behind - SINK, self.bay.low.z + self.back];
        let (low, deep) = (self.seat - 0.02, z[1] - z[0]);
        for column in inner.columns(self.seats, SEAM) {
            let flat =
                Bay::new([-column.width() / 2.0, column.width() / 2.0], [0.0, deep], [0.0, high - low]);
            let cushion = crowned(flat, 0.04, deep * 0.3).turned_x(FRAC_PI_2);
            builder.add(self.slot, cushion.moved(column.center().x, high, z[0]));
        }
    }

    /// A frame of rails under the seat and behind the back.
    fn carcass(&self, builder: &mut Builder, foot: f64, top: f64, arm: f64) {
        let base = self.bay.with_y([foot, top]).inset(arm * 0.5, 0.0, 0.008);
        builder.block(self.slot, base, 0.012);
    }

    /// The upholstered wall behind the back cushions.
    fn back_wall(&self, builder: &mut Builder, inner: Bay, y: [f64; 2], deep: f64) {
        let wall = inner.inset(-0.012, 0.0, 0.0).slab(Side::Back, deep).with_y(y);
        builder.block(self.slot, wall, 0.025);
    }
}
