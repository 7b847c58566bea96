//! Compares the furniture of a room before and after.

use std::collections::BTreeMap;

use glam::{DQuat, DVec3};

use super::change::{Change, Worth};
use super::kind::Kind;
use super::matching::{Item, Matches, Rules, match_up};
use super::tolerance::{Tolerance, round_degrees, round_metres};
use crate::contract::{ElementId, ObjectId};
use crate::read_back::ObjectEntry;

/// Metres within which an object of another class takes a place, however large both are.
const LONGEST_REACH: f64 = 0.5;

/// The changes to the objects of a room.
pub(super) struct ObjectDiff {
    /// By kind, then in the order of the new side; removals in the order of the old one.
    pub(super) changes: Vec<Change>,
    /// The new id of each object of the old side that is still there.
    pub(super) new_ids: BTreeMap<String, String>,
}

/// Both sides with their pairs.
struct Pairing<'a> {
    old: &'a [ObjectEntry],
    new: &'a [ObjectEntry],
    matches: Matches,
    old_index: BTreeMap<&'a ObjectId, usize>,
    new_index: BTreeMap<&'a ObjectId, usize>,
    tolerance: &'a Tolerance,
}

/// Compares the objects of a room.
pub(super) fn compare_objects<'a>(
    old: &'a [ObjectEntry],
    new: &'a [ObjectEntry],
    tolerance: &'a Tolerance,
) -> ObjectDiff {
    let [old_items, new_items] = [old, new].map(|side| side.iter().map(item).collect::<Vec<_>>());
    let matches = match_up(&old_items, &new_items, tolerance.metres, Rules::All);
    let index = |side: &'a [ObjectEntry]| -> BTreeMap<&'a ObjectId, usize> {
        side.iter().enumerate().map(|(index, object)| (&object.id, index)).collect()
    };
    let (old_index, new_index) = (index(old), index(new));
    let pairing = Pairing { old, new, matches, old_index, new_index, tolerance };
    let mut changes: Vec<Change> = Vec::new();
    for (index, object) in new.iter().enumerate() {
        match pairing.matches.old_of[index] {
            Some(before) => changes.extend(pairing.compare(before, index)),
            None => changes
                .push(Change { new: Some(place(object)), ..Change::of(Kind::Added, object.id.to_string()) }),
        }
    }
    let gone = old.iter().zip(&pairing.matches.new_of).filter(|(_, pair)| pair.is_none());
    changes.extend(gone.map(|(object, _)| Change {
        old: Some(place(object)),
        ..Change::of(Kind::Removed, object.id.to_string())
    }));
    changes.sort_by_key(|change| change.kind);
    ObjectDiff { changes, new_ids: pairing.new_ids() }
}

fn item(object: &ObjectEntry) -> Item<'_> {
    let [width, depth, _] = object.size;
    let reach = (width.min(depth) / 2.0).min(LONGEST_REACH);
    Item {
        id: object.id.to_string(),
        class: &object.class,
        place: object.position,
        on: object.parent.kind(),
        reach,
    }
}

fn place(object: &ObjectEntry) -> Worth {
    Worth::metres(object.position.to_array())
}

