//! Temporary files: written beside their place, then renamed to it or removed.
//!
//! A killed process leaves its temporary file behind. A living one holds a lock on it, so that later runs know which
//! files nobody will finish.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempDir};

use super::lock::{Holder, holder, ignore_unsupported};

/// Letters and digits that a temporary name ends with.
const LETTERS: usize = 6;

/// How often a file may be swept away before it is locked.
const ATTEMPTS: usize = 5;

/// A temporary file that gets the rights of any new file, not those of a secret.
///
/// # Errors
/// If the folder cannot be written.
pub(crate) fn new_temporary(folder: &Path, prefix: &str) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix).rand_bytes(LETTERS);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    for _ in 0..ATTEMPTS {
        let file = builder.tempfile_in(folder)?;
        ignore_unsupported(file.as_file().lock())?;
        if file.path().symlink_metadata().is_ok() {
            return Ok(file);
        }
    }
    Err(io::Error::other("temporary files are removed as soon as they are there"))
}

/// Deletes the temporary files of a prefix whose processes have ended. What cannot be deleted stays.
pub(crate) fn sweep_temporaries(folder: &Path, prefix: &str) {
    for path in temporaries(folder, prefix) {
        // Held until it is deleted: see `new_temporary`.
        if let Ok(file) = File::open(&path)
            && holder(&file) == Holder::Gone
        {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Deletes all temporary files of a prefix. What cannot be deleted stays.
pub(crate) fn remove_temporaries(folder: &Path, prefix: &str) {
    for path in temporaries(folder, prefix) {
        let _ = fs::remove_file(path);
    }
}

/// The locked file in a temporary folder.
const ALIVE_NAME: &str = ".roomwright-alive";

/// A folder that goes with all that is in it when this is dropped.
#[derive(Debug)]
pub(crate) struct TemporaryFolder {
    // Dropped first: some systems remove no open file.
    _alive: File,
    folder: TempDir,
}

impl TemporaryFolder {
    /// Creates one, after it has removed those of its prefix that killed processes have left.
    ///
    /// # Errors
    /// If `root` cannot be written.
    pub(crate) fn new(root: &Path, prefix: &str) -> io::Result<Self> {
        sweep_folders(root, prefix);
        for _ in 0..ATTEMPTS {
            let folder = tempfile::Builder::new().prefix(prefix).rand_bytes(LETTERS).tempdir_in(root)?;
            let alive = File::create_new(folder.path().join(ALIVE_NAME))?;
            ignore_unsupported(alive.lock())?;
            if folder.path().join(ALIVE_NAME).symlink_metadata().is_ok() {
                return Ok(Self { _alive: alive, folder });
            }
        }
        Err(io::Error::other("temporary folders are removed as soon as they are there"))
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        remove_content(self.path());
    }
}

/// Deletes all in a temporary folder but the locked file: a process that is killed meanwhile leaves a folder that is still
/// known as one of ours. What cannot be deleted stays.
fn remove_content(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().filter_map(io::Result::ok) {
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        let _ = match entry.file_name() == ALIVE_NAME {
            true => Ok(()),
            false if is_folder => fs::remove_dir_all(entry.path()),
            false => fs::remove_file(entry.path()),
        };
    }
}

/// Deletes the temporary folders of a prefix whose processes have ended. A folder without the locked file is not one of this program.
fn sweep_folders(root: &Path, prefix: &str) {
    for folder in entries(root, prefix, |kind| kind.is_dir()) {
        let alive = folder.join(ALIVE_NAME);
        let is_file = fs::symlink_metadata(&alive).is_ok_and(|found| found.is_file());
        if is_file
            && let Ok(file) = File::open(&alive)
            && holder(&file) == Holder::Gone
        {
            remove_content(&folder);
            let _ = fs::remove_dir_all(&folder);
        }
    }
}

/// Plain files with a name that [`new_temporary`] gives.
fn temporaries(folder: &Path, prefix: &str) -> Vec<PathBuf> {
    entries(folder, prefix, |kind| kind.is_file())
}

/// The entries of a kind with a temporary name.
fn entries(folder: &Path, prefix: &str, is_kind: impl Fn(fs::FileType) -> bool) -> Vec<PathBuf> {
    let is_ending =
        |rest: &str| rest.len() == LETTERS && rest.bytes().all(|byte| byte.is_ascii_alphanumeric());
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(io::Result::ok);
    let ours = entries.filter(|entry| {
        let name = entry.file_name();
        name.to_str().and_then(|name| name.strip_prefix(prefix)).is_some_and(is_ending)
            && entry.file_type().is_ok_and(&is_kind)
    });
    ours.map(|entry| entry.path()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_killed_processes_are_removed_and_no_others() {
        let root = tempfile::tempdir().unwrap();
        let place = |name: &str| root.path().join(name);
        for name in ["demo-a1B2c3", "demo-d4E5f6", "demo-notes"] {
            fs::create_dir(place(name)).unwrap();
            fs::write(place(name).join("plan.yaml"), "").unwrap();
        }
        fs::write(place("demo-a1B2c3").join(ALIVE_NAME), "").unwrap();
        fs::write(place("demo-notes").join(ALIVE_NAME), "").unwrap();
        let held = TemporaryFolder::new(root.path(), "demo-").unwrap();
        let own = held.path().to_owned();
        let _other = TemporaryFolder::new(root.path(), "demo-").unwrap();
        assert!(!place("demo-a1B2c3").exists() && place("demo-d4E5f6").exists() && own.exists());
        assert!(place("demo-notes").exists());
        drop(held);
        assert!(!own.exists());
    }

    #[test]
    fn files_of_killed_runs_are_removed_and_no_others() {
        let folder = tempfile::tempdir().unwrap();
        let held = new_temporary(folder.path(), "part-").unwrap();
        for name in ["part-a1B2c3", "part-notes.txt", "other-a1B2c3", "part-a1B2c"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        fs::create_dir(folder.path().join("part-folder")).unwrap();
        sweep_temporaries(folder.path(), "part-");
        assert!(held.path().exists() && !folder.path().join("part-a1B2c3").exists());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 5);
        remove_temporaries(folder.path(), "part-");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 4);
    }
}
