//! Keeps room for a wheelchair to turn, where the style asks for it: at the place where fewest pieces stand, those that need not
//! stay are taken away, and the place is kept free from then on.

use crate::geometry::{Convex, Point, Solid};

use super::arrange::arrange;
use super::constants::CONTACT_TOLERANCE;
use super::environment::Environment;
use super::locked::is_locked;
use super::movement::send_away;
use super::place::AgentIndex;
use super::seed::RoomKey;
use super::ways::who_is_near;

/// Of so many cells of the floor one is tried: 0.35 m apart in a row, nearer across the rows.
const CELLS_PER_PLACE: usize = 7;

/// Keeps a place to turn. Whether there is none although the empty room has one.
pub(crate) fn lacks_turn(environment: &mut Environment<'_>, key: &RoomKey) -> bool {
    let rules = environment.brief.catalog.audit.access;
    let floors = environment.brief.empty_floors;
    let Some(empty) = floors.wheelchair() else { return false };
    let Some(floor) = floors.wheelchair_among(environment.solids()) else { return false };
    let free = floor.walk(rules.walkway).wide_places(rules.turning).next();
    if let Some(place) = free {
        keep(environment, place);
        return false;
    }
    let walk = empty.walk(rules.walkway);
    let places: Vec<Point> = walk.wide_places(rules.turning).step_by(CELLS_PER_PLACE).collect();
    if places.is_empty() {
        return false;
    }
    let who_goes = |&place: &Point| Some((place, dispensable(environment, place)?));
    // Fewest pieces go; of equals the first place of the grid is kept free.
    let least = places.iter().filter_map(who_goes).min_by_key(|(_, going)| pieces(environment, going));
    let Some((place, going)) = least else { return true };
    keep(environment, place);
    for agent in going {
        send_away(environment, agent);
    }
    arrange(environment, key);
    false
}

/// The agents where a wheelchair would turn; `None` where the room cannot do without one of them.
fn dispensable(environment: &Environment<'_>, place: Point) -> Option<Vec<AgentIndex>> {
    // What touches the edge of the circle may stay.
    let reach = environment.brief.catalog.audit.access.turning / 2.0 - CONTACT_TOLERANCE;
    let going: Vec<AgentIndex> = who_is_near(environment, place, reach).into_keys().collect();
    (!going.iter().any(|&agent| environment.has_required(agent) || is_locked(environment, agent)))
        .then_some(going)
}

/// How many pieces go with some agents.
fn pieces(environment: &Environment<'_>, going: &[AgentIndex]) -> usize {
    going.iter().map(|&agent| 1 + pieces(environment, &environment.agents[agent].children)).sum()
}

fn keep(environment: &mut Environment<'_>, place: Point) {
    let rules = &environment.brief.catalog.audit;
    let disc = Convex::disc(place, Point::splat(rules.access.turning / 2.0), Point::X);
    environment.keep_way(Solid::new(disc, 0.0, rules.walking.body_height));
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::catalog::{Access, Count, DEFAULT_STYLE, Untidiness};
    use crate::layout::Furnished;
    use crate::layout::tests::{catalog, level, run};
    use crate::solve::judge_room;

    /// As many shelves as fit into an office 1.7 m deep, in a style that asks for access or not.
    fn office_with_access(access: Access) -> Furnished {
        let mut catalog = catalog(&[(4, Count::Fixed(9))], Untidiness::default());
        catalog.styles.get_mut(DEFAULT_STYLE).unwrap().access = access;
        // The door and its swing take the west end of the floor.
        let level = level(&[(0.0, 0.0), (3.4, 0.0), (3.4, 1.7), (0.0, 1.7)]);
        run(&level, &catalog, 3)
    }

    #[test]
    fn room_to_turn_stays_where_a_style_asks_for_it() {
        let has_room = |furnished: &Furnished, access: Access| {
            let mut catalog = catalog(&[], Untidiness::default());
            catalog.styles.get_mut(DEFAULT_STYLE).unwrap().access = access;
            let level = level(&[(0.0, 0.0), (3.4, 0.0), (3.4, 1.7), (0.0, 1.7)]);
            let findings = judge_room(level.room(0), furnished, &catalog).findings;
            !findings.iter().any(|finding| finding.code == Code::NoTurningCircle)
        };
        let (usual, wide) = (office_with_access(Access::Walking), office_with_access(Access::Wheelchair));
        assert!(!has_room(&usual, Access::Wheelchair), "nobody asked");
        assert!(has_room(&wide, Access::Wheelchair));
        assert!(!wide.placements.is_empty() && wide.placements.len() < usual.placements.len());
    }
}
