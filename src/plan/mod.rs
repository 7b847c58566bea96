//! Reads plan files into a checked [`Plan`]; one file per input format under `read/`.
//!
//! Later stages may rely on:
//! - lengths are metres, angles radians, x east, y north, z up;
//! - every outline is a [`crate::geometry::Polygon`]: simple, counter-clockwise, without repeated corners;
//! - a room has exactly one [`Wall`] per border of its region, in the same order;
//! - every opening lies on walls that exist, `from < to`, within the wall, and is listed both in the level
//!   and in its rooms; openings of one wall do not overlap;
//! - ids are unique in their scope, numbers are unique in the level, room types exist in the catalogue;
//! - all prototypes, references, units and defaults are resolved.

mod assemble;
mod attach;
mod axis;
mod building;
mod clean;
mod digest;
mod draft;
mod guess;
mod inset;
pub(crate) mod limits;
mod mirror;
mod options;
pub(crate) mod read;
mod report;
mod room_ref;
#[cfg(test)]
mod sample;
mod shared;
mod site_origin;
mod stairs;
mod units;
mod words;
mod write_native;

pub use assemble::assemble_level;
pub(crate) use building::LEAF_DEPTH;
pub use building::{
    Building, FRAME_DEPTH, FRAME_WIDTH, HANDLE_HEIGHTS, Home, Leaf, Level, Obstacle, Opening, OpeningKind,
    OpeningSide, PIPES_TAG, PlacedBuilding, Plan, PlanSource, Room, RoomOpening, SitePlacement, Wall,
    WallKind,
};
#[cfg(test)]
pub(crate) use building::{HANDLE_LENGTH, HANDLE_REACH};
pub(crate) use clean::{region_without, ring_surface, to_points, to_surface};
pub use draft::{
    BuildingDraft, LeafDraft, LevelDraft, ObstacleDraft, OpeningDraft, OpeningPlace, OutlineKind, Problem,
    RoomDraft, Subject,
};
pub use guess::GuessRule;
pub(crate) use inset::inner_faces;
pub(crate) use mirror::mirror_building;
pub use options::{PlanOptions, PlanReading, Planning, ProjectSettings};
pub use read::{
    DrawnPiece, ReadFormat, drawn_furniture, parse_plan, project_settings, read_formats, read_plans,
    unread_formats,
};
#[cfg(test)]
pub(crate) use read::{PlanFile, ProjectFile};
pub(crate) use read::{PlannedSite, SiteNotes, finish_draft, id_taken, plan_outlines};
pub use report::{BuildingReport, InputReport, LevelReport, Share};
pub use room_ref::RoomRef;
pub use shared::Shared;
pub use site_origin::{EarthPlace, SiteOrigin};
pub use stairs::{Flight, RailPoint, Stairs, Step, Well};
pub(crate) use stairs::{STAIRS_ROOM_TYPE, joined_rooms, middle, neighbours};
pub(crate) use units::{ECCENTRICITY_SQUARED, EQUATOR_RADIUS};
pub use words::{GENERIC_ROOM_TYPE, RoomWords};
pub use write_native::write_native;
