//! Finds where people get to on the floor of a room.

use core::cmp::Reverse;
use core::ops::Range;
use std::cell::RefCell;
use std::rc::Rc;

use crate::catalog::{AccessRules, AuditRules, WalkingRules};
use crate::geometry::{Bounds, DisjointSets, Point, Segment, Solid, distance_to_convex, edges};
use crate::plan::{Room, RoomOpening, RoomRef};

use super::gaps::{Cells, Obstacle, fixed_obstacles};
use super::known::{Known, shape};
use super::raster::{CELL, Raster, cell_around};

/// The floor of a room with what stands on it.
#[derive(Clone, Debug)]
pub(crate) struct Floor {
    pub(super) raster: Raster,
    /// As [`Raster::distances`] gives them, to the widest disc that is asked for.
    pub(super) distances: Vec<u16>,
    /// One per walkable opening.
    doors: Rc<[Doorway]>,
    /// Cells up to which distances are exact.
    reach: u16,
    /// What stands on it.
    obstacles: Vec<Obstacle>,
    /// Its walls and columns.
    fixed: Rc<[Obstacle]>,
    /// The diameters of the discs for which gaps are known exactly.
    widths: [f64; 2],
}

thread_local! {
    /// Floors of empty rooms that this thread has made.
    static KNOWN: RefCell<Known<Floor>> = RefCell::default();
}

/// How far a door reaches, in metres from the wall's inner face.
#[derive(Clone, Copy)]
struct DoorDepth {
    /// The floor behind it that is part of the room.
    behind: f64,
    /// Who has the middle so far before it, or less, is at the door.
    before: f64,
}

impl DoorDepth {
    /// The same on a floor of cells: half a cell may be missing on either side.
    fn with_cells(self, cell: f64) -> Self {
        // One cell for each end of the strip, which may begin or end between middles.
        let behind = if self.behind > 0.0 { self.behind + 2.0 * cell } else { 0.0 };
        Self { behind, before: self.before + cell }
    }
}

/// A goal that people walk to.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Goal<'g> {
    /// A door, by index into the level's openings.
    Door(usize),
    /// Any place on a convex area, corners counter-clockwise.
    Area(&'g [Point]),
}

/// An opening that people walk through.
#[derive(Debug)]
struct Doorway {
    /// Index into the level's openings.
    opening: usize,
    /// The cells on its threshold, row by row.
    threshold: Vec<Range<usize>>,
}

/// Cells side by side in a row where a disc may be.
struct Run {
    cells: Range<usize>,
    group: Group,
}

/// A number for all runs and doors that are reached from each other.
pub(crate) type Group = usize;

/// Where a disc gets to.
pub(crate) struct Walk<'f> {
    pub(super) floor: &'f Floor,
    pub(super) diameter: f64,
    /// Row by row.
    runs: Vec<Run>,
    /// Index of each row's first run, and the number of runs.
    rows: Vec<usize>,
    /// The group of each door.
    doors: Vec<Group>,
}

impl Floor {
    /// The floor of an empty room; `None` where no door leads in.
    pub(crate) fn empty(at: RoomRef<'_>, rules: &WalkingRules) -> Option<Rc<Self>> {
        // Distances beyond this are not told apart: that keeps them as cheap in halls as in closets.
        let widest = rules.person.max(rules.narrow_person).max(rules.robot);
        // Somebody on a threshold stands half behind it.
        let doors = DoorDepth { behind: rules.person / 2.0, before: 0.0 };
        Self::for_disc(at, rules, widest, doors)
    }

    /// The same for a wheelchair. Its way is wider than most doors: whoever has that width right before a door goes
    /// straight through.
    pub(crate) fn empty_for_wheelchair(at: RoomRef<'_>, rules: &AuditRules) -> Option<Rc<Self>> {
        let AccessRules { turning, walkway } = rules.access;
        let doors = DoorDepth { behind: 0.0, before: walkway / 2.0 };
        Self::for_disc(at, &rules.walking, turning.max(walkway), doors)
    }

