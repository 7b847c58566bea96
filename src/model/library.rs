//! The models of a catalogue, each built once.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use super::recipes::{PLAIN, RecipeInput, build_recipe, build_reduced_recipe, geometry_sets, recipe_names};
use super::stand_in::stand_in;
use super::stored::StoredModel;
use super::user::{UserModels, reduced};
use super::{Detail, Model};
use crate::cache::Cache;
use crate::catalog::{Catalog, Class, ClassIndex, ModelSource, Shape, Size};
use crate::document::{Fault, Faults, did_you_mean};

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
    id: String,
    sizes: Vec<Size>,
    looks: u32,
    shape: Shape,
    source: Source,
}

#[derive(Debug)]
enum Source {
    Recipe { name: String, parameters: Vec<(String, f64)>, models: Models },
    File(Vec<FittedFile>),
}

/// By level of detail, then geometry set, then variant.
type Models = [Vec<Vec<OnceLock<Arc<Model>>>>; Detail::ALL.len()];

/// A user's model in one size.
#[derive(Debug)]
struct FittedFile {
    model: Arc<Model>,
    reduced: OnceLock<Arc<Model>>,
    stand_in: OnceLock<Arc<Model>>,
}

impl ModelLibrary {
    /// Checks the recipe of every class, and reads and fits every user's model.
    ///
    /// # Errors
    /// All unknown recipes, and all faults of all model files, in the order of classes.
    pub fn load(catalog: &Catalog) -> Result<Self, Faults> {
        let mut faults = Faults::default();
        let mut files = UserModels::default();
        let mut classes = Vec::with_capacity(catalog.classes.len());
        for class in &catalog.classes {
            match source_of(class, &mut files) {
                Ok(source) => classes.push(Entry {
                    id: class.id.clone(),
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

    /// The model of a variant of a class in a geometry set; an unknown set counts as `plain`.
    ///
    /// # Panics
    /// If the class or the variant is none of the catalogue that was loaded.
    #[must_use]
    pub fn model(&self, class: ClassIndex, variant: u32, geometry: &str) -> Arc<Model> {
        self.model_in_detail(class, variant, geometry, Detail::Full)
    }

    /// [`ModelLibrary::model`] in a level of detail.
    ///
    /// # Panics
    /// As above.
    #[must_use]
    pub fn model_in_detail(
        &self,
        class: ClassIndex,
        variant: u32,
        geometry: &str,
        detail: Detail,
    ) -> Arc<Model> {
        let entry = &self.classes[class];
        match &entry.source {
            Source::File(files) => entry.file(&files[(variant / entry.looks) as usize], variant, detail),
            Source::Recipe { models, .. } => {
                let set = geometry_sets().iter().position(|&name| name == geometry).unwrap_or(plain_set());
                let build = || entry.build(variant, set, detail, self.cache.as_ref());
                Arc::clone(models[detail as usize][set][variant as usize].get_or_init(build))
            }
        }
    }
}

/// Position of the plain set.
fn plain_set() -> usize {
    geometry_sets().iter().position(|&name| name == PLAIN).unwrap_or(0)
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

    fn build(&self, variant: u32, set: usize, detail: Detail, cache: Option<&Cache>) -> Arc<Model> {
        let Source::Recipe { name, parameters, models } = &self.source else {
            unreachable!("files are read when the library is loaded")
        };
        let (size, look) = (self.size(variant), variant % self.looks);
        let known = |set: usize, detail: Detail| {
            let cell = &models[detail as usize][set][variant as usize];
            Arc::clone(cell.get_or_init(|| self.build(variant, set, detail, cache)))
        };
        let input = RecipeInput { size, look, geometry: geometry_sets()[set], parameters };
        let of_recipe = |build: fn(&str, &RecipeInput<'_>) -> Option<Model>| {
            let build = || build(name, &input).unwrap_or_else(|| panic!("class {} lost its recipe", self.id));
            let Some(cache) = cache else { return build() };
            let key = (
                "model",
                name,
                parameters,
                [size.width, size.depth, size.height],
                look,
                input.geometry,
                detail as u8,
            );
            cache.get_or_make(&key, || StoredModel::from(build())).into()
        };
        let model = match detail {
            Detail::Full => of_recipe(build_recipe),
            Detail::Reduced => of_recipe(build_reduced_recipe),
            // Quicker built than read.
            Detail::Boxes => stand_in(&known(set, Detail::Full), &self.shape, size),
        };
        if set == plain_set() {
            return Arc::new(model);
        }
        let plain = known(plain_set(), detail);
        if *plain == model { plain } else { Arc::new(model) }
    }
}

fn source_of(class: &Class, files: &mut UserModels) -> Result<Source, Faults> {
    match &class.model {
        ModelSource::Recipe { name, parameters } => {
            if recipe_names().binary_search(&name.as_str()).is_err() {
                return Err(unknown_recipe(class, name).into());
            }
            let slots = || (0..class.variant_count()).map(|_| OnceLock::new()).collect();
            let models = Detail::ALL.map(|_| geometry_sets().iter().map(|_| slots()).collect());
            Ok(Source::Recipe { name: name.clone(), parameters: parameters.clone(), models })
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

fn unknown_recipe(class: &Class, name: &str) -> Fault {
    let message = format!("class \"{}\" names the unknown model recipe \"{name}\"", class.id);
    let fault = Fault::of_file(Path::new("configs/classes"), message);
    match did_you_mean(name, recipe_names().iter().copied()) {
        Some(hint) => fault.with_hint(hint),
        None => fault,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn class(id: &str, recipe: &str) -> Class {
        let size = |width| Size { width, depth: 0.5, height: 0.9 };
        Class { looks: 2, ..Class::plain(id, vec![size(0.5), size(0.6)], recipe) }
    }

    fn library(recipe: &str) -> ModelLibrary {
        let catalog = Catalog { classes: vec![class("thing", recipe)], ..Catalog::default() };
        ModelLibrary::load(&catalog).unwrap()
    }

    #[test]
    fn equal_requests_share_one_model() {
        let library = library("chair");
        assert!(Arc::ptr_eq(&library.model(0, 1, PLAIN), &library.model(0, 1, PLAIN)));
        assert!(!Arc::ptr_eq(&library.model(0, 1, PLAIN), &library.model(0, 3, PLAIN)));
    }

    #[test]
    fn variants_are_sizes_times_looks() {
        let library = library("chair");
        let width = |variant| {
            let model = library.model(0, variant, PLAIN);
            model.primitives.iter().flat_map(|part| &part.positions).map(|p| p[0]).fold(0.0, f32::max) * 2.0
        };
        assert!((width(1) - 0.5).abs() < 0.001 && (width(2) - 0.6).abs() < 0.001);
    }

    #[test]
    fn sets_share_what_they_do_not_change() {
        // The third look of both sets is one automatic machine of metal.
        let machine = Class { looks: 4, ..class("thing", "coffee_machine") };
        let partly = ModelLibrary::load(&Catalog { classes: vec![machine], ..Catalog::default() }).unwrap();
        assert!(Arc::ptr_eq(&partly.model(0, 2, "industrial"), &partly.model(0, 2, PLAIN)));
        assert!(!Arc::ptr_eq(&partly.model(0, 2, "traditional"), &partly.model(0, 2, PLAIN)));
        let both = library("chair");
        assert!(!Arc::ptr_eq(&both.model(0, 0, "traditional"), &both.model(0, 0, PLAIN)));
        assert!(Arc::ptr_eq(&both.model(0, 0, "unknown"), &both.model(0, 0, PLAIN)));
    }

    #[test]
    fn levels_of_detail_are_coarser_and_coarser_in_the_same_box() {
        let library = library("bookshelf");
        let measure = |detail| {
            let model = library.model_in_detail(0, 1, "traditional", detail);
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
            let runs: Vec<_> = (0..4).map(|_| scope.spawn(|| library.model(0, 0, "traditional"))).collect();
            runs.into_iter().map(|run| run.join().unwrap()).collect()
        });
        assert!(models.iter().all(|model| Arc::ptr_eq(model, &models[0])));
    }

    #[test]
    fn a_kept_model_is_the_built_one() {
        let folder = tempfile::tempdir().unwrap();
        let cache = || Some(Cache::new(folder.path(), "1.0.0+test"));
        for detail in [Detail::Full, Detail::Reduced] {
            let model = |library: ModelLibrary| library.model_in_detail(0, 3, "traditional", detail);
            let built = model(library("bookshelf"));
            assert_eq!(model(library("bookshelf").with_cache(cache())), built);
            assert_eq!(model(library("bookshelf").with_cache(cache())), built, "read");
            assert_ne!(model(library("chair").with_cache(cache())), built, "of another recipe");
        }
    }

    #[test]
    fn users_models_have_levels_of_detail_too() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/stool.glb");
        let size = crate::model::model_file_size(&path, 0.0).unwrap();
        let model = ModelSource::File { path, turn: 0.0 };
        let class = Class { model, ..Class::plain("stool", vec![size], "stool") };
        let library = ModelLibrary::load(&Catalog { classes: vec![class], ..Catalog::default() }).unwrap();
        let count = |detail| -> usize {
            let model = library.model_in_detail(0, 0, PLAIN, detail);
            model.primitives.iter().map(|part| part.indices.len() / 3).sum()
        };
        let [full, reduced, boxes] = Detail::ALL.map(count);
        assert!(boxes < reduced && reduced < full, "{full}, {reduced}, {boxes}");
    }

    #[test]
    fn an_unknown_recipe_is_a_fault_with_a_suggestion() {
        let catalog = Catalog { classes: vec![class("thing", "chiar")], ..Catalog::default() };
        let faults = ModelLibrary::load(&catalog).unwrap_err();
        assert_eq!(faults.0.len(), 1);
        assert_eq!(faults.0[0].message, "class \"thing\" names the unknown model recipe \"chiar\"");
        assert_eq!(faults.0[0].hint.as_deref(), Some("did you mean \"chair\"?"));
    }
}
