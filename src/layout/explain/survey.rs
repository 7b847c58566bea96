//! The pieces along the walls, for `explain`. The search tries places in the free stretches of a wall only, so that a piece for
//! which no stretch is long enough has no refused place to report; this survey names what takes the wall.

use std::collections::BTreeSet;

use crate::catalog::{ParentName, ParentRule, Side};
use crate::geometry::Point;

use crate::layout::body::Pose;
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::layout::rules::angle_of_front;
use crate::layout::trace::Refused;

/// Metres between the places of a survey.
const STEP: f64 = 0.1;

/// Places along all walls that a piece could stand at, and why not.
#[derive(Clone, Debug, Default)]
pub(super) struct Survey {
    /// How many.
    pub(super) places: u32,
    /// Those where it cannot.
    pub(super) refused: Refused,
}

/// Looks along the walls that an agent's description allows, as the room is now; `None` if it allows none.
pub(super) fn survey_walls(environment: &Environment<'_>, agent: AgentIndex) -> Option<Survey> {
    let parents = &environment.class(agent).parents;
    let rule = parents.iter().find(|rule| rule.parent == ParentName::Wall)?;
    let mut survey = Survey::default();
    let places = places(environment, agent, rule);
    for place in &places {
        survey.places += 1;
        let mut obstacles = BTreeSet::new();
        let Some(reason) = environment.obstruction(agent, place, &mut obstacles) else { continue };
        survey.refused.add(reason, obstacles);
    }
    (survey.places > 0).then_some(survey)
}

/// Places side by side along all walls, the back to the wall.
fn places(environment: &Environment<'_>, agent: AgentIndex, rule: &ParentRule) -> Vec<Place> {
    let size = environment.agents[agent].size;
    let mut places = Vec::new();
    for (index, wall) in environment.brief.surroundings.room.walls.iter().enumerate() {
        if rule.tag.as_ref().is_some_and(|tag| !wall.tags.contains(tag)) {
            continue;
        }
        let from_wall = wall.normal() * (rule.gap.0 + size.depth / 2.0);
        let room = wall.length() - size.width;
        let count = if room < 0.0 { 0 } else { (room / STEP) as u32 + 1 };
        let pose = |number: u32| {
            let along = size.width / 2.0 + STEP * f64::from(number);
            let position: Point = wall.after(along) + from_wall;
            Pose::new(position, rule.elevation.0, angle_of_front(wall.normal()))
        };
        let place = |number| Place { pose: pose(number), parent: ParentPart::Wall(index), side: Side::Front };
        places.extend((0..count).map(place));
    }
    places
}
