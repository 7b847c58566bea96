//! The attempts at a room: what one does, how two are compared, and which is kept.

use std::collections::BTreeSet;

use crate::catalog::{Access, ClassIndex, ParentName};

use super::agent::State;
use super::brief::Brief;
use super::constants::{
    ALTERNATIVES_WITH_TAGS, ATTEMPTS, ATTEMPTS_IN_NEED, MISSING_SHARE, MOST_STEPS, MOST_STEPS_FOR_WAYS,
};
use super::environment::{Environment, Start};
use super::furnished::Furnished;
use super::place::AgentIndex;
use super::rules::PoorPlaces;
use super::seed::RoomKey;
use super::shortcomings::Shortcomings;
use super::wanted::StandIns;
use super::{
    arrange, covering, fitted, jointly, locked, push, result, turning, untidy, useless, wanted, ways,
};

/// Whether what agents meet on their search is noted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Recording {
    /// It is, for an explanation.
    On,
    /// It is not.
    Off,
}

/// The attempt that is kept.
pub(crate) struct Kept<T> {
    /// The room.
    pub(crate) furnished: Furnished,
    /// Its description.
    pub(crate) description: T,
    /// Which attempt it is, from 1.
    pub(crate) number: u32,
    /// How many there were.
    pub(crate) attempts: u32,
    /// The work of all of them, in steps of about a tenth of a microsecond.
    pub(crate) steps: u64,
    /// What it lacks, beside the removals.
    pub(crate) shortcomings: Shortcomings,
    /// Whether it was given up before it was finished.
    pub(crate) is_given_up: bool,
}

/// Furnishes a room as often as it deserves and keeps the attempt that lacks least, of equals the first. `describe` gives a
/// description of each.
pub(crate) fn best_attempt<T>(
    brief: &Brief<'_>,
    recording: Recording,
    describe: impl Fn(&Environment<'_>, &Furnished) -> T,
) -> Kept<T> {
    let mut urgency = vec![0; brief.pieces.len()];
    let mut attempt = |number: u32| {
        let attempt = Attempt::new(brief, number, recording, &urgency, &describe);
        // Counts attempts, 15 at most. A larger count is served earlier among agents of the same depth.
        attempt.missed.iter().for_each(|&agent| urgency[agent] += 1);
        attempt
    };
    let mut best = attempt(0);
    let (mut attempts, mut steps) = (1, best.steps);
    while attempts < best.deserved_attempts(brief) && steps < best.most_steps() {
        let next = attempt(attempts);
        steps += next.steps;
        // Less, not as little: of equals the first attempt stays.
        if next.lack < best.lack {
            best = next;
        }
        attempts += 1;
    }
    let Attempt { furnished, description, number, shortcomings, lack, .. } = best;
    let (number, is_given_up) = (number + 1, lack.is_given_up);
    Kept { furnished, description, number, attempts, steps, shortcomings, is_given_up }
}

/// The lack of an attempt, the worst first: attempts are compared in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Lack {
    /// Whether it was given up, so that what else it lacks is not known.
    is_given_up: bool,
    /// Classes of which a required piece is missing and none is there.
    classes_without_any: usize,
    /// Ways that are closed, with the room to turn where the style asks for it.
    closed_ways: usize,
    /// Required pieces that are missing.
    required: usize,
    /// Fitted units that were sent away from their row: a kitchen in pieces.
    strays: usize,
    /// All pieces that are missing.
    pieces: usize,
    /// How far down their lists the pieces are that stand in for others ([`StandIns::steps_down`]).
    steps_down: u32,
}

