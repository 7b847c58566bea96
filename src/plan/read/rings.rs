//! The border of an area, as maps draw it.

use crate::geometry::Point;

/// An outer ring and holes, each perhaps closed, in any direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::plan::read) struct Rings {
    pub(in crate::plan::read) outer: Vec<Point>,
    pub(in crate::plan::read) holes: Vec<Vec<Point>>,
}

impl Rings {
    /// The rings counter-clockwise, not closed, each from its lowest corner; holes sorted: the same area is the same text,
    /// whatever program wrote it.
    pub(in crate::plan::read) fn canonical(self) -> Self {
        let mut holes: Vec<Vec<Point>> = self.holes.into_iter().map(canonical).collect();
        holes.sort_by(|a, b| order(a.first(), b.first()));
        Self { outer: canonical(self.outer), holes }
    }
}

fn canonical(mut ring: Vec<Point>) -> Vec<Point> {
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    let start = (0..ring.len()).min_by(|&a, &b| order(ring.get(a), ring.get(b))).unwrap_or_default();
    ring.rotate_left(start);
    // From the lowest corner, so that the sum is of small numbers.
    let doubled: f64 = ring.windows(2).map(|edge| (edge[0] - ring[0]).perp_dot(edge[1] - ring[0])).sum();
    if doubled < 0.0 {
        ring[1..].reverse();
    }
    ring
}

fn order(a: Option<&Point>, b: Option<&Point>) -> std::cmp::Ordering {
    let key = |place: Option<&Point>| place.map_or((f64::NAN, f64::NAN), |place| (place.x, place.y));
    let (a, b) = (key(a), key(b));
    a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().copied().map(Point::from).collect()
    }

    #[test]
    fn the_same_area_has_the_same_rings_however_it_is_written() {
        let square = ring(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        let hole = ring(&[(1.0, 1.0), (1.5, 1.0), (1.0, 1.5)]);
        let expected = Rings { outer: square.clone(), holes: vec![hole.clone()] };
        let mut closed = square.clone();
        closed.rotate_left(2);
        closed.reverse();
        closed.push(closed[0]);
        let mut turned = hole;
        turned.reverse();
        assert_eq!(Rings { outer: closed, holes: vec![turned] }.canonical(), expected);
        assert_eq!(expected.clone().canonical(), expected);
    }

    #[test]
    fn rings_without_corners_stay_so() {
        let empty = Rings { outer: Vec::new(), holes: vec![Vec::new()] };
        assert_eq!(empty.clone().canonical(), empty);
    }
}
