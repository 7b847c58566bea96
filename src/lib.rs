//! Roomwright furnishes buildings: floor plans in, one glTF file for each level out. A program that uses this library from a clone
//! beside it has `roomwright = { path = "../roomwright", default-features = false }` among its dependencies: without the command.
//!
//! The same plan, catalogue, options and version give the same bytes, on any machine and with any number of threads. A
//! [`Project`] holds what was read: plans of any format that `roomwright formats` lists, the edits beside them, the catalogue of
//! furniture and its models. What could not be read is in [`Project::faults`]. A project writes whole buildings:
//!
//! ```
//! use roomwright::{BakeOptions, LevelOptions, Project};
//!
//! let project = Project::read(&["configs/plans/house.yaml"].into_iter().collect())?;
//! assert!(!project.faults.has_errors(), "{}", project.faults);
//! let level = LevelOptions { seed: 7, ..project.level_options() };
//! # let folder = tempfile::tempdir()?;
//! # let out = folder.path();
//! let report = project.bake(&BakeOptions { level, threads: 2, ..Default::default() }, out)?;
//! assert!(report.failures.is_empty() && out.join("house/ground.glb").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! It also furnishes one room on demand, judges it, and writes it without the others, where it lies in the building, with its own
//! walls, doors and windows. [`Project::room_ids`] lists the rooms and `project.catalog.style_ids()` the styles; one that the plan
//! names for a room comes first, and one that is made for other types of rooms leaves a room the default style. Errors say what
//! is possible. Faults print a line for each and end without a line break; warnings stay in a project that can be used:
//!
//! ```
//! use roomwright::{LevelOptions, Project};
//!
//! let project = Project::read(&["configs/plans/house.yaml"].into_iter().collect())?;
//! if project.faults.has_errors() {
//!     return Err(project.faults.into());
//! }
//! let options = LevelOptions { seed: 7, ..project.level_options_in("home_modern")? };
//! let rooms = project.rooms(&options);
//! let living = rooms.furnish(&"house/ground/living".parse()?)?;
//! for placement in &living.furnished.placements {
//!     // In the plan: the point (x, y) is (x, height, -y) in the file.
//!     println!("{} at {}", project.catalog.classes[placement.class].id, placement.position);
//! }
//! living.verdict.findings.iter().for_each(|finding| println!("{finding}"));
//! let glb: Vec<u8> = rooms.glb(&living)?;
//! # assert!(glb.starts_with(b"glTF") && !living.furnished.placements.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A game or a walkthrough asks for what is around an eye. A [`World`] furnishes rooms before they are seen, in the background after
//! [`World::start`] or where the program has time for a [`World::step`], holds them within a budget, and forgets those that are far:
//!
//! ```
//! use roomwright::building::Point;
//! use roomwright::{Budget, Eye, Project, RoomId, World};
//!
//! let project = Project::read(&["configs/plans/house.yaml"].into_iter().collect())?;
//! let options = project.level_options();
//! let mut world = World::open(project, options);
//! let eye = Eye::new("house", "ground", Point::new(3.0, 2.0), Point::X);
//! world.update(&eye, Budget::default())?;
//! while world.step() {}
//! let living = world.room(&RoomId::new("house", "ground", "living"));
//! assert!(living.is_some_and(|room| room.furnished.placements.len() > 20));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Plans are read from files, or from a text in memory ([`Project::parse`]): a program that makes rooms itself writes them as YAML
//! first, in some ten lines a level (`configs/plans/README.md`).
//!
//! Lengths are metres, angles radians counter-clockwise, x east, y north. The modules [`options`], [`building`], [`furniture`] and
//! [`judgement`] hold the types that the fields of these structs have. `ARCHITECTURE.md` shows how the stages follow each other; `docs/output.md` says
//! what the files hold.

// What only the command uses is dead without it, and unused imports come with it.
#![cfg_attr(not(feature = "cli"), allow(dead_code, unused_imports))]
// The documentation of the inside is for `cargo doc --document-private-items`, where its links lead somewhere.
#![allow(rustdoc::private_intra_doc_links)]

mod audit;
mod batch;
mod best;
mod cache;
mod catalog;
#[cfg(feature = "cli")]
mod cli;
mod compact;
mod contract;
mod diff;
mod disk;
mod document;
mod draw;
mod dwelling;
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
pub mod navigation;
mod output;
mod plan;
mod project;
mod read_back;
mod recipes;
mod scene;
mod solve;
mod storey;
mod texture;
mod tiles;
mod view;
mod walk;
mod world;

pub use batch::{BakeOptions, BakeReport, OutputFault};
pub use contract::RoomId;
pub use document::{Fault, Faults};
pub use gltf::GltfError;
pub use output::LevelOptions;
pub use project::{EditsChoice, FinishedRoom, Project, ProjectPaths, Rooms, UnknownRoom, UnknownStyle};
pub use world::{Budget, Change, Eye, UnknownLevel, WantedRoom, World, WorldRoom};

/// The types of the fields of [`LevelOptions`] and [`BakeOptions`].
pub mod options {
    pub use crate::batch::{ChosenLevels, LevelList, PlannedLevel, Shard, Unplanned};
    pub use crate::cache::Cache;
    pub use crate::compact::Instancing;
    pub use crate::gltf::FlatNormals;
    pub use crate::model::Detail;
    pub use crate::output::{Format, IndexOptions, TextureOptions};
    pub use crate::plan::{EarthPlace, SiteOrigin};
    pub use crate::scene::{Lights, Parts, SceneOptions};
    pub use crate::texture::TextureSize;
    pub use crate::world::{DEFAULT_REACH, Need};
}

/// Plans as they were read: the types of [`Project::plan`].
pub mod building {
    pub use crate::geometry::{Bounds, Point, Polygon, Region, Segment};
    pub use crate::plan::{
        Building, Leaf, Level, Obstacle, Opening, OpeningKind, OpeningSide, PlacedBuilding, Plan, Room,
        RoomOpening, Shared, SitePlacement, Wall, WallKind,
    };
}

/// Furniture: the catalogue ([`Project::catalog`]) and the pieces of a room ([`FinishedRoom::furnished`]).
pub mod furniture {
    pub use crate::catalog::{
        BuildingStyle, ById, Catalog, Class, ClassIndex, RoomType, Side, Style, StyleRef,
    };
    pub use crate::geometry::Size;
    pub use crate::layout::{Furnished, Parent, Placement, Removal, RemovalReason};
}

/// The verdict of the audit on a room ([`FinishedRoom::verdict`]).
pub mod judgement {
    pub use crate::audit::{Code, Finding, Grade, Quantity, Score, Severity, Unit, Verdict};
    pub use crate::edits::Misfit;
}

#[cfg(feature = "cli")]
#[doc(hidden)]
pub use cli::run as run_command;

/// Internal names for the tests, benches, examples and fuzz targets of this package; no part of the interface, and changed without
/// notice. To find dead code, take out a name that none of them uses: the compiler says whether anything else needs it.
#[doc(hidden)]
pub mod internals;
