//! A home as its file has it, in metres, with y to the north and angles counter-clockwise.

use crate::geometry::Point;

/// The format's word in `room_words.yaml`.
pub(super) const NAME: &str = "sweet_home";

/// All of a home that is read.
#[derive(Clone, Debug, Default)]
pub(super) struct Home {
    pub(super) name: Option<String>,
    /// Metres of walls that say no height.
    pub(super) wall_height: f64,
    pub(super) levels: Vec<HomeLevel>,
    pub(super) rooms: Vec<HomeRoom>,
    pub(super) walls: Vec<HomeWall>,
    pub(super) pieces: Vec<Piece>,
}

/// A level.
#[derive(Clone, Debug)]
pub(super) struct HomeLevel {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) elevation: f64,
    pub(super) floor_thickness: f64,
    /// Metres from its floor to its ceiling.
    pub(super) height: f64,
    /// Byte of the text at which it stands; so for all others.
    pub(super) place: usize,
}

/// A room: a polygon of its own, which need not fit the walls.
#[derive(Clone, Debug)]
pub(super) struct HomeRoom {
    pub(super) id: Option<String>,
    pub(super) level: Option<String>,
    pub(super) name: Option<String>,
    pub(super) outline: Vec<Point>,
    pub(super) place: usize,
}

/// A wall along its centre line.
#[derive(Clone, Debug)]
pub(super) struct HomeWall {
    pub(super) level: Option<String>,
    pub(super) start: Point,
    pub(super) end: Point,
    pub(super) thickness: f64,
    pub(super) height: Option<f64>,
    pub(super) height_at_end: Option<f64>,
    /// Radians of the arc around which it runs; zero if it is straight.
    pub(super) arc: f64,
    pub(super) place: usize,
}

/// Furniture, a door or a window.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) id: Option<String>,
    pub(super) level: Option<String>,
    /// The word of the catalogue that it comes from; none of pieces of the user's own.
    pub(super) catalog_id: Option<String>,
    pub(super) name: String,
    /// Middle of its box.
    pub(super) center: Point,
    /// Radians; at zero its front faces −y.
    pub(super) angle: f64,
    /// Metres: width, depth, height.
    pub(super) size: [f64; 3],
    /// Metres of its underside above the floor of its level.
    pub(super) elevation: f64,
    pub(super) is_mirrored: bool,
    /// Whether the ceiling above it is cut out.
    pub(super) is_staircase: bool,
    /// What it cuts out of a wall; none of furniture.
    pub(super) cut: Option<Cut>,
    pub(super) place: usize,
}

/// What a door or window cuts out of its wall, as shares of its box, from the left, from the back, from above.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    pub(super) wall_thickness: f64,
    pub(super) wall_distance: f64,
    pub(super) wall_left: f64,
    pub(super) wall_width: f64,
    pub(super) wall_top: f64,
    pub(super) wall_height: f64,
    pub(super) sashes: Vec<Sash>,
}

/// A leaf: its hinge and length as shares of the box (from the left, from the back), and the radians of its two positions,
/// counter-clockwise from the direction to the right.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sash {
    pub(super) hinge: [f64; 2],
    pub(super) width: f64,
    pub(super) angles: [f64; 2],
}

impl Piece {
    /// Unit vector to its right, seen from its back.
    pub(super) fn axis(&self) -> Point {
        let (sine, cosine) = libm::sincos(self.angle);
        Point::new(cosine, sine)
    }

    /// The place of shares of its box, from the left and from the back.
    pub(super) fn at(&self, [right, front]: [f64; 2]) -> Point {
        let right = if self.is_mirrored { 0.5 - right } else { right - 0.5 };
        let axis = self.axis();
        self.center + axis * (right * self.size[0]) - axis.perp() * ((front - 0.5) * self.size[1])
    }

    /// The corners of its box on the floor.
    pub(super) fn corners(&self) -> Vec<Point> {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|corner| self.at(corner)).to_vec()
    }
}
