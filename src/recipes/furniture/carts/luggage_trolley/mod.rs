//! Luggage trolleys: birdcages of hotels are 1.1 m long, 0.6 wide and 1.8 high; those of airports and stations 1.0 m high,
//! so that one sees over what is on them, with a deck 0.15 to 0.25 m over the floor.

mod airport;
mod platforms;

use glam::DVec3;

use super::{castor, castors};
use crate::recipes::furniture::parts::{HandleForm, HandleKind, handle};
use crate::recipes::kit::{Bay, Builder, SINK, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A luggage trolley: of an airport, with a basket; a birdcage of brass over a carpet; planks on four large wheels; a
/// folding one with a plastic deck.
pub(in super::super) static LUGGAGE_TROLLEY: Recipe =
    Recipe::furniture("luggage_trolley", [0.6, 1.0, 1.0]).every_set(luggage_trolley);

fn luggage_trolley(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    let floor = match draft.set() {
        GeometrySet::Plain => airport::trolley(builder, look),
        GeometrySet::Traditional => birdcage(builder),
        GeometrySet::Industrial => platforms::barrow(builder, look),
        GeometrySet::Budget => platforms::folding(builder, look),
    };
    if look.is_multiple_of(2) {
        suitcases(builder, floor - SINK);
    }
}

/// A carpeted deck of brass under two bows and the rails between them; gives the height of the deck.
fn birdcage(builder: &mut Builder) -> f64 {
    let bay = builder.bay();
    let lift = 0.13_f64.min(bay.height() * 0.2);
    let inner = bay.inset(0.02, 0.0, 0.02);
    castors(builder, inner, lift);
    builder.block(Slot::Brass, bay.with_y([lift - SINK, lift + 0.035]), 0.008);
    let carpet = bay.inset(0.02, 0.0, 0.02).with_y([lift + 0.034, lift + 0.042]);
    builder.cuboid(Slot::Carpet, carpet);
    let radius = 0.014;
    let top = bay.high.y - radius;
    let x = inner.high.x - 0.01;
    let at = |y: f64, z: f64| DVec3::new(x, y, z);
    let (near, far) = (inner.high.z - 0.01, inner.low.z + 0.01);
    let rise = bay.height() * 0.2;
    let path = [
        at(lift + 0.02, far),
        at(top - rise, far),
        at(top - rise * 0.3, far * 0.7),
        at(top, far * 0.3),
        at(top, near * 0.3),
        at(top - rise * 0.3, near * 0.7),
        at(top - rise, near),
        at(lift + 0.02, near),
    ];
    builder.add_pair(Slot::Brass, sweep(&path, radius, 6));
    // Rails where the bows bend, and one to hang coats on.
    for (y, z) in [(top - rise * 0.3, far * 0.7), (top, 0.0), (top - rise * 0.3, near * 0.7)] {
        let bar = [-x, x].map(|x| DVec3::new(x, y, z));
        builder.add(Slot::Brass, sweep(&bar, radius * 0.9, 6));
    }
    carpet.high.y
}

/// Two suitcases on a floor, one on the other.
fn suitcases(builder: &mut Builder, floor: f64) {
    let bay = builder.bay();
    let room = bay.height() * 0.55;
    let mut low = floor;
    for (share, slot, wide, deep) in
        [(0.46, Slot::Leather, 0.8, 0.52), (0.32, Slot::FabricAccent, 0.66, 0.42)]
    {
        let tall = room * share;
        let middle = DVec3::new(0.0, low + tall / 2.0, bay.depth() * 0.1);
        let case = Bay::around(middle, bay.width() * wide, tall, bay.depth() * deep);
        builder.block(slot, case, 0.02);
        let grip = DVec3::new(0.0, case.center().y, case.high.z);
        handle(builder, Slot::PlasticDark, HandleForm { kind: HandleKind::Level, length: 0.14 }, grip, 0.02);
        for x in [-0.3, 0.3] {
            let middle = case.center() + DVec3::X * x * case.width();
            builder.cuboid(Slot::Rubber, Bay::around(middle, 0.02, tall + 0.004, case.depth() + 0.004));
        }
        low += tall - SINK;
    }
}
