//! Whether the sides of a piece are closed: a bath, a shower or a bed for one stands in a corner, with a wall at its back and
//! something at one side; in a niche both sides are closed.

use crate::geometry::{Convex, Point, Solid};
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, Place};

/// Metres beside a piece within which it is closed: a joint, or a board. Larger: gaps that collect dust count as closed.
const JOINT: f64 = 0.04;
/// Where along its depth a side is asked, in shares of the depth from the middle to the back. It is closed if it is at all of
/// them: a jog of the wall at its back alone closes nothing.
const SHARES: [f64; 2] = [-0.3, 0.3];
/// Metres of the side that are asked at each of them.
const LENGTH: f64 = 0.1;

/// Whether the left or the right side of an agent is closed at a place, by a wall or by what stands there.
pub(super) fn stands_in_corner(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    [-1.0, 1.0].into_iter().any(|side| is_closed(environment, agent, place, (side, JOINT)))
}

/// Whether both sides of an agent are closed at a place, one at most so many metres away, the other at a joint.
pub(crate) fn fills_niche(environment: &Environment<'_>, agent: AgentIndex, place: &Place, gap: f64) -> bool {
    let is_closed = |side: f64, within: f64| is_closed(environment, agent, place, (side, within));
    [-1.0, 1.0].into_iter().any(|side| is_closed(side, JOINT) && is_closed(-side, gap))
}

/// Whether one side is closed within some metres; −1 is the left one, 1 the right one.
fn is_closed(
    environment: &Environment<'_>,
    agent: AgentIndex,
    place: &Place,
    (side, within): (f64, f64),
) -> bool {
    let (size, pose) = (environment.agents[agent].size, &place.pose);
    SHARES.into_iter().all(|share| {
        let middle = pose.place(Point::new(side * (size.width + within) / 2.0, share * size.depth));
        let base = Convex::rectangle(middle, Point::new(within, LENGTH) / 2.0, pose.right);
        let bit = Solid::new(base, pose.elevation, pose.elevation + size.height);
        !environment.is_inside(&bit) || environment.is_taken(&bit)
    })
}
