//! Which agents are asked for: what stands in for a piece without a place, and what waits for the piece that it belongs to.
//! Not in the paper.

use super::agent::{Agent, State};
use super::environment::Environment;
use super::locked::is_locked;
use super::place::AgentIndex;

/// Whether an agent waits for the piece that it was counted by: a chair without its table is not asked for.
pub(crate) fn is_waiting(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let Some(companion) = environment.agents[agent].piece.companion else { return false };
    let stand_ins = &environment.brief.catalog.classes[companion].stand_ins;
    environment.resting[companion].is_empty() && environment.resting_of(stand_ins).next().is_none()
}

/// Whether another piece stands in for an agent.
pub(crate) fn has_stand_in(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    steps_down(environment, agent) > 0
}

/// The agent that is to stand in for one that found no place, if it was not asked for before. Required pieces are
/// replaced only where the alternative says so: another arrangement may have a place for them.
pub(crate) fn next_substitute(environment: &Environment<'_>, agent: AgentIndex) -> Option<AgentIndex> {
    let is_required = environment.agents[agent].piece.is_required;
    // An optional piece has its stand-in at once: no further attempt is made for it alone.
    let may_replace = !is_required || environment.brief.alternative.takes_substitutes;
    substitute(environment, agent)
        .filter(|&other| may_replace && environment.agents[other].state == State::Unasked)
}

fn substitute(environment: &Environment<'_>, agent: AgentIndex) -> Option<AgentIndex> {
    environment.brief.substitutes[agent]
}

/// Whether an agent is a piece that was asked for and is not there. Pieces that only fill what room is left are not missed, nor
/// are those with a stand-in, nor those that would stand by a piece that is not there or carry one that others stand in for.
pub(crate) fn is_missed(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let piece = &environment.agents[agent].piece;
    matches!(environment.agents[agent].state, State::Removed(_))
        && !piece.is_fill
        && piece.substitute_for.is_none()
        && !is_waiting(environment, agent)
        && !has_stand_in(environment, agent)
        && !would_carry_nothing(environment, agent)
}

/// Whether others stand in for all that an agent is there to carry: who reads in place of watching needs no television stand.
fn would_carry_nothing(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let carries = &environment.class(agent).carries;
    let is_load = |other: &AgentIndex| {
        let piece = &environment.agents[*other].piece;
        carries.contains(&piece.class) && piece.substitute_for.is_none()
    };
    let mut loads = (0..environment.agents.len()).filter(is_load).peekable();
    loads.peek().is_some() && loads.all(|load| has_stand_in(environment, load))
}

/// Substitutes from which on a list is for what a room lives by. Shorter: more arrangements are tried for want of small things.
const LONG_LIST: usize = 3;

/// Of an attempt: what stands in for others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StandIns {
    /// How far down the lists of substitutes the pieces are that stand in for others: 1 for the first of a list, summed. The whole
    /// list counts where none of it has a place.
    pub steps_down: u32,
    /// Pieces with a long list of substitutes ([`LONG_LIST`]) of which none has a place: a living room with neither screen nor
    /// reading corner.
    pub spent_lists: u32,
    /// Whether a required piece is missing for which nothing was tried that may stand in for it.
    pub are_left: bool,
}

impl StandIns {
    /// Of all agents.
    pub(crate) fn of(environment: &Environment<'_>) -> Self {
        let heads = || {
            (0..environment.agents.len()).filter(|&agent| {
                environment.agents[agent].piece.substitute_for.is_none()
                    && matches!(environment.agents[agent].state, State::Removed(_))
            })
        };
        let is_left = |agent: AgentIndex| {
            environment.agents[agent].piece.is_required
                && !environment.brief.alternative.takes_substitutes
                && substitute(environment, agent).is_some()
        };
        let is_spent = |&agent: &AgentIndex| {
            steps_down(environment, agent) == 0 && substitutes(environment, agent).count() >= LONG_LIST
        };
        Self {
            steps_down: heads().map(|agent| lost(environment, agent)).sum(),
            spent_lists: heads().filter(is_spent).count() as u32,
            are_left: heads().any(is_left),
        }
    }
}

/// What the room lacks because an agent found no place: the piece, if it is missed, and the steps down to what stands in for it.
pub(crate) fn lack(environment: &Environment<'_>, agent: AgentIndex) -> u32 {
    match environment.agents[agent].piece.substitute_for {
        Some(_) => 0,
        None => u32::from(is_missed(environment, agent)) + lost(environment, agent),
    }
}

