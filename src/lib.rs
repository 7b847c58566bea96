//! Roomwright furnishes buildings: floor plans in, one glTF file per floor out.
//!
//! ```text
//! plan files -> plan -> layout -> scene -> gltf -> out/<building>/<level>.glb
//! configs/   -> catalog --'         |
//! recipes    -> model   ------------'      batch drives it, audit judges it, solve finds places, best chooses
//! ```

pub mod audit;
pub mod batch;
pub mod best;
pub mod cache;
pub mod catalog;
pub mod cli;
pub mod contract;
pub mod diff;
mod disk;
pub mod document;
pub mod draw;
pub mod edits;
pub mod geometry;
pub mod gltf;
#[cfg(test)]
mod growth;
pub mod handbook;
pub mod layout;
pub mod model;
pub mod output;
pub mod plan;
pub mod project;
pub mod read_back;
pub mod recipes;
pub mod scene;
pub mod solve;
pub mod texture;
mod walk;
