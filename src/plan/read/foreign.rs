//! What the readers of foreign formats share.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::document::{Fault, FaultSeverity, Faults, PathStep, Source};
use crate::plan::GENERIC_ROOM_TYPE;

/// The first bytes of a file; none if it cannot be read.
pub(super) fn head(path: &Path, size: u64) -> Vec<u8> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(size).read_to_end(&mut bytes));
    if read.is_ok() { bytes } else { Vec::new() }
}

/// A room word that the table does not know: a warning at its first place.
pub(super) fn unknown_word(source: &Source, path: &[PathStep], format: &str, word: (&str, usize)) -> Fault {
    let (message, hint) = unknown_words(format, word);
    source.fault(path, message, Some(hint), FaultSeverity::Warning)
}

/// Fact and hint about a room word that the table does not know.
pub(super) fn unknown_words(format: &str, (word, count): (&str, usize)) -> (String, String) {
    let rooms = if count == 1 { "1 room is".to_owned() } else { format!("{count} rooms are") };
    let message = format!("unknown room word \"{word}\": {rooms} taken as \"{GENERIC_ROOM_TYPE}\"");
    (message, format!("add it under formats.{format} in a room_words.yaml of yours"))
}

/// A name that reads well in paths: small letters and digits, one `_` for all between.
pub(super) fn slug(name: &str) -> String {
    let mut slug = String::new();
    for letter in name.chars() {
        if letter.is_ascii_alphanumeric() {
            slug.push(letter.to_ascii_lowercase());
        } else if !slug.is_empty() && !slug.ends_with('_') {
            slug.push('_');
        }
    }
    slug.trim_end_matches('_').to_owned()
}

/// Both values, or the faults of both.
pub(super) fn both<A, B>(first: Result<A, Faults>, second: Result<B, Faults>) -> Result<(A, B), Faults> {
    match (first, second) {
        (Ok(first), Ok(second)) => Ok((first, second)),
        (first, second) => {
            let mut faults = first.err().unwrap_or_default();
            faults.merge(second.err().unwrap_or_default());
            Err(faults)
        }
    }
}
