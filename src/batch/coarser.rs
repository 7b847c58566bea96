//! Coarser furniture for scenes that come from files: their models are what the files show.

use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, PoisonError};

use crate::catalog::{Catalog, Size};
use crate::contract::{Extras, FurnitureExtras};
use crate::mesh::Model;
use crate::model::{reduced, stand_in};
use crate::scene::{Node, Scene, SceneMesh, own_materials};

/// Models with what was made of them.
type Pairs = Vec<(Arc<Model>, Arc<Model>)>;

/// Models with fewer triangles, each reduced once a run: most stand in many levels.
#[derive(Default)]
pub(super) struct CoarserModels {
    /// By the number of numbers of their corners and a sum of these. Nothing is read from it in its own order.
    known: Mutex<HashMap<(usize, u64), Pairs>>,
}

impl CoarserModels {
    /// The scene with reduced furniture.
    pub(super) fn reduced(&self, scene: &Scene) -> Scene {
        let furniture = furniture(scene);
        let meshes =
            scene.meshes.iter().enumerate().map(|(index, mesh)| match furniture.contains_key(&index) {
                true => SceneMesh { model: self.reduced_model(&mesh.model), ..mesh.clone() },
                false => mesh.clone(),
            });
        Scene { meshes: meshes.collect(), ..scene.clone() }
    }

    fn reduced_model(&self, model: &Arc<Model>) -> Arc<Model> {
        let numbers = || model.primitives.iter().flat_map(|part| part.positions.as_flattened());
        let add = |sum: u64, number: &f32| sum.rotate_left(5) ^ u64::from(number.to_bits());
        let key = (numbers().count(), numbers().fold(0, add));
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let find = |pairs: Option<&Pairs>| {
            let mut alike = pairs.into_iter().flatten();
            alike.find(|(whole, _)| whole == model).map(|(_, made)| Arc::clone(made))
        };
        let found = find(known().get(&key));
        found.unwrap_or_else(|| {
            let made = Arc::new(reduced(model));
            known().entry(key).or_default().push((Arc::clone(model), Arc::clone(&made)));
            made
        })
    }

    /// The scene with furniture as the shapes of its classes; furniture of unknown classes stays.
    pub(super) fn boxes(&self, scene: &Scene, catalog: &Catalog) -> Scene {
        let furniture = furniture(scene);
        let boxed = |index: usize, mesh: &SceneMesh| {
            let piece = furniture.get(&index)?;
            let class = catalog.classes.iter().find(|class| class.id == piece.class)?;
            let [width, depth, height] = piece.size;
            let model = stand_in(&mesh.model, &class.shape, Size { width, depth, height });
            let materials = own_materials(&scene.materials, &model);
            Some(SceneMesh { model: Arc::new(model), materials, ..mesh.clone() })
        };
        let meshes = scene.meshes.iter().enumerate();
        let meshes = meshes.map(|(index, mesh)| boxed(index, mesh).unwrap_or_else(|| mesh.clone()));
        Scene { meshes: meshes.collect(), ..scene.clone() }
    }
}

/// The pieces that meshes show, by the index of the mesh; of several the first.
fn furniture(scene: &Scene) -> BTreeMap<usize, &FurnitureExtras> {
    let mut found = BTreeMap::new();
    add(&scene.root, &mut found);
    found
}

fn add<'s>(node: &'s Node, found: &mut BTreeMap<usize, &'s FurnitureExtras>) {
    if let (Some(mesh), Some(Extras::Furniture(piece))) = (node.mesh, &node.extras) {
        found.entry(mesh).or_insert(piece);
    }
    node.children.iter().for_each(|child| add(child, found));
}