impl Lack {
    fn of(
        environment: &Environment<'_>,
        furnished: &Furnished,
        closed_ways: usize,
        stand_ins: StandIns,
    ) -> Self {
        let required = || furnished.removals.iter().filter(|removal| removal.is_required);
        let is_stray = |agent: &AgentIndex| {
            environment.class(*agent).fitted.is_some() && environment.agents[*agent].is_in_the_way
        };
        let is_there = |class| furnished.placements.iter().any(|placement| placement.class == class);
        let classes: BTreeSet<ClassIndex> = required().map(|removal| removal.class).collect();
        Self {
            is_given_up: environment.is_given_up(),
            classes_without_any: classes.into_iter().filter(|&class| !is_there(class)).count(),
            closed_ways,
            required: required().count(),
            strays: (0..environment.agents.len()).filter(is_stray).count(),
            pieces: furnished.removals.len(),
            steps_down: stand_ins.steps_down,
        }
    }
}

/// One of the times that a room is furnished.
struct Attempt<T> {
    /// Counts from 0.
    number: u32,
    furnished: Furnished,
    lack: Lack,
    /// The agents that the next attempt should serve first.
    missed: BTreeSet<AgentIndex>,
    description: T,
    steps: u64,
    shortcomings: Shortcomings,
}

impl<T> Attempt<T> {
    fn new(
        brief: &Brief<'_>,
        number: u32,
        recording: Recording,
        urgency: &[u32],
        describe: impl Fn(&Environment<'_>, &Furnished) -> T,
    ) -> Self {
        let alternative = brief.alternative.number;
        let heeds_tags = alternative < ALTERNATIVES_WITH_TAGS && number < ATTEMPTS;
        let turn = (alternative + number) as usize;
        let start = Start { urgency, heeds_tags, turn, is_traced: recording == Recording::On };
        let mut environment = Environment::new(brief, &start);
        // No two attempts share a number: an alternative has ATTEMPTS_IN_NEED at most.
        let key = brief.key.attempt(alternative * ATTEMPTS_IN_NEED + number);
        let closed_ways = act_all(&mut environment, &key, number == 0);
        let furnished = result::furnished(&environment);
        let stand_ins = StandIns::of(&environment);
        Self {
            number,
            lack: Lack::of(&environment, &furnished, closed_ways, stand_ins),
            shortcomings: Shortcomings { stand_ins, poor_places: PoorPlaces::of(&environment) },
            missed: missed(&environment),
            description: describe(&environment, &furnished),
            steps: environment.steps(),
            furnished,
        }
    }

    /// Steps after which no further attempt begins.
    fn most_steps(&self) -> u64 {
        if self.lack.closed_ways > 0 { MOST_STEPS_FOR_WAYS } else { MOST_STEPS }
    }

    /// How many attempts the room deserves.
    fn deserved_attempts(&self, brief: &Brief<'_>) -> u32 {
        let Lack { is_given_up, classes_without_any, closed_ways, required, strays, pieces, .. } = self.lack;
        if is_given_up {
            return 1;
        }
        let misses_many = pieces as f64 > MISSING_SHARE * f64::from(self.furnished.requested);
        // Without its only bed, or without a way through, a room gets four times the attempts.
        let is_in_need = classes_without_any > 0 || closed_ways > 0;
        match (is_in_need, brief.alternative.number) {
            (true, 0) => ATTEMPTS_IN_NEED,
            (true, _) => ATTEMPTS,
            (false, 0) if required > 0 || strays > 0 || misses_many => ATTEMPTS,
            // Who compares alternatives has more of them.
            (false, _) => 1,
        }
    }
}

/// The steps of section 4: actions until all agents rest or are removed, then the style's untidiness; after that,
/// ways are cleared and rugs laid. Returns how many ways stay closed; what is given up keeps no ways.
fn act_all(environment: &mut Environment<'_>, key: &RoomKey, is_first: bool) -> usize {
    let style = environment.brief.style;
    locked::settle_locked(environment);
    fitted::settle_fitted(environment, key);
    jointly::settle_jointly(environment, key);
    if environment.brief.alternative.puts_required_first {
        put_required(environment, key, is_first);
    }
    arrange::arrange(environment, key);
    push::push_apart(environment);
    if untidy::make_untidy(environment, &style.untidiness, key) {
        arrange::arrange(environment, key);
    }
    useless::give_back(environment, key);
    if environment.is_given_up() {
        return 0;
    }
    wanted::ask_missed(environment);
    arrange::arrange(environment, key);
    // Who is sent away from here on searches among all that rest.
    let lacks_turn = style.access == Access::Wheelchair && turning::lacks_turn(environment, key);
    let closed_ways = ways::clear_ways(environment, key, is_first);
    // Who was sent away may have been on something that is there for it alone.
    useless::give_back(environment, key);
    // Rugs last: they are in nobody's way, so that the rest of the room is the same without them.
    covering::lay(environment);
    closed_ways + usize::from(lacks_turn)
}

/// Lets the required pieces settle alone, with ways between them: what the room can do without comes later and keeps them free.
fn put_required(environment: &mut Environment<'_>, key: &RoomKey, is_first: bool) {
    let can_wait = |&agent: &AgentIndex| {
        environment.agents[agent].state == State::Search && !environment.has_required(agent)
    };
    let waiting: Vec<AgentIndex> = (0..environment.agents.len()).filter(can_wait).collect();
    for &agent in &waiting {
        environment.agents[agent].state = State::Unasked;
    }
    arrange::arrange(environment, key);
    ways::clear_ways(environment, key, is_first);
    for agent in waiting {
        environment.agents[agent].state = State::Search;
    }
}

/// The agents that the next attempt should serve first: the required pieces that found no place, and those by which they would
/// stand. What goes wrong first is dealt with first: D. Joslin, D. Clements, "Squeaky Wheel Optimization", 1999.
fn missed(environment: &Environment<'_>) -> BTreeSet<AgentIndex> {
    let is_missed = |agent: &AgentIndex| {
        environment.agents[*agent].piece.is_required && wanted::is_missed(environment, *agent)
    };
    let missed: BTreeSet<AgentIndex> = (0..environment.agents.len()).filter(is_missed).collect();
    let rules = missed.iter().flat_map(|&agent| &environment.class(agent).parents);
    let parents = rules.filter_map(|rule| match &rule.parent {
        ParentName::Classes(classes) => Some(environment.resting_of(classes)),
        _ => None,
    });
    missed.iter().copied().chain(parents.flatten()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Count, Untidiness};
    use crate::layout::brief::RoomBrief;
    use crate::layout::tests::{WIDE, catalog, level};
    use crate::layout::{Alternative, FurnishOptions};

    #[test]
    fn required_pieces_stand_before_others_of_a_higher_priority_search() {
        let (desk, shelf) = (1, 4);
        let mut catalog =
            catalog(&[(desk, Count::Fixed(1)), (shelf, Count::Fixed(2))], Untidiness::default());
        catalog.classes[shelf].priority = 9;
        for room_type in catalog.room_types.values_mut() {
            room_type.programme[0].is_required = true;
        }
        let level = level(WIDE);
        let options = FurnishOptions::new(1, "test");
        let room = RoomBrief::new(level.room(0), &catalog, &options).expect("offices are furnished");
        let alternative = Alternative { puts_required_first: true, ..Alternative::numbered(1) };
        let brief = room.alternative(&alternative);
        let urgency = vec![0; brief.pieces.len()];
        let start = Start { urgency: &urgency, heeds_tags: false, turn: 0, is_traced: false };
        let mut environment = Environment::new(&brief, &start);
        put_required(&mut environment, brief.key, true);
        let is_desk = |agent: AgentIndex| environment.agents[agent].piece.class == desk;
        for agent in 0..environment.agents.len() {
            let waits = environment.agents[agent].state == State::Search;
            assert_eq!(
                (waits, environment.agents[agent].rest().is_some()),
                (!is_desk(agent), is_desk(agent))
            );
        }
    }
}
