//! Pieces that look for their places together, before anything else: the fixtures of a bathroom.
//!
//! One after the other, a bath takes the wall that the toilet needs, and a basin gets what is left, beside the door. Together
//! they are compared as whole arrangements: all that [`crate::catalog::Class::is_joint`] names are placed in the order of their priority, each
//! arrangement so far in several ways, and the best arrangements go on (a beam search). Points are those of the usual search,
//! with the walls that the classes like (docs/fixtures.md). What may stand in for a piece is compared too: a tub under the window in
//! place of a tray between open sides. At the end taste moves the points of the arrangements, so that of those that are nearly as
//! good each has seeds that choose it. A piece without a place in the best arrangement
//! searches by itself.

mod niche;
#[cfg(test)]
mod tests;

use super::agent::State;
use super::arrange::{area, in_its_look, sizes_by, take_size};
use super::arrangement::{Arrangement, Standing};
use super::environment::Environment;
use super::first_search::of_first_search;
use super::known::Found;
use super::locked::is_locked;
use super::place::{AgentIndex, ParentPart};
use super::rules::{self, Line, Score, free_stretches, steps_along};
use super::seed::{Purpose, RoomKey, Stream};
use super::spot::Spot;
use super::suggested::suggestion;
use super::wanted;
use crate::catalog::{Along, ClassIndex, ParentName, Side};
use crate::plan::WallKind;

/// Arrangements that go on after each piece. More find better ones, and cost as much more.
const ARRANGEMENTS: usize = 40;
/// How many of them have all pieces at the same walls at most.
const ALIKE: usize = 4;
/// Points by which chance moves a place: of places that are equally good a seed takes one. Larger: more variety, and fixtures
/// at walls that they like less.
const CHANCE: f64 = 0.5;
/// Points by which taste moves a whole arrangement, at most: as much as a smaller size loses, less than what is tight, dark or out of
/// place. Larger: more arrangements of a room, and then faults that others do not have.
const TASTE: f64 = 4.0;
/// Metres by which a piece of two arrangements may stand apart where the two are one to people.
const SAME_PLACE: f64 = 0.4;
/// Points lost for a piece without a place, required or not: more than all walls and wishes give together.
const MISSED: f64 = 30.0;
const MISSED_REQUIRED: f64 = 100.0;
/// Points lost, beyond those of the score, where a window gets dark, and where somebody has less room than is good: all the room
/// is still free, so that other walls are to be had.
const SPOILT: f64 = 6.0;
const TIGHT: f64 = 9.0;
/// Points lost for a tub or a tray with both sides open, or with a strip of a niche beside it: less than for a window that gets
/// dark.
const OUT_OF_PLACE: f64 = 5.0;
/// Points lost for a smaller size than the one that was drawn: half of what a tight place loses, for it may spare that. From 9 on,
/// narrow bathrooms keep large fixtures with too little space before them; less, and baths stand less often where architects
/// have them.
const SMALLER: f64 = 4.0;
/// Points for filling a niche: as much as half a tight place loses; the more, the more tubs stand where architects have the
/// toilet.
const NICHE: f64 = 4.0;
/// Points lost for a piece that stands in for another: as much as for a smaller size. More, and trays stay between open sides.
const STAND_IN: f64 = 4.0;

/// A place that the next piece could take.
struct Way {
    standing: Standing,
    points: f64,
    /// Whether somebody has less room than is good because of it, a window gets dark, or the piece belongs in a corner and is in none.
    is_poor: bool,
}

/// The part of the room that a piece of a class stands at, and whether its size only fills niches: where it takes so much that the
/// next has no good place, the usual sizes are still there.
type Outline = (ClassIndex, ParentPart, bool);

/// What stands where: arrangements that agree in this look alike.
fn outline(environment: &Environment<'_>, arrangement: &Arrangement) -> Vec<Outline> {
    let of = |standing: &Standing| {
        let class = environment.agents[standing.agent].piece.class;
        let fills = standing.variant >= environment.class(standing.agent).common_variant_count();
        (class, standing.place.parent, fills)
    };
    arrangement.standings.iter().map(of).collect()
}

/// Lets the pieces of the room that belong together rest where they stand best as a whole: each attempt at a room takes the best
/// arrangement of another outline, for something was wrong with those before.
pub(crate) fn settle_jointly(environment: &mut Environment<'_>, key: &RoomKey) {
    let agents = joint_agents(environment);
    if agents.len() < 2 || agents.iter().any(|&agent| suggestion(environment, agent).is_some()) {
        return;
    }
    let chosen = at_turn_of_first_search(environment, &agents).or_else(|| {
        let found = search(environment, &agents, key);
        let kinds = kinds(environment, &found.best_first);
        kinds.get(environment.turn).or(kinds.last()).map(|&kind| kind.clone())
    });
    if let Some(chosen) = chosen {
        stand(environment, &chosen);
        chosen.standings.iter().for_each(|standing| niche::fill_niche(environment, standing.agent));
    }
}

