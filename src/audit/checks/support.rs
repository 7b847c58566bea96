//! `floating` and `unsupported`: contact with what a body stands on, hangs on or hangs from.

use geo::{Area, BooleanOps, Centroid, Contains, Coord, LineString, MultiPolygon};

use crate::catalog::Side;
use crate::geometry::{Intervals, Point, Segment, Solid, edges};
use crate::layout::Parent;
use crate::plan::{OpeningKind, Wall, WallKind};

use crate::audit::convex::{depth, distance, penetration, segment_distance};
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::{Body, Subject};

/// The bodies that do not touch their support.
pub(crate) fn floating(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let subject = evidence.subject;
    let limit = subject.rules().bodies.support_gap;
    let fault = |(index, body): (usize, &Body<'_>)| {
        let gap = gap_to_support(subject, body);
        let subjects = || vec![subject.object(index)];
        (gap > limit + ROUNDING).then(|| Fault::new(Quantity::Gap, subjects(), gap, limit))
    };
    subject.bodies.iter().enumerate().filter_map(fault).collect()
}

/// The bodies that touch their support and hang over its edge.
pub(crate) fn unsupported(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let subject = evidence.subject;
    let rules = subject.rules().bodies;
    let fault = |(index, body): (usize, &Body<'_>)| {
        let (support, share) = overhang(subject, body)?;
        let subjects = vec![subject.object(index), subject.object(support)];
        // A body that floats is one finding, not two.
        let touches = gap_to_support(subject, body) <= rules.support_gap + ROUNDING;
        touches.then(|| Fault::new(Quantity::Share, subjects, share, rules.overhang_share))
    };
    subject.bodies.iter().enumerate().filter_map(fault).collect()
}

/// Metres between a body and what carries it; zero or less in contact.
fn gap_to_support(subject: &Subject<'_>, body: &Body<'_>) -> f64 {
    let contact = subject.rules().bodies.support_gap;
    let is_standing = body.low() <= contact;
    let placement = body.placement;
    match placement.parent {
        Parent::Floor => body.low(),
        Parent::Ceiling => subject.at.room.height - body.high(),
        Parent::Object(parent) if placement.side == Side::Above => {
            let under = gap_above(&subject.bodies[parent], body, contact);
            // A hood belongs to its cooker but hangs on the wall.
            if may_hang(body, contact) { under.min(gap_behind(subject, body)) } else { under }
        }
        _ if is_standing => body.low(),
        Parent::Wall(wall) => gap_to_wall(subject, wall, None, body),
        Parent::Opening(opening) => gap_to_opening(subject, opening, body),
        Parent::Column(column) => gap_to_column(subject, column, body),
        Parent::Object(parent) if placement.side == Side::Below => subject.bodies[parent].low() - body.high(),
        Parent::Object(parent) => gap_beside(&subject.bodies[parent], body).min(gap_behind(subject, body)),
    }
}

/// Whether its class ever stands clear of what it belongs to.
fn may_hang(body: &Body<'_>, contact: f64) -> bool {
    body.class.parents.iter().any(|rule| rule.elevation.1 > contact)
}

/// Metres between a body's underside and the highest part of its parent (or the floor) under it.
fn gap_above(parent: &Body<'_>, body: &Body<'_>, contact: f64) -> f64 {
    let is_under = |part: &&Solid| {
        let overlaps = |solid: &Solid| penetration(part.footprint(), solid.footprint()) > 0.0;
        // Parts that reach higher stand beside it and carry nothing of it.
        part.high <= body.low() + contact && body.solids.iter().any(overlaps)
    };
    // Without a part under it the gap is that to the floor.
    body.low() - parent.solids.iter().filter(is_under).map(|part| part.high).fold(0.0, f64::max)
}

/// Metres sideways to the nearest part of the parent at the same height.
fn gap_beside(parent: &Body<'_>, body: &Body<'_>) -> f64 {
    let pairs = parent.solids.iter().flat_map(|part| body.solids.iter().map(move |solid| (part, solid)));
    let level = pairs.filter(|(part, solid)| part.low < solid.high && solid.low < part.high);
    level.map(|(part, solid)| distance(part.footprint(), solid.footprint())).fold(f64::INFINITY, f64::min)
}

/// Metres to the nearest wall or to the ceiling, whichever is closer.
fn gap_behind(subject: &Subject<'_>, body: &Body<'_>) -> f64 {
    let walls = 0..subject.at.room.walls.len();
    let to_walls = walls.map(|wall| gap_to_wall(subject, wall, None, body));
    to_walls.fold(subject.at.room.height - body.high(), f64::min)
}

