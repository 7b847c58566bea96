//! The budget of the solver's searches, and their fineness.

/// Metres between the positions that are tried when asking whether an empty room can hold a piece: a sixth of the smallest
/// clearance (0.30 m), so that what fits with any slack is found. Larger: pieces that fit with little slack count as impossible,
/// and their absence as the plan's fault. Smaller: inside the room, places and time grow with its inverse square.
pub(crate) const FIT_STEP: f64 = 0.05;
/// Steps ([`super::budget`]) that one judgement spends at most on what the empty room could hold. Rooms of 500 m² take a
/// tenth of it; with more, a room in which nothing fits takes longer than furnishing it.
pub(crate) const MOST_STEPS: u64 = 25_000_000;
/// Sine of the angle below which two walls count as parallel where a piece is tried along them: 1.1 degrees. Larger: pieces are
/// not tried square to a wall that leans more than they may. Smaller: each wall of a drawing with imprecise angles costs a search of
/// its own.
pub(crate) const SAME_DIRECTION: f64 = 0.02;