/// The arrangement that this attempt takes of those that the first attempt found. None where these are too few, or where it is not known
/// to find the same room: where others rest than locked pieces, or somebody says where some fit.
fn at_turn_of_first_search(environment: &mut Environment<'_>, agents: &[AgentIndex]) -> Option<Arrangement> {
    let brief = environment.brief;
    let mut resting =
        (0..environment.agents.len()).filter(|&agent| environment.agents[agent].rest().is_some());
    if !brief.alternative.suggestions.is_empty() || !resting.all(|agent| is_locked(environment, agent)) {
        return None;
    }
    let known = &brief.known_arrangements[usize::from(environment.heeds_tags)];
    of_first_search(
        environment,
        known,
        |environment| search(environment, agents, brief.key),
        |environment, found| kinds(environment, found).get(environment.turn).map(|&kind| kind.clone()),
    )
}

/// Finds arrangements of some agents (a beam search).
fn search(environment: &mut Environment<'_>, agents: &[AgentIndex], key: &RoomKey) -> Found<Arrangement> {
    let before = environment.steps();
    let mut stream = key.stream(Purpose::Placement, "jointly", 0);
    let mut arrangements = vec![Arrangement::default()];
    for &agent in agents {
        let longer = arrangements.iter().flat_map(|begun| go_on(environment, begun, agent, &mut stream));
        arrangements = longer.collect();
        // Stable: of equal points the earlier one comes first.
        arrangements.sort_by(|a, b| b.points.total_cmp(&a.points));
        arrangements = unlike(environment, arrangements);
    }
    let best_first = by_taste(environment, arrangements, &mut stream);
    Found { best_first, steps: environment.steps() - before }
}

/// The pieces that are placed together, in the order of their priority, large before small.
fn joint_agents(environment: &Environment<'_>) -> Vec<AgentIndex> {
    let is_joint = |&agent: &AgentIndex| {
        environment.class(agent).is_joint
            && environment.agents[agent].state == State::Search
            && !is_locked(environment, agent)
    };
    let mut agents: Vec<AgentIndex> = (0..environment.agents.len()).filter(is_joint).collect();
    // Stable; of equals the order of the programme.
    agents.sort_by(|&a, &b| {
        let (first, second) = (environment.class(a).priority, environment.class(b).priority);
        let area = |agent: AgentIndex| area(environment.agents[agent].size);
        second.cmp(&first).then(area(b).total_cmp(&area(a)))
    });
    agents
}

/// The best arrangements, few of each outline: what comes next may need another.
fn unlike(environment: &Environment<'_>, best_first: Vec<Arrangement>) -> Vec<Arrangement> {
    let mut kept: Vec<(Arrangement, Vec<Outline>)> = Vec::with_capacity(ARRANGEMENTS);
    for arrangement in best_first {
        let outline = outline(environment, &arrangement);
        if kept.iter().filter(|(_, other)| *other == outline).count() < ALIKE && kept.len() < ARRANGEMENTS {
            kept.push((arrangement, outline));
        }
    }
    kept.into_iter().map(|(arrangement, _)| arrangement).collect()
}

/// Moves the points of whole arrangements by taste, those that are one to people alike, and sorts them again.
fn by_taste(
    environment: &Environment<'_>,
    best_first: Vec<Arrangement>,
    stream: &mut Stream,
) -> Vec<Arrangement> {
    let mut tastes: Vec<(Arrangement, f64)> = Vec::new();
    let mut arrangements = best_first;
    for arrangement in &mut arrangements {
        let known = tastes.iter().find(|(other, _)| is_one(environment, other, arrangement));
        let taste = known.map(|(_, taste)| *taste).unwrap_or_else(|| {
            let taste = TASTE * stream.unit();
            tastes.push((arrangement.clone(), taste));
            taste
        });
        arrangement.points += taste;
    }
    // Stable: of equal points the earlier one comes first.
    arrangements.sort_by(|a, b| b.points.total_cmp(&a.points));
    arrangements
}

