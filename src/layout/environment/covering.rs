//! The floor that rugs may cover. They lie so flat that other pieces stand on them.

use crate::catalog::ClassIndex;
use crate::geometry::Solid;
use crate::layout::constants::{CONTACT_TOLERANCE, STORAGE_GROUP};
use crate::layout::place::{AgentIndex, ParentPart};

use super::{Environment, ROOM};

impl Environment<'_> {
    /// Whether the floor under a solid can be covered: inside the room, out of the way of doors, and with nobody on it
    /// who does not stand on rugs: columns, what is built in, storage, which stands on the floor itself, and those who have a rug of
    /// their own, because one of `theirs` is among them.
    pub(crate) fn can_be_covered(&self, solid: &Solid, theirs: &[ClassIndex]) -> bool {
        let is_in_a_door =
            |index: u32| self.kept_free[index as usize].solid.overlaps(solid, CONTACT_TOLERANCE);
        let is_in_the_way = |index: u32| {
            let body = &self.bodies[index as usize];
            body.solid.overlaps(solid, CONTACT_TOLERANCE)
                && (!self.stands_on_rugs(body.owner) || self.is_about(body.owner, theirs))
        };
        self.is_inside(solid)
            && !self.kept_free_grid.any(solid.bounds, is_in_a_door)
            && !self.body_grid.any(solid.bounds, is_in_the_way)
    }

    /// Whether an agent, what it stands at, or something that stands at it is of one of these classes.
    fn is_about(&self, agent: AgentIndex, classes: &[ClassIndex]) -> bool {
        let is_one = |agent: AgentIndex| classes.contains(&self.agents[agent].piece.class);
        let parent = self.agents[agent].rest().and_then(|rest| match rest.parent {
            ParentPart::Agent(parent) => Some(parent),
            _ => None,
        });
        is_one(agent) || parent.is_some_and(is_one) || self.agents[agent].children.iter().copied().any(is_one)
    }

    fn stands_on_rugs(&self, owner: AgentIndex) -> bool {
        owner != ROOM && !self.is_built_in(owner) && !self.is_in(owner, STORAGE_GROUP)
    }
}
