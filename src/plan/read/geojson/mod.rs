//! GeoJSON in degrees, for the readers of formats that are made of it: features with the properties of the format, and their
//! outlines in metres.
//!
//! ```text
//! read_table::<Properties>(path) -> the text and its features      Properties derives Deserialize and JsonSchema
//! plane_of(geometries) -> LocalPlane                               one plane for all levels of a building
//! outlines(geometry, &plane) -> outer corners and holes of an area; points(line, &plane) -> the points of a line
//! ```
//!
//! Each feature must have a text or a number as `id`, and `properties` that are an object: others are faults. References to ids among the
//! properties take the same by `deserialize_with = "id"`, `optional_id` or `optional_ids`, as `imdf/features.rs` shows.
//!
//! A fault of a feature goes to `table.source.fault(&["features".into(), index.into(), "properties".into()], ...)`.

mod feature;
mod place;
mod sequence;

pub(super) use feature::{
    Feature, Geometry, Id, Position, Table, id, optional_id, optional_ids, read_table, reference_system,
};
pub(super) use place::{corners_of, outlines, plane_around, plane_of, points};
pub(super) use sequence::{RECORD_SEPARATOR, as_collection};
