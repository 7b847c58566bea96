//! Says to robots and simulated people where the floor of a furnished level is free: from level and furniture come a navigation
//! mesh and an occupancy map.
//!
//! ```text
//! level + furniture ─ floor ─┬─ mesh       polygons that the middle of an agent may be in, and the portals between them
//!                            └─ occupancy  cells: free, taken, unknown
//! ```
//!
//! What is in the way is what `walk` says: whatever is higher than a step and lower than a head. `walk` answers whether ways of
//! people are closed, on a grid and by room; here outlines are exact to millimetres and levels whole, because planners shrink
//! and search them on their own. Door leaves take the floor on which they stand open.
//!
//! Everything here is pure; `cli/navigation` has the files.

mod convex;
mod file;
mod floor;
mod mesh;
mod occupancy;
mod shape;
#[cfg(test)]
mod tests;

pub use file::{Agent, IndexFile, IndexedMap, MapFile, MeshFile, MeshPolygon, MeshPortal, MeshRoom, Part};
pub use floor::LevelFloor;
pub use mesh::mesh;
pub use occupancy::{Occupancy, occupancy};