    /// The floor for discs up to a width; equal rooms share it.
    fn for_disc(at: RoomRef<'_>, rules: &WalkingRules, widest: f64, depth: DoorDepth) -> Option<Rc<Self>> {
        let is_door = |place: &RoomOpening| at.level.openings[place.opening].kind.is_walkable();
        let doors: Vec<&RoomOpening> = at.room.openings.iter().filter(|place| is_door(place)).collect();
        if doors.is_empty() {
            return None;
        }
        let widths = [rules.person, rules.narrow_person];
        let further = [widest, depth.behind, depth.before, widths[0], widths[1]];
        let make = || Self::new(at.room, &doors, widths, (widest, depth));
        Some(KNOWN.with_borrow_mut(|known| known.value(shape(at, &doors, &further), make, Self::cell_count)))
    }

    /// The floor of a room with its walkable openings.
    fn new(
        room: &Room,
        places: &[&RoomOpening],
        widths: [f64; 2],
        (widest, depth): (f64, DoorDepth),
    ) -> Self {
        let bounds = room.region.outline.bounds();
        let cell = cell_around(bounds.size(), CELL);
        let DoorDepth { behind, before } = depth.with_cells(cell);
        let mut raster = Raster::new(bounds.inflated(behind), cell);
        // Free areas are painted before what blocks: of a cell that is painted twice the last counts.
        raster.paint(&room.region.borders().collect::<Vec<_>>(), true);
        for place in places {
            raster.paint(&strip(room, place, -behind, cell.min(behind)), true);
        }
        for column in &room.obstacles {
            raster.paint(&column.outline.edges().collect::<Vec<_>>(), false);
        }
        let doors = places.iter().map(|place| Doorway::new(room, place, -cell..before, &raster)).collect();
        // Distances are exact as far as the widest disc needs them, which keeps them cheap in halls.
        let reach = raster.reach(widest);
        let distances = raster.distances(reach);
        let is_door = |place: &RoomOpening| places.contains(&place);
        let fixed = fixed_obstacles(room, is_door).into();
        Self { raster, distances, doors, reach, obstacles: Vec::new(), fixed, widths }
    }

    /// This floor with some solids more, with work for the cells near these only.
    pub(crate) fn with<'s>(&self, rules: &WalkingRules, solids: impl Iterator<Item = &'s Solid>) -> Self {
        let mut floor = self.clone();
        for solid in solids.filter(|solid| is_in_the_way(rules, solid)) {
            let blocked = floor.raster.paint(&edges(solid.footprint()).collect::<Vec<_>>(), false);
            floor.raster.lower_distances(&mut floor.distances, &blocked, floor.reach);
            floor.obstacles.push(Obstacle::of(solid));
        }
        let (old, new) = floor.obstacles.split_at(self.obstacles.len());
        let mut cells = Cells { raster: &floor.raster, distances: &mut floor.distances, widths: self.widths };
        cells.lower_in_gaps(new, &[old, &floor.fixed]);
        floor
    }

    /// Number of cells.
    pub(crate) fn cell_count(&self) -> usize {
        self.raster.len()
    }

    /// The doors, as indices into the level's openings.
    pub(crate) fn doors(&self) -> impl Iterator<Item = usize> {
        self.doors.iter().map(|door| door.opening)
    }

    /// Where a disc of a diameter gets to.
    ///
    /// Runs of cells are joined to those of the row before that they touch, sideways or across a corner. Doors
    /// join all runs on their threshold: who leaves by a wide opening may come in again at its other end.
    pub(crate) fn walk(&self, diameter: f64) -> Walk<'_> {
        let (runs, rows) = self.runs(self.raster.least_distance(diameter));
        let mut joined = DisjointSets::new(self.doors.len() + runs.len());
        let number = |run: usize| self.doors.len() + run;
        for three in rows.windows(3) {
            let (mut before, mut next) = (three[0], three[1]);
            let columns = self.raster.columns();
            while before < three[1] && next < three[2] {
                let above = runs[before].start + columns..runs[before].end + columns;
                let run = &runs[next];
                // One cell of overlap is not needed: a disc goes across a corner as it goes along a side.
                if above.start <= run.end && run.start <= above.end {
                    joined.join(number(before), number(next));
                }
                if above.end < run.end { before += 1 } else { next += 1 }
            }
        }
        for (door, doorway) in self.doors.iter().enumerate() {
            for threshold in &doorway.threshold {
                let row = threshold.start / self.raster.columns();
                let met = (rows[row]..rows[row + 1]).filter(|&run| overlaps(&runs[run], threshold));
                met.for_each(|run| joined.join(door, number(run)));
            }
        }
        let doors = (0..self.doors.len()).map(|door| joined.find(door)).collect();
        let runs = runs.into_iter().enumerate();
        let runs = runs.map(|(run, cells)| Run { cells, group: joined.find(number(run)) }).collect();
        Walk { floor: self, diameter, runs, rows, doors }
    }

    /// The runs of cells at least as far from everything as `least`, and the index of each row's first.
    fn runs(&self, least: u16) -> (Vec<Range<usize>>, Vec<usize>) {
        let is_wide = |distance: u16| distance >= least;
        let pairs = self.distances.iter().zip(&self.distances[1..]);
        let changes: Vec<u8> = pairs.map(|(&a, &b)| u8::from(is_wide(a) != is_wide(b))).collect();
        // Rows begin and end with blocked cells: every run has its end in its row. memchr compares 32 cells at once.
        let mut ends = memchr::memchr_iter(1, &changes).map(|change| change + 1);
        let mut runs = Vec::new();
        while let (Some(start), Some(end)) = (ends.next(), ends.next()) {
            runs.push(start..end);
        }
        let columns = self.raster.columns();
        let starts = (0..=self.distances.len() / columns).map(|row| row * columns);
        let rows = starts.map(|start| runs.partition_point(|run| run.start < start)).collect();
        (runs, rows)
    }
}

