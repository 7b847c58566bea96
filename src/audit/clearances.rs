//! `blocked_use`: a body, a column or a wall in the space that people need before a side.

use std::collections::BTreeMap;

use crate::catalog::{Clearance, Side};
use crate::geometry::{Point, direction};
use crate::layout::Parent;
use crate::plan::OpeningKind;

use super::convex::clip_segment;
use super::finding::{Code, Finding};
use super::subject::{Body, Subject};
use super::thresholds::ROUNDING;
use super::zone::{NearPair, Purpose, Zone};

/// The smallest clearances of all bodies, and the good ones where they are deeper.
pub(crate) fn zones(subject: &Subject<'_>) -> Vec<Zone> {
    let mut zones = Vec::new();
    for (owner, body) in subject.bodies.iter().enumerate() {
        for (number, clearance) in body.class.clearances.iter().enumerate() {
            if clearance.minimum > 0.0 {
                zones.push(zone(body, clearance, clearance.minimum, Purpose::Using(owner, number)));
            }
            if clearance.good > clearance.minimum + ROUNDING {
                zones.push(zone(body, clearance, clearance.good, Purpose::Comfort(owner, number)));
            }
        }
    }
    zones
}

/// The region before a side, `depth` metres deep.
pub(crate) fn zone(body: &Body<'_>, clearance: &Clearance, depth: f64, purpose: Purpose) -> Zone {
    let placement = body.placement;
    let (half_width, half_depth) = (placement.size.width / 2.0, placement.size.depth / 2.0);
    // Out of the side, and how far the side lies from the middle and reaches left and right of it.
    let (out, reach, half) = match clearance.side {
        Side::Front => (Point::NEG_Y, half_depth, half_width),
        Side::Back => (Point::Y, half_depth, half_width),
        Side::Left => (Point::NEG_X, half_width, half_depth),
        Side::Right => (Point::X, half_width, half_depth),
        Side::Above | Side::Below => unreachable!("the catalogue allows clearances at upright sides only"),
    };
    let turn = direction(placement.angle);
    let place = |out_by: f64, along_by: f64| {
        placement.position + turn.rotate(out * (reach + out_by) + out.perp() * along_by)
    };
    let half = half + clearance.margin;
    Zone {
        purpose,
        base: vec![place(0.0, -half), place(depth, -half), place(depth, half), place(0.0, half)],
        heights: (placement.elevation, placement.elevation + clearance.height),
        face: (place(0.0, -half), place(0.0, half)),
    }
}

