//! Ways that furniture closes, and where.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::catalog::WalkingRules;
use crate::geometry::Point;

use super::floor::{Floor, Goal, Walk};
use super::raster::least_distance;

/// A way that is too narrow in some places.
pub(crate) struct Way {
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
    empty: impl FnOnce() -> Floor,
    rules: &WalkingRules,
    goals: &[Goal<'_>],
) -> Vec<Way> {
    let walk = floor.walk(rules.person);
    let home = walk.main_door();
    let is_missed = |goal: &Goal<'_>| !walk.reaches(home, *goal);
    let missed: Vec<Goal<'_>> = goals.iter().copied().filter(is_missed).collect();
    if missed.is_empty() {
        return Vec::new();
    }
    let empty = empty();
    let narrow = (empty.walk(rules.narrow_person), floor.walk(rules.narrow_person));
    let wide = (empty.walk(rules.person), walk);
    let way = |&goal: &Goal<'_>| {
        let (possible, walk) = [&wide, &narrow].into_iter().find(|(empty, _)| empty.reaches(home, goal))?;
        (!walk.reaches(home, goal)).then(|| shortest_way((possible, walk), home, goal))
    };
    missed.iter().filter_map(way).collect()
}

/// The way between a door and a goal that asks furniture for least room (E. Dijkstra 1959, on cells): those where
/// the disc may be cost nothing, others what their distance lacks.
fn shortest_way((empty, walk): (&Walk<'_>, &Walk<'_>), home: usize, goal: Goal<'_>) -> Way {
    const NOWHERE: usize = usize::MAX;
    let floor = walk.floor;
    let least = least_distance(walk.diameter);
    let cost = |cell: usize| u32::from(least.saturating_sub(floor.distances[cell]));
    let is_possible = |cell: usize| empty.floor.distances[cell] >= least;
    let mut is_goal = vec![false; floor.distances.len()];
    match goal {
        Goal::Door(door) => walk.threshold(door).for_each(|cell| is_goal[cell] = true),
        Goal::Area(area) => empty.touching(area).into_iter().for_each(|cell| is_goal[cell] = true),
    }
    let mut costs = vec![u32::MAX; floor.distances.len()];
    let mut came_from = vec![NOWHERE; floor.distances.len()];
    let mut waiting = BinaryHeap::new();
    for cell in walk.cells(walk.group(home)).chain(walk.threshold(home)).filter(|&cell| is_possible(cell)) {
        costs[cell] = cost(cell);
        waiting.push(Reverse((costs[cell], cell)));
    }
    let columns = floor.raster.columns();
    let mut end = NOWHERE;
    while let Some(Reverse((known, cell))) = waiting.pop() {
        if is_goal[cell] {
            end = cell;
            break;
        }
        if known > costs[cell] {
            continue;
        }
        // Cells where a disc may be are never at the edge of the grid.
        for row in [cell - columns, cell, cell + columns] {
            for next in (row - 1..=row + 1).filter(|&next| is_possible(next)) {
                let total = known + cost(next);
                if total < costs[next] {
                    (costs[next], came_from[next]) = (total, cell);
                    waiting.push(Reverse((total, next)));
                }
            }
        }
    }
    let mut narrows = Vec::new();
    while end != NOWHERE {
        if cost(end) > 0 {
            narrows.push(floor.raster.middle(end));
        }
        end = came_from[end];
    }
    Way { width: walk.diameter, narrows }
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
        let place = (level, &level.rooms[0]);
        let floor = Floor::new(place, &rules, solids.iter()).unwrap();
        let empty = || Floor::new(place, &rules, core::iter::empty()).unwrap();
        blocked_ways(&floor, empty, &rules, goals)
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
    fn an_area_behind_furniture_is_a_goal_too() {
        let area = [(5.0, 2.0), (5.8, 2.0), (5.8, 2.8), (5.0, 2.8)].map(|(x, y)| Point::new(x, y));
        let west = [Goal::Door(0), Goal::Area(&area)];
        let level = level(3.0);
        assert!(ways(&level, &[], &west).is_empty());
        assert_eq!(ways(&level, &[cupboard(3.0)], &west[1..]).len(), 1);
    }
}
