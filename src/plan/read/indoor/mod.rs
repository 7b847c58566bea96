//! Indoor maps: rooms that share their edges, and doors on these. The core that IMDF, Simple Indoor Tagging and the Japanese
//! indoor map have in common, and the readers of the last two.
//!
//! ```text
//! sit/    OpenStreetMap with indoor tags (XML, PBF, GeoJSON) ─┐
//! mlit/   Japanese indoor map (GeoJSON in metres)            ─┼─▶ storey.rs ─▶ drafts of levels
//! ../imdf IMDF (a folder of GeoJSON)                         ─┘
//! ```

pub(super) mod mlit;
mod remarks;
pub(super) mod sit;
mod storey;

pub(super) use storey::{STOREY_HEIGHT, Storey, opening_along};
