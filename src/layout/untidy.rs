//! Untidiness: random offsets of turn and distance from the parent (section 4.2).

use crate::catalog::{Side, Untidiness};
use crate::geometry::Point;

use super::agent::{Agent, Rest};
use super::body::{Pose, outward};
use super::environment::Environment;
use super::locked::is_locked;
use super::movement::move_agent;
use super::place::{AgentIndex, ParentPart};
use super::seed::{Purpose, RoomKey, Stream};
use super::suggested::follows_suggestion;

/// Moves every movable agent a little; where there is no room for that it stays. Returns whether any moved.
pub(crate) fn make_untidy(environment: &mut Environment<'_>, untidiness: &Untidiness, key: &RoomKey) -> bool {
    if *untidiness == Untidiness::default() {
        return false;
    }
    let mut has_moved = false;
    for agent in 0..environment.agents.len() {
        let class = environment.class(agent);
        let piece = environment.agents[agent].piece;
        // One stream for each piece: a piece more or less changes no draw of another.
        let mut stream = key.stream(Purpose::Untidiness, &class.id, piece.number);
        let is_fixed = environment.is_built_in(agent)
            || is_locked(environment, agent)
            || follows_suggestion(environment, agent);
        if let (false, Some(rest)) = (is_fixed, environment.agents[agent].rest().copied())
            && let Some(pose) = offset(environment, agent, &rest, untidiness, &mut stream)
        {
            has_moved |= move_agent(environment, agent, pose);
        }
    }
    has_moved
}

/// The pose after the offsets, or `None` for what hangs.
fn offset(
    environment: &Environment<'_>,
    agent: AgentIndex,
    rest: &Rest,
    untidiness: &Untidiness,
    stream: &mut Stream,
) -> Option<Pose> {
    let angle = rest.pose.angle + untidiness.turn * stream.signed();
    // Away from the parent only: nothing is pushed into its wall or table.
    let distance = untidiness.distance * stream.unit();
    let away = match rest.parent {
        ParentPart::Ceiling | ParentPart::Opening(_) => return None,
        // What hangs is fixed to the wall.
        ParentPart::Wall(_) if rest.pose.elevation > 0.0 => return None,
        ParentPart::Wall(wall) => environment.brief.surroundings.room.walls[wall].normal(),
        ParentPart::Floor | ParentPart::Column(_) => Point::ZERO,
        ParentPart::Agent(parent) => match rest.side {
            Side::Above | Side::Below => Point::ZERO,
            side => environment.agents[parent].rest()?.pose.turn(outward(side)),
        },
    };
    let turned = Pose::new(rest.pose.position, rest.pose.elevation, angle);
    // A turned box reaches further: it steps back by as much, so that the sides still touch at most.
    let size = environment.agents[agent].size;
    let reach = |pose: &Pose| Agent::half_extent(size, pose.right, away);
    let step = if away == Point::ZERO { 0.0 } else { reach(&turned) - reach(&rest.pose) + distance };
    Some(Pose { position: turned.position + away * step, ..turned })
}
