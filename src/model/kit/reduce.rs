//! The parts of a model with fewer triangles.

use super::simplify::simplified;
use super::solid::Solid;

/// How far surfaces may move, as shares of the model's diagonal, one after the other until it is coarse enough: the last is
/// what one no longer sees from across a room.
pub(crate) const TOLERANCES: [f64; 4] = [0.004, 0.01, 0.02, 0.04];

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

fn without_smallest(parts: Vec<Solid>, target: usize) -> Vec<Option<Solid>> {
    let mut count = triangle_count(&parts);
    let mut by_extent: Vec<usize> = (0..parts.len()).collect();
    let extent = |part: &Solid| {
        let (low, high) = part.bounds();
        (high - low).length()
    };
    // Stable: of equal parts the later one goes first.
    by_extent.sort_by(|&a, &b| extent(&parts[b]).total_cmp(&extent(&parts[a])));
    let mut parts: Vec<Option<Solid>> = parts.into_iter().map(Some).collect();
    for &index in by_extent.iter().skip(1).rev() {
        if count <= target {
            break;
        }
        count -= parts[index].take().map_or(0, |part| part.triangles.len());
    }
    parts
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

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
        assert_eq!(reduced(parts(), 1.1, 0).iter().flatten().count(), 1);
    }
}
