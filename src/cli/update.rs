//! Changes a file that other processes may change at the same time, without losing their changes.

use std::fs::File;
use std::io::ErrorKind;
use std::path::Path;

use super::files::{Overwrite, write_text};
use crate::disk::ignore_unsupported;
use crate::document::{Fault, Faults};

/// How often others may be faster before something must be wrong.
const ATTEMPTS: usize = 1000;

/// Writes what `change` makes of a file, which it reads anew each time that it is asked; the file need not be there yet.
///
/// A process that changes the file holds a lock on it. As a change renames a new file into its place, the lock that somebody waited
/// for may be on the old one: then the turn begins again.
///
/// # Errors
/// Those of `change`, and if the file cannot be read or written.
pub(super) fn update_text(path: &Path, change: impl Fn() -> Result<String, Faults>) -> Result<(), Faults> {
    let fault = |error: std::io::Error| Fault::of_file(path, format!("cannot be changed: {error}"));
    for _ in 0..ATTEMPTS {
        if path.symlink_metadata().is_err() {
            match write_text(path, &change()?, Overwrite::Nothing) {
                Err(_) if path.exists() => continue,
                written => return written,
            }
        }
        if path.metadata().is_ok_and(|found| !found.is_file()) {
            return Err(Fault::of_file(path, "is no file")
                .with_hint("name another file with --edits")
                .into());
        }
        let file = match File::open(path) {
            Ok(file) => file,
            // It went just now.
            Err(error) if error.kind() == ErrorKind::NotFound && !path.is_symlink() => continue,
            Err(_) => return write_text(path, &change()?, Overwrite::All),
        };
        ignore_unsupported(file.lock()).map_err(fault)?;
        if is_at(&file, path) {
            return write_text(path, &change()?, Overwrite::All);
        }
    }
    Err(Fault::of_file(path, "is being changed by other processes").with_hint("try again later").into())
}

/// Whether an open file is the one that a path names by now.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |found: std::fs::Metadata| (found.dev(), found.ino());
    let (opened, named) = (file.metadata().map(identity), path.metadata().map(identity));
    opened.ok().zip(named.ok()).is_some_and(|(opened, named)| opened == named)
}

/// Elsewhere an open file cannot be replaced.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}