/// Whether the same pieces stand at the same walls in two arrangements, and each nearly in the same place.
fn is_one(environment: &Environment<'_>, one: &Arrangement, other: &Arrangement) -> bool {
    let pairs = || one.standings.iter().zip(&other.standings);
    one.standings.len() == other.standings.len()
        && pairs().all(|(a, b)| {
            let class = |standing: &Standing| environment.agents[standing.agent].piece.class;
            class(a) == class(b)
                && a.place.parent == b.place.parent
                && a.place.pose.position.distance(b.place.pose.position) < SAME_PLACE
        })
}

/// The best of each outline, the best outline first.
fn kinds<'f>(environment: &Environment<'_>, best_first: &'f [Arrangement]) -> Vec<&'f Arrangement> {
    let mut seen = Vec::new();
    let mut kinds: Vec<&Arrangement> = Vec::new();
    for arrangement in best_first {
        let outline = outline(environment, arrangement);
        if !seen.contains(&outline) {
            seen.push(outline);
            kinds.push(arrangement);
        }
    }
    kinds
}

/// The arrangements that come of one when another piece is placed; without it if there is no place.
fn go_on(
    environment: &mut Environment<'_>,
    begun: &Arrangement,
    agent: AgentIndex,
    stream: &mut Stream,
) -> Vec<Arrangement> {
    stand(environment, begun);
    let mut ways = ways_in_all_sizes(environment, agent, stream);
    // Where none of its places is good, and where all are: the toilet may have no good one beside a tub that has.
    for substitute in joint_substitutes(environment, agent) {
        let mut others = ways_in_all_sizes(environment, substitute, stream);
        others.retain(|way| !way.is_poor);
        others.iter_mut().for_each(|way| way.points -= STAND_IN);
        ways.extend(others);
    }
    if ways.is_empty() {
        ways = places_of_smallest(environment, agent, stream);
    }
    leave(environment, begun);
    if ways.is_empty() {
        let lost = if environment.agents[agent].piece.is_required { MISSED_REQUIRED } else { MISSED };
        return vec![Arrangement { points: begun.points - lost, ..begun.clone() }];
    }
    let with = |way: Way| {
        let standings = begun.standings.iter().cloned().chain([way.standing]).collect();
        Arrangement { standings, points: begun.points + way.points }
    };
    ways.into_iter().map(with).collect()
}

/// Free places in the drawn size, in smaller ones where none of these is good, and in those that fill niches. The agent keeps its
/// size.
fn ways_in_all_sizes(environment: &mut Environment<'_>, agent: AgentIndex, stream: &mut Stream) -> Vec<Way> {
    let drawn = environment.agents[agent].piece.variant;
    let mut ways = places(environment, agent, stream);
    if ways.iter().all(|way| way.is_poor) {
        ways.extend(smaller_places(environment, agent, stream));
    }
    ways.extend(niche_places(environment, agent, stream));
    take_size(environment, agent, drawn);
    ways
}

/// What may stand in for an agent and is placed jointly too, one after the other.
fn joint_substitutes(environment: &Environment<'_>, agent: AgentIndex) -> Vec<AgentIndex> {
    let is_joint = |&other: &AgentIndex| environment.class(other).is_joint;
    wanted::substitutes(environment, agent).filter(is_joint).collect()
}

fn stand(environment: &mut Environment<'_>, arrangement: &Arrangement) {
    for standing in &arrangement.standings {
        take_size(environment, standing.agent, standing.variant);
        environment.settle(standing.agent, &standing.place);
    }
}

/// Undoes [`stand`]: who only stands in for another is not asked for again.
fn leave(environment: &mut Environment<'_>, arrangement: &Arrangement) {
    for &Standing { agent, .. } in arrangement.standings.iter().rev() {
        environment.unsettle(agent);
        if environment.agents[agent].piece.substitute_for.is_some() {
            environment.agents[agent].state = State::Unasked;
        }
    }
}

/// Free places in the smaller sizes, largest first, up to the first with a place that is good.
fn smaller_places(environment: &mut Environment<'_>, agent: AgentIndex, stream: &mut Stream) -> Vec<Way> {
    let drawn = area(environment.agents[agent].size);
    let mut smaller = sizes_by(environment, agent, area);
    smaller.retain(|&variant| area(environment.class(agent).size(variant)) < drawn);
    let mut found = Vec::new();
    for variant in smaller {
        take_size(environment, agent, variant);
        let mut ways = places(environment, agent, stream);
        ways.iter_mut().for_each(|way| way.points -= SMALLER);
        let is_enough = ways.iter().any(|way| !way.is_poor);
        found.extend(ways);
        if is_enough {
            break;
        }
    }
    found
}

