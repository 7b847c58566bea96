//! Reads users' `.glb` and `.gltf` files as models, and finished levels as scenes (`scene.rs`).
//!
//! Taken are triangles of the default scene with all node transforms applied, positions, normals (flat ones
//! where the file has none), texture coordinates with the transforms of the images that use them, the first set of vertex
//! colours, materials with their five kinds of images and how those are sampled. Left out are cameras, lights, points, lines,
//! tangents and further sets of colours. Rejected, with a fault that names it, is all that would look wrong if it were left out,
//! such as motion and compression.

mod accessor;
mod container;
mod fit;
mod geometry;
mod laying;
mod material;
mod problem;
mod resource;
mod scene;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

pub(crate) use container::{companion_files, unchecked_document};
pub(crate) use resource::MODEL_BYTES_LIMIT;
pub(crate) use scene::read_scene;

use crate::document::Faults;
use crate::geometry::Size;
use crate::mesh::Model;

/// A user's model, read and turned, before it is fitted to a box.
#[derive(Clone, Debug)]
pub(crate) struct UserModel {
    path: PathBuf,
    model: Model,
}

impl UserModel {
    /// Reads a file; `turn` is in radians, counter-clockwise seen from above.
    ///
    /// # Errors
    /// A file that cannot be read, is no valid glTF 2.0, uses what is not read here, or is too large.
    pub(crate) fn read(path: &Path, turn: f64) -> Result<Self, Faults> {
        let model = read_model(path, turn).map_err(|problem| problem.in_file(path))?;
        Ok(Self { path: path.to_owned(), model })
    }

    /// The model scaled to the box of a class.
    ///
    /// # Errors
    /// Proportions that differ by more than a quarter.
    pub(crate) fn fitted(&self, class: &str, size: Size) -> Result<Model, Faults> {
        fit::fit(&self.model, class, size).map_err(|problem| problem.in_file(&self.path).into())
    }
}

/// The models of files, each file read once in each turn, however many classes name it.
#[derive(Debug, Default)]
pub(crate) struct UserModels {
    /// By path and turn, whose bits are compared.
    read: BTreeMap<(PathBuf, u64), Result<UserModel, Faults>>,
}

impl UserModels {
    /// The model of a file; see [`UserModel::read`].
    ///
    /// # Errors
    /// Those of [`UserModel::read`], each time.
    pub(crate) fn read(&mut self, path: &Path, turn: f64) -> Result<&UserModel, Faults> {
        let read = self.read.entry((path.to_owned(), turn.to_bits()));
        read.or_insert_with(|| UserModel::read(path, turn)).as_ref().map_err(Clone::clone)
    }
}

/// Width, depth and height of the model in a file, in the file's metres; `turn` is in radians.
///
/// # Errors
/// Those of [`UserModel::read`].
pub(crate) fn model_file_size(path: &Path, turn: f64) -> Result<Size, Faults> {
    UserModel::read(path, turn).map(|read| fit::size(&read.model))
}

fn read_model(path: &Path, turn: f64) -> Result<Model, problem::Problem> {
    let mut container = container::open(path)?;
    let materials = material::read_materials(path, &mut container)?;
    let numbers = accessor::Numbers { document: &container.document, buffers: &container.buffers };
    geometry::read_geometry(&numbers, &materials, turn)
}
