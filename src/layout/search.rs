//! Searching a parent and arranging at it (section 3.2, states "search" and "arrange").

use crate::catalog::{ParentName, ParentRule, RelationKind, Side, Turn};
use crate::plan::OpeningKind;

use super::body::Pose;
use super::constants::{
    CANDIDATES_BUILT_IN, CANDIDATES_WITH_CLEARANCES, CANDIDATES_WITH_RELATIONS, CONTACT_TOLERANCE,
    STEPS_A_PROPOSAL, TASTE,
};
use super::environment::Environment;
use super::furnished::RemovalReason;
use super::lattice::Slots;
use super::place::{AgentIndex, ParentPart, Place};
use super::rules::{self, Score, View};
use super::seed::{Purpose, RoomKey, Stream};

/// Finds the best place for an agent, or says why there is none.
///
/// The lines of its description are taken in order; within a line, the parents that have fewest children of
/// its class come first. The first place that is free is taken, or, where the agent has wishes, the best of
/// a few, to which the seed adds its taste. A place that makes the room tight, darkens a window, is at a door's swing or
/// takes a seat is kept in hand while the search goes on.
pub(crate) fn search(
    environment: &Environment<'_>,
    agent: AgentIndex,
    key: &RoomKey,
    care: Care,
) -> Result<Found, RemovalReason> {
    environment.note_search(agent);
    let class = environment.class(agent);
    let piece = environment.agents[agent].piece;
    // A second search must not repeat the first one's draws.
    let number = piece.number + (environment.agents[agent].searches << 20);
    // Shifted beyond all numbers of pieces, of which a room has far below a million: no two searches share a stream.
    let mut stream = key.stream(Purpose::Placement, &class.id, number);
    let mut taste = key.stream(Purpose::Taste, &class.id, number);
    let mut failures = Failures::default();
    let mut poses = Vec::new();
    let mut fallback: Option<(f64, Place)> = None;
    // A scan looks at up to `SCAN_POINTS` places: too much for pieces that nobody misses.
    let may_scan = !piece.is_fill && !environment.is_exhausted[piece.class];
    for rule in &class.parents {
        let mut choice = Choice::new(environment, agent, rule);
        let mut parents = parents(environment, agent, rule, &mut stream);
        failures.has_parent |= has_parent(environment, rule);
        while let Some((parent, side)) = take_first(&mut parents) {
            let view =
                View { environment, agent, class, size: environment.agents[agent].size, rule, parent, side };
            poses.clear();
            // What turns to something takes the wall of what it faces: its parents are in that order.
            choice.taste = if rule.orientation.turn == Turn::Facing { 0.0 } else { TASTE * taste.unit() };
            let slots = rules::propose(&view, key, &mut stream, &mut poses);
            choice.consider(&view, &poses, slots, &mut failures);
            if let Some(slots) = slots.filter(|_| choice.left > 0) {
                poses.clear();
                let others = rules::propose_other_slots(&view, key, slots, &mut poses);
                choice.consider(&view, &poses, others, &mut failures);
            }
            if may_scan && choice.best.is_none_or(|(score, _)| score.is_poor()) {
                poses.clear();
                rules::propose_rows(&view, key, &mut poses);
                choice.consider(&view, &poses, None, &mut failures);
            }
            if may_scan && choice.best.is_none_or(|(score, _)| score.is_poor()) {
                poses.clear();
                rules::propose_scan(&view, care == Care::Thorough, &mut stream, &mut poses);
                choice.consider(&view, &poses, None, &mut failures);
            }
            if choice.left == 0 {
                break;
            }
        }
        match choice.best {
            Some((score, place)) if !score.is_poor() => return Ok(Found { place, is_poor: false }),
            // Kept while the further lines of the description may have a good place.
            Some((score, place)) if fallback.is_none_or(|(best, _)| score.value > best) => {
                fallback = Some((score.value, place));
            }
            _ => {}
        }
    }
    let poor = |(_, place)| Found { place, is_poor: true };
    fallback.map(poor).ok_or_else(|| failures.reason())
}

/// How hard an agent looks.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Care {
    /// Where it would like to be, then on a coarse lattice.
    Usual,
    /// At every turn and wall, on a fine lattice.
    Thorough,
}

/// A place that an agent can take.
pub(crate) struct Found {
    /// Where.
    pub(crate) place: Place,
    /// Whether somebody has less room, light or a seat less because of it.
    pub(crate) is_poor: bool,
}

