//! Free stretches of a line, such as a wall between its doors or the side of a table between its chairs.

/// Sorted, disjoint intervals in metres along a line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Intervals(Vec<(f64, f64)>);

impl Intervals {
    /// One interval, or none if `from >= to`.
    #[must_use]
    pub fn new(from: f64, to: f64) -> Self {
        Self(if from < to { vec![(from, to)] } else { Vec::new() })
    }

    /// Cuts a stretch out.
    pub fn subtract(&mut self, from: f64, to: f64) {
        if from >= to {
            return;
        }
        let mut index = 0;
        while index < self.0.len() {
            let (start, end) = self.0[index];
            if to <= start {
                break;
            }
            if from >= end {
                index += 1;
                continue;
            }
            match (from > start, to < end) {
                (true, true) => {
                    self.0[index].1 = from;
                    self.0.insert(index + 1, (to, end));
                    return;
                }
                (true, false) => {
                    self.0[index].1 = from;
                    index += 1;
                }
                (false, true) => {
                    self.0[index].0 = to;
                    return;
                }
                (false, false) => {
                    self.0.remove(index);
                }
            }
        }
    }

    /// Whether nothing is left.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The intervals, from low to high.
    #[must_use]
    pub fn as_slice(&self) -> &[(f64, f64)] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subtracting_splits_trims_and_removes() {
        let mut free = Intervals::new(0.0, 10.0);
        free.subtract(2.0, 3.0);
        free.subtract(-1.0, 0.5);
        free.subtract(9.0, 12.0);
        assert_eq!(free.as_slice(), [(0.5, 2.0), (3.0, 9.0)]);
        free.subtract(1.0, 4.0);
        assert_eq!(free.as_slice(), [(0.5, 1.0), (4.0, 9.0)]);
        free.subtract(0.0, 20.0);
        assert!(free.as_slice().is_empty());
    }

    #[test]
    fn an_empty_stretch_changes_nothing() {
        let mut free = Intervals::new(0.0, 1.0);
        free.subtract(0.5, 0.5);
        assert_eq!(free.as_slice(), [(0.0, 1.0)]);
        assert!(Intervals::new(1.0, 1.0).as_slice().is_empty());
    }
}
