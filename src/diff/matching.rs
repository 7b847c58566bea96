//! Pairs the objects of a room before with those after.
//!
//! Ids count the objects of a class, so that a removal renumbers the later ones. Objects are therefore paired in this
//! order:
//! 1. the same id, class and place;
//! 2. the same class and place: only the number differs;
//! 3. the same id: the object moved, or is of another class;
//! 4. the same class, the nearest pairs first, at any distance: the object moved and has another number;
//! 5. another class at nearly the same place, on or at the same kind of object: the object was swapped.
//!
//! In rooms with thousands of objects of a class, most of which would be paired with the same few, the last objects of
//! rule 4 are paired in the order of their places in the file ([`super::nearest`]).
//!
//! The remaining objects were added or removed. After a room was furnished anew, pairs by rules 3 and 4 say how much
//! furniture moved, not which chair it was.

use std::collections::BTreeMap;

use glam::DVec3;

use super::nearest::{Rule, pairs};

/// An object to be paired.
#[derive(Clone, Debug)]
pub(super) struct Item<'a> {
    pub(super) id: String,
    pub(super) class: &'a str,
    pub(super) place: DVec3,
    /// The class or kind of room part that it stands on or belongs to.
    pub(super) on: &'a str,
    /// Metres around its place within which another class may take it; zero for never.
    pub(super) reach: f64,
}

/// How far the rules go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rules {
    /// All of them.
    All,
    /// Up to the third: what does not move, as doors.
    Fixed,
}

/// The matched pairs, each side by index.
pub(super) struct Matches {
    /// By old object: the new one.
    pub(super) new_of: Vec<Option<usize>>,
    /// By new object: the old one.
    pub(super) old_of: Vec<Option<usize>>,
}

