//! Whole files as sites: small ones by hand, and the shared maps.

mod cityjson;
mod geojson;
mod osm;
mod real_data;

use std::path::PathBuf;

use super::{ReadSite, SiteNotes, read_site};
use crate::document::Faults;
use crate::storey::Footprint;

/// A text as a file of this name in a folder that lasts as long as the answer.
fn file(name: &str, text: impl AsRef<[u8]>) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    (folder, path)
}

/// What is read of a text as a file of this name.
fn read(name: &str, text: impl AsRef<[u8]>) -> Result<ReadSite, Faults> {
    let (_folder, path) = file(name, text);
    read_site(&path)
}

fn ids(read: &ReadSite) -> Vec<&str> {
    read.site.footprints.iter().map(|footprint| footprint.id.as_str()).collect()
}

/// Everything about some footprints that a test compares.
fn shown(footprints: &[Footprint]) -> String {
    format!("{footprints:#?}")
}

/// Whether each building that the file draws is a footprint or has its place in the notes.
fn assert_accounted(read: &ReadSite) {
    let SiteNotes { drawn, duplicates, parts, split, made_of_parts, left_out, .. } = &read.notes;
    let more: usize = split.iter().map(|split| split.pieces - 1).sum();
    let of_parts = made_of_parts.len();
    let told = read.site.footprints.len() + duplicates.len() + parts.len() + left_out.len();
    assert_eq!(*drawn, told - more - of_parts, "{:?}", read.notes);
}
