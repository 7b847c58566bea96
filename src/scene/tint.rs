//! Chooses the tint of an object among the colours of its slot.

use sha2::{Digest, Sha256};

use crate::contract::ElementId;

/// A draw that picks one of the colours of every slot of an object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Tint(u32);

impl Tint {
    /// The tint of the objects of a class that belong to one parent in a room: the chairs of a table are a set, two
    /// bookcases at different walls are not.
    pub(crate) fn of_set(room_seed: u64, class: &str, parent: &ElementId) -> Self {
        let mut hash = Sha256::new();
        hash.update(room_seed.to_le_bytes());
        hash.update(class.as_bytes());
        hash.update([0]);
        hash.update(parent.to_string());
        let [a, b, c, d, ..]: [u8; 32] = hash.finalize().into();
        Self(u32::from_le_bytes([a, b, c, d]))
    }

    /// The tint of a number: 0 is the palette's own colour of every slot.
    pub(crate) fn of_number(number: u32) -> Self {
        Self(number)
    }

    /// 0 for the palette's own colour, or the number of one of `count` others, all as often.
    pub(crate) fn pick(self, count: usize) -> usize {
        let choices = u32::try_from(count + 1).expect("a palette lists a handful of tints");
        (self.0 % choices) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chairs_of_a_table_share_a_tint_and_those_of_another_do_not() {
        let of_set = |seed, class, parent: &str| Tint::of_set(seed, class, &parent.parse().unwrap());
        let tint = |class, parent| of_set(7, class, parent);
        assert_eq!(tint("chair", "table.1"), tint("chair", "table.1"));
        assert_ne!(tint("chair", "table.1"), tint("chair", "table.2"));
        assert_ne!(tint("chair", "table.1"), tint("stool", "table.1"));
        assert_ne!(tint("chair", "table.1"), of_set(8, "chair", "table.1"));
    }

    #[test]
    fn every_colour_is_drawn_about_as_often() {
        let mut counts = [0; 3];
        for seed in 0..300 {
            counts[Tint::of_set(seed, "sofa", &ElementId::Wall(1)).pick(2)] += 1;
        }
        assert!(counts.iter().all(|&count| count > 70), "{counts:?}");
        assert_eq!(Tint::of_set(3, "sofa", &ElementId::Wall(1)).pick(0), 0);
    }
}
