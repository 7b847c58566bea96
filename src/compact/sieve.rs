//! Leaves out what is too small or too thin to be seen, and makes boxes of what is seen from afar.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use glam::Vec3;

use super::options::{CompactOptions, Shapes};
use crate::contract::{Extras, Part};
use crate::mesh::{Model, Primitive};
use crate::scene::{Node, Scene, SceneMesh};

/// What a mesh is, as far as it decides how it is simplified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// A piece of furniture.
    Furniture,
    /// A leaf of a door.
    Leaf,
    /// Along an edge of a wall or an opening, or on a wall: seen from near only.
    Trim,
    /// The rest of the shell.
    Shell,
}

/// Models of the catalogue that were simplified in this run: most stand in many levels.
#[derive(Debug, Default)]
pub(crate) struct KnownSimplified {
    /// By where the model is in memory, and the limits. Nothing is read from it in its own order.
    known: Mutex<HashMap<(usize, [u64; 3]), Simplified>>,
}

/// A model and what is left of it; as long as it is here, nothing else is where it is.
type Simplified = (Arc<Model>, Option<Arc<Model>>);

impl KnownSimplified {
    fn simplified(&self, mesh: &SceneMesh, simplifier: &Simplifier) -> Option<Arc<Model>> {
        if !mesh.is_shared() {
            return simplifier.model(&mesh.model);
        }
        let limits = [simplifier.least_size, simplifier.least_width, simplifier.boxed].map(f64::to_bits);
        let key = (Arc::as_ptr(&mesh.model).addr(), limits);
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known().get(&key).map(|(_, made)| made.clone());
        found.unwrap_or_else(|| {
            let made = simplifier.model(&mesh.model);
            known().insert(key, (Arc::clone(&mesh.model), made.clone()));
            made
        })
    }
}

/// The models of the meshes of a scene as far as they are seen; `None` for those of which nothing is.
pub(super) fn seen(
    scene: &Scene,
    options: &CompactOptions,
    known: &KnownSimplified,
) -> Vec<Option<Arc<Model>>> {
    let seen = |mesh: &SceneMesh, kind: Kind| {
        if Extent(mesh.model.bounds()).sides()[0] < options.least_size {
            return None;
        }
        let Shapes::Boxes { least_width, boxed } = options.shapes else {
            return Some(Arc::clone(&mesh.model));
        };
        let boxed = match kind {
            Kind::Trim => return None,
            Kind::Furniture => boxed,
            Kind::Leaf => f64::INFINITY,
            Kind::Shell => 0.0,
        };
        known.simplified(mesh, &Simplifier { least_size: options.least_size, least_width, boxed })
    };
    scene.meshes.iter().zip(kinds(scene)).map(|(mesh, kind)| seen(mesh, kind)).collect()
}

/// What each mesh is.
fn kinds(scene: &Scene) -> Vec<Kind> {
    let mut kinds = vec![Kind::Shell; scene.meshes.len()];
    mark(&scene.root, &mut kinds);
    kinds
}

fn kind(extras: &Extras) -> Kind {
    match extras {
        Extras::Furniture(_) => Kind::Furniture,
        Extras::Part(part) => match part.part {
            Part::Leaf => Kind::Leaf,
            Part::Skirting | Part::Socket | Part::Switch | Part::Threshold | Part::Frame | Part::Sill => {
                Kind::Trim
            }
            _ => Kind::Shell,
        },
        _ => Kind::Shell,
    }
}

fn mark(node: &Node, kinds: &mut [Kind]) {
    if let Some(mesh) = node.mesh {
        kinds[mesh] = node.extras.as_ref().map_or(Kind::Shell, kind);
    }
    node.children.iter().for_each(|child| mark(child, kinds));
}

/// A box along the axes: its lowest and highest corner.
#[derive(Clone, Copy)]
struct Extent([Vec3; 2]);

impl Extent {
    const EMPTY: Self = Self([Vec3::INFINITY, Vec3::NEG_INFINITY]);

    fn with(self, corner: &[f32; 3]) -> Self {
        let (Self([low, high]), corner) = (self, Vec3::from_array(*corner));
        Self([low.min(corner), high.max(corner)])
    }

    /// Metres, the longest first.
    fn sides(self) -> [f64; 3] {
        let mut sides = (self.0[1] - self.0[0]).as_dvec3().to_array();
        sides.sort_by(|one, other| other.total_cmp(one));
        sides
    }
}

/// Simplifies the primitives of a mesh.
struct Simplifier {
    least_size: f64,
    least_width: f64,
    boxed: f64,
}

/// What becomes of a loose part.
#[derive(Clone, Copy, PartialEq)]
enum Fate {
    Dropped,
    Kept,
    Boxed,
}

impl Simplifier {
    /// A model without what is not seen; `None` if nothing is left.
    fn model(&self, model: &Model) -> Option<Arc<Model>> {
        let primitives: Vec<Primitive> =
            model.primitives.iter().map(|primitive| self.simplified(primitive)).collect();
        primitives.iter().any(|part| !part.indices.is_empty()).then(|| Arc::new(Model { primitives }))
    }

    /// A primitive without its loose parts that are not seen, and without faces that lie on the floor; it may be left without
    /// triangles.
    fn simplified(&self, primitive: &Primitive) -> Primitive {
        let parts = parts(primitive);
        let count = parts.iter().max().map_or(0, |most| most + 1);
        let mut extents = vec![Extent::EMPTY; count];
        for (part, position) in parts.iter().zip(&primitive.positions) {
            extents[*part] = extents[*part].with(position);
        }
        let fates: Vec<Fate> = extents.iter().map(|extent| self.fate(*extent)).collect();
        let kept = primitive.indices.as_chunks::<3>().0.iter().filter(|triangle| {
            fates[parts[triangle[0] as usize]] == Fate::Kept && !is_on_floor(primitive, triangle)
        });
        let mut made = compacted(primitive, kept.flatten().copied().collect());
        let boxed = extents.iter().zip(&fates).filter(|(_, fate)| **fate == Fate::Boxed);
        boxed.for_each(|(extent, _)| add_box(&mut made, *extent));
        made
    }

