//! Finds free ids and numbers without walking along all that are taken.

use std::collections::{BTreeMap, BTreeSet};

/// Numbers that no room has yet.
pub(super) struct FreeNumbers {
    taken: BTreeSet<u32>,
    /// From where on to look, by the number that was asked for: long rows of taken numbers are walked along once.
    next: BTreeMap<u32, u32>,
}

impl FreeNumbers {
    /// All but some.
    pub(super) fn beside(taken: BTreeSet<u32>) -> Self {
        Self { taken, next: BTreeMap::new() }
    }

    /// The first free number from one on, which is free no longer.
    pub(super) fn take(&mut self, wanted: u32) -> u32 {
        let mut passed = Vec::new();
        let mut number = wanted;
        while !self.taken.insert(number) {
            passed.push(number);
            number = self.next.get(&number).copied().unwrap_or(number.wrapping_add(1));
        }
        self.next.extend(passed.into_iter().map(|place| (place, number.wrapping_add(1))));
        number
    }
}

/// Ids of a level's openings.
#[derive(Default)]
pub(super) struct OpeningIds {
    taken: BTreeSet<String>,
    /// The copy from which on one may be free, by id.
    next: BTreeMap<String, usize>,
}

impl OpeningIds {
    /// Takes an id as it is. Whether it was free.
    pub(super) fn claim(&mut self, id: &str) -> bool {
        self.taken.insert(id.to_owned())
    }

    /// The id with the first number from 2 that is free; it is taken at once.
    pub(super) fn copy_of(&mut self, base: &str) -> String {
        let mut copy = self.next.get(base).copied().unwrap_or(2);
        loop {
            let id = format!("{base}:{copy}");
            copy += 1;
            if self.taken.insert(id.clone()) {
                self.next.insert(base.to_owned(), copy);
                return id;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_free_number_is_taken() {
        let mut free = FreeNumbers::beside([1, 2, 5].into());
        assert_eq!([1, 1, 2, 5, 1].map(|wanted| free.take(wanted)), [3, 4, 6, 7, 8]);
        let mut last = FreeNumbers::beside([u32::MAX].into());
        assert_eq!(last.take(u32::MAX), 0);
    }

    #[test]
    fn copies_count_from_two_past_those_that_are_taken() {
        let mut ids = OpeningIds::default();
        assert!(ids.claim("w") && ids.claim("w:3") && !ids.claim("w"));
        assert_eq!([(); 2].map(|()| ids.copy_of("w")), ["w:2", "w:4"]);
    }
}
