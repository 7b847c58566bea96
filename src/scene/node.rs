//! The tree of nodes that becomes a glTF file.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{Quat, Vec3};
use serde::Serialize;

use super::axes::Pose;
use crate::audit::{Finding, Grade};
use crate::catalog::Material;
use crate::model::{Model, OwnMaterial, Texture, TextureUse};

/// One level as a tree of nodes in the glTF frame: metres, right-handed, Y up.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The level.
    pub root: Node,
    /// Meshes that nodes refer to; each once.
    pub meshes: Vec<SceneMesh>,
    /// Materials that meshes refer to; each once.
    pub materials: Vec<SceneMaterial>,
    /// Lights that nodes refer to; each once.
    pub lights: Vec<SceneLight>,
    /// Other looks of the whole level, if any are asked for.
    pub variants: Vec<SceneVariant>,
}

/// Another look of a level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneVariant {
    /// The palette.
    pub name: String,
    /// What takes the place of a material, both as index into [`Scene::materials`]; materials of users' models stay.
    pub materials: BTreeMap<usize, usize>,
}

/// A mesh with its materials.
#[derive(Clone, Debug)]
pub struct SceneMesh {
    /// Unique in the scene; the class and variant, or the node of a shell part.
    pub name: String,
    /// The triangles.
    pub model: Arc<Model>,
    /// Index into [`Scene::materials`] for each primitive.
    pub materials: Vec<usize>,
    /// Which model of the catalogue it is, so that a library shared by many levels may hold its triangles;
    /// `None` for the shell, which belongs to its level.
    pub key: Option<ModelKey>,
}

/// A model of the catalogue by name: equal keys have equal triangles in every level of a run.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ModelKey {
    /// Class id.
    pub class: String,
    /// Variant of the class.
    pub variant: u32,
    /// Geometry set of the style.
    pub geometry: String,
}

impl SceneMesh {
    /// Whether other levels may use the same triangles.
    #[must_use]
    pub fn is_shared(&self) -> bool {
        self.key.is_some()
    }
}

/// A material of the scene.
#[derive(Clone, Debug)]
pub enum SceneMaterial {
    /// A slot of a palette.
    Slot {
        /// `<palette>.<slot>`.
        name: String,
        /// Its factors.
        material: Material,
        /// Its textures by use.
        textures: Vec<(TextureUse, Texture)>,
    },
    /// From a user's model.
    Own(Arc<OwnMaterial>),
}

impl SceneMaterial {
    /// Its textures by use.
    #[must_use]
    pub fn textures(&self) -> &[(TextureUse, Texture)] {
        match self {
            Self::Slot { textures, .. } => textures,
            Self::Own(own) => &own.textures,
        }
    }

    /// The surface that its slot is painted with.
    pub(crate) fn surface(&self) -> Option<&'static str> {
        match self {
            Self::Slot { material, .. } => material.texture,
            Self::Own(_) => None,
        }
    }
}

/// A light of a scene: equal lamps share one.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneLight {
    /// Unique in the scene.
    pub name: String,
    /// Linear red, green and blue, the strongest 1.
    pub color: [f32; 3],
    /// Candelas in every direction.
    pub intensity: f32,
}

/// One node; its place is relative to its parent.
#[derive(Clone, Debug)]
pub struct Node {
    /// Unique in the level.
    pub name: String,
    /// Metres.
    pub translation: Vec3,
    /// Unit quaternion.
    pub rotation: Quat,
    /// Index into [`Scene::meshes`].
    pub mesh: Option<usize>,
    /// Index into [`Scene::lights`].
    pub light: Option<usize>,
    /// What the node is.
    pub extras: Option<Extras>,
    /// Nodes that move with it.
    pub children: Vec<Node>,
}

impl Node {
    /// A node without children at a place relative to its parent.
    pub(crate) fn at(name: String, pose: &Pose, mesh: Option<usize>, extras: Extras) -> Self {
        Self {
            name,
            translation: pose.translation(),
            rotation: pose.rotation(),
            mesh,
            light: None,
            extras: Some(extras),
            children: Vec::new(),
        }
    }
}

