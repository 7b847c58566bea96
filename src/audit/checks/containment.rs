//! `out_of_room`: part of a body outside the outline, in a hole or a column, below the floor or above the
//! ceiling.

use crate::geometry::{Point, Segment, Solid, edges};
use crate::plan::Obstacle;

use crate::audit::convex::{clip_segment, depth};
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;

/// Halvings of the search for the deepest point of a segment: metres to nanometres.
const SEARCH_STEPS: u32 = 40;

/// Judges every body against the room.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, .. } = *evidence;
    let mut faults = Vec::new();
    let limit = subject.rules().bodies.out_of_room;
    let borders: Vec<Segment> = subject.at.room.region.borders().collect();
    for (index, body) in subject.bodies.iter().enumerate() {
        let upright = (-body.low()).max(body.high() - subject.at.room.height);
        let sideways = body.solids.iter().map(|solid| {
            let through_walls =
                protrusion(solid, limit, &borders, |point| subject.at.room.region.contains(point));
            let columns = subject.at.room.obstacles.iter();
            columns.map(|column| into_column(solid, limit, column)).fold(through_walls, f64::max)
        });
        let measured = sideways.fold(upright, f64::max);
        if measured > limit + ROUNDING {
            faults.push(Fault::new(Quantity::Depth, vec![subject.object(index)], measured, limit));
        }
    }
    faults
}

/// How deep a prism reaches into a column; zero where it does not, or stands on top of it.
fn into_column(solid: &Solid, limit: f64, column: &Obstacle) -> f64 {
    let upright = column.height - solid.low;
    if upright <= limit || !solid.bounds.touches(column.outline.bounds()) {
        return 0.0;
    }
    let borders: Vec<Segment> = column.outline.edges().collect();
    upright.min(protrusion(solid, limit, &borders, |point| !column.outline.contains(point)))
}

/// How far a prism sticks out of an allowed area, from the area's borders and a test for points; zero for
/// less than `limit`.
///
/// A convex footprint leaves the area in one of two ways: a corner of it lies outside, or a border
/// runs through it (past a concave corner of the room, or around a hole inside it).
fn protrusion(solid: &Solid, limit: f64, borders: &[Segment], is_allowed: impl Fn(Point) -> bool) -> f64 {
    let footprint = solid.footprint();
    let passes = |border: &&Segment| border.bounds().touches(solid.bounds);
    // Without a border near it, the whole footprint is on one side.
    if is_allowed(footprint[0]) && !borders.iter().any(|border| passes(&border)) {
        return 0.0;
    }
    // A corner outside is as far out as the nearest border is away.
    let outside = footprint.iter().filter(|&&corner| !is_allowed(corner));
    let by_corner = outside.map(|&corner| distance_to(borders, corner)).fold(0.0, f64::max);
    let near = borders.iter().filter(passes);
    // Borders that run less deep than the limit are cut away before the search for the deepest point, which costs most.
    let inside = near.filter_map(|&border| clip_segment(footprint, border, limit));
    inside.map(|segment| deepest_on(footprint, segment)).fold(by_corner, f64::max)
}

fn distance_to(borders: &[Segment], point: Point) -> f64 {
    let distances = borders.iter().map(|border| border.distance(point));
    distances.fold(f64::INFINITY, f64::min)
}

/// The greatest depth of a segment's points inside a convex polygon. Depth is concave along the segment,
/// so thirds close in on it.
fn deepest_on(polygon: &[Point], segment: Segment) -> f64 {
    const THIRD: f64 = 1.0 / 3.0;
    let Segment { mut start, mut end } = segment;
    for _ in 0..SEARCH_STEPS {
        let (near, far) = (start.lerp(end, THIRD), start.lerp(end, 1.0 - THIRD));
        if depth(polygon, near) < depth(polygon, far) {
            start = near;
        } else {
            end = far;
        }
    }
    debug_assert!(edges(polygon).count() > 2, "a footprint has an area");
    depth(polygon, start.midpoint(end))
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::geometry::{Point, Polygon};
    use crate::plan::Obstacle;

    #[test]
    fn a_body_against_the_wall_is_in_and_a_centimetre_through_it_is_out() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.stand("chest", at(0.5, 2.0));
        assert_eq!(room.count(Code::OutOfRoom), 0);
        room.placements[0].position.x = 0.496;
        assert_eq!(room.count(Code::OutOfRoom), 0, "4 mm are tolerated");
        room.placements[0].position.x = 0.49;
        let findings = room.audit();
        assert_eq!(findings[0].code, Code::OutOfRoom);
        assert!((findings[0].measured - 0.01).abs() < 1e-6);
    }

    #[test]
    fn a_body_in_another_place_altogether_is_out() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.stand("chest", at(9.0, 2.0));
        assert!(room.audit().iter().any(|f| f.code == Code::OutOfRoom && f.measured > 4.0));
    }

    #[test]
    fn a_concave_corner_poking_into_a_side_is_out() {
        // The notch takes the upper right quarter; all corners of the chest stay in the room.
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)];
        let mut room = TestRoom::outline(&corners);
        room.stand("chest", at(1.5, 1.5));
        room.placements[0].angle = core::f64::consts::FRAC_PI_4;
        let reach = 0.5 / core::f64::consts::SQRT_2;
        room.placements[0].position = at(2.0 - reach * 0.99, 2.0 - reach * 0.99);
        assert_eq!(room.count(Code::OutOfRoom), 0, "5 mm are tolerated");
        room.placements[0].position = at(2.0 - reach * 0.9, 2.0 - reach * 0.9);
        let findings = room.audit();
        assert!((findings[0].measured - 0.05).abs() < 1e-6, "{findings:?}");
    }

    #[test]
    fn a_hole_or_a_column_under_a_body_is_found() {
        for is_hole in [true, false] {
            let small = Polygon::rectangle(Point::new(1.9, 1.9), Point::splat(0.2));
            let mut room = TestRoom::rectangle(5.0, 4.0);
            room.stand("chest", at(3.5, 2.0));
            if is_hole {
                room.set_holes(vec![small]);
            } else {
                room.level.rooms[0].obstacles.push(Obstacle { outline: small, height: 2.5 });
            }
            assert_eq!(room.count(Code::OutOfRoom), 0);
            room.placements[0].position.x = 2.0;
            assert_eq!(room.count(Code::OutOfRoom), 1, "around it");
            room.placements[0].position.x = 2.55;
            assert_eq!(room.count(Code::OutOfRoom), 1, "over its edge");
        }
    }

    #[test]
    fn a_lamp_on_a_low_column_is_in() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let outline = Polygon::rectangle(Point::new(1.0, 1.0), Point::splat(1.0));
        room.level.rooms[0].obstacles.push(Obstacle { outline, height: 0.9 });
        let lamp = room.stand("lamp", at(1.5, 1.5));
        room.placements[lamp].elevation = 0.9;
        assert_eq!(room.count(Code::OutOfRoom), 0);
        room.placements[lamp].elevation = 0.5;
        assert_eq!(room.count(Code::OutOfRoom), 1);
    }

    #[test]
    fn floor_and_ceiling_bound_the_room() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.stand("lamp", at(1.0, 1.0));
        room.placements[0].elevation = -0.02;
        assert_eq!(room.count(Code::OutOfRoom), 1);
        room.placements[0].elevation = 2.2;
        assert_eq!(room.count(Code::OutOfRoom), 0);
        room.placements[0].elevation = 2.22;
        assert_eq!(room.count(Code::OutOfRoom), 1);
    }
}
