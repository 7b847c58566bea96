//! Decides which meshes become instances and which are merged.
//!
//! A mesh that is drawn once costs nothing when it is merged: its material is drawn anyway. One that is drawn often costs its triangles
//! each time, and as instances only once, but a draw call for each of its primitives. So the meshes that save the most bytes a call
//! become instances, as long as the calls suffice.

use std::collections::{BTreeMap, BTreeSet};

use super::Shown;
use super::listing::Drawn;
use super::merged::{Surface, ordered_surfaces};
use super::options::{CompactOptions, Instancing};
use crate::mesh::Model;

/// About as many bytes as a corner takes with its attributes and its share of the indices.
const BYTES_OF_CORNER: usize = 24;
/// Bytes that one instance takes.
const BYTES_OF_INSTANCE: usize = 44;

/// The meshes that become instances.
pub(super) fn instanced(shown: &Shown<'_>, drawn: &[Drawn], options: &CompactOptions) -> BTreeSet<usize> {
    if options.instancing == Instancing::None {
        return BTreeSet::new();
    }
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    drawn.iter().for_each(|drawn| *counts.entry(drawn.mesh).or_default() += 1);
    // Whatever becomes instances, no more than all surfaces are left to merge.
    let left_over: BTreeSet<Surface> =
        counts.keys().flat_map(|&mesh| ordered_surfaces(shown, mesh)).collect();
    let mut left = options.most_draws.saturating_sub(left_over.len());
    let mut wanted: Vec<(usize, usize, usize)> = counts
        .into_iter()
        .filter_map(|(mesh, count)| {
            let draws = ordered_surfaces(shown, mesh).len().max(1);
            let saved = saved_bytes(shown.models[mesh].as_ref()?, count)?;
            Some((saved / draws, draws, mesh))
        })
        .collect();
    // The most saving first; of equal ones the first of the scene.
    wanted.sort_by_key(|&(saved, _, mesh)| (std::cmp::Reverse(saved), mesh));
    let mut chosen = BTreeSet::new();
    for (_, draws, mesh) in wanted {
        if draws <= left {
            left -= draws;
            chosen.insert(mesh);
        }
    }
    chosen
}

/// Bytes by which instances are shorter than merged copies, if they are.
fn saved_bytes(model: &Model, count: usize) -> Option<usize> {
    let corners: usize = model.primitives.iter().map(|part| part.positions.len()).sum();
    let copies = (count - 1) * corners * BYTES_OF_CORNER;
    copies.checked_sub(count * BYTES_OF_INSTANCE).filter(|&saved| saved > 0)
}
