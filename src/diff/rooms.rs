//! Compares a room before and after.

use std::collections::BTreeMap;

use super::change::{Change, FindingWorth, Worth};
use super::kind::Kind;
use super::objects::compare_objects;
use super::report::{Presence, RoomDiff};
use super::tolerance::{Tolerance, round_metres};
use crate::contract::FindingExtras;
use crate::read_back::RoomContents;

/// The word of a finding that fails its room.
const FAILED: &str = "failed";

/// A room on one side only.
pub(super) fn lone_room(id: &str, room: &RoomContents, state: Presence) -> RoomDiff {
    let objects = Worth::Number(room.objects.len() as f64);
    let (old, new) = if state == Presence::Removed { (Some(objects), None) } else { (None, Some(objects)) };
    let mut changes = vec![Change { old, new, ..Change::of(Kind::Rooms, "") }];
    if state == Presence::Added && fails(room) {
        changes.push(Change::of(Kind::FailedRooms, ""));
    }
    RoomDiff { room: id.to_owned(), room_type: room.room_type.clone(), state, changes }
}

/// Compares a room; `None` where nothing differs.
pub(super) fn compare_rooms(
    id: &str,
    old: &RoomContents,
    new: &RoomContents,
    tolerance: &Tolerance,
) -> Option<RoomDiff> {
    let mut changes = properties(old, new, tolerance);
    let objects = compare_objects(&old.objects, &new.objects, tolerance);
    changes.extend(objects.changes);
    changes.extend(missing(old, new));
    changes.extend(findings(old, new, &objects.new_ids));
    if fails(new) && !fails(old) {
        changes.push(Change::of(Kind::FailedRooms, ""));
    }
    (!changes.is_empty()).then(|| RoomDiff {
        room: id.to_owned(),
        room_type: new.room_type.clone(),
        state: Presence::Changed,
        changes,
    })
}

fn fails(room: &RoomContents) -> bool {
    room.findings.iter().any(|finding| finding.severity == FAILED)
}

fn properties(old: &RoomContents, new: &RoomContents, tolerance: &Tolerance) -> Vec<Change> {
    let mut changes = Vec::new();
    let is_higher = tolerance.is_far((old.height - new.height).abs());
    if is_higher || !is_same_shape(&old.rings, &new.rings, tolerance) {
        let area = |room: &RoomContents| Worth::Number(round_metres(floor_area(room)));
        changes.push(Change::of(Kind::Outline, "").between(area(old), area(new)));
    }
    let words = [
        (Kind::Type, old.room_type.clone(), new.room_type.clone()),
        (Kind::Style, old.style.clone(), new.style.clone()),
        // As a word: numbers of JSON do not hold all digits of a seed.
        (Kind::Seed, old.seed.to_string(), new.seed.to_string()),
    ];
    let differing = words.into_iter().filter(|(_, old, new)| old != new);
    changes.extend(
        differing.map(|(kind, old, new)| Change::of(kind, "").between(Worth::Word(old), Worth::Word(new))),
    );
    changes
}

/// Whether rings have the same corners, from whichever they begin.
fn is_same_shape(old: &[Vec<[f64; 2]>], new: &[Vec<[f64; 2]>], tolerance: &Tolerance) -> bool {
    let is_same_corner =
        |a: &[f64; 2], b: &[f64; 2]| !tolerance.is_far(libm::hypot(a[0] - b[0], a[1] - b[1]));
    let is_same_ring = |a: &Vec<[f64; 2]>, b: &Vec<[f64; 2]>| {
        let from =
            |start: usize| a.iter().zip(b.iter().cycle().skip(start)).all(|(a, b)| is_same_corner(a, b));
        a.len() == b.len() && (a.is_empty() || (0..b.len()).any(from))
    };
    old.len() == new.len() && old.iter().zip(new).all(|(a, b)| is_same_ring(a, b))
}

/// Square metres within the outline, without holes and columns.
fn floor_area(room: &RoomContents) -> f64 {
    let area = |ring: &Vec<[f64; 2]>| {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
    };
    let mut areas = room.rings.iter().map(area);
    let outline = areas.next().unwrap_or(0.0);
    outline - areas.sum::<f64>()
}

/// Pieces that are missing now or were missing before: class and reason, as often as they differ.
fn missing(old: &RoomContents, new: &RoomContents) -> Vec<Change> {
    let mut counts: BTreeMap<&(String, String), i64> = BTreeMap::new();
    old.missing.iter().for_each(|piece| *counts.entry(piece).or_default() -= 1);
    new.missing.iter().for_each(|piece| *counts.entry(piece).or_default() += 1);
    let change = |((class, reason), count): (&(String, String), i64)| {
        let reason = Some(Worth::word(reason));
        let change = if count > 0 {
            Change { new: reason, ..Change::of(Kind::Missing, class) }
        } else {
            Change { old: reason, ..Change::of(Kind::MissingGone, class) }
        };
        std::iter::repeat_n(change, usize::try_from(count.unsigned_abs()).unwrap_or(usize::MAX))
    };
    let mut changes: Vec<Change> = counts.into_iter().flat_map(change).collect();
    changes.sort_by_key(|change| change.kind);
    changes
}

/// Code, severity and objects: what makes two findings the same, whatever they measure.
type FindingKey = (String, String, Vec<String>);

