//! On the floor or under the ceiling: a random position in the room (section 3.2).

use std::f64::consts::FRAC_PI_2;

use crate::catalog::{Along, Turn};
use crate::geometry::Point;
use crate::layout::agent::Agent;
use crate::layout::body::Pose;
use crate::layout::constants::{SAME_DIRECTION, SCAN_DIRECTIONS, SCAN_POINTS, SCAN_STEP, TRIALS_PER_FLOOR};
use crate::layout::place::ParentPart;
use crate::layout::seed::Stream;

use super::View;
use super::turn::{self, Bearing, angle_of_front};

/// Metres between the places that are tried in the axis of a room.
const AXIS_STEP: f64 = 0.25;
/// Share of the axis, from its end on, in which they are.
const AXIS_SHARE: f64 = 0.6;

/// Poses on the floor or ceiling: in the room's corners, around its middle, or anywhere.
pub(super) fn propose(view: &View<'_>, stream: &mut Stream, poses: &mut Vec<Pose>) {
    if view.rule.along == Along::Ends {
        propose_corners(view, stream, poses);
        if view.environment.is_built_in(view.agent) {
            return;
        }
    }
    if view.rule.along == Along::Axis {
        return propose_on_axis(view, stream, poses);
    }
    let region = &view.environment.brief.surroundings.room.region;
    let bounds = region.outline.bounds();
    let middle = bounds.center();
    for trial in 0..TRIALS_PER_FLOOR {
        // Around the middle the circle of trials grows; elsewhere every point is as likely.
        let spread = match view.rule.along {
            Along::Center => trial as f64 / TRIALS_PER_FLOOR as f64,
            _ => 1.0,
        };
        let offset = Point::new(stream.signed(), stream.signed()) * bounds.size() / 2.0 * spread;
        if region.contains(middle + offset) {
            poses.push(pose_at(view, middle + offset, stream));
        }
    }
}

/// Poses on a regular lattice over the whole room, in a fixed order.
pub(super) fn scan(view: &View<'_>, is_thorough: bool, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let is_of_corners = view.rule.along == Along::Ends && view.environment.is_built_in(view.agent);
    if is_of_corners || view.rule.along == Along::Axis {
        return;
    }
    let region = &view.environment.brief.surroundings.room.region;
    let bounds = region.outline.bounds();
    let size = bounds.size();
    let (finest, most) =
        if is_thorough { (SCAN_STEP / 2.0, 2.0 * SCAN_POINTS) } else { (SCAN_STEP, SCAN_POINTS) };
    // A hall gets no more points than a room, but farther apart: the time of a scan is bounded.
    let step = finest.max((size.x * size.y / most).sqrt());
    let (columns, rows) = ((size.x / step) as usize, (size.y / step) as usize);
    for row in 0..=rows {
        for column in 0..=columns {
            let point = bounds.low + Point::new(column as f64 + 0.5, row as f64 + 0.5) * step;
            if region.contains(point) {
                poses.push(pose_at(view, point, stream));
            }
        }
    }
    if is_thorough && view.rule.orientation.turn == Turn::Quarter {
        add_all_turns(view, poses);
    }
}

/// Pieces that the room cannot do without are also tried at every quarter turn of every wall.
fn add_all_turns(view: &View<'_>, poses: &mut Vec<Pose>) {
    let surroundings = &view.environment.brief.surroundings;
    let mut turns = vec![surroundings.main_angle];
    for wall in surroundings.room.walls.iter().filter(|wall| wall.length() > SCAN_STEP) {
        let along = wall.direction();
        let is_known = |turn: &f64| {
            let known = crate::geometry::direction(*turn);
            known.dot(along).abs().min(known.perp_dot(along).abs()) < SAME_DIRECTION
        };
        // Walls within about a degree count as one direction, and quarter turns of each other too.
        if turns.len() < SCAN_DIRECTIONS && !turns.iter().any(is_known) {
            turns.push(angle_of_front(wall.normal()));
        }
    }
    let places: Vec<Pose> = poses.clone();
    for turn in turns {
        for quarter in 0..4 {
            let angle = turn + FRAC_PI_2 * f64::from(quarter);
            poses.extend(places.iter().map(|place| Pose::new(place.position, place.elevation, angle)));
        }
    }
}

/// The corners of the room from a random one on: flush with the wall that leaves the corner and the one
/// before.
fn propose_corners(view: &View<'_>, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let corners = view.environment.brief.surroundings.room.region.outline.corners();
    let count = corners.len();
    let first = stream.below(count);
    for index in first..first + count {
        let (before, at, after) =
            (corners[(index + count - 1) % count], corners[index % count], corners[(index + 1) % count]);
        let (incoming, along) = ((at - before).normalize(), (after - at).normalize());
        let sine = incoming.perp_dot(along);
        // What is built in touches both walls, and a run goes on from it along each of them.
        let shortest = (at - before).length().min((after - at).length());
        let is_corner_of_runs =
            incoming.dot(along).abs() < SAME_DIRECTION && shortest >= 2.0 * view.size.width;
        if sine <= 0.0 || (view.environment.is_built_in(view.agent) && !is_corner_of_runs) {
            continue;
        }
        let angle = angle_of_front(along.perp());
        let right = crate::geometry::direction(angle);
        let half = Point::new(
            Agent::half_extent(view.size, right, along),
            Agent::half_extent(view.size, right, along.perp()),
        );
        // In an acute corner the other wall leans over the box; it starts where that wall is high enough.
        let shift = (-incoming.dot(along) / sine * 2.0 * half.y).max(0.0);
        let gap = view.rule.gap.0;
        let position = at + along * (half.x + gap + shift) + along.perp() * (half.y + gap);
        poses.push(Pose::new(position, elevation(view), angle));
    }
}

/// Poses in the long axis of the room, from its end on, with the back to the end.
fn propose_on_axis(view: &View<'_>, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let surroundings = &view.environment.brief.surroundings;
    let Some(axis) = surroundings.room.long_axis(&surroundings.level.openings) else { return };
    let (way, length) = (-axis.direction(), axis.length());
    let bearing = Bearing { parent_angle: angle_of_front(way), outward: Point::ZERO };
    let angle = turn::angle(&view.rule.orientation, &bearing, stream);
    let right = crate::geometry::direction(angle);
    let first = stream.between(view.rule.gap.0, view.rule.gap.1) + Agent::half_extent(view.size, right, way);
    let step = AXIS_STEP.max(length / SCAN_POINTS);
    let steps = ((length * AXIS_SHARE - first) / step).max(0.0) as u32;
    let at = (0..=steps).map(|number| axis.end + way * (first + step * f64::from(number)));
    poses.extend(at.map(|position| Pose::new(position, elevation(view), angle)));
}

fn pose_at(view: &View<'_>, position: Point, stream: &mut Stream) -> Pose {
    let surroundings = &view.environment.brief.surroundings;
    let bearing = Bearing { parent_angle: surroundings.main_angle, outward: Point::ZERO };
    let angle = match view.rule.orientation.turn {
        Turn::TowardsCenter => {
            let middle = surroundings.room.region.outline.bounds().center();
            turn::towards(&view.rule.orientation, position, middle, stream)
        }
        _ => turn::angle(&view.rule.orientation, &bearing, stream),
    };
    Pose::new(position, elevation(view), angle)
}

/// Metres of the underside: standing on the floor, or hanging with the top at the ceiling.
pub(super) fn elevation(view: &View<'_>) -> f64 {
    match view.parent {
        ParentPart::Ceiling => view.environment.brief.surroundings.room.height - view.size.height,
        _ => view.rule.elevation.0,
    }
}
