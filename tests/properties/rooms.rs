//! Random rooms: convex, concave, slanted, with columns, holes and openings, 1 to 500 m².

use proptest::prelude::*;
use proptest::sample::Index;

use roomwright::internals::catalog::{Catalog, RoomType};
use roomwright::internals::geometry::{Bounds, Point, Polygon, Segment, direction};
use roomwright::internals::plan::{
    LeafDraft, Level, LevelDraft, ObstacleDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft,
    assemble_level,
};

/// Square metres of the smallest and largest room.
const AREAS: (f64, f64) = (1.0, 500.0);

/// A room as proptest draws and shrinks it; shares are of the room's own size.
#[derive(Clone, Debug)]
pub struct Sketch {
    outline: Outline,
    area: f64,
    turn: f64,
    height: f64,
    columns: Vec<Block>,
    hole: Option<Block>,
    openings: Vec<OpeningSketch>,
    room_type: Index,
    style: Option<Index>,
    /// The seed of the run.
    pub seed: u64,
}

/// The shape before it is scaled and turned.
#[derive(Clone, Debug)]
enum Outline {
    /// Two sides.
    Rectangle(f64),
    /// A side ratio, how far the top is shifted, how much shorter it is.
    Slanted(f64, f64, f64),
    /// A rectangle with a rectangular notch: ratio; from where, how wide and how deep, as shares.
    Notched(f64, f64, f64, f64),
    /// Corners around a middle: the gap to the next one and the distance, both relative. Equal distances
    /// make it convex, others concave.
    Star(Vec<(f64, f64)>),
}

/// A column or hole: its middle as shares of the bounding box, its side in metres.
type Block = (f64, f64, f64);

#[derive(Clone, Debug)]
struct OpeningSketch {
    kind: OpeningKind,
    edge: Index,
    /// Share of the edge where the middle is.
    at: f64,
    width: f64,
    opens_inward: bool,
}

/// All kinds of rooms.
pub fn sketches() -> impl Strategy<Value = Sketch> {
    let size = (libm::log(AREAS.0)..libm::log(AREAS.1)).prop_map(libm::exp);
    let turn = prop_oneof![2 => Just(0.0), 1 => 0.0..core::f64::consts::TAU];
    let block = (0.1..0.9, 0.1..0.9, 0.1..0.6);
    let fixtures = (
        prop::collection::vec(block.clone(), 0..4),
        prop::option::weighted(0.2, block),
        prop::collection::vec(opening(), 0..6),
    );
    let words = (any::<Index>(), prop::option::of(any::<Index>()), any::<u64>());
    (outline(), size, turn, 2.2..4.5, fixtures, words).prop_map(
        |(outline, area, turn, height, (columns, hole, openings), (room_type, style, seed))| Sketch {
            outline,
            area,
            turn,
            height,
            columns,
            hole,
            openings,
            room_type,
            style,
            seed,
        },
    )
}

fn outline() -> impl Strategy<Value = Outline> {
    let convex = prop::collection::vec((0.3..1.0, Just(1.0)), 3..9);
    let star = prop::collection::vec((0.5..1.0, 0.35..1.0), 4..11);
    prop_oneof![
        2 => (0.4..2.5).prop_map(Outline::Rectangle),
        2 => (0.5..2.0, -0.4..0.4, 0.0..0.5).prop_map(|(ratio, shift, less)| Outline::Slanted(ratio, shift, less)),
        3 => (0.5..2.0, 0.0..0.7, 0.2..0.6, 0.2..0.8)
            .prop_map(|(ratio, from, width, depth)| Outline::Notched(ratio, from, width, depth)),
        1 => convex.prop_map(Outline::Star),
        2 => star.prop_map(Outline::Star),
    ]
}

fn opening() -> impl Strategy<Value = OpeningSketch> {
    let kind = prop_oneof![
        3 => Just(OpeningKind::Door),
        1 => Just(OpeningKind::SlidingDoor),
        1 => Just(OpeningKind::Passage),
        1 => Just(OpeningKind::OpenBoundary),
        3 => Just(OpeningKind::Window),
    ];
    (kind, any::<Index>(), 0.0..1.0, 0.6..2.4, any::<bool>()).prop_map(
        |(kind, edge, at, width, opens_inward)| OpeningSketch { kind, edge, at, width, opens_inward },
    )
}

