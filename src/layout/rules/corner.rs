//! Whether the sides of a piece are closed: a bath, a shower or a bed for one stands in a corner, with a wall at its back and
//! something at one side; in a niche both sides are closed.

use crate::catalog::WallWishes;
use crate::geometry::{Convex, Point, Solid};
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, Place};

/// Metres beside a piece within which it is closed: a joint, or a board. Larger: gaps that collect dust count as closed.
const JOINT: f64 = 0.04;
/// Metres that may be left beside what fills a niche: a ledge with tiles, as wide as the steps between the sizes and a joint.
const LEDGE: f64 = 0.11;
/// Metres beside a piece from which on the rest of a niche has a use: somebody stands there, or a cabinet does.
const USEFUL: f64 = 0.6;
/// Where along its depth a side is asked, in shares of the depth from the middle to the back. A niche is closed at all of them: a
/// jog of the wall at its back alone closes half of a corner.
const SHARES: [f64; 2] = [-0.3, 0.3];
/// Metres of the side that are asked at each of them.
const LENGTH: f64 = 0.1;

/// The points of an agent for how much of its left or its right side is closed at a place, by a wall or by what stands there.
pub(super) fn corner_points(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> f64 {
    let WallWishes { corner, half_corner, .. } = environment.class(agent).walls;
    if corner == 0.0 && half_corner == 0.0 {
        return 0.0;
    }
    let closed = |side: f64| closed_parts(environment, agent, place, (side, JOINT));
    match closed(-1.0).max(closed(1.0)) {
        0 => 0.0,
        parts if parts < SHARES.len() => half_corner,
        _ => corner,
    }
}

/// Whether both sides of an agent are closed at a place, one of them at a ledge at most.
pub(crate) fn fills_niche(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    let is_closed = |side: (f64, f64)| closed_parts(environment, agent, place, side) == SHARES.len();
    [-1.0, 1.0].into_iter().any(|side| is_closed((side, JOINT)) && is_closed((-side, LEDGE)))
}

/// Whether an agent that has sizes for niches stands in the corner of one and leaves a strip of it that nothing fits into.
pub(super) fn leaves_rest_of_niche(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    let is_closed = |side: (f64, f64)| closed_parts(environment, agent, place, side) == SHARES.len();
    // A wall: another piece there has made use of the rest.
    let is_walled = |side: (f64, f64)| {
        parts_of_side(environment, agent, place, side).all(|part| !environment.is_inside(&part))
    };
    let leaves_rest =
        |side: f64| is_closed((-side, JOINT)) && !is_closed((side, LEDGE)) && is_walled((side, USEFUL));
    environment.class(agent).niche_sizes > 0 && [-1.0, 1.0].into_iter().any(leaves_rest)
}

/// At how many of the [`SHARES`] one side is closed within some metres, by a wall or by what stands there.
fn closed_parts(environment: &Environment<'_>, agent: AgentIndex, place: &Place, side: (f64, f64)) -> usize {
    let is_closed = |part: &Solid| !environment.is_inside(part) || environment.is_taken(part);
    parts_of_side(environment, agent, place, side).filter(is_closed).count()
}

/// The spaces beside an agent at the [`SHARES`] of a side, so many metres wide; −1 is the left side, 1 the right one.
fn parts_of_side(
    environment: &Environment<'_>,
    agent: AgentIndex,
    place: &Place,
    (side, within): (f64, f64),
) -> impl Iterator<Item = Solid> {
    let (size, pose) = (environment.agents[agent].size, place.pose);
    SHARES.into_iter().map(move |share| {
        let middle = pose.place(Point::new(side * (size.width + within) / 2.0, share * size.depth));
        let base = Convex::rectangle(middle, Point::new(within, LENGTH) / 2.0, pose.right);
        Solid::new(base, pose.elevation, pose.elevation + size.height)
    })
}

#[cfg(test)]
mod tests {
    use crate::catalog::{Along, Clearance, Count, ParentName, ParentRule, Side, Size, Turn, Untidiness};
    use crate::layout::tests::{catalog, level, rule, run};

    #[test]
    fn a_side_that_is_half_closed_is_liked_better_than_an_open_one() {
        let mut catalog = catalog(&[(4, Count::Fixed(1))], Untidiness::default());
        let bed = &mut catalog.classes[4];
        bed.sizes[0] = Size { width: 0.8, depth: 1.2, height: 1.0 };
        let at_wall = rule(ParentName::Wall, &[Side::Front], Turn::Parallel, Along::Ends);
        bed.parents = vec![ParentRule { tag: Some("here".to_owned()), ..at_wall }];
        // Who needs space compares places.
        bed.clearances = vec![Clearance::SEAT];
        (bed.walls.corner, bed.walls.half_corner) = (3.0, 1.5);
        // The wall for it ends at a jog of 0.6 m, and at a slanted wall that closes no side.
        let mut level = level(&[(0.0, 0.0), (6.0, 0.0), (7.0, 3.0), (0.6, 3.0), (0.6, 2.4), (0.0, 2.4)]);
        level.rooms[0].walls[2].tags.push("here".to_owned());
        for seed in 0..12 {
            let position = run(&level, &catalog, seed).placements[0].position;
            assert!((position.x - 1.0).abs() < 0.01, "seed {seed}: {position}");
        }
    }
}
