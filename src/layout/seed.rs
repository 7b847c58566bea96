//! Seeds: one key per room, one random stream per purpose within it.
//!
//! The paper (section 4.1) computes a room's seed "based on its position and number"; here the global seed,
//! the building and the level join in, so that no two rooms of a city share one.

use crate::geometry::Bounds;
use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};

use crate::plan::RoomRef;

/// Steps per metre to which a room's position is rounded before hashing: a millimetre.
const POSITION_STEPS: f64 = 1000.0;

/// The key of a room's random streams.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoomKey([u8; 32]);

impl RoomKey {
    /// SHA-256 over global seed, building, level, room number and position, each with its length or in a
    /// fixed width, so that no two inputs spell the same bytes.
    pub(crate) fn new(seed: u64, building: &str, at: RoomRef<'_>) -> Self {
        let RoomRef { level, room, .. } = at;
        let Bounds { low, .. } = room.region.outline.bounds();
        let mut hash = Sha256::new();
        hash.update(seed.to_le_bytes());
        for text in [building, level.id.as_str()] {
            // With its length: "a" and "bc" are not "ab" and "c".
            hash.update((text.len() as u64).to_le_bytes());
            hash.update(text.as_bytes());
        }
        hash.update(room.number.to_le_bytes());
        hash.update(((low.x * POSITION_STEPS).round() as i64).to_le_bytes());
        hash.update(((low.y * POSITION_STEPS).round() as i64).to_le_bytes());
        Self(hash.finalize().into())
    }

    /// The key of a further attempt at the same room; attempt 0 is the key itself.
    pub(crate) fn attempt(&self, number: u32) -> Self {
        if number == 0 {
            // A room that comes out well at once has the streams of its own key, however many attempts are allowed.
            return *self;
        }
        Self(Sha256::new_with_prefix(self.0).chain_update(number.to_le_bytes()).finalize().into())
    }

    /// The first eight bytes, as shown to people.
    pub(crate) fn seed(&self) -> u64 {
        u64::from_le_bytes(self.0[..8].try_into().expect("a key has 32 bytes"))
    }

    /// The stream of a purpose. `name` and `number` say which (a class and its number), so that one more
    /// lamp does not move the bed.
    pub(crate) fn stream(&self, purpose: Purpose, name: &str, number: u32) -> Stream {
        // The number is the nonce of the cipher: streams of one key have nothing in common (D. J. Bernstein, "ChaCha", 2008).
        let mut generator = ChaCha8Rng::from_seed(self.0);
        generator.set_stream(stream_number(purpose, name, number));
        Stream(generator)
    }
}

/// The stream of a purpose for a whole building, before it has rooms.
pub(crate) fn building_stream(seed: u64, building: &str, purpose: &str) -> Stream {
    let mut hash = Sha256::new();
    hash.update(seed.to_le_bytes());
    for text in ["building", building, purpose] {
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text.as_bytes());
    }
    Stream(ChaCha8Rng::from_seed(hash.finalize().into()))
}

/// The purpose of a random stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// Which classes and how many.
    Programme,
    /// Which variant an agent is.
    Variant,
    /// Where an agent goes.
    Placement,
    /// How far an object is off its place.
    Untidiness,
    /// Which of several parents that are nearly as good an agent takes.
    Taste,
}

/// FNV-1a, 64 bit (Fowler, Noll, Vo): fixed for all time, unlike the standard library's hasher.
fn stream_number(purpose: Purpose, name: &str, number: u32) -> u64 {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    // The number is last and of fixed width, so that no name and number spell the bytes of others.
    let bytes = [purpose as u8].into_iter().chain(name.bytes()).chain(number.to_le_bytes());
    bytes.fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}

/// A stream of random numbers. Draws 32 bits at a time: `usize` differs between machines.
#[derive(Debug)]
pub(crate) struct Stream(ChaCha8Rng);

impl Stream {
    /// Even in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / 4_294_967_296.0
    }

    /// Even in [low, high).
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Even in [-1, 1).
    pub(crate) fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Even in 0..count; `count` above zero.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        // Counts are far below 2^32: the bias of multiplying is far below what anybody could measure.
        ((self.unit() * count as f64) as usize).min(count - 1)
    }

    /// Even in low..=high.
    pub(crate) fn count(&mut self, low: u32, high: u32) -> u32 {
        let span = high.saturating_sub(low) as usize + 1;
        low + u32::try_from(self.below(span)).expect("below a 32-bit span")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_differ_by_purpose_name_and_number() {
        let key = RoomKey([7; 32]);
        let first = |purpose, name, number| key.stream(purpose, name, number).unit();
        let base = first(Purpose::Placement, "bed", 1);
        assert_eq!(base, first(Purpose::Placement, "bed", 1));
        assert_ne!(base, first(Purpose::Placement, "bed", 2));
        assert_ne!(base, first(Purpose::Placement, "lamp", 1));
        assert_ne!(base, first(Purpose::Variant, "bed", 1));
    }

    #[test]
    fn draws_stay_in_range_and_reach_both_ends() {
        let mut stream = RoomKey([1; 32]).stream(Purpose::Programme, "", 0);
        let counts: Vec<u32> = (0..200).map(|_| stream.count(2, 4)).collect();
        assert!(counts.iter().all(|count| (2..=4).contains(count)));
        assert!((2..=4).all(|wanted| counts.contains(&wanted)));
    }
}
