//! The room words of plan formats.

use std::collections::BTreeMap;

use crate::catalog::file::{RoomTypeEntry, WordsFile};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Table;
use crate::plan::RoomWords;

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
        add_guesses(&mut words, (*source, file), report);
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

/// Adds the rules of a file before those of the files before it.
fn add_guesses(words: &mut RoomWords, (source, file): (usize, &WordsFile), report: &mut Report<'_>) {
    let spot = Spot { source, path: vec!["guesses".into()] };
    for (index, rule) in
        file.guesses.iter().enumerate().filter(|(_, rule)| !words.known.contains(&rule.read_as))
    {
        let candidates = words.known.iter().map(String::as_str);
        report.unknown(&spot.item(Some(index)).key("read_as"), "room type", &rule.read_as, candidates);
    }
    words.guesses.splice(0..0, file.guesses.iter().cloned());
    words.families.extend(file.families.clone());
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
