//! File locks: short ones around the joining of records, long ones by which a running bake is known.

use std::fs::{File, TryLockError};
use std::io;

/// Some network file systems have no locks; there, bakes must not run at the same time in one folder.
///
/// # Errors
/// Everything but the absence of locks.
pub(crate) fn ignore_unsupported(result: io::Result<()>) -> io::Result<()> {
    match result {
        Err(error) if error.kind() == io::ErrorKind::Unsupported => Ok(()),
        other => other,
    }
}

/// Whether no living process holds the file.
pub(crate) fn is_abandoned(file: &File) -> bool {
    match file.try_lock() {
        Ok(()) => true,
        Err(TryLockError::WouldBlock) => false,
        Err(TryLockError::Error(error)) => error.kind() == io::ErrorKind::Unsupported,
    }
}
