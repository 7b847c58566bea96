//! The text of a file, with line and column of each place in it.

use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::diagnose::diagnose;
use super::excerpt::Lines;
use super::fault::{Fault, FaultSeverity, PathStep};
use super::faults::Faults;
use super::format::{Format, Refusal};
use super::json::parse_json;
use super::keys::top_keys;
use super::limits::FILE_SIZE_LIMIT;
use super::tree::{Flaw, Tree};
use super::typed::typed;
use crate::disk::open_unpacked;

/// The text of a file, kept while its meaning is checked. The places of its values are worked out when
/// the first fault asks for them.
#[derive(Debug)]
pub struct Source {
    file: PathBuf,
    text: String,
    tree: OnceLock<Result<Tree, Flaw>>,
    lines: OnceLock<Box<Lines>>,
}

impl Source {
    /// A text in memory; `file` is its name in messages; its ending decides the format.
    #[must_use]
    pub fn new(file: &Path, text: &str) -> Self {
        Self { file: file.to_owned(), text: text.to_owned(), tree: OnceLock::new(), lines: OnceLock::new() }
    }

    /// Reads a file; one that is packed with gzip as what it holds.
    ///
    /// # Errors
    /// A fault of the file as a whole: missing, a folder, a pipe or device (which might hang), not readable, larger than [`FILE_SIZE_LIMIT`]
    /// (which is found out before reading, or, of what is packed, before more is unpacked), not UTF-8.
    pub fn read(path: &Path) -> Result<Self, Faults> {
        let text = read_text(path)?;
        Ok(Self { file: path.to_owned(), text, tree: OnceLock::new(), lines: OnceLock::new() })
    }

    /// As [`Source::read`], for formats that are older than UTF-8: bytes that are none are taken as ISO 8859-1, with
    /// the fault as a warning.
    ///
    /// # Errors
    /// As [`Source::read`], but for bytes that are not UTF-8.
    pub(crate) fn read_old(path: &Path) -> Result<(Self, Faults), Faults> {
        let (text, faults) = match String::from_utf8(read_bytes(path)?) {
            Ok(text) => (text, Faults::default()),
            Err(error) => {
                let fault = not_text(path, error.as_bytes(), error.utf8_error().valid_up_to()).as_warning();
                let text = error.as_bytes().iter().map(|&byte| char::from(byte)).collect();
                (text, fault.with_hint("all its bytes above 0x7f were taken as ISO 8859-1").into())
            }
        };
        Ok((Self { file: path.to_owned(), text, tree: OnceLock::new(), lines: OnceLock::new() }, faults))
    }

    /// The name of the file.
    #[must_use]
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The text as a value.
    ///
    /// # Errors
    /// All faults of the text.
    pub fn parse<T: DeserializeOwned + JsonSchema>(&self) -> Result<T, Faults> {
        match self.read_typed() {
            Ok(value) if self.is_json() || self.flaws().is_empty() => Ok(value),
            Ok(_) => Err(self.flaws()),
            Err(refusal) => Err(diagnose(self, &refusal, &|| schemars::schema_for!(T).to_value())),
        }
    }

    fn read_typed<T: DeserializeOwned>(&self) -> Result<T, Refusal> {
        let of_type = |mismatch| Refusal::of_type(mismatch, self.tree().as_ref().ok().map(|tree| &tree.root));
        if self.is_json() {
            return typed(&parse_json(&self.text).map_err(|error| Refusal::of_json(&error))?)
                .map_err(of_type);
        }
        match self.tree() {
            Ok(tree) => typed(&tree.root).map_err(of_type),
            Err(flaw) => Err(Refusal::of_flaw(flaw)),
        }
    }

    fn is_json(&self) -> bool {
        Format::of(&self.file) == Format::Json
    }

    /// The keys of the outermost mapping, as far as they can be found without reading the values; for a text
    /// with syntax errors as far as it can be read. Tells kinds of files apart.
    #[must_use]
    pub fn top_keys(&self) -> Vec<String> {
        top_keys(&self.text)
    }

