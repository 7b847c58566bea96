//! Puts a file into place: whole or not at all, and never over something of other origin.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use super::fault::OutputFault;
use super::folder::{OutputFolder, create_folder, find_runs, lock_state, state_folder};
use super::hash::content_hash;
use super::join::is_in_place;
use super::record::{FileRecord, LevelRecord};
use super::sources::{Sources, manifest_paths};

/// How often a file may appear or vanish under our hands before we give up.
const ATTEMPTS: usize = 5;

impl OutputFolder {
    /// Writes a file under its final name.
    ///
    /// A file with the same content is left untouched. A file with other content is replaced if we wrote
    /// that content, or if the folder was opened by force.
    ///
    /// # Errors
    /// [`super::FaultCode::ForeignFile`] for content of other origin; else what the system says. Nothing is
    /// left half written.
    pub(crate) fn place(&self, file: &FileRecord, bytes: &[u8]) -> Result<(), OutputFault> {
        let target = self.root.join(&file.path);
        let fault = |error| OutputFault::of(&target, "write the file", &error);
        let mut temporary = self.write_temporary(bytes).map_err(fault)?;
        for _ in 0..ATTEMPTS {
            if let Some(found) = read_if_present(&target).map_err(fault)? {
                let found = content_hash(&found);
                if found == file.sha256 {
                    return Ok(());
                }
                if !self.is_forced && !self.is_ours(&file.path, &found)? {
                    return Err(OutputFault::foreign(&target));
                }
                return temporary.persist(&target).map(drop).map_err(|failed| fault(failed.error));
            }
            match temporary.persist_noclobber(&target) {
                Ok(_) => return Ok(()),
                Err(failed) => temporary = failed.file,
            }
            if let Some(folder) = target.parent() {
                create_folder(folder)?;
            }
        }
        temporary.persist_noclobber(&target).map(drop).map_err(|failed| fault(failed.error))
    }

    /// Deletes the files that the level's earlier record names and the new one does not (another format,
    /// another name), if they still have the content that was recorded.
    ///
    /// # Errors
    /// If a file cannot be deleted.
    pub(crate) fn retire_replaced(&self, record: &LevelRecord) -> Result<(), OutputFault> {
        let Some((_, known)) = self.known.levels.get(&record.key()) else { return Ok(()) };
        let is_replaced = |file: &&FileRecord| record.files.iter().all(|new| new.path != file.path);
        for file in known.files.iter().filter(is_replaced) {
            if is_in_place(&self.root, std::slice::from_ref(file)) {
                let path = self.root.join(&file.path);
                fs::remove_file(&path).map_err(|error| OutputFault::of(&path, "delete the file", &error))?;
            }
        }
        Ok(())
    }

    fn write_temporary(&self, bytes: &[u8]) -> io::Result<NamedTempFile> {
        let mut temporary = new_file(&self.run, "")?;
        temporary.write_all(bytes)?;
        Ok(temporary)
    }

    /// Whether a content is of our making: of an earlier run, of this one, or of one beside us.
    fn is_ours(&self, path: &str, sha256: &str) -> Result<bool, OutputFault> {
        if self.known.written.get(path).is_some_and(|hashes| hashes.contains(sha256)) {
            return Ok(true);
        }
        let state = state_folder(&self.root);
        let _lock = lock_state(&state)?;
        let runs = find_runs(&state)?;
        let sources = Sources::read(&manifest_paths(&self.root)?, &runs.journals())?;
        let written = sources.contents(self.is_forced)?.written;
        Ok(written.get(path).is_some_and(|hashes| hashes.contains(sha256)))
    }
}

/// A temporary file that gets the rights of any new file, not those of a secret.
pub(crate) fn new_file(folder: &Path, prefix: &str) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

/// A temporary file that becomes a result when it is persisted, and vanishes if not.
///
/// # Errors
/// If the folder cannot be written.
pub(crate) fn new_result_file(folder: &Path) -> io::Result<NamedTempFile> {
    new_file(folder, ".roomwright-")
}

fn read_if_present(path: &Path) -> io::Result<Option<Vec<u8>>> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}
