//! Problems of a user's model file, before the file is named.

use std::path::Path;

use crate::document::Fault;

/// A fact and what to do about it; becomes a [`Fault`] when the file is named.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    message: String,
    hint: Option<String>,
}

impl Problem {
    /// A fact.
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), hint: None }
    }

    /// With advice.
    pub(super) fn with_hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// The fault of a file.
    pub(super) fn in_file(self, file: &Path) -> Fault {
        let fault = Fault::of_file(file, self.message);
        match self.hint {
            Some(hint) => fault.with_hint(hint),
            None => fault,
        }
    }
}
