//! Finds where a piece with its back to a wall stands or hangs.

use crate::catalog::{Side, Size};
use crate::layout::body::Pose;
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::layout::rules::angle_of_front;

/// The place of an agent with its back to a wall, so many metres from the wall's start and above the floor.
pub(crate) fn place_at(
    environment: &Environment<'_>,
    agent: AgentIndex,
    wall: usize,
    from: f64,
    elevation: f64,
) -> Place {
    let pose = pose_at(environment, environment.agents[agent].size, wall, from, elevation);
    Place { pose, parent: ParentPart::Wall(wall), side: Side::Front }
}

/// The pose of what has a size, with its back to a wall.
pub(crate) fn pose_at(
    environment: &Environment<'_>,
    size: Size,
    wall: usize,
    from: f64,
    elevation: f64,
) -> Pose {
    let part = &environment.brief.surroundings.room.walls[wall];
    let (along, normal) = (part.direction(), part.normal());
    let position = part.start + along * (from + size.width / 2.0) + normal * (size.depth / 2.0);
    Pose::new(position, elevation, angle_of_front(normal))
}
