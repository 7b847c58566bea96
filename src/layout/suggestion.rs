//! Places that somebody suggests: where an agent is sure to fit if nobody else came first.

use crate::catalog::{ClassIndex, ParentName, Side, Size};
use crate::geometry::Point;

use super::agent::{AgentIndex, ParentPart};
use super::body::Pose;
use super::environment::{Environment, Place};

/// One of the arrangements of a room.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Alternative {
    /// Counts the arrangements of a room from 0.
    pub number: u32,
    /// Where some pieces should try to stand first.
    pub suggestions: Vec<Suggestion>,
}

impl Alternative {
    /// An arrangement without suggestions.
    #[must_use]
    pub fn numbered(number: u32) -> Self {
        Self { number, suggestions: Vec::new() }
    }
}

/// A place on the floor for the first piece of a class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suggestion {
    /// Index into the catalogue's classes.
    pub class: ClassIndex,
    /// One of the class's sizes.
    pub size: Size,
    /// Middle of the underside, in the level's plan frame.
    pub position: Point,
    /// Radians counter-clockwise; at zero the front faces −y.
    pub angle: f64,
    /// The wall that it has its back to, by index into the room's walls.
    pub wall: Option<usize>,
}

/// The suggestion for an agent.
pub(crate) fn suggestion(environment: &Environment<'_>, agent: AgentIndex) -> Option<Suggestion> {
    let agent = &environment.agents[agent];
    let is_first = agent.searches == 0 && environment.resting[agent.piece.class].is_empty();
    let suggested = environment.suggestions.iter().find(|suggested| suggested.class == agent.piece.class);
    suggested.copied().filter(|_| is_first)
}

/// Whether an agent rests where it was suggested: others can make way.
pub(crate) fn follows_suggestion(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let agent = &environment.agents[agent];
    let is_here = |suggested: &Suggestion| {
        suggested.class == agent.piece.class
            && agent.rest().is_some_and(|rest| rest.pose.position == suggested.position)
    };
    environment.suggestions.iter().any(is_here)
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
    let mut places = places.filter(|place| environment.obstruction(agent, place).is_none());
    places.find(|place| super::rules::meets_needs(environment, agent, place))
}
