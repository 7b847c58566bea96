//! Reads a finished level as a scene, whoever wrote or edited it: its nodes with what they show.
//!
//! Scenes have no scales: a mesh below a scaled node is taken in that size. Lights and variants are left out.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use glam::{DMat4, DQuat, DVec3};
use gltf::json::{Index, Root};

use super::accessor::Numbers;
use super::container::open;
use super::geometry::{Gathered, roots, transform};
use super::material::{ReadMaterial, read_materials};
use super::problem::Problem;
use crate::contract::Extras;
use crate::document::Fault;
use crate::scene::{Node, Scene, SceneMaterial, SceneMesh, own_materials};

/// Nodes below each other that are read; a level has five or so.
const DEEPEST: usize = 64;

/// The level of a file.
///
/// # Errors
/// A file that is no sound glTF, uses what is not read here, or has no level.
pub(crate) fn read_scene(path: &Path) -> Result<Scene, Fault> {
    read(path).map_err(|problem| problem.in_file(path))
}

fn read(path: &Path) -> Result<Scene, Problem> {
    let mut container = open(path)?;
    let materials = read_materials(path, &mut container)?;
    let numbers = Numbers { document: &container.document, buffers: &container.buffers };
    let mut reader = Reader {
        numbers,
        materials: &materials,
        shown: materials.iter().map(|read| SceneMaterial::Own(Arc::clone(&read.material))).collect(),
        meshes: Vec::new(),
        known: BTreeMap::new(),
        is_visited: vec![false; container.document.nodes.len()],
    };
    let mut levels = Vec::new();
    for root in roots(&container.document) {
        levels.push(reader.node(root, Place::IDENTITY, 0)?);
    }
    let is_level = |node: &Node| matches!(node.extras, Some(Extras::Level(_)));
    let level = levels.into_iter().find(is_level);
    let root = level.ok_or_else(|| {
        Problem::new("has no level: no node at the top has extras that say {\"kind\": \"level\"}")
            .with_hint("use files that bake wrote, or that keep their extras (custom properties)")
    })?;
    let Reader { meshes, shown, .. } = reader;
    let copyright = container.document.asset.copyright.clone();
    Ok(Scene { root, meshes, materials: shown, lights: Vec::new(), variants: Vec::new(), copyright })
}

/// A place without scale, and the scale that what it shows has.
#[derive(Clone, Copy)]
struct Place {
    rotation: DQuat,
    translation: DVec3,
    whole: DMat4,
}

impl Place {
    const IDENTITY: Self =
        Self { rotation: DQuat::IDENTITY, translation: DVec3::ZERO, whole: DMat4::IDENTITY };
}

struct Reader<'a> {
    numbers: Numbers<'a>,
    materials: &'a [ReadMaterial],
    /// The same as those of the scene.
    shown: Vec<SceneMaterial>,
    meshes: Vec<SceneMesh>,
    /// The mesh of the scene for each mesh of the file in each size; `None` for those without triangles.
    known: BTreeMap<(usize, [u64; 3]), Option<usize>>,
    /// By node: one below two others would be read as often as there are ways to it.
    is_visited: Vec<bool>,
}

impl Reader<'_> {
    fn node(&mut self, index: Index<gltf::json::Node>, parent: Place, depth: usize) -> Result<Node, Problem> {
        let document: &Root = self.numbers.document;
        let Some(source) = document.get(index) else {
            return Err(Problem::new("names a node that does not exist"));
        };
        let name = source.name.clone().unwrap_or_else(|| format!("node {}", index.value()));
        if std::mem::replace(&mut self.is_visited[index.value()], true) {
            return Err(Problem::new(format!("node \"{name}\" is reached twice")));
        }
        if depth > DEEPEST {
            return Err(Problem::new(format!("node \"{name}\" lies below more than {DEEPEST} others")));
        }
        let whole = parent.whole * transform(source);
        let (scale, rotation, translation) = whole.to_scale_rotation_translation();
        if !(scale.is_finite() && rotation.is_finite() && translation.is_finite()) {
            return Err(Problem::new(format!("node \"{name}\" has no place")));
        }
        let back = parent.rotation.inverse();
        let extras = source.extras.as_ref().and_then(|text| Extras::parse(text.get()).ok().flatten());
        let mesh = match source.mesh {
            Some(mesh) => self.mesh(mesh.value(), scale)?,
            None => None,
        };
        let place = Place { rotation, translation, whole };
        let children = source.children.iter().flatten();
        let children: Result<Vec<Node>, Problem> =
            children.map(|&child| self.node(child, place, depth + 1)).collect();
        Ok(Node {
            name,
            translation: (back * (translation - parent.translation)).as_vec3(),
            rotation: (back * rotation).normalize().as_quat(),
            mesh,
            light: None,
            extras,
            children: children?,
        })
    }

    fn mesh(&mut self, index: usize, scale: DVec3) -> Result<Option<usize>, Problem> {
        // Single precision leaves quaternions, and so the scales found, a little off.
        let scale = if (scale - DVec3::ONE).abs().max_element() < 1e-5 { DVec3::ONE } else { scale };
        let key = (index, scale.to_array().map(f64::to_bits));
        if let Some(&known) = self.known.get(&key) {
            return Ok(known);
        }
        let Some(source) = self.numbers.document.meshes.get(index) else {
            return Err(Problem::new(format!("names mesh {index}, which does not exist")));
        };
        let mut gathered = Gathered::new(self.numbers, self.materials);
        source.primitives.iter().try_for_each(|part| gathered.add(part, DMat4::from_scale(scale)))?;
        let found = gathered.into_model().ok().map(|model| {
            let name = source.name.clone().unwrap_or_else(|| format!("mesh {index}"));
            let materials = own_materials(&self.shown, &model);
            self.meshes.push(SceneMesh { name, model: Arc::new(model), materials, key: None });
            self.meshes.len() - 1
        });
        self.known.insert(key, found);
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The level of a document with nodes.
    fn level_of(nodes: &str) -> Result<Scene, Fault> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("level.gltf");
        let text = format!(
            "{{\"asset\": {{\"version\": \"2.0\"}}, \"scenes\": [{{\"nodes\": [0]}}], \"nodes\": [{nodes}]}}"
        );
        std::fs::write(&path, text).unwrap();
        read_scene(&path)
    }

    const LEVEL: &str = r#""name": "a/1", "extras": {"kind": "level", "building": "a", "level": "1", "elevation": 0, "height": 3}"#;

    #[test]
    fn nodes_are_read_below_each_other() {
        let child = r#"{"name": "b", "translation": [1, 2, 3], "scale": [2, 2, 2]}"#;
        let scene = level_of(&format!("{{{LEVEL}, \"children\": [1]}}, {child}")).unwrap();
        assert_eq!(scene.root.children[0].translation, glam::Vec3::new(1.0, 2.0, 3.0));
        assert!(level_of(r#"{"name": "no level"}"#).unwrap_err().message.contains("has no level"));
    }

    #[test]
    fn a_node_below_several_others_is_refused_however_many_ways_lead_to_it() {
        // Twice as many ways with every step.
        let steps = (0..60).map(|step| format!("{{\"children\": [{0}, {0}]}}", step + 2));
        let nodes = format!("{{{LEVEL}, \"children\": [1]}}, {}, {{}}", steps.collect::<Vec<_>>().join(", "));
        assert!(level_of(&nodes).unwrap_err().message.contains("is reached twice"));
    }
}
