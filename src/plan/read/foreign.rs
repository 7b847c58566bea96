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
pub(super) fn unknown_word(
    source: &Source,
    path: &[PathStep],
    format: &str,
    (word, count): (&str, usize),
) -> Fault {
    let rooms = if count == 1 { "1 room is".to_owned() } else { format!("{count} rooms are") };
    let message = format!("unknown room word \"{word}\": {rooms} taken as \"{GENERIC_ROOM_TYPE}\"");
    let hint = format!("add it under formats.{format} in a room_words.yaml of yours");
    source.fault(path, message, Some(hint), FaultSeverity::Warning)
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
