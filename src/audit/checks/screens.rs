//! `tv_position`: a screen that nobody sees from a seat or bed, or one before a window.

use super::windows::is_before;
use crate::audit::convex::clip_segment;
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::groups::{BED, SCREEN, SEAT, SLEEPING};
use crate::audit::near::NearPoints;
use crate::audit::quantity::Quantity;
use crate::audit::subject::{Body, Subject};
use crate::audit::upright_box::UprightBox;
use crate::audit::zone::Purpose;
use crate::geometry::{Point, Segment};

/// Metres from the back of a bed to the eyes of somebody who watches from it.
const EYES_IN_BED: f64 = 0.5;

/// Judges every screen.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, hits, .. } = *evidence;
    let mut faults = Vec::new();
    let viewers = subject.bodies.iter().enumerate().filter(|(_, body)| is_viewer(body));
    let viewers = NearPoints::new(viewers.map(|(index, body)| (index, body.placement.position)));
    for (index, screen) in subject.bodies.iter().enumerate().filter(|(_, body)| body.is_in(SCREEN)) {
        let (position, diagonal) = (screen.placement.position, diagonal(screen));
        let sees = |&viewer: &usize| sees(subject, viewer, index);
        if !viewers.nearest(position).iter().any(sees) {
            let place = |viewer: usize| subject.bodies[viewer].placement.position;
            // Without any seat the screen is infinitely far away, for which JSON has no number.
            let nearest = viewers.distance(position, place).map_or(0.0, |distance| distance / diagonal);
            let farthest = subject.rules().screens.farthest;
            let subjects = vec![subject.object(index)];
            faults.push(Fault::new(Quantity::ScreenDistance, subjects, nearest, farthest));
        }
    }
    for &(zone, index) in hits {
        let Purpose::Light(window) = zone.purpose else { continue };
        let screen = &subject.bodies[index];
        if screen.is_in(SCREEN) && is_before(subject, zone, screen) {
            let subjects = vec![subject.object(index), subject.opening(window)];
            let (depth, rule) = (zone.free_depth(screen), subject.rules().windows.depth);
            let fault = Fault::new(Quantity::FreeDepth, subjects, depth, rule);
            faults.push(fault.about(vec![zone.base.clone()]));
        }
    }
    faults
}

fn is_viewer(body: &Body<'_>) -> bool {
    body.is_in(SEAT) || body.is_in(BED) || body.is_in(SLEEPING)
}

/// Metres from corner to corner.
fn diagonal(screen: &Body<'_>) -> f64 {
    libm::hypot(screen.placement.size.width, screen.placement.size.height)
}

/// Whether somebody in some place of a viewer sees the screen: near its axis, at a good distance, not turned
/// away, nothing between.
fn sees(subject: &Subject<'_>, viewer: usize, screen: usize) -> bool {
    let (body, target) = (&subject.bodies[viewer], &subject.bodies[screen]);
    let rules = subject.rules().screens;
    let diagonal = diagonal(target);
    eyes(body).into_iter().any(|eye| {
        let sight = eye - target.placement.position;
        let distance = sight.length() / diagonal;
        let is_near_axis = sight.angle_to(target.front()).abs() <= rules.angle;
        // Within a quarter of a turn to either side: people turn their heads.
        let is_turned_to = body.front().dot(-sight) > 0.0;
        (rules.nearest..=rules.farthest).contains(&distance)
            && is_near_axis
            && is_turned_to
            && !is_hidden(subject, viewer, eye, screen)
    })
}

/// Where the eyes of those who sit or lie there may be: in the middle and towards both ends.
pub(super) fn eyes(body: &Body<'_>) -> [Point; 3] {
    let size = body.placement.size;
    let is_bed = body.is_in(BED) || body.is_in(SLEEPING);
    let back = if is_bed && !body.is_in(SEAT) { (size.depth / 2.0 - EYES_IN_BED).max(0.0) } else { 0.0 };
    [0.0, -size.width / 3.0, size.width / 3.0].map(|along| body.place(Point::new(along, back)))
}

