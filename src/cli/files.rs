//! Writes single results of a command: whole or not at all, never over an existing file unless told.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use crate::document::{Fault, Faults};

/// Which existing files may be overwritten.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Overwrite {
    /// None.
    Nothing,
    /// Those of which the function says, by their content, that the program made them and nobody changed them.
    Own(fn(&[u8]) -> bool),
    /// All of them.
    All,
}

impl Overwrite {
    /// What `--force` stands for.
    pub(crate) fn forced(is_forced: bool) -> Self {
        if is_forced { Self::All } else { Self::Nothing }
    }

    fn allows(self, path: &Path) -> bool {
        match self {
            Self::Nothing => false,
            Self::Own(is_own) => fs::read(path).is_ok_and(|content| is_own(&content)),
            Self::All => true,
        }
    }
}

/// Writes a text file.
///
/// # Errors
/// If the file exists and must not be overwritten, or cannot be written.
pub(crate) fn write_text(path: &Path, text: &str, overwrite: Overwrite) -> Result<(), Faults> {
    let fault =
        |error: &io::Error| Faults::from(Fault::of_file(path, format!("cannot write the file: {error}")));
    let folder = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(|error| fault(&error))?;
    let mut temporary = crate::batch::new_result_file(folder).map_err(|error| fault(&error))?;
    temporary.write_all(text.as_bytes()).map_err(|error| fault(&error))?;
    let placed = if overwrite.allows(path) {
        temporary.persist(path).map(drop).map_err(|failed| failed.error)
    } else {
        temporary.persist_noclobber(path).map(drop).map_err(|failed| failed.error)
    };
    placed.map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => exists_already(path, overwrite).into(),
        _ => fault(&error),
    })
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