    fn fate(&self, extent: Extent) -> Fate {
        let [longest, middle, _] = extent.sides();
        if longest < self.least_size || middle < self.least_width {
            Fate::Dropped
        } else if longest <= self.boxed {
            Fate::Boxed
        } else {
            Fate::Kept
        }
    }
}

fn is_on_floor(primitive: &Primitive, triangle: &[u32; 3]) -> bool {
    triangle.iter().all(|&corner| {
        let (position, normal) = (primitive.positions[corner as usize], primitive.normals[corner as usize]);
        position[1].abs() < FLOOR_GAP && normal[1] < FACING_DOWN
    })
}

/// The faces of a box, each by its axis and whether it is at the high end.
const FACES: [(usize, bool); 6] = [(0, false), (0, true), (1, false), (1, true), (2, false), (2, true)];

/// Adds a box, without the face that lies on the floor.
fn add_box(primitive: &mut Primitive, Extent([low, high]): Extent) {
    let has_sets = !primitive.texture_coordinates.is_empty();
    for (axis, is_high) in FACES {
        if axis == 1 && !is_high && low.y.abs() < FLOOR_GAP {
            continue;
        }
        let first = primitive.positions.len() as u32;
        let (across, up) = ((axis + 1) % 3, (axis + 2) % 3);
        // Counter-clockwise from outside: at the low end the other way around.
        let around = [(false, false), (true, false), (true, true), (false, true)];
        let pick = |axis: usize, is_high: bool| if is_high { high[axis] } else { low[axis] };
        for (one, other) in around {
            let mut corner = [0.0; 3];
            corner[axis] = pick(axis, is_high);
            corner[across] = pick(across, one);
            corner[up] = pick(up, other);
            let mut normal = [0.0; 3];
            normal[axis] = if is_high { 1.0 } else { -1.0 };
            primitive.positions.push(corner);
            primitive.normals.push(normal);
        }
        let order = if is_high { [0, 1, 2, 0, 2, 3] } else { [0, 2, 1, 0, 3, 2] };
        primitive.indices.extend(order.map(|corner| first + corner));
    }
    let count = primitive.positions.len();
    if has_sets {
        primitive.texture_coordinates.resize(count, [0.0; 2]);
        primitive.further_coordinates.iter_mut().for_each(|set| set.resize(count, [0.0; 2]));
    }
    if !primitive.colors.is_empty() {
        let last = primitive.colors.last().copied().unwrap_or([1.0; 4]);
        primitive.colors.resize(count, last);
    }
}

/// Metres above the origin of a model below which a face that looks down lies on what the model stands on.
const FLOOR_GAP: f32 = 0.01;
/// The height of the normal of a face that looks down.
const FACING_DOWN: f32 = -0.99;

/// The number of the loose part of each corner: corners in one place, and those of one triangle, are of one part.
fn parts(primitive: &Primitive) -> Vec<usize> {
    let mut first_at: HashMap<[u32; 3], usize> = HashMap::with_capacity(primitive.positions.len());
    let mut above: Vec<usize> = Vec::with_capacity(primitive.positions.len());
    for (corner, position) in primitive.positions.iter().enumerate() {
        above.push(*first_at.entry(position.map(|number| (number + 0.0).to_bits())).or_insert(corner));
    }
    for triangle in primitive.indices.as_chunks::<3>().0 {
        let [a, b, c] = triangle.map(|corner| top(&mut above, corner as usize));
        above[b] = a;
        let c = top(&mut above, c);
        above[c] = a;
    }
    let mut numbers: HashMap<usize, usize> = HashMap::new();
    (0..above.len())
        .map(|corner| {
            let top = top(&mut above, corner);
            let next = numbers.len();
            *numbers.entry(top).or_insert(next)
        })
        .collect()
}

/// The corner that stands for the part of a corner, with shorter ways to it for the next time.
fn top(above: &mut [usize], mut corner: usize) -> usize {
    while above[corner] != corner {
        above[corner] = above[above[corner]];
        corner = above[corner];
    }
    corner
}

/// A primitive of some of its triangles, without the corners that none of them has.
fn compacted(primitive: &Primitive, mut indices: Vec<u32>) -> Primitive {
    let mut new: Vec<Option<u32>> = vec![None; primitive.positions.len()];
    let mut kept: Vec<usize> = Vec::new();
    for index in &mut indices {
        let corner = *index as usize;
        *index = *new[corner].get_or_insert_with(|| {
            kept.push(corner);
            kept.len() as u32 - 1
        });
    }
    fn of<T: Copy>(values: &[T], kept: &[usize]) -> Vec<T> {
        if values.is_empty() { Vec::new() } else { kept.iter().map(|&corner| values[corner]).collect() }
    }
    Primitive {
        material: primitive.material.clone(),
        positions: of(&primitive.positions, &kept),
        normals: of(&primitive.normals, &kept),
        texture_coordinates: of(&primitive.texture_coordinates, &kept),
        further_coordinates: primitive.further_coordinates.iter().map(|set| of(set, &kept)).collect(),
        colors: of(&primitive.colors, &kept),
        indices,
    }
}
