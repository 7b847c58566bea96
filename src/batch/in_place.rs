//! Checks whether the files that a record names exist.

use std::io;
use std::path::Path;

use super::record::FileRecord;
use crate::disk::file_hash;
use crate::disk::open_inside;

/// Whether the files have exactly these contents. One of another length is not read.
pub(crate) fn is_in_place(root: &Path, files: &[FileRecord]) -> bool {
    let has_content = |file: &FileRecord| -> io::Result<bool> {
        let Some((opened, found)) = open_inside(root, &file.path)? else { return Ok(false) };
        Ok(found.len() == file.bytes && file_hash(opened)? == file.sha256)
    };
    files.iter().all(|file| has_content(file).unwrap_or(false))
}
