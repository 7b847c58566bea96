//! Takes away pieces that have lost their use: a television stand that carries nothing (`carries` of its class), a seat of an
//! auditorium that stands alone in its row (`company`). Not in the paper.

use crate::catalog::Class;

use super::agent::{Agent, Rest, State};
use super::arrange::arrange;
use super::environment::Environment;
use super::locked::is_locked;
use super::movement::{family, send_away};
use super::place::AgentIndex;
use super::seed::RoomKey;
use super::wanted;

/// Cosine of the angle by which neighbours in a row may differ: untidy styles turn them a little.
const SAME_WAY: f64 = 0.95;
/// Metres by which neighbours may be farther apart than their grid or their width says, after untidiness.
const APART: f64 = 0.1;

/// Takes away what is there to carry something that found no place on it, and what needs company and stands alone.
pub(crate) fn give_back(environment: &mut Environment<'_>, key: &RoomKey) {
    let useless = (0..environment.agents.len()).filter(|&agent| wanted::carries_nothing(environment, agent));
    let mut leaving: Vec<AgentIndex> = useless.collect();
    let alone = alone(environment);
    leaving.extend(&alone);
    // What is at them was asked for with them, and others that only fill what room is left would take their places.
    let mut unasked = leaving.clone();
    unasked.extend(alone.iter().flat_map(|&agent| family(environment, agent)).map(|(member, _)| member));
    unasked.extend((0..environment.agents.len()).filter(|&other| would_follow(environment, &alone, other)));
    for &agent in &leaving {
        send_away(environment, agent);
    }
    for &agent in &unasked {
        environment.agents[agent].state = State::Unasked;
    }
    if !leaving.is_empty() {
        wanted::ask_missed(environment);
        // Who stood on it or by it, and who may have a place now.
        arrange(environment, key);
    }
}

/// The pieces that need company and have none. Where none of a class has any, all stay.
fn alone(environment: &Environment<'_>) -> Vec<AgentIndex> {
    let classes = &environment.brief.catalog.classes;
    let resting = environment.resting.iter().enumerate().filter(|(class, _)| classes[*class].needs_company);
    resting.flat_map(|(class, resting)| alone_of(environment, &classes[class], resting)).collect()
}

fn alone_of(environment: &Environment<'_>, class: &Class, resting: &[AgentIndex]) -> Vec<AgentIndex> {
    let rests: Vec<&Rest> = resting.iter().filter_map(|&agent| environment.agents[agent].rest()).collect();
    let reach = |agent: AgentIndex| {
        class.grid.map_or(environment.agents[agent].size.width, |grid| grid.interval.x) + APART
    };
    let is_alone = |agent: &AgentIndex| {
        let own = environment.agents[*agent].rest();
        own.is_some_and(|own| !rests.iter().any(|other| is_beside(own, other, reach(*agent))))
    };
    let mut alone: Vec<AgentIndex> = resting.iter().copied().filter(is_alone).collect();
    if alone.len() == resting.len() {
        return Vec::new();
    }
    alone.retain(|&agent| !is_locked(environment, agent));
    alone
}

/// Whether another piece is the next in the row of one: to its left or right within some metres, and turned the same way.
fn is_beside(one: &Rest, other: &Rest, metres: f64) -> bool {
    let offset = other.pose.position - one.pose.position;
    let along = offset.dot(one.pose.right).abs();
    let across = offset.dot(one.pose.right.perp()).abs();
    along > across && along <= metres && one.pose.right.dot(other.pose.right) > SAME_WAY
}

/// Whether an agent without a place only fills what room is left and is of the class of some of others.
fn would_follow(environment: &Environment<'_>, others: &[AgentIndex], agent: AgentIndex) -> bool {
    let Agent { piece, state, .. } = &environment.agents[agent];
    let is_without_place = matches!(state, State::Search | State::Removed(_));
    let is_of_class = |other: &AgentIndex| environment.agents[*other].piece.class == piece.class;
    piece.is_fill && is_without_place && others.iter().any(is_of_class)
}

#[cfg(test)]
mod tests {
    use crate::catalog::{
        Along, Catalog, Class, Count, Grid, ParentName, Relation, RelationKind, Side, Size, Turn, Untidiness,
    };
    use crate::geometry::{Point, direction};
    use crate::layout::Placement;
    use crate::layout::tests::{WIDE, catalog, level, rule, run};

    const DESK: usize = 1;
    const LAMP: usize = 2;
    const SHELF: usize = 4;

