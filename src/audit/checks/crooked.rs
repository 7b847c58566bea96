//! `crooked`: wall furniture that is not parallel to its wall in a tidy style.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::{Body, Subject};
use crate::catalog::{ParentName, Shape, Turn};
use crate::geometry::{Point, direction};
use crate::layout::Parent;

/// Judges what stands at walls or hangs on them.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, .. } = *evidence;
    let mut faults = Vec::new();
    let limit = subject.rules().alignment.angle;
    if !is_tidy(subject, limit) {
        return faults;
    }
    let straight = |(_, body): &(usize, &Body<'_>)| stands_straight(body, limit);
    for (index, body) in subject.bodies.iter().enumerate().filter(straight) {
        let Parent::Wall(wall) = body.placement.parent else { continue };
        let off = angle_off(body, subject.at.room.walls[wall].direction());
        if off > limit + ROUNDING {
            let subjects = vec![subject.object(index), Subject::wall(wall)];
            faults.push(Fault::new(Quantity::Angle, subjects, off.to_degrees(), limit.to_degrees()));
        }
    }
    faults
}

/// A style whose untidiness turns nothing further than furniture may stand crooked.
fn is_tidy(subject: &Subject<'_>, limit: f64) -> bool {
    subject.style().untidiness.turn <= limit
}

/// Whether a class wants to stand straight at its wall; plants and round things do not.
pub(crate) fn stands_straight(body: &Body<'_>, limit: f64) -> bool {
    let at_wall = body.class.parents.iter().filter(|rule| rule.parent == ParentName::Wall);
    let mut orientations = at_wall.map(|rule| rule.orientation);
    let is_free = orientations.any(|orientation| orientation.turn == Turn::Any || orientation.jitter > limit);
    !is_free && body.class.shape != Shape::Disc
}

/// Radians between a body's sides and a direction, at most an eighth of a turn.
pub(crate) fn angle_off(body: &Body<'_>, along: Point) -> f64 {
    let right = direction(body.placement.angle);
    let (cosine, sine) = (right.dot(along).abs(), right.perp_dot(along).abs());
    libm::atan2(cosine.min(sine), cosine.max(sine))
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::Turn;
    use crate::layout::Parent;

    /// A chest before the south wall, turned by some degrees.
    fn turned(degrees: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(3.0, 3.0);
        let chest = room.add("chest", at(1.5, 0.7), Parent::Wall(0));
        room.placements[chest].angle = degrees.to_radians();
        room
    }

    #[test]
    fn five_degrees_are_straight_and_six_are_crooked() {
        for straight in [0.0, 4.9, 85.1, 180.0, 270.0] {
            assert_eq!(turned(straight).count(Code::Crooked), 0, "{straight}");
        }
        for crooked in [6.0, -20.0, 45.0, 84.0, 130.0] {
            assert_eq!(turned(crooked).count(Code::Crooked), 1, "{crooked}");
        }
        let findings = turned(6.0).audit();
        assert_eq!(findings[0].objects, ["chest.1", "wall.0"]);
        assert!((findings[0].measured - 6.0).abs() < 1e-9);
    }

    #[test]
    fn an_untidy_style_and_a_class_that_turns_freely_may_be_crooked() {
        let mut room = turned(12.0);
        room.catalog.styles.get_mut("default").unwrap().untidiness.turn = 0.3;
        assert_eq!(room.count(Code::Crooked), 0);
        let mut room = turned(12.0);
        let chest = room.catalog.class_index("chest").unwrap();
        let mut rule = room.catalog.classes[chest].parents[0].clone();
        (rule.parent, rule.orientation.turn) = (crate::catalog::ParentName::Wall, Turn::Any);
        room.catalog.classes[chest].parents.push(rule);
        assert_eq!(room.count(Code::Crooked), 0);
    }
}
