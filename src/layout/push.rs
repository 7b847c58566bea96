//! Pushes resting agents apart, within bounds: one that has less room than is good, or takes it from others, slides along its wall
//! or over the floor, with all that belongs to it. The paper tried this (section 6.1) and left it out for its cost.

use std::collections::BTreeSet;

use crate::geometry::Point;

use super::agent::Rest;
use super::body::Pose;
use super::constants::{LINE_WIDTH, PUSH_DISTANCES, PUSH_GAIN, PUSH_ROUNDS, SAME_DIRECTION};
use super::environment::Environment;
use super::locked::is_locked;
use super::movement::lift;
use super::place::{AgentIndex, ParentPart, Place};
use super::rules::{meets_needs, score};
use super::suggested::follows_suggestion;

/// Pushes every group with a tight member to the best place within reach.
pub(crate) fn push_apart(environment: &mut Environment<'_>) {
    for _ in 0..PUSH_ROUNDS {
        let mut has_moved = false;
        // In the order of the programme: each push sees where the earlier ones have led.
        for root in tight_roots(environment) {
            has_moved |= push(environment, root);
        }
        if !has_moved {
            return;
        }
    }
}

/// The agents at the head of the groups in which somebody has less room than is good.
fn tight_roots(environment: &Environment<'_>) -> BTreeSet<AgentIndex> {
    let is_tight = |&agent: &AgentIndex| {
        environment.agents[agent].rest().is_some_and(|rest| is_tight(environment, agent, &rest.place()))
    };
    let roots = (0..environment.agents.len()).filter(is_tight).map(|agent| root(environment, agent));
    roots.filter(|&root| can_slide(environment, root)).collect()
}

/// The direction of the line in which an agent on the floor stands with another of its class: beside it or behind it, turned
/// the same way or the other. Who slides along it leaves no line.
fn line_of(environment: &Environment<'_>, agent: AgentIndex, rest: &Rest) -> Option<Point> {
    let along = [rest.pose.right, rest.pose.right.perp()];
    let others = environment.resting[environment.agents[agent].piece.class].iter();
    let poses = others.filter(|&&other| other != agent).filter_map(|&other| environment.agents[other].rest());
    let in_line = |other: &Rest, along: Point| {
        let offset = other.pose.position - rest.pose.position;
        let is_parallel = other.pose.right.perp_dot(rest.pose.right).abs() < SAME_DIRECTION;
        is_parallel && offset.perp_dot(along).abs() < LINE_WIDTH
    };
    poses.flat_map(|other| along.into_iter().filter(move |&along| in_line(other, along))).next()
}

/// Whether an agent takes of the room that is good for others, or has less than is good itself.
fn is_tight(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    environment.lacks_comfort(agent, place) || environment.takes_comfort(agent, place, &mut ())
}

fn root(environment: &Environment<'_>, mut agent: AgentIndex) -> AgentIndex {
    while let Some(Rest { parent: ParentPart::Agent(parent), .. }) = environment.agents[agent].rest() {
        agent = *parent;
    }
    agent
}

/// Whether an agent may move at all: what is built in, in rows, hung, or where it was suggested stays.
fn can_slide(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    // A row keeps its spacing: one of it alone would leave it crooked.
    let is_free = environment.class(agent).grid.is_none()
        && !environment.is_built_in(agent)
        && !is_locked(environment, agent)
        && !follows_suggestion(environment, agent);
    let rest = environment.agents[agent].rest();
    is_free
        && rest.is_some_and(|rest| {
            rest.pose.elevation == 0.0 && matches!(rest.parent, ParentPart::Wall(_) | ParentPart::Floor)
        })
}

/// Moves a group to the best of the places within reach that are better than its own.
fn push(environment: &mut Environment<'_>, root: AgentIndex) -> bool {
    let Some(group) = lift(environment, root) else { return false };
    let old = group.head().place();
    let least = score(environment, root, &old).value + PUSH_GAIN;
    let mut better: Vec<(f64, Place)> = Vec::new();
    for pose in slides(environment, root, group.head()) {
        let place = Place { pose, ..old };
        if environment.is_free(root, &place) && meets_needs(environment, root, &place) {
            let value = score(environment, root, &place).value;
            if value > least {
                better.push((value, place));
            }
        }
    }
    // Stable: of equals the shorter way comes first.
    better.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    for (_, place) in better {
        if group.settle_whole(environment, &place.pose) {
            environment.note_push(root);
            return true;
        }
    }
    group.put_back(environment);
    false
}

/// The poses that an agent can slide to, nearest first: along its wall, or the line in which it stands with others of its class.
fn slides(environment: &Environment<'_>, agent: AgentIndex, rest: &Rest) -> Vec<Pose> {
    let directions: Vec<Point> = match rest.parent {
        ParentPart::Wall(wall) => {
            let along = environment.brief.surroundings.room.walls[wall].direction();
            vec![along, -along]
        }
        _ => match line_of(environment, agent, rest) {
            Some(along) => vec![along, -along],
            None => {
                let right = rest.pose.right;
                vec![right, right.perp(), -right, -right.perp()]
            }
        },
    };
    let slide = |(distance, direction): (f64, Point)| Pose {
        position: rest.pose.position + direction * distance,
        ..rest.pose
    };
    PUSH_DISTANCES
        .iter()
        .flat_map(|&distance| directions.iter().map(move |&direction| (distance, direction)))
        .map(slide)
        .collect()
}
