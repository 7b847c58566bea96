//! Changes as lines of text, one for each object.

use std::collections::{BTreeMap, BTreeSet};

use crate::diff::change::{Change, FindingWorth, Worth};
use crate::diff::kind::Kind;

/// Objects that are named as carried by another one; more are counted.
const NAMED_COMPANIONS: usize = 3;

/// Something that differs, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Line {
    /// `+`, `−`, `~` or `!`.
    pub(super) sign: &'static str,
    /// An id; empty for the room or level.
    pub(super) subject: String,
    /// The change in words.
    pub(super) text: String,
}

/// The lines of a room or a level: about itself, then objects, then what is missing and found.
pub(super) fn lines(changes: &[Change]) -> Vec<Line> {
    let told: BTreeSet<&str> =
        changes.iter().filter(|change| is_of_object(change.kind)).map(|change| change.id.as_str()).collect();
    let companions = companions(changes, &told);
    let mut lines = Vec::new();
    let mut objects: Vec<(&str, Vec<&Change>)> = Vec::new();
    let mut places: BTreeMap<&str, usize> = BTreeMap::new();
    let mut renumbered = 0_u64;
    for change in changes {
        match change.kind {
            Kind::Renumbered => renumbered += 1,
            _ if carrier(change, &told).is_some() => {}
            kind if is_of_object(kind) => {
                let place = *places.entry(&change.id).or_insert(objects.len());
                if place == objects.len() {
                    objects.push((&change.id, Vec::new()));
                }
                objects[place].1.push(change);
            }
            _ => lines.push(line(change)),
        }
    }
    let of_objects = objects.iter().map(|(id, own)| object_line(id, own, companions.get(*id)));
    // After what is said about the room, before what is missing and found.
    let place = lines.iter().take_while(|(order, _)| *order == 0).count();
    let mut lines: Vec<Line> = lines.into_iter().map(|(_, line)| line).collect();
    lines.splice(place..place, of_objects);
    if renumbered > 0 {
        let text = format!("{} with another number only", super::counted(renumbered, "object"));
        lines.push(Line { sign: "~", subject: String::new(), text });
    }
    lines
}

/// Kinds of which an object may have several.
fn is_of_object(kind: Kind) -> bool {
    (Kind::Added..=Kind::Parent).contains(&kind)
}

/// The object that carried another one, if that has a line of its own.
fn carrier<'a>(change: &'a Change, told: &BTreeSet<&str>) -> Option<&'a str> {
    change.with.as_deref().filter(|with| told.contains(with))
}

/// The objects that moved with each object, by the object that nothing else carried.
fn companions<'a>(changes: &'a [Change], told: &BTreeSet<&str>) -> BTreeMap<&'a str, Vec<&'a str>> {
    /// Deeper than people stack objects, and where carriers run in a circle, deep enough.
    const DEEPEST: usize = 64;
    let above: BTreeMap<&str, &str> =
        changes.iter().filter_map(|change| Some((change.id.as_str(), carrier(change, told)?))).collect();
    let mut companions: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for &id in above.keys() {
        let chain = std::iter::successors(above.get(id), |above_it| above.get(**above_it));
        if let Some(last) = chain.take(DEEPEST).last() {
            companions.entry(last).or_default().push(id);
        }
    }
    companions
}

fn object_line(id: &str, changes: &[&Change], companions: Option<&Vec<&str>>) -> Line {
    let has = |kind: Kind| changes.iter().any(|change| change.kind == kind);
    let sign = if has(Kind::Added) {
        "+"
    } else if has(Kind::Removed) {
        "−"
    } else {
        "~"
    };
    let mut words: Vec<String> = changes.iter().map(|change| object_words(change)).collect();
    if let Some(others) = companions {
        let named = others.iter().take(NAMED_COMPANIONS).copied().collect::<Vec<_>>().join(", ");
        let more = others.len().saturating_sub(NAMED_COMPANIONS);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        words.push(format!("with {named}{more}"));
    }
    let was = changes.iter().find_map(|change| change.old_id.as_ref());
    let subject = was.map_or_else(|| id.to_owned(), |was| format!("{id} (was {was})"));
    Line { sign, subject, text: words.join(", ") }
}