    /// Whether the text is a document, whatever it means.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.tree().is_ok()
    }

    /// A fault about what stands at a document path: its value if that begins on the line of its key, else
    /// the key; the nearest value around it if there is nothing at the path.
    #[must_use]
    pub fn fault(
        &self,
        path: &[PathStep],
        message: impl Into<String>,
        hint: Option<String>,
        severity: FaultSeverity,
    ) -> Fault {
        let position = self.tree().as_ref().ok().map(|tree| tree.root.locate(path));
        Fault { path: path.to_vec(), severity, ..self.fault_at(position, message) }.with_some_hint(hint)
    }

    /// A fault about the key at the end of a document path.
    #[must_use]
    pub fn fault_of_key(&self, path: &[PathStep], message: impl Into<String>, hint: Option<String>) -> Fault {
        let tree = self.tree().as_ref().ok();
        let position = tree.map(|tree| tree.root.locate_key(path).unwrap_or_else(|| tree.root.locate(path)));
        Fault { path: path.to_vec(), ..self.fault_at(position, message) }.with_some_hint(hint)
    }

    /// A fault at a place of the text.
    #[must_use]
    pub fn fault_at(&self, position: Option<(usize, usize)>, message: impl Into<String>) -> Fault {
        let lines = || self.lines.get_or_init(|| Box::new(Lines::new(&self.text)));
        let line = position.and_then(|(line, column)| lines().excerpt(&self.text, line, column));
        Fault { position, line, ..Fault::of_file(&self.file, message) }
    }

    /// The words that a text may define although it has faults: the keys below its outermost ones, and what stands under
    /// `key` in their values. None if it is not known what the text says.
    pub(crate) fn promised_words(&self, key: &str) -> Option<Vec<String>> {
        let root = self.tree().as_ref().ok()?.root.to_value();
        let tables = root.as_object()?.values().filter_map(Value::as_object);
        let mut words = Vec::new();
        for (id, definition) in tables.flatten() {
            words.push(id.clone());
            match definition.get(key) {
                Some(Value::Array(items)) => {
                    words.extend(items.iter().filter_map(Value::as_str).map(str::to_owned));
                }
                found => words.extend(found.and_then(Value::as_str).map(str::to_owned)),
            }
        }
        Some(words)
    }

    /// The tree of the text, or the reason why there is none.
    pub(super) fn tree(&self) -> &Result<Tree, Flaw> {
        self.tree.get_or_init(|| Tree::parse(&self.text))
    }

    /// The faults of the text that do not depend on its type.
    pub(super) fn flaws(&self) -> Faults {
        let flaws = match self.tree() {
            Ok(tree) => &tree.flaws[..],
            Err(flaw) => std::slice::from_ref(flaw),
        };
        Faults(flaws.iter().map(|flaw| self.fault_of_flaw(flaw)).collect())
    }

    pub(super) fn fault_of_flaw(&self, flaw: &Flaw) -> Fault {
        let fault = self.fault_at(Some(flaw.position), flaw.message.as_str());
        Fault { path: flaw.path.clone(), hint: flaw.hint.map(str::to_owned), ..fault }
    }
}

fn read_text(path: &Path) -> Result<String, Faults> {
    String::from_utf8(read_bytes(path)?)
        .map_err(|error| not_text(path, error.as_bytes(), error.utf8_error().valid_up_to()).into())
}

/// The bytes of a file without a byte order mark.
fn read_bytes(path: &Path) -> Result<Vec<u8>, Faults> {
    let refuse = |error: &std::io::Error| Faults::from(unreadable(path, error));
    if path.is_dir() {
        return Err(Fault::of_file(path, "is a folder, a file is needed here").into());
    }
    let (file, metadata) = open_unpacked(path).map_err(|error| refuse(&error))?;
    if metadata.len() > FILE_SIZE_LIMIT {
        return Err(too_large(path, metadata.len()).into());
    }
    let mut bytes = Vec::new();
    // A file may grow while it is read, and what it holds be larger than the file.
    file.take(FILE_SIZE_LIMIT + 1).read_to_end(&mut bytes).map_err(|error| refuse(&error))?;
    if bytes.len() as u64 > FILE_SIZE_LIMIT {
        return Err(too_large(path, bytes.len() as u64).into());
    }
    let start = if bytes.starts_with("\u{feff}".as_bytes()) { "\u{feff}".len() } else { 0 };
    bytes.drain(..start);
    Ok(bytes)
}

