//! Faults of the output folder and of single levels.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::document::printable;

/// Something about the output that stopped the run or one level of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFault {
    /// A stable word for the kind, for counting.
    pub code: FaultCode,
    /// The file or folder.
    pub path: PathBuf,
    /// The fact.
    pub message: String,
    /// Advice for the user.
    pub hint: Option<String>,
}

/// The kinds of [`OutputFault`] and [`super::LevelFailure`]; the words are stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultCode {
    /// A file stands where a folder should be, or the other way round.
    WrongKind,
    /// No right to write.
    NoRights,
    /// No space left.
    DiskFull,
    /// Something of other origin stands where a file should go.
    ForeignFile,
    /// Any other fault of the file system.
    WriteFailed,
    /// A merge of a folder that no bake has written into.
    NothingToJoin,
    /// Levels that were chosen are not in the plan, or are made from other inputs.
    OtherLevels,
    /// The level does not fit into the format.
    TooLarge,
    /// The system starts no more threads.
    NoThreads,
    /// The program failed while it furnished a room: a fault of the program.
    RoomBroken,
    /// The program failed while it built a level: a fault of the program.
    LevelBroken,
}

impl FaultCode {
    /// The word in messages and JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::WrongKind => "wrong_kind",
            Self::NoRights => "no_rights",
            Self::DiskFull => "disk_full",
            Self::ForeignFile => "foreign_file",
            Self::WriteFailed => "write_failed",
            Self::NothingToJoin => "nothing_to_join",
            Self::OtherLevels => "other_levels",
            Self::TooLarge => "too_large",
            Self::NoThreads => "no_threads",
            Self::RoomBroken => "room_broken",
            Self::LevelBroken => "level_broken",
        }
    }

    /// Whether every further level would meet the same fault.
    #[must_use]
    pub fn stops_the_run(self) -> bool {
        self == Self::DiskFull
    }
}

impl OutputFault {
    /// A fault that the system reported during `action` (`create the folder`) on `path`.
    pub(crate) fn of(path: &Path, action: &str, error: &io::Error) -> Self {
        let (code, hint) = match error.kind() {
            io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
                (FaultCode::NoRights, "choose another folder with --out, or give yourself the right to write")
            }
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => (
                FaultCode::DiskFull,
                "free some space and run the same command again: it goes on where it stopped",
            ),
            io::ErrorKind::NotADirectory | io::ErrorKind::AlreadyExists | io::ErrorKind::IsADirectory => {
                (FaultCode::WrongKind, "a file or folder of that name is in the way; choose another --out")
            }
            // The error of `disk` for links, pipes and devices.
            io::ErrorKind::InvalidInput => (
                FaultCode::WrongKind,
                "links, pipes and devices in the output folder are not followed; remove it, or choose another --out",
            ),
            io::ErrorKind::FileTooLarge => (
                FaultCode::WriteFailed,
                "the system lets no file become so large; see `ulimit -f` and the file system",
            ),
            _ => (FaultCode::WriteFailed, "see the system's message"),
        };
        let message = format!("cannot {action}: {error}");
        Self { code, path: path.to_owned(), message, hint: Some(hint.to_owned()) }
    }

    /// A file that this program did not write.
    pub(crate) fn foreign(path: &Path) -> Self {
        Self {
            code: FaultCode::ForeignFile,
            path: path.to_owned(),
            message: "was not written by roomwright, or was changed since; it is left as it is".to_owned(),
            hint: Some("move it away, or overwrite such files with --force".to_owned()),
        }
    }
}

impl fmt::Display for OutputFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", printable(&self.path.display().to_string()), self.message)
    }
}

impl std::error::Error for OutputFault {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_and_missing_rights_have_messages_of_their_own() {
        let full = OutputFault::of(Path::new("out/a.glb"), "write", &io::ErrorKind::StorageFull.into());
        assert!(full.code.stops_the_run() && full.hint.unwrap().contains("run the same command again"));
        let closed = OutputFault::of(Path::new("out"), "create", &io::ErrorKind::PermissionDenied.into());
        assert_eq!(closed.code, FaultCode::NoRights);
        assert!(!closed.code.stops_the_run());
    }

    #[test]
    fn the_refusal_names_the_flag() {
        assert!(OutputFault::foreign(Path::new("x")).hint.unwrap().contains("--force"));
    }
}
