//! Makes the [`Furnished`] room of the agents that rest, with a reason for each piece that is missing.

use super::agent::{Agent, Rest, State};
use super::environment::Environment;
use super::furnished::{Furnished, Parent, Placement, Removal};
use super::place::{AgentIndex, ParentPart};
use super::wanted::is_missed;

/// The result of the agents.
pub(crate) fn furnished(environment: &Environment<'_>) -> Furnished {
    let (agents, brief) = (&environment.agents, environment.brief);
    let mut result = Furnished::empty(brief.at.index, brief.key.seed(), brief.style_ref);
    let mut indices = vec![None; agents.len()];
    for agent in 0..agents.len() {
        place(environment, agent, &mut indices, &mut result.placements);
    }
    let removal = |agent: AgentIndex| match &agents[agent] {
        Agent { piece, state: State::Removed(reason), .. } => {
            Some(Removal { class: piece.class, reason: *reason, is_required: piece.is_required })
        }
        _ => None,
    };
    let missed = (0..agents.len()).filter(|&agent| is_missed(environment, agent));
    result.removals = missed.filter_map(removal).collect();
    let count = result.placements.len() + result.removals.len();
    result.requested = u32::try_from(count).expect("a programme asks for fewer than 2^32 pieces");
    result
}

/// Appends an agent's placement after its parent's.
fn place(
    environment: &Environment<'_>,
    agent: AgentIndex,
    indices: &mut [Option<usize>],
    placements: &mut Vec<Placement>,
) {
    let Some(rest) = environment.agents[agent].rest() else { return };
    if indices[agent].is_some() {
        return;
    }
    if let ParentPart::Agent(parent) = rest.parent {
        place(environment, parent, indices, placements);
    }
    indices[agent] = Some(placements.len());
    placements.push(placement(environment, agent, rest, indices));
}

fn placement(
    environment: &Environment<'_>,
    agent: AgentIndex,
    rest: &Rest,
    indices: &[Option<usize>],
) -> Placement {
    let parent = match rest.parent {
        ParentPart::Floor => Parent::Floor,
        ParentPart::Ceiling => Parent::Ceiling,
        ParentPart::Wall(wall) => Parent::Wall(wall),
        ParentPart::Opening(side) => {
            Parent::Opening(environment.brief.surroundings.room.openings[side].opening)
        }
        ParentPart::Column(column) => Parent::Column(column),
        ParentPart::Agent(parent) => Parent::Object(indices[parent].expect("parents are placed first")),
    };
    let piece = &environment.agents[agent].piece;
    Placement {
        class: piece.class,
        number: piece.number,
        parent,
        side: rest.side,
        position: rest.pose.position,
        elevation: rest.pose.elevation,
        angle: rest.pose.angle,
        variant: piece.variant,
        size: environment.agents[agent].size,
    }
}
