//! Classes of furniture (the paper's sections 3.2 and 4.3, and the additions of `configs/`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::building_style::Share;
use super::light::Light;
use super::shape::Shape;
use super::style::Era;
use super::variety::Variety;
use crate::geometry::{Point, Side, Size};
use crate::recipes::Recipe;

/// Index of a class in [`crate::catalog::Catalog::classes`].
pub type ClassIndex = usize;

/// A variant of a class of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct VariantRef {
    /// The class.
    pub class: ClassIndex,
    /// The variant, below [`Class::variant_count`].
    pub variant: u32,
}

impl VariantRef {
    /// A variant of a class.
    #[must_use]
    pub fn new(class: ClassIndex, variant: u32) -> Self {
        Self { class, variant }
    }
}

/// Metres of height up to which what lies on the floor is stood on and walked over like the floor itself: the highest
/// threshold without a barrier (DIN 18040-2, 4.3.3.1).
pub const COVERING_HEIGHT: f64 = 0.02;

/// One class of furniture, all inheritance resolved.
///
/// The frame of a class, seen from above: width along x, depth along y, origin in the middle of the
/// underside, the front at −y (towards the person who uses it), left and right as that person sees them.
///
/// ```text
///            back
///        +----------+
///  left  |          |  right     y ↑
///        +----------+              → x
///            front
/// ```
#[derive(Clone, Debug)]
pub struct Class {
    /// The word used in configuration, names and messages.
    pub id: String,
    /// A title for people.
    pub label: String,
    /// Further names under which others may refer to it (`seat`, `surface`, `sleeping`), sorted.
    pub groups: Vec<String>,
    /// The sizes it is made in; at least one.
    pub sizes: Vec<Size>,
    /// How many of them, from the first, a room asks for; the others are taken where none of these has a place.
    pub usual_sizes: usize,
    /// How many of them, from the last, only fill niches: a piece that is placed with others ([`Class::is_joint`]) takes one where it
    /// reaches from a corner to what closes its other side.
    pub niche_sizes: usize,
    /// How many looks of each size the model recipe makes; at least one.
    pub looks: u32,
    /// How much pieces that are furnished together differ.
    pub variety: Variety,
    /// Whose pieces are alike, where it is not for the rooms to say: baths and kitchens come with the building.
    pub share: Option<Share>,
    /// The solid parts of its box.
    pub shape: Shape,
    /// Where it may stand, best first.
    pub parents: Vec<ParentRule>,
    /// The places that its own sides offer to children, by [`Side::index`].
    pub sides: [SideOffer; 6],
    /// Regions before its sides that no body may enter.
    pub clearances: Vec<Clearance>,
    /// Further regions of which one is enough: people get into a bed by one of its sides.
    pub either: Vec<Clearance>,
    /// Wishes about other objects that are not its parent.
    pub relations: Vec<Relation>,
    /// Under whom it lies on the floor, best first; empty for what is no rug.
    pub covers: Vec<ClassIndex>,
    /// The classes that stand in for it where others are counted by it: those in a group of its name.
    pub stand_ins: Vec<ClassIndex>,
    /// What it is there to carry: it is taken away again where none of these stands on it; empty for what needs nothing.
    pub carries: Vec<ClassIndex>,
    /// Whether it is taken away again where no other of its class stands beside it: seats in rows, shelves between aisles.
    pub needs_company: bool,
    /// Regular intervals instead of random positions (section 3.3).
    pub grid: Option<Grid>,
    /// The part that it plays in a row of fitted units, which a room plans as a whole; `None` for what is no such unit.
    pub fitted: Option<FittedPart>,
    /// Whether its place is sought together with those of the room's other such pieces, before anything else.
    pub is_joint: bool,
    /// The walls that it likes.
    pub walls: WallWishes,
    /// Pieces with a lower number are given up first when room is short.
    pub priority: i32,
    /// The eras whose styles it is drawn in; empty for any.
    pub eras: Vec<Era>,
    /// The wealth of the styles that it is drawn in, lowest and highest; `None` for any.
    pub wealth: Option<(u32, u32)>,
    /// How it looks.
    pub model: ModelSource,
    /// The light that it gives.
    pub light: Option<Light>,
    /// Expected depth in the hierarchy: 0 for what stands on room parts, else one more than its nearest
    /// possible parent class. Agents are served in this order (section 3.2).
    pub depth: u32,
}

impl Class {
    /// A box made by a recipe in one look, of these sizes, that stands nowhere and offers nothing: where programs that
    /// put catalogues together themselves begin.
    #[must_use]
    pub fn plain(id: &str, sizes: Vec<Size>, recipe: &'static Recipe) -> Self {
        Self {
            id: id.to_owned(),
            label: id.to_owned(),
            groups: Vec::new(),
            usual_sizes: sizes.len(),
            niche_sizes: 0,
            sizes,
            looks: 1,
            variety: Variety::None,
            share: None,
            shape: Shape::Box,
            parents: Vec::new(),
            sides: [SideOffer::NONE; 6],
            clearances: Vec::new(),
            either: Vec::new(),
            relations: Vec::new(),
            covers: Vec::new(),
            stand_ins: Vec::new(),
            carries: Vec::new(),
            needs_company: false,
            grid: None,
            fitted: None,
            is_joint: false,
            walls: WallWishes::default(),
            priority: 0,
            eras: Vec::new(),
            wealth: None,
            light: None,
            model: ModelSource::Recipe { recipe, parameters: Vec::new() },
            depth: 0,
        }
    }

