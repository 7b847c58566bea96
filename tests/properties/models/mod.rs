//! Properties of every recipe's models, over sizes, looks, sets and parameters.

mod agreement;
mod set_shapes;
mod tops;
mod welded;

use proptest::prelude::*;
use roomwright::internals::geometry::Size;
use roomwright::internals::recipes::{GeometrySet, Mesh, Recipe, RecipeInput, find, recipes};

use welded::{Welded, number_fault};

fn size([width, depth, height]: [f64; 3]) -> Size {
    Size { width, depth, height }
}

fn triangle_count(model: &Mesh) -> usize {
    model.parts.iter().map(|part| part.indices.len() / 3).sum()
}

/// Every parameter of a recipe on its own, and none.
fn parameter_choices(recipe: &Recipe) -> Vec<Vec<(String, f64)>> {
    let each = recipe.parameters().iter().map(|(key, _)| vec![((*key).to_owned(), 3.0)]);
    std::iter::once(Vec::new()).chain(each).collect()
}

/// A usual size and two that differ from it.
fn sizes_about(Size { width, depth, height }: Size) -> [Size; 3] {
    let factors = [[1.0, 1.0, 1.0], [1.3, 0.9, 1.0], [0.85, 1.1, 1.1]];
    factors.map(|[wide, deep, high]| size([width * wide, depth * deep, height * high]))
}

/// Calls `check` with every recipe in its usual size and two that differ, in all sets, with four looks.
fn for_every_recipe(mut check: impl FnMut(&Recipe, &RecipeInput) -> Option<String>) {
    let mut faults = Vec::new();
    for recipe in recipes() {
        for parameters in parameter_choices(recipe) {
            for (geometry, look) in
                GeometrySet::ALL.into_iter().flat_map(|set| (0..4).map(move |look| (set, look)))
            {
                let about = |size| RecipeInput { size, look, geometry, parameters: &parameters };
                let checked = sizes_about(recipe.usual_size()).map(|size| check(recipe, &about(size)));
                let found = checked.into_iter().flatten();
                faults.extend(found.map(|fault| {
                    format!("{} {geometry} look {look} {parameters:?}: {fault}", recipe.name())
                }));
            }
        }
    }
    faults.sort();
    let first_of_each =
        faults.chunk_by(|a, b| a.split(' ').next() == b.split(' ').next()).map(|chunk| &chunk[0]);
    let shown: Vec<&String> = first_of_each.collect();
    assert!(faults.is_empty(), "{} faults:\n{shown:#?}", faults.len());
}

#[test]
fn the_table_is_sorted_and_has_no_doubles() {
    assert!(recipes().windows(2).all(|pair| pair[0].name() < pair[1].name()));
    for recipe in recipes() {
        assert!(recipe.parameters().windows(2).all(|pair| pair[0].0 < pair[1].0), "{recipe:?}");
        assert_eq!(find(recipe.name()), Some(*recipe));
        assert!(GeometrySet::ALL.into_iter().any(|set| recipe.served(set) == set), "{recipe:?} has no form");
    }
    assert_eq!(find("spaceship"), None);
}

/// One test, for to build and weld thousands of models takes far longer than to look at them.
#[test]
fn models_fill_their_box_are_closed_face_outwards_and_stay_within_their_triangles() {
    for_every_recipe(|recipe, input| {
        let model = recipe.build(input);
        let welded = Welded::new(&model);
        let (count, most) = (triangle_count(&model), recipe.most_triangles());
        let faults = [
            number_fault(&model, input.size),
            welded.surface_fault(),
            // Two faces in one plane flicker.
            welded.flicker_fault(),
            (count > most).then(|| format!("{count} triangles, {most} are allowed")),
        ];
        let faults: Vec<String> = faults.into_iter().flatten().collect();
        (!faults.is_empty()).then(|| faults.join(", "))
    });
}

#[test]
fn recipes_build_to_size_themselves() {
    for_every_recipe(|recipe, input| {
        let misfit = recipe.misfit(input);
        let size = input.size;
        let allowed = 0.004 + 0.04 * size.width.min(size.depth).min(size.height);
        (misfit > allowed).then(|| format!("is off by {misfit} m before it is fitted"))
    });
}