/// Judges the pairs of zone and body that the broad phase found, then the walls and columns; an object and
/// what blocks it make one finding.
pub(crate) fn judge(
    subject: &Subject<'_>,
    zones: &[Zone],
    hits: &[NearPair<'_>],
    findings: &mut Vec<Finding>,
) {
    let takings = takings(subject, zones, hits, |purpose| match purpose {
        Purpose::Using(owner, number) => Some((owner, number)),
        _ => None,
    });
    findings.extend(narrowest(&takings).into_values().map(|taking| {
        let owner = &subject.bodies[taking.owner];
        let minimum = owner.class.clearances[taking.number].minimum;
        Finding::new(Code::BlockedUse, vec![owner.id.clone(), taking.blocker.clone()], taking.free, minimum)
    }));
}

/// Something in a clearance that should not be there.
pub(crate) struct Taking {
    /// Whose clearance it is, by index.
    pub(crate) owner: usize,
    /// Which of the clearances of its class.
    pub(crate) number: usize,
    /// The id of what takes it.
    pub(crate) blocker: String,
    /// Metres that are left of it.
    pub(crate) free: f64,
}

/// For each object and what takes its clearances, the narrowest that is left.
pub(crate) fn narrowest(takings: &[Taking]) -> BTreeMap<(usize, &str), &Taking> {
    let mut narrowest: BTreeMap<(usize, &str), &Taking> = BTreeMap::new();
    for taking in takings {
        let known = narrowest.entry((taking.owner, &taking.blocker)).or_insert(taking);
        if taking.free < known.free {
            *known = taking;
        }
    }
    narrowest
}

/// What takes the clearances of some purpose; `select` tells their object and number.
pub(crate) fn takings(
    subject: &Subject<'_>,
    zones: &[Zone],
    hits: &[NearPair<'_>],
    select: impl Fn(Purpose) -> Option<(usize, usize)>,
) -> Vec<Taking> {
    let limit = subject.rules().clearances.intrusion + ROUNDING;
    let mut takings = Vec::new();
    for &(zone, body) in hits {
        let Some((owner, number)) = select(zone.purpose) else { continue };
        let other = &subject.bodies[body];
        if !is_welcome(subject, (owner, number), body)
            && !is_flat(subject, other)
            && zone.intrusion(subject, other) > limit
        {
            takings.push(Taking { owner, number, blocker: other.id.clone(), free: zone.free_depth(other) });
        }
    }
    for zone in zones {
        if let Some((owner, number)) = select(zone.purpose) {
            takings.extend(fixed_edges(subject, zone).into_iter().map(|(blocker, edge)| Taking {
                owner,
                number,
                blocker,
                free: zone.free_depth_to(edge),
            }));
        }
    }
    takings
}

/// Whether a body may be in a clearance: it belongs to its object, and the side takes children or it lies
/// below in the hierarchy.
fn is_welcome(subject: &Subject<'_>, (owner, number): (usize, usize), body: usize) -> bool {
    let clearance = &subject.bodies[owner].class.clearances[number];
    is_relative(subject, owner, clearance.side, body) && (clearance.allows_children || body <= owner)
}

/// Whether a body belongs to the owner of a clearance: the owner itself, what it stands at, what stands on or
/// under it, a child at that side, or what rests on one of these (the cushion on the chair).
fn is_relative(subject: &Subject<'_>, owner: usize, side: Side, body: usize) -> bool {
    let is_welcome_child = |object: usize| {
        let placement = subject.bodies[object].placement;
        let is_out_of_the_way = matches!(placement.side, Side::Above | Side::Below);
        placement.parent == Parent::Object(owner) && (is_out_of_the_way || placement.side == side)
    };
    subject.descends_from(owner, body)
        || subject.ancestors(body).take_while(|&object| object > owner).any(is_welcome_child)
}

/// Whether something hangs flat on a wall, where nobody walks into it.
fn is_flat(subject: &Subject<'_>, body: &Body<'_>) -> bool {
    let rules = subject.rules().clearances;
    matches!(body.placement.parent, Parent::Wall(_) | Parent::Opening(_))
        && body.placement.size.depth <= rules.flat_depth
        && body.low() >= rules.flat_elevation
}

/// The edges of walls and columns inside a zone, with the names of their parts. Where the wall is open, a
/// zone may reach into the next room.
fn fixed_edges(subject: &Subject<'_>, zone: &Zone) -> Vec<(String, (Point, Point))> {
    let room = subject.room;
    let margin = subject.rules().clearances.intrusion + ROUNDING;
    let inside = |edge: (Point, Point)| clip_segment(&zone.base, edge, margin);
    let walls = room.region.borders().enumerate().filter_map(|(number, border)| {
        let segment = inside(border)?;
        (!is_open(subject, number, segment)).then(|| (format!("wall.{number}"), segment))
    });
    let tall = room.obstacles.iter().enumerate().filter(|(_, column)| column.height > zone.heights.0);
    let columns = tall.flat_map(|(number, column)| {
        column.outline.edges().filter_map(inside).map(move |segment| (format!("column.{number}"), segment))
    });
    walls.chain(columns).collect()
}

/// Whether a stretch of a wall lies in an opening that nothing closes.
fn is_open(subject: &Subject<'_>, wall: usize, (start, end): (Point, Point)) -> bool {
    let face = &subject.room.walls[wall];
    let along = |point: Point| (point - face.start).dot(face.direction());
    let (from, to) = (along(start).min(along(end)), along(start).max(along(end)));
    subject.room.openings.iter().filter(|place| place.wall == wall).any(|place| {
        let kind = subject.level.openings[place.opening].kind;
        let is_free = matches!(kind, OpeningKind::OpenBoundary | OpeningKind::Passage);
        is_free && place.from - ROUNDING <= from && to <= place.to + ROUNDING
    })
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::Side;
    use crate::geometry::Polygon;
    use crate::layout::Parent;
    use crate::plan::{Obstacle, OpeningKind};

    /// A desk (1.5 × 0.75, front clearance 0.75 that lets its chair in) with its front at y = 2.
    fn desk_room() -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.stand("desk", at(3.0, 2.375));
        room
    }

    #[test]
    fn a_body_before_the_desk_blocks_it() {
        let mut room = desk_room();
        let chest = room.stand("chest", at(3.0, 0.75));
        assert_eq!(room.count(Code::BlockedUse), 0, "its edge is at 1.25, where the clearance ends");
        room.placements[chest].position.y = 0.85;
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::BlockedUse, 1));
        assert_eq!(findings[0].objects, ["chest.1", "desk.1"]);
        assert!((findings[0].measured - 0.65).abs() < 1e-9);
        assert!((findings[0].threshold - 0.75).abs() < 1e-9);
    }

    #[test]
    fn its_own_chair_may_stand_there_and_what_lies_on_it_and_nobody_elses() {
        let mut room = desk_room();
        let chair = room.add("stool", at(3.0, 1.7), Parent::Object(0));
        room.placements[chair].side = Side::Front;
        let cushion = room.add("lamp", at(3.0, 1.7), Parent::Object(chair));
        room.placements[cushion].elevation = 0.45;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[chair].parent = Parent::Floor;
        room.placements[chair].side = Side::Above;
        assert_eq!(room.count(Code::BlockedUse), 2);
    }

    #[test]
    fn the_front_turns_with_the_desk() {
        let mut room = desk_room();
        room.stand("chest", at(3.0, 0.85));
        room.placements[0].angle = core::f64::consts::PI;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[0].angle = -core::f64::consts::FRAC_PI_2;
        room.placements[1].position = at(1.6, 2.4);
        assert_eq!(room.count(Code::BlockedUse), 1, "turned clockwise the front faces west");
        room.placements[1].position = at(4.4, 2.4);
        assert_eq!(room.count(Code::BlockedUse), 0);
    }

    #[test]
    fn a_lamp_above_the_clearance_takes_nothing() {
        let mut room = desk_room();
        let lamp = room.add("lamp", at(3.0, 1.7), Parent::Ceiling);
        room.placements[lamp].elevation = 2.2;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[lamp].elevation = 1.5;
        assert_eq!(room.count(Code::BlockedUse), 1);
    }

    #[test]
    fn a_wall_or_a_column_before_the_desk_blocks_it_and_an_opening_does_not() {
        let mut room = desk_room();
        room.placements[0].position.y = 0.375 + 0.74;
        assert_eq!(room.count(Code::BlockedUse), 0, "a centimetre is tolerated");
        room.placements[0].position.y = 0.375 + 0.7;
        let findings = room.audit();
        assert_eq!(findings[0].objects, ["desk.1", "wall.0"]);
        assert!((findings[0].measured - 0.7).abs() < 1e-9);
        room.open(0, OpeningKind::OpenBoundary, (1.0, 5.0), (0.0, 2.5));
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[0].position.y = 2.375;
        let outline = Polygon::rectangle(at(3.0, 1.5), at(0.2, 0.2));
        room.level.rooms[0].obstacles.push(Obstacle { outline, height: 2.5 });
        assert_eq!(room.audit()[0].objects, ["column.0", "desk.1"]);
    }

    #[test]
    fn a_picture_on_the_wall_is_in_nobodys_way_and_a_cabinet_is() {
        let mut room = desk_room();
        room.placements[0].position.y = 0.375 + 0.76;
        let picture = room.add("picture", at(3.0, 0.025), Parent::Wall(0));
        room.placements[picture].elevation = 1.2;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[picture].size.depth = 0.2;
        room.placements[picture].position.y = 0.1;
        assert_eq!(room.count(Code::BlockedUse), 1);
    }
}
