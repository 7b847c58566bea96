//! Which variant each piece of a room is: what is furnished together looks alike.
//!
//! Departs from the paper, where every agent draws its own (section 3.4): the chairs of a table are of one kind, and so are
//! the beds of a hotel, and bookcases differ in their books alone. Classes of full variety, such as plants and books, differ
//! from each other in a room, but a level has few kinds of them.

use crate::catalog::{Class, KINDS, SHAPES, Variety};

use super::choice::Series;
use super::seed::{Purpose, RoomKey};

/// Draws the variants of the pieces of a room.
pub(crate) struct Variants<'a> {
    /// The seed of the run, or the one that the room is pinned to.
    pub(crate) seed: u64,
    /// The rooms that look like it.
    pub(crate) series: Series<'a>,
    /// The room's own.
    pub(crate) key: &'a RoomKey,
}

impl Variants<'_> {
    /// The variant of the piece of this number: in one of the sizes that rooms ask for.
    pub(crate) fn draw(&self, class: &Class, number: u32) -> u32 {
        let of_room = || self.key.stream(Purpose::Variant, &class.id, 0);
        let size = || of_room().below(class.usual_sizes) as u32;
        match class.variety {
            Variety::None => size() * class.looks + self.shared(class, class.looks),
            Variety::Details => {
                let shape = self.shared(class, SHAPES.min(class.looks));
                // Looks with equal numbers modulo SHAPES have one shape: the room draws the shape, each piece its contents.
                let fillings = (class.looks - shape).div_ceil(SHAPES);
                let mut own = self.key.stream(Purpose::Variant, &class.id, number);
                size() * class.looks + shape + SHAPES * own.count(0, fillings - 1)
            }
            Variety::Full => {
                let kinds = KINDS.min(class.usual_variant_count());
                // One after the other, so that neighbours differ.
                self.kind(class, (of_room().below(kinds as usize) as u32 + number) % kinds, kinds)
            }
        }
    }

    /// One of `count`, the same for all that are furnished together.
    fn shared(&self, class: &Class, count: u32) -> u32 {
        (self.series.look(class, self.seed) * f64::from(count)) as u32
    }

    /// The variant of a kind of the level: each kind draws from a part of them of its own.
    fn kind(&self, class: &Class, kind: u32, kinds: u32) -> u32 {
        let count = class.usual_variant_count();
        // No two kinds share a part, so that no two of them can come out alike.
        let (from, to) = (kind * count / kinds, (kind + 1) * count / kinds);
        from + (self.series.kind(class, kind, self.seed) * f64::from(to - from)) as u32
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::catalog::{Share, Size};
    use crate::layout::FurnishOptions;
    use crate::layout::tests::level;
    use crate::recipes::find;

    fn class(variety: Variety) -> Class {
        let size = |width| Size { width, depth: 0.5, height: 0.5 };
        let mut class = Class::plain("chair", vec![size(0.4), size(0.5), size(0.6)], find("chair").unwrap());
        (class.looks, class.usual_sizes, class.variety) = (4, 2, variety);
        class
    }

    /// The variants of so many chairs in a room of this number in a flat.
    fn variants(class: &Class, seed: u64, flat: &str, room: u32) -> Vec<u32> {
        let mut level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        level.rooms[0].number = room;
        let key = RoomKey::new(seed, "block", level.room(0));
        level.rooms[0].dwelling = Some(flat.to_owned());
        let options = FurnishOptions::new(seed, "block");
        let series = Series { at: level.room(0), options: &options, share: Share::Dwelling };
        (1..=12).map(|number| Variants { seed, series, key: &key }.draw(class, number)).collect()
    }

    #[test]
    fn chairs_of_a_room_are_alike_and_those_of_a_flat_of_one_look() {
        let class = class(Variety::None);
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
        let class = class(Variety::None);
        let look = |seed, flat: u32| variants(&class, seed, &flat.to_string(), 0)[0] % class.looks;
        assert_eq!((0..40).map(|flat| look(1, flat)).collect::<BTreeSet<_>>().len(), 4);
        assert_eq!((0..40).map(|seed| look(seed, 1)).collect::<BTreeSet<_>>().len(), 4);
    }

    #[test]
    fn what_varies_in_details_is_of_one_shape_and_size_and_filled_in_all_ways() {
        let mut class = class(Variety::Details);
        for (looks, fillings) in [(12, [3, 3, 3, 3]), (6, [2, 2, 1, 1])] {
            class.looks = looks;
            let mut shapes = BTreeSet::new();
            for flat in 0..30 {
                let drawn: BTreeSet<u32> = variants(&class, 1, &flat.to_string(), 0).into_iter().collect();
                let sizes: BTreeSet<u32> = drawn.iter().map(|variant| variant / looks).collect();
                let of_flat: BTreeSet<u32> = drawn.iter().map(|variant| variant % looks % SHAPES).collect();
                assert_eq!((sizes.len(), of_flat.len()), (1, 1), "{drawn:?}");
                let shape = *of_flat.first().unwrap();
                assert!(drawn.len() <= fillings[shape as usize], "{drawn:?}");
                shapes.insert((shape, drawn.len()));
            }
            let all = fillings.iter().enumerate().map(|(shape, &count)| (shape as u32, count));
            assert!(all.into_iter().all(|filled| shapes.contains(&filled)), "{shapes:?}");
        }
    }

    #[test]
    fn varied_pieces_differ_within_a_room() {
        let class = class(Variety::Full);
        let mut all = BTreeSet::new();
        for seed in 0..20 {
            let rooms: Vec<Vec<u32>> = (0..6).map(|room| variants(&class, seed, "a", room)).collect();
            for room in &rooms {
                let differ = |pair: &[u32]| pair.iter().collect::<BTreeSet<_>>().len() == pair.len();
                assert!(room.windows(KINDS as usize).all(differ), "{room:?}");
            }
            let of_level: BTreeSet<u32> = rooms.into_iter().flatten().collect();
            assert_eq!(of_level.len(), KINDS as usize, "the rooms of a level have the same kinds");
            all.extend(of_level);
        }
        assert_eq!(all, (0..8).collect(), "every look in usual sizes, and no spare one");
    }

    #[test]
    fn what_comes_with_the_building_is_alike_in_all_flats() {
        let looks = |class: &Class| -> BTreeSet<u32> {
            let rooms = ["a", "b", "c", "d", "e", "f"].map(|flat| variants(class, 1, flat, 0));
            rooms.into_iter().flatten().map(|variant| variant % class.looks).collect()
        };
        let chair = class(Variety::None);
        assert!(looks(&chair).len() > 1);
        assert_eq!(looks(&Class { share: Some(Share::Building), ..chair }).len(), 1);
    }
}
