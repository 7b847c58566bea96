//! Away from where the leaves of doors swing: people who come in carry things past the open leaf.

use crate::catalog::RelationKind;
use crate::geometry::{Convex, distance_of_convex};
use crate::layout::body::box_solid;
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, Place};

use super::View;

/// 1 where the body is so many metres from where leaves swing, falling to 0 beside them.
pub(super) fn clearness(environment: &Environment<'_>, agent: AgentIndex, place: &Place, least: f64) -> f64 {
    if least > 0.0 { (distance_to_swings(environment, agent, place) / least).min(1.0) } else { 1.0 }
}

/// Metres from a body to the nearest space where a leaf swings; infinite in a room without leaves.
pub(crate) fn distance_to_swings(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> f64 {
    let body = box_solid(environment.agents[agent].size, &place.pose);
    let to_swing = |swing: &Convex| distance_of_convex(body.footprint(), swing.corners());
    environment.brief.surroundings.swings.iter().map(to_swing).fold(f64::INFINITY, f64::min)
}

/// Metres that an agent's class wishes to be away from swings; zero where it does not care.
pub(super) fn wished_distance(view: &View<'_>) -> f64 {
    let wishes = view.class.relations.iter().filter(|wish| wish.kind == RelationKind::ClearOf);
    wishes.map(|wish| wish.distance.0).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use crate::catalog::{Along, Count, ParentName, Relation, RelationKind, Side, Turn, Untidiness};
    use crate::geometry::distance_of_convex;
    use crate::layout::body::{Pose, seat};
    use crate::layout::surroundings::{Surroundings, Swings};
    use crate::layout::tests::{WIDE, catalog, level, rule, run};
    use crate::layout::{Alternative, FurnishOptions, RoomLayout, solids};

    const DESK: usize = 1;
    const SHELF: usize = 4;
    const SQUARE: &[(f64, f64)] = &[(0.0, 0.0), (3.6, 0.0), (3.6, 3.6), (0.0, 3.6)];
    const NARROW: &[(f64, f64)] = &[(0.0, 0.0), (1.6, 0.0), (1.6, 1.7), (0.0, 1.7)];

    /// Metres from the swing of the door to the shelf that wishes to be so far away from it, and whether that counts as too near.
    fn stand(corners: &[(f64, f64)], wished: f64, seed: u64) -> (f64, bool) {
        let mut catalog = catalog(&[(SHELF, Count::Fixed(1))], Untidiness::default());
        catalog.room_types.get_mut("office").unwrap().programme[0].is_required = true;
        catalog.classes[SHELF].relations = vec![Relation {
            kind: RelationKind::ClearOf,
            target: ParentName::Door,
            distance: (wished, 100.0),
            angle: 0.5,
            weight: 1.0,
            is_needed: false,
        }];
        let level = level(corners);
        let swings = Surroundings::new(level.room(0), &catalog.audit, Swings::Simple).swings;
        let options = FurnishOptions::new(seed, "test");
        let room = RoomLayout::new(level.room(0), &catalog, &options).furnish(&Alternative::default());
        let shelf = solids(&catalog.classes[SHELF], &room.furnished.placements[0])[0];
        (
            distance_of_convex(shelf.footprint(), swings[0].corners()),
            room.shortcomings.poor_places.at_swings == 1,
        )
    }

    fn distance(corners: &[(f64, f64)], wished: f64, seed: u64) -> f64 {
        stand(corners, wished, seed).0
    }

    #[test]
    fn what_wishes_to_be_clear_of_doors_keeps_its_distance_from_the_leaf() {
        assert!((0..16).all(|seed| distance(WIDE, 1.5, seed) >= 1.5 - 1e-9));
        assert!((0..16).any(|seed| distance(WIDE, 0.0, seed) < 1.5), "else it is chance");
    }

    #[test]
    fn a_required_desk_has_the_place_of_its_seat_out_of_the_way_of_doors() {
        let in_the_way = |is_required: bool, seed: u64| {
            let mut catalog = catalog(&[(DESK, Count::Fixed(1))], Untidiness::default());
            catalog.room_types.get_mut("office").unwrap().programme[0].is_required = is_required;
            let on_floor = rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random);
            catalog.classes[DESK].parents = vec![on_floor];
            let level = level(SQUARE);
            let surroundings = Surroundings::new(level.room(0), &catalog.audit, Swings::Simple);
            let placed = run(&level, &catalog, seed).placements.remove(0);
            let pose = Pose::new(placed.position, placed.elevation, placed.angle);
            let desk = &catalog.classes[DESK];
            let seat = seat(&desk.clearances[0], placed.size, &pose).unwrap();
            surroundings.kept_free.iter().any(|region| region.solid.overlaps(&seat, 0.01))
        };
        assert!(!(0..64).any(|seed| in_the_way(true, seed)));
        assert!((0..64).any(|seed| in_the_way(false, seed)), "else it is chance");
    }

    #[test]
    fn what_cannot_be_clear_of_doors_stands_nearer() {
        assert!((0..4).all(|seed| distance(NARROW, 3.0, seed) < 3.0));
        assert!((0..4).all(|seed| stand(NARROW, 3.0, seed).1 && !stand(WIDE, 1.5, seed).1));
    }
}
