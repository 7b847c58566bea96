//! Pieces on castors: trolleys, drip stands.

mod drip_stand;
mod luggage_trolley;
mod serving_trolley;
mod tool_carts;
mod tool_trolley;

pub(super) use drip_stand::DRIP_STAND;
pub(super) use luggage_trolley::LUGGAGE_TROLLEY;
pub(super) use serving_trolley::SERVING_TROLLEY;
pub(super) use tool_trolley::TOOL_TROLLEY;

use glam::DVec3;

use super::parts::turned_forward;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, cylinder};

/// A castor under a point at a height over the floor.
fn castor(builder: &mut Builder, at: DVec3, height: f64) {
    let radius = height * 0.42;
    let wheel = turned_forward(cylinder(radius, [-radius * 0.35, radius * 0.35], 10));
    builder.add(Slot::Rubber, wheel.turned_y(std::f64::consts::FRAC_PI_2).moved(at.x, radius, at.z));
    let fork = Bay::around(DVec3::new(at.x, 0.0, at.z), radius * 1.05, 1.0, radius * 0.9);
    builder.cuboid(Slot::Metal, fork.with_y([radius * 0.9, height]));
}

/// Castors near the corners of a bay's floor.
fn castors(builder: &mut Builder, bay: Bay, height: f64) {
    let inset = height * 0.5;
    for x in [bay.low.x + inset, bay.high.x - inset] {
        for z in [bay.low.z + inset, bay.high.z - inset] {
            castor(builder, DVec3::new(x, 0.0, z), height);
        }
    }
}
