//! Divides outlines with holes into outlines without.

use earcut::Earcut;

use super::archilyse::areas::Outline;
use crate::geometry::Point;

/// Corners of the largest outline that is divided; a wall around all rooms of a level has a few hundred.
const MOST_CORNERS: usize = 4_096;

/// The outline itself, or the triangles that it is made of if it has holes: a wall around rooms is not as solid as its outer ring.
pub(super) fn solid_pieces(outline: &Outline) -> Vec<Vec<Point>> {
    if outline.holes.is_empty() {
        return vec![outline.outer.clone()];
    }
    let rings = || std::iter::once(&outline.outer).chain(&outline.holes);
    if rings().map(Vec::len).sum::<usize>() > MOST_CORNERS {
        return Vec::new();
    }
    let mut corners: Vec<Point> = Vec::new();
    let mut hole_starts: Vec<u32> = Vec::new();
    for ring in rings() {
        if !corners.is_empty() {
            hole_starts.push(corners.len() as u32);
        }
        corners.extend(open(ring));
    }
    let mut indices: Vec<u32> = Vec::new();
    Earcut::new().earcut(corners.iter().map(|corner| corner.to_array()), &hole_starts, &mut indices);
    indices
        .chunks_exact(3)
        .map(|triangle| triangle.iter().map(|&corner| corners[corner as usize]).collect())
        .collect()
}

/// A ring without the corner that repeats its first.
fn open(ring: &[Point]) -> &[Point] {
    match ring {
        [first, middle @ .., last] if first == last && !middle.is_empty() => &ring[..ring.len() - 1],
        _ => ring,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{ring_contains, signed_area};

    #[test]
    fn a_wall_around_a_room_is_solid_where_it_is_drawn_and_nowhere_else() {
        let square = |at: f64, side: f64| {
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]
                .map(|(x, y)| Point::new(at + side * x, at + side * y))
                .to_vec()
        };
        let pieces = solid_pieces(&Outline { outer: square(0.0, 4.0), holes: vec![square(0.5, 3.0)] });
        let area: f64 = pieces.iter().map(|piece| signed_area(piece).abs()).sum();
        assert!((area - 7.0).abs() < 1e-9, "{area}");
        assert!(!pieces.iter().any(|piece| ring_contains(piece, Point::splat(2.0))));
        assert!(pieces.iter().any(|piece| ring_contains(piece, Point::splat(0.2))));
    }
}
