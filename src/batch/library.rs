//! The geometry that floors share instead of each carrying a copy.

use std::collections::BTreeSet;
use std::sync::Arc;

use rayon::prelude::*;

use crate::catalog::{Catalog, ClassIndex};
use crate::gltf::{FlatNormals, LibraryReference, Painting, SharedLibrary};
use crate::model::{Detail, Model, ModelLibrary, ModelMaterial, TextureUse};
use crate::scene::ModelKey;
use crate::texture::has_relief;

use super::LIBRARY_FOLDER;
use super::fault::OutputFault;
use super::files::with_record;
use super::folder::OutputFolder;
use super::job::BakeOptions;
use super::record::FileRecord;

/// Digits of the content's hash in the library's name.
const NAME_DIGITS: usize = 16;

/// A library that is in place.
pub(crate) struct GeometryLibrary {
    /// The file.
    pub(crate) file: FileRecord,
    shared: SharedLibrary,
    /// From the folder of a building.
    relative_path: String,
}

impl GeometryLibrary {
    /// How the levels of a building refer to it.
    pub(crate) fn reference(&self) -> LibraryReference<'_> {
        LibraryReference { library: &self.shared, path: &self.relative_path }
    }

    /// Builds every model that any level may use and writes them to one file. Its content depends on the
    /// catalogue only, so that processes and shards agree on it; its name tells its content, so that runs
    /// with other catalogues do not disturb each other.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn create(
        catalog: &Catalog,
        models: &ModelLibrary,
        folder: &OutputFolder,
        options: &BakeOptions,
    ) -> Result<Self, OutputFault> {
        let built = all_models(catalog, models, options.detail);
        let models = built.iter().map(|(key, model)| (key.clone(), model.as_ref()));
        let shared = SharedLibrary::new(models, |material| painting(catalog, material, options));
        let (mut file, bytes) = with_record(String::new(), shared.bytes());
        let name = format!("{LIBRARY_FOLDER}/{}.bin", &file.sha256[..NAME_DIGITS]);
        let relative_path = format!("../{name}");
        file.path = name;
        folder.announce(std::slice::from_ref(&file))?;
        folder.place(&file, &bytes)?;
        folder.record_library_file(&file)?;
        Ok(Self { file, shared, relative_path })
    }
}

/// What is painted on a material, in any palette.
fn painting(catalog: &Catalog, material: &ModelMaterial, options: &BakeOptions) -> Painting {
    let has_textures = options.textures.size.is_some();
    let lacks_flat_normals = options.flat_normals == FlatNormals::Implied;
    match material {
        ModelMaterial::Slot(slot) => {
            let materials = catalog.palettes.values().filter_map(|palette| palette.materials.get(*slot));
            let surfaces: Vec<&str> = materials.filter_map(|material| material.texture).collect();
            Painting {
                has_coordinates: has_textures && !surfaces.is_empty(),
                has_tangents: has_textures && surfaces.into_iter().any(has_relief),
                normal_set: 0,
                lacks_flat_normals,
            }
        }
        ModelMaterial::Own(own) => {
            let normal = own.textures.iter().find(|(purpose, _)| *purpose == TextureUse::Normal);
            Painting {
                has_coordinates: !own.textures.is_empty(),
                has_tangents: normal.is_some(),
                normal_set: normal.map_or(0, |(_, texture)| texture.coordinate_set),
                lacks_flat_normals,
            }
        }
    }
}

/// All models in a level of detail, built on as many threads as there are.
fn all_models(catalog: &Catalog, models: &ModelLibrary, detail: Detail) -> Vec<(ModelKey, Arc<Model>)> {
    let geometries: BTreeSet<&str> = catalog.styles.values().map(|style| style.geometry.as_str()).collect();
    let of_class = |class: ClassIndex| {
        let geometries = geometries.clone();
        let count = catalog.classes[class].variant_count();
        (0..count).flat_map(move |variant| {
            geometries.clone().into_iter().map(move |geometry| (class, variant, geometry))
        })
    };
    let build = |(class, variant, geometry): (ClassIndex, u32, &str)| {
        let id = catalog.classes[class].id.clone();
        let key = ModelKey { class: id, variant, geometry: geometry.to_owned() };
        (key, models.model_in_detail(class, variant, geometry, detail))
    };
    let wanted: Vec<(ClassIndex, u32, &str)> = (0..catalog.classes.len()).flat_map(of_class).collect();
    wanted.into_par_iter().map(build).collect()
}