    /// Lamps that stand in rows on the floor.
    fn seats(count: Count, needs_company: bool) -> Catalog {
        let mut catalog = catalog(&[(LAMP, count)], Untidiness::default());
        let seat = &mut catalog.classes[LAMP];
        seat.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random)];
        seat.grid = Some(Grid {
            interval: Point::new(0.7, 1.0),
            block: [0, 0],
            aisle: 0.0,
            is_centered: true,
            is_halved: false,
            is_back_to_back: false,
            margin: [0.0; 4],
        });
        seat.needs_company = needs_company;
        catalog
    }

    /// How many have no neighbour in their row.
    fn lone(placements: &[Placement]) -> usize {
        let is_beside = |one: &Placement, other: &Placement| {
            let offset = other.position - one.position;
            let along = offset.dot(direction(one.angle)).abs();
            (0.1..0.75).contains(&along) && offset.length() < along + 0.1
        };
        let is_alone = |one: &&Placement| !placements.iter().any(|other| is_beside(one, other));
        placements.iter().filter(is_alone).count()
    }

    #[test]
    fn a_seat_without_another_beside_it_is_left_out() {
        let triangle = level(&[(0.0, 0.0), (8.0, 0.0), (4.0, 6.0)]);
        let lone_seats = |needs_company: bool| {
            let placements = run(&triangle, &seats(Count::Fill(100), needs_company), 1).placements;
            (lone(&placements), placements.len())
        };
        let (lone, all) = lone_seats(false);
        assert!(lone > 0 && all > 10, "{lone} of {all}");
        let (still_lone, kept) = lone_seats(true);
        assert_eq!((still_lone, kept), (0, all - lone));
    }

    #[test]
    fn rows_of_what_needs_company_fill_one_after_the_other() {
        let hall = level(&[(0.0, 0.0), (9.0, 0.0), (9.0, 8.0), (0.0, 8.0)]);
        let apart = Relation {
            kind: RelationKind::AwayFrom,
            target: ParentName::Classes(vec![LAMP]),
            distance: (3.0, 100.0),
            angle: 0.5,
            weight: 1.0,
            is_needed: false,
        };
        let mut catalog = seats(Count::Fixed(6), true);
        catalog.classes[LAMP].relations = vec![apart];
        let placements = run(&hall, &catalog, 1).placements;
        assert_eq!((lone(&placements), placements.len()), (0, 6), "though they would rather be apart");
    }

    /// A stand, and what is to stand on it but needs a shelf that is not there.
    fn stand_for_nothing(further: &[(usize, Count)]) -> Catalog {
        let programme = [&[(DESK, Count::Fixed(1)), (LAMP, Count::Fixed(1))], further].concat();
        let mut catalog = catalog(&programme, Untidiness::default());
        catalog.classes[DESK].carries = vec![LAMP];
        let shelf = ParentName::Classes(vec![SHELF]);
        catalog.classes[LAMP].relations = vec![Relation {
            kind: RelationKind::Near,
            target: shelf,
            distance: (0.0, 1.0),
            angle: 0.5,
            weight: 1.0,
            is_needed: true,
        }];
        catalog
    }

    #[test]
    fn a_stand_on_which_nothing_stands_is_given_back() {
        let mut catalog = stand_for_nothing(&[]);
        let furnished = run(&level(WIDE), &catalog, 1);
        let missing: Vec<usize> = furnished.removals.iter().map(|removal| removal.class).collect();
        assert_eq!((furnished.placements.len(), missing), (0, vec![LAMP]), "the stand is not missed");
        catalog.classes[LAMP].relations.clear();
        assert_eq!(run(&level(WIDE), &catalog, 1).placements.len(), 2);
    }

    #[test]
    fn who_found_no_place_beside_a_stand_that_is_given_back_has_one_then() {
        let mut catalog = stand_for_nothing(&[(SHELF + 1, Count::Fixed(1))]);
        let size = Size { width: 5.0, depth: 3.8, height: 0.7 };
        let on_floor = rule(ParentName::Floor, &[Side::Above], Turn::Parallel, Along::Random);
        let table = Class { sizes: vec![size], parents: vec![on_floor], ..catalog.classes[SHELF].clone() };
        catalog.classes.push(Class { id: "table".to_owned(), ..table });
        catalog.classes[DESK].priority = 1;
        let classes = |catalog: &Catalog| -> Vec<usize> {
            run(&level(WIDE), catalog, 1).placements.iter().map(|placement| placement.class).collect()
        };
        assert_eq!(classes(&catalog), [SHELF + 1]);
        catalog.classes[LAMP].relations.clear();
        assert_eq!(classes(&catalog), [DESK, LAMP], "they leave it no room");
    }
}
