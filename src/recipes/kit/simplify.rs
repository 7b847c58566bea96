//! Fewer triangles for a closed solid.
//!
//! Edges are collapsed in the order of the error that they make, measured by quadrics (M. Garland and P. Heckbert,
//! "Surface Simplification Using Quadric Error Metrics", 1997). A corner always moves onto another corner, so that the
//! result lies in the convex hull of the solid. Ours and not a library's: the well-kept ones are C++, whose compilers round
//! sums differently from machine to machine.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::{DMat3, DVec3};

use super::solid::{Shading, Solid};

/// Crease angle in degrees of what had normals of its own: edges of boxes are sharp, bends of cushions smooth.
const CREASE: f64 = 50.0;
/// The least cosine between a triangle's direction before and after a collapse.
const LEAST_AGREEMENT: f64 = 0.3;
/// Square metres below which a triangle would count as having no area.
const LEAST_AREA: f64 = 1e-9;
/// Triangles of the smallest closed solid.
const LEAST_TRIANGLES: usize = 4;

/// The solid with edges collapsed until it has at most `target` triangles or the next collapse would move its surface
/// by more than `tolerance` metres.
pub(super) fn simplified(solid: &Solid, target: usize, tolerance: f64) -> Solid {
    if solid.triangles.len() <= target.max(LEAST_TRIANGLES) {
        return solid.clone();
    }
    let mut surface =
        Surface::new(&solid.points, &solid.triangles, vec![false; solid.points.len()], tolerance);
    surface.collapse(target.max(LEAST_TRIANGLES));
    let shading = match solid.shading {
        _ if surface.living == solid.triangles.len() => return solid.clone(),
        Shading::Crease(angle) => Shading::Crease(angle),
        Shading::Given(_) => Shading::Crease(CREASE.to_radians()),
    };
    surface.into_solid(shading)
}

/// The triangles of surfaces that need not be closed, with edges collapsed as those of [`simplified`]. Corners at rims stay,
/// and so do seams, where corners lie at one place and differ in what else they carry.
pub(crate) fn simplified_surface(
    points: &[DVec3],
    triangles: &[[usize; 3]],
    target: usize,
    tolerance: f64,
) -> Vec<[usize; 3]> {
    let mut surface = Surface::new(points, triangles, at_rims(points.len(), triangles), tolerance);
    surface.collapse(target.max(LEAST_TRIANGLES));
    surface.triangles.into_iter().flatten().collect()
}

/// The sum of squared distances to planes, weighted by the area of the faces in them.
#[derive(Clone, Copy, Debug)]
struct Quadric {
    matrix: DMat3,
    vector: DVec3,
    constant: f64,
    weight: f64,
}

impl Quadric {
    const NONE: Self = Self { matrix: DMat3::ZERO, vector: DVec3::ZERO, constant: 0.0, weight: 0.0 };

    fn of_plane(normal: DVec3, point: DVec3, weight: f64) -> Self {
        let distance = -normal.dot(point);
        Self {
            matrix: DMat3::from_cols(normal * normal.x, normal * normal.y, normal * normal.z) * weight,
            vector: normal * distance * weight,
            constant: distance * distance * weight,
            weight,
        }
    }

    fn add(&mut self, other: &Self) {
        self.matrix += other.matrix;
        self.vector += other.vector;
        self.constant += other.constant;
        self.weight += other.weight;
    }

    /// Root mean square distance of a point from the planes, in metres.
    fn distance(&self, point: DVec3) -> f64 {
        let sum = point.dot(self.matrix * point) + 2.0 * self.vector.dot(point) + self.constant;
        (sum.max(0.0) / self.weight.max(LEAST_AREA)).sqrt()
    }
}

/// A collapse: its error in metres as bits, which sort as the positive numbers do, and the corner that goes to another.
type Collapse = (u64, usize, usize);
/// A collapse that waits, with the counts that tell whether either corner has become another since.
type Candidate = Reverse<(Collapse, u32, u32)>;