fn gap_to_opening(subject: &Subject<'_>, opening: usize, body: &Body<'_>) -> f64 {
    let here = subject.at.room.openings.iter().filter(|place| place.opening == opening);
    here.map(|place| gap_to_wall(subject, place.wall, Some(opening), body)).fold(f64::INFINITY, f64::min)
}

fn gap_to_column(subject: &Subject<'_>, column: usize, body: &Body<'_>) -> f64 {
    let column = &subject.at.room.obstacles[column];
    if body.placement.side == Side::Above {
        return body.low() - column.height;
    }
    column.outline.edges().map(|edge| gap_to_segment(body, edge)).fold(f64::INFINITY, f64::min)
}

/// Metres to the solid stretches of a wall at the body's height. Door holes, glass and the air over a
/// railing carry nothing; the frame of the opening `hung_on` does.
fn gap_to_wall(subject: &Subject<'_>, wall: usize, hung_on: Option<usize>, body: &Body<'_>) -> f64 {
    let face = &subject.at.room.walls[wall];
    let stretches = solid_stretches(subject, wall, hung_on, body);
    let at = |along: f64| face.after(along);
    let segments = stretches.as_slice().iter().map(|&(from, to)| Segment::new(at(from), at(to)));
    segments.map(|segment| gap_to_segment(body, segment)).fold(f64::INFINITY, f64::min)
}

fn solid_stretches(subject: &Subject<'_>, wall: usize, hung_on: Option<usize>, body: &Body<'_>) -> Intervals {
    let face: &Wall = &subject.at.room.walls[wall];
    if matches!(face.kind, WallKind::Railing(top) if body.low() >= top) {
        return Intervals::default();
    }
    let mut stretches = Intervals::new(0.0, face.length());
    for place in subject.at.room.openings.iter().filter(|place| place.wall == wall) {
        let opening = &subject.at.level.openings[place.opening];
        let has_frame = opening.kind != OpeningKind::OpenBoundary && hung_on == Some(place.opening);
        // Only an opening over its whole height leaves it nothing to hang on: a shelf over a door has wall behind it.
        let covers = opening.bottom <= body.low() + ROUNDING && opening.top + ROUNDING >= body.high();
        if covers && !has_frame {
            stretches.subtract(place.from, place.to);
        }
    }
    stretches
}

fn gap_to_segment(body: &Body<'_>, segment: Segment) -> f64 {
    let gaps = body.solids.iter().map(|solid| segment_distance(solid.footprint(), segment));
    gaps.fold(f64::INFINITY, f64::min)
}

/// The share of a footprint that hangs over the edge of its support, with the support's index, where it is
/// too much.
fn overhang(subject: &Subject<'_>, body: &Body<'_>) -> Option<(usize, f64)> {
    let Parent::Object(index) = body.placement.parent else { return None };
    let parent = &subject.bodies[index];
    let rules = subject.rules().bodies;
    let carries = |part: &&Solid| (part.high - body.low()).abs() <= rules.support_gap + ROUNDING;
    let support: Vec<&Solid> = parent.solids.iter().filter(carries).collect();
    if body.placement.side != Side::Above || support.is_empty() {
        return None;
    }
    let rests_on = |solid: &Solid| support.iter().any(|part| is_within(part.footprint(), solid.footprint()));
    // Nearly always. Unions of polygons, the slow way, are made for what reaches over an edge only.
    if body.solids.iter().all(rests_on) {
        return None;
    }
    let carried = union(body.solids.iter());
    let carrier = union(support.into_iter());
    let share = carried.difference(&carrier).unsigned_area() / carried.unsigned_area();
    let is_balanced = carried.centroid().is_some_and(|center| carrier.contains(&center));
    // Too much hangs over the edge, or its middle is not carried and it would tip.
    (share > rules.overhang_share + ROUNDING || !is_balanced).then_some((index, share))
}

fn is_within(outer: &[Point], inner: &[Point]) -> bool {
    inner.iter().all(|&corner| depth(outer, corner) >= -ROUNDING)
}

