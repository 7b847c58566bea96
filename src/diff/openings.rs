//! Compares the doors and windows of a level before and after.

use super::change::{Change, Worth};
use super::kind::Kind;
use super::matching::{Item, Rules, match_up};
use super::tolerance::{Tolerance, round_metres};
use crate::read_back::OpeningEntry;

/// Openings that were added, removed, moved or changed; new ones first, in the order of their file.
pub(super) fn compare_openings(
    old: &[OpeningEntry],
    new: &[OpeningEntry],
    tolerance: &Tolerance,
) -> Vec<Change> {
    let [old_items, new_items] = [old, new].map(|side| side.iter().map(item).collect::<Vec<_>>());
    let matches = match_up(&old_items, &new_items, tolerance.metres, Rules::Fixed);
    let mut changes = Vec::new();
    for (opening, pair) in new.iter().zip(&matches.old_of) {
        match pair {
            Some(before) => changes.extend(compare(&old[*before], opening, tolerance)),
            None => {
                changes.push(Change {
                    new: Some(shown(opening)),
                    ..Change::of(Kind::Openings, opening.id.to_string())
                });
            }
        }
    }
    let gone = old.iter().zip(&matches.new_of).filter(|(_, pair)| pair.is_none());
    changes.extend(gone.map(|(opening, _)| Change {
        old: Some(shown(opening)),
        ..Change::of(Kind::Openings, opening.id.to_string())
    }));
    changes
}

fn item(opening: &OpeningEntry) -> Item<'_> {
    Item { id: opening.id.to_string(), class: opening.id.kind(), place: opening.position, on: "", reach: 0.0 }
}

fn compare(old: &OpeningEntry, new: &OpeningEntry, tolerance: &Tolerance) -> Option<Change> {
    let metres = old.position.distance(new.position);
    let differs = |a: &[f64; 2], b: &[f64; 2]| (0..2).any(|axis| tolerance.is_far((a[axis] - b[axis]).abs()));
    let is_same = !tolerance.is_far(metres)
        && !differs(&old.size, &new.size)
        && old.closure == new.closure
        && old.rooms == new.rooms
        && old.leaves.len() == new.leaves.len()
        && !old.leaves.iter().zip(&new.leaves).any(|(a, b)| differs(a, b));
    (!is_same).then(|| Change {
        old_id: (old.id != new.id).then(|| old.id.to_string()),
        amount: tolerance.is_far(metres).then(|| round_metres(metres)),
        ..Change::of(Kind::Openings, new.id.to_string()).between(shown(old), shown(new))
    })
}

/// The kind, size, place and rooms of an opening.
fn shown(opening: &OpeningEntry) -> Worth {
    let [width, height] = opening.size.map(round_metres);
    let [x, y, z] = opening.position.to_array().map(round_metres);
    let rooms = opening.rooms.join(" and ");
    let leaves = match opening.leaves.as_slice() {
        [] => String::new(),
        tips => {
            let tips = tips.iter().map(|tip| format!("{}, {}", round_metres(tip[0]), round_metres(tip[1])));
            format!(", opens to {}", tips.collect::<Vec<_>>().join(" and "))
        }
    };
    Worth::Word(format!("{} {width} × {height} m at {x}, {y}, {z} of {rooms}{leaves}", opening.closure))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::contract::ElementId;

    fn door(id: &str, x: f64) -> OpeningEntry {
        OpeningEntry {
            id: ElementId::Door(id.to_owned()),
            closure: "door".to_owned(),
            rooms: vec!["a".to_owned(), "b".to_owned()],
            position: DVec3::new(x, 0.0, 0.0),
            size: [0.9, 2.0],
            leaves: vec![[x + 0.45, 0.9]],
        }
    }

    fn found(old: &[OpeningEntry], new: &[OpeningEntry]) -> Vec<Change> {
        compare_openings(old, new, &Tolerance::default())
    }

    #[test]
    fn doors_are_added_removed_moved_and_changed() {
        let old = [door("1", 1.0)];
        assert!(found(&old, &old.clone()).is_empty());
        let moved = found(&old, &[door("1", 1.5)]);
        assert_eq!((moved.len(), moved[0].amount), (1, Some(0.5)));
        let wider = OpeningEntry { size: [1.0, 2.0], ..door("1", 1.0) };
        let other_way = OpeningEntry { leaves: vec![[1.45, -0.9]], ..door("1", 1.0) };
        let sliding = OpeningEntry { closure: "sliding".to_owned(), leaves: Vec::new(), ..door("1", 1.0) };
        for changed in [wider, other_way, sliding] {
            let changes = found(&old, &[changed]);
            assert!(changes.len() == 1 && changes[0].amount.is_none() && changes[0].old != changes[0].new);
        }
        let came = found(&old, &[door("1", 1.0), door("2", 3.0)]);
        assert!(came.len() == 1 && came[0].old.is_none() && came[0].id == "door:2");
        let went = found(&[door("1", 1.0), door("2", 3.0)], &old);
        assert!(went.len() == 1 && went[0].new.is_none() && went[0].id == "door:2");
    }

    #[test]
    fn a_door_with_another_number_is_the_same_door() {
        let changes = found(&[door("1", 1.0), door("2", 3.0)], &[door("1", 3.0)]);
        assert!(changes.len() == 1 && changes[0].id == "door:1" && changes[0].new.is_none(), "{changes:?}");
    }
}
