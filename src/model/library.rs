//! The models of a catalogue, each built once.

use std::sync::{Arc, OnceLock};

use super::reduce::reduced;
use super::stand_in::stand_in;
use super::{Detail, Model};
use crate::cache::Cache;
use crate::catalog::{Catalog, Class, ModelSource, Shape, Size, VariantRef};
use crate::document::Faults;
use crate::model_file::UserModels;
use crate::recipes::{GeometrySet, Mesh, Recipe, RecipeInput};

/// The models of all classes, variants and geometry sets; built when first asked for and then shared.
///
/// The same request gives the same [`Arc`], from any thread. A recipe without a form of its own in a set gives
/// the [`Arc`] of the plain one, and a user's model one [`Arc`] for all looks of a size.
#[derive(Debug)]
pub struct ModelLibrary {
    classes: Vec<Entry>,
    cache: Option<Cache>,
}

#[derive(Debug)]
struct Entry {
    sizes: Vec<Size>,
    looks: u32,
    shape: Shape,
    source: Source,
}

#[derive(Debug)]
enum Source {
    Recipe { recipe: &'static Recipe, parameters: Vec<(String, f64)>, models: Models },
    File(Vec<FittedFile>),
}

/// By level of detail, then geometry set, then variant.
type Models = Vec<[Vec<OnceLock<Arc<Model>>>; GeometrySet::ALL.len()]>;

/// A user's model in one size.
#[derive(Debug)]
struct FittedFile {
    model: Arc<Model>,
    reduced: OnceLock<Arc<Model>>,
    stand_in: OnceLock<Arc<Model>>,
}

impl ModelLibrary {
    /// Reads and fits every user's model; those of recipes are built when they are asked for.
    ///
    /// # Errors
    /// All faults of all model files, in the order of classes.
    pub fn load(catalog: &Catalog) -> Result<Self, Faults> {
        let mut faults = Faults::default();
        let mut files = UserModels::default();
        let mut classes = Vec::with_capacity(catalog.classes.len());
        for class in &catalog.classes {
            match source_of(class, &mut files) {
                Ok(source) => classes.push(Entry {
                    sizes: class.sizes.clone(),
                    looks: class.looks,
                    shape: class.shape.clone(),
                    source,
                }),
                Err(found) => faults.merge(found),
            }
        }
        if faults.is_empty() { Ok(Self { classes, cache: None }) } else { Err(faults) }
    }

    /// The same library that looks for models of recipes in a cache before it builds them, and keeps them there.
    #[must_use]
    pub fn with_cache(self, cache: Option<Cache>) -> Self {
        Self { cache, ..self }
    }

    /// The model of a variant of a class in a geometry set.
    ///
    /// # Panics
    /// If the class or the variant is none of the catalogue that was loaded.
    #[must_use]
    pub fn model(&self, of: VariantRef, set: GeometrySet) -> Arc<Model> {
        self.model_in_detail(of, set, Detail::Full)
    }

    /// [`ModelLibrary::model`] in a level of detail.
    ///
    /// # Panics
    /// As above.
    #[must_use]
    pub fn model_in_detail(&self, of: VariantRef, set: GeometrySet, detail: Detail) -> Arc<Model> {
        let VariantRef { class, variant } = of;
        let entry = &self.classes[class];
        match &entry.source {
            Source::File(files) => entry.file(&files[(variant / entry.looks) as usize], variant, detail),
            Source::Recipe { recipe, models, .. } => {
                let set = recipe.served(set);
                let build = || entry.build(variant, set, detail, self.cache.as_ref());
                Arc::clone(models[detail as usize][set as usize][variant as usize].get_or_init(build))
            }
        }
    }
}

impl Entry {
    fn size(&self, variant: u32) -> Size {
        self.sizes[(variant / self.looks) as usize]
    }

    fn file(&self, file: &FittedFile, variant: u32, detail: Detail) -> Arc<Model> {
        let model = match detail {
            Detail::Full => &file.model,
            Detail::Reduced => file.reduced.get_or_init(|| Arc::new(reduced(&file.model))),
            Detail::Boxes => {
                file.stand_in.get_or_init(|| Arc::new(stand_in(&file.model, &self.shape, self.size(variant))))
            }
        };
        Arc::clone(model)
    }

