//! The parts of a model with fewer triangles.

use glam::DVec3;

use super::simplify::simplified;
use super::solid::Solid;

/// How far surfaces may move, as shares of the model's diagonal, one after the other until it is coarse enough: the last is
/// what one no longer sees from across a room.
pub(crate) const TOLERANCES: [f64; 4] = [0.004, 0.01, 0.02, 0.04];

/// Metres from a side of the box at which a part reaches it.
const REACH: f64 = 0.001;

/// Triangles below which a part is rather left out: what has fewer than a box is a splinter.
const FEWEST: usize = 12;

/// Simplifies parts until they have at most `target` triangles together: first by collapsing their edges, then by leaving
/// out the smallest parts. The largest one always stays.
pub(super) fn reduced(parts: Vec<Solid>, diagonal: f64, target: usize) -> Vec<Option<Solid>> {
    let mut parts = parts;
    for tolerance in TOLERANCES {
        let count = triangle_count(&parts);
        if count <= target {
            break;
        }
        let share = target as f64 / count as f64;
        for part in &mut parts {
            let own_target = (part.triangles.len() as f64 * share) as usize;
            *part = simplified(part, own_target.max(FEWEST), tolerance * diagonal);
        }
    }
    without_smallest(parts, target)
}

fn triangle_count(parts: &[Solid]) -> usize {
    parts.iter().map(|part| part.triangles.len()).sum()
}

/// Leaves out parts from the smallest on until no more than `target` triangles are left. The largest stays, and so do those
/// that reach the sides of the box, without which the model would not fill it.
fn without_smallest(parts: Vec<Solid>, target: usize) -> Vec<Option<Solid>> {
    let mut count = triangle_count(&parts);
    let mut by_extent: Vec<usize> = (0..parts.len()).collect();
    let bounds: Vec<(DVec3, DVec3)> = parts.iter().map(Solid::bounds).collect();
    let extent = |part: usize| (bounds[part].1 - bounds[part].0).length();
    // Stable: of equal parts the later one goes first.
    by_extent.sort_by(|&a, &b| extent(b).total_cmp(&extent(a)));
    let is_needed = reaching_sides(&bounds, &by_extent);
    let mut parts: Vec<Option<Solid>> = parts.into_iter().map(Some).collect();
    for &index in by_extent.iter().skip(1).rev().filter(|&&index| !is_needed[index]) {
        if count <= target {
            break;
        }
        count -= parts[index].take().map_or(0, |part| part.triangles.len());
    }
    parts
}

/// For each part, given by its bounds, whether it is the first in an order that reaches one of the six sides of the box around
/// all.
fn reaching_sides(bounds: &[(DVec3, DVec3)], order: &[usize]) -> Vec<bool> {
    let low = bounds.iter().fold(DVec3::INFINITY, |least, part| least.min(part.0));
    let high = bounds.iter().fold(DVec3::NEG_INFINITY, |most, part| most.max(part.1));
    let mut is_needed = vec![false; bounds.len()];
    for axis in 0..3 {
        let reaches_low = |part: &&usize| bounds[**part].0[axis] <= low[axis] + REACH;
        let reaches_high = |part: &&usize| bounds[**part].1[axis] >= high[axis] - REACH;
        let first = [order.iter().find(reaches_low), order.iter().find(reaches_high)];
        first.into_iter().flatten().for_each(|&part| is_needed[part] = true);
    }
    is_needed
}

#[cfg(test)]
mod tests {
    use super::super::{Bay, cuboid, rounded_box};
    use super::*;

    /// A board with knobs on it, each smaller than the one before.
    fn parts() -> Vec<Solid> {
        let knob = |index: u32| {
            let size = 0.02 / f64::from(index + 1);
            let at = 0.1 * f64::from(index);
            rounded_box(
                Bay::new([at, at + size], [0.5, 0.5 + size], [0.0, size]),
                DVec3::splat(size / 4.0),
                2,
            )
        };
        let board = cuboid(Bay::new([0.0, 1.0], [0.0, 0.5], [0.0, 0.02]));
        std::iter::once(board).chain((0..4).map(knob)).collect()
    }

    #[test]
    fn what_is_coarse_enough_stays_as_it_is() {
        let count = triangle_count(&parts());
        let same: Vec<Option<Solid>> = parts().into_iter().map(Some).collect();
        assert_eq!(reduced(parts(), 1.1, count), same);
    }

    #[test]
    fn roundings_go_before_parts_and_small_parts_before_large_ones() {
        let rounded = reduced(parts(), 1.1, 60);
        assert!(rounded.iter().all(Option::is_some));
        let fewer = reduced(parts(), 1.1, 30);
        let is_there: Vec<bool> = fewer.iter().map(Option::is_some).collect();
        assert!(is_there[0] && is_there[1] && !is_there[4], "{is_there:?}");
        let least = reduced(parts(), 1.1, 0);
        let is_there: Vec<bool> = least.iter().map(Option::is_some).collect();
        assert_eq!(is_there, [true, true, false, false, false], "the largest, and what reaches highest");
    }
}
