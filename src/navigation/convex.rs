//! Cuts areas into convex polygons with corners on whole millimetres.

use std::collections::BTreeMap;

use super::shape::Area;

/// Whole millimetres east and north.
pub(super) type Corner = [i64; 2];

/// Millimetres of a metre.
const MILLIMETRES: f64 = 1000.0;

/// The corners of a convex polygon, counter-clockwise.
pub(super) type Convex = Vec<Corner>;

/// A place on whole millimetres.
fn corner(place: &geo::Coord<f64>) -> Corner {
    [place.x, place.y].map(|metres| libm::rint(metres * MILLIMETRES) as i64)
}

/// A place in metres.
pub(super) fn metres(corner: Corner) -> [f64; 2] {
    corner.map(|millimetres| millimetres as f64 / MILLIMETRES)
}

/// Convex polygons that fill an area.
///
/// Triangles are joined across the longest of their common sides first, as long as what they make is convex (S. Hertel,
/// K. Mehlhorn, "Fast triangulation of simple polygons", 1983: at most four times as many as needed).
pub(super) fn convex_parts(area: &Area) -> Vec<Convex> {
    area.0.iter().flat_map(parts_of).collect()
}

fn parts_of(polygon: &geo::Polygon<f64>) -> Vec<Convex> {
    let rings = core::iter::once(polygon.exterior()).chain(polygon.interiors());
    let (mut corners, mut hole_starts): (Vec<Corner>, Vec<u32>) = (Vec::new(), Vec::new());
    for (number, ring) in rings.enumerate() {
        let mut ring: Vec<Corner> = ring.0.iter().map(corner).collect();
        ring.dedup();
        // The last place of a ring is its first.
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        match (ring.len() > 2, number) {
            (true, 0) => {}
            (true, _) => hole_starts.push(u32::try_from(corners.len()).expect("a room has few corners")),
            (false, 0) => return Vec::new(),
            (false, _) => continue,
        }
        corners.extend(ring);
    }
    let mut indices: Vec<u32> = Vec::new();
    let plain = corners.iter().map(|corner| corner.map(|millimetres| millimetres as f64));
    earcut::Earcut::new().earcut(plain, &hole_starts, &mut indices);
    let triangles = indices.as_chunks::<3>().0.iter().filter_map(|triangle| {
        let [a, b, c] = triangle.map(|index| corners[index as usize]);
        match turn(a, b, c) {
            0 => None,
            1.. => Some(vec![a, b, c]),
            _ => Some(vec![a, c, b]),
        }
    });
    joined(triangles.collect())
}

/// Twice the area of a triangle, positive if its corners are counter-clockwise.
pub(super) fn turn([ax, ay]: Corner, [bx, by]: Corner, [cx, cy]: Corner) -> i128 {
    let (ux, uy) = (i128::from(bx - ax), i128::from(by - ay));
    let (vx, vy) = (i128::from(cx - ax), i128::from(cy - ay));
    ux * vy - uy * vx
}

/// The sides of a polygon.
pub(super) fn sides(polygon: &[Corner]) -> impl Iterator<Item = (Corner, Corner)> + '_ {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

fn joined(mut polygons: Vec<Convex>) -> Vec<Convex> {
    let mut owners: BTreeMap<(Corner, Corner), usize> = BTreeMap::new();
    for (index, polygon) in polygons.iter().enumerate() {
        owners.extend(sides(polygon).map(|side| (side, index)));
    }
    let length = |(a, b): (Corner, Corner)| {
        let (x, y) = (i128::from(b[0] - a[0]), i128::from(b[1] - a[1]));
        x * x + y * y
    };
    let inner = owners.keys().filter(|&&(a, b)| a < b && owners.contains_key(&(b, a)));
    let mut inner: Vec<(Corner, Corner)> = inner.copied().collect();
    inner.sort_by_key(|&side| (core::cmp::Reverse(length(side)), side));
    for (a, b) in inner {
        let (Some(&left), Some(&right)) = (owners.get(&(a, b)), owners.get(&(b, a))) else { continue };
        if left == right {
            continue;
        }
        let Some(merged) = merged(&polygons[left], &polygons[right], (a, b)) else { continue };
        owners.remove(&(a, b));
        owners.remove(&(b, a));
        owners.extend(sides(&merged).map(|side| (side, left)));
        polygons[left] = merged;
        polygons[right].clear();
    }
    polygons.retain(|polygon| !polygon.is_empty());
    polygons
}

/// Two polygons on the left and the right of a side as one, if that is convex.
fn merged(left: &[Corner], right: &[Corner], (a, b): (Corner, Corner)) -> Option<Convex> {
    // From b around the left polygon to a, then around the right one from a to b, both without their last corner.
    let from = |polygon: &[Corner], first: Corner| {
        let at = polygon.iter().position(|&corner| corner == first)?;
        let around = polygon.iter().cycle().skip(at).take(polygon.len() - 1);
        Some(around.copied().collect::<Vec<_>>())
    };
    let mut merged = from(left, b)?;
    merged.extend(from(right, a)?);
    let count = merged.len();
    let is_convex = (0..count)
        .all(|index| turn(merged[index], merged[(index + 1) % count], merged[(index + 2) % count]) >= 0);
    is_convex.then_some(merged)
}
