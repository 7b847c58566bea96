//! The input of a recipe, and the view of it that a form has.

use super::geometry_set::GeometrySet;
use super::kit::Sampler;
use crate::geometry::Size;

/// The request for a model.
#[derive(Clone, Copy, Debug)]
pub struct RecipeInput<'a> {
    /// Size of the box to fill, in metres.
    pub size: Size,
    /// The look: shapes, proportions and counts are drawn from a stream keyed by recipe and look.
    pub look: u32,
    /// The geometry set; a recipe without a form in it builds its stand-in.
    pub geometry: GeometrySet,
    /// Named numbers that differ from the recipe's defaults; unknown names are ignored here, the catalogue reports
    /// them.
    pub parameters: &'a [(String, f64)],
}

/// A [`RecipeInput`] on its way through a recipe.
pub(crate) struct Draft<'a> {
    /// Name of the recipe.
    pub(super) name: &'static str,
    /// Its parameters with their defaults.
    pub(super) defaults: &'static [(&'static str, f64)],
    /// The geometry set that it serves with the form that is built.
    pub(super) set: GeometrySet,
    /// The request.
    pub(crate) input: &'a RecipeInput<'a>,
}

/// The most pieces (drawers, doors, shelves) that a parameter may ask for.
const MOST_PIECES: f64 = 40.0;
/// Share of a piece's usual width or height that it needs at least.
const LEAST_PIECE: f64 = 0.25;

impl Draft<'_> {
    /// The stream of this look.
    pub(crate) fn sampler(&self) -> Sampler {
        Sampler::new(self.name, self.input.look)
    }

    /// Which of the four shapes of a form the look has: looks whose numbers are equal modulo four share one.
    pub(crate) fn form(&self) -> usize {
        self.input.look as usize % 4
    }

    /// The geometry set that is built.
    pub(crate) fn set(&self) -> GeometrySet {
        self.set
    }

    /// Whether the traditional set is built.
    pub(crate) fn is_traditional(&self) -> bool {
        self.set == GeometrySet::Traditional
    }

    /// Value of a parameter; its default where it is not given or no number.
    pub(crate) fn parameter(&self, name: &str) -> f64 {
        let given = self.input.parameters.iter().find(|(key, value)| key == name && value.is_finite());
        let default = || self.defaults.iter().find(|(key, _)| *key == name).map_or(0.0, |pair| pair.1);
        given.map_or_else(default, |pair| pair.1)
    }

    /// Whether a parameter is switched on.
    pub(crate) fn is_set(&self, name: &str) -> bool {
        self.parameter(name) > 0.0
    }

    /// How many pieces stand along a length in metres: as many as were asked for and have a quarter of their usual
    /// share of it, below which there is no room for edges and handles; or else as many as are usual, `most` at most.
    pub(crate) fn count_along(&self, name: &str, length: f64, usual: f64, most: u32) -> u32 {
        let room = (length / (usual * LEAST_PIECE)).floor().clamp(1.0, MOST_PIECES) as u32;
        self.count(name, (length / usual).round().clamp(1.0, f64::from(most)) as u32).min(room)
    }

    /// A count that was asked for, or else the recipe's own choice.
    pub(crate) fn count(&self, name: &str, choice: u32) -> u32 {
        let asked = self.parameter(name).round();
        if asked >= 1.0 { asked.min(MOST_PIECES) as u32 } else { choice.max(1) }
    }
}

#[cfg(test)]
mod tests {
    use super::super::find;
    use super::*;

    fn with_draft<T>(parameters: &[(String, f64)], check: impl Fn(&Draft) -> T) -> T {
        let size = Size { width: 1.6, depth: 0.8, height: 0.74 };
        let input = RecipeInput { size, look: 0, geometry: GeometrySet::Plain, parameters };
        check(&find("desk").unwrap().draft(&input))
    }

    #[test]
    fn a_given_number_wins_over_the_default() {
        let given = [("drawers".to_owned(), 3.0)];
        assert_eq!(with_draft(&given, |draft| draft.count("drawers", 9)), 3);
        assert_eq!(with_draft(&[], |draft| draft.count("drawers", 9)), 9);
    }

    #[test]
    fn pieces_without_room_are_not_made() {
        let given = [("drawers".to_owned(), 30.0)];
        let count = |length| with_draft(&given, |draft| draft.count_along("drawers", length, 0.2, 5));
        assert_eq!((count(0.01), count(0.52), count(1.6)), (1, 10, 30));
        let usual = |length| with_draft(&[], |draft| draft.count_along("drawers", length, 0.2, 5));
        assert_eq!((usual(0.01), usual(0.52), usual(1.6)), (1, 3, 5));
    }

    #[test]
    fn senseless_numbers_do_no_harm() {
        for value in [f64::NAN, f64::INFINITY, -3.0, 1e18] {
            let given = [("drawers".to_owned(), value)];
            let count = with_draft(&given, |draft| draft.count("drawers", 2));
            assert!((1..=MOST_PIECES as u32).contains(&count), "{value} gave {count}");
        }
    }
}
