//! Tubs and trays reach from wall to wall, as they are built: once all fixtures have their places, what stands in the corner of
//! a niche takes the size that fills it.

use crate::layout::agent::Rest;
use crate::layout::arrange::{in_its_look, take_size};
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::layout::rules;
use crate::layout::spot::Spot;

/// Widens a resting piece whose class has sizes for niches, where one of its sizes fills the niche that it stands in. A place that
/// was good stays good: nobody has less room because of it.
pub(super) fn fill_niche(environment: &mut Environment<'_>, agent: AgentIndex) {
    let class = environment.class(agent);
    let Some(place) = environment.agents[agent].rest().filter(|_| class.niche_sizes > 0).map(Rest::place)
    else {
        return;
    };
    if rules::fills_niche(environment, agent, &place) {
        return;
    }
    let present = environment.agents[agent].piece.variant;
    environment.unsettle(agent);
    let place = wider_place(environment, agent, &place).unwrap_or_else(|| {
        take_size(environment, agent, present);
        place
    });
    environment.settle(agent, &place);
}

/// The first good place, widest first, at which a wider size keeps one side where it is and fills the niche. The agent has that
/// size then.
fn wider_place(environment: &mut Environment<'_>, agent: AgentIndex, place: &Place) -> Option<Place> {
    let ParentPart::Wall(wall) = place.parent else { return None };
    let (class, size) = (environment.class(agent), environment.agents[agent].size);
    let was_poor = rules::score(environment, agent, place).is_poor();
    let mut wider: Vec<u32> = in_its_look(environment, agent, 0..class.variant_count())
        .filter(|&variant| class.size(variant).width > size.width)
        .collect();
    // Stable: of equal widths and depths the lower variant comes first.
    wider.sort_by(|&a, &b| {
        let (first, second) = (class.size(a), class.size(b));
        let deeper = |depth: f64| (depth - size.depth).abs();
        second.width.total_cmp(&first.width).then(deeper(first.depth).total_cmp(&deeper(second.depth)))
    });
    let line = &environment.brief.surroundings.room.walls[wall];
    let from = (place.pose.position - line.start).dot(line.direction()) - size.width / 2.0;
    wider.into_iter().find_map(|variant| {
        take_size(environment, agent, variant);
        let grown = environment.agents[agent].size.width - size.width;
        [from, from - grown]
            .into_iter()
            .map(|from| Spot::standing(wall, from).place(environment, agent))
            .find(|place| {
                environment.refusal(agent, place).is_none()
                    && rules::fills_niche(environment, agent, place)
                    && (was_poor || !rules::score(environment, agent, place).is_poor())
            })
    })
}
