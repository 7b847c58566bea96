//! The rooms that a world holds, those that it wants, and which of them is made next.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::graph::Key;
use super::room::WorldRoom;
use super::wish::Wanted;

/// How much a world may hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Rooms at most.
    pub rooms: usize,
    /// Bytes of furnished rooms at most ([`WorldRoom::bytes`]).
    pub bytes: usize,
}

impl Default for Budget {
    /// Some floors of a hotel.
    fn default() -> Self {
        Self { rooms: 512, bytes: 64 << 20 }
    }
}

/// A room that is held.
struct Kept {
    room: Arc<WorldRoom>,
    /// The look that wanted it last.
    wanted_at: u64,
    /// Whether the inputs have changed since: it is shown until it is made again.
    is_stale: bool,
}

/// Bytes of a room that is not made yet, to begin with.
const USUAL_BYTES: usize = 8 << 10;

/// The rooms that a world holds and wants.
#[derive(Default)]
pub(crate) struct Store {
    kept: BTreeMap<Key, Kept>,
    bytes: usize,
    wanted: Vec<Wanted>,
    rank: BTreeMap<Key, usize>,
    /// Bytes of wanted rooms that were made and had no place, so that they are not made again and again.
    sizes: BTreeMap<Key, usize>,
    making: BTreeSet<Key>,
    /// Rooms that cannot be made, for a fault of the program.
    broken: BTreeMap<Key, String>,
    budget: Budget,
    looks: u64,
    made: u64,
    /// Counts changes of the inputs: what was begun before one is not kept.
    pub(crate) generation: u64,
    /// Whether nothing more is to be made.
    pub(crate) is_closing: bool,
}

impl Store {
    /// Wants these rooms, the most urgent first, and forgets what is over the budget.
    pub(crate) fn want(&mut self, wanted: Vec<Wanted>, budget: Budget) {
        self.looks += 1;
        self.budget = budget;
        self.rank = wanted.iter().enumerate().map(|(rank, wanted)| (wanted.key, rank)).collect();
        self.sizes.retain(|key, _| self.rank.contains_key(key));
        for wanted in &wanted {
            if let Some(kept) = self.kept.get_mut(&wanted.key) {
                kept.wanted_at = self.looks;
            }
        }
        self.wanted = wanted;
        self.forget();
    }

    /// The rooms that are wanted.
    pub(crate) fn wanted(&self) -> &[Wanted] {
        &self.wanted
    }

    /// A room as it is now.
    pub(crate) fn ready(&self, key: Key) -> Option<&Arc<WorldRoom>> {
        self.kept.get(&key).filter(|kept| !kept.is_stale).map(|kept| &kept.room)
    }

    /// A room as it is, or as it was before the last change.
    pub(crate) fn shown(&self, key: Key) -> Option<&Arc<WorldRoom>> {
        self.kept.get(&key).map(|kept| &kept.room)
    }

    /// Whether a room is held, as it is or as it was.
    pub(crate) fn holds(&self, key: Key) -> bool {
        self.kept.contains_key(&key)
    }

