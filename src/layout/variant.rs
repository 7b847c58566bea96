//! Which variant each piece of a room is: what is furnished together looks alike.
//!
//! Departs from the paper, where every agent draws its own (section 3.4): the chairs of a table are of one kind, and so are
//! the beds of a hotel. Classes that are `varied`, such as plants and books, do as the paper says.

use crate::catalog::Class;

use super::seed::{Purpose, RoomKey, shared_draw};

/// Draws the variants of the pieces of a room.
pub(crate) struct Variants<'a> {
    /// The seed of the run, or the one that the room is pinned to.
    pub(crate) seed: u64,
    /// What rooms of one look are called.
    pub(crate) series: &'a [String],
    /// The room's own.
    pub(crate) key: &'a RoomKey,
}

impl Variants<'_> {
    /// The variant of the piece of this number: in one of the sizes that rooms ask for.
    pub(crate) fn draw(&self, class: &Class, number: u32) -> u32 {
        if class.is_varied {
            let last = class.usual_variant_count() - 1;
            return self.key.stream(Purpose::Variant, &class.id, number).count(0, last);
        }
        let size = self.key.stream(Purpose::Variant, &class.id, 0).below(class.usual_sizes);
        let names = self.series.iter().map(String::as_str).chain(["look of", &class.id]);
        let look = shared_draw(self.seed, names) * f64::from(class.looks);
        size as u32 * class.looks + look as u32
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::catalog::Size;
    use crate::layout::tests::level;

    fn class(is_varied: bool) -> Class {
        let size = |width| Size { width, depth: 0.5, height: 0.5 };
        let mut class = Class::plain("chair", vec![size(0.4), size(0.5), size(0.6)], "box");
        (class.looks, class.usual_sizes, class.is_varied) = (4, 2, is_varied);
        class
    }

    /// The variants of so many chairs in a room of this number in a flat.
    fn variants(class: &Class, seed: u64, flat: &str, room: u32) -> Vec<u32> {
        let mut level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        level.rooms[0].number = room;
        let key = RoomKey::new(seed, "block", &level, &level.rooms[0]);
        let series = ["block".to_owned(), flat.to_owned()];
        (1..=12).map(|number| Variants { seed, series: &series, key: &key }.draw(class, number)).collect()
    }

    #[test]
    fn chairs_of_a_room_are_alike_and_those_of_a_flat_of_one_look() {
        let class = class(false);
        for flat in ["a", "b", "c"] {
            let rooms: Vec<Vec<u32>> = (0..20).map(|room| variants(&class, 1, flat, room)).collect();
            assert!(rooms.iter().all(|room| room.iter().all(|&variant| variant == room[0])));
            let looks: BTreeSet<u32> = rooms.iter().map(|room| room[0] % class.looks).collect();
            let sizes: BTreeSet<u32> = rooms.iter().map(|room| room[0] / class.looks).collect();
            assert_eq!((looks.len(), sizes.len()), (1, 2), "{flat}: every usual size, and no spare one");
        }
    }

    #[test]
    fn all_looks_are_drawn_by_one_flat_or_another_and_by_one_seed_or_another() {
        let class = class(false);
        let look = |seed, flat: u32| variants(&class, seed, &flat.to_string(), 0)[0] % class.looks;
        assert_eq!((0..40).map(|flat| look(1, flat)).collect::<BTreeSet<_>>().len(), 4);
        assert_eq!((0..40).map(|seed| look(seed, 1)).collect::<BTreeSet<_>>().len(), 4);
    }

    #[test]
    fn varied_pieces_differ_within_a_room() {
        let drawn: BTreeSet<u32> = variants(&class(true), 1, "a", 0).into_iter().collect();
        assert!(drawn.len() > 4, "{drawn:?}");
        assert!(drawn.iter().all(|&variant| variant < 8), "in usual sizes only");
    }
}
