//! Workbenches: 1.5 to 2.0 m wide, 0.60 to 0.75 deep, their surface 0.84 to 0.90 high, tops 0.03 to 0.09 thick.

mod joinery;
mod steel;

use glam::DVec3;

use super::parts::{ball, turned_forward};
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres between the surface and the top of the box, which is that of the vice's jaws: those of engineers' vices are 0.1
/// to 0.15 m over the bench.
const RISE: f64 = 0.12;
/// Metres of depth before the top's edge, for the vice.
const EDGE: f64 = 0.05;
/// Share of the width at the left that the vice may take.
const VICE: f64 = 0.28;

/// A bench with a vice: a steel frame with a chest of drawers; a joiner's bench; a welded frame with a board for tools;
/// a sheet on trestles with a clamp.
pub(super) static WORKBENCH: Recipe = Recipe::furniture("workbench", [2.0, 0.75, 0.98])
    .plain(steel::with_drawers)
    .traditional(|_, builder| joinery::joiners_bench(builder))
    .industrial(|_, builder| steel::welded(builder))
    .budget(|_, builder| joinery::on_trestles(builder));

/// The bay of a top of a thickness, with the surface below the box's top.
fn top_bay(bay: Bay, thickness: f64) -> Bay {
    let surface = bay.high.y - RISE;
    bay.with_y([surface - thickness, surface]).with_z([bay.low.z, bay.high.z - EDGE])
}

/// The middle of the vice along the front.
fn vice_middle(bay: Bay) -> f64 {
    bay.low.x + bay.width() * VICE * 0.56
}

/// A screw's hub that looks forward, with a bar through it that hangs crooked; `at` is the hub's back.
fn screw_handle(builder: &mut Builder, [hub, bar]: [Slot; 2], at: DVec3, length: f64) {
    let front = builder.bay().high.z;
    let radius = (front - at.z).min(0.022);
    let body = turned_forward(cylinder(radius, [at.z - SINK, front], 10));
    builder.add(hub, body.moved(at.x, at.y, 0.0));
    let z = front - radius;
    let along = DVec3::new(0.34, -0.94, 0.0) * length;
    let middle = DVec3::new(at.x, at.y, z) + along * 0.3;
    let ends = [middle - along * 0.5, middle + along * 0.5];
    builder.add(bar, sweep(&ends, 0.008, 6));
    for end in ends {
        builder.add(bar, ball(0.014, 8).moved(end.x, end.y, end.z));
    }
}
