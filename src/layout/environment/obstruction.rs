//! Whether an agent can stand at a place, and what is in the way: every rule once, for the search and for explanations.
//!
//! The search stops at the first obstacle. An explanation hands in a recorder that wants them all.

use std::cell::{Cell, OnceCell};
use std::collections::BTreeSet;

use crate::catalog::{Shape, Size};
use crate::geometry::{Bounds, Grid, Solid};
use crate::layout::body::{append_solids, box_solid};
use crate::layout::constants::{CONTACT_TOLERANCE, STEPS_A_TEST};
use crate::layout::furnished::RemovalReason;
use crate::layout::place::{AgentIndex, Place};
use crate::layout::surroundings::Border;
use crate::layout::trace::Obstacle;

use super::{Environment, ROOM};

/// Takes the obstacles that a test of a place meets.
pub(crate) trait Recorder {
    /// Whether a test ends at the first obstacle.
    const FIRST_IS_ENOUGH: bool;

    /// Takes an obstacle.
    fn record(&mut self, obstacle: Obstacle);
}

/// Nobody asks what is in the way.
impl Recorder for () {
    const FIRST_IS_ENOUGH: bool = true;

    fn record(&mut self, _: Obstacle) {}
}

/// All that is in the way, by the first reason for which the place is refused.
impl Recorder for BTreeSet<Obstacle> {
    const FIRST_IS_ENOUGH: bool = false;

    fn record(&mut self, obstacle: Obstacle) {
        self.insert(obstacle);
    }
}

/// Whether an item near a box is an obstacle. Records it, and the others too if the first is not enough.
pub(super) fn any_obstacle<R: Recorder>(
    grid: &Grid,
    bounds: Bounds,
    recorder: &mut R,
    mut obstacle: impl FnMut(usize) -> Option<Obstacle>,
) -> bool {
    let mut is_met = false;
    grid.any(bounds, |item| {
        let Some(obstacle) = obstacle(item as usize) else { return false };
        recorder.record(obstacle);
        is_met = true;
        R::FIRST_IS_ENOUGH
    });
    is_met
}

/// An agent's body where it would stand.
pub(super) struct Probe<'a> {
    /// Who.
    pub(super) agent: AgentIndex,
    /// Where.
    pub(super) place: &'a Place,
    /// Its box.
    pub(super) whole: Solid,
    shape: &'a Shape,
    size: Size,
    /// Its true shape, made when the box does not decide.
    parts: OnceCell<Vec<Solid>>,
    /// Where to take the memory for it from.
    spare: &'a Cell<Vec<Solid>>,
}

impl Probe<'_> {
    /// Whether the body and a solid share more than a contact.
    pub(super) fn meets(&self, solid: &Solid, tolerance: f64) -> bool {
        self.whole.overlaps(solid, tolerance)
            && (*self.shape == Shape::Box || self.parts().iter().any(|part| part.overlaps(solid, tolerance)))
    }

    fn parts(&self) -> &[Solid] {
        self.parts.get_or_init(|| {
            let mut parts = self.spare.take();
            parts.clear();
            append_solids(&mut parts, self.shape, self.size, &self.place.pose);
            parts
        })
    }
}

