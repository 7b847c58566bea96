//! The fixed parts of a room, before any agent rests: walls, columns, windows, and regions that stay free.

use crate::catalog::AuditRules;
use crate::geometry::{Bounds, Convex, DISC_CORNERS, Grid, Point, Polygon, Segment, Solid};
use crate::plan::{
    FRAME_DEPTH, FRAME_WIDTH, HANDLE_HEIGHTS, Leaf, Level, Opening, OpeningKind, OpeningSide, Room,
    RoomOpening, RoomRef, Stairs, Wall,
};

use super::constants::{WALL_POINTS, WALL_STEP};

/// Radians of the sectors of [`Swings::Exact`]: the polygon around the arc of a leaf of 1.5 m is then half a millimetre
/// outside it at most.
const EXACT_SWEEP: f64 = core::f64::consts::PI / 16.0;

/// How what door leaves sweep is kept free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Swings {
    /// One polygon a leaf, a few centimetres wider than the arc: fast.
    Simple,
    /// Narrow sectors: for places that were found free to the millimetre.
    Exact,
}

/// A stretch of the room's outline or of a hole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Border {
    /// Index of its wall.
    pub(crate) wall: usize,
    /// Where it runs.
    pub(crate) segment: Segment,
    /// Whether nothing stands there: bodies stay inside all the same, people walk across.
    pub(crate) is_open: bool,
    /// Whether it is open to stairs: people step there, and nobody who uses a piece of this room does.
    pub(crate) is_at_stairs: bool,
}

/// A stretch of a wall that nothing closes.
#[derive(Clone, Copy, Debug)]
struct OpenStretch {
    /// Metres from the wall's start.
    from: f64,
    /// See `from`.
    to: f64,
    /// Whether there are stairs on the other side.
    is_at_stairs: bool,
}

/// A region that no body may enter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeptFree {
    /// The region.
    pub(crate) solid: Solid,
    /// The reason.
    pub(crate) cause: Cause,
}

/// The reason why a region stays free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cause {
    /// An opening, by index into the level's openings.
    Opening(usize),
    /// A way that furniture has closed before, or room for a wheelchair to turn.
    Way,
}

/// The fixed part of an agent's environment.
#[derive(Clone, Debug)]
pub(crate) struct Surroundings<'a> {
    /// The level, for its openings.
    pub(crate) level: &'a Level,
    /// The room.
    pub(crate) room: &'a Room,
    /// Angle of the longest wall: what "straight" means in this room.
    pub(crate) main_angle: f64,
    /// The outline and the holes, cut where a wall is open.
    pub(crate) borders: Vec<Border>,
    /// The borders by number.
    pub(crate) border_grid: Grid,
    /// Door swings and approaches: no body may enter.
    pub(crate) kept_free: Vec<KeptFree>,
    /// They by number.
    pub(crate) kept_free_grid: Grid,
    /// Where leaves swing in the room: no body enters (they are in `kept_free`), and some keep farther away.
    pub(crate) swings: Vec<Convex>,
    /// Convex pieces of the columns, and of stairs, over and under which nothing stands.
    pub(crate) columns: Vec<Solid>,
    /// Metres between the points of a scan along walls.
    pub(crate) wall_step: f64,
    /// Strips before windows, from a little over the sill to the head: tall pieces avoid them.
    pub(crate) window_strips: Vec<Solid>,
}

impl<'a> Surroundings<'a> {
    /// Works out the surroundings of a room; what has to stay free is what the audit asks for.
    pub(crate) fn new(at: RoomRef<'a>, rules: &AuditRules, swings: Swings) -> Self {
        let RoomRef { level, room, index } = at;
        let columns = room.obstacles.iter().map(|column| (&column.outline, column.height));
        let stairs = level.stairs_of(index).and_then(Stairs::footprint);
        let bodies = columns.chain(stairs.map(|footprint| (footprint, room.height)));
        let bounds = room.region.outline.bounds();
        let mut surroundings = Self {
            level,
            room,
            main_angle: main_angle(room),
            borders: Vec::new(),
            border_grid: Grid::new(bounds),
            kept_free: Vec::new(),
            kept_free_grid: Grid::new(bounds),
            swings: Vec::new(),
            columns: bodies.flat_map(|(outline, height)| convex_parts(outline, height)).collect(),
            // The same number of points in the longest halls: a scan takes no longer, it only gets coarser.
            wall_step: WALL_STEP.max(room.walls.iter().map(Wall::length).sum::<f64>() / WALL_POINTS),
            window_strips: Vec::new(),
        };
        for side in &room.openings {
            let opening = &level.openings[side.opening];
            let regions = surroundings.regions_of(opening, side, rules, swings);
            let cause = Cause::Opening(side.opening);
            surroundings.kept_free.extend(regions.into_iter().map(|solid| KeptFree { solid, cause }));
            let leaves = opening.leaves_into(&room.walls[side.wall]);
            surroundings.swings.extend(leaves.flat_map(|leaf| swept(leaf, Swings::Simple)));
            if opening.kind == OpeningKind::Window {
                let from = opening.bottom + rules.windows.over_sill;
                // No region that must stay free: a strip before a window costs points (`WINDOW_PENALTY`), no place.
                let strip = wall_strip(room, side, rules.windows.depth, 0.0);
                surroundings.window_strips.push(Solid::new(strip, from, opening.top.max(from)));
            }
        }
        surroundings.borders = surroundings.cut_borders();
        let Self { borders, border_grid, kept_free, kept_free_grid, .. } = &mut surroundings;
        fill(border_grid, borders.iter().map(|border| border.segment.bounds()));
        fill(kept_free_grid, kept_free.iter().map(|region| region.solid.bounds));
        surroundings
    }