fn object_words(change: &Change) -> String {
    let amount = change.amount.unwrap_or(0.0);
    let (old, new) = (change.old.as_ref(), change.new.as_ref());
    match change.kind {
        Kind::Added => format!("at {}", shown(new)),
        Kind::Removed => format!("was at {}", shown(old)),
        Kind::Moved => format!("moved {amount} m"),
        Kind::Turned => format!("turned {amount}°"),
        Kind::Resized => format!("size {} → {} m", shown(old), shown(new)),
        kind => {
            let (old, new) = differing_words(old, new);
            format!("{} {} → {}", kind.name(), shown(old.as_ref()), shown(new.as_ref()))
        }
    }
}

/// Both values; of lists of words only those that the other one lacks.
fn differing_words(old: Option<&Worth>, new: Option<&Worth>) -> (Option<Worth>, Option<Worth>) {
    let (Some(Worth::Words(before)), Some(Worth::Words(after))) = (old, new) else {
        return (old.cloned(), new.cloned());
    };
    let without = |words: &[String], others: &[String]| {
        let left: Vec<String> = words.iter().filter(|word| !others.contains(word)).cloned().collect();
        (!left.is_empty()).then_some(Worth::Words(left))
    };
    (without(before, after), without(after, before))
}

/// Whether it comes after the objects, and the line.
fn line(change: &Change) -> (u8, Line) {
    let sign = match (change.kind, &change.old, &change.new) {
        (Kind::Findings | Kind::FailedRooms | Kind::Missing, _, _) => "!",
        (Kind::FindingsGone | Kind::MissingGone, _, _) | (_, Some(_), None) => "−",
        (Kind::Shell | Kind::Models | Kind::Looks, _, _) => "~",
        (_, None, Some(_)) => "+",
        _ => "~",
    };
    let is_last = change.kind > Kind::Parent;
    let (subject, text) = words(change);
    (u8::from(is_last), Line { sign, subject, text })
}

fn words(change: &Change) -> (String, String) {
    let (old, new) = (change.old.as_ref(), change.new.as_ref());
    let id = change.id.clone();
    let between = || format!("{} → {}", shown(old), shown(new));
    let text = match change.kind {
        Kind::Rooms => return (String::new(), format!("room with {} objects", shown(old.or(new)))),
        Kind::Levels => match old.xor(new) {
            Some(Worth::Numbers(counts)) if counts.len() == 2 => {
                return (String::new(), format!("level with {} rooms, {} objects", counts[0], counts[1]));
            }
            _ => between(),
        },
        Kind::Outline => format!("outline or height, {} → {} m²", shown(old), shown(new)),
        Kind::Type | Kind::Style | Kind::Seed => format!("{} {}", change.kind.name(), between()),
        Kind::Openings => match (old, new) {
            (Some(_), Some(_)) => {
                let moved = change.amount.map_or_else(String::new, |metres| format!("moved {metres} m: "));
                format!("{moved}{}", between())
            }
            (Some(_), None) => format!("removed: {}", shown(old)),
            _ => format!("added: {}", shown(new)),
        },
        Kind::Missing => format!("is missing now ({})", shown(new)),
        Kind::MissingGone => format!("was missing ({})", shown(old)),
        Kind::Findings | Kind::FindingsGone => shown(old.or(new)),
        Kind::FailedRooms => match change.amount {
            Some(count) => format!("{count} rooms fail"),
            None => "the room fails now".to_owned(),
        },
        Kind::Shell => return (String::new(), differing("part of the shell", change)),
        Kind::Models => return (String::new(), differing("model", change)),
        Kind::Looks => return (String::new(), differing(change.id.trim_end_matches('s'), change)),
        Kind::Bytes => "the bytes differ, nothing else does".to_owned(),
        _ => between(),
    };
    (id, text)
}