/// Free places in the sizes that only fill niches, where one does: the best at each wall, so that there is room in the search for
/// other arrangements.
fn niche_places(environment: &mut Environment<'_>, agent: AgentIndex, stream: &mut Stream) -> Vec<Way> {
    let class = environment.class(agent);
    let in_niches = class.common_variant_count()..class.variant_count();
    let mut found = Vec::new();
    for variant in in_its_look(environment, agent, in_niches) {
        take_size(environment, agent, variant);
        let mut ways = places(environment, agent, stream);
        ways.retain(|way| !way.is_poor && rules::fills_niche(environment, agent, &way.standing.place));
        ways.iter_mut().for_each(|way| way.points += NICHE);
        found.extend(ways);
    }
    // Stable: of equal points the earlier one comes first.
    found.sort_by(|a, b| b.points.total_cmp(&a.points));
    let mut walls = Vec::new();
    found.retain(|way| {
        let is_first = !walls.contains(&way.standing.place.parent);
        walls.push(way.standing.place.parent);
        is_first
    });
    found
}

/// The free places of an agent in its present size, with their points.
fn places(environment: &Environment<'_>, agent: AgentIndex, stream: &mut Stream) -> Vec<Way> {
    places_at(environment, agent, stream, |line, stream| {
        let stretches = free_stretches(environment, line, stream);
        stretches.into_iter().flat_map(|stretch| positions(environment, agent, stretch)).collect()
    })
}

/// The same of all steps along the walls, in the smallest size: in a narrow room the way of a door's leaf may reach into all
/// stretches and leave places in them.
fn places_of_smallest(environment: &mut Environment<'_>, agent: AgentIndex, stream: &mut Stream) -> Vec<Way> {
    let drawn = environment.agents[agent].piece.variant;
    let smallest = sizes_by(environment, agent, area).last().copied().unwrap_or(drawn);
    take_size(environment, agent, smallest);
    let ways = places_at(environment, agent, stream, |line, stream| steps_along(environment, line, stream));
    take_size(environment, agent, drawn);
    ways
}

/// The free places of an agent among those that begin where `from` says, in metres along each wall.
fn places_at(
    environment: &Environment<'_>,
    agent: AgentIndex,
    stream: &mut Stream,
    from: impl Fn(&Line, &mut Stream) -> Vec<f64>,
) -> Vec<Way> {
    let (size, variant) = (environment.agents[agent].size, environment.agents[agent].piece.variant);
    let walls = &environment.brief.surroundings.room.walls;
    let mut found = Vec::new();
    for wall in (0..walls.len()).filter(|&wall| walls[wall].kind == WallKind::Solid) {
        let line = Line { agent, size, wall, before_opening: 0.0 };
        let spots = from(&line, stream).into_iter().map(|from| Spot::standing(wall, from));
        let places = spots.map(|spot| spot.place(environment, agent));
        for place in places.filter(|place| environment.refusal(agent, place).is_none()) {
            let mut way = way(environment, Standing { agent, variant, place });
            way.points += CHANCE * stream.unit();
            found.push(way);
        }
    }
    found
}

/// A free place with its points.
fn way(environment: &Environment<'_>, standing: Standing) -> Way {
    let Score { value, is_spoilt, is_tight } = rules::score(environment, standing.agent, &standing.place);
    let is_out_of_place = rules::is_out_of_place(environment, standing.agent, &standing.place);
    let lost = |is_so: bool, points: f64| if is_so { points } else { 0.0 };
    let lost = lost(is_spoilt, SPOILT) + lost(is_tight, TIGHT) + lost(is_out_of_place, OUT_OF_PLACE);
    Way { standing, points: value - lost, is_poor: is_spoilt || is_tight || is_out_of_place }
}

/// Where in a stretch of wall an agent could begin, in metres from the wall's start: at its ends, and with the space that it
/// needs beside it or the space that is good; in the middle too, unless it goes to the ends.
fn positions(environment: &Environment<'_>, agent: AgentIndex, (from, to): (f64, f64)) -> Vec<f64> {
    let class = environment.class(agent);
    let last = to - environment.agents[agent].size.width;
    let beside =
        class.clearances.iter().filter(|clearance| matches!(clearance.side, Side::Left | Side::Right));
    let wall_rule = class.parents.iter().find(|rule| rule.parent == ParentName::Wall);
    let mut positions = vec![from, last];
    for clearance in beside.take(1) {
        for metres in [clearance.minimum, clearance.good] {
            positions.extend([from + metres, last - metres]);
        }
    }
    if wall_rule.is_none_or(|rule| rule.along != Along::Ends) {
        positions.push(f64::midpoint(from, last));
    }
    positions.retain(|position| (from..=last).contains(position));
    positions
}
