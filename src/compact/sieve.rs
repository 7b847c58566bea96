//! Decides what is seen of the meshes of a scene.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::coarse::{Extent, Kind, Limits, Seen, Simplifier};
use super::options::{Coarse, CompactOptions, Shapes};
use crate::contract::{ElementId, Extras, Part};
use crate::mesh::Model;
use crate::scene::{Node, Scene, SceneMesh};

/// Models of the catalogue that were simplified in this run: most stand in many levels.
#[derive(Debug, Default)]
pub(crate) struct KnownSimplified {
    /// Nothing is read from it in its own order.
    known: Mutex<HashMap<Looked, Simplified>>,
}

/// Where a model is in memory, what it is, and the limits.
type Looked = (usize, Kind, [u64; 5]);

/// A model and what is left of it; as long as it is here, nothing else is where it is.
type Simplified = (Arc<Model>, Option<Seen>);

impl KnownSimplified {
    fn simplified(&self, mesh: &SceneMesh, simplifier: &Simplifier) -> Option<Seen> {
        if !mesh.is_shared() {
            return simplifier.model(&mesh.model);
        }
        let key = (Arc::as_ptr(&mesh.model).addr(), simplifier.kind, simplifier.limits.bits());
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known().get(&key).map(|(_, made)| made.clone());
        found.unwrap_or_else(|| {
            let made = simplifier.model(&mesh.model);
            known().insert(key, (Arc::clone(&mesh.model), made.clone()));
            made
        })
    }
}

/// The models of the meshes of a scene as far as they are seen; `None` for those of which nothing is.
pub(super) fn seen(scene: &Scene, options: &CompactOptions, known: &KnownSimplified) -> Vec<Option<Seen>> {
    let seen = |mesh: &SceneMesh, kind: Kind| {
        if Extent(mesh.model.bounds()).sides()[0] < options.least_size {
            return None;
        }
        let Shapes::Coarse(coarse) = options.shapes else {
            return Some(Seen { model: Arc::clone(&mesh.model), cuboids: Arc::default() });
        };
        let limits = limits(&coarse, options.least_size, kind)?;
        known.simplified(mesh, &Simplifier { kind, limits })
    };
    scene.meshes.iter().zip(kinds(scene)).map(|(mesh, kind)| seen(mesh, kind)).collect()
}

/// Metres within which a part of the shell is a box.
const ROUNDING_OF_SHELL: f64 = 0.001;

/// What is seen of a mesh; `None` for nothing.
fn limits(coarse: &Coarse, least_size: f64, kind: Kind) -> Option<Limits> {
    let Coarse { least_width, boxed, rounding, sheet, has_trim } = *coarse;
    let (boxed, rounding) = match kind {
        Kind::Trim if !has_trim => return None,
        Kind::Leaf if !has_trim => (f64::INFINITY, rounding),
        Kind::Furniture | Kind::Hung | Kind::Leaf => (boxed, rounding),
        Kind::Trim | Kind::Shell => (0.0, ROUNDING_OF_SHELL),
        // Only one or two of their faces are seen.
        Kind::Floor | Kind::Ceiling => (0.0, f64::NEG_INFINITY),
    };
    Some(Limits { least_size, least_width, boxed, rounding, sheet })
}

/// What each mesh is.
fn kinds(scene: &Scene) -> Vec<Kind> {
    let mut kinds = vec![Kind::Shell; scene.meshes.len()];
    mark(&scene.root, &mut kinds);
    kinds
}

fn kind(extras: &Extras) -> Kind {
    match extras {
        Extras::Furniture(piece) if piece.parent == ElementId::Ceiling => Kind::Hung,
        Extras::Furniture(_) => Kind::Furniture,
        Extras::Part(part) => match part.part {
            Part::Leaf => Kind::Leaf,
            Part::Floor => Kind::Floor,
            Part::Ceiling => Kind::Ceiling,
            Part::Skirting | Part::Socket | Part::Switch | Part::Threshold | Part::Frame | Part::Sill => {
                Kind::Trim
            }
            _ => Kind::Shell,
        },
        _ => Kind::Shell,
    }
}

fn mark(node: &Node, kinds: &mut [Kind]) {
    if let Some(mesh) = node.mesh {
        kinds[mesh] = node.extras.as_ref().map_or(Kind::Shell, kind);
    }
    node.children.iter().for_each(|child| mark(child, kinds));
}
