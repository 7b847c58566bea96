//! The smallest rectangle around an outline, along one of its longer edges.

use crate::geometry::{Point, edges};

/// Edges whose directions are tried, longest first: what is drawn as a rectangle has four.
const MOST_EDGES: usize = 64;

/// A rectangle that may be turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Oriented {
    pub(super) center: Point,
    /// Unit vector of its longer side.
    pub(super) axis: Point,
    /// Metres along and across the axis; the first is not smaller.
    pub(super) size: Point,
}

impl Oriented {
    /// Around an outline; `None` if all of its corners are one.
    pub(super) fn around(outline: &[Point]) -> Option<Self> {
        let mut sides: Vec<(f64, Point)> = edges(outline)
            .map(|edge| (edge.length(), edge.direction()))
            .filter(|(length, _)| *length > 0.0)
            .collect();
        sides.sort_by(|a, b| b.0.total_cmp(&a.0));
        let boxes = sides.iter().take(MOST_EDGES).map(|(_, axis)| Self::along(outline, *axis));
        // The first of equals: that of the longest edge.
        boxes.reduce(|best, next| {
            let area = |found: &Self| found.size.element_product();
            if area(&next) < area(&best) * (1.0 - 1e-9) { next } else { best }
        })
    }

    fn along(outline: &[Point], axis: Point) -> Self {
        let across = axis.perp();
        let (mut least, mut most) = (Point::INFINITY, Point::NEG_INFINITY);
        for corner in outline {
            let place = Point::new(corner.dot(axis), corner.dot(across));
            least = least.min(place);
            most = most.max(place);
        }
        let (middle, size) = ((least + most) / 2.0, most - least);
        let center = axis * middle.x + across * middle.y;
        if size.x >= size.y {
            Self { center, axis, size }
        } else {
            Self { center, axis: across, size: Point::new(size.y, size.x) }
        }
    }

    /// Its corners, the longer sides between the first two and the last two.
    pub(super) fn corners(&self) -> [Point; 4] {
        let (along, across) = (self.axis * (self.size.x / 2.0), self.axis.perp() * (self.size.y / 2.0));
        [
            self.center - along - across,
            self.center + along - across,
            self.center + along + across,
            self.center - along + across,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_rectangle_is_found_with_corners_between_and_repeated() {
        let axis = Point::new(0.8, 0.6);
        let drawn = Oriented { center: Point::new(3.0, 2.0), axis, size: Point::new(0.9, 0.2) };
        let mut outline = drawn.corners().to_vec();
        outline.insert(1, outline[0].lerp(outline[1], 0.3));
        outline.push(outline[0]);
        let found = Oriented::around(&outline).unwrap();
        assert!((found.size - drawn.size).length() < 1e-12, "{found:?}");
        assert!((found.center - drawn.center).length() < 1e-12 && found.axis.dot(axis).abs() > 1.0 - 1e-12);
        assert_eq!(Oriented::around(&[Point::ONE; 3]), None);
    }
}
