//! Files that are packed with gzip (RFC 1952), as tiles of cities are often offered: they are read as what they hold.

use std::fs::Metadata;
use std::io::{self, Cursor, Read};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use super::regular::{open_regular, read_bounded};

/// The ending of packed files.
const ENDING: &str = "gz";
/// The first bytes of packed files (RFC 1952, section 2.3.1).
const MAGIC: [u8; 2] = [0x1f, 0x8b];

/// The name that a file has unpacked: `tile.city.json` for `tile.city.json.gz`. Format and id of a file go by it.
pub(crate) fn unpacked_name(path: &Path) -> &Path {
    let is_packed = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(ENDING));
    path.file_stem().filter(|_| is_packed).map_or(path, Path::new)
}

/// Opens a regular file, or one that a link leads to; of a packed file, to read what it holds. The metadata are those of the file.
///
/// # Errors
/// As [`super::read_regular`]. Damage of a packed file is an error of the one who reads.
pub(crate) fn open_unpacked(path: &Path) -> io::Result<(Box<dyn Read>, Metadata)> {
    let (mut file, found) = open_regular(path)?;
    let mut start = Vec::new();
    file.by_ref().take(MAGIC.len() as u64).read_to_end(&mut start)?;
    let is_packed = start == MAGIC;
    let whole = Cursor::new(start).chain(file);
    Ok((if is_packed { Box::new(MultiGzDecoder::new(whole)) } else { Box::new(whole) }, found))
}

/// The bytes of a file; of a packed file, of what it holds.
///
/// # Errors
/// As [`super::read_regular`]; of a packed file, `most` goes for what it holds, of which no more is unpacked.
pub(crate) fn read_unpacked(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let (file, found) = open_unpacked(path)?;
    read_bounded(file, found.len(), most)
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::{Compression, write::GzEncoder};

    use super::*;

    fn packed(parts: &[&[u8]]) -> Vec<u8> {
        let pack = |part: &&[u8]| {
            let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
            encoder.write_all(part).unwrap();
            encoder.finish().unwrap()
        };
        parts.iter().flat_map(pack).collect()
    }

    fn read(bytes: &[u8], most: u64) -> io::Result<Vec<u8>> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        std::fs::write(&path, bytes).unwrap();
        read_unpacked(&path, most)
    }

    #[test]
    fn what_is_packed_is_read_as_what_it_holds() {
        for plain in [&b""[..], b"\x1f", b"{}", b"\x1f\x8c is not packed"] {
            assert_eq!(read(plain, 100).unwrap(), plain);
            assert_eq!(read(&packed(&[plain]), 100).unwrap(), plain);
        }
        // `cat one.gz other.gz` is a packed file, too.
        assert_eq!(read(&packed(&[b"{ ", b"}"]), 100).unwrap(), b"{ }");
    }

    #[test]
    fn what_is_damaged_or_swells_is_refused() {
        let whole = packed(&[&[7; 1000]]);
        assert!(whole.len() < 100);
        assert_eq!(read(&whole, 999).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        assert_eq!(read(&whole[..whole.len() - 4], 1000).unwrap_err().kind(), io::ErrorKind::UnexpectedEof);
        let mut damaged = whole.clone();
        damaged[12] ^= 0xff;
        assert!(read(&damaged, 1000).is_err());
    }

    #[test]
    fn the_ending_of_a_packed_file_is_not_that_of_its_format() {
        for (path, name) in [
            ("a/9-284-556.city.json.gz", "9-284-556.city.json"),
            ("b.GZ", "b"),
            ("a/b.json", "a/b.json"),
            (".gz", ".gz"),
        ] {
            assert_eq!(unpacked_name(Path::new(path)), Path::new(name));
        }
    }
}