/// The best of the candidates seen so far.
struct Choice {
    best: Option<(Score, Place)>,
    /// Free candidates still to be compared.
    left: usize,
    is_first_best: bool,
    /// Whether the agent is there only where nobody has less room or light for it.
    is_guest: bool,
    /// Points by which the seed likes the parent that is looked at.
    taste: f64,
}

impl Choice {
    fn new(environment: &Environment<'_>, agent: AgentIndex, rule: &ParentRule) -> Self {
        let class = environment.class(agent);
        let left = if environment.is_built_in(agent) && environment.agents[agent].piece.is_required {
            CANDIDATES_BUILT_IN
        } else if class.grid.is_some() && class.needs_company {
            // Rows fill one after the other: who chose a better place of the lattice might stand alone there.
            1
        } else if !class.relations.is_empty() {
            CANDIDATES_WITH_RELATIONS
        } else if class.clearances.is_empty() || class.grid.is_some() {
            1
        } else {
            CANDIDATES_WITH_CLEARANCES
        };
        Self {
            best: None,
            left,
            is_first_best: left == 1,
            is_guest: is_guest(environment, agent, rule),
            taste: 0.0,
        }
    }

    /// Tests poses until enough are free; ties go to the earlier one.
    fn consider(&mut self, view: &View<'_>, poses: &[Pose], slots: Option<Slots>, failures: &mut Failures) {
        for (index, &pose) in poses.iter().enumerate() {
            if self.left == 0 {
                return;
            }
            let place = Place { pose, parent: view.parent, side: view.side };
            if let Some(reason) = refusal(view, &place, slots.map(|slots| slots.slot(index))) {
                failures.count(reason);
                continue;
            }
            let score = if self.is_first_best && !self.is_guest {
                Score { value: 0.0, is_spoilt: false, is_tight: false }
            } else {
                view.environment.count_steps(STEPS_A_PROPOSAL);
                rules::score(view.environment, view.agent, &place)
            };
            if self.is_guest && score.is_poor() {
                failures.count(RemovalReason::Comfort);
                view.environment.note_discomfort(view.agent, &place);
                continue;
            }
            view.environment.note_free(view.agent);
            // Poor places are compared but not counted, so that the search goes on for a good one.
            self.left -= usize::from(!score.is_poor());
            // Of parents that are nearly as good as each other the seed chooses one.
            let score = Score { value: score.value + self.taste, ..score };
            // More points, not as many: of equals the place that was proposed first is taken.
            if self.best.is_none_or(|(best, _)| score.value > best.value) {
                self.best = Some((score, place));
            }
        }
    }
}

/// Why an agent cannot or will not stand at a place; of a slot, by what is known of it where something is.
fn refusal(view: &View<'_>, place: &Place, slot: Option<usize>) -> Option<RemovalReason> {
    let environment = view.environment;
    let Some(slot) = slot else { return environment.refusal(view.agent, place) };
    if let Some(reason) = environment.known_refusal(slot) {
        return Some(reason);
    }
    let before = environment.steps();
    let reason = environment.refusal(view.agent, place)?;
    environment.note_refusal(slot, reason, environment.steps() - before);
    Some(reason)
}

/// Whether a piece is left out rather than let it make the room tight or dark: what the programme does not
/// require, further pieces of a row, and what does not belong to a group.
fn is_guest(environment: &Environment<'_>, agent: AgentIndex, rule: &ParentRule) -> bool {
    let class = environment.class(agent);
    let piece = &environment.agents[agent].piece;
    let is_free = match &rule.parent {
        ParentName::Floor | ParentName::Wall | ParentName::Column | ParentName::Window => true,
        // The next bookcase of a row, which may reach before a window.
        ParentName::Classes(classes) => classes.contains(&piece.class),
        ParentName::Ceiling | ParentName::Door => false,
    };
    let is_one_of_many = class.grid.is_some() && !environment.resting[piece.class].is_empty();
    (!piece.is_required || is_one_of_many) && (is_free || environment.is_built_in(agent))
}

/// Why places were refused, to name the reason that was met most.
#[derive(Default)]
struct Failures {
    has_parent: bool,
    outside: u32,
    collision: u32,
    clearance: u32,
    relation: u32,
    comfort: u32,
}

impl Failures {
    fn count(&mut self, reason: RemovalReason) {
        match reason {
            RemovalReason::Outside => self.outside += 1,
            RemovalReason::Collision => self.collision += 1,
            RemovalReason::Relation => self.relation += 1,
            RemovalReason::Comfort => self.comfort += 1,
            _ => self.clearance += 1,
        }
    }

