//! The environment of the agents: who rests where, and whether a place is free.

use core::ops::Range;
use std::cell::{Cell, RefCell};

use crate::catalog::{Class, ClassIndex, Side, Size};
use crate::geometry::{Grid, Solid};

mod clearances;
mod covering;
mod hanging;
mod near;
mod notes;
mod obstruction;
mod slots;

use super::agent::{Agent, Rest, State};
use super::body::{append_solids, clearance_solid, seat};
use super::brief::Brief;
use super::lattice::KnownBlock;
use super::place::{AgentIndex, ParentPart, Place};
use super::refused_slots::RefusedSlots;
use super::surroundings::KeptFree;
use super::trace::Trace;

/// Owner of what belongs to the room and not to an agent.
const ROOM: AgentIndex = AgentIndex::MAX;

/// Classes of this group are built in and never off their place.
const FIXED_GROUP: &str = "fixed";

/// The room with its agents.
pub(crate) struct Environment<'a> {
    /// The data that is fixed for the room.
    pub(crate) brief: &'a Brief<'a>,
    /// All agents, in the order of the programme.
    pub(crate) agents: Vec<Agent>,
    /// Resting agents by class (section 4: "lists according to their type").
    pub(crate) resting: Vec<Vec<AgentIndex>>,
    /// The record of the search, for explanations.
    pub(crate) trace: Option<RefCell<Trace>>,
    /// Classes of which an agent found no place: the room only gets fuller, so the next need not scan it again.
    pub(crate) is_exhausted: Vec<bool>,
    /// Whether walls that carry the right tag come first.
    pub(crate) heeds_tags: bool,
    /// How many times the room was furnished before, in other attempts and alternatives.
    pub(crate) turn: usize,
    /// Pieces that have found no place so far, and steps down for those that others stand in for; zero where nobody asks.
    pub(crate) lacking: u32,
    bodies: Vec<OwnedSolid>,
    body_grid: Grid,
    clearances: Vec<Region>,
    clearance_grid: Grid,
    /// Boxes of agents that leave room under or beside their solid parts, a table's.
    roofs: Vec<(Solid, AgentIndex)>,
    roof_grid: Grid,
    /// Those of the openings, and the ways that were found closed.
    kept_free: Vec<KeptFree>,
    kept_free_grid: Grid,
    /// The lattice of lamps that was worked out last.
    pub(crate) known_block: KnownBlock,
    refused_slots: RefCell<RefusedSlots>,
    /// Memory for the parts of the shape under test: thousands of tests a room share one allocation.
    scratch: Cell<Vec<Solid>>,
    /// The steps so far.
    steps: Cell<u64>,
}

/// A solid part of an agent or column.
#[derive(Clone, Copy, Debug)]
struct OwnedSolid {
    solid: Solid,
    owner: AgentIndex,
    /// Hangs flat on a wall, where it is in nobody's way.
    is_flat: bool,
}

/// A clearance of a resting agent.
#[derive(Clone, Copy, Debug)]
struct Region {
    solid: Solid,
    /// As deep as is good; the solid is as deep as is needed.
    comfort: Solid,
    owner: AgentIndex,
    allows_children: bool,
    /// The part of it where a child's seat stands, if it allows any.
    seat: Option<Solid>,
}

/// The data in which the attempts at a room differ.
pub(crate) struct Start<'u> {
    /// By agent, in how many earlier attempts the room missed it.
    pub(crate) urgency: &'u [u32],
    /// Whether walls that carry the right tag come first.
    pub(crate) heeds_tags: bool,
    /// How many times the room was furnished before, in other attempts and alternatives.
    pub(crate) turn: usize,
    /// Whether it is noted what agents meet on their search.
    pub(crate) is_traced: bool,
}