/// The `extras` of a node (the output contract).
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Extras {
    /// The root.
    Level {
        /// Building id.
        building: String,
        /// Level id.
        level: String,
        /// Metres above the building's zero.
        elevation: f64,
        /// Metres from floor to floor.
        height: f64,
        /// Seed of the run.
        seed: u64,
        /// Program and version.
        generator: String,
        /// Where the building stands, unless it stands at the site's origin; no node is moved by it.
        #[serde(skip_serializing_if = "Option::is_none")]
        site: Option<SiteExtras>,
    },
    /// A door, window, passage or open boundary.
    Opening {
        /// `door` or `window`.
        opening: &'static str,
        /// How it is closed: door, sliding, passage, open, window.
        closure: &'static str,
        /// Unique in the level; the node's name is `door:<id>` or `window:<id>`.
        id: String,
        /// Room ids.
        rooms: Vec<String>,
        /// Where it is in the walls of these rooms.
        sides: Vec<SideExtras>,
        /// Metres along the wall.
        width: f64,
        /// Metres from bottom to top.
        height: f64,
        /// Metres of the bottom above the floor.
        sill: f64,
        /// The leaves on hinges.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        leaves: Vec<LeafExtras>,
    },
    /// A room.
    Room {
        /// Room id.
        room: String,
        /// Room type.
        #[serde(rename = "type")]
        room_type: String,
        /// Style used.
        style: String,
        /// Seed that repeats the room; a text in the file, for most readers of JSON keep 53 bits of a number.
        #[serde(serialize_with = "as_text")]
        seed: u64,
        /// Corners in plan metres, counter-clockwise, not closed.
        outline: Vec<[f64; 2]>,
        /// Corners of each hole.
        holes: Vec<Vec<[f64; 2]>>,
        /// Metres from floor to ceiling.
        height: f64,
        /// Pieces the programme asked for.
        requested: u32,
        /// Pieces that rest.
        placed: u32,
        /// Pieces that do not, each with its reason.
        removed: Vec<Removed>,
        /// The audit's grade.
        grade: Grade,
        /// The audit's score from 0 to 1; none where nothing was asked for.
        #[serde(skip_serializing_if = "Option::is_none")]
        score: Option<f64>,
        /// Findings of the audit.
        findings: Vec<Finding>,
    },
    /// Floor, ceiling, wall, or a piece of an opening.
    Part {
        /// `floor`, `ceiling`, `wall`, `skirting`, `column`, `socket`, `switch`, and `walls`, which shows all of these but
        /// floor and ceiling where parts are merged; of an opening `threshold`, `frame`, `leaf`, `glass`, `sill`.
        part: &'static str,
        /// Unique in its room or opening; what `parent` of an object names: `floor`, `wall.2`, `leaf.1`.
        id: String,
        /// The paper's tags.
        tags: Vec<String>,
        /// Of a column, its corners in plan metres, counter-clockwise, not closed.
        #[serde(skip_serializing_if = "Option::is_none")]
        outline: Option<Vec<[f64; 2]>>,
        /// Of a column, metres of its top above the floor.
        #[serde(skip_serializing_if = "Option::is_none")]
        height: Option<f64>,
    },
    /// The light of a lamp, a child of the lamp.
    Light {
        /// Luminous flux in lumens.
        lumens: f64,
        /// Colour temperature in kelvins.
        kelvin: f64,
    },
    /// An object.
    Furniture {
        /// Class id.
        class: String,
        /// `<class>.<number>`, unique in the room.
        id: String,
        /// Id of the parent object, or the part: `floor`, `ceiling`, `wall.2`, `door:3`.
        parent: String,
        /// The parent's side.
        side: &'static str,
        /// Width, depth, height in metres.
        size: [f64; 3],
        /// Variant number.
        variant: u32,
    },
}

/// A missing piece.
#[derive(Clone, Debug, Serialize)]
pub struct Removed {
    /// Class id.
    pub class: String,
    /// Why.
    pub reason: &'static str,
    /// Whether the programme calls it required.
    pub required: bool,
}

/// Where a building stands, in plan axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SiteExtras {
    /// Metres east and north of the site's origin.
    pub position: [f64; 2],
    /// Radians counter-clockwise.
    pub turn: f64,
}

/// Where an opening is in a wall of a room.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SideExtras {
    /// Room id.
    pub room: String,
    /// Number of the wall: `wall.<n>` of that room.
    pub wall: usize,
    /// Metres from the wall's start where it begins.
    pub from: f64,
    /// Metres from the wall's start where it ends.
    pub to: f64,
}

/// The sector a door leaf sweeps, as points in plan metres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LeafExtras {
    /// The axis it turns around.
    pub hinge: [f64; 2],
    /// Its free end when shut.
    pub closed: [f64; 2],
    /// Its free end when fully open, as the leaf's node stands.
    pub open: [f64; 2],
}

/// A number as a text.
fn as_text<S: serde::Serializer>(number: &u64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(number)
}
