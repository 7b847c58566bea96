//! Disjoint sets: finds which items are connected, directly or through others.

/// Disjoint sets of numbers, each a tree whose root is its smallest (R. Tarjan, "Efficiency of a Good But Not Linear Set
/// Union Algorithm", 1975, without ranks).
#[derive(Clone, Debug)]
pub struct DisjointSets {
    parents: Vec<usize>,
}

impl DisjointSets {
    /// The numbers below `count`, each by itself.
    pub fn new(count: usize) -> Self {
        Self { parents: (0..count).collect() }
    }

    /// The smallest number of the set of a number; the way there is halved for the next who asks.
    pub fn find(&mut self, mut number: usize) -> usize {
        while self.parents[number] != number {
            self.parents[number] = self.parents[self.parents[number]];
            number = self.parents[number];
        }
        number
    }

    /// Makes one set of those of two numbers.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.parents[a.max(b)] = a.min(b);
    }
}
