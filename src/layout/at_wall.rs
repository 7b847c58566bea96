//! Finds where a piece with its back to a wall stands or hangs.

use crate::catalog::{Side, Size};
use crate::layout::body::Pose;
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::layout::rules::angle_of_front;

/// Where the back of a piece is, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// Index of the wall.
    pub(crate) wall: usize,
    /// From the wall's start to the nearer side of the piece.
    pub(crate) from: f64,
    /// From the wall to the back: 0 but for what stands before an open side.
    pub(crate) before: f64,
    /// From the floor to the underside.
    pub(crate) elevation: f64,
}

impl Spot {
    /// On the floor, at a wall.
    pub(crate) fn standing(wall: usize, from: f64) -> Self {
        Self { wall, from, before: 0.0, elevation: 0.0 }
    }

    /// Whether it is before an open side, with no wall behind.
    pub(crate) fn is_before_opening(&self) -> bool {
        self.before > 0.0
    }

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
