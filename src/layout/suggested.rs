//! Agents for which somebody suggests a place.

use crate::catalog::{ParentName, Side};

use super::body::Pose;
use super::environment::Environment;
use super::place::{AgentIndex, ParentPart, Place};
use super::suggestion::Suggestion;

/// The suggestion for an agent, by index: for the first of its class to search.
pub(crate) fn suggestion(environment: &Environment<'_>, agent: AgentIndex) -> Option<usize> {
    let agent = &environment.agents[agent];
    // A suggestion holds one piece of a class. An agent that was sent away from it searches as others do.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Count, Untidiness};
    use crate::geometry::Point;
    use crate::layout::arrange::arrange;
    use crate::layout::brief::RoomBrief;
    use crate::layout::environment::Start;
    use crate::layout::movement::send_away;
    use crate::layout::tests::{WIDE, catalog, level};
    use crate::layout::{Alternative, FurnishOptions};

    #[test]
    fn an_agent_follows_its_suggestion_until_it_is_sent_away_wherever_it_stands_then() {
        const DESK: usize = 1;
        let (level, catalog) = (level(WIDE), catalog(&[(DESK, Count::Fixed(1))], Untidiness::default()));
        let size = catalog.classes[DESK].sizes[0];
        let position = Point::new(3.0, 2.0);
        let suggestion = Suggestion { class: DESK, size, position, angle: 0.0, wall: Some(2) };
        let alternative = Alternative { suggestions: vec![suggestion], ..Alternative::numbered(1) };
        let options = FurnishOptions::new(1, "test");
        let room = RoomBrief::new(level.room(0), &catalog, &options).expect("offices are furnished");
        let brief = room.alternative(&alternative);
        let start = Start { urgency: &[0], heeds_tags: false, turn: 0, is_traced: false };
        let mut environment = Environment::new(&brief, &start);
        arrange(&mut environment, brief.key);
        let place = environment.agents[0].rest().expect("the desk has a place").place();
        assert_eq!((place.pose.position, follows_suggestion(&environment, 0)), (position, true));
        send_away(&mut environment, 0);
        assert!(!follows_suggestion(&environment, 0));
        environment.settle(0, &place);
        assert!(!follows_suggestion(&environment, 0), "it came there by itself");
    }
}
