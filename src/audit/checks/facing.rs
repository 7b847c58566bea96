//! `facing`: a seat turned away from its table or desk, a desk used from its wrong side, a mirror over nothing.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::groups::{MIRROR, SEAT, WORK_SURFACE};
use crate::audit::quantity::Quantity;
use crate::audit::subject::{Body, Subject};
use crate::catalog::{ParentName, Side};
use crate::geometry::Point;

/// Judges seats at tables, desks with seats, and mirrors.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, .. } = *evidence;
    let mut faults = Vec::new();
    let limit = subject.rules().facing.angle;
    for (index, body) in subject.bodies.iter().enumerate() {
        if let Some(table) = subject.table_of(index) {
            let off = off_table(body, &subject.bodies[table]);
            if off > limit {
                let subjects = vec![subject.object(index), subject.object(table)];
                faults.push(Fault::new(Quantity::Angle, subjects, off.to_degrees(), limit.to_degrees()));
            }
        }
        if hangs_over_nothing(subject, body) {
            faults.push(Fault::new(Quantity::Count, vec![subject.object(index)], 0.0, 1.0));
        }
    }
    for (index, _) in subject.bodies.iter().enumerate().filter(|(_, body)| body.is_in(WORK_SURFACE)) {
        if is_used_from_behind(subject, index) {
            faults.push(Fault::new(Quantity::Angle, vec![subject.object(index)], 180.0, limit.to_degrees()));
        }
    }
    faults
}

/// Radians between where a seat faces and its table: straight at the side it stands at, or at the middle, as
/// one sits at a round table.
fn off_table(seat: &Body<'_>, table: &Body<'_>) -> f64 {
    let inward = match seat.placement.side {
        Side::Front => -table.front(),
        Side::Back => table.front(),
        Side::Left => -table.front().perp(),
        _ => table.front().perp(),
    };
    // Either direction will do: the smaller of the two angles is judged.
    let to_middle = (table.placement.position - seat.placement.position).normalize_or(inward);
    [inward, to_middle]
        .map(|towards| seat.front().angle_to(towards).abs())
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// Whether seats stand at a desk, but none at a side that people use.
fn is_used_from_behind(subject: &Subject<'_>, index: usize) -> bool {
    let desk = &subject.bodies[index];
    let used = |side: Side| desk.class.clearances.iter().any(|one| one.side == side && one.allows_children);
    let children = subject.children(index).map(|child| &subject.bodies[child]);
    let mut seats = children.filter(|body| body.is_in(SEAT)).peekable();
    // One seat at a used side is enough: a visitor's chair may stand opposite.
    seats.peek().is_some() && !seats.any(|seat| used(seat.placement.side))
}

/// Whether a mirror whose class may hang over others (a basin) has none of them below it.
fn hangs_over_nothing(subject: &Subject<'_>, mirror: &Body<'_>) -> bool {
    let rules = mirror.class.parents.iter();
    let below: Vec<usize> = rules
        .filter_map(|rule| if let ParentName::Classes(classes) = &rule.parent { Some(classes) } else { None })
        .flatten()
        .copied()
        .collect();
    let is_under = |body: &Body<'_>| {
        let offset: Point = mirror.placement.position - body.placement.position;
        let across = offset.dot(body.front().perp()).abs();
        let forth = offset.dot(body.front()).abs();
        // The mirror hangs on the wall, a little behind the basin's box.
        let reach = mirror.placement.size.depth;
        across <= body.placement.size.width / 2.0 && forth <= body.placement.size.depth / 2.0 + reach
    };
    let nearest = |&class: &usize| subject.nearest_of(class, mirror.placement.position);
    let is_over = |class: &usize| nearest(class).iter().any(|&body| is_under(&subject.bodies[body]));
    let is_over_some = || below.iter().any(is_over);
    mirror.is_in(MIRROR) && !below.is_empty() && !is_over_some()
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::{ParentName, Side};
    use crate::layout::Parent;
    use core::f64::consts::{FRAC_PI_2, PI};

    /// A desk with its front to the south and a stool before it that faces it.
    fn desk_with_stool() -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.group("stool", "seat");
        room.group("desk", "surface");
        room.group("desk", "work_surface");
        let desk = room.stand("desk", at(3.0, 2.375));
        let stool = room.add("stool", at(3.0, 1.7), Parent::Object(desk));
        room.placements[stool].side = Side::Front;
        room.placements[stool].angle = PI;
        room
    }

    #[test]
    fn a_seat_faces_its_table_give_or_take_thirty_degrees() {
        let mut room = desk_with_stool();
        assert_eq!(room.audit(), []);
        room.placements[1].angle = PI + 0.5;
        assert_eq!(room.audit(), []);
        for angle in [PI + 0.6, FRAC_PI_2, 0.0] {
            room.placements[1].angle = angle;
            let findings = room.audit();
            assert_eq!((findings[0].code, findings.len()), (Code::Facing, 1));
            assert_eq!(findings[0].objects, ["desk.1", "stool.1"]);
        }
    }

    #[test]
    fn at_an_end_of_a_side_straight_and_towards_the_middle_are_both_right() {
        let mut room = desk_with_stool();
        room.placements[1].position.x = 2.4;
        assert_eq!(room.audit(), []);
        room.placements[1].angle = PI - 0.7;
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn a_desk_with_its_only_seat_behind_it_is_turned_round() {
        let mut room = desk_with_stool();
        room.placements[1].side = Side::Back;
        room.placements[1].angle = 0.0;
        room.placements[1].position.y = 3.0;
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::Facing, 1));
        assert_eq!(findings[0].objects, ["desk.1"]);
        let stool = room.add("stool", at(3.0, 1.7), Parent::Object(0));
        room.placements[stool].side = Side::Front;
        room.placements[stool].angle = PI;
        assert_eq!(room.audit(), [], "a guest may sit behind it");
    }

    #[test]
    fn a_mirror_that_belongs_over_a_basin_needs_one() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.group("picture", "mirror_glass");
        let mirror = room.add("picture", at(2.0, 0.025), Parent::Wall(0));
        room.placements[mirror].elevation = 1.2;
        assert_eq!(room.audit(), [], "this one may hang anywhere");
        let (picture, chest) =
            (room.catalog.class_index("picture").unwrap(), room.catalog.class_index("chest").unwrap());
        let mut over = room.catalog.classes[picture].parents[0].clone();
        over.parent = ParentName::Classes(vec![chest]);
        room.catalog.classes[picture].parents.push(over);
        assert_eq!(room.count(Code::Facing), 1);
        // The front of the chest is away from the wall.
        let basin = room.stand("chest", at(2.2, 0.5));
        room.placements[basin].angle = PI;
        assert_eq!(room.audit(), []);
        room.placements[basin].position.x = 2.6;
        assert_eq!(room.count(Code::Facing), 1);
    }
}
