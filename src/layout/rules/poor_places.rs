//! Places that an architect would change though nothing is wrong with them: the audit has no finding of them, and of several
//! arrangements the one with fewer is better.

use crate::catalog::RelationKind;
use crate::layout::agent::Rest;
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, Place};

use super::corner::{corner_points, leaves_rest_of_niche};
use super::swing::clearness;

/// Points of a wish for a corner from which on a piece belongs there: more than one usual wish (weight 1). Smaller: toilets count,
/// which merely like one.
const BELONGS_IN_CORNER: f64 = 2.0;

/// How many required pieces of a room stand where their classes would rather not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PoorPlaces {
    /// Those that are nearer to where the leaves of doors swing than they wish, beds above all.
    pub at_swings: usize,
    /// Tubs, trays and beds for one that belong in a corner and have both sides open, or closed along a part that is worth nothing to
    /// them.
    pub open_sides: usize,
    /// Tubs and trays beside which a strip of a niche is left that nothing fits into.
    pub rests_of_niches: usize,
}

impl PoorPlaces {
    /// Those of the pieces that rest.
    pub(crate) fn of(environment: &Environment<'_>) -> Self {
        let is_required = |&agent: &AgentIndex| environment.agents[agent].piece.is_required;
        let resting = |agent: AgentIndex| Some((agent, environment.agents[agent].rest().map(Rest::place)?));
        let required: Vec<(AgentIndex, Place)> =
            (0..environment.agents.len()).filter(is_required).filter_map(resting).collect();
        let count = |is_poor: fn(&Environment<'_>, AgentIndex, &Place) -> bool| {
            required.iter().filter(|(agent, place)| is_poor(environment, *agent, place)).count()
        };
        Self {
            at_swings: count(is_at_swing),
            open_sides: count(is_open),
            rests_of_niches: count(leaves_rest_of_niche),
        }
    }
}

fn is_at_swing(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    let wishes = environment.class(agent).relations.iter();
    let mut swings = wishes.filter(|wish| wish.kind == RelationKind::ClearOf);
    swings.any(|wish| clearness(environment, agent, place, wish.distance.0) < 1.0)
}

/// Whether an agent belongs in a corner and has both sides open at a place, or leaves a strip of a niche there.
pub(crate) fn is_out_of_place(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    is_open(environment, agent, place) || leaves_rest_of_niche(environment, agent, place)
}

fn is_open(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    environment.class(agent).walls.corner >= BELONGS_IN_CORNER
        && corner_points(environment, agent, place) == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Along, Count, ParentName, ParentRule, Side, Size, Turn, Untidiness};
    use crate::layout::tests::{catalog, level, rule};
    use crate::layout::{Alternative, FurnishOptions, RoomLayout};

    const TRAY: usize = 4;

    /// The poor places of a room whose required tray, 0.8 m wide, stands at the fifth wall.
    fn poor_places(corners: &[(f64, f64)], seed: u64) -> PoorPlaces {
        let mut catalog = catalog(&[(TRAY, Count::Fixed(1))], Untidiness::default());
        catalog.room_types.get_mut("office").unwrap().programme[0].is_required = true;
        let tray = &mut catalog.classes[TRAY];
        tray.sizes = vec![Size { width: 0.8, depth: 0.9, height: 1.0 }; 2];
        tray.niche_sizes = 1;
        let at_wall = rule(ParentName::Wall, &[Side::Back], Turn::Parallel, Along::Ends);
        tray.parents = vec![ParentRule { tag: Some("here".to_owned()), ..at_wall }];
        tray.walls.corner = 3.0;
        let mut level = level(corners);
        level.rooms[0].walls[4].tags.push("here".to_owned());
        let options = FurnishOptions::new(seed, "test");
        RoomLayout::new(level.room(0), &catalog, &options)
            .furnish(&Alternative::default())
            .shortcomings
            .poor_places
    }

    #[test]
    fn a_strip_of_a_niche_is_a_poor_place_and_a_ledge_or_a_way_is_none() {
        let rests = |wide: f64| {
            let niche = [(0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (wide, 3.0), (wide, 5.0), (0.0, 5.0)];
            (0..4).map(|seed| poor_places(&niche, seed).rests_of_niches).collect::<Vec<_>>()
        };
        assert_eq!(rests(1.2), [1; 4]);
        assert_eq!(rests(0.88), [0; 4], "a ledge");
        assert_eq!(rests(2.0), [0; 4], "room to stand");
    }

    #[test]
    fn what_belongs_in_a_corner_and_stands_between_open_sides_has_a_poor_place() {
        // The wall for it meets walls that lean away from it, or upright ones.
        let leaning = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (5.0, 2.0), (4.0, 4.0), (2.0, 4.0), (0.0, 2.0)];
        let upright =
            [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (4.0, 2.0), (4.0, 4.0), (2.0, 4.0), (2.0, 2.0), (0.0, 2.0)];
        for seed in 0..4 {
            assert_eq!(poor_places(&leaning, seed).open_sides, 1, "seed {seed}");
            assert_eq!(poor_places(&upright, seed).open_sides, 0, "seed {seed}");
        }
    }
}
