//! Where a piece may stand on the floor of a room.

use crate::audit::{ROUNDING, clip_segment, door_zones, middle, penetration};
use crate::geometry::{Bounds, Grid, Line, Point, Solid};
use crate::plan::{FRAME_DEPTH, FRAME_WIDTH, Leaf, RoomOpening};

use super::borders::Borders;
use super::empty_room::EmptyRoom;
use super::footprint::{Footprint, Part};

/// Metres that boxes must be apart for their contents to be: more than rounding makes of contact.
const APART: f64 = 1e-9;
/// Metres by which a border or a body enters a part for certain.
const SLACK: f64 = 2.0 * ROUNDING;
/// Edges of polygons that a point is compared with in the time of one other step.
const EDGES_A_STEP: u64 = 4;

/// Where a piece may stand.
pub(crate) struct Space<'s, 'a> {
    pub(super) empty: &'s EmptyRoom<'a>,
    borders: Borders,
    /// Corners of what no piece may stand in: the ways through the doors, and their frames, each with the box around it.
    door_zones: Vec<(Vec<Point>, Bounds)>,
    /// The boxes around the columns.
    columns: Vec<Bounds>,
    /// Bodies whose footprints the piece and its clearances keep clear of.
    bodies: Vec<&'s Solid>,
    /// Where they are.
    body_grid: Option<Grid>,
    /// The piece stays to the left of this line.
    line: Option<Line>,
}

/// The floor under the frames of doors and passages.
fn frames(empty: &EmptyRoom<'_>) -> impl Iterator<Item = Vec<Point>> {
    let kind = |place: &RoomOpening| empty.at.level.openings[place.opening].kind;
    empty.at.room.openings.iter().filter(move |place| kind(place).has_frame()).map(|place| {
        let wall = &empty.at.room.walls[place.wall];
        let at = |along: f64| wall.after(along);
        let (start, end) = (at(place.from - FRAME_WIDTH), at(place.to + FRAME_WIDTH));
        let outward = wall.normal() * FRAME_DEPTH;
        vec![start, end, end + outward, start + outward]
    })
}

fn with_bounds(zone: Vec<Point>) -> (Vec<Point>, Bounds) {
    let bounds = Bounds::around(zone.iter().copied());
    (zone, bounds)
}

/// The floor under leaves that stand open in the room, beside the ways through their doors.
fn open_leaves(empty: &EmptyRoom<'_>) -> impl Iterator<Item = Vec<Point>> {
    empty.at.room.openings.iter().flat_map(move |place| {
        let leaves = empty.at.level.openings[place.opening].leaves_into(&empty.at.room.walls[place.wall]);
        leaves.filter_map(Leaf::standing_open).flatten().map(|base| base.to_vec())
    })
}

impl<'s, 'a> Space<'s, 'a> {
    /// The room without furniture.
    pub(crate) fn empty(empty: &'s EmptyRoom<'a>) -> Self {
        let passages = door_zones(empty.at, empty.rules().doors).into_iter().map(|zone| zone.base);
        let zones = passages.chain(frames(empty)).chain(open_leaves(empty));
        Self {
            empty,
            borders: Borders::new(empty),
            door_zones: zones.map(with_bounds).collect(),
            columns: empty.at.room.obstacles.iter().map(|column| column.outline.bounds()).collect(),
            bodies: Vec::new(),
            body_grid: None,
            line: None,
        }
    }

    /// The same on one side of a line, among some bodies.
    pub(super) fn beside(self, bodies: Vec<&'s Solid>, line: Line) -> Self {
        let mut grid = Grid::new(self.empty.at.room.region.outline.bounds());
        for (number, body) in (0..).zip(&bodies) {
            grid.insert(number, body.bounds);
        }
        Self { bodies, body_grid: Some(grid), line: Some(line), ..self }
    }

    fn spend(&self, steps: u64) {
        self.empty.budget.spend(steps);
    }

    /// About what one place of a piece of so many parts takes: for each, whether its middle is inside, and how near the
    /// next border is.
    pub(super) fn steps_a_spot(&self, parts: usize) -> u64 {
        let inside = 1 + self.borders.len() as u64 / EDGES_A_STEP;
        parts as u64 * (2 * inside + EDGES_A_STEP)
    }

