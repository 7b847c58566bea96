//! Lists what a scene draws: each mesh at its place in the level, with its feature.

use std::cell::Cell;

use glam::{DQuat, DVec3};

use super::Shown;
use super::feature::{Above, Feature};
use crate::scene::Node;

/// A place in the level: metres, Y up. Scenes have no scales.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) rotation: DQuat,
    pub(super) translation: DVec3,
}

impl Frame {
    pub(super) const IDENTITY: Self = Self { rotation: DQuat::IDENTITY, translation: DVec3::ZERO };

    fn below(&self, node: &Node) -> Self {
        let translation = self.point(node.translation.as_dvec3());
        Self { rotation: (self.rotation * node.rotation.as_dquat()).normalize(), translation }
    }

    /// A point in the frame as one of the level.
    pub(super) fn point(&self, point: DVec3) -> DVec3 {
        self.rotation * point + self.translation
    }
}

/// A mesh at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drawn {
    /// Index into the meshes of the scene.
    pub(super) mesh: usize,
    pub(super) frame: Frame,
    /// Index into [`Listing::features`].
    pub(super) feature: usize,
}

/// All that is drawn, in the order of the nodes.
pub(super) struct Listing {
    pub(super) drawn: Vec<Drawn>,
    /// Those that something is drawn of.
    pub(super) features: Vec<Feature>,
}

impl Listing {
    /// Lists the meshes of a scene that are seen.
    pub(super) fn new(shown: &Shown<'_>) -> Self {
        let is_seen = shown.models.iter().map(Option::is_some);
        let mut walk =
            Walk { is_seen: is_seen.collect(), found: Self { drawn: Vec::new(), features: Vec::new() } };
        walk.node(&shown.scene.root, Frame::IDENTITY, Above::default(), None);
        walk.found
    }
}

struct Walk {
    /// By mesh.
    is_seen: Vec<bool>,
    found: Listing,
}

impl Walk {
    /// A node and all below it; `begun` is the feature of the node above.
    fn node<'s>(&mut self, node: &'s Node, parent: Frame, above: Above<'s>, begun: Option<&Begun>) {
        let frame = parent.below(node);
        let own = above.feature(node.extras.as_ref());
        let own = own.map(|feature| Begun { index: Cell::new(None), feature });
        let feature = own.as_ref().or(begun);
        if let Some((mesh, feature)) = node.mesh.filter(|&mesh| self.is_seen[mesh]).zip(feature) {
            let index = feature.index.get().unwrap_or_else(|| {
                self.found.features.push(feature.feature.clone());
                self.found.features.len() - 1
            });
            feature.index.set(Some(index));
            self.found.drawn.push(Drawn { mesh, frame, feature: index });
        }
        let below = above.below(node.extras.as_ref());
        node.children.iter().for_each(|child| self.node(child, frame, below, feature));
    }
}

/// A feature that a node begins; it gets its index when something of it is drawn.
struct Begun {
    index: Cell<Option<usize>>,
    feature: Feature,
}
