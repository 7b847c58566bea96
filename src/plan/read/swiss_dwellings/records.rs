//! The records of a table, one after the other, however large the file is.

use std::cell::Cell;
use std::io::{self, Read};
use std::path::Path;
use std::rc::Rc;

use csv::{ByteRecord, Reader, ReaderBuilder};

use crate::disk::open_unpacked;
use crate::document::{Fault, Faults};

/// Bytes of the longest record: a floor of a hundred thousand corners is a tenth of it. What is longer has a quote that is not
/// closed, and would be the whole rest of the file.
const LONGEST_RECORD: u64 = 16 << 20;

/// A table that is read from its beginning to its end. Nothing but the current record is in memory.
pub(super) struct Records {
    reader: Reader<Bounded>,
    /// Bytes that may be read before the next record ends.
    allowance: Rc<Cell<u64>>,
}

impl Records {
    /// Opens a table and reads its first record, the names of the columns.
    ///
    /// # Errors
    /// If the file cannot be opened or has no record.
    pub(super) fn open(path: &Path) -> Result<(Self, ByteRecord), Faults> {
        let unreadable =
            |error: io::Error| Faults::from(Fault::of_file(path, format!("cannot be read: {error}")));
        let (file, _) = open_unpacked(path).map_err(unreadable)?;
        let allowance = Rc::new(Cell::new(LONGEST_RECORD));
        let bounded = Bounded { file, allowance: Rc::clone(&allowance) };
        // Rows of other lengths are faults with a line, not the end of the file.
        let reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(bounded);
        let mut records = Self { reader, allowance };
        let mut names = ByteRecord::new();
        match records.next(path, &mut names) {
            Ok(true) => Ok((records, names)),
            Ok(false) => Err(Fault::of_file(path, "the table is empty").into()),
            Err(fault) => Err(fault.into()),
        }
    }

    /// Reads the next record into `record`; whether there was one.
    ///
    /// # Errors
    /// Why nothing can be read from here on.
    pub(super) fn next(&mut self, path: &Path, record: &mut ByteRecord) -> Result<bool, Fault> {
        self.allowance.set(LONGEST_RECORD);
        self.reader.read_byte_record(record).map_err(|error| {
            let line = usize::try_from(self.reader.position().line()).unwrap_or(usize::MAX);
            let fault = Fault { position: Some((line, 1)), ..Fault::of_file(path, error.to_string()) };
            fault.with_hint("rows before this one are read; mend it, or cut the file off here")
        })
    }
}

/// The line of a record, from 1.
pub(super) fn line_of(record: &ByteRecord) -> usize {
    record.position().map_or(1, |place| usize::try_from(place.line()).unwrap_or(usize::MAX))
}

/// A file of which no record may be longer than [`LONGEST_RECORD`].
struct Bounded {
    file: Box<dyn Read>,
    allowance: Rc<Cell<u64>>,
}

impl Read for Bounded {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.file.read(buffer)?;
        let rest = self.allowance.get().checked_sub(count as u64).ok_or_else(|| {
            let message =
                format!("a row does not end within {} MB: is a quote not closed?", LONGEST_RECORD >> 20);
            io::Error::new(io::ErrorKind::InvalidData, message)
        })?;
        self.allowance.set(rest);
        Ok(count)
    }
}
