//! Decides what becomes instances and what is merged.
//!
//! A mesh that is drawn once costs nothing when it is merged: its material is drawn anyway. One that is drawn often costs its triangles
//! each time, and as instances only once, but a draw call for each of its primitives. Boxes of one colour can be instances of one cube,
//! in one draw call whichever meshes they are of. So the meshes and colours that save the most bytes a call become instances, as long
//! as the calls suffice; each choice changes what the others save, which is therefore looked at again after each.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::sync::Arc;

use super::Shown;
use super::coarse::{Cuboid, Seen};
use super::cuboids::{Look, looks, part_looks, standing};
use super::listing::Drawn;
use super::merged::{Surface, ordered_surfaces};
use super::options::{CompactOptions, Instancing};
use crate::mesh::Primitive;

/// About as many bytes as a corner takes with its attributes.
const BYTES_OF_CORNER: usize = 20;
/// Bytes of most indices.
const BYTES_OF_INDEX: usize = 2;
/// Bytes that one instance takes.
const BYTES_OF_INSTANCE: usize = 22;
/// Bytes that a box takes as an instance: most have no rotation.
const BYTES_OF_CUBE: usize = 28;

/// What becomes instances.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Grouping {
    /// Meshes, as a whole, and those whose instances they are: of one model, in looks alike.
    pub(super) meshes: BTreeMap<usize, usize>,
    /// The looks of boxes of all other meshes, and those that stand for them.
    pub(super) looks: BTreeMap<Look, Look>,
}

/// Chooses what becomes instances.
pub(super) fn choose(shown: &Shown<'_>, drawn: &[Drawn], options: &CompactOptions) -> Grouping {
    if options.instancing == Instancing::None {
        return Grouping::default();
    }
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    drawn.iter().for_each(|drawn| *counts.entry(drawn.mesh).or_default() += 1);
    // Whatever becomes instances, no more than all surfaces are left to merge.
    let left_over: BTreeSet<Surface> =
        counts.keys().flat_map(|&mesh| ordered_surfaces(shown, mesh)).collect();
    let mut left = options.most_draws.saturating_sub(left_over.len());
    let standing = standing(&look_counts(shown, &counts));
    let twins = twins(shown, &counts, &standing);
    let mut twin_counts: BTreeMap<usize, usize> = BTreeMap::new();
    counts.iter().for_each(|(mesh, count)| *twin_counts.entry(twins[mesh]).or_default() += count);
    let candidates = twin_counts.into_iter().filter_map(|(mesh, count)| {
        let mut candidate = Candidate::new(shown, mesh, count)?;
        candidate.boxes.iter_mut().for_each(|(look, _)| *look = standing[look]);
        Some((mesh, candidate))
    });
    let mut choosing = Choosing { candidates: candidates.collect(), ..Choosing::default() };
    choosing.fill(&mut left);
    choosing.improve(left);
    let Choosing { taken, looks, .. } = choosing;
    Grouping {
        meshes: twins.into_iter().filter(|(_, first)| taken.contains_key(first)).collect(),
        looks: standing.into_iter().filter(|(_, leader)| looks.contains(leader)).collect(),
    }
}

/// How often each look of a box or of a part of a mesh is drawn.
fn look_counts(shown: &Shown<'_>, counts: &BTreeMap<usize, usize>) -> BTreeMap<Look, usize> {
    let mut found: BTreeMap<Look, usize> = BTreeMap::new();
    for (&mesh, count) in counts {
        let of_parts = part_looks(shown, mesh).into_iter().flatten();
        let all = looks(shown, mesh).into_iter().chain(of_parts);
        all.for_each(|look| *found.entry(look).or_default() += count);
    }
    found
}