impl Outline {
    /// Corners of any size around the origin.
    fn corners(&self) -> Vec<Point> {
        match self {
            Self::Rectangle(ratio) => rectangle(*ratio).to_vec(),
            Self::Slanted(ratio, shift, less) => {
                let [a, b, c, d] = rectangle(*ratio);
                let (shift, less) = (Point::X * shift * *ratio, Point::X * (less * ratio / 2.0));
                vec![a, b, c + shift - less, d + shift + less]
            }
            Self::Notched(ratio, from, width, depth) => {
                let [a, b, c, d] = rectangle(*ratio);
                let (left, right) = (c.lerp(d, (from + width).min(1.0)), c.lerp(d, *from));
                let down = Point::NEG_Y * *depth;
                vec![a, b, c, right, right + down, left + down, left, d]
            }
            Self::Star(spokes) => {
                let total: f64 = spokes.iter().map(|(gap, _)| gap).sum();
                let mut angle = 0.0;
                let corner = |&(gap, distance): &(f64, f64)| {
                    angle += gap / total * core::f64::consts::TAU;
                    direction(angle) * distance
                };
                spokes.iter().map(corner).collect()
            }
        }
    }
}

/// A rectangle one metre deep.
fn rectangle(width: f64) -> [Point; 4] {
    [(0.0, 0.0), (width, 0.0), (width, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y))
}

impl Sketch {
    /// The level with this one room; `None` where the corners make no polygon.
    pub fn level(&self, catalog: &Catalog) -> Option<Level> {
        let corners = self.outline.corners();
        let scale = (self.area / Polygon::new(&corners).ok()?.area()).sqrt();
        let turn = direction(self.turn);
        let corners: Vec<Point> = corners.iter().map(|&corner| turn.rotate(corner * scale)).collect();
        let outline = Polygon::new(&corners).ok()?;
        let usual = |one: &&RoomType| (one.area.0..=one.area.1).contains(&self.area);
        let types: Vec<&RoomType> = catalog.room_types.values().filter(usual).collect();
        let styles: Vec<&str> = catalog.styles.ids().collect();
        let columns =
            self.columns.iter().map(|block| ObstacleDraft { outline: square(&outline, block), height: None });
        let draft = LevelDraft {
            id: "level".into(),
            height: self.height + 0.3,
            exterior_thickness: 0.3,
            interior_thickness: 0.1,
            rooms: vec![RoomDraft {
                id: "room".into(),
                number: Some(1),
                room_type: self.room_type.get(&types).id.clone(),
                style: self.style.map(|style| (*style.get(&styles)).to_owned()),
                outline: outline.corners().to_vec(),
                holes: self.hole.iter().map(|block| square(&outline, block)).collect(),
                height: Some(self.height),
                ..RoomDraft::default()
            }],
            openings: self.openings.iter().enumerate().map(|(n, sketch)| sketch.draft(n, &outline)).collect(),
            obstacles: columns.collect(),
            ..LevelDraft::default()
        };
        // What does not fit (a hole over the border, a door wider than its wall) is left out with a problem.
        let (level, _) = assemble_level(draft);
        (level.rooms.len() == 1).then_some(level)
    }
}

fn square(outline: &Polygon, &(x, y, side): &Block) -> Vec<Point> {
    let Bounds { low, high } = outline.bounds();
    let origin = low + (high - low) * Point::new(x, y);
    Polygon::rectangle(origin, Point::splat(side)).corners().to_vec()
}

impl OpeningSketch {
    fn draft(&self, number: usize, outline: &Polygon) -> OpeningDraft {
        let edges: Vec<Segment> = outline.edges().collect();
        let edge = self.edge.index(edges.len());
        let length = edges[edge].length();
        let (bottom, top) = match self.kind {
            OpeningKind::Window => (0.9, 2.1),
            OpeningKind::OpenBoundary => (0.0, 2.2),
            _ => (0.0, 2.0),
        };
        let into = self.opens_inward.then(|| "room".to_owned());
        let leaf = match self.kind {
            OpeningKind::Door => LeafDraft::Swing {
                hinge_left: self.at > 0.5,
                into,
                count: 1,
                angle: core::f64::consts::FRAC_PI_2,
            },
            _ => LeafDraft::None,
        };
        OpeningDraft {
            id: format!("opening{number}"),
            kind: self.kind,
            place: OpeningPlace::Edge { edge, at: self.at * length },
            rooms: vec!["room".into()],
            width: self.width,
            bottom,
            top,
            leaf,
        }
    }
}