/// How many parts differ, and some of them by name.
fn differing(what: &str, change: &Change) -> String {
    let count = change.amount.unwrap_or(0.0) as u64;
    let what = if count == 1 { what.to_owned() } else { plural(what) };
    let more = match change.new.as_ref() {
        Some(Worth::Words(names)) if (names.len() as u64) < count => ", …",
        _ => "",
    };
    let verb = if count == 1 { "differs" } else { "differ" };
    format!("{count} {what} {verb}: {}{more}", shown(change.new.as_ref()))
}

fn plural(what: &str) -> String {
    match what.split_once(' ') {
        Some((first, rest)) => format!("{first}s {rest}"),
        None => format!("{what}s"),
    }
}

/// A value in words.
fn shown(worth: Option<&Worth>) -> String {
    match worth {
        None => "nothing".to_owned(),
        Some(Worth::Word(word)) => word.clone(),
        Some(Worth::Words(words)) => words.join(", "),
        Some(Worth::Number(number)) => number.to_string(),
        Some(Worth::Numbers(numbers)) => {
            numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
        }
        Some(Worth::Finding(FindingWorth { severity, objects, measured, threshold })) => {
            format!("{severity}, {}: {measured}, threshold {threshold}", objects.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown_lines(changes: &[Change]) -> Vec<String> {
        lines(changes)
            .into_iter()
            .map(|line| format!("{} {}: {}", line.sign, line.subject, line.text))
            .collect()
    }

    #[test]
    fn an_object_has_one_line_and_carries_others() {
        let carried = |id: &str, with: &str| Change {
            with: Some(with.to_owned()),
            ..Change::of(Kind::Moved, id).by(1.0)
        };
        let variant = Change::of(Kind::Variant, "desk.1").between(Worth::word("0"), Worth::word("2"));
        let materials = |words: &[&str]| Worth::Words(words.iter().map(ToString::to_string).collect());
        let material = Change::of(Kind::Material, "desk.1");
        let changes = [
            Change::of(Kind::Style, "").between(Worth::word("plain"), Worth::word("tidy")),
            Change::of(Kind::Moved, "desk.1").by(1.0),
            carried("lamp.1", "desk.1"),
            carried("bulb.1", "lamp.1"),
            Change { old_id: Some("desk.2".to_owned()), ..variant },
            material.between(materials(&["metal", "oak"]), materials(&["ash", "metal"])),
            Change { new: Some(Worth::word("no place")), ..Change::of(Kind::Missing, "chair") },
        ];
        assert_eq!(
            shown_lines(&changes),
            [
                "~ : style plain → tidy",
                "~ desk.1 (was desk.2): moved 1 m, variant 0 → 2, material oak → ash, with bulb.1, lamp.1",
                "! chair: is missing now (no place)",
            ]
        );
    }

    #[test]
    fn differences_in_many_places_are_counted() {
        let shell = Change {
            new: Some(Worth::Words(vec!["wall.1@a".to_owned()])),
            ..Change::of(Kind::Shell, "").by(2.0)
        };
        let one = Change {
            amount: Some(1.0),
            ..Change { kind: Kind::Looks, id: "materials".to_owned(), ..shell.clone() }
        };
        assert_eq!(
            shown_lines(&[shell, one]),
            ["~ : 2 parts of the shell differ: wall.1@a, …", "~ : 1 material differs: wall.1@a"]
        );
        let renumbered = [Change::of(Kind::Renumbered, "a.1"), Change::of(Kind::Renumbered, "a.2")];
        assert_eq!(shown_lines(&renumbered), ["~ : 2 objects with another number only"]);
    }
}