/// A surface under simplification.
struct Surface {
    points: Vec<DVec3>,
    /// `None` once it is gone.
    triangles: Vec<Option<[usize; 3]>>,
    /// Triangles by corner, in any order.
    fans: Vec<Vec<usize>>,
    /// Corners at a rim, which stay; none of a closed solid.
    is_held: Vec<bool>,
    quadrics: Vec<Quadric>,
    /// How often a corner took in another or went, so that the errors of its collapses are no longer true.
    changes: Vec<u32>,
    /// Collapses that the triangles around either of their corners forbade, by both corners: they are tried again when
    /// those triangles change.
    refused: Vec<Vec<Collapse>>,
    living: usize,
    /// Metres of error up to which collapses are queued.
    tolerance: f64,
    queue: BinaryHeap<Candidate>,
}

impl Surface {
    fn new(points: &[DVec3], triangles: &[[usize; 3]], is_held: Vec<bool>, tolerance: f64) -> Self {
        let mut surface = Self {
            points: points.to_vec(),
            triangles: triangles.iter().copied().map(Some).collect(),
            fans: vec![Vec::new(); points.len()],
            is_held,
            quadrics: vec![Quadric::NONE; points.len()],
            changes: vec![0; points.len()],
            refused: vec![Vec::new(); points.len()],
            living: triangles.len(),
            tolerance,
            queue: BinaryHeap::new(),
        };
        for (index, triangle) in triangles.iter().enumerate() {
            let doubled = surface.doubled(*triangle);
            let area = doubled.length() / 2.0;
            let plane = Quadric::of_plane(doubled.normalize_or_zero(), surface.points[triangle[0]], area);
            for &corner in triangle {
                surface.fans[corner].push(index);
                surface.quadrics[corner].add(&plane);
            }
        }
        for corner in 0..points.len() {
            // Each edge once.
            surface
                .neighbours(corner)
                .into_iter()
                .filter(|&other| other > corner)
                .for_each(|other| surface.propose(corner, other));
        }
        surface
    }

    /// The triangle's normal times twice its area.
    fn doubled(&self, [a, b, c]: [usize; 3]) -> DVec3 {
        (self.points[b] - self.points[a]).cross(self.points[c] - self.points[a])
    }

    /// The corners that share an edge with one, each once.
    fn neighbours(&self, corner: usize) -> Vec<usize> {
        let corners = self.fans[corner].iter().filter_map(|&triangle| self.triangles[triangle]).flatten();
        let mut others: Vec<usize> = corners.filter(|&other| other != corner).collect();
        others.sort_unstable();
        others.dedup();
        others
    }

    /// Queues the collapses of two neighbours onto each other, as far as they are not too coarse.
    fn propose(&mut self, corner: usize, other: usize) {
        let mut sum = self.quadrics[corner];
        sum.add(&self.quadrics[other]);
        for (from, to) in [(corner, other), (other, corner)] {
            let error = sum.distance(self.points[to]);
            if error <= self.tolerance && !self.is_held[from] {
                self.enqueue((error.to_bits(), from, to));
            }
        }
    }

    fn enqueue(&mut self, collapse: Collapse) {
        let (_, from, to) = collapse;
        self.queue.push(Reverse((collapse, self.changes[from], self.changes[to])));
    }

    fn collapse(&mut self, target: usize) {
        while self.living > target {
            let Some(Reverse((collapse, changes, changes_there))) = self.queue.pop() else { break };
            let (_, from, to) = collapse;
            if [self.changes[from], self.changes[to]] != [changes, changes_there] {
                continue;
            }
            if self.can_merge(from, to) {
                self.merge(from, to);
            } else {
                self.refused[from].push(collapse);
                self.refused[to].push(collapse);
            }
        }
    }

    /// Whether the surface stays closed and no triangle folds over.
    fn can_merge(&self, from: usize, to: usize) -> bool {
        // Two corners of a closed surface may become one if no others than the two beside their edge touch both.
        let there = self.neighbours(to);
        let shared =
            self.neighbours(from).iter().filter(|corner| there.binary_search(corner).is_ok()).count();
        if shared != 2 || self.living <= LEAST_TRIANGLES {
            return false;
        }
        self.fans[from].iter().filter_map(|&triangle| self.triangles[triangle]).all(|triangle| {
            if triangle.contains(&to) {
                return true;
            }
            let after = self.doubled(triangle.map(|corner| if corner == from { to } else { corner }));
            let before = self.doubled(triangle);
            after.length() > 2.0 * LEAST_AREA
                && after.dot(before) > LEAST_AGREEMENT * after.length() * before.length()
        })
    }

