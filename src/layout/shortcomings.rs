//! What those who choose among arrangements of a room count beside the findings and the removals.

use super::rules::PoorPlaces;
use super::wanted::StandIns;

/// What a furnished room lacks of what was asked for, and what stands there as a second best. Those who choose among arrangements
/// count it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shortcomings {
    /// The pieces that replace others.
    pub stand_ins: StandIns,
    /// The required pieces that would rather stand elsewhere.
    pub poor_places: PoorPlaces,
}