impl<'a> Environment<'a> {
    /// An environment without resting agents.
    pub(crate) fn new(brief: &'a Brief<'a>, start: &Start<'_>) -> Self {
        let Brief { catalog, surroundings, pieces, .. } = brief;
        let bounds = surroundings.room.region.outline.bounds();
        let agents = pieces.iter().zip(start.urgency).map(|(piece, &urgency)| {
            let size = catalog.classes[piece.class].size(piece.variant);
            Agent { urgency, ..Agent::new(*piece, size) }
        });
        let mut environment = Self {
            brief,
            agents: agents.collect(),
            resting: vec![Vec::new(); catalog.classes.len()],
            trace: start.is_traced.then(|| RefCell::new(Trace::new(pieces.len()))),
            is_exhausted: vec![false; catalog.classes.len()],
            heeds_tags: start.heeds_tags,
            turn: start.turn,
            lacking: 0,
            // Most pieces are a box or a top with a leg or two.
            bodies: Vec::with_capacity(pieces.len() * 2),
            body_grid: Grid::new(bounds),
            clearances: Vec::new(),
            clearance_grid: Grid::new(bounds),
            roofs: Vec::new(),
            roof_grid: Grid::new(bounds),
            kept_free: surroundings.kept_free.clone(),
            kept_free_grid: surroundings.kept_free_grid.clone(),
            known_block: KnownBlock::default(),
            refused_slots: RefCell::default(),
            scratch: Cell::default(),
            steps: Cell::default(),
        };
        for &solid in &surroundings.columns {
            environment.push_body(OwnedSolid { solid, owner: ROOM, is_flat: false });
        }
        environment
    }

