//! Collects parts by material and makes the model.

use std::collections::BTreeMap;

use glam::DVec3;

use super::mend::mended;
use super::normals::corner_normals;
use super::projection::Projection;
use super::reduce::reduced;
use super::{Bay, Shading, Solid, THINNEST, cuboid, rounded_box};
use crate::geometry::Size;
use crate::recipes::Slot;
use crate::recipes::mesh::{Mesh, MeshPart};

/// Collects the parts of a model.
#[derive(Clone, Debug)]
pub(crate) struct Builder {
    bay: Bay,
    parts: Vec<Part>,
}

#[derive(Clone, Debug)]
struct Part {
    slot: Slot,
    solid: Solid,
}

/// The slot of the box that replaces a model of which nothing thick enough remains.
const PLAIN_SLOT: Slot = Slot::Painted;

impl Builder {
    /// For a box of this size.
    pub(crate) fn new(size: Size) -> Self {
        Self { bay: Bay::of_size(size), parts: Vec::new() }
    }

    /// The whole box.
    pub(crate) fn bay(&self) -> Bay {
        self.bay
    }

    /// Adds a closed solid of a material slot.
    pub(crate) fn add(&mut self, slot: Slot, solid: Solid) {
        self.parts.push(Part { slot, solid });
    }

    /// Adds a solid and its mirror image in x.
    pub(crate) fn add_pair(&mut self, slot: Slot, solid: Solid) {
        self.add(slot, solid.clone().mirrored());
        self.add(slot, solid);
    }

    /// Adds a box with sharp edges; one too thin to be seen is left out.
    pub(crate) fn cuboid(&mut self, slot: Slot, bay: Bay) {
        if bay.extent().min_element() > THINNEST {
            self.add(slot, cuboid(bay));
        }
    }

    /// Adds a box with chamfered edges, `edge` metres wide.
    pub(crate) fn block(&mut self, slot: Slot, bay: Bay, edge: f64) {
        self.rounded(slot, bay, DVec3::splat(edge), 1);
    }

    /// Adds a soft box, rounded by `radius` metres in two segments.
    pub(crate) fn cushion(&mut self, slot: Slot, bay: Bay, radius: f64) {
        self.rounded(slot, bay, DVec3::splat(radius), 2);
    }

    /// Adds a rounded box; one too thin to be seen is left out, one too thin to be rounded is sharp.
    pub(crate) fn rounded(&mut self, slot: Slot, bay: Bay, radii: DVec3, segments: usize) {
        if bay.extent().min_element() > THINNEST {
            let is_roundable = radii.min(bay.extent()).min_element() > THINNEST;
            self.add(slot, if is_roundable { rounded_box(bay, radii, segments) } else { cuboid(bay) });
        }
    }

    /// Another builder for the same box.
    pub(crate) fn empty(&self) -> Self {
        Self { bay: self.bay, parts: Vec::new() }
    }

    /// The parts collected so far by slot, to be placed in another builder.
    pub(crate) fn into_parts(self) -> impl Iterator<Item = (Slot, Solid)> {
        self.parts.into_iter().map(|part| (part.slot, part.solid))
    }

    /// The model: fitted to a box of this size, one primitive for each slot in the order of first use.
    pub(crate) fn finish(mut self, size: Size) -> Mesh {
        self.settle(size);
        self.assemble()
    }

    /// The model with at most this share of its triangles, as far as its parts allow.
    pub(crate) fn finish_reduced(mut self, size: Size, share: f64) -> Mesh {
        self.settle(size);
        let slots: Vec<Slot> = self.parts.iter().map(|part| part.slot).collect();
        let solids: Vec<Solid> = self.parts.into_iter().map(|part| part.solid).collect();
        let count: usize = solids.iter().map(|solid| solid.triangles.len()).sum();
        let target = (count as f64 * share) as usize;
        let solids = reduced(solids, Bay::of_size(size).extent().length(), target).into_iter().zip(slots);
        let parts = solids.filter_map(|(solid, slot)| Some(Part { slot, solid: solid? })).collect();
        // Corners that went may have been the outermost ones.
        Self { bay: self.bay, parts }.finish(size)
    }

    /// The model of a single solid where it is, in the plain slot.
    pub(crate) fn unfitted(solid: Solid) -> Mesh {
        let (low, high) = solid.bounds();
        Self { bay: Bay { low, high }, parts: vec![Part { slot: PLAIN_SLOT, solid }] }.assemble()
    }

    /// Drops what is empty or too thin, sees to it that something is there, and fits it to the box.
    fn settle(&mut self, size: Size) {
        self.parts.retain(|part| !part.solid.triangles.is_empty());
        loop {
            if self.parts.is_empty() {
                self.add(PLAIN_SLOT, cuboid(self.bay));
            }
            self.fit(Bay::of_size(size));
            let count = self.parts.len();
            let mend = |Part { slot, solid }| Some(Part { slot, solid: mended(solid)? });
            self.parts = std::mem::take(&mut self.parts).into_iter().filter_map(mend).collect();
            // Without a part, the rest may no longer touch all sides.
            if self.parts.len() == count {
                return;
            }
        }
    }