impl Pairing<'_> {
    fn new_ids(&self) -> BTreeMap<String, String> {
        let pairs = self.old.iter().zip(&self.matches.new_of);
        pairs
            .filter_map(|(object, pair)| Some((object.id.to_string(), self.new[(*pair)?].id.to_string())))
            .collect()
    }

    /// All differences of one object.
    fn compare(&self, old_index: usize, new_index: usize) -> Vec<Change> {
        let (old, new) = (&self.old[old_index], &self.new[new_index]);
        let old_id = (old.id != new.id).then(|| old.id.to_string());
        let change = |kind: Kind| Change { old_id: old_id.clone(), ..Change::of(kind, new.id.to_string()) };
        let mut changes = self.moves(old, new, &change);
        if old.size.iter().zip(&new.size).any(|(a, b)| self.tolerance.is_far((a - b).abs())) {
            changes.push(change(Kind::Resized).between(Worth::metres(old.size), Worth::metres(new.size)));
        }
        let mut word = |kind: Kind, old: &str, new: &str| {
            if old != new {
                changes.push(change(kind).between(Worth::word(old), Worth::word(new)));
            }
        };
        word(Kind::Class, &old.class, &new.class);
        word(Kind::Variant, &old.variant.to_string(), &new.variant.to_string());
        if !self.is_same_parent(&old.parent, &new.parent) {
            word(Kind::Parent, &old.parent.to_string(), &new.parent.to_string());
        }
        if old.materials != new.materials {
            let words = |materials: &[String]| Worth::Words(materials.to_vec());
            changes.push(change(Kind::Material).between(words(&old.materials), words(&new.materials)));
        }
        if changes.is_empty() && old.id != new.id {
            changes.push(change(Kind::Renumbered));
        }
        changes
    }

    /// How it moved and turned.
    fn moves(&self, old: &ObjectEntry, new: &ObjectEntry, change: &dyn Fn(Kind) -> Change) -> Vec<Change> {
        let metres = old.position.distance(new.position);
        let degrees = angle_between(old.rotation, new.rotation);
        let (is_far, is_turn) = (self.tolerance.is_far(metres), self.tolerance.is_turn(degrees));
        if !is_far && !is_turn {
            return Vec::new();
        }
        let with = self.carrier(old, new);
        let mut changes = Vec::new();
        if is_far {
            let moved = change(Kind::Moved).between(place(old), place(new)).by(round_metres(metres));
            changes.push(Change { with: with.clone(), ..moved });
        }
        if is_turn {
            let heading = |object: &ObjectEntry| Worth::degrees(heading(object.rotation));
            let turned = change(Kind::Turned).between(heading(old), heading(new)).by(round_degrees(degrees));
            changes.push(Change { with, ..turned });
        }
        changes
    }

    /// The new id of the object that carried another one: both have moved as one.
    fn carrier(&self, old: &ObjectEntry, new: &ObjectEntry) -> Option<String> {
        let before = &self.old[find(&self.old_index, &old.parent)?];
        let after = &self.new[find(&self.new_index, &new.parent)?];
        if !self.is_same_parent(&old.parent, &new.parent) {
            return None;
        }
        let from = |parent: &ObjectEntry, child: &ObjectEntry| -> (DVec3, DQuat) {
            let back = parent.rotation.conjugate();
            (back * (child.position - parent.position), back * child.rotation)
        };
        let ((place_before, turn_before), (place_after, turn_after)) = (from(before, old), from(after, new));
        let is_carried = !self.tolerance.is_far(place_before.distance(place_after))
            && !self.tolerance.is_turn(angle_between(turn_before, turn_after));
        is_carried.then(|| after.id.to_string())
    }

    /// Whether two parents are the same part of the room, or an object and what it was before.
    fn is_same_parent(&self, old: &ElementId, new: &ElementId) -> bool {
        match (find(&self.old_index, old), find(&self.new_index, new)) {
            (Some(before), Some(after)) => self.matches.new_of[before] == Some(after),
            (None, None) => old == new,
            _ => false,
        }
    }
}

/// The index of an object, if the element is one and is there.
fn find(index: &BTreeMap<&ObjectId, usize>, element: &ElementId) -> Option<usize> {
    let ElementId::Object(object) = element else { return None };
    index.get(object).copied()
}

/// Degrees of the smallest turn from one to the other.
fn angle_between(a: DQuat, b: DQuat) -> f64 {
    let turn = a.conjugate() * b;
    let sine = DVec3::new(turn.x, turn.y, turn.z).length();
    (2.0 * libm::atan2(sine, turn.w.abs())).to_degrees()
}