fn union<'a>(solids: impl Iterator<Item = &'a Solid>) -> MultiPolygon {
    let mut all = MultiPolygon::new(Vec::new());
    for solid in solids {
        let ring =
            edges(solid.footprint()).map(|edge| edge.start).map(|corner| Coord { x: corner.x, y: corner.y });
        all = all.union(&geo::Polygon::new(LineString::from_iter(ring), Vec::new()));
    }
    all
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::Side;
    use crate::layout::Parent;
    use crate::plan::{OpeningKind, WallKind};

    #[test]
    fn standing_needs_the_floor() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.stand("chest", at(2.0, 2.0));
        room.placements[0].elevation = 0.01;
        assert_eq!(room.count(Code::Floating), 0);
        room.placements[0].elevation = 0.03;
        let findings = room.audit();
        assert_eq!(findings[0].code, Code::Floating);
        assert!((findings[0].measured - 0.03).abs() < 1e-9);
    }

    #[test]
    fn hanging_needs_the_ceiling() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let lamp = room.add("lamp", at(2.0, 2.0), Parent::Ceiling);
        room.placements[lamp].elevation = 2.5 - 0.3;
        assert_eq!(room.count(Code::Floating), 0);
        room.placements[lamp].elevation = 2.1;
        assert_eq!(room.count(Code::Floating), 1);
    }

    #[test]
    fn a_picture_needs_the_wall_behind_it() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        // Wall 0 runs along y = 0; the picture is 5 cm deep.
        let picture = room.add("picture", at(2.0, 0.025), Parent::Wall(0));
        room.placements[picture].elevation = 1.2;
        assert_eq!(room.count(Code::Floating), 0);
        room.placements[picture].position.y = 0.05;
        assert_eq!(room.count(Code::Floating), 1);
    }

    #[test]
    fn glass_and_air_carry_no_picture_but_a_curtain_hangs_on_its_window() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let picture = room.add("picture", at(2.0, 0.025), Parent::Wall(0));
        room.placements[picture].elevation = 1.2;
        room.open(0, OpeningKind::Window, (1.2, 2.8), (0.9, 2.2));
        assert_eq!(room.count(Code::Floating), 1, "on the glass");
        room.placements[picture].position.x = 3.1;
        assert_eq!(room.count(Code::Floating), 0, "beside the window");
        room.placements[picture].position.x = 2.0;
        room.placements[picture].parent = Parent::Opening(0);
        assert_eq!(room.count(Code::Floating), 0, "in the window's frame");
        room.placements[picture].parent = Parent::Wall(1);
        room.placements[picture].position = at(4.975, 2.0);
        room.placements[picture].angle = core::f64::consts::FRAC_PI_2;
        assert_eq!(room.count(Code::Floating), 0);
        room.level.rooms[0].walls[1].kind = WallKind::Railing(1.0);
        assert_eq!(room.count(Code::Floating), 1, "over a railing");
    }

    #[test]
    fn a_lamp_needs_the_surface_under_it() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let table = room.stand("table", at(2.0, 2.0));
        let lamp = room.add("lamp", at(2.0, 2.0), Parent::Object(table));
        room.placements[lamp].elevation = 0.75;
        assert_eq!(room.audit(), []);
        room.placements[lamp].elevation = 0.78;
        assert_eq!(room.count(Code::Floating), 1);
        room.placements[lamp].elevation = 0.75;
        room.placements[lamp].position.x = 4.0;
        assert!((room.audit()[0].measured - 0.75).abs() < 1e-9, "beside the table it hangs over the floor");
    }

    #[test]
    fn a_tenth_may_hang_over_the_edge() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let table = room.stand("table", at(2.0, 2.0));
        // The lamp is 0.2 wide, the table reaches to x = 2.75.
        let lamp = room.add("lamp", at(2.665, 2.0), Parent::Object(table));
        room.placements[lamp].elevation = 0.75;
        assert_eq!(room.count(Code::Unsupported), 0);
        room.placements[lamp].position.x = 2.675;
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::Unsupported, 1));
        assert!((findings[0].measured - 0.125).abs() < 1e-6);
        assert_eq!(findings[0].objects, ["lamp.1", "table.1"]);
    }

    #[test]
    fn a_wall_cabinet_hangs_beside_its_neighbour_or_on_the_wall() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let first = room.add("picture", at(2.0, 0.025), Parent::Wall(0));
        room.placements[first].elevation = 1.2;
        let second = room.add("picture", at(2.6, 0.025), Parent::Object(first));
        room.placements[second].elevation = 1.2;
        room.placements[second].side = Side::Right;
        assert_eq!(room.count(Code::Floating), 0);
        room.placements[second].position = at(2.7, 0.2);
        assert_eq!(room.count(Code::Floating), 1);
    }

    #[test]
    fn a_shelf_on_a_column_needs_its_face() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let outline = crate::geometry::Polygon::rectangle(at(2.0, 2.0), at(0.6, 0.4));
        room.level.rooms[0].obstacles.push(crate::plan::Obstacle { outline, height: 2.5 });
        let picture = room.add("picture", at(2.3, 1.975), Parent::Column(0));
        room.placements[picture].elevation = 1.0;
        room.placements[picture].side = Side::Front;
        assert_eq!(room.audit(), []);
        room.placements[picture].position.y = 1.9;
        assert_eq!(room.count(Code::Floating), 1);
    }
}