    fn assemble(self) -> Mesh {
        let mut parts: Vec<MeshPart> = Vec::new();
        let mut counts: Vec<usize> = Vec::new();
        for Part { slot, solid } in &self.parts {
            let index = parts.iter().position(|part| part.slot == *slot).unwrap_or_else(|| {
                parts.push(MeshPart::empty(*slot));
                parts.len() - 1
            });
            counts.resize(parts.len(), 0);
            append(&mut parts[index], solid, &Projection::of_part(solid, counts[index]));
            counts[index] += 1;
        }
        Mesh { parts }
    }

    /// How many parts, as built, are too flat to be written as they are.
    pub(crate) fn flat_count(&self) -> usize {
        self.parts.iter().filter(|part| mended(part.solid.clone()).as_ref() != Some(&part.solid)).count()
    }

    /// How far the parts, as built, are from touching the six sides of the box, in metres.
    pub(crate) fn misfit(&self) -> f64 {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let bounds = self.parts.iter().map(|part| part.solid.bounds());
        let (low, high) = bounds.fold(start, |a, b| (a.0.min(b.0), a.1.max(b.1)));
        (low - self.bay.low).abs().max_element().max((high - self.bay.high).abs().max_element())
    }

    /// Moves and stretches all parts together so that they touch every side of `bay`. Recipes build to
    /// size; this evens out the last millimetres of turned, bent and sampled parts (a circle of ten corners, a
    /// leaf).
    fn fit(&mut self, bay: Bay) {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let bounds = self.parts.iter().map(|part| part.solid.bounds());
        let (low, high) = bounds.fold(start, |a, b| (a.0.min(b.0), a.1.max(b.1)));
        let by = bay.extent() / (high - low).max(DVec3::splat(THINNEST));
        let to = bay.low;
        for part in &mut self.parts {
            let empty = Solid { points: Vec::new(), triangles: Vec::new(), shading: Shading::FLAT };
            let solid = std::mem::replace(&mut part.solid, empty).moved(-low.x, -low.y, -low.z);
            part.solid = solid.stretched(by).moved(to.x, to.y, to.z);
        }
    }
}

/// Normals closer than this are one, so that corners can be shared.
const NORMAL_STEPS: f64 = 1024.0;

/// Adds a solid's triangles; corners with equal position, normal and projection become one.
fn append(part: &mut MeshPart, solid: &Solid, projection: &Projection) {
    let mut known: BTreeMap<(usize, [i32; 3], usize), u32> = BTreeMap::new();
    for (triangle, normals) in solid.triangles.iter().zip(corner_normals(solid)) {
        let axis = Projection::axis(normals.iter().sum());
        for (&point, normal) in triangle.iter().zip(normals) {
            let key = (point, (normal * NORMAL_STEPS).round().to_array().map(|step| step as i32), axis);
            let index = *known.entry(key).or_insert_with(|| {
                let coordinates = projection.coordinates(solid.points[point], axis);
                part.positions.push(solid.points[point].as_vec3().to_array());
                part.texture_coordinates.push(coordinates.as_vec2().to_array());
                part.normals.push(normal.as_vec3().normalize().to_array());
                u32::try_from(part.positions.len() - 1).expect("recipes stay within thousands of corners")
            });
            part.indices.push(index);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size { width: 1.0, depth: 0.5, height: 0.8 };

    #[test]
    fn a_box_keeps_four_corners_a_face() {
        let mut builder = Builder::new(SIZE);
        builder.cuboid(Slot::Wood, builder.bay());
        let model = builder.finish(SIZE);
        assert_eq!(model.parts[0].positions.len(), 24);
        assert_eq!(model.parts[0].indices.len(), 36);
    }

    #[test]
    fn parts_of_one_slot_become_one_primitive() {
        let mut builder = Builder::new(SIZE);
        let halves = builder.bay().columns(2, 0.1);
        builder.cuboid(Slot::Wood, halves[0]);
        builder.cuboid(Slot::Metal, builder.bay().inset(0.3, 0.3, 0.1));
        builder.cuboid(Slot::Wood, halves[1]);
        let model = builder.finish(SIZE);
        let slots: Vec<_> = model.parts.iter().map(|part| part.slot).collect();
        assert_eq!(slots, [Slot::Wood, Slot::Metal]);
    }

    #[test]
    fn what_is_a_little_off_is_fitted_to_the_box() {
        let mut builder = Builder::new(SIZE);
        builder.cuboid(Slot::Wood, builder.bay().inset(0.01, 0.0, 0.02).moved(0.0, 0.01, 0.0));
        assert!(builder.misfit() > 0.009);
        let positions = &builder.finish(SIZE).parts[0].positions;
        let high =
            positions.iter().fold([f32::MIN; 3], |high, p| [0, 1, 2].map(|axis| high[axis].max(p[axis])));
        assert_eq!(high, [0.5, 0.8, 0.25]);
    }

    #[test]
    fn nothing_at_all_becomes_the_plain_box() {
        let mut builder = Builder::new(SIZE);
        builder.cuboid(Slot::Wood, Bay::new([0.0, 0.0], [0.0, 1.0], [0.0, 1.0]));
        assert_eq!(builder.finish(SIZE).parts[0].indices.len(), 36);
    }
}
