//! A recipe: what the engine knows of a piece of furniture that is modelled by code.

use std::fmt;

use super::geometry_set::GeometrySet;
use super::input::{Draft, RecipeInput};
use super::kit::Builder;
use super::mesh::Mesh;
use super::symbol::Symbol;
use crate::geometry::Size;

/// Adds the parts of one form to a builder.
pub(super) type Form = fn(&Draft, &mut Builder);

/// A recipe: name, usual size, parameters, symbol and forms. Each stands in `furniture/`, beside its forms:
///
/// ```text
/// pub(super) static URINAL: Recipe = Recipe::furniture("urinal", [0.4, 0.36, 0.7])
///     .symbol(Symbol::Basin)
///     .plain(shell)
///     .traditional(hooded);
/// ```
///
/// The first form that is named stands in for the sets that have none.
pub struct Recipe {
    name: &'static str,
    usual_size: Size,
    most_triangles: usize,
    is_round: bool,
    parameters: &'static [(&'static str, f64)],
    symbol: Option<Symbol>,
    /// A parameter, and the symbol where it is above zero.
    special_symbol: Option<(&'static str, Symbol)>,
    /// By geometry set.
    forms: [Option<Form>; GeometrySet::ALL.len()],
    /// The set that is built in place of those without a form.
    stand_in: Option<GeometrySet>,
}

/// Share of the usual size under which a piece is not drawn anew but scaled down, so that boards and legs of fixed
/// thickness still find room.
const LEAST_SHARE: f64 = 0.6;
/// The most triangles of furniture.
const FURNITURE_TRIANGLES: usize = 2500;
/// The most triangles of what stands on furniture, hangs on walls or gives light.
const ACCESSORY_TRIANGLES: usize = 300;

/// How a recipe is written down.
impl Recipe {
    /// Furniture that is drawn for a width, depth and height in metres, without forms yet.
    pub(super) const fn furniture(name: &'static str, [width, depth, height]: [f64; 3]) -> Self {
        Self {
            name,
            usual_size: Size { width, depth, height },
            most_triangles: FURNITURE_TRIANGLES,
            is_round: false,
            parameters: &[],
            symbol: None,
            special_symbol: None,
            forms: [None; GeometrySet::ALL.len()],
            stand_in: None,
        }
    }

    /// The same of what stands on furniture, hangs on walls or gives light, which has fewer triangles.
    pub(super) const fn accessory(name: &'static str, usual_size: [f64; 3]) -> Self {
        Self { most_triangles: ACCESSORY_TRIANGLES, ..Self::furniture(name, usual_size) }
    }

    /// Drawn in a square seen from above and stretched to the box, because most of it is round.
    pub(super) const fn round(mut self) -> Self {
        self.is_round = true;
        self
    }

    /// Parameters with their defaults, sorted by name. A count of zero leaves the choice to the recipe.
    pub(super) const fn with(mut self, parameters: &'static [(&'static str, f64)]) -> Self {
        self.parameters = parameters;
        self
    }

    /// How drawings show it; without a symbol it is an outline.
    pub(super) const fn symbol(mut self, symbol: Symbol) -> Self {
        self.symbol = Some(symbol);
        self
    }

    /// How drawings show it where a parameter is above zero.
    pub(super) const fn symbol_where(mut self, parameter: &'static str, symbol: Symbol) -> Self {
        self.special_symbol = Some((parameter, symbol));
        self
    }

    /// The form of [`GeometrySet::Budget`].
    pub(super) const fn budget(self, form: Form) -> Self {
        self.form(GeometrySet::Budget, form)
    }

    /// The form of [`GeometrySet::Industrial`].
    pub(super) const fn industrial(self, form: Form) -> Self {
        self.form(GeometrySet::Industrial, form)
    }

    /// The form of [`GeometrySet::Plain`].
    pub(super) const fn plain(self, form: Form) -> Self {
        self.form(GeometrySet::Plain, form)
    }

    /// The form of [`GeometrySet::Traditional`].
    pub(super) const fn traditional(self, form: Form) -> Self {
        self.form(GeometrySet::Traditional, form)
    }

    /// One function for all sets, which asks [`Draft::set`] where they differ.
    pub(super) const fn every_set(self, form: Form) -> Self {
        self.plain(form).traditional(form).industrial(form).budget(form)
    }

    const fn form(mut self, set: GeometrySet, form: Form) -> Self {
        if self.stand_in.is_none() {
            self.stand_in = Some(set);
        }
        self.forms[set as usize] = Some(form);
        self
    }
}