    fn reason(&self) -> RemovalReason {
        // Of several reasons people are told the one that stood in the way most often; the order below breaks ties.
        let most = self.outside.max(self.collision).max(self.clearance);
        match most.max(self.relation).max(self.comfort) {
            0 if !self.has_parent => RemovalReason::NoParent,
            0 => RemovalReason::NoPlace,
            // Free but for this: nothing else kept it out.
            _ if self.comfort > 0 => RemovalReason::Comfort,
            _ if self.relation > 0 => RemovalReason::Relation,
            _ if most == self.clearance => RemovalReason::Clearance,
            _ if most == self.collision => RemovalReason::Collision,
            _ => RemovalReason::Outside,
        }
    }
}

/// A parent that a rule allows, with its rank: lower is asked first.
struct Possibility {
    parent: ParentPart,
    side: Side,
    rank: f64,
}

/// Takes the parent of lowest rank; found by selection, for most agents need only the first.
fn take_first(options: &mut Vec<Possibility>) -> Option<(ParentPart, Side)> {
    let index = (0..options.len()).min_by(|&a, &b| options[a].rank.total_cmp(&options[b].rank))?;
    let option = options.swap_remove(index);
    Some((option.parent, option.side))
}

/// All parents that a rule allows.
fn parents(
    environment: &Environment<'_>,
    agent: AgentIndex,
    rule: &ParentRule,
    stream: &mut Stream,
) -> Vec<Possibility> {
    let room = environment.brief.surroundings.room;
    let level = environment.brief.surroundings.level;
    let mut options = Vec::new();
    match &rule.parent {
        ParentName::Floor => {
            options.push(Possibility { parent: ParentPart::Floor, side: Side::Above, rank: 0.0 })
        }
        ParentName::Ceiling => {
            options.push(Possibility { parent: ParentPart::Ceiling, side: Side::Below, rank: 0.0 })
        }
        ParentName::Wall => {
            let is_tagged = |tag: &String, tags: &[String]| environment.heeds_tags && tags.contains(tag);
            let has_tag = |tags: &[String]| rule.tag.as_ref().is_none_or(|tag| is_tagged(tag, tags));
            for (index, wall) in room.walls.iter().enumerate() {
                // Draws without replacement, weighted by length (Efraimidis, Spirakis 2006).
                let drawn = -libm::log(stream.unit().max(1e-12)) / wall.length();
                // Draws are zero or more: a wall that holds what the agent faces comes before all of them.
                let rank = if holds_what_it_faces(environment, agent, rule, index) { -1.0 } else { drawn };
                if has_tag(&wall.tags) {
                    options.push(Possibility { parent: ParentPart::Wall(index), side: Side::Front, rank });
                }
            }
        }
        ParentName::Door | ParentName::Window => {
            let is_window = rule.parent == ParentName::Window;
            for (index, side) in room.openings.iter().enumerate() {
                let kind = level.openings[side.opening].kind;
                if (kind == OpeningKind::Window) == is_window {
                    let parent = ParentPart::Opening(index);
                    options.push(Possibility { parent, side: Side::Front, rank: stream.unit() });
                }
            }
        }
        ParentName::Column => {
            for index in 0..room.obstacles.len() {
                for side in [Side::Front, Side::Back, Side::Left, Side::Right] {
                    options.push(Possibility {
                        parent: ParentPart::Column(index),
                        side,
                        rank: stream.unit(),
                    });
                }
            }
        }
        ParentName::Classes(classes) => {
            let class = environment.agents[agent].piece.class;
            for parent in environment.resting_of(classes).filter(|&parent| parent != agent) {
                let children = &environment.agents[parent].children;
                let alike =
                    children.iter().filter(|&&child| environment.agents[child].piece.class == class).count();
                let draw = stream.unit();
                let has_place = |side: &&Side| has_place(environment, agent, parent, **side);
                for (order, &side) in rule.sides.iter().enumerate().filter(|(_, side)| has_place(side)) {
                    // Fewest of its kind first, then by chance, then the sides as listed.
                    let rank = alike as f64 + draw * 0.9 + order as f64 * 1e-6;
                    options.push(Possibility { parent: ParentPart::Agent(parent), side, rank });
                }
            }
        }
    }
    options
}

