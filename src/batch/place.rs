//! Moves a finished file to its place: whole or not at all, and never over a file of other origin.

use std::cell::LazyCell;
use std::fs::{self, File};
use std::io::{self, Write};

use tempfile::NamedTempFile;

use super::fault::OutputFault;
use super::folder::OutputFolder;
use super::in_place::is_in_place;
use super::record::{FileRecord, LevelRecord};
use super::sources::{Sources, Written, manifest_paths};
use super::state::{RESULT_PREFIX, create_folder, find_runs, lock_state, state_folder};
use crate::disk::file_hash;
use crate::disk::{new_temporary, open_inside};

/// How often a file may appear or vanish while it is placed, before it counts as one of another program.
const ATTEMPTS: usize = 5;

/// Bytes of one write. Linux caches what is written at once in pages as large, and large pages it has to clear, or a virtual
/// machine to ask its host for: files of 2.6 MB take five times as long in one write (Linux 6.18, ext4).
const WRITTEN_AT_ONCE: usize = 256 << 10;

/// A result that waits under a temporary name.
struct Waiting<'a> {
    file: &'a FileRecord,
    temporary: NamedTempFile,
}

/// The state of the place where a result goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Standing {
    Nothing,
    /// The very result.
    Same,
    /// A file that may be replaced: one of this program, or any by force.
    Replaceable,
}

impl OutputFolder {
    /// Writes a file under its final name.
    ///
    /// A file with the same content is left untouched. A file with other content is replaced if we wrote
    /// that content, or if the folder was opened by force.
    ///
    /// # Errors
    /// [`super::fault::FaultCode::ForeignFile`] for content of other origin; else what the system says. Nothing is
    /// left half written.
    pub(crate) fn place(&self, file: &FileRecord, bytes: &[u8]) -> Result<(), OutputFault> {
        let mut waiting = self.write_temporary(file, bytes)?;
        for _ in 0..ATTEMPTS {
            match self.standing(file, None)? {
                Standing::Same => return Ok(()),
                Standing::Replaceable => return self.put(waiting),
                Standing::Nothing => match self.put_where_nothing_is(waiting)? {
                    None => return Ok(()),
                    // Somebody was faster: look again.
                    Some(back) => waiting = back,
                },
            }
        }
        Err(OutputFault::foreign(&self.root.join(&file.path)))
    }

    /// Writes the files of a level, the one to open first. Where there are several, those of one run stand there, although
    /// others write the same level at the same time; and the one to open never refers to what is not there, whenever
    /// this process is killed.
    ///
    /// # Errors
    /// As [`OutputFolder::place`].
    pub(crate) fn place_level(&self, files: &[(FileRecord, Vec<u8>)]) -> Result<(), OutputFault> {
        if let [(file, bytes)] = files {
            return self.place(file, bytes);
        }
        let waiting = self.write_temporaries(files)?;
        let lock = lock_state(&state_folder(&self.root))?;
        self.put_all(waiting, &lock)
    }

    /// As [`OutputFolder::place_level`], where the short lock is held already.
    ///
    /// # Errors
    /// As [`OutputFolder::place`].
    pub(crate) fn place_all(&self, files: &[(FileRecord, Vec<u8>)], lock: &File) -> Result<(), OutputFault> {
        self.put_all(self.write_temporaries(files)?, lock)
    }