    /// All rooms that are held.
    pub(crate) fn keys(&self) -> impl Iterator<Item = Key> + '_ {
        self.kept.keys().copied()
    }

    /// Bytes of the rooms that are held.
    pub(crate) fn bytes(&self) -> usize {
        self.bytes
    }

    /// Rooms that were made so far.
    pub(crate) fn made(&self) -> u64 {
        self.made
    }

    /// Whether a room is being made.
    pub(crate) fn is_being_made(&self, key: Key) -> bool {
        self.making.contains(&key)
    }

    /// What is wrong with a room that cannot be made.
    pub(crate) fn fault(&self, key: Key) -> Option<&String> {
        self.broken.get(&key)
    }

    /// Rooms that are wanted, fit into the budget and are not there.
    pub(crate) fn waiting(&self) -> usize {
        self.fitting().filter(|wanted| !self.is_settled(wanted.key)).count()
    }

    /// The most urgent room that nobody makes; whoever takes it has to [`Store::keep`] it.
    pub(crate) fn take(&mut self) -> Option<Key> {
        if self.is_closing {
            return None;
        }
        let key = self.next()?;
        self.making.insert(key);
        Some(key)
    }

    /// Takes a certain room.
    pub(crate) fn begin(&mut self, key: Key) {
        self.making.insert(key);
    }

    /// Holds a room that was taken in a generation; gives it its number.
    pub(crate) fn keep(
        &mut self,
        key: Key,
        generation: u64,
        made: Result<WorldRoom, String>,
    ) -> Option<Arc<WorldRoom>> {
        if generation != self.generation {
            return None;
        }
        self.making.remove(&key);
        let room = match made {
            Ok(room) => room,
            Err(fault) => {
                self.broken.insert(key, fault);
                return None;
            }
        };
        self.made += 1;
        let room = Arc::new(room.numbered(self.made));
        self.bytes += room.bytes();
        let wanted_at = if self.rank.contains_key(&key) { self.looks } else { 0 };
        let before = self.kept.insert(key, Kept { room: Arc::clone(&room), wanted_at, is_stale: false });
        self.bytes -= before.map_or(0, |kept| kept.room.bytes());
        self.forget();
        Some(room)
    }

    /// The inputs have changed: rooms for which `renewed` gives a key stay under it, as they are or stale; others go.
    pub(crate) fn change(&mut self, renewed: impl Fn(&WorldRoom) -> Option<(Key, bool)>) {
        self.generation += 1;
        self.making.clear();
        self.broken.clear();
        self.wanted.clear();
        self.rank.clear();
        self.sizes.clear();
        let kept = std::mem::take(&mut self.kept).into_values();
        let kept = kept.filter_map(|kept| {
            let (key, is_equal) = renewed(&kept.room)?;
            Some((key, Kept { is_stale: kept.is_stale || !is_equal, ..kept }))
        });
        self.kept = kept.collect();
        self.bytes = self.kept.values().map(|kept| kept.room.bytes()).sum();
    }

    /// Whether all that is waited for is being made.
    pub(crate) fn is_idle(&self) -> bool {
        self.next().is_none()
    }

    /// The most urgent room that is neither there nor being made.
    fn next(&self) -> Option<Key> {
        let is_free = |key: &Key| !self.is_settled(*key) && !self.making.contains(key);
        self.fitting().map(|wanted| wanted.key).find(is_free)
    }

    fn is_settled(&self, key: Key) -> bool {
        self.broken.contains_key(&key) || self.kept.get(&key).is_some_and(|kept| !kept.is_stale)
    }

    /// The most urgent rooms, as many as the budget holds; one at least.
    fn fitting(&self) -> impl Iterator<Item = &Wanted> + '_ {
        let usual = self.bytes.checked_div(self.kept.len()).unwrap_or(USUAL_BYTES);
        let mut bytes = 0_usize;
        self.wanted.iter().take(self.budget.rooms.max(1)).take_while(move |wanted| {
            let is_first = bytes == 0;
            let known = self.sizes.get(&wanted.key).copied().unwrap_or(usual);
            bytes += self.kept.get(&wanted.key).map_or(known, |kept| kept.room.bytes());
            is_first || bytes <= self.budget.bytes
        })
    }

    /// Lets go of rooms over the budget: those that were wanted longest ago, then the least urgent.
    fn forget(&mut self) {
        while self.kept.len() > 1 && (self.kept.len() > self.budget.rooms || self.bytes > self.budget.bytes) {
            let worst = self.kept.iter().max_by_key(|(key, kept)| {
                let rank = self.rank.get(key).copied();
                (rank.is_none(), u64::MAX - kept.wanted_at, rank)
            });
            let Some(key) = worst.map(|(key, _)| *key) else { return };
            if let Some(kept) = self.kept.remove(&key) {
                self.bytes -= kept.room.bytes();
                if self.rank.contains_key(&key) {
                    self.sizes.insert(key, kept.room.bytes());
                }
            }
        }
    }
}
