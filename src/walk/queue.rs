//! Cells that wait to be looked at: the cheapest first, of equals the first in the grid.
//!
//! R. Dial, "Algorithm 360: Shortest-path forest with topological ordering", 1969: a list for each cost, as no step
//! costs more than a few dozen. The cells of the cost at hand are bits, in a tree of words that each say which words
//! below them are not empty.

/// Bits of a word.
const BITS: usize = 64;

/// A queue of cells by cost. What is put in never costs less than what came out last.
pub(super) struct CellQueue {
    /// The cells of the cost at hand; the last layer is one word.
    layers: Vec<Vec<u64>>,
    /// The cost at hand.
    cost: u32,
    /// Cells of higher costs, each list by its cost modulo the number of lists.
    later: Vec<Vec<u32>>,
    /// How many cells are in the lists.
    later_count: usize,
}

impl CellQueue {
    /// For cells below `cell_count`, where no step costs more than `dearest`.
    pub(super) fn new(cell_count: usize, dearest: u16) -> Self {
        let mut layers = Vec::new();
        let mut length = cell_count.max(1);
        while layers.is_empty() || length > 1 {
            length = length.div_ceil(BITS);
            layers.push(vec![0; length]);
        }
        let later = vec![Vec::new(); usize::from(dearest) + 1];
        Self { layers, cost: 0, later, later_count: 0 }
    }

    pub(super) fn push(&mut self, cost: u32, cell: usize) {
        debug_assert!(
            cost >= self.cost && ((cost - self.cost) as usize) < self.later.len(),
            "costs only rise"
        );
        if cost == self.cost {
            self.insert(cell);
        } else {
            // Costs that wait at the same time differ by less than the number of lists: no two of them share one.
            let list = cost as usize % self.later.len();
            self.later[list].push(u32::try_from(cell).expect("floors have fewer than 2^32 cells"));
            self.later_count += 1;
        }
    }

    /// The cheapest cell with the cost that it was put in with, if that is `most` at most; each time it was put in, unless
    /// twice at one cost.
    pub(super) fn pop_up_to(&mut self, most: u32) -> Option<(u32, usize)> {
        loop {
            if let Some(cell) = self.take_first() {
                return Some((self.cost, cell));
            }
            if self.later_count == 0 || self.cost >= most {
                return None;
            }
            self.cost += 1;
            let list = self.cost as usize % self.later.len();
            let cells = core::mem::take(&mut self.later[list]);
            self.later_count -= cells.len();
            cells.iter().for_each(|&cell| self.insert(cell as usize));
        }
    }

    /// Whether no cell waits.
    pub(super) fn is_empty(&self) -> bool {
        self.later_count == 0 && self.layers.last().is_none_or(|root| root[0] == 0)
    }

    fn insert(&mut self, cell: usize) {
        let mut index = cell;
        for layer in &mut self.layers {
            let word = &mut layer[index / BITS];
            let was_empty = *word == 0;
            *word |= 1 << (index % BITS);
            if !was_empty {
                return;
            }
            index /= BITS;
        }
    }

    fn take_first(&mut self) -> Option<usize> {
        let top = self.layers.last().expect("a tree has a root")[0];
        if top == 0 {
            return None;
        }
        let below = |index: usize, layer: &Vec<u64>| index * BITS + layer[index].trailing_zeros() as usize;
        let cell = self.layers.iter().rev().fold(0, below);
        let mut index = cell;
        for layer in &mut self.layers {
            let word = &mut layer[index / BITS];
            *word &= *word - 1;
            if *word != 0 {
                break;
            }
            index /= BITS;
        }
        Some(cell)
    }
}

#[cfg(test)]
mod tests {
    use core::cmp::Reverse;
    use std::collections::BinaryHeap;

    use super::*;

    #[test]
    fn cells_come_as_from_a_heap_of_costs_and_cells() {
        for (cell_count, dearest) in [(1, 0), (64, 3), (65, 3), (5000, 18), (300_000, 75)] {
            compare_with_heap(cell_count, dearest);
        }
    }

    fn compare_with_heap(cell_count: usize, dearest: u16) {
        let (mut queue, mut heap) = (CellQueue::new(cell_count, dearest), BinaryHeap::new());
        let mut draw = 1_u64;
        let mut next = |most: u64| {
            draw = draw.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (draw >> 33) % most
        };
        let mut known = 0;
        let mut waiting = std::collections::BTreeSet::new();
        for _ in 0..2000 {
            let cost = known + next(u64::from(dearest) + 1) as u32;
            let cell = next(cell_count as u64) as usize;
            if waiting.insert((cost, cell)) {
                queue.push(cost, cell);
                heap.push(Reverse((cost, cell)));
            }
            if next(3) == 0 {
                let popped = queue.pop_up_to(u32::MAX);
                assert_eq!(popped, heap.pop().map(|Reverse(first)| first));
                popped.iter().for_each(|first| _ = waiting.remove(first));
                known = popped.map_or(known, |(cost, _)| cost);
            }
        }
        while let Some(Reverse(first)) = heap.pop() {
            assert_eq!(queue.pop_up_to(u32::MAX), Some(first));
        }
        assert_eq!(queue.pop_up_to(u32::MAX), None);
    }

    #[test]
    fn what_costs_more_waits() {
        let mut queue = CellQueue::new(100, 10);
        queue.push(3, 7);
        queue.push(5, 2);
        assert_eq!((queue.pop_up_to(2), queue.pop_up_to(4)), (None, Some((3, 7))));
        queue.push(4, 9);
        assert_eq!((queue.pop_up_to(4), queue.pop_up_to(4), queue.is_empty()), (Some((4, 9)), None, false));
        assert_eq!((queue.pop_up_to(5), queue.pop_up_to(9), queue.is_empty()), (Some((5, 2)), None, true));
    }
}
