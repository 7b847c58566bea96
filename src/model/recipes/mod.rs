//! Procedural models: one function per recipe, one file per family, one table of names.
//!
//! What callers may rely on: a recipe builds for any positive size, its model touches all six sides of the
//! box, every part is closed and faces outwards, and the same request gives the same bytes.
//!
//! Four geometry sets exist, one for each [`GeometrySet`]. Every recipe has a shape of its own in each.

mod apparatus;
mod appliances;
mod barber;
mod basins;
mod bathing;
mod beds;
mod belongings;
mod bin;
mod boards;
mod books;
mod car;
mod carts;
mod cash_register;
mod ceiling_panel;
#[cfg(test)]
mod checks;
mod clocks;
mod coat_stand;
mod computer;
mod cooker;
mod copier;
mod counter;
mod countertop;
mod cubicle;
mod desk_lamps;
mod dispenser;
mod fire_extinguisher;
mod football_table;
mod fridges;
mod gym;
mod hangings;
mod hook_board;
mod input;
mod keyboard;
mod kitchen;
mod lamps;
mod laptop;
mod laundry;
mod lights;
mod lounge;
mod luggage_belt;
mod luggage_rack;
mod microwave;
mod ovens;
mod papers;
mod partition;
mod parts;
mod phone;
mod plants;
mod projection_screen;
mod projector;
mod radiators;
mod rugs;
mod screens;
mod seating;
mod server_rack;
#[cfg(test)]
mod set_shapes;
mod shelving;
mod signage;
mod soap;
mod storage;
mod table;
mod tables;
mod tableware;
mod ticket_machine;
mod toilets;
mod towels;
mod toys;
mod umbrella_stand;
mod urinal;
mod utility_sink;
mod wall_lamps;
mod windows;
mod workbench;

pub use input::{GeometrySet, PLAIN, RecipeInput};
pub(crate) use table::{RECIPES, Recipe};

use std::sync::LazyLock;

use super::Model;
use crate::catalog::Size;

static NAMES: LazyLock<Vec<&'static str>> =
    LazyLock::new(|| RECIPES.iter().map(|recipe| recipe.name).collect());

/// Names of all recipes, sorted.
#[must_use]
pub fn recipe_names() -> &'static [&'static str] {
    &NAMES
}

/// Names of the geometry sets, sorted.
#[must_use]
pub fn geometry_sets() -> &'static [&'static str] {
    &GeometrySet::NAMES
}

/// Parameters of a recipe with their defaults, sorted by name; `None` for an unknown recipe. A count of zero
/// leaves the choice to the recipe, which goes by size and look.
#[must_use]
pub fn recipe_parameters(name: &str) -> Option<&'static [(&'static str, f64)]> {
    find(name).map(|recipe| recipe.parameters)
}

/// The size in metres that a recipe is drawn for; `None` for an unknown recipe.
#[must_use]
pub fn recipe_size(name: &str) -> Option<Size> {
    find(name).map(|recipe| {
        let [width, depth, height] = recipe.usual;
        Size { width, depth, height }
    })
}

/// Builds a model; `None` for an unknown recipe.
#[must_use]
pub fn build_recipe(name: &str, input: &RecipeInput) -> Option<Model> {
    find(name).map(|recipe| recipe.build(input))
}

/// Builds a model with fewer triangles, [`super::Detail::Reduced`]; `None` for an unknown recipe.
#[must_use]
pub(crate) fn build_reduced_recipe(name: &str, input: &RecipeInput) -> Option<Model> {
    find(name).map(|recipe| recipe.build_reduced(input))
}

fn find(name: &str) -> Option<&'static Recipe> {
    RECIPES.binary_search_by(|recipe| recipe.name.cmp(name)).ok().map(|index| &RECIPES[index])
}

#[cfg(test)]
mod tests;
