//! Edits of small rooms.

mod apply;
mod capture;
mod locks;
mod read;

use super::book::{ObjectEdit, RoomEdits};
use super::file::ObjectEntry;
use crate::document::{Fault, Source};

/// The edits of a room from lines like `table.1: {remove: true}`.
fn edits(lines: &[&str]) -> RoomEdits {
    let object = |line: &&str| {
        let (id, text) = line.split_once(": ").unwrap();
        let entry: ObjectEntry = Source::new("house.edits.yaml".as_ref(), text).parse().unwrap();
        let mark = Fault::of_file("house.edits.yaml".as_ref(), "");
        (id.to_owned(), ObjectEdit { entry, mark })
    };
    RoomEdits { seed: None, objects: lines.iter().map(object).collect() }
}
