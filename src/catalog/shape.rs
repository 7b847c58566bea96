//! The solid parts of a class.

/// The solid parts of a class inside its box. Fractions scale with the size, metres do not.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The whole box.
    Box,
    /// An upright cylinder (an ellipse where width and depth differ).
    Disc,
    /// Several convex prisms: a table top and its legs, the two arms of an L.
    Prisms(Vec<PrismRule>),
}

impl Shape {
    /// Whether one part reaches to all four sides of the box, so that it holds the disc around the box's middle.
    #[must_use]
    pub fn fills_its_box(&self) -> bool {
        let is_low = |extent: &Extent| extent.share <= 0.0 && extent.offset <= 0.0;
        let is_high = |extent: &Extent| extent.share >= 1.0 && extent.offset >= 0.0;
        match self {
            Self::Box | Self::Disc => true,
            Self::Prisms(parts) => parts
                .iter()
                .any(|part| part.low[..2].iter().all(is_low) && part.high[..2].iter().all(is_high)),
        }
    }

    /// Whether what stands on its top stands on a disc and not on a rectangle.
    #[must_use]
    pub fn is_round_on_top(&self) -> bool {
        let reaches_top = |part: &&PrismRule| part.high[2].share >= 1.0 && part.high[2].offset >= 0.0;
        match self {
            Self::Box => false,
            Self::Disc => true,
            Self::Prisms(parts) => parts.iter().filter(reaches_top).all(|part| part.is_disc),
        }
    }
}

/// A box-shaped or disc-shaped part of a [`Shape`], given by its faces.
#[derive(Clone, Debug, PartialEq)]
pub struct PrismRule {
    /// Whether the part is round.
    pub is_disc: bool,
    /// Left, front, underside.
    pub low: [Extent; 3],
    /// Right, back, top.
    pub high: [Extent; 3],
}

/// A coordinate inside a box: `share × length + offset`, from the low end of that axis (left, front, below).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Share of the box's length along the axis, 0 to 1.
    pub share: f64,
    /// Metres added.
    pub offset: f64,
}
