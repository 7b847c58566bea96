//! Beside an object or a column: the touching sides meet, the position along them is free (section 3.2).

use crate::catalog::{Along, Side, Turn};
use crate::geometry::Point;
use crate::layout::agent::Agent;
use crate::layout::body::{Pose, outward};
use crate::layout::constants::TRIALS_PER_SIDE;
use crate::layout::place::AgentIndex;
use crate::layout::seed::Stream;

use super::View;
use super::turn::{self, Bearing};

/// A side of a parent as a line that children touch.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// Middle of the side.
    center: Point,
    /// Unit vector away from the parent.
    outward: Point,
    /// Metres along the side.
    length: f64,
    /// Metres of the parent's underside above the floor.
    base: f64,
    /// The parent's middle.
    parent_center: Point,
    /// The parent's angle.
    parent_angle: f64,
    /// Places on the side, and how many are taken.
    places: (u32, u32),
}

/// Poses at a side of a resting agent.
pub(super) fn propose_at_agent(
    view: &View<'_>,
    parent: AgentIndex,
    stream: &mut Stream,
    poses: &mut Vec<Pose>,
) {
    let agent = &view.environment.agents[parent];
    let Some(rest) = agent.rest() else { return };
    let (width, depth) = (agent.size.width, agent.size.depth);
    let (reach, length) = match view.side {
        Side::Left | Side::Right => (width / 2.0, depth),
        _ => (depth / 2.0, width),
    };
    let out = rest.pose.turn(outward(view.side));
    let offer = view.environment.class(parent).offer(view.side);
    let face = Face {
        center: rest.pose.position + out * reach,
        outward: out,
        length,
        base: rest.pose.elevation,
        parent_center: rest.pose.position,
        parent_angle: rest.pose.angle,
        places: (offer.places, agent.taken[view.side.index()]),
    };
    propose(view, &face, stream, poses);
}

/// Poses at a side of the box around a column.
pub(super) fn propose_at_column(view: &View<'_>, column: usize, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let bounds = view.environment.brief.surroundings.room.obstacles[column].outline.bounds();
    let (center, half) = (bounds.center(), bounds.size() / 2.0);
    let out = outward(view.side);
    let face = Face {
        center: center + out * half,
        outward: out,
        length: 2.0 * half.dot(out.perp().abs()),
        base: 0.0,
        parent_center: center,
        // A column has no front: children turn to it as to a piece whose front is on their side.
        parent_angle: turn::angle_of_front(out),
        places: (1, 0),
    };
    propose(view, &face, stream, poses);
}

fn propose(view: &View<'_>, face: &Face, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let bearing = Bearing { parent_angle: face.parent_angle, outward: face.outward };
    let (rule, along) = (view.rule, face.outward.perp());
    for trial in 0..trials(rule.along, face) {
        let angle = turn::angle(&rule.orientation, &bearing, stream);
        let right = crate::geometry::direction(angle);
        // Half of what the side leaves free. A child that is longer than the side sits at its middle.
        let room = (face.length / 2.0 - Agent::half_extent(view.size, right, along)).max(0.0);
        let at = match rule.along {
            Along::Center => 0.0,
            Along::Even => even(face, trial),
            Along::Ends => room * if trial % 2 == 0 { 1.0 } else { -1.0 },
            // Left and right of a parent, "back" is flush with its back, so that cabinets line up.
            // Around a corner the back is at the wall beside the parent.
            Along::Back if rule.orientation.turn == Turn::AroundCorner => room,
            Along::Back => room * towards_back(face, along),
            Along::Front => -room * towards_back(face, along),
            Along::Random => room * stream.signed(),
        };
        // Drawn for each trial, also where the rule leaves no choice: the numbers after it stay the same.
        let gap = stream.between(rule.gap.0, rule.gap.1);
        let reach = Agent::half_extent(view.size, right, face.outward);
        let position = face.center + face.outward * (reach + gap) + along * at;
        let elevation = face.base + stream.between(rule.elevation.0, rule.elevation.1);
        let angle = match rule.orientation.turn {
            Turn::TowardsCenter => turn::towards(&rule.orientation, position, face.parent_center, stream),
            _ => angle,
        };
        poses.push(Pose::new(position, elevation, angle));
    }
}

/// How many positions make sense: one where it is given, one per place where they are spread evenly.
fn trials(along: Along, face: &Face) -> usize {
    match along {
        Along::Center | Along::Back | Along::Front => 1,
        Along::Ends => 2,
        Along::Even => face.places.0.max(1) as usize,
        Along::Random => TRIALS_PER_SIDE,
    }
}

/// The middle of the side's place number `taken + trial`, cyclically.
fn even(face: &Face, trial: usize) -> f64 {
    let places = face.places.0.max(1) as usize;
    let index = (face.places.1 as usize + trial) % places;
    face.length * ((index as f64 + 0.5) / places as f64 - 0.5)
}

/// Which end of `along` is the parent's back: 1 or −1, and 0 on the front and back themselves.
fn towards_back(face: &Face, along: Point) -> f64 {
    Pose::new(face.parent_center, 0.0, face.parent_angle).turn(Point::Y).dot(along).round()
}
