//! What makes a place impossible, by name: the slow answer to the question that `obstruction` answers fast.

use std::collections::BTreeSet;

use crate::geometry::Solid;
use crate::layout::body::{box_solid, clearance_solid};
use crate::layout::constants::{CLEARANCE_TOLERANCE, CONTACT_TOLERANCE};
use crate::layout::furnished::RemovalReason;
use crate::layout::place::{AgentIndex, Place};
use crate::layout::rules::{Ground, weigh};
use crate::layout::surroundings::{Border, Cause};
use crate::layout::trace::Obstacle;

use super::{Body, Environment, Probe, ROOM};

impl Environment<'_> {
    /// What stands in the way of an agent at a place that was refused for a reason.
    pub(crate) fn obstacles(
        &self,
        agent: AgentIndex,
        place: &Place,
        reason: RemovalReason,
    ) -> BTreeSet<Obstacle> {
        let size = self.agents[agent].size;
        let probe = self.probe(agent, place, box_solid(size, &place.pose));
        match reason {
            RemovalReason::Outside => self.what_is_outside(&probe),
            RemovalReason::Collision => self.who_collides(&probe),
            RemovalReason::Comfort => self.what_is_uncomfortable(&probe),
            _ => {
                let taken = self.what_is_taken(&probe);
                if taken.is_empty() { self.who_takes_own(&probe) } else { taken }
            }
        }
    }

    fn what_is_outside(&self, probe: &Probe<'_>) -> BTreeSet<Obstacle> {
        let height = self.brief.surroundings.room.height;
        if probe.whole.low < -CONTACT_TOLERANCE || probe.whole.high > height + CONTACT_TOLERANCE {
            return [Obstacle::Height].into();
        }
        if self.hangs_in_the_air(probe.agent, probe.place) {
            return [Obstacle::NoWall].into();
        }
        let borders = self.borders_through(&probe.whole, CONTACT_TOLERANCE);
        let walls: BTreeSet<Obstacle> = borders.map(|border| Obstacle::Wall(border.wall)).collect();
        if walls.is_empty() { [Obstacle::BeyondWalls].into() } else { walls }
    }

    fn borders_through(&self, solid: &Solid, tolerance: f64) -> impl Iterator<Item = &Border> {
        self.borders
            .iter()
            .filter(move |border| solid.base.is_entered_by(border.start, border.end, tolerance))
    }

    fn who_collides(&self, probe: &Probe<'_>) -> BTreeSet<Obstacle> {
        let others = || self.others_at(&probe.whole, probe.agent, CONTACT_TOLERANCE);
        let name = |owner: AgentIndex| if owner == ROOM { Obstacle::Column } else { Obstacle::Body(owner) };
        let touched = others().filter(|body| probe.meets(&body.solid, CONTACT_TOLERANCE));
        let mut found: BTreeSet<Obstacle> = touched.map(|body| name(body.owner)).collect();
        if found.is_empty() {
            // Nothing touches: it would slide under a table that it does not belong to, or be slid over.
            let roofs = self.roofs.iter().filter(|(roof, _)| probe.meets(roof, CONTACT_TOLERANCE));
            let rests = |owner: AgentIndex| self.agents[owner].rest().is_some();
            found.extend(roofs.filter(|roof| rests(roof.1)).map(|&(_, owner)| name(owner)));
            found.extend(others().map(|body| name(body.owner)));
        }
        found
    }

    /// Solid parts of resting agents and columns that meet a region.
    fn others_at(&self, region: &Solid, agent: AgentIndex, tolerance: f64) -> impl Iterator<Item = &Body> {
        let is_there = |owner: AgentIndex| owner == ROOM || self.agents[owner].rest().is_some();
        self.bodies.iter().filter(move |body| {
            body.owner != agent && is_there(body.owner) && body.solid.overlaps(region, tolerance)
        })
    }

    fn what_is_taken(&self, probe: &Probe<'_>) -> BTreeSet<Obstacle> {
        let taken = self.kept_free.iter().filter(|region| probe.meets(&region.solid, CONTACT_TOLERANCE));
        let mut found: BTreeSet<Obstacle> = taken
            .map(|region| match region.cause {
                Cause::Opening(opening) => Obstacle::Opening(opening),
                Cause::Way => Obstacle::Way,
            })
            .collect();
        let is_flat = self.is_flat(self.agents[probe.agent].size, probe.place);
        let resting = (0..self.agents.len()).filter(|&owner| self.agents[owner].rest().is_some());
        for owner in resting.filter(|&owner| owner != probe.agent && !is_flat) {
            let regions = &self.clearances[self.agents[owner].clearances.clone()];
            let is_taken = regions.iter().any(|region| {
                probe.meets(&region.solid, CLEARANCE_TOLERANCE)
                    && !(region.allows_children && self.descends(probe.place.parent, owner))
            });
            if is_taken {
                found.insert(Obstacle::ClearanceOf(owner));
            }
        }
        found
    }

    fn what_is_uncomfortable(&self, probe: &Probe<'_>) -> BTreeSet<Obstacle> {
        let mut found = BTreeSet::new();
        weigh(self, probe.agent, probe.place, |ground, _| match ground {
            Ground::Wish(_) | Ground::SuitsWall => {}
            Ground::BeforeWindow => drop(found.insert(Obstacle::WindowBehind)),
            Ground::TakesSeat => drop(found.insert(Obstacle::Seat)),
            Ground::Tight { takes, lacks } => {
                if lacks {
                    found.insert(Obstacle::OwnComfort);
                }
                if takes {
                    found.extend(self.whose_comfort(probe).map(Obstacle::ClearanceOf));
                }
            }
        });
        found
    }

    /// The agents of whose comfort a body takes.
    fn whose_comfort(&self, probe: &Probe<'_>) -> impl Iterator<Item = AgentIndex> {
        let resting = (0..self.agents.len()).filter(|&owner| self.agents[owner].rest().is_some());
        resting.filter(move |&owner| {
            let mut regions = self.clearances[self.agents[owner].clearances.clone()].iter();
            owner != probe.agent
                && !self.is_relative(probe.agent, probe.place.parent, owner)
                && regions.any(|region| region.comfort.overlaps(&probe.whole, CLEARANCE_TOLERANCE))
        })
    }

    fn who_takes_own(&self, probe: &Probe<'_>) -> BTreeSet<Obstacle> {
        let size = self.agents[probe.agent].size;
        let mut found = BTreeSet::new();
        for clearance in &self.class(probe.agent).clearances {
            let solid = clearance_solid(clearance, size, &probe.place.pose, clearance.minimum);
            let walls = self.borders_through(&solid, CLEARANCE_TOLERANCE).filter(|border| !border.is_open);
            found.extend(walls.map(|border| Obstacle::WallInOwnClearance(border.wall)));
            let others = self.others_at(&solid, probe.agent, CLEARANCE_TOLERANCE);
            found.extend(others.filter(|body| !body.is_flat).filter_map(|body| match body.owner {
                ROOM => Some(Obstacle::ColumnInOwnClearance),
                owner if self.is_relative(probe.agent, probe.place.parent, owner) => None,
                owner => Some(Obstacle::InOwnClearance(owner)),
            }));
        }
        found
    }
}
