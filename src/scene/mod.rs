//! Building, placements and models to a tree of nodes, Y up; the only place that crosses plan and glTF axes.
//!
//! What later stages may rely on: node names are unique in the level, mesh and material indices are valid,
//! every number is finite, every mesh has triangles.

mod axes;
mod carrier;
mod extras;
mod light;
mod meshes;
mod names;
mod node;
mod options;
mod room;
mod shell;
mod tint;

pub use light::SceneLight;
pub use meshes::ModelSourceFunction;
pub use node::{
    Extras, LeafExtras, ModelKey, Node, Removed, Scene, SceneMaterial, SceneMesh, SceneVariant, SideExtras,
    SiteExtras,
};

pub use options::{Lights, Parts, SceneOptions};

pub(crate) use extras::GENERATOR;
pub(crate) use names::{numbered as object_id, opening as opening_id, parent as parent_id};

use axes::Pose;
use meshes::{Look, MeshTable};
use shell::{OpeningLook, RoomFinish, opening_node};

use crate::audit::Verdict;
use crate::catalog::{Catalog, DEFAULT_STYLE};
use crate::geometry::Point;
use crate::layout::Furnished;
use crate::model::SwatchedModels;
use crate::plan::{Level, SitePlacement};
use crate::texture::TextureLibrary;

/// What a scene is made of.
#[derive(Clone, Copy)]
pub struct SceneInput<'a> {
    /// The level.
    pub level: &'a Level,
    /// Id of its building.
    pub building: &'a str,
    /// Where the building stands; recorded, not applied.
    pub site: SitePlacement,
    /// One per room, in the order of the level's rooms.
    pub furnished: &'a [Furnished],
    /// What the audit says, in the same order; rooms past the end are as good as empty ones.
    pub verdicts: &'a [Verdict],
    /// Classes, room types, styles and palettes.
    pub catalog: &'a Catalog,
    /// The model of a class, variant and geometry set; the same one for the same arguments.
    pub models: &'a ModelSourceFunction<'a>,
    /// What lies on the materials; none for plain colours.
    pub textures: Option<&'a TextureLibrary>,
    /// What makes fewer primitives of models; none where every slot keeps its own material, as it must without textures.
    pub swatches: Option<&'a SwatchedModels>,
    /// What is shown beyond rooms and furniture.
    pub options: SceneOptions,
    /// Seed of the run.
    pub seed: u64,
}

/// Builds the tree of one level.
///
/// The level's floor is at y = 0; its elevation stands in the extras only. Openings come first, in the
/// order of the plan, then rooms.
///
/// # Panics
/// If `furnished` has not one entry per room, or an index in it points nowhere.
#[must_use]
pub fn build_scene(input: &SceneInput<'_>) -> Scene {
    assert_eq!(input.furnished.len(), input.level.rooms.len(), "one furnished room per room");
    let mut meshes = MeshTable::new(input);
    let name = names::level(input.building, &input.level.id);
    let origin = Pose::on_floor(Point::ZERO, 0.0);
    let mut root = Node::at(name, &origin, None, extras::level_extras(input));
    root.children.extend(openings(input, &mut meshes));
    root.children.extend((0..input.level.rooms.len()).map(|room| room::room_node(input, room, &mut meshes)));
    meshes.finish(root)
}

/// Openings look like the first room they join.
fn openings<'a>(input: &SceneInput<'a>, meshes: &mut MeshTable<'a>) -> Vec<Node> {
    let node = |opening: &crate::plan::Opening| {
        let room = opening.sides.first().map(|side| side.room);
        let style = room.map_or(DEFAULT_STYLE, |room| &input.furnished[room].style);
        let look = Look::of_style(input.catalog, style);
        let finish =
            room.map_or(RoomFinish::PLAIN, |room| RoomFinish::of(input.catalog, &input.level.rooms[room]));
        let SceneOptions { door_angle, parts, .. } = input.options;
        opening_node(input.level, opening, &OpeningLook { finish, look, door_angle, parts }, meshes)
    };
    input.level.openings.iter().map(node).collect()
}
