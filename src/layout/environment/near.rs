//! What is near a region: bodies, borders and what is kept free, for those who weigh a place.

use crate::geometry::{Point, Solid};
use crate::layout::agent::AgentIndex;
use crate::layout::constants::{CLEARANCE_TOLERANCE, CONTACT_TOLERANCE};

use super::{Border, Environment, ROOM};

impl Environment<'_> {
    /// Calls `visit` with every body that meets a region, relatives of nobody excepted.
    pub(crate) fn each_obstacle(&self, region: &Solid, mut visit: impl FnMut(&Solid, bool)) {
        self.body_grid.each(region.bounds, |index| {
            let body = &self.bodies[index as usize];
            if body.solid.overlaps(region, CONTACT_TOLERANCE) {
                visit(&body.solid, body.is_flat);
            }
        });
    }

    /// Calls `visit` with every door's way and clearance that meets a region.
    pub(crate) fn each_kept_free(&self, region: &Solid, mut visit: impl FnMut(&Solid)) {
        self.kept_free_grid.each(region.bounds, |index| {
            let solid = &self.surroundings.kept_free[index as usize];
            if solid.overlaps(region, CONTACT_TOLERANCE) {
                visit(solid);
            }
        });
        self.clearance_grid.each(region.bounds, |index| {
            let solid = &self.clearances[index as usize].solid;
            if solid.overlaps(region, CLEARANCE_TOLERANCE) {
                visit(solid);
            }
        });
    }

    /// Calls `visit` with every border of the room near a region.
    pub(crate) fn each_border(&self, region: &Solid, mut visit: impl FnMut(&Border)) {
        self.border_grid.each(region.bounds, |index| visit(&self.borders[index as usize]));
    }

    /// Calls `visit` with every part of a resting agent near a place, and its owner.
    pub(crate) fn each_part_near(&self, place: Point, reach: f64, mut visit: impl FnMut(AgentIndex, &Solid)) {
        let around = (place - Point::splat(reach), place + Point::splat(reach));
        self.body_grid.each(around, |index| {
            let body = &self.bodies[index as usize];
            if body.owner != ROOM {
                visit(body.owner, &body.solid);
            }
        });
    }
}