#[test]
fn no_part_is_too_flat_for_its_form() {
    for_every_recipe(|recipe, input| {
        let count = recipe.flat_count(input);
        (count > 0).then(|| format!("{count} parts become boxes"))
    });
}

#[test]
fn a_recipe_builds_the_same_bytes_again() {
    for_every_recipe(|recipe, input| {
        let [first, second] = [0, 1].map(|_| recipe.build(input));
        (first != second).then(|| "differs from the first build".to_owned())
    });
}

#[test]
fn looks_differ_where_a_recipe_samples() {
    let parts = |look| {
        let input =
            RecipeInput { size: size([0.9, 0.3, 2.0]), look, geometry: GeometrySet::Plain, parameters: &[] };
        find("bookshelf").unwrap().build(&input)
    };
    assert_ne!(parts(0), parts(1));
}

/// The tests of all recipes build the size for walls.
#[test]
fn clocks_that_stand_are_sound_and_differ_between_the_sets() {
    let size = size([0.14, 0.08, 0.1]);
    for look in 0..4 {
        let build =
            |geometry| find("clock").unwrap().build(&RecipeInput { size, look, geometry, parameters: &[] });
        let models = GeometrySet::ALL.map(build);
        for (model, set) in models.iter().zip(GeometrySet::ALL) {
            let welded = Welded::new(model);
            let faults = [number_fault(model, size), welded.surface_fault(), welded.flicker_fault()];
            assert_eq!(faults, [None, None, None], "{set} {look}");
            assert!(triangle_count(model) <= 300, "{set} {look} has {} triangles", triangle_count(model));
        }
        for (index, model) in models.iter().enumerate() {
            assert!(!models[..index].contains(model), "{look}");
        }
    }
}

/// A model with a part that crosses itself, is open or is shaded from behind.
fn broken(recipe: &Recipe, input: &RecipeInput) -> Option<String> {
    let model = recipe.build(input);
    let is_empty = model.parts.iter().any(|part| part.indices.is_empty());
    let empty = is_empty.then(|| "a material without triangles".to_owned());
    empty.or_else(|| number_fault(&model, input.size)).or_else(|| Welded::new(&model).surface_fault())
}

/// Boxes in which the back of a bench crossed itself, and in which the lid of a computer was shaded from behind.
#[test]
fn thin_boxes_do_not_break_a_recipe() {
    let boxes = [
        ("exercise_bench", 0, [0.03, 0.9, 0.03]),
        ("exercise_bench", 0, [0.193, 0.8833, 3.5016]),
        ("exercise_bench", 0, [2.5, 0.9064, 0.0416]),
        ("exercise_bench", 1, [0.03, 0.92, 0.03]),
        ("exercise_bench", 1, [1.5, 0.91, 1.2]),
        ("laptop", 0, [3.05, 2.94, 0.089]),
        ("laptop", 0, [2.23, 0.115, 1.2]),
        ("laptop", 0, [0.9826, 0.12016, 0.44344]),
        ("laptop", 0, [0.0619, 0.064, 0.038]),
    ];
    for (name, set, extents) in boxes {
        let geometry = GeometrySet::ALL[set];
        let input = RecipeInput { size: size(extents), look: 0, geometry, parameters: &[] };
        assert_eq!(broken(find(name).unwrap(), &input), None, "{name} {geometry} {extents:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    /// Users' classes may pair any recipe with any size and any number.
    #[test]
    fn no_size_or_number_breaks_a_recipe(
        recipe in 0..recipes().len(),
        extents in prop::array::uniform3(0.03_f64..4.0),
        look in 0_u32..50,
        set in 0_usize..GeometrySet::ALL.len(),
        value in prop::num::f64::ANY,
    ) {
        let recipe = recipes()[recipe];
        let parameters: Vec<(String, f64)> =
            recipe.parameters().iter().map(|(key, _)| ((*key).to_owned(), value)).collect();
        let input = RecipeInput { size: size(extents), look, geometry: GeometrySet::ALL[set], parameters: &parameters };
        prop_assert_eq!(broken(recipe, &input), None, "{:?} {:?}", recipe, extents);
    }
}
