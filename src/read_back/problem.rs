//! Faults of nodes, before the file is named.

use std::path::Path;

use crate::document::Fault;

/// A fact about a node and what to do about it; becomes a [`Fault`] when the file is named.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    node: String,
    message: String,
    hint: Option<String>,
    is_warning: bool,
}

impl Problem {
    /// A fact about a node; an empty name is the file as a whole.
    pub(super) fn new(node: &str, message: impl Into<String>) -> Self {
        Self { node: node.to_owned(), message: message.into(), hint: None, is_warning: false }
    }

    /// With advice.
    pub(super) fn with_hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// The room is judged all the same.
    pub(super) fn that_only_warns(self) -> Self {
        Self { is_warning: true, ..self }
    }

    /// The fault of a file.
    pub(super) fn in_file(self, file: &Path) -> Fault {
        let place = if self.node.is_empty() { String::new() } else { format!("node \"{}\" ", self.node) };
        let mut fault = Fault::of_file(file, format!("{place}{}", self.message));
        fault.hint = self.hint;
        if self.is_warning { fault.as_warning() } else { fault }
    }
}