    /// All regions before its sides: those that it needs, then those of which one is enough.
    pub fn all_clearances(&self) -> impl Iterator<Item = &Clearance> {
        self.clearances.iter().chain(&self.either)
    }

    /// One of [`Class::all_clearances`].
    ///
    /// # Panics
    /// If the class has fewer.
    #[must_use]
    pub fn clearance(&self, number: usize) -> &Clearance {
        self.all_clearances().nth(number).expect("clearances are numbered by their class")
    }

    /// Whether one of [`Class::all_clearances`] may be missing if another is there.
    #[must_use]
    pub fn is_either(&self, number: usize) -> bool {
        number >= self.clearances.len()
    }

    /// Number of variants: sizes times looks.
    #[must_use]
    pub fn variant_count(&self) -> u32 {
        u32::try_from(self.sizes.len()).expect("a class lists a handful of sizes") * self.looks
    }

    /// Number of variants that a room asks for: the usual sizes times looks.
    #[must_use]
    pub fn usual_variant_count(&self) -> u32 {
        u32::try_from(self.usual_sizes).expect("a class lists a handful of sizes") * self.looks
    }

    /// Number of variants that a piece may have anywhere: all but those that only fill niches.
    #[must_use]
    pub fn common_variant_count(&self) -> u32 {
        u32::try_from(self.sizes.len() - self.niche_sizes).expect("a class lists a handful of sizes")
            * self.looks
    }

    /// The size of a variant; variant = index of the size × looks + look.
    #[must_use]
    pub fn size(&self, variant: u32) -> Size {
        self.sizes[(variant / self.looks) as usize]
    }

    /// The places of a side.
    #[must_use]
    pub fn offer(&self, side: Side) -> &SideOffer {
        &self.sides[side.index()]
    }
}

/// One way to stand somewhere.
#[derive(Clone, Debug)]
pub struct ParentRule {
    /// The parent to stand on or beside.
    pub parent: ParentName,
    /// The parent's sides that will do, best first.
    pub sides: Vec<Side>,
    /// A tag that a wall or room must carry, if any.
    pub tag: Option<String>,
    /// How to turn.
    pub orientation: Orientation,
    /// Where along the side.
    pub along: Along,
    /// Metres between the touching sides, lowest and highest; below zero slides under the parent.
    pub gap: (f64, f64),
    /// Metres of the underside above the parent's underside (above its top for `above`), lowest and
    /// highest; zero for what stands.
    pub elevation: (f64, f64),
    /// For windows and doors: metres of the top above the opening's head, in place of the elevation; the piece
    /// covers the opening.
    pub above_head: Option<f64>,
}

/// A parent as a class may name it.
#[derive(Clone, Debug, PartialEq)]
pub enum ParentName {
    /// The floor of the room.
    Floor,
    /// The ceiling.
    Ceiling,
    /// A wall, between its openings.
    Wall,
    /// The wall strip at a door.
    Door,
    /// The wall strip at a window.
    Window,
    /// A column or other fixed body.
    Column,
    /// Classes by id or group, as sorted indices.
    Classes(Vec<ClassIndex>),
}

/// How a child turns relative to its parent (section 3.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orientation {
    /// The rule.
    pub turn: Turn,
    /// Random offset, up to this many radians either way.
    pub jitter: f64,
}

/// The rule of an [`Orientation`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Turn {
    /// Front in the same direction as the parent's (a wall's front is its inner face).
    Parallel,
    /// Front against the side it touches: a chair at a table.
    Facing,
    /// Back against the side it touches.
    Away,
    /// Front towards the middle of the parent.
    TowardsCenter,
    /// At the front of a piece in a corner: a quarter turn on, with its back to the wall that the parent's right side
    /// touches, so that a run goes on around the corner.
    AroundCorner,
    /// One of the four directions of the parent.
    Quarter,
    /// Any angle.
    Any,
}

/// Where along a side, or on a surface, a child goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Along {
    /// Anywhere (the paper's random position).
    Random,
    /// In the middle.
    Center,
    /// Spread evenly over the side's places.
    Even,
    /// Flush with one end, or in a corner of the room.
    Ends,
    /// Flush with the back (for children above: at the back edge, random along it).
    Back,
    /// Near the front edge (for children above).
    Front,
    /// In the long axis of the room, at its end away from the doors: at the wall there, or on the floor as near as may be to it, looking
    /// down the axis.
    Axis,
}

/// The places that one side of a class offers to children.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideOffer {
    /// How many children; zero for none.
    pub places: u32,
    /// Metres free along the side (for above: along the width); defaults to the side's length.
    pub space: Option<f64>,
    /// For above: height of the surface over the underside where it is not the top of the box (a mattress).
    pub surface: Option<f64>,
    /// For above: the part of the top that carries, as left, front, right, back margins in metres.
    pub margin: [f64; 4],
}