/// For each mesh the first of the same model in looks alike, which may be the mesh itself.
fn twins(
    shown: &Shown<'_>,
    counts: &BTreeMap<usize, usize>,
    standing: &BTreeMap<Look, Look>,
) -> BTreeMap<usize, usize> {
    // By where a model is in memory: nothing is read from it in its own order.
    let mut first: BTreeMap<(usize, Vec<Look>), usize> = BTreeMap::new();
    let twin = |&mesh: &usize| {
        let Some((seen, looks)) = shown.models[mesh].as_ref().zip(part_looks(shown, mesh)) else {
            return (mesh, mesh);
        };
        let looks = looks.into_iter().map(|look| standing[&look]).collect();
        (mesh, *first.entry((Arc::as_ptr(&seen.model).addr(), looks)).or_insert(mesh))
    };
    counts.keys().map(twin).collect()
}

/// A mesh that may become instances.
struct Candidate {
    /// How often it is drawn.
    count: usize,
    draws: usize,
    /// Bytes of it but for its boxes.
    bytes: usize,
    /// Boxes with the bytes of each.
    boxes: Vec<(Look, usize)>,
}

/// Something that becomes instances.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Choice {
    /// Index into the meshes of the scene.
    Mesh(usize),
    Look(Look),
}

impl Candidate {
    fn new(shown: &Shown<'_>, mesh: usize, count: usize) -> Option<Self> {
        let Seen { model, cuboids } = shown.models[mesh].as_ref()?;
        let of_boxes = |(number, primitive): (usize, &Primitive)| {
            let ends = cuboids.iter().filter(|cuboid| cuboid.primitive == number).map(|cuboid| cuboid.first);
            let ends: Vec<usize> = ends.chain([primitive.positions.len()]).collect();
            ends.windows(2).map(|ends| bytes_of_faces(ends[1] - ends[0])).collect::<Vec<_>>()
        };
        let sizes: Vec<usize> = model.primitives.iter().enumerate().flat_map(of_boxes).collect();
        let others = model.primitives.iter().enumerate();
        let bytes = others.map(|(number, primitive)| bytes_without_boxes(primitive, number, cuboids)).sum();
        let boxes = looks(shown, mesh).into_iter().zip(sizes).collect();
        Some(Self { count, draws: ordered_surfaces(shown, mesh).len().max(1), bytes, boxes })
    }

    /// Bytes by which instances are shorter than merged copies, if they are.
    fn saved_bytes(&self, chosen: &BTreeSet<Look>) -> Option<usize> {
        let as_box =
            |(look, bytes): &(Look, usize)| if chosen.contains(look) { BYTES_OF_CUBE } else { *bytes };
        let copy = self.bytes + self.boxes.iter().map(as_box).sum::<usize>();
        let model = self.bytes + self.boxes.iter().map(|(_, bytes)| bytes).sum::<usize>();
        let instances = model + self.count * BYTES_OF_INSTANCE;
        (self.count * copy).checked_sub(instances).filter(|&saved| saved > 0)
    }
}

/// Bytes of rectangles with so many corners.
fn bytes_of_faces(corners: usize) -> usize {
    corners * BYTES_OF_CORNER + corners / 4 * 6 * BYTES_OF_INDEX
}

/// Bytes of a primitive without the boxes at its end. Corners that agree in everything will be one.
fn bytes_without_boxes(primitive: &Primitive, number: usize, cuboids: &[Cuboid]) -> usize {
    let first_box = cuboids.iter().find(|cuboid| cuboid.primitive == number).map(|cuboid| cuboid.first);
    let end = first_box.unwrap_or(primitive.positions.len());
    let different: HashSet<[u32; 8]> = (0..end)
        .map(|corner| {
            let [x, y, z] = primitive.positions[corner].map(f32::to_bits);
            let [i, j, k] = primitive.normals[corner].map(f32::to_bits);
            let [u, v] = primitive.texture_coordinates.get(corner).copied().unwrap_or_default();
            [x, y, z, i, j, k, u.to_bits(), v.to_bits()]
        })
        .collect();
    let indices = primitive.indices.iter().filter(|&&index| (index as usize) < end).count();
    different.len() * BYTES_OF_CORNER + indices * BYTES_OF_INDEX
}

/// A choice under way. Meshes are in the order of the scene.
#[derive(Default)]
struct Choosing {
    /// Meshes that are not chosen.
    candidates: BTreeMap<usize, Candidate>,
    /// Those that are.
    taken: BTreeMap<usize, Candidate>,
    /// Looks that stand for others.
    looks: BTreeSet<Look>,
}

