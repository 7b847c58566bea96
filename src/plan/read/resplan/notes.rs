//! The name of the format, and places in its files.

use crate::document::PathStep;

/// The faults so far.
pub(super) use crate::plan::read::told::DocumentFaults as Notes;

/// The format's word in `room_words.yaml`.
pub(super) const NAME: &str = "resplan";

/// A place in the document.
pub(super) type Place = Vec<PathStep>;

/// A place below another.
pub(super) fn below(place: &Place, step: impl Into<PathStep>) -> Place {
    let mut longer = place.clone();
    longer.push(step.into());
    longer
}
