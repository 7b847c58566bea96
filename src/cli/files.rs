//! Writes the single files of a command: whole or not at all, never over an existing file unless told.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use tempfile::NamedTempFile;

use crate::disk::{new_temporary, read_regular, sweep_temporaries};
use crate::document::{Fault, Faults};

/// How files begin that are not yet in place. Hidden, so that none is taken for a result.
const TEMPORARY_PREFIX: &str = ".roomwright-";

/// The most bytes of a file that are read to see whether the program made it.
pub(super) const LARGEST_OWN: u64 = 1 << 30;

/// Which existing files may be overwritten.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Overwrite {
    /// None.
    Nothing,
    /// Files that the function recognises, by their content, as written by the program and not changed since.
    Own(fn(&[u8]) -> bool),
    /// All of them.
    All,
}

impl Overwrite {
    /// The meaning of `--force`.
    pub(crate) fn forced(is_forced: bool) -> Self {
        if is_forced { Self::All } else { Self::Nothing }
    }

    fn allows(self, path: &Path) -> bool {
        match self {
            Self::Nothing => false,
            Self::Own(is_own) => read_regular(path, LARGEST_OWN).is_ok_and(|content| is_own(&content)),
            Self::All => true,
        }
    }
}

/// Writes a text file, as [`write_bytes`].
///
/// # Errors
/// As there.
pub(crate) fn write_text(path: &Path, text: &str, overwrite: Overwrite) -> Result<(), Faults> {
    write_bytes(path, text.as_bytes(), overwrite)
}

/// Writes a file. What a link leads to is written, and the link stays.
///
/// # Errors
/// If the file exists and must not be overwritten, or cannot be written.
pub(crate) fn write_bytes(path: &Path, bytes: &[u8], overwrite: Overwrite) -> Result<(), Faults> {
    let fault = |error: &io::Error| Faults::from(not_written(path, error));
    let target = end_of_links(path)?;
    if is_stream(&target) {
        return write_stream(&target, bytes).map_err(|error| fault(&error));
    }
    let folder = target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut temporary = temporary_in(folder).map_err(|error| fault(&error))?;
    temporary.write_all(bytes).map_err(|error| fault(&error))?;
    let placed = if overwrite.allows(&target) {
        temporary.persist(&target).map(drop).map_err(|failed| failed.error)
    } else {
        temporary.persist_noclobber(&target).map(drop).map_err(|failed| failed.error)
    };
    placed.map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => exists_already(path, overwrite).into(),
        _ => fault(&error),
    })
}

/// The file that is written: if the path is a link, what it leads to.
///
/// # Errors
/// If that is not there.
fn end_of_links(path: &Path) -> Result<PathBuf, Faults> {
    if !path.is_symlink() {
        return Ok(path.to_owned());
    }
    path.canonicalize().map_err(|error| {
        let fault = Fault::of_file(path, format!("is a link that leads nowhere: {error}"));
        fault.with_hint("remove the link, or make the file that it leads to").into()
    })
}

/// Whether a path is a pipe, a terminal or another device: nothing can be renamed into its place.
fn is_stream(path: &Path) -> bool {
    path.metadata().is_ok_and(|found| !found.is_file() && !found.is_dir())
}

fn write_stream(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut stream = fs::File::options().write(true).open(path)?;
    stream.write_all(bytes)?;
    stream.flush()
}

/// Folders from which this process has removed what killed ones left.
static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A temporary file in a folder, which is created where it is missing.
fn temporary_in(folder: &Path) -> io::Result<NamedTempFile> {
    fs::create_dir_all(folder)?;
    if SWEPT.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.to_owned()) {
        sweep_temporaries(folder, TEMPORARY_PREFIX);
    }
    new_temporary(folder, TEMPORARY_PREFIX)
}

fn not_written(path: &Path, error: &io::Error) -> Fault {
    let hint = match error.kind() {
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "choose another place, or give yourself the right to write there"
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            "free some space and run the command again"
        }
        io::ErrorKind::NotADirectory | io::ErrorKind::AlreadyExists | io::ErrorKind::IsADirectory => {
            "a file has the name of a folder, or a folder that of a file: choose another path"
        }
        _ => "see the system's message, or choose another path",
    };
    Fault::of_file(path, format!("cannot write the file: {error}")).with_hint(hint)
}

fn exists_already(path: &Path, overwrite: Overwrite) -> Fault {
    if path.is_dir() {
        let hint = "name a file in it, or another one";
        return Fault::of_file(path, "is a folder, where a file is to be written").with_hint(hint);
    }
    let whose = match overwrite {
        Overwrite::Own(_) => "was not written by roomwright, or was changed since",
        Overwrite::Nothing | Overwrite::All => "exists already",
    };
    Fault::of_file(path, format!("{whose}; it is left as it is")).with_hint("overwrite it with --force")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_existing_file_is_overwritten_by_force_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new/plan.yaml");
        write_text(&path, "one", Overwrite::Nothing).unwrap();
        let refusal = write_text(&path, "two", Overwrite::Nothing).unwrap_err();
        assert!(refusal.to_string().contains("--force"));
        assert_eq!(fs::read_to_string(&path).unwrap(), "one");
        write_text(&path, "two", Overwrite::All).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1, "no temporary file stays");
    }
}