/// The interface for the engine.
impl Recipe {
    /// The word in `model:` of a class.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The size that it is drawn for.
    #[must_use]
    pub fn usual_size(&self) -> Size {
        self.usual_size
    }

    /// Parameters with their defaults, sorted by name. A count of zero leaves the choice to the recipe, which goes by
    /// size and look.
    #[must_use]
    pub fn parameters(&self) -> &'static [(&'static str, f64)] {
        self.parameters
    }

    /// The most triangles that it makes in about its usual size.
    #[must_use]
    pub fn most_triangles(&self) -> usize {
        self.most_triangles
    }

    /// The set whose form it builds for a set: the same one, or the stand-in where it has no form of its own.
    #[must_use]
    pub fn served(&self, set: GeometrySet) -> GeometrySet {
        if self.forms[set as usize].is_some() { set } else { self.stand_in.expect("a recipe names a form") }
    }

    /// How drawings show it with these parameters, if as more than an outline.
    #[must_use]
    pub fn symbol_of(&self, parameters: &[(String, f64)]) -> Option<Symbol> {
        let special = self.special_symbol.filter(|(parameter, _)| {
            parameters.iter().any(|(name, value)| name == parameter && *value > 0.0)
        });
        special.map(|(_, symbol)| symbol).or(self.symbol)
    }

    /// The finished model.
    #[must_use]
    pub fn build(&self, input: &RecipeInput) -> Mesh {
        self.parts(input).finish(input.size)
    }

    /// The model with at most this share of its triangles, as far as its parts allow.
    #[must_use]
    pub fn build_reduced(&self, input: &RecipeInput, share: f64) -> Mesh {
        self.parts(input).finish_reduced(input.size, share)
    }

    /// How far, in metres, its parts are from the six sides of the box before they are fitted into it: what the form of the recipe
    /// gets wrong.
    #[must_use]
    pub fn misfit(&self, input: &RecipeInput) -> f64 {
        self.parts(input).misfit()
    }

    /// How many of its parts are too flat for their form and become boxes.
    #[must_use]
    pub fn flat_count(&self, input: &RecipeInput) -> usize {
        self.parts(input).flat_count()
    }

    /// The parts before they are fitted to the box.
    fn parts(&self, input: &RecipeInput) -> Builder {
        let mut builder = Builder::new(self.drawn_size(input.size));
        let draft = self.draft(input);
        let form = self.forms[draft.set() as usize].expect("sets that are served have a form");
        form(&draft, &mut builder);
        builder
    }

    /// The argument of its form.
    pub(super) fn draft<'a>(&self, input: &'a RecipeInput<'a>) -> Draft<'a> {
        Draft { name: self.name, defaults: self.parameters, set: self.served(input.geometry), input }
    }

    fn drawn_size(&self, size: Size) -> Size {
        let least = self.usual_size;
        let size = Size {
            width: size.width.max(least.width * LEAST_SHARE),
            depth: size.depth.max(least.depth * LEAST_SHARE),
            height: size.height.max(least.height * LEAST_SHARE),
        };
        let side = size.width.min(size.depth);
        if self.is_round { Size { width: side, depth: side, ..size } } else { size }
    }
}

impl PartialEq for Recipe {
    /// Names tell recipes apart.
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl fmt::Debug for Recipe {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "Recipe({})", self.name)
    }
}
