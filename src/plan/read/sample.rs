//! The beginning of a file, and what can be recognised in it.

use std::path::Path;

use super::foreign::head;
use super::geojson::RECORD_SEPARATOR;
use crate::disk::unpacked_name;
use crate::document::top_keys;

/// The parts of a file that recognition looks at.
pub(super) struct Sample {
    /// In small letters.
    extension: String,
    /// The first bytes.
    pub(super) head: Vec<u8>,
    /// The beginning as text, in which every byte that is none is replaced.
    pub(super) text: String,
    /// The outermost keys of the beginning.
    keys: Vec<String>,
}

impl Sample {
    /// Of so many bytes of a file.
    pub(super) fn read(path: &Path, size: u64) -> Self {
        Self::of(path, head(path, size))
    }

    /// Of the first bytes of a file.
    pub(super) fn of(path: &Path, head: Vec<u8>) -> Self {
        let extension =
            unpacked_name(path).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let text = String::from_utf8_lossy(&head);
        let text = text.trim_start_matches(['\u{feff}', RECORD_SEPARATOR]).trim_start().to_owned();
        Self { extension: extension.to_ascii_lowercase(), keys: top_keys(&text), text, head }
    }

    /// Whether the name has one of these endings.
    pub(super) fn is_of(&self, extensions: &[&str]) -> bool {
        extensions.contains(&self.extension.as_str())
    }

    /// Whether the file begins so.
    pub(super) fn begins(&self, signature: &[u8]) -> bool {
        self.head.starts_with(signature)
    }

    /// Whether the file begins as an object of JSON does.
    pub(super) fn is_object(&self) -> bool {
        self.text.starts_with('{')
    }

    /// Whether the beginning holds one of these words.
    pub(super) fn holds_one_of(&self, words: &[&str]) -> bool {
        words.iter().any(|word| self.text.contains(word))
    }

    /// Whether all of these are outermost keys.
    pub(super) fn has(&self, keys: &[&str]) -> bool {
        keys.iter().all(|key| self.keys.iter().any(|known| known == key))
    }

    /// Whether a JSON text says so, whatever the spaces.
    pub(super) fn says(&self, key: &str, value: &str) -> bool {
        let (key, value) = (format!("\"{key}\""), format!("\"{value}\""));
        self.text.match_indices(&key).map(|(at, found)| at + found.len()).any(|at| {
            let rest = self.text[at..].trim_start().strip_prefix(':').map(str::trim_start);
            rest.is_some_and(|rest| rest.starts_with(&value))
        })
    }

    /// Whether the outermost element of an XML text has this name, whatever its prefix.
    pub(super) fn is_xml(&self, root: &str) -> bool {
        self.xml_root().is_some_and(|name| name.eq_ignore_ascii_case(root))
    }

    /// The name of the outermost element of an XML text, without its prefix.
    pub(super) fn xml_root(&self) -> Option<&str> {
        let mut rest = self.text.strip_prefix('<').map(|_| self.text.as_str())?;
        while let Some(at) = rest.find('<') {
            rest = &rest[at + 1..];
            if rest.starts_with(|letter: char| letter.is_alphabetic()) {
                let end = rest.find(|letter: char| letter.is_whitespace() || matches!(letter, '>' | '/'));
                let name = &rest[..end.unwrap_or(rest.len())];
                return Some(name.rsplit(':').next().unwrap_or(name));
            }
            // Comments may hold anything.
            if let Some(comment) = rest.strip_prefix("!--") {
                rest = &comment[comment.find("-->")?..];
            }
        }
        None
    }

    /// Whether it is a collection of features of GeoJSON.
    pub(super) fn is_geojson(&self) -> bool {
        self.says("type", "FeatureCollection") || self.has(&["type", "features"])
    }
}
