//! Takes needles off outlines: spurs narrower than any room, as drawn walls, flagpoles and slips of the mouse leave them.

use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::{BooleanOps, Buffer};

use super::sound::{SHARPEST_TIP, regions_of, surface_of};
use crate::geometry::{Region, Segment};

/// Metres of width below which a spur is a needle.
const NEEDLE_WIDTH: f64 = 0.6;
/// The share of the area that needles may have: where it is more, they are what the building is.
const NEEDLE_SHARE: f64 = 0.01;
/// Corners beyond which not all are compared with all to find out whether there is a needle.
const COMPARED_CORNERS: usize = 200;

/// The region without its needles; `None` if it has none, or if they are more than a needle.
pub(super) fn without_needles(region: &Region) -> Option<Region> {
    if !may_have_needles(region) {
        return None;
    }
    let surface = surface_of(region);
    let margin = NEEDLE_WIDTH / 2.0;
    let style = |distance: f64| BufferStyle::new(distance).line_join(LineJoin::Miter(SHARPEST_TIP));
    let opened = surface.buffer_with_style(style(-margin)).buffer_with_style(style(margin));
    let mut pieces = regions_of(surface.intersection(&opened));
    let area: f64 = pieces.iter().map(Region::area).sum();
    let lost = 1.0 - area / region.area();
    // One piece as before: a narrow passage between two halves is no needle.
    (pieces.len() == 1 && lost < NEEDLE_SHARE).then(|| pieces.remove(0))
}

/// Whether two edges that are no neighbours are near each other, or two neighbours fold back: a test that most outlines fail.
fn may_have_needles(region: &Region) -> bool {
    let edges: Vec<Segment> = region.outline.edges().collect();
    let count = edges.len();
    if count > COMPARED_CORNERS {
        return true;
    }
    /// Cosine of the sharpest corner that is no needle's, 30°.
    const SHARPEST: f64 = 0.866;
    let is_sharp = |at: usize| edges[at].direction().dot(edges[(at + 1) % count].direction()) < -SHARPEST;
    let near = |at: usize| {
        let box_near = edges[at].bounds().inflated(NEEDLE_WIDTH);
        (at + 2..count)
            .filter(move |other| (other + 1) % count != at)
            .any(|other| box_near.touches(edges[other].bounds()) && is_facing(edges[at], edges[other]))
    };
    (0..count).any(|at| is_sharp(at) || near(at))
}

/// Whether two edges run in opposite directions and an end of one is near the other.
fn is_facing(one: Segment, other: Segment) -> bool {
    let ends = [(one, other.start), (one, other.end), (other, one.start), (other, one.end)];
    one.direction().dot(other.direction()) < 0.0
        && ends.into_iter().any(|(edge, end)| edge.distance(end) < NEEDLE_WIDTH)
}