    /// The outline and the holes, cut where a wall is open.
    fn cut_borders(&self) -> Vec<Border> {
        let edges = self.room.region.borders().enumerate();
        edges.flat_map(|(wall, edge)| cut(wall, edge, self.open_stretches(wall))).collect()
    }

    /// Where a wall has nothing that closes it, from its start on.
    fn open_stretches(&self, wall: usize) -> Vec<OpenStretch> {
        let is_open = |side: &&RoomOpening| {
            let kind = self.level.openings[side.opening].kind;
            side.wall == wall && matches!(kind, OpeningKind::OpenBoundary | OpeningKind::Passage)
        };
        let has_stairs = |other: &OpeningSide| {
            !core::ptr::eq(&self.level.rooms[other.room], self.room)
                && self.level.stairs_of(other.room).is_some()
        };
        let is_at_stairs =
            |side: &RoomOpening| self.level.openings[side.opening].sides.iter().any(has_stairs);
        let stretch = |side: &RoomOpening| {
            let &RoomOpening { from, to, .. } = side;
            OpenStretch { from, to, is_at_stairs: is_at_stairs(side) }
        };
        let mut stretches: Vec<_> = self.room.openings.iter().filter(is_open).map(stretch).collect();
        // From the start of the wall on, for `cut` goes along it once.
        stretches.sort_by(|a, b| a.from.total_cmp(&b.from));
        stretches
    }

    /// The regions before an opening that stay free: swings and approaches.
    fn regions_of(
        &self,
        opening: &Opening,
        side: &RoomOpening,
        rules: &AuditRules,
        swings: Swings,
    ) -> Vec<Solid> {
        let strip = |depth, margin| {
            let strip = wall_strip(self.room, side, depth, margin);
            Solid::new(strip, 0.0, opening.top.max(0.0))
        };
        match opening.kind {
            OpeningKind::Window => Vec::new(),
            // Nobody turns a handle there: less depth (metres) than before a door is enough to walk by.
            OpeningKind::OpenBoundary => {
                let ends = rules.doors.free_ends(side.to - side.from);
                vec![strip(rules.doors.open_boundary_depth, -ends)]
            }
            OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage => {
                // As the audit measures it: no deeper than the door is wide. Deeper would empty small bathrooms.
                let depth = rules.doors.approach_depth.min(side.to - side.from);
                let mut regions = vec![strip(depth, 0.0), strip(FRAME_DEPTH, FRAME_WIDTH)];
                for leaf in opening.leaves_into(&self.room.walls[side.wall]) {
                    let sectors = swept(leaf, swings).into_iter();
                    regions.extend(sectors.map(|base| Solid::new(base, 0.0, opening.top)));
                    regions.extend(standing_open(leaf, opening.top));
                }
                regions
            }
        }
    }
}

/// Adds boxes to a grid by number.
fn fill(grid: &mut Grid, boxes: impl Iterator<Item = Bounds>) {
    for (number, bounds) in (0..).zip(boxes) {
        grid.insert(number, bounds);
    }
}

