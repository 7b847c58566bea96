//! The tree of nodes that becomes a glTF file.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{Quat, Vec3};

use super::axes::Pose;
use crate::catalog::Material;
use crate::contract::{Extras, VariantId};
use crate::mesh::coordinate_set_count;
use crate::model::{Model, ModelMaterial, OwnMaterial, Primitive, Texture, TextureUse};
use crate::recipes::GeometrySet;

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
    /// The text by which the source of the plan asks to be named, which viewers show.
    pub copyright: Option<String>,
}

impl Scene {
    /// All textures of its materials.
    pub(crate) fn textures(&self) -> impl Iterator<Item = &Texture> {
        self.materials.iter().flat_map(SceneMaterial::textures).map(|(_, texture)| texture)
    }
}

/// The indices of the materials of a model among some; the first where one is not among them.
pub(crate) fn own_materials(materials: &[SceneMaterial], model: &Model) -> Vec<usize> {
    let index =
        |part: &Primitive| materials.iter().position(|known| known.is_of(&part.material)).unwrap_or(0);
    model.primitives.iter().map(index).collect()
}

/// Another look of a level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneVariant {
    /// The palette.
    pub name: String,
    /// The material that replaces another, both as index into [`Scene::materials`]; materials of users' models stay.
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
    /// Variant of a class.
    pub variant: VariantId,
    /// Geometry set of the style.
    pub geometry: GeometrySet,
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

    /// Whether it is the material of a part of a user's model.
    pub(crate) fn is_of(&self, part: &ModelMaterial) -> bool {
        match (self, part) {
            (Self::Own(known), ModelMaterial::Own(own)) => Arc::ptr_eq(known, own),
            _ => false,
        }
    }

    /// How many sets of texture coordinates its images need.
    pub(crate) fn coordinate_set_count(&self) -> usize {
        coordinate_set_count(self.textures())
    }

    /// The surface of its slot.
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
    /// The facts of the node.
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