/// Findings that are new or gone. Objects are known by their new ids.
fn findings(old: &RoomContents, new: &RoomContents, new_ids: &BTreeMap<String, String>) -> Vec<Change> {
    let key = |finding: &FindingExtras, rename: &dyn Fn(&String) -> String| -> FindingKey {
        let mut objects: Vec<String> = finding.objects.iter().map(rename).collect();
        objects.sort();
        (finding.code.to_string(), finding.severity.to_string(), objects)
    };
    let is_object = |id: &String| old.objects.iter().any(|object| object.id.to_string() == *id);
    // A removed object is none of the new side, although one of those may have its number.
    let renamed = |id: &String| match new_ids.get(id) {
        Some(found) => found.clone(),
        None if is_object(id) => format!("{id} (removed)"),
        None => id.clone(),
    };
    let mut left: BTreeMap<FindingKey, Vec<&FindingExtras>> = BTreeMap::new();
    for finding in &old.findings {
        left.entry(key(finding, &renamed)).or_default().push(finding);
    }
    let mut changes = Vec::new();
    for finding in &new.findings {
        let known = left.get_mut(&key(finding, &String::clone)).and_then(Vec::pop);
        if known.is_none() {
            changes.push(Change { new: Some(worth(finding)), ..Change::of(Kind::Findings, &*finding.code) });
        }
    }
    let gone = left.into_values().flatten();
    changes.extend(gone.map(|finding| Change {
        old: Some(worth(finding)),
        ..Change::of(Kind::FindingsGone, &*finding.code)
    }));
    changes
}

fn worth(finding: &FindingExtras) -> Worth {
    Worth::Finding(FindingWorth {
        severity: finding.severity.to_string(),
        objects: finding.objects.clone(),
        measured: round_metres(finding.measured),
        threshold: round_metres(finding.threshold),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn room() -> RoomContents {
        RoomContents {
            room_type: "office".to_owned(),
            style: "default".to_owned(),
            seed: u64::MAX,
            rings: vec![vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]],
            height: 2.5,
            missing: vec![("chair".to_owned(), "no place".to_owned())],
            findings: vec![finding("tight_use", "minor", "desk.1")],
            objects: Vec::new(),
        }
    }

    fn finding(code: &str, severity: &str, object: &str) -> FindingExtras {
        FindingExtras {
            code: code.to_owned().into(),
            severity: severity.to_owned().into(),
            objects: vec![object.to_owned()],
            measured: 0.5,
            threshold: 0.6,
            not_searched_further: false,
        }
    }

    fn kinds(old: &RoomContents, new: &RoomContents) -> Vec<Kind> {
        let diff = compare_rooms("a", old, new, &Tolerance::default());
        diff.into_iter().flat_map(|diff| diff.changes).map(|change| change.kind).collect()
    }

    type Fault = fn(&mut RoomContents);

    #[test]
    fn each_property_has_its_kind_and_an_equal_room_none() {
        let old = room();
        assert!(kinds(&old, &old.clone()).is_empty());
        let faults: [(Kind, Fault); 7] = [
            (Kind::Outline, |room| room.rings[0][1][0] = 4.1),
            (Kind::Outline, |room| room.height = 2.6),
            (Kind::Outline, |room| room.rings.push(vec![[1.0, 1.0], [1.3, 1.0], [1.3, 1.3]])),
            (Kind::Type, |room| room.room_type = "study".to_owned()),
            (Kind::Style, |room| room.style = "tidy".to_owned()),
            (Kind::Seed, |room| room.seed -= 1),
            (Kind::MissingGone, |room| room.missing.clear()),
        ];
        for (kind, fault) in faults {
            let mut new = old.clone();
            fault(&mut new);
            assert_eq!(kinds(&old, &new), [kind]);
        }
    }

    #[test]
    fn an_outline_may_begin_at_any_corner_and_blur_a_little() {
        let old = room();
        let mut new = old.clone();
        new.rings[0].rotate_left(2);
        new.rings[0][0][0] += 5e-5;
        assert!(kinds(&old, &new).is_empty());
    }

    #[test]
    fn findings_appear_disappear_and_get_worse() {
        let old = room();
        let with = |findings: Vec<FindingExtras>| RoomContents { findings, ..room() };
        assert_eq!(kinds(&old, &with(Vec::new())), [Kind::FindingsGone]);
        let worse = with(vec![finding("tight_use", "failed", "desk.1")]);
        assert_eq!(kinds(&old, &worse), [Kind::Findings, Kind::FindingsGone, Kind::FailedRooms]);
        // A room that failed before fails no more than it did.
        let other = with(vec![finding("collision", "failed", "desk.1")]);
        assert_eq!(kinds(&worse, &other), [Kind::Findings, Kind::FindingsGone]);
        // Measured values may differ.
        let measured = FindingExtras { measured: 0.55, ..finding("tight_use", "minor", "desk.1") };
        assert!(kinds(&old, &with(vec![measured])).is_empty());
    }

    #[test]
    fn one_missing_piece_more_of_two_alike_is_one_change() {
        let mut new = room();
        new.missing.push(new.missing[0].clone());
        assert_eq!(kinds(&room(), &new), [Kind::Missing]);
        assert_eq!(kinds(&new, &room()), [Kind::MissingGone]);
    }
}
