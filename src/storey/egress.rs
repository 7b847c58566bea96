//! How far it is out: from each room through doors to stairs, or on the ground floor to the open air.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::geometry::{Point, edges};

use super::faces::Partition;
use super::links::Links;
use super::ring::bounds;

/// Metres from the middle of a room to stairs or the open air at most: building codes ask for 30 to 40 from any place (the German
/// model code, § 33, for 35), and straight lines from door to door are a little shorter than ways are.
const LONGEST: f64 = 34.9;
/// Storeys whose width and depth are together less than this many metres have no such ways.
const SMALL: f64 = 34.0;

/// The room farthest from a way out, with its metres, where that is too far.
pub(super) fn too_far_out(partition: &Partition<'_>, links: &Links, is_ground: bool) -> Option<(usize, f64)> {
    let boxes = partition.cells.iter().map(|cell| bounds(&cell.ring));
    let size = boxes.reduce(|all, next| all.union(next))?.size();
    if size.x + size.y < SMALL {
        return None;
    }
    let metres = metres_out(partition, links, is_ground);
    let middles: Vec<Point> = (0..partition.cells.len()).map(|room| middle_of(partition, room)).collect();
    let mut nearest = vec![f64::INFINITY; partition.cells.len()];
    for (link, metres) in links.links.iter().zip(&metres) {
        for room in rooms_of(link.rooms) {
            let way = middles[room].distance(link.center);
            nearest[room] = nearest[room].min(metres + way);
        }
    }
    // What has no way out at all is told as unreached.
    let far = nearest.into_iter().enumerate().filter(|(_, metres)| metres.is_finite());
    far.reduce(|a, b| if b.1 > a.1 { b } else { a }).filter(|(_, metres)| *metres > LONGEST)
}

/// The middle of a room within its walls.
fn middle_of(partition: &Partition<'_>, room: usize) -> Point {
    let faces: Vec<Point> = partition.faces[room].iter().map(|face| face.start).collect();
    middle_of_ring(if faces.is_empty() { &partition.cells[room].ring } else { &faces })
}

/// The middle of the widest part of a ring on a line across its middle: it is inside, whatever the ring's form. The line runs
/// midway between the corners next to the middle, so that it meets none (the interior point of areas of the JTS Topology Suite).
fn middle_of_ring(ring: &[Point]) -> Point {
    let extent = bounds(ring);
    let middle = extent.center().y;
    let heights = || ring.iter().map(|corner| corner.y);
    let above = heights().filter(|y| *y > middle).fold(extent.high.y, f64::min);
    let below = heights().filter(|y| *y <= middle).fold(extent.low.y, f64::max);
    let y = 0.5 * (above + below);
    let mut crossings: Vec<f64> = edges(ring)
        .filter(|edge| (edge.start.y > y) != (edge.end.y > y))
        .map(|edge| {
            edge.start.x + (y - edge.start.y) / (edge.end.y - edge.start.y) * (edge.end.x - edge.start.x)
        })
        .collect();
    crossings.sort_by(f64::total_cmp);
    let widest = crossings.chunks_exact(2).reduce(|a, b| if b[1] - b[0] > a[1] - a[0] { b } else { a });
    widest.map_or(extent.center(), |ends| Point::new(0.5 * (ends[0] + ends[1]), y))
}

fn rooms_of((first, second): (usize, Option<usize>)) -> impl Iterator<Item = usize> {
    std::iter::once(first).chain(second)
}

/// By door: metres to a way out, in straight lines from door to door (Dijkstra's algorithm).
fn metres_out(partition: &Partition<'_>, links: &Links, is_ground: bool) -> Vec<f64> {
    let mut doors_of = vec![Vec::new(); partition.cells.len()];
    for (number, link) in links.links.iter().enumerate() {
        rooms_of(link.rooms).for_each(|room| doors_of[room].push(number));
    }
    let mut metres = vec![f64::INFINITY; links.links.len()];
    let mut queue = BinaryHeap::new();
    for (number, link) in links.links.iter().enumerate() {
        let is_stairs = rooms_of(link.rooms).any(|room| partition.cells[room].room_type == "stairs");
        if is_stairs || is_ground && link.rooms.1.is_none() {
            metres[number] = 0.0;
            queue.push((Reverse(0), number));
        }
    }
    while let Some((Reverse(far), number)) = queue.pop() {
        if far > millimetres(metres[number]) {
            continue;
        }
        let link = &links.links[number];
        for other in rooms_of(link.rooms).flat_map(|room| &doors_of[room]) {
            let there = metres[number] + link.center.distance(links.links[*other].center);
            if there < metres[*other] {
                metres[*other] = there;
                queue.push((Reverse(millimetres(there)), *other));
            }
        }
    }
    metres
}

/// For the order of the queue, which needs whole numbers.
fn millimetres(metres: f64) -> u64 {
    (metres * 1000.0).ceil() as u64
}

#[cfg(test)]
mod tests {
    use super::super::dwelling::Cell;
    use super::super::links::link;
    use super::super::typology::Typologies;
    use super::*;
    use crate::layout::seed::building_stream;

    fn cell(room_type: &str, x: (f64, f64), y: (f64, f64)) -> Cell {
        Cell::shared([(x.0, y.0), (x.1, y.0), (x.1, y.1), (x.0, y.1)].map(Point::from).into(), room_type)
    }

    /// Stairs at the left end of a corridor of some metres, an office at its right end.
    fn far_office(length: f64) -> Option<(usize, f64)> {
        let cells = [
            cell("walkway", (0.0, length), (0.0, 2.0)),
            cell("stairs", (0.0, 3.0), (2.0, 7.0)),
            cell("office", (length - 4.0, length), (2.0, 7.0)),
        ];
        let catalog = crate::catalog::builtin_catalog();
        let typologies: &Typologies = &catalog.typologies;
        let partition = Partition::new(&cells, typologies, 0.1);
        let links = link(&partition, &[], true, &mut building_stream(1, "a", "b"));
        assert!(links.unreached.is_empty());
        too_far_out(&partition, &links, false)
    }

    #[test]
    fn the_way_along_a_corridor_is_measured_from_door_to_door() {
        assert_eq!(far_office(32.0), None);
        let (room, metres) = far_office(45.0).expect("it is more than 35 m");
        assert_eq!(room, 2);
        assert!(metres > 38.0 && metres < 46.0, "{metres}");
    }

    #[test]
    fn the_middle_of_an_l_is_inside() {
        let corners = [(0., 0.), (9., 0.), (9., 1.), (1., 1.), (1., 9.), (0., 9.)].map(Point::from);
        assert_eq!(middle_of_ring(&corners), Point::new(0.5, 5.0));
    }

    #[test]
    fn the_line_across_the_middle_meets_no_corner() {
        // A spur of a hall begins just at half its height.
        let corners = [(0., 0.), (8., 0.), (8., 4.5), (20., 4.5), (20., 6.), (8., 6.), (8., 9.), (0., 9.)];
        assert_eq!(middle_of_ring(&corners.map(Point::from)), Point::new(10.0, 5.25));
    }
}
