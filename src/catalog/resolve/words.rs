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
    let mut words = RoomWords { known, styles, words: BTreeMap::new() };
    for (source, file) in files {
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
