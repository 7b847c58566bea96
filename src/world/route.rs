//! A way inside a room, around its corners. Furniture is walked through: what is measured is when rooms have to be there.

use crate::geometry::{Point, Region, Segment};

/// Metres that the way keeps from corners and openings.
pub(super) const CLEARANCE: f64 = 0.3;
/// Metres between the places at which a straight way is tested.
const STEP: f64 = 0.2;
/// Corners of a room that a way goes around at most.
const MOST_CORNERS: usize = 64;

/// The corners of a short way from one place of a room to another, both included; straight where there is none.
pub(crate) fn route(region: &Region, from: Point, to: Point) -> Vec<Point> {
    if is_free(region, from, to) {
        return vec![from, to];
    }
    let mut points = vec![from, to];
    points.extend(turns(region).take(MOST_CORNERS));
    let mut metres = vec![f64::INFINITY; points.len()];
    let mut before = vec![0_usize; points.len()];
    let mut is_done = vec![false; points.len()];
    metres[0] = 0.0;
    loop {
        let open = (0..points.len()).filter(|index| !is_done[*index] && metres[*index].is_finite());
        let Some(nearest) = open.min_by(|one, other| metres[*one].total_cmp(&metres[*other])) else {
            return vec![from, to];
        };
        if nearest == 1 {
            break;
        }
        is_done[nearest] = true;
        for next in 0..points.len() {
            let length = metres[nearest] + points[nearest].distance(points[next]);
            if length < metres[next] && is_free(region, points[nearest], points[next]) {
                (metres[next], before[next]) = (length, nearest);
            }
        }
    }
    let mut way = vec![points[1]];
    let mut at = 1;
    while at != 0 {
        at = before[at];
        way.push(points[at]);
    }
    way.reverse();
    way
}

/// Places beside the corners around which a way may go: those where walls meet outwards.
fn turns(region: &Region) -> impl Iterator<Item = Point> + '_ {
    let edges: Vec<Segment> = region.borders().collect();
    let corners = edges.clone().into_iter().flat_map(move |edge| {
        let next = edges.iter().find(|next| next.start == edge.end).copied();
        next.filter(|next| edge.vector().perp_dot(next.vector()) < 0.0).map(|next| (edge, next))
    });
    corners
        .map(|(edge, next)| edge.end + (edge.direction() - next.direction()).normalize_or_zero() * CLEARANCE)
        .filter(|place| region.contains(*place))
}

/// Whether a straight way stays in a room; its ends may lie on the border.
fn is_free(region: &Region, from: Point, to: Point) -> bool {
    let steps = (from.distance(to) / STEP).ceil().max(1.0);
    let places = (1..steps as u32).map(|step| from.lerp(to, f64::from(step) / steps));
    places.into_iter().all(|place| region.contains(place))
}