/// Steps down the list of substitutes of an agent without a place to the one that stands in for it; all of them if none does.
fn lost(environment: &Environment<'_>, agent: AgentIndex) -> u32 {
    match steps_down(environment, agent) {
        0 => substitutes(environment, agent).count() as u32,
        steps => steps,
    }
}

/// Which of its substitutes stands in for an agent, from 1; 0 if none does.
fn steps_down(environment: &Environment<'_>, agent: AgentIndex) -> u32 {
    let rests = |&(_, other): &(u32, AgentIndex)| environment.agents[other].rest().is_some();
    (1..).zip(substitutes(environment, agent)).find(rests).map_or(0, |(step, _)| step)
}

/// What may stand in for an agent, one after the other.
pub(crate) fn substitutes(
    environment: &Environment<'_>,
    agent: AgentIndex,
) -> impl Iterator<Item = AgentIndex> {
    core::iter::successors(substitute(environment, agent), |&other| substitute(environment, other))
}

/// The piece that is there to carry an agent and may search for another place: it did so once at most, and nothing that the room cannot do
/// without belongs to it.
pub(crate) fn movable_carrier(environment: &Environment<'_>, agent: AgentIndex) -> Option<AgentIndex> {
    let class = environment.agents[agent].piece.class;
    (0..environment.agents.len()).find(|&other| {
        environment.class(other).carries.contains(&class)
            && environment.agents[other].rest().is_some()
            && environment.agents[other].searches == 0
            && !environment.has_required(other)
            && !is_locked(environment, other)
    })
}

/// Whether an agent is there to carry something, nothing of that stands on it, and the room can do without it.
pub(crate) fn carries_nothing(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let carries = &environment.class(agent).carries;
    let stands_on_it = |&child: &AgentIndex| carries.contains(&environment.agents[child].piece.class);
    !carries.is_empty()
        && environment.agents[agent].rest().is_some()
        && !environment.agents[agent].piece.is_required
        && !is_locked(environment, agent)
        && !environment.agents[agent].children.iter().any(stands_on_it)
}

/// The pieces that were there to carry an agent without a place and have nothing else to carry: nor do they wait for it.
pub(crate) fn idle_carriers(environment: &Environment<'_>, agent: AgentIndex) -> Vec<AgentIndex> {
    let class = environment.agents[agent].piece.class;
    let is_idle = |&other: &AgentIndex| {
        let carries = &environment.class(other).carries;
        let waits_for = |load: &Agent| load.state == State::Search && carries.contains(&load.piece.class);
        carries.contains(&class)
            && carries_nothing(environment, other)
            && !environment.agents.iter().any(waits_for)
    };
    (0..environment.agents.len()).filter(is_idle).collect()
}

