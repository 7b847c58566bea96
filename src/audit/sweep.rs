//! Broad phase: which boxes touch, without asking every pair.

use glam::DVec3;

/// An axis-parallel box: plan metres, elevation above the room's floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    /// Lowest corner.
    pub(crate) low: DVec3,
    /// Highest corner.
    pub(crate) high: DVec3,
}

impl Bounds {
    /// Contains nothing; the neutral value of [`Bounds::union`].
    pub(crate) const EMPTY: Self =
        Self { low: DVec3::splat(f64::INFINITY), high: DVec3::splat(f64::NEG_INFINITY) };

    /// The smallest box around both.
    pub(crate) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Whether they share a point.
    pub(crate) fn touches(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

/// All pairs of boxes that touch, as `(lower index, higher index)`, sorted.
///
/// Sort and sweep along the longer horizontal axis: boxes enter in the order of their low faces and leave
/// when the sweep has passed their high faces. In a room, where bodies are small and spread out, the
/// number of boxes open at a time grows with the room's width only.
pub(crate) fn touching_pairs(boxes: &[Bounds]) -> Vec<(usize, usize)> {
    let extent = boxes.iter().copied().fold(Bounds::EMPTY, Bounds::union);
    let axis = usize::from(extent.high.y - extent.low.y > extent.high.x - extent.low.x);
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a].low[axis].total_cmp(&boxes[b].low[axis]).then(a.cmp(&b)));
    let mut open: Vec<usize> = Vec::new();
    let mut pairs = Vec::new();
    for &entering in &order {
        open.retain(|&other| boxes[other].high[axis] >= boxes[entering].low[axis]);
        let touched = open.iter().filter(|&&other| boxes[other].touches(&boxes[entering]));
        pairs.extend(touched.map(|&other| (other.min(entering), other.max(entering))));
        open.push(entering);
    }
    // The sweep's order depends on coordinates; findings are listed by object.
    pairs.sort_unstable();
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit_box(x: f64, y: f64, z: f64) -> Bounds {
        Bounds { low: DVec3::new(x, y, z), high: DVec3::new(x + 1.0, y + 1.0, z + 1.0) }
    }

    #[test]
    fn touching_boxes_are_pairs_and_stacked_ones_are_not() {
        let boxes = [
            unit_box(0.0, 0.0, 0.0),
            unit_box(5.0, 0.0, 0.0),
            unit_box(0.9, 0.9, 0.9),
            unit_box(0.0, 0.0, 2.0),
        ];
        assert_eq!(touching_pairs(&boxes), [(0, 2)]);
    }

    #[test]
    fn the_sweep_finds_what_asking_every_pair_finds() {
        let scatter = |i: u32, step: u32| f64::from((i * step) % 101) / 10.0;
        for tall in [0.5, 3.0] {
            let boxes: Vec<Bounds> = (0..120)
                .map(|i| unit_box(scatter(i, 37), scatter(i, 53) * tall, scatter(i, 71) / 5.0))
                .collect();
            let every: Vec<(usize, usize)> = (0..boxes.len())
                .flat_map(|a| (a + 1..boxes.len()).map(move |b| (a, b)))
                .filter(|&(a, b)| boxes[a].touches(&boxes[b]))
                .collect();
            assert!(every.len() > 20);
            assert_eq!(touching_pairs(&boxes), every);
        }
    }

    #[test]
    fn no_boxes_no_pairs() {
        assert!(touching_pairs(&[]).is_empty());
    }
}
