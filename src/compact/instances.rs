//! Gathers the instances of each mesh.

use std::collections::BTreeMap;

use super::Shown;
use super::listing::{Drawn, Frame};
use super::merged::{Merged, Surface, merge};

/// A mesh with the places where it stands.
pub(super) struct Instances<'s> {
    /// Index into the meshes of the scene.
    pub(super) mesh: usize,
    /// Its triangles by look, in the frame of the model.
    pub(super) parts: BTreeMap<Surface, Vec<Merged>>,
    /// Where it stands.
    pub(super) drawn: Vec<&'s Drawn>,
}

/// The instances of meshes, in the order of the meshes.
pub(super) fn gather<'s>(shown: &Shown<'_>, drawn: &[&'s Drawn]) -> Vec<Instances<'s>> {
    let mut places: BTreeMap<usize, Vec<&'s Drawn>> = BTreeMap::new();
    drawn.iter().for_each(|drawn| places.entry(drawn.mesh).or_default().push(drawn));
    let gathered = places.into_iter().map(|(mesh, drawn)| {
        let alone = Drawn { mesh, frame: Frame::IDENTITY, feature: 0 };
        let mut parts = merge(shown, &[&alone]);
        parts.values_mut().flatten().for_each(Merged::join_corners);
        Instances { mesh, parts, drawn }
    });
    gathered.collect()
}
