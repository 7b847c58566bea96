//! Roomwright furnishes buildings: floor plans in, one glTF file for each level out.
//!
//! The same plan, catalogue, options and version give the same bytes, on any machine and with any number of threads. A
//! [`Project`] holds what was read: plans of any format that `roomwright formats` lists, the edits beside them, the catalogue of
//! furniture and its models. It writes whole buildings,
//!
//! ```
//! use roomwright::{BakeOptions, FloorOptions, Project};
//!
//! let project = Project::read(&["configs/plans/house.yaml"].into_iter().collect())?;
//! let options = BakeOptions { floor: FloorOptions { seed: 7, ..Default::default() }, threads: 2, ..Default::default() };
//! # let folder = tempfile::tempdir()?;
//! # let out = folder.path();
//! let report = project.bake(&options, out)?; // writes house/ground.glb, house/upper.glb, manifest.json
//! assert!(report.failures.is_empty() && out.join("house/ground.glb").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! or furnishes one room when it is asked for, judges it, and writes it without the others:
//!
//! ```
//! use roomwright::{FloorOptions, Project, RoomId};
//!
//! let project = Project::read(&["configs/plans/house.yaml"].into_iter().collect())?;
//! let options = FloorOptions::default();
//! let rooms = project.rooms(&options);
//! let living = rooms.furnish(&RoomId::new("house", "ground", "living"))?;
//! for placement in &living.furnished.placements {
//!     println!("{} at {}", project.catalog.classes[placement.class].id, placement.position);
//! }
//! println!("{} findings", living.verdict.findings.len());
//! let glb: Vec<u8> = rooms.glb(&living)?;
//! # assert!(glb.starts_with(b"glTF") && !living.furnished.placements.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lengths are metres, angles radians counter-clockwise, x east, y north. `ARCHITECTURE.md` shows how the stages follow each other;
//! `docs/output.md` says what the files hold.

// The documentation of the inside is for `cargo doc --document-private-items`, where its links lead somewhere.
#![allow(rustdoc::private_intra_doc_links)]

mod audit;
mod batch;
mod best;
mod cache;
mod catalog;
mod cli;
mod contract;
mod diff;
mod disk;
mod document;
mod draw;
mod edits;
mod geometry;
mod gltf;
#[cfg(test)]
mod growth;
mod handbook;
mod layout;
mod mesh;
mod model;
mod model_file;
mod output;
mod plan;
mod project;
mod read_back;
mod recipes;
mod scene;
mod solve;
mod texture;
mod walk;

pub use audit::{Finding, Verdict};
pub use batch::{BakeOptions, BakeReport, OutputFault};
pub use document::{Fault, Faults};
pub use gltf::GltfError;
pub use layout::{Furnished, Placement};
pub use output::{FloorOptions, Format};
pub use project::{EditsChoice, FinishedRoom, Project, ProjectPaths, RoomId, Rooms, UnknownRoom};

#[doc(hidden)]
pub use cli::run as run_command;

/// What the tests, benches, examples and fuzz targets of this package use of its inside. No part of the interface: it changes
/// without notice. A name that none of them uses any more is taken out here, and the compiler says whether anything else
/// still needs it.
#[doc(hidden)]
pub mod internals;
