//! The formats of documents, and why one was refused.

use std::path::Path;

use super::node::Node;
use super::tree::Flaw;
use super::typed::Mismatch;
use crate::disk::unpacked_name;

/// How a document is spelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For people.
    Yaml,
    /// For machines: over ten times faster to read.
    Json,
}

/// Why a document was refused: the first reason that was met.
#[derive(Clone, Debug)]
pub(super) struct Refusal {
    /// The reason.
    pub(super) message: String,
    /// Line and column from 1, where known.
    pub(super) position: Option<(usize, usize)>,
    /// Whether the text is no YAML or JSON at all, whatever it was to mean.
    pub(super) is_syntax: bool,
    /// Whether the text ends too early.
    pub(super) is_cut_off: bool,
}

impl Format {
    /// By the extension: `.json`, `.geojson` and those of energy models are JSON, everything else YAML (of which JSON is a part);
    /// of what is packed, that before `.gz`.
    #[must_use]
    pub fn of(file: &Path) -> Self {
        let extension =
            unpacked_name(file).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let is_json =
            ["json", "geojson", "dfjson", "hbjson"].iter().any(|known| extension.eq_ignore_ascii_case(known));
        if is_json { Self::Json } else { Self::Yaml }
    }
}

impl Refusal {
    /// JSON that could not be read.
    pub(super) fn of_json(error: &serde_json::Error) -> Self {
        let message = error.to_string();
        let message =
            message.rsplit_once(" at line ").map_or(message.as_str(), |(reason, _)| reason).to_owned();
        let position = (error.line() > 0).then(|| (error.line(), error.column().max(1)));
        Self { message, position, is_syntax: error.is_syntax() || error.is_eof(), is_cut_off: error.is_eof() }
    }

    /// YAML that could not be read.
    pub(super) fn of_flaw(flaw: &Flaw) -> Self {
        let (message, position) = (flaw.message.clone(), Some(flaw.position));
        Self { message, position, is_syntax: true, is_cut_off: false }
    }

    /// A document of another type.
    pub(super) fn of_type(mismatch: Mismatch, tree: Option<&Node>) -> Self {
        let (message, path) = mismatch.into_parts();
        let position = tree.and_then(|root| root.find(&path)).map(|node| node.position);
        Self { message, position, is_syntax: false, is_cut_off: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_tells_the_format() {
        assert_eq!(Format::of(Path::new("a/b.JSON")), Format::Json);
        assert_eq!(Format::of(Path::new("a.yml")), Format::Yaml);
        assert_eq!(Format::of(Path::new("a")), Format::Yaml);
    }
}
