//! Lights of lamps: `KHR_lights_punctual`.

use gltf_json::extensions::root::KhrLightsPunctual as Lights;
use gltf_json::extensions::scene;
use gltf_json::extensions::scene::khr_lights_punctual::{KhrLightsPunctual as NodeLight, Light, Type};
use gltf_json::validation::Checked;
use gltf_json::{Index, Root};

use crate::scene::SceneLight;

/// The extension.
pub(crate) const LIGHTS: &str = "KHR_lights_punctual";

/// Lists the lights, if there are any.
pub(crate) fn add_lights(root: &mut Root, lights: &[SceneLight]) {
    if lights.is_empty() {
        return;
    }
    root.extensions.get_or_insert_default().khr_lights_punctual = Some(list(lights));
}

/// The list of lights as JSON.
pub(crate) fn light_list(lights: &[SceneLight]) -> serde_json::Value {
    serde_json::to_value(list(lights)).expect("names are strings and numbers are finite")
}

fn list(lights: &[SceneLight]) -> Lights {
    let light = |source: &SceneLight| Light {
        color: source.color,
        extensions: None,
        extras: None,
        intensity: source.intensity,
        name: Some(source.name.clone()),
        range: None,
        spot: None,
        type_: Checked::Valid(Type::Point),
    };
    Lights { lights: lights.iter().map(light).collect() }
}

/// The light of a node.
pub(crate) fn node_light(index: usize) -> scene::Node {
    let light = Index::new(u32::try_from(index).expect("a level has few kinds of lamps"));
    scene::Node { khr_lights_punctual: Some(NodeLight { light }) }
}
