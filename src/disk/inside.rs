//! Opens files below a folder by relative paths with `/`, and rejects links on the way.

use std::fs::{self, File, Metadata};
use std::io;
use std::path::Path;

use super::regular::{not_a_file, open_found, refuse_unless_file};

/// Looks for a regular file; `None` where nothing is. The folder itself may be reached by links.
///
/// # Errors
/// Those of the system; [`io::ErrorKind::InvalidInput`] for a path that leads out of the folder, a link on the way, and
/// anything but a regular file at its end.
pub(crate) fn look_inside(folder: &Path, path: &str) -> io::Result<Option<Metadata>> {
    if let Some(step) = stray_step(path) {
        let message = format!("its step \"{step}\" leads out of the folder");
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    }
    let mut place = folder.to_owned();
    let mut steps = path.split('/').peekable();
    while let Some(step) = steps.next() {
        place.push(step);
        let found = match fs::symlink_metadata(&place) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(error),
        };
        if steps.peek().is_none() {
            refuse_unless_file(found.file_type())?;
            return Ok(Some(found));
        }
        if !found.is_dir() {
            return Err(in_the_way(&place, &found));
        }
    }
    Ok(None)
}

/// As [`look_inside`], and opens the file.
///
/// # Errors
/// As [`look_inside`].
pub(crate) fn open_inside(folder: &Path, path: &str) -> io::Result<Option<(File, Metadata)>> {
    let Some(found) = look_inside(folder, path)? else { return Ok(None) };
    open_found(&folder.join(path), &found).map(Some)
}

/// The first step of a relative path that is no plain name: empty, `.`, `..`, a drive, or with a separator of some system.
pub(crate) fn stray_step(path: &str) -> Option<&str> {
    let is_plain = |step: &&str| {
        !matches!(*step, "" | "." | "..") && !step.contains(['\\', ':']) && !step.contains(char::is_control)
    };
    path.split('/').find(|step| !is_plain(step))
}

fn in_the_way(place: &Path, found: &Metadata) -> io::Error {
    let kind = found.file_type();
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    if kind.is_file() {
        return io::Error::new(io::ErrorKind::NotADirectory, format!("\"{name}\" on the way is a file"));
    }
    let message = format!("\"{name}\" on the way is no folder: {}", not_a_file(kind));
    io::Error::new(io::ErrorKind::InvalidInput, message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_that_leave_the_folder_are_found() {
        for path in ["", "/etc/hosts", "../a", "a/../../b", "a//b", "./a", "C:/a", "a\\..\\b", "a/\0", "a/"] {
            assert!(stray_step(path).is_some(), "{path:?}");
            assert!(look_inside(Path::new("."), path).is_err(), "{path:?}");
        }
        assert_eq!(stray_step("a b/c..d/.e"), None);
    }

    #[test]
    #[cfg(unix)]
    fn links_are_not_followed() {
        use std::os::unix::fs::symlink;
        let world = tempfile::tempdir().unwrap();
        let [inside, outside] = ["inside", "outside"].map(|name| world.path().join(name));
        for folder in [&inside, &outside] {
            fs::create_dir(folder).unwrap();
            fs::write(folder.join("file"), "1").unwrap();
        }
        symlink(&outside, inside.join("folder")).unwrap();
        symlink(outside.join("file"), inside.join("link")).unwrap();
        symlink(&inside, world.path().join("root")).unwrap();
        assert!(look_inside(&inside, "folder/file").unwrap_err().to_string().contains("a link"));
        assert!(open_inside(&inside, "link").unwrap_err().to_string().contains("a link"));
        assert!(open_inside(&world.path().join("root"), "file").unwrap().is_some());
        assert!(look_inside(&inside, "nothing/here").unwrap().is_none());
        assert!(look_inside(&inside, "file/here").is_err());
    }
}