impl SideOffer {
    /// Takes no children.
    pub const NONE: Self = Self { places: 0, space: None, surface: None, margin: [0.0; 4] };
}

/// A region before a side, as deep as people need to use it. Two clearances may share space; a body and a
/// clearance may not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Before which side: front, back, left or right.
    pub side: Side,
    /// Metres that must stay free.
    pub minimum: f64,
    /// Metres that should stay free.
    pub good: f64,
    /// Metres left and right of the side's ends that belong to it.
    pub margin: f64,
    /// Metres from the underside up to which it reaches.
    pub height: f64,
    /// Whether children on that side may stand in it (the chair before a desk).
    pub allows_children: bool,
}

#[cfg(test)]
impl Clearance {
    /// The place of somebody who sits before a desk.
    pub(crate) const SEAT: Self =
        Self { side: Side::Front, minimum: 0.75, good: 0.9, margin: 0.0, height: 2.0, allows_children: true };
}

/// A wish about another object, scored when candidates are compared.
#[derive(Clone, Debug)]
pub struct Relation {
    /// The kind of wish.
    pub kind: RelationKind,
    /// Of what: classes by sorted index, or a room part.
    pub target: ParentName,
    /// Metres, lowest and highest that are good.
    pub distance: (f64, f64),
    /// Radians off the axis that are good.
    pub angle: f64,
    /// Share in the score.
    pub weight: f64,
    /// Whether the object is left out where it is not met.
    pub is_needed: bool,
}

/// The kinds of [`Relation`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RelationKind {
    /// Its front points at the target.
    Faces,
    /// Its front points at the target, and no wall is between them.
    Sees,
    /// Stands across from the target, fronts towards each other.
    Opposite,
    /// Within the distance.
    Near,
    /// Within the distance too, whose lower end is what counts: at least so far away.
    AwayFrom,
    /// Not in front of the target (a window).
    NotBefore,
    /// Side by side with the target.
    Beside,
    /// Fronts or backs on one line.
    AlignedWith,
    /// The body is at least the lower distance away from where the leaves of the target (a door) swing.
    ClearOf,
}

/// The walls that a piece likes at its back or side, as points of the score that places are compared by. A wish of weight 1 that
/// is met counts as much as one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WallWishes {
    /// Points at walls that carry a tag, fewer than zero at walls to keep away from, by tag.
    pub tags: Vec<(String, f64)>,
    /// Points at walls where one of these classes stands already.
    pub with: Vec<(Vec<ClassIndex>, f64)>,
    /// Points for each metre that the wall is long, up to 4 m.
    pub metre: f64,
    /// Points where its left or right side is closed, by another wall or by what stands there.
    pub corner: f64,
    /// Points where half of one of them is closed.
    pub half_corner: f64,
}

/// A regular layout on a side (section 3.3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Metres between neighbours along x and y: along the width and the depth of the class where it turns by
    /// quarters, else of the parent's side.
    pub interval: Point,
    /// Most places in a row along x and y without an aisle; zero for no aisles.
    pub block: [u32; 2],
    /// Metres that an aisle adds to the interval.
    pub aisle: f64,
    /// Whether the grid is centred on the side instead of starting at a random first position.
    pub is_centered: bool,
    /// Whether there is an aisle in the middle, with as many columns on both sides.
    pub is_halved: bool,
    /// Whether two stand back to back at each place: shelves between aisles, seats in a hall.
    pub is_back_to_back: bool,
    /// Metres that stay free at the walls, as left, front, right, back: aisles, and the floor before a board.
    pub margin: [f64; 4],
}

/// The part of a unit in a row of fitted ones, such as a kitchen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FittedPart {
    /// Holds the water: near pipes, under a window.
    Sink,
    /// Needs water, beside the sink: a dishwasher.
    BesideSink,
    /// Cooks: worktop between it and the sink, never before a window.
    Hob,
    /// What is set down goes there: between the others, and where wall is left.
    Worktop,
    /// Stands in the corner where two rows meet.
    Corner,
    /// Tall, at the end of a row: a fridge.
    Tall,
    /// Hangs on the wall over the row, in one line.
    WallUnit,
    /// Closes what a row leaves to the wall at its end: a panel.
    Filler,
}

impl FittedPart {
    /// Its word in class files.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Sink => "sink",
            Self::BesideSink => "beside_sink",
            Self::Hob => "hob",
            Self::Worktop => "worktop",
            Self::Corner => "corner",
            Self::Tall => "tall",
            Self::WallUnit => "wall_unit",
            Self::Filler => "filler",
        }
    }
}

/// How a class looks.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelSource {
    /// A recipe, with named numbers.
    Recipe {
        /// One of [`crate::recipes::recipes`].
        recipe: &'static Recipe,
        /// Parameters, sorted by name.
        parameters: Vec<(String, f64)>,
    },
    /// A user's `.glb` or `.gltf`.
    File {
        /// Path as found: absolute or relative to the working folder.
        path: std::path::PathBuf,
        /// Radians by which the file's model is turned so that its front faces +Z.
        turn: f64,
    },
}
