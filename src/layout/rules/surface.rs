//! On top of (or under) an object: a position on its surface (section 3.2).

use crate::catalog::{Along, Side, Turn};
use crate::geometry::{Bounds, Point};
use crate::layout::agent::Agent;
use crate::layout::body::Pose;
use crate::layout::constants::{FRONT_MARGIN, SURFACE_STEP, TRIALS_PER_SIDE};
use crate::layout::place::AgentIndex;
use crate::layout::seed::Stream;

use super::View;
use super::turn::{self, Bearing};

/// The carrying rectangle in the parent's frame, and who is on it already.
#[derive(Clone, Copy, Debug)]
struct Surface {
    bounds: Bounds,
    /// Metres above the parent's underside at which a child's underside comes to be.
    elevation: f64,
    places: usize,
    taken: usize,
    /// Half axes of the ellipse that carries, where the top is round.
    round: Option<Point>,
}

impl Surface {
    fn of(view: &View<'_>, parent: AgentIndex, agent: &Agent) -> Self {
        let class = view.environment.class(parent);
        let offer = class.offer(view.side);
        let [left, front, right, back] = offer.margin;
        let half = Point::new(agent.size.width, agent.size.depth) / 2.0;
        Self {
            bounds: Bounds::new(Point::new(left, front) - half, half - Point::new(right, back)),
            elevation: match view.side {
                Side::Below => -view.size.height,
                _ => offer.surface.unwrap_or(agent.size.height),
            },
            places: offer.places.max(1) as usize,
            taken: agent.taken[view.side.index()] as usize,
            round: class.shape.is_round_on_top().then_some(half),
        }
    }
}

/// Poses on the surface of a resting agent.
pub(super) fn propose(view: &View<'_>, parent: AgentIndex, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let agent = &view.environment.agents[parent];
    let Some(rest) = agent.rest() else { return };
    let surface = Surface::of(view, parent, agent);
    let elevation = rest.pose.elevation + surface.elevation;
    let orientation = &view.rule.orientation;
    let bearing = Bearing { parent_angle: rest.pose.angle, outward: Point::ZERO };
    for trial in 0..TRIALS_PER_SIDE {
        let angle = turn::angle(orientation, &bearing, stream);
        let extent = half_extents(view, angle, &rest.pose);
        let Some(local) = position(&surface, extent, view.rule.along, trial, stream) else { return };
        let local = surface.round.map_or(local, |axes| onto_ellipse(local, extent, axes));
        let position = rest.pose.place(local);
        let angle = match orientation.turn {
            Turn::TowardsCenter => turn::towards(orientation, position, rest.pose.position, stream),
            _ => angle,
        };
        // Drawn for each trial, also where the rule leaves no choice: the numbers after it stay the same.
        let lift = stream.between(view.rule.elevation.0, view.rule.elevation.1);
        poses.push(Pose::new(position, elevation + lift, angle));
        // There is one middle: further trials would propose it again.
        if view.rule.along == Along::Center {
            return;
        }
    }
}

/// Poses on a lattice over the surface, along the edge that the rule asks for.
pub(super) fn scan(view: &View<'_>, parent: AgentIndex, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let agent = &view.environment.agents[parent];
    let Some(rest) = agent.rest() else { return };
    let surface = Surface::of(view, parent, agent);
    let elevation = rest.pose.elevation + surface.elevation + view.rule.elevation.0;
    let bearing = Bearing { parent_angle: rest.pose.angle, outward: Point::ZERO };
    let angle = turn::angle(&view.rule.orientation, &bearing, stream);
    let extent = half_extents(view, angle, &rest.pose);
    let (least, most) = (surface.bounds.low + extent, surface.bounds.high - extent);
    if least.cmpgt(most).any() {
        return;
    }
    // At least one step each way, so that both ends are tried on a small surface too.
    let steps = ((most - least) / SURFACE_STEP).ceil().max(Point::ONE);
    let rows = match view.rule.along {
        Along::Random => 0..=steps.y as u32,
        Along::Back => steps.y as u32..=steps.y as u32,
        Along::Front => 0..=0,
        Along::Center | Along::Even | Along::Ends | Along::Axis => return,
    };
    for row in rows {
        for column in 0..=steps.x as u32 {
            let share = Point::new(f64::from(column), f64::from(row)) / steps;
            let local = least + (most - least) * share;
            let local = surface.round.map_or(local, |axes| onto_ellipse(local, extent, axes));
            poses.push(Pose::new(rest.pose.place(local), elevation, angle));
        }
    }
}

/// Half of the child's extent along width and depth of its parent.
fn half_extents(view: &View<'_>, angle: f64, parent: &Pose) -> Point {
    let right = crate::geometry::direction(angle);
    Point::new(
        Agent::half_extent(view.size, right, parent.right),
        Agent::half_extent(view.size, right, parent.right.perp()),
    )
}

/// Where the middle of a child with half extents `extent` goes, in the parent's frame; `None` if it is larger
/// than the surface.
fn position(
    surface: &Surface,
    extent: Point,
    along: Along,
    trial: usize,
    stream: &mut Stream,
) -> Option<Point> {
    let (least, most) = (surface.bounds.low + extent, surface.bounds.high - extent);
    // A child as large as the surface fits it, whatever rounding says.
    if least.cmpgt(most + Point::splat(1e-9)).any() {
        return None;
    }
    let middle = (least + most) / 2.0;
    Some(match along {
        Along::Center | Along::Axis => middle,
        Along::Even => {
            // The next of the even places first, then those after it.
            let index = (surface.taken + trial) % surface.places;
            let share = (index as f64 + 0.5) / surface.places as f64;
            let x = surface.bounds.low.x + surface.bounds.size().x * share;
            Point::new(x.min(most.x).max(least.x), middle.y)
        }
        Along::Back => Point::new(stream.between(least.x, most.x), most.y),
        Along::Front => Point::new(stream.between(least.x, most.x), (least.y + FRONT_MARGIN).min(most.y)),
        Along::Ends => {
            Point::new(if (trial + surface.taken).is_multiple_of(2) { least.x } else { most.x }, middle.y)
        }
        Along::Random => Point::new(stream.between(least.x, most.x), stream.between(least.y, most.y)),
    })
}

/// The position moved towards the middle until a box with half extents `extent` stands on the ellipse with all
/// four corners: a round top has none where a box would have them.
fn onto_ellipse(position: Point, extent: Point, axes: Point) -> Point {
    const STEPS: u32 = 20;
    let carries = |at: &Point| ((at.abs() + extent) / axes).length_squared() <= 1.0;
    let steps = (0..=STEPS).rev().map(|step| position * (f64::from(step) / f64::from(STEPS)));
    steps.into_iter().find(carries).unwrap_or(Point::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bottle_at_the_missing_corner_of_a_round_top_moves_in() {
        let (extent, axes) = (Point::splat(0.04), Point::splat(0.5));
        let moved = onto_ellipse(Point::splat(0.46), extent, axes);
        assert!((moved + extent).length() <= 0.5 && moved.length() > 0.3, "{moved}");
        assert_eq!(moved.x, moved.y, "straight towards the middle");
        let inside = Point::new(0.3, 0.1);
        assert_eq!(onto_ellipse(inside, extent, axes), inside);
    }

    #[test]
    fn what_is_too_large_for_a_round_top_stands_in_its_middle() {
        assert_eq!(onto_ellipse(Point::X, Point::splat(0.4), Point::splat(0.5)), Point::ZERO);
    }
}
