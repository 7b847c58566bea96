//! The box around all that a scene shows.

use glam::{Affine3A, DVec3, Vec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axes::plan_point;
use super::node::{Node, Scene};

/// The box around all that a level shows, in the frame of its building: metres, x east, y north, z up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LevelBounds {
    /// The level's floor above the building's zero.
    pub elevation: f64,
    /// The lowest corner.
    pub low: [f64; 3],
    /// The highest corner.
    pub high: [f64; 3],
}

/// Boxes end at whole parts of a metre, outside of all that they hold.
const PARTS: f64 = 1000.0;

impl LevelBounds {
    /// The box of a scene; `None` where it shows nothing.
    pub(crate) fn of(scene: &Scene, elevation: f64) -> Option<Self> {
        let boxes: Vec<[Vec3; 2]> = scene.meshes.iter().map(|mesh| mesh.model.bounds()).collect();
        let mut found = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        add(&scene.root, Affine3A::IDENTITY, &boxes, &mut found);
        let [low, high] = found;
        let rise = DVec3::new(0.0, 0.0, elevation);
        // Half a millimetre for formats that round.
        let down = ((low + rise) * PARTS - 0.5).floor() / PARTS;
        let up = ((high + rise) * PARTS + 0.5).ceil() / PARTS;
        low.is_finite().then(|| Self { elevation, low: down.to_array(), high: up.to_array() })
    }
}

fn add(node: &Node, parent: Affine3A, boxes: &[[Vec3; 2]], found: &mut [DVec3; 2]) {
    let frame = parent * Affine3A::from_rotation_translation(node.rotation, node.translation);
    if let Some([low, high]) = node.mesh.map(|mesh| boxes[mesh]) {
        for corner in 0..8 {
            let pick = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
            let place = frame.transform_point3(Vec3::new(pick(0), pick(1), pick(2)));
            let place = plan_point(place.as_dvec3());
            *found = [found[0].min(place), found[1].max(place)];
        }
    }
    node.children.iter().for_each(|child| add(child, frame, boxes, found));
}
