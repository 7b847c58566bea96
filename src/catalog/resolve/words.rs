//! Resolves the room words of plan formats.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use crate::catalog::file::{RoomTypeEntry, WordsFile};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Table;
use crate::plan::{GuessRule, RoomWords};

/// Merges the tables of all folders word by word, later ones first.
pub(crate) fn resolve_words<'a>(
    files: &[(usize, WordsFile)],
    room_types: &Table<RoomTypeEntry>,
    styles: impl Iterator<Item = &'a str>,
    report: &mut Report<'_>,
) -> RoomWords {
    let is_abstract = |id: &str| room_types.get(id).is_some_and(|definition| definition.entry.is_abstract);
    let known = room_types.ids().filter(|id| !is_abstract(id)).map(str::to_owned).collect();
    let styles = styles.map(str::to_owned).collect();
    let mut words = RoomWords { known, styles, ..RoomWords::default() };
    for (source, file) in files {
        add_guesses(&mut words, *source, file, report);
        for (format, table) in &file.formats {
            let spot = Spot { source: *source, path: vec!["formats".into()] }.key(format);
            let merged = words.words.entry(format.clone()).or_default();
            let lowered = lower_words(table, &spot, report);
            for (word, room_type) in &lowered {
                if !words.known.contains(*room_type) {
                    let candidates = words.known.iter().map(String::as_str);
                    report.unknown(&spot.key(word), "room type", room_type, candidates);
                }
            }
            merged.extend(
                lowered.into_iter().map(|(word, room_type)| (word.to_lowercase(), room_type.clone())),
            );
        }
    }
    words
}

/// Merges the classes of drawn furniture of all folders word by word, later ones first.
pub(crate) fn resolve_pieces(
    files: &[(usize, WordsFile)],
    classes: &BTreeSet<&str>,
    report: &mut Report<'_>,
) -> BTreeMap<String, BTreeMap<String, String>> {
    let mut pieces: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    for (source, file) in files {
        for (format, table) in &file.pieces {
            let spot = Spot { source: *source, path: vec!["pieces".into()] }.key(format);
            let lowered = lower_words(table, &spot, report);
            for (word, class) in &lowered {
                if !classes.contains(class.as_str()) {
                    report.unknown(&spot.key(word), "class", class, classes.iter().copied());
                }
            }
            let lowered = lowered.into_iter().map(|(word, class)| (word.to_lowercase(), class.clone()));
            pieces.entry(format.clone()).or_default().extend(lowered);
        }
    }
    pieces
}

/// Adds the kinds of buildings of a file, and its rules before those of the files before it.
fn add_guesses(words: &mut RoomWords, source: usize, file: &WordsFile, report: &mut Report<'_>) {
    words.families.extend(file.families.clone());
    let spot = Spot { source, path: vec!["families".into()] };
    for (family, types) in &file.families {
        let unknown = types.iter().filter(|kind| !words.known.contains(*kind));
        unknown.for_each(|kind| unknown_type(words, &spot.key(family), kind, report));
    }
    let spot = Spot { source, path: vec!["guesses".into()] };
    for (index, rule) in file.guesses.iter().enumerate() {
        check_rule(words, &spot.index(index), rule, report);
    }
    words.guesses.splice(0..0, file.guesses.iter().cloned());
}

/// Reports names that nothing defines, and ranges in which nothing lies.
fn check_rule(words: &RoomWords, spot: &Spot, rule: &GuessRule, report: &mut Report<'_>) {
    if !words.known.contains(&rule.read_as) {
        unknown_type(words, &spot.key("read_as"), &rule.read_as, report);
    }
    for (index, kind) in
        rule.above_or_below.iter().enumerate().filter(|(_, kind)| !words.known.contains(*kind))
    {
        unknown_type(words, &spot.key("above_or_below").index(index), kind, report);
    }
    for (index, family) in
        rule.building.iter().enumerate().filter(|(_, family)| !words.families.contains_key(*family))
    {
        let candidates = words.families.keys().map(String::as_str);
        report.unknown(&spot.key("building").index(index), "family of buildings", family, candidates);
    }
    let is_empty = |[low, high]: [f64; 2]| low.partial_cmp(&high).is_none_or(Ordering::is_gt);
    for (key, _) in rule.ranges().into_iter().filter(|(_, range)| is_empty(*range)) {
        report.error_with_hint(&spot.key(key), "nothing lies in this range", "write [least, most]");
    }
}

fn unknown_type(words: &RoomWords, spot: &Spot, kind: &str, report: &mut Report<'_>) {
    report.unknown(spot, "room type", kind, words.known.iter().map(String::as_str));
}

/// The words as written, without those that differ from another only in case.
fn lower_words<'a>(
    table: &'a BTreeMap<String, String>,
    spot: &Spot,
    report: &mut Report<'_>,
) -> Vec<(&'a String, &'a String)> {
    let mut seen: BTreeMap<String, &String> = BTreeMap::new();
    for word in table.keys() {
        if let Some(first) = seen.insert(word.to_lowercase(), word) {
            let message = format!("\"{word}\" stands here a second time, as \"{first}\"");
            report.error_at_key(&spot.key(word), message, "words are compared without regard to case");
        }
    }
    table.iter().collect()
}
