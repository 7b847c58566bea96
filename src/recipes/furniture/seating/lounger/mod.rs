//! Sun loungers: 1.9 to 2.0 m long, 0.6 to 0.7 wide, lying is 0.3 m over the floor (EN 581, typical). They lie along x,
//! the head raised on the left.

mod folding;
mod padded;
mod pallets;
mod steamer;

use crate::recipes::kit::{Bay, Builder, Solid};
use crate::recipes::{Draft, GeometrySet, Recipe, Symbol};

/// Share of the length that the raised part takes.
const HEAD: f64 = 0.36;

/// A sun lounger: cushions on a low frame; slats with wheels, arm rests and handles; pallets with a mattress; tube with a
/// sling that folds up.
pub(in super::super) static LOUNGER: Recipe =
    Recipe::furniture("lounger", [1.9, 0.66, 0.4]).symbol(Symbol::Bed).every_set(lounger);

fn lounger(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    let lounger = Lounger::new(builder.bay());
    match draft.set() {
        GeometrySet::Plain => padded::build(&lounger, builder, look),
        GeometrySet::Traditional => steamer::build(&lounger, builder, look),
        GeometrySet::Industrial => pallets::build(&lounger, builder, look),
        GeometrySet::Budget => folding::build(&lounger, builder, look),
    }
}

/// The measures that all loungers share.
struct Lounger {
    bay: Bay,
    /// Metres that one lies over the floor.
    lying: f64,
    /// Where the raised part begins.
    knee: f64,
    /// Radians by which it is raised, so that it ends with the box, and metres of its length.
    slope: f64,
    length: f64,
}

impl Lounger {
    fn new(bay: Bay) -> Self {
        let lying = (bay.height() * 0.72).min(0.32);
        let knee = bay.low.x + bay.width() * HEAD;
        let slope = libm::atan2(bay.high.y - lying, knee - bay.low.x).clamp(0.05, 0.7);
        let length = (knee - bay.low.x) / libm::cos(slope);
        Self { bay, lying, knee, slope, length }
    }

    /// The part one lies on with the legs, of a thickness.
    fn flat(&self, thickness: f64) -> Bay {
        self.bay.with_x([self.knee, self.bay.high.x]).with_y([self.lying - thickness, self.lying])
    }

    /// The raised part of a thickness before it is raised: it ends at the origin.
    fn head(&self, thickness: f64) -> Bay {
        self.bay.with_x([-self.length, 0.0]).with_y([-thickness, 0.0])
    }

    /// A body of the raised part, raised.
    fn raised(&self, solid: Solid) -> Solid {
        solid.turned_z(-self.slope).moved(self.knee, self.lying, 0.0)
    }

    /// How high the raised part lies over a place along it.
    fn height_at(&self, x: f64) -> f64 {
        self.lying + (self.knee - x) * libm::tan(self.slope)
    }
}