/// Lets those search again that found no place, but for those who were sent away themselves: there is more room now.
pub(crate) fn ask_missed(environment: &mut Environment<'_>) {
    for agent in 0..environment.agents.len() {
        if is_missed(environment, agent) && !environment.agents[agent].is_in_the_way {
            environment.lacking = environment.lacking.saturating_sub(lack(environment, agent));
            environment.agents[agent].state = State::Search;
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::catalog::{
        Along, Catalog, Class, Count, ParentName, Relation, RelationKind, Side, Turn, Untidiness,
    };
    use crate::layout::tests::{WIDE, catalog, level, rule, run};
    use crate::layout::{Alternative, FurnishOptions, Furnished, RoomLayout, StandIns};

    const CHAIR: usize = 0;
    const DESK: usize = 1;
    const LAMP: usize = 2;
    const SHELF: usize = 4;

    /// Beside the door there is room for a shelf, and none for a desk.
    const NARROW: &[(f64, f64)] = &[(0.0, 0.0), (1.3, 0.0), (1.3, 2.4), (0.0, 2.4)];

    fn names(catalog: &Catalog, furnished: &Furnished) -> (Vec<String>, Vec<String>) {
        let id = |class: usize| catalog.classes[class].id.clone();
        (
            furnished.placements.iter().map(|placement| id(placement.class)).collect(),
            furnished.removals.iter().map(|removal| id(removal.class)).collect(),
        )
    }

    fn needs(kind: RelationKind, target: usize, distance: (f64, f64)) -> Relation {
        let target = ParentName::Classes(vec![target]);
        Relation { kind, target, distance, angle: 0.5, weight: 1.0, is_needed: true }
    }

    #[test]
    fn a_chair_without_its_desk_is_not_asked_for() {
        let programme = [(DESK, Count::Fixed(1)), (CHAIR, Count::PerPiece(DESK, 2.0))];
        let mut catalog = catalog(&programme, Untidiness::default());
        let at_wall = rule(ParentName::Wall, &[Side::Front], Turn::Parallel, Along::Random);
        let tagged = crate::catalog::ParentRule { tag: Some("seating".to_owned()), ..at_wall.clone() };
        catalog.classes[CHAIR].parents.push(tagged);
        let furnished = run(&level(NARROW), &catalog, 1);
        assert_eq!(names(&catalog, &furnished), (vec![], vec!["desk".to_owned()]));
        assert_eq!(furnished.requested, 1);
        assert!(!run(&level(WIDE), &catalog, 1).placements.is_empty());
        catalog.classes[CHAIR].parents.push(at_wall);
        let stands = names(&catalog, &run(&level(NARROW), &catalog, 1)).0;
        assert_eq!(stands, ["chair", "chair"], "what stands by itself by design stays");
    }

    #[test]
    fn a_rug_without_the_desk_that_it_lies_under_is_not_asked_for() {
        let programme = [(DESK, Count::Fixed(1)), (LAMP, Count::PerPiece(DESK, 1.0))];
        let mut catalog = catalog(&programme, Untidiness::default());
        let rug = &mut catalog.classes[LAMP];
        rug.covers = vec![DESK];
        rug.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Parallel, Along::Random)];
        let furnished = run(&level(NARROW), &catalog, 1);
        assert_eq!(names(&catalog, &furnished), (vec![], vec!["desk".to_owned()]));
    }

    #[test]
    fn an_optional_piece_without_a_place_is_replaced_by_the_next_of_its_line() {
        let programme = [(DESK, Count::Fixed(1)), (LAMP, Count::PerPiece(SHELF, 1.0))];
        let mut catalog = catalog(&programme, Untidiness::default());
        catalog.room_types.get_mut("office").unwrap().programme[0].substitutes = vec![SHELF];
        catalog.classes[SHELF].sides[Side::Above.index()].places = 1;
        catalog.classes[LAMP].parents =
            vec![rule(ParentName::Classes(vec![SHELF, DESK]), &[Side::Above], Turn::Parallel, Along::Center)];
        let found = names(&catalog, &run(&level(NARROW), &catalog, 1));
        assert_eq!(found, (vec!["shelf".to_owned(), "lamp".to_owned()], vec![]), "with what belongs to it");
        let found = names(&catalog, &run(&level(WIDE), &catalog, 1));
        assert_eq!(found, (vec!["desk".to_owned()], vec![]), "and not where it has a place");
    }

    #[test]
    fn what_would_carry_a_piece_is_not_missed_where_another_stands_in_for_that() {
        let programme = [(DESK, Count::Fixed(1)), (LAMP, Count::Fixed(1))];
        let mut catalog = catalog(&programme, Untidiness::default());
        catalog.classes[DESK].carries = vec![LAMP];
        let missing = names(&catalog, &run(&level(NARROW), &catalog, 1)).1;
        assert_eq!(missing, ["desk", "lamp"]);
        catalog.room_types.get_mut("office").unwrap().programme[1].substitutes = vec![SHELF];
        let found = names(&catalog, &run(&level(NARROW), &catalog, 1));
        assert_eq!(found, (vec!["shelf".to_owned()], vec![]));
    }

    #[test]
    fn an_arrangement_that_lacks_as_much_as_another_is_given_up() {
        let catalog = catalog(&[(DESK, Count::Fixed(2)), (SHELF, Count::Fixed(1))], Untidiness::default());
        let (level, options) = (level(NARROW), FurnishOptions::new(1, "test"));
        let layout = RoomLayout::new(level.room(0), &catalog, &options);
        let finished = |gives_up_at: Option<u32>| {
            let made = layout.furnish(&Alternative { gives_up_at, ..Alternative::numbered(1) });
            (!made.is_given_up).then_some(made)
        };
        let whole = finished(None).expect("nothing says that it is given up");
        assert_eq!(whole.furnished.removals.len(), 2);
        assert_eq!(finished(Some(3)).as_ref(), Some(&whole));
        assert_eq!(finished(Some(2)), None);
    }

    #[test]
    fn of_a_piece_for_which_nothing_stands_in_the_whole_list_counts() {
        let mut catalog = catalog(&[(DESK, Count::Fixed(1))], Untidiness::default());
        let table = Class { id: "table".to_owned(), ..catalog.classes[DESK].clone() };
        catalog.classes.push(table);
        let mut stand_ins = |substitutes: &[usize]| {
            catalog.room_types.get_mut("office").unwrap().programme[0].substitutes = substitutes.to_vec();
            let (level, options) = (level(NARROW), FurnishOptions::new(1, "test"));
            let layout = RoomLayout::new(level.room(0), &catalog, &options);
            let StandIns { steps_down, spent_lists, .. } =
                layout.furnish(&Alternative::default()).shortcomings.stand_ins;
            (steps_down, spent_lists)
        };
        assert_eq!(stand_ins(&[]), (0, 0));
        // A lamp stands on desks, a shelf has a place.
        assert_eq!(stand_ins(&[LAMP, SHELF]), (2, 0));
        assert_eq!(stand_ins(&[LAMP, CHAIR]), (2, 0), "a short list is for small things");
        assert_eq!(stand_ins(&[LAMP, CHAIR, SHELF + 1]), (3, 1));
    }

    #[test]
    fn a_required_piece_is_replaced_only_where_the_alternative_says_so() {
        let mut catalog = catalog(&[(DESK, Count::Fixed(1))], Untidiness::default());
        let request = &mut catalog.room_types.get_mut("office").unwrap().programme[0];
        (request.substitutes, request.is_required) = (vec![SHELF], true);
        let (level, options) = (level(NARROW), FurnishOptions::new(1, "test"));
        let layout = RoomLayout::new(level.room(0), &catalog, &options);
        let usual = layout.furnish(&Alternative::default());
        assert_eq!(names(&catalog, &usual.furnished), (vec![], vec!["desk".to_owned()]));
        assert!(usual.shortcomings.stand_ins.are_left);
        let last = layout.furnish(&Alternative { takes_substitutes: true, ..Alternative::default() });
        assert_eq!(names(&catalog, &last.furnished), (vec!["shelf".to_owned()], vec![]));
        assert_eq!(
            (last.shortcomings.stand_ins.are_left, last.shortcomings.stand_ins.steps_down),
            (false, 1)
        );
    }

    #[test]
    fn what_needs_to_see_something_looks_for_a_place_with_what_carries_it() {
        let programme = [(DESK, Count::Fixed(1)), (LAMP, Count::Fixed(1)), (SHELF, Count::Fixed(1))];
        let mut catalog = catalog(&programme, Untidiness::default());
        // The desk stands before the shelf comes, and wishes to be near it.
        catalog.classes[DESK].priority = 1;
        let near = needs(RelationKind::Near, SHELF, (0.0, 1.2));
        catalog.classes[DESK].relations = vec![Relation { is_needed: false, weight: 5.0, ..near.clone() }];
        catalog.classes[LAMP].relations = vec![near];
        let has_lamp = |carries: &[usize], seed: u64| {
            let mut catalog = catalog.clone();
            catalog.classes[DESK].carries = carries.to_vec();
            run(&level(WIDE), &catalog, seed).removals.is_empty()
        };
        let count = |carries: &[usize]| (0..16).filter(|&seed| has_lamp(carries, seed)).count();
        let (fixed, moved) = (count(&[]), count(&[LAMP]));
        assert!(fixed < 16 && moved > fixed, "{fixed} with a fixed desk, {moved} with one that moves");
    }

    #[test]
    fn what_must_be_away_from_something_stands_where_it_is() {
        let mut catalog =
            catalog(&[(DESK, Count::Fixed(1)), (SHELF, Count::Fixed(1))], Untidiness::default());
        catalog.classes[DESK].priority = 1;
        let away = |metres: f64| vec![needs(RelationKind::AwayFrom, DESK, (metres, 100.0))];
        catalog.classes[SHELF].relations = away(1.0);
        assert_eq!(run(&level(WIDE), &catalog, 1).placements.len(), 2);
        catalog.classes[SHELF].relations = away(9.0);
        assert_eq!(run(&level(WIDE), &catalog, 1).placements.len(), 1);
    }
}