/// An edge as borders, closed between its open stretches.
fn cut(wall: usize, edge: Segment, open: Vec<OpenStretch>) -> Vec<Border> {
    let (length, along) = (edge.length(), edge.direction());
    // Exact at the corners, so that neighbours meet.
    let at = |metres: f64| if metres < length { edge.start + along * metres } else { edge.end };
    let border = |from: f64, to: f64, open: Option<OpenStretch>| Border {
        wall,
        segment: Segment::new(at(from), at(to)),
        is_open: open.is_some(),
        is_at_stairs: open.is_some_and(|stretch| stretch.is_at_stairs),
    };
    let mut pieces = Vec::with_capacity(2 * open.len() + 1);
    let mut done = 0.0_f64;
    for stretch in open {
        pieces.push((done, stretch.from.min(length), None));
        pieces.push((stretch.from.max(done), stretch.to.min(length), Some(stretch)));
        done = done.max(stretch.to);
    }
    pieces.push((done, length, None));
    let has_length = pieces.into_iter().filter(|(from, to, _)| to > from);
    has_length.map(|(from, to, open)| border(from, to, open)).collect()
}

/// The floor before an opening on the room's side: `depth` metres deep, `margin` wider at both ends.
fn wall_strip(room: &Room, side: &RoomOpening, depth: f64, margin: f64) -> Convex {
    let wall = &room.walls[side.wall];
    let (along, normal) = (wall.direction(), wall.normal());
    let center = wall.start + along * f64::midpoint(side.from, side.to) + normal * (depth / 2.0);
    let half = Point::new((side.to - side.from) / 2.0 + margin, depth / 2.0);
    Convex::rectangle(center, half, along)
}

/// The space of an open leaf beside the sector that it sweeps: its thickness, and its handle.
fn standing_open(leaf: &Leaf, top: f64) -> Vec<Solid> {
    let Some([board, handle]) = leaf.standing_open() else { return Vec::new() };
    let (low, high) = HANDLE_HEIGHTS;
    vec![
        Solid::new(Convex::from_corners(&board), 0.0, top),
        Solid::new(Convex::from_corners(&handle), low.min(top), high.min(top)),
    ]
}

/// The sector that a leaf sweeps; nothing for a leaf that does not turn.
fn swept(leaf: &Leaf, swings: Swings) -> Vec<Convex> {
    let (closed, open) = (leaf.closed_tip - leaf.hinge, leaf.open_tip - leaf.hinge);
    let radius = closed.length().max(open.length());
    let sweep = libm::atan2(closed.perp_dot(open), closed.dot(open));
    // A twentieth of a degree: drawn shut, or not at all.
    if radius <= 0.0 || sweep.abs() < 1e-3 {
        return Vec::new();
    }
    let count = match swings {
        Swings::Simple => 1.0,
        Swings::Exact => (sweep.abs() / EXACT_SWEEP).ceil(),
    };
    let (first, part) = (libm::atan2(closed.y, closed.x), sweep / count);
    let sector = |number: u32| sector(leaf.hinge, radius, first + f64::from(number) * part, part);
    (0..count as u32).map(sector).collect()
}

/// The polygon around a sector from an angle on.
///
/// ```text
///  open tip
///    |\ _
///    |    \        corners outside the arc are
///    |     |       where its tangents meet
///  hinge --+ closed tip
/// ```
fn sector(hinge: Point, radius: f64, first: f64, sweep: f64) -> Convex {
    const STEPS: usize = 4;
    let step = sweep / STEPS as f64;
    // The corners of a polygon around an arc lie outside of it by this factor: no part of the leaf sticks out.
    let reach = radius / libm::cos(step / 2.0);
    let mut corners = vec![hinge, hinge + crate::geometry::direction(first) * radius];
    for index in 0..STEPS {
        let angle = first + (index as f64 + 0.5) * step;
        corners.push(hinge + crate::geometry::direction(angle) * reach);
    }
    corners.push(hinge + crate::geometry::direction(first + sweep) * radius);
    if sweep < 0.0 {
        corners.reverse();
    }
    Convex::from_corners(&corners)
}

/// The polygon itself where it is convex, else its triangles.
fn convex_parts(outline: &Polygon, height: f64) -> Vec<Solid> {
    let corners = outline.corners();
    let count = corners.len();
    let is_convex = (0..count).all(|i| {
        let (a, b, c) = (corners[i], corners[(i + 1) % count], corners[(i + 2) % count]);
        (b - a).perp_dot(c - b) >= 0.0
    });
    if is_convex && count <= DISC_CORNERS {
        return vec![Solid::new(Convex::from_corners(corners), 0.0, height)];
    }
    let mut indices: Vec<usize> = Vec::new();
    earcut::Earcut::new().earcut(corners.iter().map(|c| [c.x, c.y]), &[], &mut indices);
    let triangles = indices.chunks_exact(3).map(|corner| {
        let mut triangle = [corners[corner[0]], corners[corner[1]], corners[corner[2]]];
        if (triangle[1] - triangle[0]).perp_dot(triangle[2] - triangle[0]) < 0.0 {
            triangle.swap(1, 2);
        }
        Solid::new(Convex::from_corners(&triangle), 0.0, height)
    });
    triangles.collect()
}