    /// Metres around a place nearer than which a piece of these parts, the first its body, can stand nowhere; zero where that is known of
    /// the place alone, none where the piece may stand there.
    pub(super) fn blocked_around(&self, parts: &[Part], position: Point) -> Option<f64> {
        let body = &parts[0];
        let each_part = |question: &dyn Fn(&Footprint) -> Option<f64>| {
            parts.iter().find_map(|part| question(&part.footprint.moved(position)))
        };
        // What is asked most quickly, and of what most is seen, first.
        self.behind_line(&body.footprint.moved(position))
            .or_else(|| parts.iter().find_map(|part| self.outside(part, position)))
            .or_else(|| each_part(&|footprint| self.in_bodies(footprint)))
            // The body keeps out of the doors' ways; its clearances may share them.
            .or_else(|| self.in_door_zones(&body.footprint.moved(position)))
            .or_else(|| each_part(&|footprint| self.is_cut(footprint).then_some(0.0)))
    }

    /// Metres that the body of a piece must move at least to be to the left of the line.
    fn behind_line(&self, body: &Footprint) -> Option<f64> {
        let line = self.line?;
        let depths = body.corners.iter().map(|&corner| line.right_of(corner));
        let deepest = depths.fold(f64::NEG_INFINITY, f64::max);
        (deepest > 0.0).then_some(deepest - SLACK)
    }

    /// Metres that a part must move at least to be inside, where it is seen without looking at the whole of it that it is not: a border
    /// is nearer to its middle than any of its edges, or the middle is outside.
    fn outside(&self, part: &Part, position: Point) -> Option<f64> {
        let middle = position + part.middle;
        let (distance, looked_at) = self.borders.distance(middle);
        self.spend(looked_at);
        if distance < part.radius - SLACK {
            // At all places nearer than that the border is inside the part as well.
            Some(part.radius - SLACK - distance)
        } else if self.contains(middle) {
            None
        } else {
            // Outside, and no border nearer: so is all around it up to there.
            Some(distance - SLACK)
        }
    }

    fn contains(&self, point: Point) -> bool {
        self.spend(1 + self.borders.len() as u64 / EDGES_A_STEP);
        self.empty.at.room.region.contains(point)
    }

    /// Whether a border runs through a footprint, or it is in a column.
    fn is_cut(&self, footprint: &Footprint) -> bool {
        self.is_in_column(middle(&footprint.corners)) || self.is_crossed(footprint)
    }

    fn is_in_column(&self, point: Point) -> bool {
        self.spend(self.columns.len() as u64 / EDGES_A_STEP);
        let mut columns = self.columns.iter().zip(&self.empty.at.room.obstacles);
        columns.any(|(bounds, column)| bounds.contains(point) && column.outline.contains(point))
    }

    /// Whether a border runs through a footprint. Nearly all borders are far away, as their boxes show.
    fn is_crossed(&self, footprint: &Footprint) -> bool {
        // Half of what the audit rounds off, so that a place that is free here is without a finding there.
        let crosses = |border| clip_segment(&footprint.corners, border, ROUNDING / 2.0).is_some();
        let (is_crossed, looked_at) = self.borders.any_near(footprint.bounds, ROUNDING, crosses);
        self.spend(looked_at);
        is_crossed
    }

    /// Metres that a footprint must move at least to be out of a body that it is in.
    fn in_bodies(&self, footprint: &Footprint) -> Option<f64> {
        let grid = self.body_grid.as_ref()?;
        let (mut looked_at, mut depth) = (0, 0.0);
        let is_met = grid.any(footprint.bounds, |number| {
            let body = self.bodies[number as usize];
            looked_at += 1;
            if body.bounds.overlaps(footprint.bounds, 0.0) {
                depth = penetration(body.footprint(), &footprint.corners);
            }
            depth > 0.0
        });
        self.spend(looked_at);
        is_met.then_some(depth - SLACK)
    }

    /// Metres that a footprint must move at least to be out of a door's way that it is in.
    fn in_door_zones(&self, footprint: &Footprint) -> Option<f64> {
        self.spend(self.door_zones.len() as u64);
        let near = self.door_zones.iter().filter(|(_, bounds)| bounds.overlaps(footprint.bounds, -APART));
        let mut depths = near.map(|(zone, _)| penetration(zone, &footprint.corners));
        depths.find(|&depth| depth > 0.0).map(|depth| depth - SLACK)
    }
}