fn unreadable(path: &Path, error: &std::io::Error) -> Fault {
    let (message, hint) = match error.kind() {
        ErrorKind::NotFound => ("there is no such file".to_owned(), "check the path and the working folder"),
        ErrorKind::PermissionDenied => {
            ("no permission to read it".to_owned(), "check the rights of file and folder")
        }
        ErrorKind::InvalidInput => {
            (format!("cannot be read: {error}"), "copy its content into a file, and name that file")
        }
        ErrorKind::UnexpectedEof | ErrorKind::InvalidData => {
            (format!("cannot be unpacked: {error}"), "it is cut off or damaged: fetch it again")
        }
        _ => (format!("cannot be read: {error}"), "check the path"),
    };
    Fault::of_file(path, message).with_hint(hint)
}

fn too_large(path: &Path, size: u64) -> Fault {
    const MEBIBYTE: u64 = 1024 * 1024;
    let (size, limit) = (size.div_ceil(MEBIBYTE), FILE_SIZE_LIMIT / MEBIBYTE);
    Fault::of_file(path, format!("is {size} MiB large, {limit} MiB is the limit"))
        .with_hint("is it the right file? split large plans into one file per building")
}

fn not_text(path: &Path, bytes: &[u8], valid: usize) -> Fault {
    let line = bytes[..valid].iter().filter(|&&byte| byte == b'\n').count() + 1;
    let start = bytes[..valid].iter().rposition(|&byte| byte == b'\n').map_or(0, |newline| newline + 1);
    let column = String::from_utf8_lossy(&bytes[start..valid]).chars().count() + 1;
    let fault = Fault::of_file(path, format!("is not UTF-8 text: byte 0x{:02x}", bytes[valid]));
    Fault { position: Some((line, column)), ..fault }.with_hint("save the file with the encoding UTF-8")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs::File;

    use super::*;

    type Numbers = BTreeMap<String, f64>;

    fn message_of(path: &Path) -> String {
        Source::read(path).unwrap_err().0[0].message.clone()
    }

    #[test]
    fn unreadable_files_say_why() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(message_of(folder.path()), "is a folder, a file is needed here");
        assert_eq!(message_of(&folder.path().join("a.yaml")), "there is no such file");
    }

    #[test]
    fn a_file_above_the_limit_is_refused_without_reading_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("huge.yaml");
        File::create(&path).unwrap().set_len(2 * 1024 * 1024 * 1024).unwrap();
        assert_eq!(message_of(&path), "is 2048 MiB large, 512 MiB is the limit");
    }

    #[test]
    fn bytes_that_are_no_text_have_a_place() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("latin.yaml");
        std::fs::write(&path, b"a: 1\nb: caf\xe9\n").unwrap();
        let faults = Source::read(&path).unwrap_err();
        assert_eq!(
            (faults.0[0].position, faults.0[0].message.as_str()),
            (Some((2, 7)), "is not UTF-8 text: byte 0xe9")
        );
    }

    #[test]
    fn a_byte_order_mark_is_skipped() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("marked.json");
        std::fs::write(&path, "\u{feff}{\"a\": 1}").unwrap();
        assert_eq!(
            Source::read(&path).unwrap().parse::<Numbers>().unwrap()["a"].to_bits(),
            1.0_f64.to_bits()
        );
    }

    #[test]
    fn a_number_that_is_not_finite_is_a_fault_even_where_serde_takes_it() {
        for text in ["a: .nan", "a: -.inf", "a: 1e999"] {
            let faults = Source::new(Path::new("x.yaml"), text).parse::<Numbers>().unwrap_err();
            assert!(faults.0[0].message.ends_with("is not a finite number"), "{text}: {faults}");
            assert_eq!(faults.0[0].position, Some((1, 4)));
        }
        assert!(Source::new(Path::new("x.yaml"), "a.nano: 1").parse::<Numbers>().is_ok());
    }

    #[test]
    fn places_are_found_by_document_path() {
        let place = |text, path: &[PathStep]| {
            let fault = Source::new(Path::new("x.yaml"), text).fault(path, "", None, FaultSeverity::Error);
            (fault.position, fault.line)
        };
        let (position, line) = place("a:\n  - b: 1\n    c: 2\n", &["a".into(), 0.into(), "c".into()]);
        assert_eq!((position, line.as_deref()), (Some((3, 8)), Some("    c: 2")));
        assert_eq!(place("a: [", &[]), (None, None));
    }
}
