//! Decides what becomes instances and what is merged.
//!
//! A mesh that is drawn once costs nothing when it is merged: its material is drawn anyway. One that is drawn often costs its triangles
//! each time, and as instances only once, but a draw call for each of its primitives. Boxes of one colour can be instances of one cube,
//! in one draw call whichever meshes they are of. So the meshes and colours that save the most bytes a call become instances, as long
//! as the calls suffice; each choice changes what the others save, which is therefore looked at again after each.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::Shown;
use super::coarse::Seen;
use super::cuboids::{Look, looks, part_looks, standing};
use super::listing::Drawn;
use super::merged::{Surface, ordered_surfaces};
use super::options::{CompactOptions, Instancing};

/// About as many bytes as a corner takes with its attributes and its share of the indices.
const BYTES_OF_CORNER: usize = 24;
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
        Some(candidate)
    });
    let mut choosing = Choosing { candidates: candidates.collect(), ..Choosing::default() };
    choosing.fill(&mut left);
    choosing.improve(left);
    let Choosing { taken, looks, .. } = choosing;
    let meshes: BTreeSet<usize> = taken.into_iter().map(|candidate| candidate.mesh).collect();
    Grouping {
        meshes: twins.into_iter().filter(|(_, first)| meshes.contains(first)).collect(),
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

/// A mesh that is not yet instances.
struct Candidate {
    mesh: usize,
    /// How often it is drawn.
    count: usize,
    draws: usize,
    /// Corners but for those of boxes.
    corners: usize,
    /// Boxes with their numbers of corners.
    boxes: Vec<(Look, usize)>,
}

#[derive(Clone, Copy)]
enum Choice {
    /// Index into the candidates.
    Mesh(usize),
    Look(Look),
}

impl Candidate {
    fn new(shown: &Shown<'_>, mesh: usize, count: usize) -> Option<Self> {
        let Seen { model, cuboids } = shown.models[mesh].as_ref()?;
        let ends = cuboids.iter().enumerate().map(|(index, cuboid)| {
            let next = cuboids.get(index + 1).filter(|next| next.primitive == cuboid.primitive);
            next.map_or(model.primitives[cuboid.primitive].positions.len(), |next| next.first)
        });
        let sizes: Vec<usize> = cuboids.iter().zip(ends).map(|(cuboid, end)| end - cuboid.first).collect();
        let all: usize = model.primitives.iter().map(|part| part.positions.len()).sum();
        let corners = all - sizes.iter().sum::<usize>();
        let boxes = looks(shown, mesh).into_iter().zip(sizes).collect();
        Some(Self { mesh, count, draws: ordered_surfaces(shown, mesh).len().max(1), corners, boxes })
    }

    /// Bytes by which instances are shorter than merged copies, if they are.
    fn saved_bytes(&self, chosen: &BTreeSet<Look>) -> Option<usize> {
        let as_box = |(look, corners): &(Look, usize)| {
            if chosen.contains(look) { BYTES_OF_CUBE } else { corners * BYTES_OF_CORNER }
        };
        let copy = self.corners * BYTES_OF_CORNER + self.boxes.iter().map(as_box).sum::<usize>();
        let corners = self.corners + self.boxes.iter().map(|(_, corners)| corners).sum::<usize>();
        let instances = corners * BYTES_OF_CORNER + self.count * BYTES_OF_INSTANCE;
        (self.count * copy).checked_sub(instances).filter(|&saved| saved > 0)
    }
}

/// A choice under way.
#[derive(Default)]
struct Choosing {
    /// Meshes that are not chosen.
    candidates: Vec<Candidate>,
    /// Those that are.
    taken: Vec<Candidate>,
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

    /// Takes meshes back that save less than something else, since their boxes are instances anyway.
    fn improve(&mut self, mut left: usize) {
        for _ in 0..self.taken.len() {
            let saved = |taken: &Candidate| taken.saved_bytes(&self.looks).unwrap_or(0) / taken.draws;
            let least = (0..self.taken.len()).min_by_key(|&index| saved(&self.taken[index]));
            let Some(least) = least else { return };
            let back = self.taken.remove(least);
            let mesh = back.mesh;
            left += back.draws;
            self.candidates.push(back);
            self.candidates.sort_by_key(|candidate| candidate.mesh);
            self.fill(&mut left);
            if self.taken.iter().any(|candidate| candidate.mesh == mesh) {
                return;
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
        let mut looks: BTreeMap<Look, usize> = BTreeMap::new();
        for (index, candidate) in self.candidates.iter().enumerate() {
            if let Some(saved) = candidate.saved_bytes(&self.looks) {
                look_at(saved, candidate.draws, Choice::Mesh(index));
            }
            for (look, corners) in candidate.boxes.iter().filter(|(look, _)| !self.looks.contains(look)) {
                let saved = (corners * BYTES_OF_CORNER).saturating_sub(BYTES_OF_CUBE);
                *looks.entry(*look).or_default() += candidate.count * saved;
            }
        }
        looks.into_iter().for_each(|(look, saved)| look_at(saved, 1, Choice::Look(look)));
        most.map(|(_, draws, choice)| (draws, choice))
    }

    fn take(&mut self, choice: Choice) {
        match choice {
            Choice::Mesh(index) => self.taken.push(self.candidates.remove(index)),
            Choice::Look(look) => {
                self.looks.insert(look);
            }
        }
    }
}
