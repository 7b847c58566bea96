//! The random stream of one look of one recipe.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};

/// Draws proportions and counts; the same recipe and look draw the same, whatever the size or the class.
#[derive(Debug)]
pub(crate) struct Sampler {
    stream: ChaCha8Rng,
}

impl Sampler {
    /// The stream of a look.
    pub(crate) fn new(recipe: &str, look: u32) -> Self {
        let mut hash = Sha256::new();
        hash.update(b"roomwright model ");
        hash.update(recipe.as_bytes());
        hash.update([0]);
        hash.update(look.to_le_bytes());
        Self { stream: ChaCha8Rng::from_seed(hash.finalize().into()) }
    }

    /// A number from `low` to `high`.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.stream.next_u32()) / f64::from(u32::MAX)
    }

    /// A whole number from `low` to `high`, both included.
    pub(crate) fn count(&mut self, low: u32, high: u32) -> u32 {
        let choices = u64::from(high.saturating_sub(low)) + 1;
        // The upper bits of a product instead of a remainder: no choice is more likely than another by over 2⁻³².
        low + ((u64::from(self.stream.next_u32()) * choices) >> 32) as u32
    }

    /// One of a list, which is not empty.
    pub(crate) fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        let last = u32::try_from(choices.len() - 1).unwrap_or(u32::MAX);
        choices[self.count(0, last) as usize]
    }

    /// True with a probability.
    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_and_recipes_draw_differently_and_repeatably() {
        let draw = |recipe, look| Sampler::new(recipe, look).between(0.0, 1.0);
        assert_eq!(draw("chair", 0), draw("chair", 0));
        assert_ne!(draw("chair", 0), draw("chair", 1));
        assert_ne!(draw("chair", 0), draw("table", 0));
    }

    #[test]
    fn counts_reach_both_ends_and_nothing_else() {
        let mut sampler = Sampler::new("test", 0);
        let drawn: std::collections::BTreeSet<u32> = (0..200).map(|_| sampler.count(2, 5)).collect();
        assert_eq!(drawn.into_iter().collect::<Vec<_>>(), [2, 3, 4, 5]);
        assert_eq!(sampler.count(3, 3), 3);
    }
}
