//! Reads regular files up to a number of bytes.

use std::fs::{self, File, FileType, Metadata};
use std::io::{self, Read};
use std::path::Path;

/// Reads a regular file, or one that a link leads to.
///
/// # Errors
/// Those of the system; [`io::ErrorKind::InvalidInput`] for folders, pipes and devices, [`io::ErrorKind::FileTooLarge`] for
/// more bytes than `most`, of which none is read then.
pub(crate) fn read_regular(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let (file, found) = open_regular(path)?;
    read_bounded(file, found.len(), most)
}

/// As [`read_regular`], but a link is an error too.
///
/// # Errors
/// As [`read_regular`].
pub(crate) fn read_plain(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let (file, found) = open_plain(path)?;
    read_bounded(file, found.len(), most)
}

/// As [`open_regular`], but a link is an error too.
///
/// # Errors
/// As [`read_regular`].
pub(crate) fn open_plain(path: &Path) -> io::Result<(File, Metadata)> {
    open_found(path, &fs::symlink_metadata(path)?)
}

/// Opens a regular file, or one that a link leads to.
///
/// # Errors
/// As [`read_regular`].
pub(crate) fn open_regular(path: &Path) -> io::Result<(File, Metadata)> {
    open_found(path, &fs::metadata(path)?)
}

/// Opens what a look has found, if it is a regular file.
pub(super) fn open_found(path: &Path, found: &Metadata) -> io::Result<(File, Metadata)> {
    refuse_unless_file(found.file_type())?;
    let file = File::open(path)?;
    let opened = file.metadata()?;
    refuse_unless_file(opened.file_type())?;
    Ok((file, opened))
}

pub(super) fn read_bounded(file: impl Read, length: u64, most: u64) -> io::Result<Vec<u8>> {
    let too_large = |length: u64| {
        let message = format!("it has {} MB, {} MB are the most that is read", length >> 20, most >> 20);
        io::Error::new(io::ErrorKind::FileTooLarge, message)
    };
    if length > most {
        return Err(too_large(length));
    }
    let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or(0));
    // A file may grow while it is read.
    file.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(too_large(bytes.len() as u64)) } else { Ok(bytes) }
}

/// # Errors
/// [`io::ErrorKind::InvalidInput`], which says what is there in place of a file.
pub(super) fn refuse_unless_file(kind: FileType) -> io::Result<()> {
    if kind.is_file() { Ok(()) } else { Err(not_a_file(kind)) }
}

/// Says what is there.
pub(super) fn not_a_file(kind: FileType) -> io::Error {
    let what = if kind.is_dir() {
        "a folder"
    } else if kind.is_symlink() {
        "a link"
    } else {
        "a pipe or device"
    };
    io::Error::new(io::ErrorKind::InvalidInput, format!("it is {what}, not a file"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_is_read_than_was_asked_for() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "12345").unwrap();
        assert_eq!(read_regular(&path, 5).unwrap(), b"12345");
        assert_eq!(read_regular(&path, 4).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        // Sparse: to read it would take minutes and all memory.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        assert_eq!(read_regular(&path, 1 << 30).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
    }

    #[test]
    #[cfg(unix)]
    fn folders_devices_and_links_are_rejected() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link, endless] = ["file", "link", "endless"].map(|name| folder.path().join(name));
        fs::write(&file, "1").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        std::os::unix::fs::symlink("/dev/zero", &endless).unwrap();
        assert_eq!(read_regular(&link, 9).unwrap(), b"1");
        assert!(read_plain(&link, 9).unwrap_err().to_string().contains("a link"));
        assert!(read_regular(&endless, 9).unwrap_err().to_string().contains("device"));
        assert!(read_regular(folder.path(), 9).unwrap_err().to_string().contains("a folder"));
    }
}