    fn write_temporaries<'a>(
        &self,
        files: &'a [(FileRecord, Vec<u8>)],
    ) -> Result<Vec<Waiting<'a>>, OutputFault> {
        files.iter().map(|(file, bytes)| self.write_temporary(file, bytes)).collect()
    }

    fn put_all(&self, waiting: Vec<Waiting<'_>>, lock: &File) -> Result<(), OutputFault> {
        // Everything is looked at before anything is changed.
        let standing = waiting.iter().map(|waiting| self.standing(waiting.file, Some(lock)));
        let standing: Vec<Standing> = standing.collect::<Result<_, _>>()?;
        let changes_a_part = standing.iter().skip(1).any(|standing| *standing != Standing::Same);
        if let (Some(Standing::Replaceable), Some(first)) = (standing.first(), waiting.first())
            && changes_a_part
        {
            let main = self.root.join(&first.file.path);
            fs::remove_file(&main).map_err(|error| OutputFault::of(&main, "replace the file", &error))?;
        }
        let changed =
            waiting.into_iter().zip(standing).rev().filter(|(_, standing)| *standing != Standing::Same);
        changed.map(|(waiting, _)| waiting).try_for_each(|waiting| self.put(waiting))
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

    fn write_temporary<'a>(&self, file: &'a FileRecord, bytes: &[u8]) -> Result<Waiting<'a>, OutputFault> {
        let write = || -> io::Result<NamedTempFile> {
            let mut temporary = new_temporary(&self.run, RESULT_PREFIX)?;
            bytes.chunks(WRITTEN_AT_ONCE).try_for_each(|part| temporary.write_all(part))?;
            Ok(temporary)
        };
        let fault = |error| OutputFault::of(&self.root.join(&file.path), "write the file", &error);
        Ok(Waiting { file, temporary: write().map_err(fault)? })
    }

    /// The state of the place where a file goes; `lock` is the short lock, where this thread holds it.
    ///
    /// # Errors
    /// [`super::fault::FaultCode::ForeignFile`] for what may not be replaced, [`super::fault::FaultCode::WrongKind`] for links on the way and folders.
    fn standing(&self, file: &FileRecord, lock: Option<&File>) -> Result<Standing, OutputFault> {
        let target = self.root.join(&file.path);
        let (opened, found) = match open_inside(&self.root, &file.path) {
            Ok(None) => return Ok(Standing::Nothing),
            Ok(Some(found)) => found,
            Err(error) => return Err(OutputFault::of(&target, "write the file", &error)),
        };
        // A file of another length than any content of this program is not read: it may be of any size.
        let hash = LazyCell::new(|| file_hash(opened).unwrap_or_default());
        let is_one = |bytes: u64, sha256: &str| bytes == found.len() && *hash == sha256;
        if is_one(file.bytes, &file.sha256) {
            return Ok(Standing::Same);
        }
        let is_known = |written: &Written| {
            let contents = written.get(&file.path).into_iter().flatten();
            contents.into_iter().any(|content| is_one(content.bytes, &content.sha256))
        };
        if self.is_forced || is_known(&self.known.written) || is_known(&self.written_beside(lock)?) {
            return Ok(Standing::Replaceable);
        }
        Err(OutputFault::foreign(&target))
    }

    /// Renames a result into place, over whatever is there.
    fn put(&self, waiting: Waiting<'_>) -> Result<(), OutputFault> {
        let target = self.root.join(&waiting.file.path);
        target.parent().map_or(Ok(()), create_folder)?;
        let fault =
            |failed: tempfile::PersistError| OutputFault::of(&target, "write the file", &failed.error);
        waiting.temporary.persist(&target).map(drop).map_err(fault)
    }

    /// Renames a result into place; gives it back if something is there by now.
    fn put_where_nothing_is<'a>(&self, waiting: Waiting<'a>) -> Result<Option<Waiting<'a>>, OutputFault> {
        let Waiting { file, temporary } = waiting;
        let target = self.root.join(&file.path);
        target.parent().map_or(Ok(()), create_folder)?;
        match temporary.persist_noclobber(&target) {
            Ok(_) => Ok(None),
            Err(failed) if failed.error.kind() == io::ErrorKind::AlreadyExists => {
                Ok(Some(Waiting { file, temporary: failed.file }))
            }
            Err(failed) => Err(OutputFault::of(&target, "write the file", &failed.error)),
        }
    }

    /// The files that this run and those beside it have written so far.
    fn written_beside(&self, lock: Option<&File>) -> Result<Written, OutputFault> {
        let state = state_folder(&self.root);
        let _lock = if lock.is_some() { None } else { Some(lock_state(&state)?) };
        let runs = find_runs(&state, Some(&self.run))?;
        let sources = Sources::read(&manifest_paths(&self.root)?, &runs.journals())?;
        Ok(sources.contents(self.is_forced)?.written)
    }
}
