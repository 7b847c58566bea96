//! Ways that furniture closes, and where.

use core::cell::{LazyCell, OnceCell, RefCell};

use crate::catalog::WalkingRules;
use crate::geometry::Point;

use super::floor::{Floor, Goal, Walk};
use super::queue::CellQueue;

/// A way that is too narrow in some places.
pub(crate) struct Way {
    /// Where it leads to, as index into the goals that were asked for.
    pub(crate) goal: usize,
    /// Metres that it needs everywhere.
    pub(crate) width: f64,
    /// Where it is narrower, cell by cell.
    pub(crate) narrows: Vec<Point>,
}

/// The ways from the main door to those goals that furniture closes. Where the empty room has no way of a
/// person's width, a narrow person must get through; where it has none at all, the plan is at fault and there is
/// no way to clear.
pub(crate) fn blocked_ways(
    floor: &Floor,
    empty: &Floor,
    rules: &WalkingRules,
    goals: &[Goal<'_>],
) -> Vec<Way> {
    let walk = floor.walk(rules.person);
    let home = walk.main_door();
    let is_missed = |&(_, goal): &(usize, Goal<'_>)| !walk.reaches(home, goal);
    let missed: Vec<(usize, Goal<'_>)> = goals.iter().copied().enumerate().filter(is_missed).collect();
    if missed.is_empty() {
        return Vec::new();
    }
    let wide = Passage::new(empty.walk(rules.person), walk, home);
    let narrow = LazyCell::new(|| {
        Passage::new(empty.walk(rules.narrow_person), floor.walk(rules.narrow_person), home)
    });
    let way = |&(index, goal): &(usize, Goal<'_>)| {
        // The plan may itself be too narrow for a person: then a narrow person must get through.
        let passage = if wide.is_possible(goal) { &wide } else { &*narrow };
        // A goal that the plan itself closes to both widths asks nothing of the furniture.
        (passage.is_possible(goal) && !passage.is_open(goal)).then(|| passage.way_to(index, goal))
    };
    missed.iter().filter_map(way).collect()
}

/// Where people of both widths get to in the empty room.
pub(crate) struct EmptyWalks<'f> {
    wide: Walk<'f>,
    narrow: Walk<'f>,
}

impl<'f> EmptyWalks<'f> {
    /// The walks on a floor without furniture.
    pub(crate) fn new(empty: &'f Floor, rules: &WalkingRules) -> Self {
        Self { wide: empty.walk(rules.person), narrow: empty.walk(rules.narrow_person) }
    }

    /// The floor without furniture.
    pub(crate) fn floor(&self) -> &'f Floor {
        self.wide.floor
    }

    /// Whether people get from every door to every other. Only then is a way that some furniture closes closed with more
    /// furniture too, for it never depends on the furniture which door counts as the main one.
    pub(crate) fn join_all_doors(&self) -> bool {
        let home = self.wide.main_door();
        self.wide.floor.doors().all(|door| self.wide.reaches(home, Goal::Door(door)))
    }

    /// Whether furniture closes a way to any goal: whether [`blocked_ways`] would find one, without asking where.
    pub(crate) fn are_blocked(&self, floor: &Floor, rules: &WalkingRules, goals: &[Goal<'_>]) -> bool {
        let walk = floor.walk(rules.person);
        let home = walk.main_door();
        let narrow = OnceCell::new();
        let is_shut = |&goal: &Goal<'_>| {
            let narrow = || narrow.get_or_init(|| floor.walk(rules.narrow_person));
            !walk.reaches(home, goal)
                && (self.wide.reaches(home, goal)
                    || (self.narrow.reaches(home, goal) && !narrow().reaches(home, goal)))
        };
        goals.iter().any(is_shut)
    }
}

/// Where people of one width get to from a door.
struct Passage<'f> {
    /// The walk in the empty room.
    empty: Walk<'f>,
    /// The walk in the furnished room.
    walk: Walk<'f>,
    home: usize,
    /// The least distance of cells where the disc may be.
    least: u16,
    /// Made where a way is asked for, and as far as that leads: it takes longer than all else.
    routes: OnceCell<RefCell<Routes>>,
}