impl Environment<'_> {
    /// Whether an agent can stand at a place.
    pub(crate) fn is_free(&self, agent: AgentIndex, place: &Place) -> bool {
        self.obstruction(agent, place, &mut ()).is_none()
    }

    /// Why an agent cannot stand at a place, or `None` if it can; the recorder takes what is in the way. Cheap questions
    /// first.
    pub(crate) fn obstruction<R: Recorder>(
        &self,
        agent: AgentIndex,
        place: &Place,
        recorder: &mut R,
    ) -> Option<RemovalReason> {
        self.count_steps(1);
        let is_cut_through = self.is_cut_through(agent, place);
        if is_cut_through && R::FIRST_IS_ENOUGH {
            return Some(RemovalReason::Outside);
        }
        // An explanation takes as many steps as the search that it explains.
        self.count_steps(if is_cut_through { 0 } else { STEPS_A_TEST });
        let whole = box_solid(self.agents[agent].size, &place.pose);
        let height = self.brief.surroundings.room.height;
        // Half a millimetre either way: pieces as high as the room fit under its ceiling.
        if whole.low < -CONTACT_TOLERANCE || whole.high > height + CONTACT_TOLERANCE {
            recorder.record(Obstacle::Height);
            return Some(RemovalReason::Outside);
        }
        if self.hangs_in_the_air(agent, place) {
            recorder.record(Obstacle::NoWall);
            return Some(RemovalReason::Outside);
        }
        let (shape, size) = (&self.class(agent).shape, self.agents[agent].size);
        let probe = Probe { agent, place, whole, shape, size, parts: OnceCell::new(), spare: &self.scratch };
        // The reasons are asked in a fixed order; the first one that holds is the one that is reported.
        let reason = self.shape_obstruction(&probe, recorder);
        if let Some(parts) = probe.parts.into_inner() {
            self.scratch.set(parts);
        }
        reason
    }

    fn shape_obstruction<R: Recorder>(&self, probe: &Probe<'_>, recorder: &mut R) -> Option<RemovalReason> {
        // From the cheapest to the dearest: borders are few, bodies many, clearances need a region each.
        if self.is_outside(probe, recorder) {
            Some(RemovalReason::Outside)
        } else if self.has_collision(probe, recorder)
            || self.lies_on_its_like(probe, recorder)
            || self.slides_under_a_stranger(probe, recorder)
        {
            Some(RemovalReason::Collision)
        } else if self.blocks_a_way(probe, recorder)
            || !self.has_clearances(probe.agent, probe.place, false, recorder)
        {
            Some(RemovalReason::Clearance)
        } else {
            None
        }
    }

    /// Whether some part of a body lies outside. A wall may run through its box where the body leaves room for it, so that
    /// obstacles are looked for when the answer is known.
    fn is_outside<R: Recorder>(&self, probe: &Probe<'_>, recorder: &mut R) -> bool {
        if self.is_inside(&probe.whole) || probe.parts().iter().all(|part| self.is_inside(part)) {
            return false;
        }
        if !R::FIRST_IS_ENOUGH {
            let wall = |border: &Border| Some(Obstacle::Wall(border.wall));
            if !self.is_entered(&probe.whole, CONTACT_TOLERANCE, recorder, wall) {
                recorder.record(Obstacle::BeyondWalls);
            }
        }
        true
    }

    /// Whether a solid lies inside the outline and outside the holes.
    pub(crate) fn is_inside(&self, solid: &Solid) -> bool {
        self.lies_inside(solid, CONTACT_TOLERANCE)
    }

    /// The same with a tolerance in metres.
    pub(super) fn lies_inside(&self, solid: &Solid, tolerance: f64) -> bool {
        !self.is_entered(solid, tolerance, &mut (), |border| Some(Obstacle::Wall(border.wall)))
            && self.brief.surroundings.room.region.contains(solid.base.center())
    }

    /// Whether a border that is an obstacle runs through a solid.
    pub(super) fn is_entered<R: Recorder>(
        &self,
        solid: &Solid,
        tolerance: f64,
        recorder: &mut R,
        obstacle: impl Fn(&Border) -> Option<Obstacle>,
    ) -> bool {
        any_obstacle(&self.brief.surroundings.border_grid, solid.bounds, recorder, |index| {
            let border = &self.brief.surroundings.borders[index];
            let is_entered = border.segment.bounds().overlaps(solid.bounds, -tolerance)
                && solid.base.is_entered_by(border.segment, tolerance);
            if is_entered { obstacle(border) } else { None }
        })
    }

    /// The paper leaves the parent out of the test; here its true shape takes part, because a chair that slides
    /// under a table may touch the top's shadow but not a leg. Contact alone never counts.
    fn has_collision<R: Recorder>(&self, probe: &Probe<'_>, recorder: &mut R) -> bool {
        any_obstacle(&self.body_grid, probe.whole.bounds, recorder, |index| {
            let body = &self.bodies[index];
            let meets = body.owner != probe.agent && probe.meets(&body.solid, CONTACT_TOLERANCE);
            meets.then(|| body_of(body.owner))
        })
    }

    /// Whether what lies flat, which is in nobody's way and has no body, would lie on another of its class: mats in rows.
    fn lies_on_its_like<R: Recorder>(&self, probe: &Probe<'_>, recorder: &mut R) -> bool {
        if !probe.place.lies_flat(probe.size) {
            return false;
        }
        let others = self.resting[self.agents[probe.agent].piece.class].iter();
        let meets = |other: &AgentIndex| {
            let rest = self.agents[*other].rest().filter(|_| *other != probe.agent);
            rest.is_some_and(|rest| {
                box_solid(self.agents[*other].size, &rest.pose).overlaps(&probe.whole, CONTACT_TOLERANCE)
            })
        };
        let met = others.copied().find(meets);
        met.into_iter().for_each(|other| recorder.record(Obstacle::Body(other)));
        met.is_some()
    }
}

/// A body as an obstacle, by its owner.
pub(super) fn body_of(owner: AgentIndex) -> Obstacle {
    if owner == ROOM { Obstacle::Column } else { Obstacle::Body(owner) }
}
