//! How architects draw furniture from above.

use crate::geometry::Point;

/// The lines inside the outline of a piece. A recipe names its symbol; `draw/symbols.rs` draws the lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Symbol {
    /// Pillows, and a blanket that is turned back.
    Bed,
    /// Arms, a back, cushions.
    Sofa,
    /// A seat before a back.
    Chair,
    /// A cistern and a bowl.
    Toilet,
    /// A basin and its tap.
    Basin,
    /// A tub inside its rim, with a drain.
    Tub,
    /// Falls from all corners to a drain.
    Shower,
    /// Rings to cook on.
    Cooker,
    /// Two diagonals: what is cold.
    Fridge,
    /// One diagonal: another machine, or a tall cupboard.
    Diagonal,
    /// A drum.
    Drum,
    /// A rail and what hangs on it.
    Wardrobe,
    /// The doors' line along the front.
    Doors,
    /// The boards' line along the back.
    Shelf,
    /// Leaves around a stem.
    Plant,
    /// A cross in a circle.
    Lamp,
    /// A frame inside the outline.
    Frame,
    /// A line across the middle.
    Net,
    /// A border along the edges.
    Rug,
}

impl Symbol {
    /// All symbols.
    pub const ALL: [Self; 19] = [
        Self::Bed,
        Self::Sofa,
        Self::Chair,
        Self::Toilet,
        Self::Basin,
        Self::Tub,
        Self::Shower,
        Self::Cooker,
        Self::Fridge,
        Self::Diagonal,
        Self::Drum,
        Self::Wardrobe,
        Self::Doors,
        Self::Shelf,
        Self::Plant,
        Self::Lamp,
        Self::Frame,
        Self::Net,
        Self::Rug,
    ];

    /// The pieces that it stands for.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Bed => "bed, couch",
            Self::Sofa => "sofa, armchair",
            Self::Chair => "chair",
            Self::Toilet => "toilet",
            Self::Basin => "basin, sink",
            Self::Tub => "bath",
            Self::Shower => "shower",
            Self::Cooker => "cooker",
            Self::Fridge => "fridge, freezer",
            Self::Diagonal => "machine",
            Self::Drum => "washing machine",
            Self::Wardrobe => "wardrobe",
            Self::Doors => "cabinet, drawers",
            Self::Shelf => "shelves",
            Self::Plant => "plant",
            Self::Lamp => "lamp",
            Self::Frame => "table or case",
            Self::Net => "two-sided piece",
            Self::Rug => "rug",
        }
    }

    /// Width and depth in metres of what usually has it.
    #[must_use]
    pub fn usual_size(self) -> Point {
        let (width, depth) = match self {
            Self::Bed => (1.6, 2.0),
            Self::Sofa => (1.9, 0.9),
            Self::Chair => (0.5, 0.5),
            Self::Toilet => (0.5, 0.7),
            Self::Basin => (0.6, 0.5),
            Self::Tub => (1.7, 0.75),
            Self::Shower => (0.9, 0.9),
            Self::Cooker | Self::Fridge | Self::Diagonal | Self::Drum => (0.6, 0.6),
            Self::Wardrobe => (1.5, 0.6),
            Self::Doors => (1.0, 0.45),
            Self::Shelf => (1.0, 0.4),
            Self::Plant | Self::Lamp => (0.5, 0.5),
            Self::Frame => (1.6, 0.9),
            Self::Net => (1.5, 0.9),
            Self::Rug => (1.7, 1.2),
        };
        Point::new(width, depth)
    }
}
