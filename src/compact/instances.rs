//! Gathers the instances of each mesh.

use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, PoisonError};

use glam::Vec3;

use super::Shown;
use super::encode::{EncodedPart, Grid, encode};
use super::listing::{Drawn, Frame};
use super::merged::{Surface, looks_of, merge, ordered_surfaces};
use crate::mesh::Model;

/// A mesh with the places where it stands.
pub(super) struct Instances {
    pub(super) name: String,
    /// Its looks.
    pub(super) surfaces: Vec<Surface>,
    pub(super) model: Arc<EncodedModel>,
    /// Where it stands.
    pub(super) places: Vec<Instance>,
}

/// A place of a mesh, in the frame of the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Instance {
    pub(super) frame: Frame,
    /// By how much it is larger than its model along each axis.
    pub(super) scale: Vec3,
    /// Index of its feature.
    pub(super) feature: usize,
}

/// A model by its own: its arrays, which do not depend on what else is in a file.
#[derive(Debug)]
pub(super) struct EncodedModel {
    /// Metres of a step of its positions.
    pub(super) step: f32,
    /// Each with the number of its look, in the order of the model's primitives.
    pub(super) parts: Vec<(usize, EncodedPart)>,
}

/// Models of the catalogue that were encoded in this run: most stand in many levels.
#[derive(Debug, Default)]
pub(crate) struct KnownModels {
    /// By where the model is in memory, and by the colours of its parts. Nothing is read from it in its own order.
    known: Mutex<HashMap<(usize, Vec<u32>), Known>>,
}

/// A model and its arrays; as long as it is here, nothing else is where it is.
type Known = (Arc<Model>, Arc<EncodedModel>);

impl KnownModels {
    fn encoded(&self, shown: &Shown<'_>, mesh: usize) -> Arc<EncodedModel> {
        let source = &shown.scene.meshes[mesh];
        // The shell is that of one level, and models that were changed are those of one file.
        let looks = source.key.as_ref().and_then(|_| looks_of(shown, mesh));
        let Some(looks) = looks else { return Arc::new(encoded(shown, mesh)) };
        let key = (Arc::as_ptr(&source.model).addr(), looks);
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known().get(&key).map(|(_, made)| Arc::clone(made));
        found.unwrap_or_else(|| {
            let made = Arc::new(encoded(shown, mesh));
            known().insert(key, (Arc::clone(&source.model), Arc::clone(&made)));
            made
        })
    }
}

fn encoded(shown: &Shown<'_>, mesh: usize) -> EncodedModel {
    let alone = Drawn { mesh, frame: Frame::IDENTITY, feature: 0 };
    let merged = merge(shown, &[&alone]);
    let grid = Grid::of_model(merged.values().flatten().flat_map(|part| &part.positions));
    let surfaces = ordered_surfaces(shown, mesh).into_iter().enumerate();
    let parts = surfaces.flat_map(|(look, surface)| {
        let parts = merged.get(&surface).into_iter().flatten();
        parts.map(|part| (look, encode(part, &grid))).collect::<Vec<_>>()
    });
    EncodedModel { step: grid.step as f32, parts: parts.collect() }
}

/// The instances of meshes, in the order of the meshes.
pub(super) fn gather(shown: &Shown<'_>, drawn: &[Drawn]) -> Vec<Instances> {
    let mut places: BTreeMap<usize, Vec<&Drawn>> = BTreeMap::new();
    drawn.iter().for_each(|drawn| places.entry(drawn.mesh).or_default().push(drawn));
    let gathered = places.into_iter().map(|(mesh, drawn)| {
        let model = shown.models_known.encoded(shown, mesh);
        let place = |drawn: &Drawn| Instance { frame: drawn.frame, scale: Vec3::ONE, feature: drawn.feature };
        let places = drawn.into_iter().map(place).collect();
        let name = shown.scene.meshes[mesh].name.clone();
        Instances { name, surfaces: ordered_surfaces(shown, mesh), model, places }
    });
    gathered.collect()
}
