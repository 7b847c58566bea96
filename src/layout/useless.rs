//! What is there to carry something and carries nothing is given back: an empty television stand. Not in the paper.

use super::agent::State;
use super::arrange::arrange;
use super::environment::Environment;
use super::locked::is_locked;
use super::movement::send_away;
use super::place::AgentIndex;
use super::seed::RoomKey;

/// Takes away what is there to carry something that found no place on it.
pub(crate) fn give_back(environment: &mut Environment<'_>, key: &RoomKey) {
    let useless: Vec<AgentIndex> =
        (0..environment.agents.len()).filter(|&agent| is_useless(environment, agent)).collect();
    for &agent in &useless {
        send_away(environment, agent);
    }
    for &agent in &useless {
        environment.agents[agent].state = State::Unasked;
    }
    if !useless.is_empty() {
        // Who stood on it or by it.
        arrange(environment, key);
    }
}

fn is_useless(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    let carries = &environment.class(agent).carries;
    let stands_on_it = |&child: &AgentIndex| carries.contains(&environment.agents[child].piece.class);
    !carries.is_empty()
        && environment.agents[agent].rest().is_some()
        && !environment.agents[agent].piece.is_required
        && !is_locked(environment, agent)
        && !environment.agents[agent].children.iter().any(stands_on_it)
}

#[cfg(test)]
mod tests {
    use crate::catalog::{Count, ParentName, Relation, RelationKind, Untidiness};
    use crate::layout::tests::{WIDE, catalog, level, run};

    const DESK: usize = 1;
    const LAMP: usize = 2;
    const SHELF: usize = 4;

    #[test]
    fn a_stand_on_which_nothing_stands_is_given_back() {
        let mut catalog = catalog(&[(DESK, Count::Fixed(1)), (LAMP, Count::Fixed(1))], Untidiness::default());
        catalog.classes[DESK].carries = vec![LAMP];
        assert_eq!(run(&level(WIDE), &catalog, 1).placements.len(), 2);
        // It needs a shelf that is not there.
        let shelf = ParentName::Classes(vec![SHELF]);
        catalog.classes[LAMP].relations = vec![Relation {
            kind: RelationKind::Near,
            target: shelf,
            distance: (0.0, 1.0),
            angle: 0.5,
            weight: 1.0,
            is_needed: true,
        }];
        let furnished = run(&level(WIDE), &catalog, 1);
        let missing: Vec<usize> = furnished.removals.iter().map(|removal| removal.class).collect();
        assert_eq!((furnished.placements.len(), missing), (0, vec![LAMP]), "the stand is not missed");
    }
}
