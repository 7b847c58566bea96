//! Why every object is where it is, and why the others are missing.
//!
//! Wishes are weighed where things stand in the end, not when a place was chosen: who came later moved the
//! figures. What agents met on their search is counted over all their searches of the attempt that was kept.

mod names;
mod story;
mod survey;

use std::cmp::Reverse;

use crate::catalog::{ParentName, Relation, RelationKind};

pub use story::{
    Explanation, MissingStory, ObjectStory, ObstacleStory, ParentStory, Refusal, SearchStory, WallStory, Wish,
};

use super::attempt::{Recording, best_attempt};
use super::brief::Brief;
use super::environment::Environment;
use super::furnished::{Furnished, RemovalReason};
use super::place::{AgentIndex, Place};
use super::rules::{Factor, distance_to_swings, measure, weigh};
use super::trace::Refused;
use super::wanted::is_missed;
use names::{decider, id, obstacle_name, relation_word, target_name};
use survey::survey_walls;

/// Furnishes a room by its brief, and explains what came of it.
pub(super) fn explain(brief: &Brief<'_>) -> (Furnished, Explanation) {
    let kept = best_attempt(brief, Recording::On, explanation);
    (kept.furnished, Explanation { attempts: kept.attempts, kept: kept.number, ..kept.description })
}

/// The explanation of the objects and the missing pieces of an attempt; its number is filled in by the caller.
fn explanation(environment: &Environment<'_>, furnished: &Furnished) -> Explanation {
    let agent_of = |class: usize, number: u32| {
        let is_it = |&agent: &AgentIndex| {
            let piece = &environment.agents[agent].piece;
            (piece.class, piece.number) == (class, number)
        };
        (0..environment.agents.len()).find(is_it)
    };
    let agents = furnished.placements.iter().filter_map(|object| agent_of(object.class, object.number));
    let missed = (0..environment.agents.len()).filter(|&agent| is_missed(environment, agent));
    let missing = missed.zip(&furnished.removals).map(|(agent, removal)| MissingStory {
        id: id(environment, agent),
        reason: removal.reason.name(),
        is_required: removal.is_required,
        search: search_story(environment, agent),
        walls: survey_walls(environment, agent).map(|survey| WallStory {
            places: survey.places,
            refused: refusals(environment, agent, &survey.refused),
        }),
        parents: parents(environment, agent),
    });
    Explanation {
        attempts: 0,
        kept: 0,
        objects: agents.map(|agent| object_story(environment, agent)).collect(),
        missing: missing.collect(),
    }
}

fn object_story(environment: &Environment<'_>, agent: AgentIndex) -> ObjectStory {
    let mut wishes = Vec::new();
    if let Some(rest) = environment.agents[agent].rest() {
        let place = rest.place();
        weigh(environment, agent, &place, |factor, points| match factor {
            Factor::Wish(relation) => wishes.push(wish(environment, agent, &place, relation, points)),
            Factor::BeforeWindow => wishes.push(fault("before a window", points)),
            Factor::Wall => wishes.push(Wish { is_met: points > 0.0, ..fault("its wall", points) }),
            Factor::SuitsWall => wishes.push(Wish { is_met: true, ..fault("its wall suits it", points) }),
            Factor::SeatsInWays => wishes.push(fault("a seat of its own is in a door's way", points)),
            Factor::TakesSeat => wishes.push(fault("takes the place of a seat", points)),
            Factor::Tight { takes, lacks } => {
                let faults = [
                    (takes, "takes of the space that is good for others"),
                    (lacks, "has less space than is good"),
                ];
                // One factor with the points of both: each line shows its share, so that the lines add up to the score.
                let each = points / faults.iter().filter(|(is_so, _)| *is_so).count() as f64;
                let faults = faults.iter().filter(|(is_so, _)| *is_so);
                wishes.extend(faults.map(|(_, about)| fault(about, each)));
            }
        });
    }
    let score = wishes.iter().map(|wish| wish.points).sum();
    ObjectStory { id: id(environment, agent), score, wishes, search: search_story(environment, agent) }
}

/// Something about a place that is no wish; bad unless said otherwise.
fn fault(about: &'static str, points: f64) -> Wish {
    Wish {
        about,
        target: String::new(),
        is_met: false,
        decided_by: None,
        distance: None,
        angle: None,
        weight: 0.0,
        points,
    }
}

fn wish(
    environment: &Environment<'_>,
    agent: AgentIndex,
    place: &Place,
    relation: &Relation,
    points: f64,
) -> Wish {
    let measured = match relation.kind {
        RelationKind::NotBefore | RelationKind::ClearOf => None,
        _ => measure(environment, agent, place, relation),
    };
    let has_direction =
        matches!(relation.kind, RelationKind::Faces | RelationKind::Sees | RelationKind::Opposite);
    Wish {
        about: relation_word(relation.kind),
        target: target_name(environment, &relation.target),
        is_met: match relation.kind {
            // Farther is better without an end: from the lower distance on it is far enough.
            RelationKind::AwayFrom => measured.is_none_or(|found| found.distance >= relation.distance.0),
            _ => points >= relation.weight,
        },
        decided_by: measured.map(|measured| decider(environment, &relation.target, &measured)),
        distance: match relation.kind {
            RelationKind::ClearOf => {
                Some(distance_to_swings(environment, agent, place)).filter(|it| it.is_finite())
            }
            _ => measured.map(|measured| measured.distance),
        },
        angle: measured.filter(|_| has_direction).map(|measured| measured.angle.to_degrees()),
        weight: relation.weight,
        points,
    }
}

