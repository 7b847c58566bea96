//! File locks, where the file system has them.

use std::fs::{File, TryLockError};
use std::io;

/// Whether a lock is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holder {
    /// A living process.
    Living,
    /// Nobody: its process has ended.
    Gone,
    /// The file system has no locks.
    Unknown,
}

/// Some network file systems have no locks; there, bakes must not run at the same time in one folder.
///
/// # Errors
/// Everything but the absence of locks.
pub(crate) fn ignore_unsupported(result: io::Result<()>) -> io::Result<()> {
    match result {
        Err(error) if lacks_locks(&error) => Ok(()),
        other => other,
    }
}

/// Whether the lock on a file is held, as far as the file system knows.
pub(crate) fn holder(file: &File) -> Holder {
    match file.try_lock() {
        Ok(()) => Holder::Gone,
        Err(TryLockError::WouldBlock) => Holder::Living,
        Err(TryLockError::Error(_)) => Holder::Unknown,
    }
}

/// ENOLCK, which the standard library has no kind for: NFS without its lock service gives it.
const NO_LOCKS_AVAILABLE: i32 = if cfg!(target_os = "linux") { 37 } else { 77 };

fn lacks_locks(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::Unsupported
        || (cfg!(unix) && error.raw_os_error() == Some(NO_LOCKS_AVAILABLE))
}