    fn build(&self, variant: u32, set: GeometrySet, detail: Detail, cache: Option<&Cache>) -> Arc<Model> {
        let Source::Recipe { recipe, parameters, models } = &self.source else {
            unreachable!("files are read when the library is loaded")
        };
        let (size, look) = (self.size(variant), variant % self.looks);
        let known = |set: GeometrySet, detail: Detail| {
            let cell = &models[detail as usize][set as usize][variant as usize];
            Arc::clone(cell.get_or_init(|| self.build(variant, set, detail, cache)))
        };
        let input = RecipeInput { size, look, geometry: set, parameters };
        let of_recipe = |build: &dyn Fn() -> Mesh| -> Model {
            let Some(cache) = cache else { return build().into() };
            let name = recipe.name();
            let extent = [size.width, size.depth, size.height];
            let key = ("model", name, parameters, extent, look, set.name(), detail as u8);
            cache.get_or_make(&key, build).into()
        };
        let model = match detail {
            Detail::Full => of_recipe(&|| recipe.build(&input)),
            Detail::Reduced => of_recipe(&|| recipe.build_reduced(&input, Detail::REDUCED_SHARE)),
            // Quicker built than read.
            Detail::Boxes => stand_in(&known(set, Detail::Full), &self.shape, size),
        };
        if set == GeometrySet::Plain {
            return Arc::new(model);
        }
        let plain = known(GeometrySet::Plain, detail);
        if *plain == model { plain } else { Arc::new(model) }
    }
}

fn source_of(class: &Class, files: &mut UserModels) -> Result<Source, Faults> {
    match &class.model {
        ModelSource::Recipe { recipe, parameters } => {
            let slots = || (0..class.variant_count()).map(|_| OnceLock::new()).collect();
            let models = Detail::ALL.iter().map(|_| GeometrySet::ALL.map(|_| slots())).collect();
            Ok(Source::Recipe { recipe, parameters: parameters.clone(), models })
        }
        ModelSource::File { path, turn } => {
            let read = files.read(path, *turn)?;
            let mut faults = Faults::default();
            let mut models = Vec::new();
            for &size in &class.sizes {
                match read.fitted(&class.id, size) {
                    Ok(model) => {
                        let [reduced, stand_in] = [OnceLock::new(), OnceLock::new()];
                        models.push(FittedFile { model: Arc::new(model), reduced, stand_in });
                    }
                    Err(found) => faults.merge(found),
                }
            }
            if faults.is_empty() { Ok(Source::File(models)) } else { Err(faults) }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::recipes::find;

    fn class(id: &str, recipe: &str) -> Class {
        let size = |width| Size { width, depth: 0.5, height: 0.9 };
        Class { looks: 2, ..Class::plain(id, vec![size(0.5), size(0.6)], find(recipe).unwrap()) }
    }

    fn library(recipe: &str) -> ModelLibrary {
        let catalog = Catalog { classes: vec![class("thing", recipe)], ..Catalog::default() };
        ModelLibrary::load(&catalog).unwrap()
    }

    #[test]
    fn equal_requests_share_one_model() {
        let library = library("chair");
        assert!(Arc::ptr_eq(
            &library.model(VariantRef::new(0, 1), GeometrySet::Plain),
            &library.model(VariantRef::new(0, 1), GeometrySet::Plain)
        ));
        assert!(!Arc::ptr_eq(
            &library.model(VariantRef::new(0, 1), GeometrySet::Plain),
            &library.model(VariantRef::new(0, 3), GeometrySet::Plain)
        ));
    }

    #[test]
    fn variants_are_sizes_times_looks() {
        let library = library("chair");
        let width = |variant| {
            let model = library.model(VariantRef::new(0, variant), GeometrySet::Plain);
            model.primitives.iter().flat_map(|part| &part.positions).map(|p| p[0]).fold(0.0, f32::max) * 2.0
        };
        assert!((width(1) - 0.5).abs() < 0.001 && (width(2) - 0.6).abs() < 0.001);
    }

    #[test]
    fn sets_share_what_they_do_not_change() {
        // The third look of both sets is one automatic machine of metal.
        let machine = Class { looks: 4, ..class("thing", "coffee_machine") };
        let partly = ModelLibrary::load(&Catalog { classes: vec![machine], ..Catalog::default() }).unwrap();
        assert!(Arc::ptr_eq(
            &partly.model(VariantRef::new(0, 2), GeometrySet::Industrial),
            &partly.model(VariantRef::new(0, 2), GeometrySet::Plain)
        ));
        assert!(!Arc::ptr_eq(
            &partly.model(VariantRef::new(0, 2), GeometrySet::Traditional),
            &partly.model(VariantRef::new(0, 2), GeometrySet::Plain)
        ));
        let both = library("chair");
        assert!(!Arc::ptr_eq(
            &both.model(VariantRef::new(0, 0), GeometrySet::Traditional),
            &both.model(VariantRef::new(0, 0), GeometrySet::Plain)
        ));
    }

    #[test]
    fn levels_of_detail_are_coarser_and_coarser_in_the_same_box() {
        let library = library("bookshelf");
        let measure = |detail| {
            let model = library.model_in_detail(VariantRef::new(0, 1), GeometrySet::Traditional, detail);
            let triangles: usize = model.primitives.iter().map(|part| part.indices.len() / 3).sum();
            let points = model.primitives.iter().flat_map(|part| &part.positions);
            let farthest = points.map(|p| f64::from(p[0].abs())).fold(0.0, f64::max);
            assert!((farthest - 0.25).abs() < 0.001, "{detail:?} is {farthest} wide");
            triangles as f64
        };
        let [full, reduced, boxes] = Detail::ALL.map(measure);
        assert!(reduced <= full * Detail::REDUCED_SHARE && reduced > 12.0, "{reduced} of {full}");
        assert_eq!(boxes, 12.0);
    }

    #[test]
    fn threads_share_one_model() {
        let library = library("bookshelf");
        let models: Vec<Arc<Model>> = std::thread::scope(|scope| {
            let runs: Vec<_> = (0..4)
                .map(|_| scope.spawn(|| library.model(VariantRef::new(0, 0), GeometrySet::Traditional)))
                .collect();
            runs.into_iter().map(|run| run.join().unwrap()).collect()
        });
        assert!(models.iter().all(|model| Arc::ptr_eq(model, &models[0])));
    }

    #[test]
    fn a_kept_model_is_the_built_one() {
        let folder = tempfile::tempdir().unwrap();
        let cache = || Some(Cache::new(folder.path(), "1.0.0+test"));
        for detail in [Detail::Full, Detail::Reduced] {
            let model = |library: ModelLibrary| {
                library.model_in_detail(VariantRef::new(0, 3), GeometrySet::Traditional, detail)
            };
            let built = model(library("bookshelf"));
            assert_eq!(model(library("bookshelf").with_cache(cache())), built);
            assert_eq!(model(library("bookshelf").with_cache(cache())), built, "read");
            assert_ne!(model(library("chair").with_cache(cache())), built, "of another recipe");
        }
    }

    #[test]
    fn users_models_have_levels_of_detail_too() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/stool.glb");
        let size = crate::model_file::model_file_size(&path, 0.0).unwrap();
        let model = ModelSource::File { path, turn: 0.0 };
        let class = Class { model, ..Class::plain("stool", vec![size], find("stool").unwrap()) };
        let library = ModelLibrary::load(&Catalog { classes: vec![class], ..Catalog::default() }).unwrap();
        let count = |detail| -> usize {
            let model = library.model_in_detail(VariantRef::new(0, 0), GeometrySet::Plain, detail);
            model.primitives.iter().map(|part| part.indices.len() / 3).sum()
        };
        let [full, reduced, boxes] = Detail::ALL.map(count);
        assert!(boxes < reduced && reduced < full, "{full}, {reduced}, {boxes}");
    }
}
