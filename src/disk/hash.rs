//! SHA-256 of inputs and files, as other tools compute it.

use std::fs::File;
use std::io::{self, Read};

use sha2::{Digest, Sha256};

/// A SHA-256 as lower-case hexadecimal digits.
pub(crate) fn to_hex(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let digit = |nibble: u8| char::from(DIGITS[usize::from(nibble)]);
    bytes.iter().flat_map(|&byte| [digit(byte >> 4), digit(byte & 0xF)]).collect()
}

/// The hash of a file's content as the manifest shows it.
pub(crate) fn content_hash(bytes: &[u8]) -> String {
    to_hex(&Sha256::digest(bytes))
}

/// [`content_hash`] of what a file holds, however long it is, in the memory of one piece.
///
/// # Errors
/// The message of the system.
pub(crate) fn file_hash(mut file: File) -> io::Result<String> {
    const PIECE: usize = 1 << 16;
    let mut hash = Sha256::new();
    let mut piece = vec![0; PIECE];
    loop {
        match file.read(&mut piece)? {
            0 => return Ok(to_hex(&hash.finalize())),
            length => hash.update(&piece[..length]),
        }
    }
}

/// Collects fields of different lengths so that no two lists of fields look the same.
pub(crate) struct FieldHash(Sha256);

impl FieldHash {
    /// Starts a hash for one purpose.
    pub(crate) fn new(purpose: &str) -> Self {
        let mut hash = Self(Sha256::new());
        hash.field(purpose.as_bytes());
        hash
    }

    /// Adds one field, preceded by its length.
    pub(crate) fn field(&mut self, bytes: &[u8]) -> &mut Self {
        self.0.update((bytes.len() as u64).to_le_bytes());
        self.0.update(bytes);
        self
    }

    /// The hash of all fields.
    pub(crate) fn finish(&self) -> String {
        to_hex(&self.0.clone().finalize())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_of_no_bytes_is_the_published_one() {
        assert_eq!(content_hash(b""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }

    #[test]
    fn moving_a_letter_to_the_next_field_changes_the_hash() {
        let one = FieldHash::new("test").field(b"ab").field(b"c").finish();
        let two = FieldHash::new("test").field(b"a").field(b"bc").finish();
        assert_ne!(one, two);
    }
}