fn overlaps(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end && b.start < a.end
}

/// Whether people walk neither under a solid nor over it.
pub(crate) fn is_in_the_way(rules: &WalkingRules, solid: &Solid) -> bool {
    solid.low < rules.body_height && solid.high > rules.step
}

/// The strip along an opening between two distances from the wall's inner face, above zero inside the room.
fn strip(room: &Room, place: &RoomOpening, from: f64, to: f64) -> Vec<Segment> {
    let wall = &room.walls[place.wall];
    let at = |along: f64, inward: f64| wall.after(along) + wall.normal() * inward;
    let corners = [at(place.from, from), at(place.to, from), at(place.to, to), at(place.from, to)];
    edges(&corners).collect()
}

impl Doorway {
    /// Its threshold lies `across` the wall, in metres from the inner face.
    fn new(room: &Room, place: &RoomOpening, across: Range<f64>, raster: &Raster) -> Self {
        let mut threshold = Vec::new();
        raster.spans(&strip(room, place, across.start, across.end), |span| threshold.push(span));
        Self { opening: place.opening, threshold }
    }
}

impl Walk<'_> {
    /// A door of the group of most doors, then of most cells, then of the first door; an index into the level's
    /// openings.
    pub(crate) fn main_door(&self) -> usize {
        let doors_of = |group: Group| self.doors.iter().filter(|&&other| other == group).count();
        // Of groups with equally many doors the one with most floor: a closet is then what is missed, not the room.
        let rank =
            |&(_, group): &(usize, Group)| (Reverse(doors_of(group)), Reverse(self.size(group)), group);
        let best = self.doors().min_by_key(rank);
        best.expect("a floor has a door").0
    }

    /// The group of a door.
    pub(crate) fn group(&self, door: usize) -> Group {
        self.doors().find(|&(other, _)| other == door).expect("all walks have the same doors").1
    }

    /// Doors, as indices into the level's openings, with the group of each.
    pub(crate) fn doors(&self) -> impl Iterator<Item = (usize, Group)> {
        self.floor.doors.iter().zip(&self.doors).map(|(door, &group)| (door.opening, group))
    }

    /// Cells of a group.
    fn size(&self, group: Group) -> usize {
        self.runs.iter().filter(|run| run.group == group).map(|run| run.cells.len()).sum()
    }

    /// Runs of a row that have cells among some of it.
    fn runs_among(&self, span: &Range<usize>) -> &[Run] {
        let row = span.start / self.floor.raster.columns();
        let runs = &self.runs[self.rows[row]..self.rows[row + 1]];
        let from = runs.partition_point(|run| run.cells.end <= span.start);
        let to = runs.partition_point(|run| run.cells.start < span.end);
        &runs[from..to]
    }

    /// The cells on a door's threshold.
    pub(super) fn threshold(&self, door: usize) -> impl Iterator<Item = usize> {
        let doorway = self.floor.doors.iter().find(|doorway| doorway.opening == door);
        doorway.into_iter().flat_map(|doorway| doorway.threshold.iter().cloned().flatten())
    }

    /// The cells of a group.
    pub(super) fn cells(&self, group: Group) -> impl Iterator<Item = usize> {
        self.runs.iter().filter(move |run| run.group == group).flat_map(|run| run.cells.clone())
    }

    /// Whether the disc's middle gets into a convex area, from whatever door.
    pub(crate) fn enters(&self, area: &[Point]) -> bool {
        let mut is_inside = false;
        self.floor.raster.spans(&edges(area).collect::<Vec<_>>(), |span| {
            is_inside |= self.runs_among(&span).iter().any(|run| self.doors.contains(&run.group));
        });
        is_inside
    }

    /// Whether the middle of a disc of a group gets onto a convex area.
    fn stands_on(&self, group: Group, area: &[Point]) -> bool {
        self.any_on(area, |other| other == group, |_| true)
    }

    /// The cells of discs with their middle on a convex area.
    pub(super) fn standing_on(&self, area: &[Point]) -> Vec<usize> {
        let mut cells = Vec::new();
        self.any_on(
            area,
            |_| true,
            |cell| {
                cells.push(cell);
                false
            },
        );
        cells
    }

    /// Metres that the middle of a disc may be beside a convex area on which somebody stands.
    fn slack(&self, area: &[Point]) -> f64 {
        let across =
            |edge: Segment| area.iter().map(|&corner| edge.side(corner)).fold(0.0, f64::max) / edge.length();
        let depth = edges(area).map(across).fold(f64::INFINITY, f64::min);
        let [_, narrow] = self.floor.widths;
        if depth <= narrow + self.floor.raster.cell() / 2.0 {
            // Beside a bed people squeeze in sideways: the disc touches the area.
            self.diameter / 2.0
        } else {
            // Who uses a piece stands before it: with the middle beside the area they would reach past the corner of another.
            self.floor.raster.cell()
        }
    }

    /// Whether one of the cells of wanted groups with their middle on a convex area is the one looked for.
    fn any_on(
        &self,
        area: &[Point],
        is_wanted: impl Fn(Group) -> bool,
        mut is_it: impl FnMut(usize) -> bool,
    ) -> bool {
        let slack = self.slack(area);
        let around = Bounds::around(area.iter().copied()).inflated(slack).corners();
        let is_near = |cell: usize| distance_to_convex(area, self.floor.raster.middle(cell)) <= slack;
        let mut found = false;
        self.floor.raster.spans(&edges(&around).collect::<Vec<_>>(), |span| {
            for run in self.runs_among(&span).iter().filter(|run| is_wanted(run.group)) {
                // Only what both have: a run may be as long as the room.
                let mut cells = run.cells.start.max(span.start)..run.cells.end.min(span.end);
                found = found || cells.any(|cell| is_near(cell) && is_it(cell));
            }
        });
        found
    }

    /// Whether who comes in by a door (an index into the level's openings) gets to a goal.
    pub(crate) fn reaches(&self, home: usize, goal: Goal<'_>) -> bool {
        let group = self.group(home);
        match goal {
            Goal::Door(door) => self.group(door) == group,
            Goal::Area(area) => self.stands_on(group, area),
        }
    }

    /// The places where a wider disc may be, among those that this one gets to from some door, row by row; where it gets
    /// in by no door, among all.
    pub(crate) fn wide_places(&self, diameter: f64) -> impl Iterator<Item = Point> + '_ {
        let least = self.floor.raster.least_distance(diameter);
        let is_entered = self.runs.iter().any(|run| self.doors.contains(&run.group));
        let runs = self.runs.iter().filter(move |run| !is_entered || self.doors.contains(&run.group));
        let cells = runs.flat_map(|run| run.cells.clone());
        let wide = cells.filter(move |&cell| self.floor.distances[cell] >= least);
        wide.map(|cell| self.floor.raster.middle(cell))
    }

    /// The share of all places where the disc could stand that a group reaches (the walkable rate of
    /// PhyScene, Yang et al. 2024, for one door).
    pub(crate) fn rate(&self, group: Group) -> f64 {
        let all: usize = self.runs.iter().map(|run| run.cells.len()).sum();
        if all == 0 { 0.0 } else { self.size(group) as f64 / all as f64 }
    }
}