fn search_story(environment: &Environment<'_>, agent: AgentIndex) -> SearchStory {
    let Some(trace) = &environment.trace else { return SearchStory::default() };
    let trace = trace.borrow();
    let record = trace.record(agent);
    SearchStory {
        searches: record.searches,
        places: record.places,
        was_sent_away: environment.agents[agent].is_in_the_way,
        was_pushed: record.was_pushed,
        refused: refusals(environment, agent, &record.refused),
    }
}

/// Counts by reason and by what stood in the way, as stories.
fn refusals(environment: &Environment<'_>, agent: AgentIndex, refused: &Refused) -> Vec<Refusal> {
    let stories = |wanted: RemovalReason| {
        let of_reason = refused.obstacles.iter().filter(|((reason, _), _)| *reason == wanted);
        let mut stories: Vec<ObstacleStory> = of_reason
            .map(|((_, obstacle), &places)| ObstacleStory {
                name: obstacle_name(environment, agent, *obstacle),
                places,
            })
            .collect();
        // The most frequent first; of equals by name, whatever the order of the search.
        stories.sort_by(|a, b| b.places.cmp(&a.places).then_with(|| a.name.cmp(&b.name)));
        stories
    };
    let refusal = |(&reason, &places): (&RemovalReason, &u32)| Refusal {
        reason: reason.name(),
        places,
        obstacles: stories(reason),
    };
    let mut refusals: Vec<Refusal> = refused.by_reason.iter().map(refusal).collect();
    refusals.sort_by_key(|refusal| Reverse(refusal.places));
    refusals
}

/// The resting objects that a class names as parents, with the sides that it would take.
fn parents(environment: &Environment<'_>, agent: AgentIndex) -> Vec<ParentStory> {
    let mut stories = Vec::new();
    for rule in &environment.class(agent).parents {
        let ParentName::Classes(classes) = &rule.parent else { continue };
        for parent in environment.resting_of(classes) {
            for &side in &rule.sides {
                let places = environment.class(parent).offer(side).places;
                let taken = environment.agents[parent].taken[side.index()];
                // A side without places is no answer to "why not there": the class offers none.
                if places > 0 {
                    stories.push(ParentStory { id: id(environment, parent), side, taken, places });
                }
            }
        }
    }
    stories
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Count, Untidiness};
    use crate::layout::tests::{WIDE, catalog, level};
    use crate::layout::{Alternative, FurnishOptions, RoomLayout};

    const DESK: usize = 1;
    const SHELF: usize = 4;

    /// Desks, then shelves, in a room of two by two metres at most.
    fn small_room(desks: u32, shelves: u32) -> (Furnished, Explanation) {
        let corners: Vec<(f64, f64)> = WIDE.iter().map(|&(x, y)| (x / 3.0, y / 3.0)).collect();
        let programme = [(DESK, Count::Fixed(desks)), (SHELF, Count::Fixed(shelves))];
        let catalog = catalog(&programme, Untidiness::default());
        let options = FurnishOptions::new(1, "test");
        RoomLayout::new(level(&corners).room(0), &catalog, &options).explain(&Alternative::default())
    }

    #[test]
    fn who_finds_no_place_says_what_stood_there_most() {
        let (furnished, explanation) = small_room(1, 3);
        assert_eq!(explanation.objects.len(), furnished.placements.len());
        assert_eq!(explanation.missing.len(), furnished.removals.len());
        let shelf = explanation.missing.last().expect("the room is too small for all of them");
        let walls = shelf.walls.as_ref().expect("a shelf goes to a wall");
        let refused: u32 = walls.refused.iter().map(|refusal| refusal.places).sum();
        assert!(shelf.id.starts_with("shelf.") && walls.places > 0 && refused == walls.places, "{walls:?}");
        assert!(walls.refused.is_sorted_by(|a, b| a.places >= b.places));
        let known = |name: &str| {
            let objects = explanation.objects.iter().any(|object| name.contains(&object.id));
            objects || name.contains("wall.") || name == "door:1"
        };
        let obstacles = walls.refused.iter().flat_map(|refusal| &refusal.obstacles);
        assert!(obstacles.clone().any(|obstacle| obstacle.name == "door:1"), "{walls:?}");
        assert!(obstacles.clone().all(|obstacle| known(&obstacle.name)), "{walls:?}");
    }

    #[test]
    fn places_are_free_or_refused_and_attempts_are_counted() {
        let (_, alone) = small_room(0, 1);
        assert_eq!((alone.attempts, alone.kept, alone.missing.len()), (1, 1, 0));
        let (_, crowded) = small_room(1, 3);
        assert!(crowded.attempts > 1 && (1..=crowded.attempts).contains(&crowded.kept));
        let stories = crowded.objects.iter().map(|object| &object.search);
        for (story, is_placed) in
            stories.map(|story| (story, 1)).chain(crowded.missing.iter().map(|piece| (&piece.search, 0)))
        {
            let refused: u32 = story.refused.iter().map(|refusal| refusal.places).sum();
            assert!(story.searches > 0 && refused + is_placed <= story.places, "{story:?}");
        }
    }

    #[test]
    fn every_refused_place_has_an_obstacle() {
        for (desks, shelves) in [(1, 3), (2, 2), (3, 1)] {
            let (_, explanation) = small_room(desks, shelves);
            let of_objects = explanation.objects.iter().flat_map(|object| &object.search.refused);
            let of_missing = explanation.missing.iter().flat_map(|piece| &piece.search.refused);
            for refusal in of_objects.chain(of_missing) {
                let named: u32 = refusal.obstacles.iter().map(|obstacle| obstacle.places).sum();
                assert!(named >= refusal.places, "{desks} desks, {shelves} shelves: {refusal:?}");
            }
        }
    }
}
