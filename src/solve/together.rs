//! Whether an empty room could hold several pieces at the same time, and where.

use crate::audit::{ROUNDING, penetration};
use crate::catalog::{Class, ClassIndex, Size};
use crate::geometry::{Convex, Solid};
use crate::layout::Suggestion;
use crate::walk::{EmptyWalks, Floor, Goal};

use super::empty_room::EmptyRoom;
use super::footprint::Footprint;
use super::hold::{Stand, Stands, smallest_size};

/// Pairs of places compared before the question is given up.
const MOST_TESTS: u32 = 1_000_000;
/// Whole arrangements of which the ways are looked at before the search becomes careful.
const MOST_ARRANGEMENTS: u32 = 100;
/// Square metres of floor on which ways are looked at before the question is given up: of 10 m², two thousand times.
const MOST_FLOOR: f64 = 20_000.0;
/// Cells of a floor in the time of one other step of the budget.
const CELLS_A_STEP: u64 = 8;
/// The share of the places to go on by: the golden section meets all parts of a list early.
const STRIDE: f64 = 0.618_033_988_749_894_9;

/// The answer about several pieces in an empty room.
#[derive(Clone, Debug)]
pub(crate) enum Together {
    /// They fit, each at its place; ways to doors and to all used sides stay open.
    Fit(Vec<Suggestion>),
    /// They do not.
    TooMuch,
    /// It would take too long to find out.
    Unknown,
}

/// Whether one piece of each class, in its smallest size and with its smallest clearances, fits on the empty floor
/// at the same time. Clearances may share space. `places_of` gives the places of each class by itself.
pub(crate) fn place_together(
    empty: &EmptyRoom<'_>,
    classes: &[ClassIndex],
    places_of: impl Fn(ClassIndex) -> Option<Stands>,
) -> Together {
    let choices = classes.iter().map(|&class| Some(Choice::new(empty, class, places_of(class)?)));
    let choices: Option<Vec<Choice<'_>>> = choices.collect();
    // Of some class the budget did not suffice to find the places.
    let Some(choices) = choices else { return Together::Unknown };
    let open: Vec<Open<'_>> =
        choices.iter().map(|choice| Open { choice, stands: choice.stands().collect() }).collect();
    let answer = search(empty, &open);
    // A coarse net may have missed the places with which they fit.
    let knows_all_places = choices.iter().all(|choice| choice.places.are_all);
    match answer {
        Together::TooMuch if !knows_all_places => Together::Unknown,
        answer => answer,
    }
}

/// Looks at the ways of whole arrangements; if none of those it tries is open, again with care.
fn search(empty: &EmptyRoom<'_>, open: &[Open<'_>]) -> Together {
    let rules = &empty.rules().walking;
    let floor = Floor::empty(empty.at, rules);
    let walks = floor.as_ref().map(|floor| EmptyWalks::new(floor, rules));
    let quick = Search::new(empty, walks.as_ref(), MOST_ARRANGEMENTS);
    match (quick.answer(open), &walks) {
        (Together::Unknown, Some(walks)) if walks.join_all_doors() => {
            let most = (MOST_FLOOR / empty.at.room.region.area()) as u32;
            Search { is_careful: true, ..Search::new(empty, Some(walks), most) }.answer(open)
        }
        (answer, _) => answer,
    }
}

/// A piece with all the places that it has in the empty room.
struct Choice<'c> {
    index: ClassIndex,
    class: &'c Class,
    size: Size,
    places: Stands,
}

impl<'c> Choice<'c> {
    fn new(empty: &EmptyRoom<'c>, index: ClassIndex, places: Stands) -> Self {
        let class = &empty.catalog.classes[index];
        Self { index, class, size: smallest_size(class), places }
    }

    /// All places, those along walls first, neighbours far from each other.
    fn stands(&self) -> impl Iterator<Item = &Stand> {
        let stands = &self.places.stands;
        let at_walls = stands.partition_point(|stand| stand.spot.wall.is_some());
        let (at_walls, inside) = stands.split_at(at_walls);
        spread(at_walls).chain(spread(inside))
    }
}

/// All items once, each far from the one before.
fn spread<T>(items: &[T]) -> impl Iterator<Item = &T> {
    let count = items.len();
    let shares_factor = |stride: usize| {
        (2..=stride).any(|factor| stride.is_multiple_of(factor) && count.is_multiple_of(factor))
    };
    let mut stride = ((count as f64 * STRIDE) as usize).max(1);
    // A stride without a common factor visits every item once before it comes back.
    while shares_factor(stride) {
        stride -= 1;
    }
    (0..count).map(move |number| &items[number * stride % count])
}

/// A piece that has no place yet, with the places that those who have one leave it.
#[derive(Clone)]
struct Open<'s> {
    choice: &'s Choice<'s>,
    stands: Vec<&'s Stand>,
}

