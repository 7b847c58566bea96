//! Where the back of a piece at a wall is.

/// Where the back of a piece is, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// Index of the wall.
    pub(crate) wall: usize,
    /// From the wall's start to the nearer side of the piece.
    pub(crate) from: f64,
    /// From the wall to the back: 0 but for what stands before an open side.
    pub(crate) before: f64,
    /// From the floor to the underside.
    pub(crate) elevation: f64,
}

impl Spot {
    /// On the floor, at a wall.
    pub(crate) fn standing(wall: usize, from: f64) -> Self {
        Self { wall, from, before: 0.0, elevation: 0.0 }
    }

    /// Whether it is before an open side, with no wall behind.
    pub(crate) fn is_before_opening(&self) -> bool {
        self.before > 0.0
    }
}
