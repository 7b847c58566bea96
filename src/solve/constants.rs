//! What the solver's searches may cost, and how fine they are.

/// Step in metres between the positions tried when asking whether an empty room can hold a piece: below
/// the smallest clearance by a factor of six, so that what fits with any slack is found.
pub(crate) const FIT_STEP: f64 = 0.05;
/// Steps ([`super::budget`]) that one judgement spends at most on what the empty room could hold. Rooms of 500 m² take a
/// tenth of it; with more, a room in which nothing fits takes longer than furnishing it.
pub(crate) const MOST_STEPS: u64 = 25_000_000;
/// Sine of the angle below which two walls count as parallel where a piece is tried along them.
pub(crate) const SAME_DIRECTION: f64 = 0.02;