impl Choosing {
    /// Chooses as long as the calls suffice.
    fn fill(&mut self, left: &mut usize) {
        while let Some((draws, choice)) = self.best(*left) {
            *left -= draws;
            self.take(choice);
        }
    }

    /// Takes back what saves less than something else, now that all is chosen: the boxes of a mesh may be instances anyway, and those of
    /// a look may be of meshes that are instances themselves.
    fn improve(&mut self, mut left: usize) {
        let mut kept = BTreeSet::new();
        for _ in 0..self.taken.len() + self.looks.len() {
            let Some(least) = self.least(&kept) else { return };
            left += self.take_back(least);
            self.fill(&mut left);
            if self.has(least) {
                kept.insert(least);
            }
        }
    }

    /// What saves the most bytes a draw call, within so many calls: its calls, and what it is. Of equal ones the first mesh of the
    /// scene.
    fn best(&self, left: usize) -> Option<(usize, Choice)> {
        let mut most: Option<(usize, usize, Choice)> = None;
        let mut look_at = |saved: usize, draws: usize, choice: Choice| {
            if draws <= left && saved > 0 && most.is_none_or(|(known, _, _)| saved / draws > known) {
                most = Some((saved / draws, draws, choice));
            }
        };
        for (&mesh, candidate) in &self.candidates {
            if let Some(saved) = candidate.saved_bytes(&self.looks) {
                look_at(saved, candidate.draws, Choice::Mesh(mesh));
            }
        }
        let looks = self.saved_by_looks(|look| !self.looks.contains(look));
        looks.into_iter().for_each(|(look, saved)| look_at(saved, 1, Choice::Look(look)));
        most.map(|(_, draws, choice)| (draws, choice))
    }

    /// What is chosen and saves the fewest bytes a draw call, but for some.
    fn least(&self, but_for: &BTreeSet<Choice>) -> Option<Choice> {
        let meshes = self.taken.iter().map(|(&mesh, candidate)| {
            (candidate.saved_bytes(&self.looks).unwrap_or(0) / candidate.draws, Choice::Mesh(mesh))
        });
        let saved = self.saved_by_looks(|look| self.looks.contains(look));
        let looks =
            self.looks.iter().map(|look| (saved.get(look).copied().unwrap_or(0), Choice::Look(*look)));
        let movable = meshes.chain(looks).filter(|(_, choice)| !but_for.contains(choice));
        movable.min().map(|(_, choice)| choice)
    }

    /// The bytes that some looks save, as the meshes are chosen.
    fn saved_by_looks(&self, is_asked: impl Fn(&Look) -> bool) -> BTreeMap<Look, usize> {
        let mut found: BTreeMap<Look, usize> = BTreeMap::new();
        for candidate in self.candidates.values() {
            for (look, bytes) in candidate.boxes.iter().filter(|(look, _)| is_asked(look)) {
                let saved = bytes.saturating_sub(BYTES_OF_CUBE);
                *found.entry(*look).or_default() += candidate.count * saved;
            }
        }
        found
    }

    fn has(&self, choice: Choice) -> bool {
        match choice {
            Choice::Mesh(mesh) => self.taken.contains_key(&mesh),
            Choice::Look(look) => self.looks.contains(&look),
        }
    }

    fn take(&mut self, choice: Choice) {
        match choice {
            Choice::Mesh(mesh) => self.taken.extend(self.candidates.remove_entry(&mesh)),
            Choice::Look(look) => {
                self.looks.insert(look);
            }
        }
    }

    /// Gives the calls that are free again.
    fn take_back(&mut self, choice: Choice) -> usize {
        match choice {
            Choice::Mesh(mesh) => {
                let back = self.taken.remove_entry(&mesh);
                let draws = back.as_ref().map_or(0, |(_, candidate)| candidate.draws);
                self.candidates.extend(back);
                draws
            }
            Choice::Look(look) => usize::from(self.looks.remove(&look)),
        }
    }
}
