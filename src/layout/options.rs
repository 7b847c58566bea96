//! The options of a layout.

use super::lock::Lock;

/// The options of furnishing a room, besides plan and catalogue.
#[derive(Clone, Copy, Debug)]
pub struct FurnishOptions<'a> {
    /// The seed of the whole run.
    pub seed: u64,
    /// Id of the building, part of the room's seed.
    pub building: &'a str,
    /// Style or building style for rooms whose plan names none, where it suits their type; else
    /// [`crate::catalog::DEFAULT_STYLE`].
    pub style: Option<&'a str>,
    /// The seed of this room's furniture, in place of that of the run; the style is still drawn by that one.
    pub pinned: Option<u64>,
    /// Objects that stand before the others search.
    pub locks: &'a [Lock],
}

impl<'a> FurnishOptions<'a> {
    /// Nothing but a seed and a building.
    #[must_use]
    pub fn new(seed: u64, building: &'a str) -> Self {
        Self { seed, building, style: None, pinned: None, locks: &[] }
    }

    /// The same in a style.
    #[must_use]
    pub fn with_style(self, style: Option<&'a str>) -> Self {
        Self { style, ..self }
    }
}
