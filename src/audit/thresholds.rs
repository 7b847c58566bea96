//! Every threshold of the audit, in metres or shares.
//!
//! Changing one changes verdicts, not layouts; the layout has its own, stricter margins.

/// Depth at which two bodies collide. Contact of neighbours carries rounding of some nanometres; a
/// millimetre is what a picture does not show. SceneEval tests at 0 and at 5 mm.
pub(crate) const COLLISION_DEPTH: f64 = 0.001;

/// How far a body may stick out of the room (SceneEval's out-of-bounds share, as a length).
pub(crate) const OUT_OF_ROOM: f64 = 0.005;

/// Gap between a body and its support above which the body floats.
pub(crate) const SUPPORT_GAP: f64 = 0.01;

/// Share of a footprint that may hang over the edge of its support.
pub(crate) const OVERHANG_SHARE: f64 = 0.1;

/// Deepest approach before a door: people do not need more than this to stand in, however wide the door is.
pub(crate) const APPROACH_DEPTH: f64 = 0.8;

/// Approach before an edge without a wall: a body there is walked around, not into.
pub(crate) const OPEN_BOUNDARY_DEPTH: f64 = 0.3;

/// Depth at which a body stands in a door's way; as small as [`COLLISION_DEPTH`] for its reason.
pub(crate) const DOOR_DEPTH: f64 = 0.001;

/// Depth at which a clearance is taken: the figures are rounded from inches, people do not feel a centimetre.
pub(crate) const USE_DEPTH: f64 = 0.01;

/// How far a piece on a wall may reach into a clearance, as a picture over a bedside does. ADA 307.2 allows
/// 0.10 m above knee height in a walkway; here it is a shelf's depth, as nobody hurries there.
pub(crate) const FLAT_DEPTH: f64 = 0.15;

/// Underside of pieces on a wall from which [`FLAT_DEPTH`] applies: feet and knees stay clear.
pub(crate) const FLAT_ELEVATION: f64 = 0.3;

/// Share of the requested pieces that must rest.
pub(crate) const REST_SHARE: f64 = 0.9;

/// Rounding that never decides: values this close to a threshold keep it.
pub(crate) const ROUNDING: f64 = 1e-6;

/// Step in metres between the positions tried when asking whether an empty room can hold a piece: below
/// the smallest clearance by a factor of six, so that what fits with any slack is found.
pub(crate) const FIT_STEP: f64 = 0.05;