/// Degrees about the vertical, counter-clockwise.
fn heading(rotation: DQuat) -> f64 {
    let east = rotation * DVec3::X;
    libm::atan2(east.y, east.x).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn object(id: &str, x: f64) -> ObjectEntry {
        ObjectEntry {
            id: id.parse().unwrap(),
            class: id.split('.').next().unwrap().to_owned(),
            parent: ElementId::Floor,
            position: DVec3::new(x, 1.0, 0.0),
            rotation: DQuat::IDENTITY,
            size: [0.5, 0.5, 0.9],
            variant: 0,
            materials: vec!["plain.wood".to_owned()],
        }
    }

    fn turned(object: ObjectEntry, degrees: f64) -> ObjectEntry {
        let half = degrees.to_radians() / 2.0;
        ObjectEntry { rotation: DQuat::from_xyzw(0.0, 0.0, libm::sin(half), libm::cos(half)), ..object }
    }

    /// Each change as `kind id amount with`.
    fn shown(old: &[ObjectEntry], new: &[ObjectEntry]) -> Vec<String> {
        let diff = compare_objects(old, new, &Tolerance::default());
        let line = |change: &Change| {
            let amount = change.amount.map_or_else(String::new, |amount| format!(" {amount}"));
            let with = change.with.as_ref().map_or_else(String::new, |with| format!(" with {with}"));
            format!("{} {}{amount}{with}", change.kind.name(), change.id)
        };
        diff.changes.iter().map(line).collect()
    }

    #[test]
    fn equal_rooms_have_no_difference() {
        assert!(shown(&[object("chair.1", 1.0)], &[object("chair.1", 1.0)]).is_empty());
        // Single precision, and a hundredth of a degree.
        assert!(shown(&[object("chair.1", 1.0)], &[turned(object("chair.1", 1.000_09), 0.009)]).is_empty());
    }

    #[test]
    fn moves_and_turns_are_measured() {
        let old = [object("chair.1", 1.0)];
        assert_eq!(shown(&old, &[object("chair.1", 1.000_2)]), ["moved chair.1 0.0002"]);
        assert_eq!(shown(&old, &[turned(object("chair.1", 1.0), 0.02)]), ["turned chair.1 0.02"]);
        // The short way round, from heading 170 to -170.
        let turned =
            shown(&[turned(object("chair.1", 1.0), 170.0)], &[turned(object("chair.1", 1.0), -170.0)]);
        assert_eq!(turned, ["turned chair.1 20"]);
    }

    #[test]
    fn each_property_has_its_kind() {
        let old = object("chair.1", 1.0);
        let faults: [(ObjectEntry, &str); 5] = [
            (ObjectEntry { size: [0.5, 0.6, 0.9], ..old.clone() }, "resized chair.1"),
            (ObjectEntry { variant: 2, ..old.clone() }, "variant chair.1"),
            (ObjectEntry { class: "armchair".to_owned(), ..old.clone() }, "class chair.1"),
            (ObjectEntry { parent: ElementId::Wall(1), ..old.clone() }, "parent chair.1"),
            (ObjectEntry { materials: vec!["plain.metal".to_owned()], ..old.clone() }, "material chair.1"),
        ];
        for (new, expected) in faults {
            assert_eq!(shown(std::slice::from_ref(&old), &[new]), [expected]);
        }
    }

    #[test]
    fn a_swap_is_one_change_of_class_and_not_two_of_presence() {
        let lines = shown(&[object("chair.1", 1.0)], &[object("armchair.1", 1.0)]);
        assert_eq!(lines, ["class armchair.1"]);
        assert_eq!(
            shown(&[object("chair.1", 1.0)], &[object("armchair.1", 2.0)]),
            ["added armchair.1", "removed chair.1"]
        );
    }

    #[test]
    fn a_removal_is_the_only_change_besides_numbers() {
        let old = [object("chair.1", 1.0), object("chair.2", 2.0), object("chair.3", 3.0)];
        let new = [object("chair.1", 1.0), object("chair.2", 3.0)];
        assert_eq!(shown(&old, &new), ["removed chair.2", "renumbered chair.2"]);
    }

    #[test]
    fn objects_on_a_moved_object_move_with_it() {
        let lamp = |x: f64, degrees: f64| ObjectEntry {
            parent: "desk.1".parse().unwrap(),
            position: DVec3::new(x, 1.0, 0.7),
            ..turned(object("lamp.1", x), degrees)
        };
        let old = [object("desk.1", 1.0), lamp(1.2, 0.0)];
        assert_eq!(
            shown(&old, &[object("desk.1", 2.0), lamp(2.2, 0.0)]),
            ["moved desk.1 1", "moved lamp.1 1 with desk.1"]
        );
        assert_eq!(
            shown(&old, &[object("desk.1", 2.0), lamp(2.1, 0.0)]),
            ["moved desk.1 1", "moved lamp.1 0.9"]
        );
        // Turned about the desk's middle by half a turn, it stands on the other side of that.
        assert_eq!(
            shown(&old, &[turned(object("desk.1", 1.0), 180.0), lamp(0.8, 180.0)]),
            ["moved lamp.1 0.4 with desk.1", "turned desk.1 180", "turned lamp.1 180 with desk.1"]
        );
    }

    #[test]
    fn a_parent_that_has_another_number_is_the_same_parent() {
        let on =
            |parent: &str, x: f64| ObjectEntry { parent: parent.parse().unwrap(), ..object("lamp.1", x) };
        let old = [object("desk.1", 1.0), object("desk.2", 3.0), on("desk.2", 3.0)];
        let new = [object("desk.1", 3.0), on("desk.1", 3.0)];
        assert_eq!(shown(&old, &new), ["removed desk.1", "renumbered desk.1"]);
        let new = [object("desk.1", 1.0), object("desk.2", 3.0), on("desk.1", 3.0)];
        assert_eq!(shown(&old, &new), ["parent lamp.1"]);
    }
}
