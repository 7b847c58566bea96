//! Agents for which somebody suggests a place.

use crate::catalog::{ParentName, Side};

use super::body::Pose;
use super::environment::Environment;
use super::place::{AgentIndex, ParentPart, Place};
use super::suggestion::Suggestion;

/// The suggestion for an agent, by index: for the first of its class to search.
pub(crate) fn suggestion(environment: &Environment<'_>, agent: AgentIndex) -> Option<usize> {
    let agent = &environment.agents[agent];
    let is_first = agent.searches == 0 && environment.resting[agent.piece.class].is_empty();
    let mut suggestions = environment.brief.alternative.suggestions.iter();
    suggestions.position(|suggested| suggested.class == agent.piece.class).filter(|_| is_first)
}

/// Whether an agent rests where it was suggested: others can make way.
pub(crate) fn follows_suggestion(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let agent = &environment.agents[agent];
    agent.suggestion.is_some() && agent.rest().is_some()
}

/// The suggested place, if the agent may stand there.
pub(crate) fn place(
    environment: &Environment<'_>,
    agent: AgentIndex,
    suggestion: &Suggestion,
) -> Option<Place> {
    let pose = Pose::new(suggestion.position, 0.0, suggestion.angle);
    let at = |parent, side| Place { pose, parent, side };
    let places =
        environment.class(agent).parents.iter().filter_map(|rule| match (&rule.parent, suggestion.wall) {
            (ParentName::Wall, Some(wall)) => Some(at(ParentPart::Wall(wall), Side::Front)),
            (ParentName::Floor, _) => Some(at(ParentPart::Floor, Side::Above)),
            _ => None,
        });
    let mut places = places.filter(|place| environment.is_free(agent, place));
    places.find(|place| super::rules::meets_needs(environment, agent, place))
}
