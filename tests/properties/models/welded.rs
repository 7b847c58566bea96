//! The requirements that every recipe is tested against.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use roomwright::internals::geometry::{DisjointSets, Size};
use roomwright::internals::recipes::Mesh;

/// Square metres below which a triangle counts as having none.
const SMALLEST_AREA: f64 = 1e-9;
/// Metres by which a model may miss the sides of its box.
const SIZE_TOLERANCE: f64 = 0.001;
/// Metres within which two faces lie in one plane.
const COPLANAR: f64 = 0.000_1;
/// Square metres of overlap that count as a fault.
const OVERLAP: f64 = 2e-6;

/// A model as one list of triangles over welded corners.
pub struct Welded {
    points: Vec<DVec3>,
    triangles: Vec<[usize; 3]>,
    /// The connected part that each triangle belongs to.
    parts: Vec<usize>,
}

impl Welded {
    /// Welds corners of exactly equal position, whatever their material.
    pub fn new(model: &Mesh) -> Self {
        let mut known: BTreeMap<[u32; 3], usize> = BTreeMap::new();
        let mut points = Vec::new();
        let mut triangles = Vec::new();
        let mut weld = |position: [f32; 3]| {
            *known.entry(position.map(|value| (value + 0.0).to_bits())).or_insert_with(|| {
                points.push(DVec3::from_array(position.map(f64::from)));
                points.len() - 1
            })
        };
        for part in &model.parts {
            let at = |index: u32| part.positions[index as usize];
            for triangle in part.indices.chunks_exact(3) {
                triangles.push([0, 1, 2].map(|corner| weld(at(triangle[corner]))));
            }
        }
        let parts = connected_parts(points.len(), &triangles);
        Self { points, triangles, parts }
    }

    fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|point| self.points[point])
    }

    fn cross(&self, triangle: usize) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(c - a)
    }

    /// The first fault of the surface: an open or overused edge, a triangle without area, a part inside out.
    pub fn surface_fault(&self) -> Option<String> {
        let mut edges: BTreeMap<(usize, usize), u32> = BTreeMap::new();
        let mut volumes: BTreeMap<usize, f64> = BTreeMap::new();
        for (index, triangle) in self.triangles.iter().enumerate() {
            let [a, b, c] = self.corners(index);
            if self.cross(index).length() / 2.0 < SMALLEST_AREA {
                return Some(format!("triangle without area at {a} {b} {c}"));
            }
            *volumes.entry(self.parts[index]).or_default() += a.dot(b.cross(c)) / 6.0;
            for step in 0..3 {
                *edges.entry((triangle[step], triangle[(step + 1) % 3])).or_default() += 1;
            }
        }
        for (&(from, to), &count) in &edges {
            if count != 1 || edges.get(&(to, from)) != Some(&1) {
                return Some(format!("edge {} to {} is open or shared", self.points[from], self.points[to]));
            }
        }
        let inside_out = volumes.iter().find(|&(_, &volume)| volume <= 0.0);
        inside_out.map(|(part, volume)| format!("part {part} has volume {volume}"))
    }

    /// The first two faces of different parts that overlap in one plane, where they would flicker.
    pub fn flicker_fault(&self) -> Option<String> {
        // By distance from the origin along normals that all point the same way, so that planes that are one follow
        // each other.
        let mut faces: Vec<(f64, DVec3, usize)> = (0..self.triangles.len())
            .map(|index| {
                let normal = self.cross(index).normalize();
                let normal = if normal.dot(RAY) < 0.0 { -normal } else { normal };
                (normal.dot(self.corners(index)[0]), normal, index)
            })
            .collect();
        faces.sort_by(|a, b| a.0.total_cmp(&b.0));
        let near = |start: usize| {
            let limit = faces[start].0 + COPLANAR;
            faces[start + 1..].iter().take_while(move |face| face.0 < limit)
        };
        let pairs = (0..faces.len()).flat_map(|start| near(start).map(move |other| (start, other)));
        for (start, &(_, other, second)) in pairs {
            let (_, normal, first) = faces[start];
            if normal.dot(other) <= 0.999_99 || self.parts[first] == self.parts[second] {
                continue;
            }
            let (area, middle) = overlap(self.corners(first), self.corners(second), normal);
            if area > OVERLAP && !self.is_hidden(middle, [self.parts[first], self.parts[second]]) {
                return Some(format!("faces overlap by {area} m² near {middle}, normal {normal}"));
            }
        }
        None
    }
}

/// A direction along no edge of any model.
const RAY: DVec3 = DVec3::new(0.571_3, 0.613_7, 0.545_1);

