//! Finds where a piece with its back to a wall stands or hangs.

use crate::catalog::{Side, Size};
use crate::layout::body::Pose;
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::layout::rules::angle_of_front;
use crate::layout::spot::Spot;

impl Spot {
    /// The pose of what has a size there.
    pub(crate) fn pose(&self, environment: &Environment<'_>, size: Size) -> Pose {
        let part = &environment.brief.surroundings.room.walls[self.wall];
        let (along, normal) = (part.direction(), part.normal());
        let off = self.before + size.depth / 2.0;
        let position = part.start + along * (self.from + size.width / 2.0) + normal * off;
        Pose::new(position, self.elevation, angle_of_front(normal))
    }

    /// The place of an agent there; what stands before an open side stands on the floor.
    pub(crate) fn place(&self, environment: &Environment<'_>, agent: AgentIndex) -> Place {
        let pose = self.pose(environment, environment.agents[agent].size);
        let (parent, side) = if self.is_before_opening() {
            (ParentPart::Floor, Side::Above)
        } else {
            (ParentPart::Wall(self.wall), Side::Front)
        };
        Place { pose, parent, side }
    }
}
