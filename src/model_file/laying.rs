//! How images are laid on: by which set of texture coordinates, and moved, turned and scaled (`KHR_texture_transform`).
//!
//! Transforms are applied to the coordinates when a model is read, so that no viewer needs the extension.

use serde::Deserialize;

use crate::mesh::TextureUse;

/// The farthest that coordinates may lead from the image, in images; beyond it single precision has no detail left.
const FARTHEST: f32 = 1e5;

/// How one image is laid on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Laying {
    /// The set of texture coordinates in the file.
    pub(super) set: u32,
    transform: Transform,
}

impl Laying {
    /// Where in the image a coordinate leads: scaled, then turned counter-clockwise as one sees it, where `v` grows
    /// downwards, then moved. `None` if that is out of all bounds.
    pub(super) fn apply(&self, [u, v]: [f32; 2]) -> Option<[f32; 2]> {
        let Transform { offset, rotation, scale, .. } = self.transform;
        let (u, v) = (u * scale[0], v * scale[1]);
        let (sine, cosine) = (libm::sinf(rotation), libm::cosf(rotation));
        let found = [cosine * u + sine * v + offset[0], cosine * v - sine * u + offset[1]];
        found.iter().all(|number| number.abs() <= FARTHEST).then_some(found)
    }
}

/// What a document says of its materials' images, beside what the `gltf` crate reads: that knows transforms for some of
/// them only.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Layings {
    materials: Vec<OfMaterial>,
}

impl Layings {
    /// How an image of a material, by its number in the document, is laid on.
    pub(super) fn of(&self, material: usize, usage: TextureUse) -> Laying {
        let info = self.materials.get(material).and_then(|material| material.info(usage));
        let Info { tex_coord, extensions } = info.copied().unwrap_or_default();
        let transform = extensions.transform.unwrap_or_default();
        // The extension's own set is meant for those who know the extension.
        let set = transform.tex_coord.unwrap_or(tex_coord);
        Laying { set, transform: Transform { tex_coord: None, ..transform } }
    }
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct OfMaterial {
    pbr_metallic_roughness: OfSurface,
    normal_texture: Option<Info>,
    occlusion_texture: Option<Info>,
    emissive_texture: Option<Info>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct OfSurface {
    base_color_texture: Option<Info>,
    metallic_roughness_texture: Option<Info>,
}

impl OfMaterial {
    fn info(&self, usage: TextureUse) -> Option<&Info> {
        let surface = &self.pbr_metallic_roughness;
        let info = match usage {
            TextureUse::BaseColor => &surface.base_color_texture,
            TextureUse::MetallicRoughness => &surface.metallic_roughness_texture,
            TextureUse::Normal => &self.normal_texture,
            TextureUse::Occlusion => &self.occlusion_texture,
            TextureUse::Emissive => &self.emissive_texture,
        };
        info.as_ref()
    }
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Info {
    tex_coord: u32,
    extensions: Extensions,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default)]
struct Extensions {
    #[serde(rename = "KHR_texture_transform")]
    transform: Option<Transform>,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Transform {
    offset: [f32; 2],
    rotation: f32,
    scale: [f32; 2],
    tex_coord: Option<u32>,
}

impl Default for Transform {
    fn default() -> Self {
        Self { offset: [0.0; 2], rotation: 0.0, scale: [1.0; 2], tex_coord: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laying(transform: serde_json::Value) -> Laying {
        let info = serde_json::json!({"index": 0, "extensions": {"KHR_texture_transform": transform}});
        let document = serde_json::json!({"materials": [{"emissiveTexture": info}]});
        let layings: Layings = serde_json::from_value(document).unwrap();
        layings.of(0, TextureUse::Emissive)
    }

    /// The extension's own examples: a quarter of the image, turned, and an image with its origin at the bottom.
    #[test]
    fn the_examples_of_the_specification_hold() {
        let quarter = laying(serde_json::json!({
            "offset": [0, 1], "rotation": std::f32::consts::FRAC_PI_2, "scale": [0.5, 0.5]
        }));
        for (corner, wanted) in [([0.0, 0.0], [0.0, 1.0]), ([1.0, 0.0], [0.0, 0.5]), ([1.0, 1.0], [0.5, 0.5])]
        {
            let found = quarter.apply(corner).unwrap();
            assert!((0..2).all(|axis| (found[axis] - wanted[axis]).abs() < 1e-6), "{corner:?} {found:?}");
        }
        let upright = laying(serde_json::json!({"offset": [0, 1], "scale": [1, -1]}));
        assert_eq!(upright.apply([0.25, 0.25]), Some([0.25, 0.75]));
    }

    #[test]
    fn the_extension_may_name_another_set_and_absurd_transforms_lead_nowhere() {
        assert_eq!(laying(serde_json::json!({"texCoord": 3})).set, 3);
        assert_eq!(
            laying(serde_json::json!({"texCoord": 3})),
            Laying { set: 3, transform: Transform::default() }
        );
        assert_eq!(laying(serde_json::json!({"scale": [1e30, 1]})).apply([1.0, 0.0]), None);
    }
}
