//! The inside of the package, for its own tests, benches, examples and fuzz targets.

pub mod audit {
    pub use crate::audit::{AuditSummary, Code, Finding, Grade, Severity, Verdict};
}
pub mod batch {
    pub use crate::batch::{BakeInput, BakeOptions, OutputFolder, bake, merge};
}
pub mod best {
    pub use crate::best::{DEFAULT_EFFORT, Judged, best_of, furnish_best};
}
pub mod catalog {
    pub use crate::catalog::{
        Access, ById, Catalog, Class, ClassIndex, DEFAULT_STYLE, Dado, Extent, Finish, FittedPart, Material,
        ModelSource, Palette, PaletteRef, Plausible, RoomType, Shape, Share, Side, Size, Style, StyleRef,
        Untidiness, VariantRef, load_catalog,
    };
}
pub mod contract {
    pub use crate::contract::Extras;
}
pub mod diff {
    pub use crate::diff::{DiffOptions, Tolerance, compare, text};
}
pub mod document {
    pub use crate::document::{Fault, FaultSeverity, Faults, Source};
}
pub mod draw {
    pub use crate::draw::{Drawing, draw_level};
}
pub mod dwelling {
    pub use crate::dwelling::{Occupancy, occupied};
}
pub mod edits {
    pub use crate::edits::{EditBook, read_edits};
}
pub mod geometry {
    pub use crate::geometry::{
        Bounds, Convex, DisjointSets, Point, Polygon, Region, Segment, Size, direction,
    };
}
pub mod gltf {
    pub use crate::gltf::{
        EncodedModels, FlatNormals, GltfError, Painting, SharedLibrary, SharedModel, WriteOptions, write_glb,
        write_glb_with, write_gltf, write_gltf_with,
    };
}
pub mod layout {
    pub use crate::layout::{
        Alternative, FurnishOptions, Furnished, Parent, Placement, Removal, RemovalReason, RoomLayout,
        furnish,
    };
}
pub mod model {
    pub use crate::model::{
        Image, Model, ModelLibrary, ModelMaterial, OwnMaterial, Primitive, SwatchedModels, Texture,
        TextureSampler, TextureUse, Transparency, distance_outside, prisms_of,
    };
}
pub mod output {
    pub use crate::output::LevelOptions;
}
pub mod plan {
    pub use crate::plan::{
        Building, DrawnPiece, Leaf, LeafDraft, Level, LevelDraft, Obstacle, ObstacleDraft, Opening,
        OpeningDraft, OpeningKind, OpeningPlace, OpeningSide, PlacedBuilding, Plan, PlanOptions, PlanReading,
        Room, RoomDraft, RoomOpening, RoomRef, RoomWords, SitePlacement, Wall, WallKind, assemble_level,
        drawn_furniture, project_settings, read_formats, read_plans, write_native,
    };
}
pub mod read_back {
    pub use crate::read_back::{ReadLevel, parse_inventory, parse_level, parse_survey};
}
pub mod recipes {
    pub use crate::recipes::{GeometrySet, Mesh, Recipe, RecipeInput, Slot, find, recipes};
}
pub mod scene {
    pub use crate::scene::{
        Lights, ModelKey, Node, Parts, Scene, SceneInput, SceneMaterial, SceneMesh, SceneOptions, build_scene,
    };
}
pub mod solve {
    pub use crate::solve::{RoomSolver, judge_room};
}
pub mod storey {
    pub use crate::storey::Choices;
}
pub mod texture {
    pub use crate::texture::{SurfaceUse, TextureLibrary, TextureLocation, TextureSize};
}
pub mod world {
    pub use crate::world::{Pace, Spread, WalkPath, WalkReport, walk};
}
pub mod view {
    pub use crate::view::{PageAnswer, PlanPage};
}