/// Pairs objects; ids are unique on each side.
pub(super) fn match_up(old: &[Item<'_>], new: &[Item<'_>], same_place: f64, rules: Rules) -> Matches {
    let mut matches = Matches { new_of: vec![None; old.len()], old_of: vec![None; new.len()] };
    let by_id: BTreeMap<&str, usize> =
        new.iter().enumerate().map(|(index, item)| (item.id.as_str(), index)).collect();
    let twin = |item: &Item<'_>| by_id.get(item.id.as_str()).copied();
    for (index, item) in old.iter().enumerate() {
        let found = twin(item).filter(|&other| {
            new[other].class == item.class && new[other].place.distance(item.place) <= same_place
        });
        matches.join(index, found);
    }
    matches.join_of_class(old, new, same_place);
    for (index, item) in old.iter().enumerate() {
        matches.join(index, twin(item));
    }
    if rules == Rules::All {
        matches.join_of_class(old, new, f64::INFINITY);
        let is_swap = |a: &Item<'_>, b: &Item<'_>, distance: f64| {
            a.class != b.class && a.on == b.on && distance <= a.reach.min(b.reach)
        };
        let left = matches.left();
        matches.join_all(pairs(old, new, left, &Rule { reach: |a: &Item<'_>| a.reach, is_pair: is_swap }));
    }
    matches
}

impl Matches {
    fn join(&mut self, old: usize, new: Option<usize>) {
        let Some(new) = new else { return };
        if self.new_of[old].is_none() && self.old_of[new].is_none() {
            self.new_of[old] = Some(new);
            self.old_of[new] = Some(old);
        }
    }

    /// Joins what is left of the same class, up to a distance.
    fn join_of_class(&mut self, old: &[Item<'_>], new: &[Item<'_>], most: f64) {
        let (left_old, left_new) = self.left();
        let mut classes: BTreeMap<&str, (Vec<usize>, Vec<usize>)> = BTreeMap::new();
        for index in left_old {
            classes.entry(old[index].class).or_default().0.push(index);
        }
        for index in left_new {
            classes.entry(new[index].class).or_default().1.push(index);
        }
        for (_, left) in classes.into_iter().filter(|(_, (old, new))| !old.is_empty() && !new.is_empty()) {
            let rule = Rule { reach: |_: &Item<'_>| most, is_pair: |_: &Item<'_>, _: &Item<'_>, _| true };
            self.join_all(pairs(old, new, left, &rule));
        }
    }

    fn join_all(&mut self, pairs: Vec<(usize, usize)>) {
        pairs.into_iter().for_each(|(old, new)| self.join(old, Some(new)));
    }

    /// The objects without a pair so far.
    fn left(&self) -> (Vec<usize>, Vec<usize>) {
        let left = |taken: &[Option<usize>]| -> Vec<usize> {
            taken.iter().enumerate().filter(|(_, pair)| pair.is_none()).map(|(index, _)| index).collect()
        };
        (left(&self.new_of), left(&self.old_of))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn item<'a>(id: &'a str, x: f64) -> Item<'a> {
        let class = id.split('.').next().unwrap();
        Item { id: id.to_owned(), class, place: DVec3::new(x, 0.0, 0.0), on: "floor", reach: 0.25 }
    }

    /// Pairs as `old=new`, then removals and additions.
    fn shown(old: &[Item<'_>], new: &[Item<'_>], rules: Rules) -> String {
        let matches = match_up(old, new, 1e-4, rules);
        let mut words: Vec<String> = old
            .iter()
            .zip(&matches.new_of)
            .map(|(item, pair)| match pair {
                Some(pair) => format!("{}={}", item.id, new[*pair].id),
                None => format!("-{}", item.id),
            })
            .collect();
        let came = new.iter().zip(&matches.old_of).filter(|(_, pair)| pair.is_none());
        words.extend(came.map(|(item, _)| format!("+{}", item.id)));
        words.join(" ")
    }

    #[test]
    fn a_removed_object_does_not_make_the_next_ones_move() {
        let old = [item("chair.1", 1.0), item("chair.2", 2.0), item("chair.3", 3.0), item("chair.4", 4.0)];
        let new = [item("chair.1", 1.0), item("chair.2", 3.0), item("chair.3", 4.0)];
        assert_eq!(shown(&old, &new, Rules::All), "chair.1=chair.1 -chair.2 chair.3=chair.2 chair.4=chair.3");
        assert_eq!(shown(&new, &old, Rules::All), "chair.1=chair.1 chair.2=chair.3 chair.3=chair.4 +chair.2");
    }

    #[test]
    fn a_moved_object_keeps_its_id() {
        let old = [item("chair.1", 1.0), item("chair.2", 2.0)];
        let new = [item("chair.1", 2.5), item("chair.2", 2.0)];
        assert_eq!(shown(&old, &new, Rules::All), "chair.1=chair.1 chair.2=chair.2");
    }

    #[test]
    fn remaining_objects_of_a_class_are_paired_with_the_nearest() {
        let old = [item("chair.1", 1.0), item("chair.2", 8.0)];
        let new = [item("chair.3", 8.5), item("chair.4", 2.0), item("lamp.1", 1.0)];
        // The lamp is not asked: both chairs have found another.
        assert_eq!(shown(&old, &new, Rules::All), "chair.1=chair.4 chair.2=chair.3 +lamp.1");
        assert_eq!(shown(&old, &new, Rules::Fixed), "-chair.1 -chair.2 +chair.3 +chair.4 +lamp.1");
    }

    #[test]
    fn an_object_is_swapped_only_for_one_at_the_same_place() {
        let old = [item("chair.1", 1.0), item("desk.1", 5.0)];
        let new = [item("armchair.1", 1.1), item("table.1", 5.6)];
        assert_eq!(shown(&old, &new, Rules::All), "chair.1=armchair.1 -desk.1 +table.1");
        let new = [Item { on: "wall", ..item("armchair.1", 1.1) }];
        assert_eq!(shown(&old, &new, Rules::All), "-chair.1 -desk.1 +armchair.1");
    }

    #[test]
    fn an_edited_class_under_the_same_id_is_the_same_object() {
        let old = [item("chair.1", 1.0)];
        let new = [Item { class: "armchair", ..item("chair.1", 1.0) }];
        assert_eq!(shown(&old, &new, Rules::All), "chair.1=chair.1");
    }

    #[test]
    fn objects_beyond_the_limit_of_comparisons_are_paired_too() {
        let name = |index: usize| format!("chair.{index}");
        let count = 2001;
        let names: Vec<String> = (0..2 * count).map(name).collect();
        let at = |index: usize| item(&names[index], index as f64);
        let (old, new): (Vec<_>, Vec<_>) =
            ((0..count).map(at).collect(), (count..2 * count).map(at).collect());
        let matches = match_up(&old, &new, 1e-4, Rules::All);
        assert!(matches.new_of.iter().all(Option::is_some));
    }
}
