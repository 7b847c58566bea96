//! Finds the text of a home in its ZIP archive, at bounded cost whatever the archive says of itself.

use std::cell::Cell;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use std::rc::Rc;

use zip::ZipArchive;
use zip::result::ZipError;

use crate::disk::open_regular;
use crate::document::{Fault, Faults, Source};
use crate::plan::read::foreign::head;

/// The entry that is read: the home as XML.
const XML_ENTRY: &str = "Home.xml";
/// The entry of homes of all versions, in the serialisation of Java.
const OLD_ENTRY: &str = "Home";
/// Beginning of a ZIP archive with entries.
const SIGNATURE: &[u8] = b"PK\x03\x04";
/// Bytes of the largest text of a home: one of a thousand rooms has 2 MB.
const TEXT_LIMIT: u64 = 64 << 20;
/// Bytes that are read of an archive to find its directory: that of 10,000 entries has 1 MB.
const DIRECTORY_LIMIT: u64 = 8 << 20;
/// Bytes of an entry that are read at most; deflate makes no text larger by more than a little.
const ENTRY_LIMIT: u64 = TEXT_LIMIT + (1 << 20);

/// Whether a file is a ZIP archive that holds a home, or the damaged one of a home by its name.
pub(super) fn is_archive(path: &Path) -> bool {
    if head(path, SIGNATURE.len() as u64) != SIGNATURE {
        return false;
    }
    let Ok((archive, _)) = open(path) else {
        return path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("sh3d"));
    };
    [XML_ENTRY, OLD_ENTRY].iter().any(|name| archive.index_for_name(name).is_some())
}

/// The text of a home: of a ZIP archive its entry, else the file itself.
///
/// # Errors
/// Why it cannot be read: the archive is damaged, too large when unpacked, or holds no XML.
pub(super) fn read_text(path: &Path) -> Result<Source, Faults> {
    if head(path, SIGNATURE.len() as u64) != SIGNATURE {
        return Source::read(path);
    }
    let refuse =
        |(message, hint): (String, &str)| Faults::from(Fault::of_file(path, message).with_hint(hint));
    let (mut archive, left) = open(path).map_err(|error| refuse(damage(&error)))?;
    left.set(ENTRY_LIMIT);
    if archive.index_for_name(XML_ENTRY).is_none() {
        let hint = "open it in Sweet Home 3D 5.3 or later and save it again: that adds Home.xml";
        return Err(refuse((
            format!("was saved without {XML_ENTRY}, which is what is read of a home"),
            hint,
        )));
    }
    let mut bytes = Vec::new();
    let entry = archive.by_name(XML_ENTRY).map_err(|error| refuse(damage(&error)))?;
    entry.take(TEXT_LIMIT + 1).read_to_end(&mut bytes).map_err(|error| refuse(damage(&error.into())))?;
    if bytes.len() as u64 > TEXT_LIMIT {
        let message = format!("its {XML_ENTRY} has more than {} MiB when unpacked", TEXT_LIMIT >> 20);
        return Err(refuse((message, "no home is that large; save it again in Sweet Home 3D")));
    }
    // Places in faults are those of the entry.
    let inside = path.join(XML_ENTRY);
    let text = String::from_utf8(bytes).map_err(|error| {
        let message = format!("is no text: byte {} is not UTF-8", error.utf8_error().valid_up_to());
        Faults::from(Fault::of_file(&inside, message).with_hint("save it again in Sweet Home 3D"))
    })?;
    Ok(Source::new(&inside, text.trim_start_matches('\u{feff}')))
}

/// The directory of an archive, and how many bytes more are read of it: what the directory left of its limit, until another is set.
fn open(path: &Path) -> Result<(ZipArchive<Bounded>, Rc<Cell<u64>>), ZipError> {
    let (file, _) = open_regular(path)?;
    let left = Rc::new(Cell::new(DIRECTORY_LIMIT));
    let archive = ZipArchive::new(Bounded { file, left: Rc::clone(&left) })?;
    Ok((archive, left))
}

fn damage(error: &ZipError) -> (String, &'static str) {
    (format!("is no sound ZIP archive: {error}"), "copy the file again, or save it again in Sweet Home 3D")
}

/// A file of which no more than some bytes are read.
struct Bounded {
    file: File,
    left: Rc<Cell<u64>>,
}

impl Read for Bounded {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = self.left.get();
        if left == 0 && !buffer.is_empty() {
            return Err(io::Error::new(io::ErrorKind::InvalidData, "it is larger than that of any home"));
        }
        let most = usize::try_from(left).unwrap_or(usize::MAX).min(buffer.len());
        let count = self.file.read(&mut buffer[..most])?;
        self.left.set(left - count as u64);
        Ok(count)
    }
}

impl Seek for Bounded {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}
