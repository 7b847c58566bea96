//! Builds the scene of a level, a tree of nodes (Y up), from building, placements and models.
//!
//! `axes.rs` turns plan axes into glTF axes, and back for readers of files. The *shell* (`shell/`) is all that is no furniture: floors,
//! ceilings, walls, columns, skirting boards, sockets and switches, doors and windows.
//!
//! Later stages may rely on:
//! - node names are unique in the level;
//! - mesh and material indices are valid;
//! - every number is finite;
//! - every mesh has triangles.

mod axes;
mod bounds;
mod carrier;
mod extras;
mod input;
mod light;
mod meshes;
mod node;
mod options;
mod room;
mod shell;
mod tint;

pub use bounds::LevelBounds;
pub use input::SceneInput;
pub use node::{ModelKey, Node, Scene, SceneLight, SceneMaterial, SceneMesh, SceneVariant};

pub use options::{Lights, Parts, SceneOptions};

pub(crate) use node::own_materials;

pub(crate) use axes::{plan_angle, plan_point, plan_rotation};
pub(crate) use extras::{GENERATOR, closure};

use axes::Pose;
use meshes::{Look, MeshTable};
use shell::{OpeningLook, RoomFinish, Storey, opening_node};

use crate::contract::level_name;
use crate::geometry::Point;

/// Builds the tree of one level, or of some of its rooms with the openings that they have.
///
/// The level's floor is at y = 0; its elevation stands in the extras only. Openings come first, in the
/// order of the plan, then rooms.
///
/// # Panics
/// If an index in `furnished` points nowhere, or a style is none of the catalogue.
#[must_use]
pub fn build_scene(input: &SceneInput<'_>) -> Scene {
    let mut meshes = MeshTable::new(input);
    let name = level_name(input.building, &input.level.id);
    let origin = Pose::on_floor(Point::ZERO, 0.0);
    let mut root = Node::at(name, &origin, None, extras::level_extras(input));
    let storey = Storey::of(input.level);
    root.children.extend(openings(input, &storey, &mut meshes));
    let rooms = 0..input.furnished.len();
    root.children.extend(rooms.map(|room| room::room_node(input, &storey, room, &mut meshes)));
    Scene { copyright: input.attribution.map(str::to_owned), ..meshes.finish(root) }
}

/// Openings look like the first room they join.
fn openings<'a>(input: &SceneInput<'a>, storey: &Storey<'_>, meshes: &mut MeshTable<'a>) -> Vec<Node> {
    let node = |opening: &crate::plan::Opening| {
        let room = opening.sides.first().map(|side| side.room);
        let style = room.map_or(input.catalog.default_style, |room| input.style_of(room));
        let look = Look::of_style(input.catalog, style);
        let finish =
            room.map_or(RoomFinish::PLAIN, |room| RoomFinish::of(input.catalog, &input.level.rooms[room]));
        let SceneOptions { door_angle, parts, .. } = input.options;
        opening_node(storey, opening, &OpeningLook { finish, look, door_angle, parts }, meshes)
    };
    input.level.openings.iter().filter(|opening| input.shows(opening)).map(node).collect()
}