/// The ways from a door that ask furniture for least room.
struct Routes {
    /// Cells from which ways may lead on.
    waiting: CellQueue,
    /// All ways that lack so much at most are known.
    known: u32,
    /// The width that the way to a cell lacks, by cell, summed over its cells in squared cells; the largest number where no way leads.
    costs: Vec<u32>,
    /// The cell before, or [`NOWHERE`] at the door.
    came_from: Vec<u32>,
}

const NOWHERE: u32 = u32::MAX;

fn number(cell: usize) -> u32 {
    u32::try_from(cell).expect("floors have fewer than 2^32 cells")
}

impl<'f> Passage<'f> {
    fn new(empty: Walk<'f>, walk: Walk<'f>, home: usize) -> Self {
        let least = walk.floor.raster.least_distance(walk.diameter);
        Self { empty, walk, home, least, routes: OnceCell::new() }
    }

    /// Whether the empty room has a way to a goal.
    fn is_possible(&self, goal: Goal<'_>) -> bool {
        self.empty.reaches(self.home, goal)
    }

    /// Whether the furnished room has one.
    fn is_open(&self, goal: Goal<'_>) -> bool {
        self.walk.reaches(self.home, goal)
    }

    /// The ways from the door that lack nothing (E. Dijkstra 1959, on cells): cells where the disc may be cost nothing, others
    /// what their distance lacks.
    fn routes(&self) -> Routes {
        let cell_count = self.walk.floor.distances.len();
        let (mut costs, came_from) = (vec![u32::MAX; cell_count], vec![NOWHERE; cell_count]);
        let starts = self.walk.cells(self.walk.group(self.home)).chain(self.walk.threshold(self.home));
        let starts: Vec<usize> = starts.filter(|&cell| self.allows(cell)).collect();
        for &cell in &starts {
            costs[cell] = self.cost(cell);
        }
        // Nearly all of a floor lies where ways begin, and where all around is free too, none begins.
        let begins =
            |&cell: &usize| costs[cell] > 0 || self.around(cell).into_iter().any(|next| costs[next] > 0);
        let mut waiting = CellQueue::new(cell_count, self.least);
        for cell in starts.into_iter().filter(begins) {
            waiting.push(costs[cell], cell);
        }
        let mut routes = Routes { waiting, known: 0, costs, came_from };
        self.spread(&mut routes, 0);
        routes
    }

    /// Goes on with all ways that lack so much at most.
    fn spread(&self, routes: &mut Routes, most: u32) {
        let Routes { waiting, known, costs, came_from } = routes;
        while let Some((cost, cell)) = waiting.pop_up_to(most) {
            // A cheaper way to this cell was found after the entry was made.
            if cost > costs[cell] {
                continue;
            }
            for next in self.around(cell) {
                let total = cost + self.cost(next);
                if total < costs[next] && self.allows(next) {
                    (costs[next], came_from[next]) = (total, number(cell));
                    waiting.push(total, next);
                }
            }
        }
        *known = most;
    }

    /// The cell among some that the cheapest way leads to, of equals the first in the grid.
    fn nearest(&self, routes: &mut Routes, ends: &[usize]) -> Option<usize> {
        loop {
            let cheapest = ends.iter().map(|&end| (routes.costs[end], end)).min()?;
            if cheapest.0 <= routes.known {
                return Some(cheapest.1);
            }
            if routes.waiting.is_empty() {
                return (cheapest.0 < u32::MAX).then_some(cheapest.1);
            }
            let most = if cheapest.0 < u32::MAX { cheapest.0 } else { routes.known + u32::from(self.least) };
            self.spread(routes, most);
        }
    }

