//! Edits that do not fit.

use crate::document::Fault;

/// An edit that does not fit the room as it is arranged now. It stays in its file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// Place, fact and hint.
    pub fault: Fault,
    /// Whether the edit was made all the same: the object stands where somebody wants it, and the audit objects.
    pub is_made: bool,
}

impl Misfit {
    /// An edit that could not be made.
    pub(super) fn unmade(mark: &Fault, message: impl Into<String>, hint: &str) -> Self {
        let fault = Fault { message: message.into(), ..mark.clone() }.with_hint(hint);
        Self { fault, is_made: false }
    }

    /// An edit that was made, and has consequences that nobody wants.
    pub(super) fn made(mark: &Fault, message: impl Into<String>, hint: &str) -> Self {
        let fault = Fault { message: message.into(), ..mark.clone() }.with_hint(hint).as_warning();
        Self { fault, is_made: true }
    }
}
