//! `facing`: a seat turned away from its table or desk, a sofa that looks past the screen, a desk used from its wrong side, a mirror
//! over nothing.

use super::screens::eyes;
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::groups::{MIRROR, SCREEN, SEAT, WORK_SURFACE};
use crate::audit::near::NearPoints;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::{Body, Subject};
use crate::catalog::{ParentName, Side};
use crate::geometry::Point;

/// The group of what people watch a screen from: sofas and beds.
const VIEWING: &str = "viewing";
/// The group of sofas and armchairs.
const SOFT_SEAT: &str = "soft_seat";

/// Judges seats at tables, sofas before screens, desks with seats, and mirrors.
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
    faults.extend(sofa_past_screen(subject));
    faults
}

/// The widest sofa of a room, where it looks past the screens and nobody watches one from bed instead.
fn sofa_past_screen(subject: &Subject<'_>) -> Option<Fault> {
    let limit = subject.rules().facing.angle;
    let place = |screen: usize| subject.bodies[screen].placement.position;
    let screens = subject.bodies.iter().enumerate().filter(|(_, body)| body.is_in(SCREEN));
    let screens = NearPoints::new(screens.map(|(index, body)| (index, body.placement.position)));
    let off_screen = |watcher: &Body<'_>| {
        let near = screens.nearest(watcher.placement.position);
        let off = near.iter().map(|&screen| (off_view(watcher, place(screen)), screen));
        // Of equal angles the earlier screen.
        off.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
    };
    let watchers = || subject.bodies.iter().enumerate().filter(|(_, body)| body.is_in(VIEWING));
    let (beds, sofas) = (
        watchers().filter(|(_, body)| !body.is_in(SOFT_SEAT)),
        watchers().filter(|(_, body)| body.is_in(SOFT_SEAT)),
    );
    let width = |body: &Body<'_>| body.placement.size.width;
    // Of equal widths the earlier sofa.
    let (sofa, body) = sofas.reduce(|a, b| if width(b.1) > width(a.1) { b } else { a })?;
    let (off, screen) = off_screen(body)?;
    let is_watched = |bed: &Body<'_>| off_screen(bed).is_some_and(|(off, _)| off <= limit);
    if off <= limit + ROUNDING || beds.map(|(_, bed)| bed).any(is_watched) {
        return None;
    }
    let subjects = vec![subject.object(sofa), subject.object(screen)];
    Some(Fault::new(Quantity::Angle, subjects, off.to_degrees(), limit.to_degrees()))
}

/// Radians between where somebody looks straight ahead and a point, from the best place to sit or lie.
fn off_view(watcher: &Body<'_>, point: Point) -> f64 {
    let off = |eye: Point| watcher.front().angle_to(point - eye).abs();
    eyes(watcher).into_iter().map(off).fold(f64::INFINITY, f64::min)
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

    /// A screen on the north wall, and a chest as a sofa of 1 m, so far aside from its axis, that faces north.
    fn sofa_before_screen(aside: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(8.0, 4.0);
        room.group("picture", "screen");
        ["seat", "soft_seat", "viewing"].into_iter().for_each(|group| room.group("chest", group));
        let screen = room.add("picture", at(3.0, 3.975), Parent::Wall(2));
        room.placements[screen].elevation = 1.0;
        let sofa = room.stand("chest", at(3.0 + aside, 1.975));
        room.placements[sofa].angle = PI;
        room
    }

    #[test]
    fn a_sofa_looks_at_a_screen_give_or_take_thirty_degrees() {
        for (aside, count) in [(0.0, 0), (1.4, 0), (1.6, 1)] {
            assert_eq!(sofa_before_screen(aside).count(Code::Facing), count, "{aside} m aside");
        }
        let mut room = sofa_before_screen(0.0);
        room.placements[1].angle = FRAC_PI_2;
        let findings: Vec<_> = room.audit().into_iter().filter(|one| one.code == Code::Facing).collect();
        assert_eq!(findings[0].objects, ["chest.1", "picture.1"]);
        // A wider one that looks at it is the one that counts.
        let other = room.stand("chest", at(4.4, 1.975));
        room.placements[other].angle = PI;
        room.placements[other].size.width = 1.2;
        assert_eq!(room.count(Code::Facing), 0);
    }

    #[test]
    fn a_sofa_may_look_elsewhere_where_the_screen_is_watched_from_bed() {
        let mut room = sofa_before_screen(3.0);
        assert_eq!(room.count(Code::Facing), 1);
        room.group("table", "viewing");
        let bed = room.stand("table", at(3.0, 2.0));
        room.placements[bed].angle = PI;
        assert_eq!(room.count(Code::Facing), 0);
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