    /// The cells around one where a disc may be, which is never at the edge of the grid.
    fn around(&self, cell: usize) -> [usize; 8] {
        let columns = self.walk.floor.raster.columns();
        let (before, after) = (cell - columns, cell + columns);
        [before - 1, before, before + 1, cell - 1, cell + 1, after - 1, after, after + 1]
    }

    /// The distance that a cell lacks to let the disc pass.
    fn cost(&self, cell: usize) -> u32 {
        // In squared cells, as distances are: zero where the disc may be, `least` inside a body.
        u32::from(self.least.saturating_sub(self.walk.floor.distances[cell]))
    }

    /// Whether the disc may be at a cell of the empty room.
    fn allows(&self, cell: usize) -> bool {
        self.empty.floor.distances[cell] >= self.least
    }

    /// The cheapest way to a goal of an index.
    fn way_to(&self, index: usize, goal: Goal<'_>) -> Way {
        let ends: Vec<usize> = match goal {
            Goal::Door(door) => self.walk.threshold(door).collect(),
            Goal::Area(area) => self.empty.standing_on(area),
        };
        let mut routes = self.routes.get_or_init(|| RefCell::new(self.routes())).borrow_mut();
        let end = self.nearest(&mut routes, &ends);
        let before = |&cell: &usize| {
            Some(routes.came_from[cell] as usize).filter(|&before| before != NOWHERE as usize)
        };
        let cells = core::iter::successors(end, before);
        let narrow = cells.filter(|&cell| self.cost(cell) > 0);
        let narrows = narrow.map(|cell| self.walk.floor.raster.middle(cell)).collect();
        Way { goal: index, width: self.walk.diameter, narrows }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::AuditRules;
    use crate::geometry::{Convex, Solid};
    use crate::plan::{LeafDraft, Level, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft};

    /// Rooms of 6 × 3 m, narrowed to `neck` metres between x = 2 and 3, with a door in each short wall.
    fn level(neck: f64) -> Level {
        let corners = [
            (0.0, 0.0),
            (6.0, 0.0),
            (6.0, 3.0),
            (3.0, 3.0),
            (3.0, neck),
            (2.0, neck),
            (2.0, 3.0),
            (0.0, 3.0),
        ];
        let room = RoomDraft {
            id: "room".to_owned(),
            outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(),
            ..RoomDraft::default()
        };
        let door = |id: &str, x: f64| OpeningDraft {
            id: id.to_owned(),
            kind: OpeningKind::Door,
            place: OpeningPlace::Points { center: Point::new(x, 1.0), along: None },
            rooms: vec!["room".to_owned()],
            width: 0.9,
            bottom: 0.0,
            top: 2.0,
            leaf: LeafDraft::Automatic,
        };
        let openings = vec![door("west", 0.0), door("east", 6.0)];
        let draft = LevelDraft { height: 3.0, rooms: vec![room], openings, ..LevelDraft::default() };
        crate::plan::assemble_level(draft).0
    }

    fn ways(level: &Level, solids: &[Solid], goals: &[Goal<'_>]) -> Vec<Way> {
        let rules = AuditRules::default().walking;
        let at = level.room(0);
        let empty = Floor::empty(at, &rules).unwrap();
        let floor = empty.with(&rules, solids.iter());
        let ways = blocked_ways(&floor, &empty, &rules, goals);
        let is_blocked = !ways.is_empty();
        assert_eq!(EmptyWalks::new(&empty, &rules).are_blocked(&floor, &rules, goals), is_blocked);
        ways
    }

    /// A cupboard from the south wall up to some metres before `top`, where x is 4.
    fn cupboard(top: f64) -> Solid {
        let middle = Point::new(4.0, top / 2.0);
        Solid::new(Convex::rectangle(middle, Point::new(0.3, top / 2.0), Point::X), 0.0, 2.0)
    }

    const DOORS: [Goal<'_>; 2] = [Goal::Door(0), Goal::Door(1)];

    #[test]
    fn a_free_way_asks_for_nothing() {
        assert!(ways(&level(3.0), &[cupboard(2.4)], &DOORS).is_empty());
    }

    #[test]
    fn the_way_leads_through_the_gap_that_is_almost_wide_enough() {
        let ways = ways(&level(3.0), &[cupboard(2.6)], &DOORS);
        assert_eq!((ways.len(), ways[0].width), (1, 0.45));
        let is_in_gap = |place: &Point| place.y > 2.6 && (place.x - 4.0).abs() < 0.6;
        assert!(
            !ways[0].narrows.is_empty() && ways[0].narrows.iter().all(is_in_gap),
            "{:?}",
            ways[0].narrows
        );
    }

    #[test]
    fn a_wall_of_furniture_is_crossed_where_it_is_thinnest() {
        let thin =
            Solid::new(Convex::rectangle(Point::new(4.0, 2.0), Point::new(0.05, 1.0), Point::X), 0.0, 2.0);
        let ways = ways(&level(3.0), &[cupboard(1.0), thin], &DOORS);
        let beside = |place: &&Point| (place.x - 4.0).abs() < 0.3;
        let crossing: Vec<&Point> = ways[0].narrows.iter().filter(beside).collect();
        assert!(!crossing.is_empty() && crossing.iter().all(|place| place.y > 0.95), "{crossing:?}");
    }

    #[test]
    fn where_the_plan_is_narrow_a_narrow_way_is_enough_and_where_it_is_shut_none_is_asked_for() {
        assert!(ways(&level(0.4), &[], &DOORS).is_empty(), "one turns sideways");
        let narrow = ways(&level(0.4), &[cupboard(2.8)], &DOORS);
        assert_eq!((narrow.len(), narrow[0].width), (1, 0.3));
        assert!(ways(&level(0.2), &[cupboard(2.8)], &DOORS).is_empty());
    }

    #[test]
    fn doors_are_joined_where_people_walk_upright() {
        let are_joined = |neck: f64| {
            let (level, rules) = (level(neck), AuditRules::default().walking);
            let floor = Floor::empty(level.room(0), &rules).unwrap();
            EmptyWalks::new(&floor, &rules).join_all_doors()
        };
        assert!(are_joined(0.6));
        assert!(!are_joined(0.4), "one turns sideways");
    }

    #[test]
    fn an_area_behind_furniture_is_a_goal_too() {
        let area = [(5.0, 2.0), (5.8, 2.0), (5.8, 2.8), (5.0, 2.8)].map(|(x, y)| Point::new(x, y));
        let west = [Goal::Door(0), Goal::Area(&area)];
        let level = level(3.0);
        assert!(ways(&level, &[], &west).is_empty());
        assert_eq!(ways(&level, &[cupboard(3.0)], &west[1..]).len(), 1);
    }

    #[test]
    fn who_uses_a_piece_stands_before_it_and_does_not_reach_it_past_the_corner_of_another() {
        // Between two cupboards at the north wall 0.35 m are left: enough to put a foot in, too little to stand there.
        let beside = |x: f64| {
            Solid::new(Convex::rectangle(Point::new(x, 2.6), Point::new(0.5, 0.4), Point::X), 0.0, 2.0)
        };
        let cupboards = [beside(3.5), beside(4.85)];
        let between = |width: f64| {
            let (low, high) = (Point::new(4.0, 2.2), Point::new(4.0 + width, 2.8));
            [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
        };
        let is_closed =
            |area: &[Point]| !ways(&level(3.0), &cupboards, &[Goal::Door(0), Goal::Area(area)]).is_empty();
        assert!(is_closed(&between(0.35)));
        // Where people squeeze in sideways, as beside a bed, it is enough to get to the end.
        assert!(!is_closed(&between(0.3)));
    }
}
