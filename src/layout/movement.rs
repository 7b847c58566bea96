//! Moves agents that rest: their children follow, and children that collide lose their parent (section 3.2, "rest").

use crate::geometry::Point;

use super::agent::{Rest, State};
use super::body::Pose;
use super::environment::Environment;
use super::place::{AgentIndex, ParentPart, Place};

/// Moves a resting agent and all that stands on it. Returns whether it moved: if its own new place is not free,
/// everything stays. A descendant that collides at its new place searches again, and so does what stood on it.
pub(crate) fn move_agent(environment: &mut Environment<'_>, agent: AgentIndex, pose: Pose) -> bool {
    let Some(group) = lift(environment, agent) else { return false };
    let old = *group.head();
    let place = Place { pose, ..old.place() };
    if !environment.is_free(agent, &place) {
        group.put_back(environment);
        return false;
    }
    environment.settle(agent, &place);
    for &(member, rest) in &group.0[1..] {
        follow(environment, member, &rest, &old.pose, &pose);
    }
    true
}

/// A resting agent with all that stands on it or belongs to it, taken out of the room to be put elsewhere.
pub(crate) struct Group(Vec<(AgentIndex, Rest)>);

/// Takes a resting agent out of the room, with its group; `None` if it does not rest.
pub(crate) fn lift(environment: &mut Environment<'_>, agent: AgentIndex) -> Option<Group> {
    let family = family(environment, agent);
    // Children leave before what they stand on: nobody rests on an agent that does not rest.
    for &(member, _) in family.iter().rev() {
        environment.unsettle(member);
    }
    (!family.is_empty()).then_some(Group(family))
}

impl Group {
    /// Where the first one rested.
    pub(crate) fn head(&self) -> &Rest {
        &self.0[0].1
    }

    /// Puts all where they were.
    pub(crate) fn put_back(&self, environment: &mut Environment<'_>) {
        for &(member, rest) in &self.0 {
            environment.settle(member, &rest.place());
        }
    }

    /// Puts the first one at a pose and carries the others along. Where one of them has no place then, nobody is
    /// put anywhere and the answer is no.
    pub(crate) fn settle_whole(&self, environment: &mut Environment<'_>, pose: &Pose) -> bool {
        let from = self.head().pose;
        for (count, &(member, rest)) in self.0.iter().enumerate() {
            let place = Place { pose: carried(&rest.pose, &from, pose), ..rest.place() };
            if !environment.is_free(member, &place) {
                for &(settled, _) in self.0[..count].iter().rev() {
                    environment.unsettle(settled);
                }
                return false;
            }
            environment.settle(member, &place);
        }
        true
    }
}

/// Sends a resting agent away from where it stands, with all that stands on it, to search again.
pub(crate) fn send_away(environment: &mut Environment<'_>, agent: AgentIndex) {
    // What stood on it searches again too, each piece by itself.
    for (member, _) in family(environment, agent).into_iter().rev() {
        environment.unsettle(member);
        environment.agents[member].searches += 1;
        environment.agents[member].suggestion = None;
    }
    environment.agents[agent].is_in_the_way = true;
    // There is more room now than when others of its class found none.
    environment.is_exhausted.fill(false);
}

fn follow(environment: &mut Environment<'_>, member: AgentIndex, rest: &Rest, from: &Pose, to: &Pose) {
    let has_parent = match rest.parent {
        ParentPart::Agent(parent) => environment.agents[parent].rest().is_some(),
        _ => true,
    };
    let pose = carried(&rest.pose, from, to);
    let place = Place { pose, ..rest.place() };
    // Parents come first: whether the parent found its new place is known by now.
    if has_parent && environment.is_free(member, &place) {
        environment.settle(member, &place);
    } else {
        environment.agents[member].state = State::Search;
        environment.agents[member].searches += 1;
    }
}

/// A pose after the frame it stands in went from one pose to another.
fn carried(pose: &Pose, from: &Pose, to: &Pose) -> Pose {
    let offset = pose.position - from.position;
    // In the frame of the old pose, so that a child keeps its place on a parent that turns.
    let local = Point::new(offset.dot(from.right), offset.dot(from.right.perp()));
    let elevation = pose.elevation + to.elevation - from.elevation;
    Pose::new(to.place(local), elevation, pose.angle + to.angle - from.angle)
}

/// An agent and its descendants, parents first, with where they rest.
pub(crate) fn family(environment: &Environment<'_>, agent: AgentIndex) -> Vec<(AgentIndex, Rest)> {
    let mut family = Vec::new();
    let mut waiting = vec![agent];
    while let Some(member) = waiting.pop() {
        if let Some(rest) = environment.agents[member].rest() {
            family.push((member, *rest));
            waiting.extend(environment.agents[member].children.iter().rev());
        }
    }
    family
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn what_stands_on_a_turned_table_turns_with_it() {
        let from = Pose::new(Point::new(1.0, 1.0), 0.0, 0.0);
        let to = Pose::new(Point::new(3.0, 1.0), 0.0, FRAC_PI_2);
        let lamp = Pose::new(Point::new(1.5, 1.0), 0.74, 0.2);
        let moved = carried(&lamp, &from, &to);
        assert!(moved.position.distance(Point::new(3.0, 1.5)) < 1e-12);
        assert!((moved.angle - 0.2 - FRAC_PI_2).abs() < 1e-12);
        assert_eq!(moved.elevation, 0.74);
    }
}
