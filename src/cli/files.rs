//! Writes single results of a command: whole or not at all, never over an existing file unless told.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use crate::document::{Fault, Faults};

/// Writes a text file.
///
/// # Errors
/// If the file exists and `is_forced` is not set, or cannot be written.
pub(crate) fn write_text(path: &Path, text: &str, is_forced: bool) -> Result<(), Faults> {
    let fault =
        |error: &io::Error| Faults::from(Fault::of_file(path, format!("cannot write the file: {error}")));
    let folder = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(|error| fault(&error))?;
    let mut temporary = crate::batch::new_result_file(folder).map_err(|error| fault(&error))?;
    temporary.write_all(text.as_bytes()).map_err(|error| fault(&error))?;
    let placed = if is_forced {
        temporary.persist(path).map(drop).map_err(|failed| failed.error)
    } else {
        temporary.persist_noclobber(path).map(drop).map_err(|failed| failed.error)
    };
    placed.map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => Fault::of_file(path, "exists already; it is left as it is")
            .with_hint("overwrite it with --force")
            .into(),
        _ => fault(&error),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_existing_file_is_overwritten_by_force_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new/plan.yaml");
        write_text(&path, "one", false).unwrap();
        let refusal = write_text(&path, "two", false).unwrap_err();
        assert!(refusal.to_string().contains("--force"));
        assert_eq!(fs::read_to_string(&path).unwrap(), "one");
        write_text(&path, "two", true).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1, "no temporary file stays");
    }
}
