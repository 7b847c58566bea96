//! Bodies, borders and regions that are kept free, near a region: for the rules that weigh a place.

use crate::geometry::{Bounds, Point, Solid};
use crate::layout::constants::{CLEARANCE_TOLERANCE, CONTACT_TOLERANCE};
use crate::layout::place::{AgentIndex, Place};
use crate::layout::surroundings::Border;

use super::{Environment, ROOM};

impl Environment<'_> {
    /// Calls `visit` with every body that meets a region, relatives of nobody excepted.
    pub(crate) fn each_obstacle(&self, region: &Solid, mut visit: impl FnMut(&Solid, bool)) {
        self.body_grid.each_under(&region.base, |index| {
            let body = &self.bodies[index as usize];
            // The sides of a region along a wall are what most bodies lie apart from: they are asked first.
            if region.overlaps(&body.solid, CONTACT_TOLERANCE) {
                visit(&body.solid, body.is_flat);
            }
        });
    }

    /// Whether a body that is more than a rug meets a region.
    pub(crate) fn is_taken(&self, region: &Solid) -> bool {
        self.body_grid.any(region.bounds, |index| {
            let body = &self.bodies[index as usize];
            !body.is_flat && region.overlaps(&body.solid, CONTACT_TOLERANCE)
        })
    }

    /// Calls `visit` with every door's way and clearance that meets a region.
    pub(crate) fn each_kept_free(&self, region: &Solid, mut visit: impl FnMut(&Solid)) {
        self.kept_free_grid.each_under(&region.base, |index| {
            let solid = &self.kept_free[index as usize].solid;
            if region.overlaps(solid, CONTACT_TOLERANCE) {
                visit(solid);
            }
        });
        self.clearance_grid.each_under(&region.base, |index| {
            let solid = &self.clearances[index as usize].solid;
            if region.overlaps(solid, CLEARANCE_TOLERANCE) {
                visit(solid);
            }
        });
    }

    /// Whether a border comes nearer to the middle of an agent than any of its own edges: whatever its shape, it is
    /// outside then. Seen without making the shape, which is what most of a scan meets.
    pub(super) fn is_cut_through(&self, agent: AgentIndex, place: &Place) -> bool {
        let (shape, size) = (&self.class(agent).shape, self.agents[agent].size);
        if !shape.fills_its_box() {
            return false;
        }
        // By twice the tolerance, so that the exact test, which rounds otherwise, agrees.
        let radius = size.width.min(size.depth) / 2.0 - 2.0 * CONTACT_TOLERANCE;
        let middle = place.pose.position;
        let around = Bounds::around_point(middle, radius);
        radius > 0.0
            && self.brief.surroundings.border_grid.any(around, |index| {
                let border = &self.brief.surroundings.borders[index as usize];
                border.segment.distance_squared(middle) < radius * radius
            })
    }

    /// Calls `visit` with every border of the room near a region.
    pub(crate) fn each_border(&self, region: &Solid, mut visit: impl FnMut(&Border)) {
        self.brief
            .surroundings
            .border_grid
            .each_under(&region.base, |index| visit(&self.brief.surroundings.borders[index as usize]));
    }

    /// Calls `visit` with every part of a resting agent near a place, and its owner.
    pub(crate) fn each_part_near(&self, place: Point, reach: f64, mut visit: impl FnMut(AgentIndex, &Solid)) {
        self.body_grid.each(Bounds::around_point(place, reach), |index| {
            let body = &self.bodies[index as usize];
            // Columns go nowhere: only agents can be sent away from a way.
            if body.owner != ROOM {
                visit(body.owner, &body.solid);
            }
        });
    }
}