/// Whether a third body stands in the line of sight.
fn is_hidden(subject: &Subject<'_>, viewer: usize, eye: Point, screen: usize) -> bool {
    let rules = subject.rules().screens;
    let sight = Segment::new(eye, subject.bodies[screen].placement.position);
    let is_part = |body: usize| {
        // What carries the screen or lies on the seat is no third body.
        [viewer, screen]
            .iter()
            .any(|&end| subject.descends_from(body, end) || subject.descends_from(end, body))
    };
    let ends = |height: f64| UprightBox { low: eye.extend(height), high: eye.extend(height) };
    let ends = ends(rules.sight_low).union(ends(rules.sight_high));
    let far = sight.end.extend(rules.sight_low);
    let around = ends.union(UprightBox { low: far, high: far });
    let third = subject.near_boxes().touching(&around).filter(|&body| !is_part(body));
    let mut solids = third.flat_map(|body| &subject.bodies[body].solids);
    solids.any(|solid| {
        solid.high > rules.sight_low
            && solid.low < rules.sight_high
            && clip_segment(solid.footprint(), sight, 0.0).is_some()
    })
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::layout::Parent;
    use crate::plan::OpeningKind;
    use core::f64::consts::{FRAC_PI_2, PI};

    /// A screen of 0.6 × 0.5 m on the north wall, facing south, and a stool before it that faces north.
    fn watched_from(distance: f64, aside: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.group("picture", "screen");
        room.group("stool", "seat");
        let screen = room.add("picture", at(3.0, 4.975), Parent::Wall(2));
        room.placements[screen].elevation = 1.0;
        let stool = room.stand("stool", at(3.0 + aside, 4.975 - distance));
        room.placements[stool].angle = PI;
        room
    }

    #[test]
    fn it_is_watched_from_one_to_three_diagonals_before_it() {
        assert_eq!(watched_from(1.8, 0.0).audit(), []);
        for distance in [0.8, 3.2] {
            let findings = watched_from(distance, 0.0).audit();
            assert_eq!((findings[0].code, findings.len()), (Code::TvPosition, 1));
            assert_eq!(findings[0].objects, ["picture.1"]);
        }
    }

    #[test]
    fn it_is_not_watched_from_aside_or_with_the_back_to_it() {
        assert_eq!(watched_from(1.8, 0.9).count(Code::TvPosition), 0);
        assert_eq!(watched_from(1.8, 1.3).count(Code::TvPosition), 1);
        let mut room = watched_from(1.8, 0.0);
        room.placements[1].angle = 0.0;
        assert_eq!(room.count(Code::TvPosition), 1);
        room.placements[1].angle = FRAC_PI_2 + 0.1;
        assert_eq!(room.count(Code::TvPosition), 0);
    }

    #[test]
    fn a_tall_body_between_hides_it_and_a_low_one_does_not() {
        let mut room = watched_from(1.9, 0.0);
        let chest = room.stand("chest", at(3.0, 4.1));
        room.placements[chest].size.depth = 0.4;
        assert_eq!(room.count(Code::TvPosition), 0);
        room.placements[chest].size.height = 1.2;
        assert_eq!(room.count(Code::TvPosition), 1);
    }

    #[test]
    fn it_does_not_hang_before_a_window() {
        let mut room = watched_from(1.8, 0.0);
        room.open(2, OpeningKind::Window, (2.0, 3.0), (0.9, 2.2));
        room.placements[0].position.y = 4.8;
        let findings: Vec<_> = room.audit().into_iter().filter(|one| one.code == Code::TvPosition).collect();
        assert_eq!(findings[0].objects, ["picture.1", "window:0"]);
        assert_eq!(room.count(Code::WindowBlocked), 0, "one fault, one finding");
        room.placements[0].position.x = 5.0;
        room.placements[1].position.x = 5.0;
        assert_eq!(room.count(Code::TvPosition), 0);
    }
}