    fn merge(&mut self, from: usize, to: usize) {
        let quadric = self.quadrics[from];
        self.quadrics[to].add(&quadric);
        for index in std::mem::take(&mut self.fans[from]) {
            let Some(triangle) = self.triangles[index] else { continue };
            if triangle.contains(&to) {
                self.triangles[index] = None;
                self.living -= 1;
                for corner in triangle {
                    self.fans[corner].retain(|&other| other != index);
                }
            } else {
                self.triangles[index] = Some(triangle.map(|corner| if corner == from { to } else { corner }));
                self.fans[to].push(index);
            }
        }
        for corner in [from, to] {
            self.changes[corner] += 1;
            self.refused[corner].clear();
        }
        for corner in self.neighbours(to) {
            self.propose(to, corner);
            for refused in std::mem::take(&mut self.refused[corner]) {
                self.retry(refused, corner);
            }
        }
    }

    /// Queues a refused collapse again, which one of its corners has just forgotten. Those of corners that became others
    /// are left: they have been proposed anew or cannot be.
    fn retry(&mut self, collapse: Collapse, forgotten_by: usize) {
        let (_, from, to) = collapse;
        let other = if from == forgotten_by { to } else { from };
        let is_known = self.refused[other].iter().position(|&known| known == collapse);
        if let Some(place) = is_known {
            self.refused[other].swap_remove(place);
            self.enqueue(collapse);
        }
    }

    fn into_solid(self, shading: Shading) -> Solid {
        let mut place = vec![usize::MAX; self.points.len()];
        let mut points = Vec::new();
        let mut triangles = Vec::new();
        for triangle in self.triangles.iter().flatten() {
            triangles.push(triangle.map(|corner| {
                if place[corner] == usize::MAX {
                    place[corner] = points.len();
                    points.push(self.points[corner]);
                }
                place[corner]
            }));
        }
        Solid { points, triangles, shading }
    }
}

/// Which corners are at an edge that does not have one triangle on either side.
fn at_rims(corner_count: usize, triangles: &[[usize; 3]]) -> Vec<bool> {
    let directed = |&[a, b, c]: &[usize; 3]| [[a, b], [b, c], [c, a]];
    let mut edges: Vec<[usize; 2]> = triangles.iter().flat_map(directed).collect();
    edges.sort_unstable();
    let count_of = |edge: [usize; 2]| {
        edges.partition_point(|&other| other <= edge) - edges.partition_point(|&other| other < edge)
    };
    let mut is_at_rim = vec![false; corner_count];
    for &[from, to] in &edges {
        if count_of([from, to]) != 1 || count_of([to, from]) != 1 {
            (is_at_rim[from], is_at_rim[to]) = (true, true);
        }
    }
    is_at_rim
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::super::{Bay, cuboid, cylinder, rounded_box};
    use super::*;

    fn bay() -> Bay {
        Bay::new([-0.4, 0.4], [0.0, 0.7], [-0.25, 0.25])
    }

    #[test]
    fn a_rounded_box_becomes_a_box_of_about_its_volume() {
        let solid = rounded_box(bay(), DVec3::splat(0.02), 2);
        let coarse = simplified(&solid, 12, 0.02);
        assert_sound(&coarse);
        assert_eq!(coarse.triangles.len(), 12);
        assert!((coarse.volume() / solid.volume() - 1.0).abs() < 0.1, "{}", coarse.volume() / solid.volume());
    }

    #[test]
    fn a_column_keeps_its_height_and_stays_in_its_hull() {
        let solid = cylinder(0.1, [0.0, 1.0], 24);
        let coarse = simplified(&solid, 28, 0.05);
        assert_sound(&coarse);
        assert_eq!(coarse.triangles.len(), 28);
        assert_eq!((coarse.bounds().0.y, coarse.bounds().1.y), (0.0, 1.0));
        assert!(coarse.points.iter().all(|point| solid.points.contains(point)));
    }

    #[test]
    fn tolerance_is_kept_and_what_it_forbids_is_left_alone() {
        let solid = rounded_box(bay(), DVec3::splat(0.02), 2);
        assert_eq!(simplified(&solid, 4, 1e-9).triangles.len(), solid.triangles.len());
        // A box has nothing to spare at two centimetres.
        assert_eq!(simplified(&cuboid(bay()), 4, 0.02), cuboid(bay()));
    }
}