    /// The class of an agent.
    pub(crate) fn class(&self, agent: AgentIndex) -> &'a Class {
        &self.brief.catalog.classes[self.agents[agent].piece.class]
    }

    /// Whether an agent's class is in a group.
    pub(crate) fn is_in(&self, agent: AgentIndex, group: &str) -> bool {
        self.class(agent).groups.iter().any(|other| other == group)
    }

    /// Whether an agent's class is built in.
    pub(crate) fn is_built_in(&self, agent: AgentIndex) -> bool {
        self.is_in(agent, FIXED_GROUP)
    }

    /// Whether an agent, or one that stands on it or belongs to it, is required.
    pub(crate) fn has_required(&self, agent: AgentIndex) -> bool {
        let agent = &self.agents[agent];
        agent.piece.is_required || agent.children.iter().any(|&child| self.has_required(child))
    }

    /// Resting agents of some classes, in the order of those classes, then of coming to rest.
    pub(crate) fn resting_of<'b>(
        &'b self,
        classes: &'b [ClassIndex],
    ) -> impl Iterator<Item = AgentIndex> + 'b {
        classes.iter().flat_map(|&class| self.resting[class].iter().copied())
    }

    /// Whether so much is lacking that the arrangement is not worth finishing.
    pub(crate) fn is_given_up(&self) -> bool {
        self.brief.alternative.gives_up_at.is_some_and(|most| self.lacking >= most)
    }

    /// Counts work, in steps of about a tenth of a microsecond.
    pub(crate) fn count_steps(&self, steps: u64) {
        self.steps.set(self.steps.get() + steps);
    }

    /// The work so far, in the same steps.
    pub(crate) fn steps(&self) -> u64 {
        self.steps.get()
    }

    /// The solid parts of all resting agents.
    pub(crate) fn solids(&self) -> impl Iterator<Item = &Solid> {
        let resting = self.agents.iter().filter(|agent| agent.rest().is_some());
        resting.flat_map(|agent| &self.bodies[agent.bodies.clone()]).map(|body| &body.solid)
    }

    /// Lets an agent rest at a place.
    pub(crate) fn settle(&mut self, agent: AgentIndex, place: &Place) {
        // Kept with the rest: the side gets back the same number when the agent leaves.
        let extent = self.extent_along(agent, place);
        self.agents[agent].state =
            State::Rest(Rest { pose: place.pose, parent: place.parent, side: place.side, extent });
        // The parent counts places and metres, so that a full side is known without looking at the children.
        if let ParentPart::Agent(parent) = place.parent {
            let parent = &mut self.agents[parent];
            parent.taken[place.side.index()] += 1;
            parent.occupied[place.side.index()] += extent;
            parent.children.push(agent);
        }
        self.resting[self.agents[agent].piece.class].push(agent);
        self.add_shapes(agent, place);
    }

    /// Takes a resting agent out of the room; its children keep their state and must be seen to by the caller.
    pub(crate) fn unsettle(&mut self, agent: AgentIndex) {
        let Some(rest) = self.agents[agent].rest().copied() else { return };
        self.refused_slots.get_mut().forget();
        if let ParentPart::Agent(parent) = rest.parent {
            let parent = &mut self.agents[parent];
            parent.taken[rest.side.index()] -= 1;
            parent.occupied[rest.side.index()] -= rest.extent;
            parent.children.retain(|&child| child != agent);
        }
        // Keeps the order: rules that name a class ask those first that came to rest first.
        self.resting[self.agents[agent].piece.class].retain(|&other| other != agent);
        let bodies = self.agents[agent].bodies.clone();
        for index in bodies.clone().rev() {
            self.body_grid.remove(item(index), self.bodies[index].solid.bounds);
        }
        give_back(&mut self.bodies, bodies);
        self.remove_roof(agent);
        let clearances = self.agents[agent].clearances.clone();
        for index in clearances.clone().rev() {
            self.clearance_grid.remove(item(index), self.clearances[index].comfort.bounds);
        }
        give_back(&mut self.clearances, clearances);
        self.agents[agent].state = State::Search;
    }

    fn add_shapes(&mut self, agent: AgentIndex, place: &Place) {
        let (class, size) = (self.class(agent), self.agents[agent].size);
        let mut parts = Vec::new();
        append_solids(&mut parts, &class.shape, size, &place.pose);
        let is_flat = self.is_flat(size, place);
        let first = self.bodies.len();
        // What lies flat on the floor is in nobody's way.
        for solid in parts.into_iter().filter(|_| !place.lies_flat(size)) {
            self.push_body(OwnedSolid { solid, owner: agent, is_flat });
        }
        let first_clearance = self.clearances.len();
        for clearance in class.clearances.iter().chain(self.chosen_clearance(agent, place)) {
            // Two depths (metres): where another may not stand, and where it had better not (`TIGHT_PENALTY`).
            let solid = clearance_solid(clearance, size, &place.pose, clearance.minimum);
            let comfort =
                clearance_solid(clearance, size, &place.pose, clearance.good.max(clearance.minimum));
            let seat = seat(clearance, size, &place.pose);
            // By the larger of the two regions: whoever asks for the smaller one finds it there too.
            self.clearance_grid.insert(item(self.clearances.len()), comfort.bounds);
            let allows_children = clearance.allows_children;
            self.clearances.push(Region { solid, comfort, owner: agent, allows_children, seat });
        }
        self.add_roof(agent, place);
        self.agents[agent].bodies = added(first, &self.bodies);
        self.agents[agent].clearances = added(first_clearance, &self.clearances);
    }

    fn push_body(&mut self, body: OwnedSolid) {
        self.body_grid.insert(item(self.bodies.len()), body.solid.bounds);
        self.bodies.push(body);
    }

    /// Metres that an agent takes along the side of its parent.
    pub(crate) fn extent_along(&self, agent: AgentIndex, place: &Place) -> f64 {
        let ParentPart::Agent(parent) = place.parent else { return 0.0 };
        let Some(rest) = self.agents[parent].rest() else { return 0.0 };
        let along = match place.side {
            Side::Left | Side::Right => rest.pose.right.perp(),
            Side::Front | Side::Back | Side::Above | Side::Below => rest.pose.right,
        };
        2.0 * Agent::half_extent(self.agents[agent].size, place.pose.right, along)
    }

    /// Whether something hangs flat on a wall or opening, where nobody walks into it, or lies flat on the floor.
    fn is_flat(&self, size: Size, place: &Place) -> bool {
        let rules = &self.brief.catalog.audit.clearances;
        let hangs_flat = matches!(place.parent, ParentPart::Wall(_) | ParentPart::Opening(_))
            && size.depth <= rules.flat_depth
            && place.pose.elevation >= rules.flat_elevation;
        hangs_flat || place.lies_flat(size)
    }
}

/// The shapes that were added from the first one on. None are 0..0: others that were there before may be given back.
fn added<T>(first: usize, shapes: &[T]) -> Range<usize> {
    if first == shapes.len() { 0..0 } else { first..shapes.len() }
}

/// Takes shapes out again if they are the last ones. Whole arrangements come and go where pieces look for their places together:
/// their shapes would pile up, and those of thousands take longer to keep than to make.
fn give_back<T>(shapes: &mut Vec<T>, leaving: Range<usize>) {
    if leaving.end == shapes.len() {
        shapes.truncate(leaving.start);
    }
}

fn item(index: usize) -> u32 {
    u32::try_from(index).expect("a room holds fewer than 2^32 shapes")
}
