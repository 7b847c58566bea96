//! Furniture that is modelled by code: one recipe for each kind, known to the rest by a small interface.
//!
//! Callers may rely on this: a recipe builds for any positive size, its model touches all six sides of the
//! box, every part is closed and faces outwards, and the same request gives the same bytes.
//!
//! ```text
//! find("urinal") -> &'static Recipe -- build(&RecipeInput) -> Mesh: triangles by material slot
//! ```
//!
//! | to | read |
//! |---|---|
//! | call a recipe | `recipe.rs`, `input.rs`, `geometry_set.rs`, `mesh.rs`, `slot.rs`, `symbol.rs` |
//! | write one | `docs/recipe.md`, one file of `furniture/`, `kit/mod.rs` |
//!
//! Nothing here uses anything of the program but `geometry`.

mod furniture;
mod geometry_set;
mod input;
pub(crate) mod kit;
mod mesh;
mod recipe;
mod slot;
mod symbol;

pub(crate) use input::Draft;
pub use {
    geometry_set::GeometrySet,
    input::RecipeInput,
    mesh::{Mesh, MeshPart},
    recipe::Recipe,
    slot::Slot,
    symbol::Symbol,
};

use furniture::RECIPES;

/// All recipes, sorted by name.
#[must_use]
pub fn recipes() -> &'static [&'static Recipe] {
    RECIPES
}

/// The recipe of a name, the word in `model:` of a class.
#[must_use]
pub fn find(name: &str) -> Option<&'static Recipe> {
    RECIPES.binary_search_by(|recipe| recipe.name().cmp(name)).ok().map(|index| RECIPES[index])
}