/// Angle of the longest wall.
pub(crate) fn main_angle(room: &Room) -> f64 {
    let longest = room.walls.iter().max_by(|a, b| a.length().total_cmp(&b.length()));
    longest.map_or(0.0, |wall| {
        let along = wall.direction();
        libm::atan2(along.y, along.x)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swing_covers_its_quarter_circle() {
        let leaf = Leaf { hinge: Point::ZERO, closed_tip: Point::X, open_tip: Point::Y };
        let sector = swept(&leaf, Swings::Simple)[0];
        let probe = |x: f64, y: f64| Convex::rectangle(Point::new(x, y), Point::splat(0.005), Point::X);
        assert!(sector.overlaps(&probe(0.7, 0.7), 1e-4));
        assert!(!sector.overlaps(&probe(0.8, 0.8), 1e-4));
        assert!(!sector.overlaps(&probe(-0.1, 0.5), 1e-4));
        let mirrored = Leaf { hinge: Point::ZERO, closed_tip: Point::Y, open_tip: Point::X };
        assert!(swept(&mirrored, Swings::Simple)[0].overlaps(&probe(0.7, 0.7), 1e-4));
    }

    #[test]
    fn an_exact_swing_ends_where_the_leaf_does() {
        let leaf = Leaf { hinge: Point::ZERO, closed_tip: Point::X * 1.5, open_tip: Point::Y * 1.5 };
        // A corner at some distance from the hinge, where the polygon around the whole arc is widest.
        let is_met = |distance: f64, swings: Swings| {
            let towards = crate::geometry::direction(core::f64::consts::FRAC_PI_2 * 0.375);
            let middle = towards * (distance + 0.01);
            let probe = Convex::rectangle(middle, Point::splat(0.01), towards);
            swept(&leaf, swings).iter().any(|sector| sector.overlaps(&probe, 1e-6))
        };
        assert!(is_met(1.499, Swings::Simple) && is_met(1.499, Swings::Exact));
        assert!(is_met(1.501, Swings::Simple) && !is_met(1.501, Swings::Exact));
        assert!(!is_met(1.54, Swings::Simple));
        let mirrored = Leaf { closed_tip: leaf.open_tip, open_tip: leaf.closed_tip, ..leaf };
        assert_eq!(swept(&mirrored, Swings::Exact).len(), swept(&leaf, Swings::Exact).len());
        let still = Leaf { open_tip: leaf.closed_tip, ..leaf };
        assert!(swept(&still, Swings::Exact).is_empty());
    }

    #[test]
    fn a_leaf_that_stands_open_has_a_thickness_and_a_handle() {
        for sign in [1.0, -1.0] {
            let leaf = Leaf { hinge: Point::ZERO, closed_tip: Point::X * sign, open_tip: Point::Y };
            let regions = standing_open(&leaf, 2.0);
            let meets = |x: f64, y: f64, z: f64| {
                let base = Convex::rectangle(Point::new(-x * sign, y), Point::splat(0.001), Point::X);
                let probe = Solid::new(base, z, z + 0.01);
                regions.iter().any(|region| region.overlaps(&probe, 1e-6))
            };
            assert!(meets(0.04, 0.1, 0.1) && meets(0.04, 0.99, 1.9), "the board");
            assert!(!meets(0.05, 0.1, 0.1) && !meets(-0.01, 0.5, 0.1) && !meets(0.04, 0.1, 2.1), "beside it");
            assert!(meets(0.1, 0.9, 1.05), "the handle");
            assert!(
                !meets(0.1, 0.9, 0.9) && !meets(0.1, 0.5, 1.05) && !meets(0.11, 0.9, 1.05),
                "beside that"
            );
        }
    }

    #[test]
    fn a_column_in_the_shape_of_an_l_keeps_its_notch() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
        let outline = Polygon::new(&corners.map(|(x, y)| Point::new(x, y))).unwrap();
        let parts = convex_parts(&outline, 2.5);
        let probe = Solid::new(Convex::rectangle(Point::splat(1.5), Point::splat(0.3), Point::X), 0.0, 1.0);
        assert!(parts.len() >= 2);
        assert!(!parts.iter().any(|part| part.overlaps(&probe, 1e-4)));
    }
}