impl Welded {
    /// Whether a point lies inside a part that is none of two.
    fn is_hidden(&self, point: DVec3, but: [usize; 2]) -> bool {
        let mut crossings: BTreeMap<usize, u32> = BTreeMap::new();
        for index in 0..self.triangles.len() {
            if !but.contains(&self.parts[index]) && crosses(point, self.corners(index)) {
                *crossings.entry(self.parts[index]).or_default() += 1;
            }
        }
        crossings.values().any(|count| count % 2 == 1)
    }
}

/// Whether the ray from a point passes through a triangle (Möller and Trumbore, 1997).
fn crosses(point: DVec3, [a, b, c]: [DVec3; 3]) -> bool {
    let (first, second) = (b - a, c - a);
    let across = RAY.cross(second);
    let determinant = first.dot(across);
    let offset = point - a;
    let u = offset.dot(across) / determinant;
    let turned = offset.cross(first);
    let v = RAY.dot(turned) / determinant;
    determinant.abs() > 1e-15
        && u >= 0.0
        && v >= 0.0
        && u + v <= 1.0
        && second.dot(turned) / determinant > 0.0
}

fn connected_parts(point_count: usize, triangles: &[[usize; 3]]) -> Vec<usize> {
    let mut parts = DisjointSets::new(point_count);
    for &[a, b, c] in triangles {
        parts.join(a, b);
        parts.join(a, c);
    }
    triangles.iter().map(|triangle| parts.find(triangle[0])).collect()
}

/// Area that two triangles of one plane share, and its middle (Sutherland and Hodgman's clipping).
fn overlap(first: [DVec3; 3], second: [DVec3; 3], normal: DVec3) -> (f64, DVec3) {
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    let flat = |corners: [DVec3; 3]| {
        let mut flat = corners.map(|corner| DVec2::new(corner.dot(across), corner.dot(up)));
        if (flat[1] - flat[0]).perp_dot(flat[2] - flat[0]) < 0.0 {
            flat.swap(1, 2);
        }
        flat
    };
    let clip = flat(second);
    let mut shape: Vec<DVec2> = flat(first).to_vec();
    for step in 0..3 {
        let (from, to) = (clip[step], clip[(step + 1) % 3]);
        let side = |point: DVec2| (to - from).perp_dot(point - from);
        let mut kept = Vec::new();
        for index in 0..shape.len() {
            let (here, next) = (shape[index], shape[(index + 1) % shape.len()]);
            let (a, b) = (side(here), side(next));
            if a >= 0.0 {
                kept.push(here);
            }
            if (a >= 0.0) != (b >= 0.0) {
                kept.push(here + (next - here) * (a / (a - b)));
            }
        }
        shape = kept;
    }
    let next = |index: usize| shape[(index + 1) % shape.len()];
    let area = shape.iter().enumerate().map(|(index, &point)| point.perp_dot(next(index))).sum::<f64>() / 2.0;
    let middle = shape.iter().sum::<DVec2>() / shape.len().max(1) as f64;
    (area, across * middle.x + up * middle.y + normal * normal.dot(first[0]))
}

/// The first fault of a model's numbers: a bad index, a normal that is not of unit length or looks
/// away, a box that is not filled.
pub fn number_fault(model: &Mesh, size: Size) -> Option<String> {
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for part in &model.parts {
        if part.positions.len() != part.normals.len() || part.indices.len() % 3 != 0 {
            return Some("lists of different length".to_owned());
        }
        for position in &part.positions {
            let position = DVec3::from_array(position.map(f64::from));
            if !position.is_finite() {
                return Some(format!("position {position}"));
            }
            (low, high) = (low.min(position), high.max(position));
        }
        for triangle in part.indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|corner| triangle[corner] as usize);
            let at = |index: usize| DVec3::from_array(part.positions[index].map(f64::from));
            let face = (at(b) - at(a)).cross(at(c) - at(a)).normalize();
            for corner in [a, b, c] {
                let normal = DVec3::from_array(part.normals[corner].map(f64::from));
                if (normal.length() - 1.0).abs() > 1e-5 || normal.dot(face) <= 0.0 {
                    return Some(format!("normal {normal} on a face {face} at {}", at(corner)));
                }
            }
        }
    }
    let half = DVec3::new(size.width / 2.0, size.height / 2.0, size.depth / 2.0);
    let middle = DVec3::Y * half.y;
    let miss = (low - (middle - half)).abs().max((high - (middle + half)).abs()).max_element();
    (miss > SIZE_TOLERANCE).then(|| format!("box misses by {miss} m"))
}
