//! Writes a bake as 3D Tiles 1.1 (OGC 22-025r4), for clients that stream cities: CesiumJS, 3d-tiles-renderer, game engines.
//!
//! Each level is there three times, as boxes, reduced and in full, each a compact file ([`crate::compact`]) of few draw calls. The
//! tileset leads to them: a quadtree of buildings, the levels of each, and for each level the three files, one replacing the other as
//! one comes near.
//!
//! - `output`: the format of the table;
//! - `near`: distances as geometric errors;
//! - `placement`: where a building is on the earth, or on its site;
//! - `volume`: boxes;
//! - `quadtree`: which buildings are in which file;
//! - `tileset`: the JSON.
//!
//! Tiles give the same bytes for any number of threads, and the tileset depends on the records of the levels alone.

mod near;
mod output;
mod placement;
mod quadtree;
#[cfg(test)]
mod tests;
mod tileset;
mod volume;

pub(crate) use output::TILES;