/// Whether a wall holds what an agent that turns to its wall wants to face: the board behind a teacher's desk. Such
/// a wall comes first.
fn holds_what_it_faces(
    environment: &Environment<'_>,
    agent: AgentIndex,
    rule: &ParentRule,
    wall: usize,
) -> bool {
    let hangs_there = |other: AgentIndex| {
        environment.agents[other].rest().is_some_and(|rest| rest.parent == ParentPart::Wall(wall))
    };
    let mut wishes = environment.class(agent).relations.iter();
    rule.orientation.turn == Turn::Facing
        && wishes.any(|wish| match (&wish.target, wish.kind) {
            (ParentName::Classes(classes), RelationKind::Faces | RelationKind::Sees) => {
                environment.resting_of(classes).any(hangs_there)
            }
            _ => false,
        })
}

/// Whether the room has anything that a rule names, full or not.
fn has_parent(environment: &Environment<'_>, rule: &ParentRule) -> bool {
    match &rule.parent {
        ParentName::Classes(classes) => environment.resting_of(classes).next().is_some(),
        _ => true,
    }
}

/// Whether a parent's side has a place and enough space left.
fn has_place(environment: &Environment<'_>, agent: AgentIndex, parent: AgentIndex, side: Side) -> bool {
    let (holder, offer) = (&environment.agents[parent], environment.class(parent).offer(side));
    if holder.taken[side.index()] >= offer.places {
        return false;
    }
    let size = environment.agents[agent].size;
    let extent = size.width.min(size.depth);
    let space = match (offer.space, side) {
        (Some(space), _) => space,
        (None, Side::Above | Side::Below) => f64::INFINITY,
        (None, Side::Left | Side::Right) => holder.size.depth,
        (None, Side::Front | Side::Back) => holder.size.width,
    };
    // A single child may be longer than the side (a lamp beside a narrow shelf).
    holder.taken[side.index()] == 0 || holder.occupied[side.index()] + extent <= space + CONTACT_TOLERANCE
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::TASTE;
    use crate::catalog::{
        Along, Count, ParentName, ParentRule, Relation, RelationKind, Side, Turn, Untidiness,
    };
    use crate::layout::tests::{WIDE, catalog, level, rule, run};

    #[test]
    fn of_walls_that_are_nearly_as_good_the_seed_chooses_and_of_others_the_better_is_taken() {
        let walls = |points: f64| -> BTreeSet<String> {
            let mut catalog = catalog(&[(4, Count::Fixed(1))], Untidiness::default());
            let shelf = &mut catalog.classes[4];
            shelf.walls.tags = vec![("liked".to_owned(), points)];
            // A wish that all places meet: with it several are compared.
            let near = RelationKind::Near;
            shelf.relations = vec![Relation {
                kind: near,
                target: ParentName::Door,
                distance: (0.0, 99.0),
                angle: 1.0,
                weight: 1.0,
                is_needed: false,
            }];
            let mut level = level(WIDE);
            level.rooms[0].walls[2].tags = vec!["liked".to_owned()];
            let parent = |seed| format!("{:?}", run(&level, &catalog, seed).placements[0].parent);
            (0..24).map(parent).collect()
        };
        assert!(walls(TASTE / 4.0).len() > 1);
        assert_eq!(walls(2.0 * TASTE).len(), 1);
    }

    #[test]
    fn who_turns_to_a_wall_takes_that_of_what_it_faces() {
        let shares_wall = |wishes: bool, seed: u64| {
            let mut catalog = catalog(&[(1, Count::Fixed(1)), (4, Count::Fixed(1))], Untidiness::default());
            catalog.classes[4].priority = 1;
            let desk = &mut catalog.classes[1];
            let at_wall = rule(ParentName::Wall, &[Side::Front], Turn::Facing, Along::Random);
            desk.parents = vec![ParentRule { gap: (1.4, 1.4), ..at_wall }];
            let faces = Relation {
                kind: RelationKind::Faces,
                target: ParentName::Classes(vec![4]),
                distance: (0.0, 9.0),
                angle: 1.5,
                weight: 1.0,
                is_needed: false,
            };
            desk.relations = if wishes { vec![faces] } else { Vec::new() };
            let placements = run(&level(WIDE), &catalog, seed).placements;
            assert_eq!(placements.len(), 2);
            placements[0].parent == placements[1].parent
        };
        assert!((0..8).all(|seed| shares_wall(true, seed)));
        assert!(!(0..8).all(|seed| shares_wall(false, seed)), "else it is chance");
    }
}
