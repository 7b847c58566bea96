//! Regions that people need: before doors, before the sides of objects, and under tables.

use crate::catalog::{Clearance, Shape};
use crate::geometry::Solid;
use crate::layout::body::{box_solid, clearance_between, clearance_solid, seat};
use crate::layout::constants::{CLEARANCE_TOLERANCE, CONTACT_TOLERANCE, RUG_HEIGHT};
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::layout::surroundings::{Border, Cause, KeptFree};
use crate::layout::trace::Obstacle;

use super::obstruction::{Probe, Recorder, any_obstacle, body_of};
use super::{Environment, ROOM, added, give_back, item};

/// A clearance of an agent that would stand at a place.
struct OwnClearance<'a> {
    agent: AgentIndex,
    place: &'a Place,
    clearance: &'a Clearance,
    /// Metres of it that are asked for.
    depth: f64,
}

impl<'a> Environment<'a> {
    /// Whether a body would stand in a door's way or in another object's clearance.
    pub(super) fn blocks_a_way<R: Recorder>(&self, probe: &Probe<'_>, recorder: &mut R) -> bool {
        let bounds = probe.whole.bounds;
        let is_kept_free = any_obstacle(&self.kept_free_grid, bounds, recorder, |index| {
            let region = &self.kept_free[index];
            probe.meets(&region.solid, CONTACT_TOLERANCE).then_some(match region.cause {
                Cause::Opening(opening) => Obstacle::Opening(opening),
                Cause::Way => Obstacle::Way,
            })
        });
        let is_decided = is_kept_free && R::FIRST_IS_ENOUGH;
        if is_decided || self.is_flat(self.agents[probe.agent].size, probe.place) {
            return is_kept_free;
        }
        let is_in_a_clearance = any_obstacle(&self.clearance_grid, bounds, recorder, |index| {
            let region = &self.clearances[index];
            let is_taken = region.owner != probe.agent
                && probe.meets(&region.solid, CLEARANCE_TOLERANCE)
                && !(region.allows_children && self.descends(probe.place.parent, region.owner));
            is_taken.then_some(Obstacle::ClearanceOf(region.owner))
        });
        is_kept_free || is_in_a_clearance
    }

    /// Keeps a way free of all bodies from now on.
    pub(crate) fn keep_way(&mut self, solid: Solid) {
        self.kept_free_grid.insert(item(self.kept_free.len()), solid.bounds);
        self.kept_free.push(KeptFree { solid, cause: Cause::Way });
    }

    /// Clearances of resting agents at least so deep, so low that people stand in them, each with its agent.
    pub(crate) fn used_areas(&self, depth: f64, most: f64) -> impl Iterator<Item = (AgentIndex, &Solid)> {
        let resting = (0..self.agents.len()).filter(|&agent| self.agents[agent].rest().is_some());
        resting.flat_map(move |agent| {
            let clearances = self.class(agent).clearances.iter();
            let regions = &self.clearances[self.agents[agent].clearances.clone()];
            // Both figures are those of the audit: what it wants to be reached is what ways are kept open to.
            let is_used =
                move |clearance: &Clearance, region: &Solid| clearance.minimum >= depth && region.low < most;
            let pairs = clearances.zip(regions).map(|(clearance, region)| (clearance, &region.solid));
            pairs
                .filter(move |(clearance, solid)| is_used(clearance, solid))
                .map(move |(_, solid)| (agent, solid))
        })
    }

    /// Whether a parent is an agent or one of its descendants.
    pub(super) fn descends(&self, parent: ParentPart, ancestor: AgentIndex) -> bool {
        let mut parent = parent;
        while let ParentPart::Agent(index) = parent {
            if index == ancestor {
                return true;
            }
            match self.agents[index].rest() {
                Some(rest) => parent = rest.parent,
                None => return false,
            }
        }
        false
    }