/// A depth-first search for places that agree, with forward checking (R. Haralick, G. Elliott, "Increasing Tree
/// Search Efficiency for Constraint Satisfaction Problems", 1980).
struct Search<'s, 'a> {
    empty: &'s EmptyRoom<'a>,
    /// Where people get to in the empty room; nothing where no door leads in.
    walks: Option<&'s EmptyWalks<'s>>,
    placed: Vec<(&'s Choice<'s>, &'s Stand)>,
    tests: u32,
    /// How often ways were looked at.
    arrangements: u32,
    most_arrangements: u32,
    /// Whether the ways are looked at after each piece, and of each piece alone, not of whole arrangements only: for
    /// rooms with places enough, nearly all of which close a way. A way that is closed stays closed when a piece is
    /// added, if the room [joins all its doors](EmptyWalks::join_all_doors).
    is_careful: bool,
}

impl<'s, 'a> Search<'s, 'a> {
    fn new(empty: &'s EmptyRoom<'a>, walks: Option<&'s EmptyWalks<'s>>, most_arrangements: u32) -> Self {
        let placed = Vec::new();
        Self { empty, walks, placed, tests: 0, arrangements: 0, most_arrangements, is_careful: false }
    }

    fn answer(mut self, open: &[Open<'s>]) -> Together {
        let open = if self.is_careful { self.without_closing(open) } else { open.to_vec() };
        if self.place_next(&open) {
            Together::Fit(self.suggestions())
        } else if self.is_given_up() {
            Together::Unknown
        } else {
            Together::TooMuch
        }
    }

    /// The open pieces without the places where one closes a way by itself, as far as half of the arrangements go;
    /// who has the least choice first.
    fn without_closing(&mut self, open: &[Open<'s>]) -> Vec<Open<'s>> {
        let mut open = open.to_vec();
        open.sort_by_key(|piece| piece.stands.len());
        for Open { choice, stands } in &mut open {
            stands.retain(|&stand| {
                self.placed.push((*choice, stand));
                let stays = self.arrangements >= self.most_arrangements / 2 || self.has_open_ways();
                self.placed.pop();
                stays
            });
        }
        open
    }

    /// Places the open pieces. Who has the least choice goes first, so that dead ends are seen early; in a careful search
    /// the largest, which decides more than others where ways are left.
    fn place_next(&mut self, open: &[Open<'s>]) -> bool {
        let asks_for_ways = open.is_empty() || (self.is_careful && self.placed.len() > 1);
        if asks_for_ways && !self.has_open_ways() {
            return false;
        }
        let rank = |&index: &usize| {
            let Open { choice, stands } = &open[index];
            // Whole square millimetres, so that equal sizes are equal.
            let square_millimetres = (choice.size.width * choice.size.depth * 1e6) as i64;
            if self.is_careful { (-square_millimetres, stands.len()) } else { (0, stands.len()) }
        };
        let Some(next) = (0..open.len()).min_by_key(rank) else {
            return true;
        };
        for &stand in &open[next].stands {
            if self.is_given_up() {
                return false;
            }
            let others = open.iter().enumerate().filter(|&(index, _)| index != next);
            let left: Vec<Open<'s>> = others.map(|(_, other)| self.left_beside(other, stand)).collect();
            // Forward checking: a piece that keeps no place is a dead end, seen before any of the others is placed.
            if left.iter().all(|other| !other.stands.is_empty()) {
                self.placed.push((open[next].choice, stand));
                if self.place_next(&left) {
                    return true;
                }
                self.placed.pop();
            }
        }
        false
    }

    /// The places of a piece that agree with another's.
    fn left_beside(&mut self, open: &Open<'s>, stand: &Stand) -> Open<'s> {
        self.tests += u32::try_from(open.stands.len()).unwrap_or(MOST_TESTS);
        self.empty.budget.spend(open.stands.len() as u64);
        let stands = open.stands.iter().copied().filter(|other| agree(stand, other)).collect();
        Open { choice: open.choice, stands }
    }

    fn is_given_up(&self) -> bool {
        self.tests > MOST_TESTS
            || self.arrangements >= self.most_arrangements
            || self.empty.budget.is_overdrawn()
    }

    /// Whether people get to all doors and to the pieces that have places.
    fn has_open_ways(&mut self) -> bool {
        self.arrangements += 1;
        let rules = &self.empty.rules().walking;
        let solids: Vec<Solid> = self.placed.iter().map(|(choice, stand)| body(choice, stand)).collect();
        let Some(walks) = self.walks else { return true };
        let floor = &walks.floor().with(rules, solids.iter());
        self.empty.budget.spend(floor.cell_count() as u64 / CELLS_A_STEP);
        let sides = self.placed.iter().flat_map(|(choice, stand)| {
            let clearances = choice.class.clearances.iter().zip(&stand.parts[1..]);
            // Narrower strips are elbow room that nobody stands in: the audit asks for no way to them either.
            clearances.filter(|(clearance, _)| clearance.minimum >= rules.narrow_person).map(|(_, part)| part)
        });
        let sides = sides.map(|part| Goal::Area(&part.corners));
        let goals: Vec<Goal<'_>> = floor.doors().map(Goal::Door).chain(sides).collect();
        !walks.are_blocked(floor, rules, &goals)
    }

    fn suggestions(&self) -> Vec<Suggestion> {
        let suggestion = |(choice, stand): &(&Choice<'_>, &Stand)| Suggestion {
            class: choice.index,
            size: choice.size,
            position: stand.spot.position,
            angle: stand.spot.angle,
            wall: stand.spot.wall,
        };
        self.placed.iter().map(suggestion).collect()
    }
}

fn body(choice: &Choice<'_>, stand: &Stand) -> Solid {
    Solid::new(Convex::from_corners(&stand.parts[0].corners), 0.0, choice.size.height)
}

/// Whether neither piece takes floor that the other needs.
fn agree(one: &Stand, other: &Stand) -> bool {
    let meets = |a: &Footprint, b: &Footprint| {
        a.bounds.overlaps(b.bounds, 0.0) && penetration(&a.corners, &b.corners) > ROUNDING
    };
    !one.bounds.overlaps(other.bounds, 0.0)
        || (!other.parts.iter().any(|part| meets(&one.parts[0], part))
            && !one.parts.iter().skip(1).any(|part| meets(&other.parts[0], part)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::testing::TestRoom;
    use crate::plan::OpeningKind;
    use crate::solve::constants::MOST_STEPS;
    use crate::solve::hold::free_stands;

    fn place(room: &TestRoom, classes: &[&str]) -> Together {
        let empty = EmptyRoom::new(room.level.room(0), &room.catalog, MOST_STEPS);
        let classes: Vec<ClassIndex> =
            classes.iter().map(|class| room.catalog.class_index(class).unwrap()).collect();
        place_together(&empty, &classes, |class| Some(free_stands(&empty, class)))
    }

    #[test]
    fn two_chests_need_the_floor_of_two() {
        let suggestions = |width: f64| match place(&TestRoom::rectangle(width, 1.02), &["chest", "chest"]) {
            Together::Fit(suggestions) => suggestions.len(),
            _ => 0,
        };
        assert_eq!(suggestions(2.05), 2);
        assert_eq!(suggestions(1.95), 0);
    }

    #[test]
    fn what_would_close_the_way_to_a_door_does_not_fit() {
        let fits = |depth: f64| {
            let mut room = TestRoom::rectangle(3.0, depth);
            room.open(1, OpeningKind::Passage, (0.0, depth), (0.0, 2.0));
            room.open(3, OpeningKind::Passage, (0.0, depth), (0.0, 2.0));
            matches!(place(&room, &["chest"]), Together::Fit(_))
        };
        assert!(!fits(1.2), "a chest of one metre leaves no way past it");
        assert!(fits(1.8));
    }

    /// A corridor of 1.2 m between two passages, where a chest leaves no way past it, with a niche that makes it a little
    /// wider for as long as a chest is.
    fn corridor(niche: f64) -> TestRoom {
        let (low, high) = (1.2, 1.2 + niche);
        let corners = [
            (0.0, 0.0),
            (5.0, 0.0),
            (5.0, low),
            (3.6, low),
            (3.6, high),
            (2.5, high),
            (2.5, low),
            (0.0, low),
        ];
        let mut room = TestRoom::outline(&corners);
        room.open(1, OpeningKind::Passage, (0.0, low), (0.0, 2.0));
        room.open(7, OpeningKind::Passage, (0.0, low), (0.0, 2.0));
        room
    }

    #[test]
    fn where_nearly_all_places_close_a_way_the_one_that_does_not_is_found_or_none_is() {
        assert!(matches!(place(&corridor(0.3), &["chest"]), Together::Fit(_)));
        assert!(matches!(place(&corridor(0.2), &["chest"]), Together::TooMuch));
    }

    #[test]
    fn whole_arrangements_alone_do_not_tell_that_a_corridor_is_too_narrow() {
        let room = corridor(0.2);
        let empty = EmptyRoom::new(room.level.room(0), &room.catalog, MOST_STEPS);
        let chest = room.catalog.class_index("chest").unwrap();
        let choice = Choice::new(&empty, chest, free_stands(&empty, chest));
        let open = [Open { choice: &choice, stands: choice.stands().collect() }];
        let rules = &empty.rules().walking;
        let floor = Floor::empty(empty.at, rules).unwrap();
        let walks = EmptyWalks::new(&floor, rules);
        let quick = Search::new(&empty, Some(&walks), MOST_ARRANGEMENTS);
        assert!(matches!(quick.answer(&open), Together::Unknown));
    }

    #[test]
    fn every_item_comes_once_and_far_from_the_one_before() {
        for count in [0, 1, 2, 7, 100] {
            let items: Vec<usize> = (0..count).collect();
            let mut seen: Vec<usize> = spread(&items).copied().collect();
            seen.sort_unstable();
            assert_eq!(seen, items);
        }
        let hundred: Vec<i64> = (0..100).collect();
        let order: Vec<i64> = spread(&hundred).copied().collect();
        assert!(order.windows(2).all(|pair| (pair[0] - pair[1]).abs() > 20));
    }
}
