//! `window_blocked`: a body before a window that takes its light.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::groups::{LIGHT, MOVABLE, PLANT, SCREEN, SMALL, WINDOW_DRESSING};
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::{Body, Subject};
use crate::audit::zone::{Purpose, Zone};
use crate::geometry::Segment;
use crate::layout::Parent;
use crate::plan::OpeningKind;

/// The strip before every window, from where a body counts as high up to the head.
pub(crate) fn zones(subject: &Subject<'_>) -> Vec<Zone> {
    let rules = subject.rules().windows;
    let zones = subject.at.room.openings.iter().filter_map(|place| {
        let opening = &subject.at.level.openings[place.opening];
        // The higher of both, so that low pieces may stand before windows that go down to the floor.
        let from = (opening.bottom + rules.over_sill).max(rules.low_piece);
        if opening.kind != OpeningKind::Window || from >= opening.top {
            return None;
        }
        let wall = &subject.at.room.walls[place.wall];
        let at = |along: f64, inward: f64| wall.after(along) + wall.normal() * inward;
        let face = Segment::new(at(place.from, 0.0), at(place.to, 0.0));
        Some(Zone {
            purpose: Purpose::Light(place.opening),
            base: vec![face.start, face.end, at(place.to, rules.depth), at(place.from, rules.depth)],
            heights: (from, opening.top),
            face,
        })
    });
    zones.collect()
}

/// Judges the pairs of zone and body that the broad phase found.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, hits, .. } = *evidence;
    let mut faults = Vec::new();
    for &(zone, index) in hits {
        let Purpose::Light(window) = zone.purpose else { continue };
        let body = &subject.bodies[index];
        // A screen before a window is judged as a screen.
        let is_clear = lets_light_through(subject, body) || rises_slimly(subject, zone, body);
        if body.is_in(SCREEN) || is_clear || !is_before(subject, zone, body) {
            continue;
        }
        let subjects = vec![subject.object(index), subject.opening(window)];
        let fault = Fault::new(Quantity::Height, subjects, body.high(), zone.heights.0);
        faults.push(fault.about(vec![zone.base.clone()]));
    }
    faults
}

/// Whether a body stands before a window by more than is tolerated.
pub(crate) fn is_before(subject: &Subject<'_>, zone: &Zone, body: &Body<'_>) -> bool {
    zone.intrusion(subject, body) > subject.rules().clearances.intrusion + ROUNDING
}

/// Curtains, lamps, chairs that one moves away, and slim plants and things.
fn lets_light_through(subject: &Subject<'_>, body: &Body<'_>) -> bool {
    let size = body.placement.size;
    let is_slim = size.width.max(size.depth) < subject.rules().windows.slim_width;
    matches!(body.placement.parent, Parent::Opening(_))
        || body.is_in(WINDOW_DRESSING)
        || body.is_in(LIGHT)
        || body.is_in(MOVABLE)
        || (is_slim && (body.is_in(PLANT) || body.is_in(SMALL)))
}

/// Whether what reaches into the light is slim, whatever stands below: the tap of a sink.
fn rises_slimly(subject: &Subject<'_>, zone: &Zone, body: &Body<'_>) -> bool {
    let rules = &subject.rules().windows;
    let high = body.solids.iter().filter(|solid| solid.high > zone.heights.0 && solid.low < zone.heights.1);
    high.map(|solid| solid.bounds.size().max_element()).fold(0.0, f64::max) < rules.slim_part
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::plan::OpeningKind;

    /// A chest 1.1 m high, its back `gap` metres from a window with its sill at 0.9.
    fn chest_before_window(gap: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.open(0, OpeningKind::Window, (1.5, 3.5), (0.9, 2.2));
        let chest = room.stand("chest", at(2.5, gap + 0.5));
        room.placements[chest].size.height = 1.1;
        room
    }

    #[test]
    fn a_body_over_the_sill_takes_the_light_and_one_as_high_as_the_sill_does_not() {
        let mut room = chest_before_window(0.0);
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::WindowBlocked, 1));
        assert_eq!(findings[0].objects, ["chest.1", "window:0"]);
        room.placements[0].size.height = 0.99;
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn half_a_metre_away_or_beside_the_window_it_may_stand() {
        assert_eq!(chest_before_window(0.48).count(Code::WindowBlocked), 1);
        assert_eq!(chest_before_window(0.51).count(Code::WindowBlocked), 0);
        let mut room = chest_before_window(0.0);
        room.placements[0].position.x = 0.95;
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn low_pieces_may_stand_before_a_window_down_to_the_floor() {
        let mut room = chest_before_window(0.0);
        room.level.openings[0].bottom = 0.1;
        room.placements[0].size.height = 0.85;
        assert_eq!(room.audit(), []);
        room.placements[0].size.height = 0.95;
        assert_eq!(room.count(Code::WindowBlocked), 1);
    }

    #[test]
    fn slim_plants_may_stand_there() {
        let mut room = chest_before_window(0.0);
        room.placements[0].size.width = 0.5;
        room.placements[0].size.depth = 0.5;
        room.placements[0].position.y = 0.25;
        assert_eq!(room.count(Code::WindowBlocked), 1);
        room.group("chest", "greenery");
        assert_eq!(room.count(Code::WindowBlocked), 0);
    }

    #[test]
    fn what_rises_slimly_over_a_low_piece_may_stand_there() {
        use crate::catalog::{Extent, PrismRule, Shape};
        let extent = |share: f64, offset: f64| Extent { share, offset };
        let (none, all) = (extent(0.0, 0.0), extent(1.0, 0.0));
        // A chest 0.9 m high with something on it, in the middle and as high as its box.
        let high = |width: f64| {
            let mut room = chest_before_window(0.0);
            let chest = room.catalog.class_index("chest").unwrap();
            let (from, to) = (extent(0.5, -width / 2.0), extent(0.5, width / 2.0));
            let part = |low, high| PrismRule { low, high, is_disc: false };
            let body = part([none, none, none], [all, all, extent(0.0, 0.9)]);
            let top = part([from, from, extent(0.0, 0.9)], [to, to, all]);
            room.catalog.classes[chest].shape = Shape::Prisms(vec![body, top]);
            room.placements[0].position.y = 0.4;
            room.count(Code::WindowBlocked)
        };
        assert_eq!([high(0.15), high(0.3)], [0, 1]);
    }
}