    /// Whether all clearances of an agent are free at a place: free of walls, and of bodies other than its
    /// relatives and what hangs flat on a wall.
    pub(crate) fn has_clearances<R: Recorder>(
        &self,
        agent: AgentIndex,
        place: &Place,
        is_good: bool,
        recorder: &mut R,
    ) -> bool {
        let own = |clearance: &'a Clearance| OwnClearance {
            agent,
            place,
            clearance,
            depth: if is_good { clearance.good } else { clearance.minimum },
        };
        let class = self.class(agent);
        let mut is_free = true;
        for clearance in &class.clearances {
            is_free &= self.is_clearance_free(&own(clearance), recorder);
            if !is_free && R::FIRST_IS_ENOUGH {
                return false;
            }
        }
        // Of those of which one is enough, the first stands for all that are taken.
        let mut either = class.either.iter();
        let is_taken = |first: &'a Clearance| {
            !either.any(|other| self.is_clearance_free(&own(other), &mut ()))
                && !self.is_clearance_free(&own(first), recorder)
        };
        is_free && !class.either.first().is_some_and(is_taken)
    }

    /// Of the clearances of which one is enough, the one that an agent keeps free at a place: the first that is as deep as is
    /// good, else as is needed.
    pub(super) fn chosen_clearance(&self, agent: AgentIndex, place: &Place) -> Option<&'a Clearance> {
        let either = &self.class(agent).either;
        let is_free = |clearance: &Clearance, depth: f64| {
            self.is_clearance_free(&OwnClearance { agent, place, clearance, depth }, &mut ())
        };
        let good = either.iter().find(|clearance| is_free(clearance, clearance.good));
        good.or_else(|| either.iter().find(|clearance| is_free(clearance, clearance.minimum)))
            .or(either.first())
    }

    /// Whether a clearance is free of walls and bodies, as deep as some metres.
    fn is_clearance_free<R: Recorder>(&self, own: &OwnClearance<'_>, recorder: &mut R) -> bool {
        let &OwnClearance { agent, place, clearance, depth } = own;
        let solid = clearance_solid(clearance, self.agents[agent].size, &place.pose, depth);
        let is_walled = self.is_walled(own, &solid, recorder);
        if is_walled && R::FIRST_IS_ENOUGH {
            return false;
        }
        let is_taken = any_obstacle(&self.body_grid, solid.bounds, recorder, |index| {
            let body = &self.bodies[index];
            let is_in_it = !body.is_flat
                && body.owner != agent
                && body.solid.overlaps(&solid, CLEARANCE_TOLERANCE)
                && !self.is_relative(agent, place.parent, body.owner);
            is_in_it.then_some(match body.owner {
                ROOM => Obstacle::ColumnInOwnClearance,
                owner => Obstacle::InOwnClearance(owner),
            })
        });
        !is_walled && !is_taken
    }

    /// Whether the walls leave a clearance too little room. Where the wall is open it may reach across the strip that the
    /// next room keeps free, but not onto stairs: who comes from there would have no more than what is left of the floor.
    fn is_walled<R: Recorder>(&self, own: &OwnClearance<'_>, solid: &Solid, recorder: &mut R) -> bool {
        if self.lies_inside(solid, CLEARANCE_TOLERANCE) {
            return false;
        }
        let is_wall = |border: &Border| !border.is_open || border.is_at_stairs;
        let wall = |border: &Border| is_wall(border).then_some(Obstacle::WallInOwnClearance(border.wall));
        // From inside the object, for a wall that it touches is at the very edge of its clearance.
        let reach = (-2.0 * CLEARANCE_TOLERANCE, own.depth);
        let (size, pose) = (self.agents[own.agent].size, &own.place.pose);
        let from_inside = clearance_between(own.clearance, size, pose, reach);
        if self.is_entered(&from_inside, CLEARANCE_TOLERANCE, recorder, wall) {
            return true;
        }
        let kept_by_next_room = self.brief.catalog.audit.doors.open_boundary_depth;
        // At least as deep as the tolerance: a clearance without depth is no region.
        let depth = (own.depth - kept_by_next_room).max(CLEARANCE_TOLERANCE);
        let inner = clearance_solid(own.clearance, size, pose, depth);
        let is_outside = !self.lies_inside(&inner, CLEARANCE_TOLERANCE);
        if is_outside {
            recorder.record(Obstacle::OwnClearanceOutside);
        }
        is_outside
    }

    /// Whether an owner is an ancestor or a descendant of an agent that would have this parent.
    pub(super) fn is_relative(&self, agent: AgentIndex, parent: ParentPart, owner: AgentIndex) -> bool {
        owner != ROOM
            && (self.descends(parent, owner)
                || self.agents[owner].rest().is_some_and(|rest| self.descends(rest.parent, agent)))
    }

    /// Whether a place uses the floor where another object's seat will stand, or has its own seats where others
    /// need the floor. Two clearances may share space; a clearance and somebody who sits there may not.
    pub(crate) fn takes_a_seat(&self, agent: AgentIndex, place: &Place) -> bool {
        let (class, size) = (self.class(agent), self.agents[agent].size);
        class.clearances.iter().any(|clearance| {
            let own_seat = seat(clearance, size, &place.pose);
            let own =
                own_seat.unwrap_or_else(|| clearance_solid(clearance, size, &place.pose, clearance.minimum));
            self.clearance_grid.any(own.bounds, |index| {
                let other = &self.clearances[index as usize];
                let needed = match (own_seat, other.seat) {
                    (None, None) => return false,
                    // Somebody who sits here takes of the space that others need to pass.
                    (Some(_), None) => &other.solid,
                    // The other's seat may meet neither the own seat nor, without one, the own clearance.
                    (_, Some(_)) => other.seat.as_ref().expect("just matched"),
                };
                other.owner != agent
                    && own.overlaps(needed, CLEARANCE_TOLERANCE)
                    && !self.is_relative(agent, place.parent, other.owner)
            })
        })
    }

    /// Whether one of those who would sit at an agent has no place for the seat: a door swings over it, or people walk there.
    pub(crate) fn has_seats_in_ways(&self, agent: AgentIndex, place: &Place) -> bool {
        let size = self.agents[agent].size;
        let mut seats =
            self.class(agent).clearances.iter().filter_map(|clearance| seat(clearance, size, &place.pose));
        seats.any(|seat| {
            self.kept_free_grid.any(seat.bounds, |index| {
                seat.overlaps(&self.kept_free[index as usize].solid, CLEARANCE_TOLERANCE)
            })
        })
    }

    /// Whether a place takes of the space that others have plenty of beyond what they need, with the piece itself or
    /// with those who will sit at it.
    pub(crate) fn takes_comfort<R: Recorder>(
        &self,
        agent: AgentIndex,
        place: &Place,
        recorder: &mut R,
    ) -> bool {
        let (class, size) = (self.class(agent), self.agents[agent].size);
        if self.is_flat(size, place) {
            return false;
        }
        let whole = box_solid(size, &place.pose);
        let seats = class.clearances.iter().filter_map(|clearance| seat(clearance, size, &place.pose));
        let mut is_taken = false;
        for solid in core::iter::once(whole).chain(seats) {
            is_taken |= any_obstacle(&self.clearance_grid, solid.bounds, recorder, |index| {
                let region = &self.clearances[index];
                let is_in_it = region.owner != agent
                    && region.comfort.overlaps(&solid, CLEARANCE_TOLERANCE)
                    && !self.is_relative(agent, place.parent, region.owner);
                is_in_it.then_some(Obstacle::ClearanceOf(region.owner))
            });
            if is_taken && R::FIRST_IS_ENOUGH {
                break;
            }
        }
        is_taken
    }

    /// Whether an agent would have less room at a place than is good.
    pub(crate) fn lacks_comfort(&self, agent: AgentIndex, place: &Place) -> bool {
        let mut clearances = self.class(agent).all_clearances();
        // Cheap, and enough for most classes: their good depth is the minimum, which was tested already.
        clearances.any(|clearance| clearance.good > clearance.minimum)
            && !self.has_clearances(agent, place, true, &mut ())
    }

    /// Calls `visit` with every region that is good to have free and meets another.
    pub(crate) fn each_comfort(&self, region: &Solid, mut visit: impl FnMut(&Solid)) {
        self.clearance_grid.each_under(&region.base, |index| {
            let comfort = &self.clearances[index as usize].comfort;
            if region.overlaps(comfort, CLEARANCE_TOLERANCE) {
                visit(comfort);
            }
        });
    }

    /// Calls `visit` with every place of a seat in a region, and, for a region where a seat will stand, with every
    /// other clearance too.
    pub(crate) fn each_claim(&self, region: &Solid, is_seat: bool, mut visit: impl FnMut(&Solid)) {
        self.clearance_grid.each_under(&region.base, |index| {
            let other = &self.clearances[index as usize];
            let claimed = other.seat.as_ref().or(is_seat.then_some(&other.solid));
            if let Some(claimed) = claimed.filter(|solid| region.overlaps(solid, CLEARANCE_TOLERANCE)) {
                visit(claimed);
            }
        });
    }

    /// Whether something would stand under a table that it does not belong to, or a table over it.
    pub(super) fn slides_under_a_stranger<R: Recorder>(&self, probe: &Probe<'_>, recorder: &mut R) -> bool {
        // A rug neither stands under a table nor fills the space there.
        let stands = |solid: &Solid| solid.low < RUG_HEIGHT && solid.high > RUG_HEIGHT;
        if !stands(&probe.whole) {
            return false;
        }
        let is_stranger = |owner: AgentIndex| !self.is_relative(probe.agent, probe.place.parent, owner);
        let is_under = any_obstacle(&self.roof_grid, probe.whole.bounds, recorder, |index| {
            let (roof, owner) = &self.roofs[index];
            let is_under =
                *owner != probe.agent && probe.meets(roof, CONTACT_TOLERANCE) && is_stranger(*owner);
            is_under.then_some(Obstacle::Body(*owner))
        });
        if (is_under && R::FIRST_IS_ENOUGH) || !has_roof(&self.class(probe.agent).shape) {
            return is_under;
        }
        let is_over = any_obstacle(&self.body_grid, probe.whole.bounds, recorder, |index| {
            let body = &self.bodies[index];
            let is_over = stands(&body.solid)
                && body.owner != probe.agent
                && body.solid.overlaps(&probe.whole, CONTACT_TOLERANCE)
                && is_stranger(body.owner);
            is_over.then(|| body_of(body.owner))
        });
        is_under || is_over
    }

    /// Notes the box of an agent that others could slide under.
    pub(super) fn add_roof(&mut self, agent: AgentIndex, place: &Place) {
        let first = self.roofs.len();
        if has_roof(&self.class(agent).shape) && place.pose.elevation < RUG_HEIGHT {
            let solid = box_solid(self.agents[agent].size, &place.pose);
            self.roof_grid.insert(item(first), solid.bounds);
            self.roofs.push((solid, agent));
        }
        self.agents[agent].roofs = added(first, &self.roofs);
    }

    /// Forgets it again.
    pub(super) fn remove_roof(&mut self, agent: AgentIndex) {
        let roofs = self.agents[agent].roofs.clone();
        for index in roofs.clone() {
            self.roof_grid.remove(item(index), self.roofs[index].0.bounds);
        }
        give_back(&mut self.roofs, roofs);
    }
}

/// Whether a shape leaves parts of its box empty, where low things could stand.
fn has_roof(shape: &Shape) -> bool {
    matches!(shape, Shape::Prisms(_))
}
