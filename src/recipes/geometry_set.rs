//! Geometry sets: families of shapes, of which a style chooses one.

use std::fmt;

/// A family of shapes. Sets differ in shapes and construction; colours come from palettes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum GeometrySet {
    /// Bought cheaply: thin laminated boards, tubular steel, moulded plastic, no ornament.
    Budget,
    /// Workshop and loft: steel angles and pipes, thick planks, bolts, wire and lattice.
    Industrial,
    /// Plain modern: flush fronts, tapered legs, hidden handles. The set of styles that name no other.
    #[default]
    Plain,
    /// Turned legs, mouldings, panelled doors, cornices, knobs.
    Traditional,
}

impl GeometrySet {
    /// All sets, sorted by name.
    pub const ALL: [Self; 4] = [Self::Budget, Self::Industrial, Self::Plain, Self::Traditional];

    /// The word in `geometry:` of a style.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["budget", "industrial", "plain", "traditional"][self as usize]
    }

    /// The set of a name, if there is one.
    #[must_use]
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|set| set.name() == name)
    }
}

impl fmt::Display for GeometrySet {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.name())
    }
}
