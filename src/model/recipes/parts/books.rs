//! Books on a shelf.

use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Sampler};

/// Materials of the spines, the first the most frequent.
const SPINES: [&str; 5] = ["book", "book", "painted_accent", "leather", "book"];
/// Metres of air between neighbouring books, so that their covers do not share a plane.
const AIR: f64 = 0.0015;

/// Stands books on the floor of a bay from the left, of varied thickness, height and depth, until `share` of its
/// width is taken or `most` stand.
pub(in super::super) fn fill_with_books(
    builder: &mut Builder,
    sampler: &mut Sampler,
    bay: Bay,
    share: f64,
    most: u32,
) {
    let end = bay.low.x + bay.width() * share;
    // Thick enough on average that `most` books fill the share.
    let mean = (bay.width() * share / f64::from(most.max(1))).max(0.028);
    let mut left = bay.low.x + AIR;
    for _ in 0..most {
        let right = left + sampler.between(0.6, 1.4) * mean;
        if right > end {
            return;
        }
        let height = bay.height() * sampler.between(0.62, 0.92);
        let depth = bay.depth() * sampler.between(0.6, 0.85);
        let book = bay.with_x([left, right - AIR]).slab(Side::Below, height).slab(Side::Back, depth);
        builder.cuboid(sampler.pick(&SPINES), book);
        left = right;
    }
}
