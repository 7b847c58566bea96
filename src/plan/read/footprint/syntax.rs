//! Faults of syntax of files in JSON that are read piece by piece.

use crate::document::{Faults, Source};

/// The fault of a text that is no JSON, or not of the shape that is read, at its place.
pub(super) fn fault_of(source: &Source, error: &serde_json::Error) -> Faults {
    let place = (error.line() > 0).then(|| (error.line(), error.column().max(1)));
    let message = error.to_string();
    // The place stands in the fault.
    let message = message.split(" at line ").next().unwrap_or_default().to_owned();
    source.fault_at(place, message).into()
}
