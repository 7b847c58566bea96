//! Materials, textures and images.

use std::sync::Arc;

use gltf_json::extensions::material::{
    EmissiveStrength, EmissiveStrengthFactor, Transmission, TransmissionFactor,
};
use gltf_json::material as json;
use gltf_json::validation::Checked;
use gltf_json::{Index, extensions, texture};

use super::pack::{Packed, Packer};
use crate::catalog::Material;
use crate::model::{Image, OwnMaterial, Texture, TextureSampler, TextureUse, Transparency};
use crate::scene::SceneMaterial;

/// Glass lets light through.
pub(crate) const TRANSMISSION: &str = "KHR_materials_transmission";
/// Lit lamps are brighter than their colour.
pub(crate) const EMISSIVE_STRENGTH: &str = "KHR_materials_emissive_strength";

/// Images of a document and the textures that lay them on, each once.
#[derive(Debug, Default)]
pub(crate) struct Images {
    /// Those without a file of their own have a place in the buffer.
    known: Vec<(Arc<Image>, Option<Packed>)>,
    textures: Vec<(usize, TextureSampler)>,
}

impl Images {
    /// Images in the order of first use, with their places in the buffer.
    pub(crate) fn all(&self) -> impl ExactSizeIterator<Item = (&Image, Option<&Packed>)> {
        self.known.iter().map(|(image, packed)| (&**image, packed.as_ref()))
    }

    /// Index of the image and sampler of each texture, in the order of first use.
    pub(crate) fn textures(&self) -> &[(usize, TextureSampler)] {
        &self.textures
    }

    fn texture(&mut self, texture: &Texture, packer: &mut Packer) -> Index<texture::Texture> {
        let laid = (self.image(&texture.image, packer), texture.sampler);
        let known = self.textures.iter().position(|other| *other == laid);
        let index = known.unwrap_or_else(|| {
            self.textures.push(laid);
            self.textures.len() - 1
        });
        Index::new(u32::try_from(index).expect("a level has few textures"))
    }

    fn image(&mut self, image: &Arc<Image>, packer: &mut Packer) -> usize {
        let known = self.known.iter().position(|(other, _)| Arc::ptr_eq(image, other) || image == other);
        known.unwrap_or_else(|| {
            let packed = image.uri.is_none().then(|| packer.image(&image.bytes));
            self.known.push((Arc::clone(image), packed));
            self.known.len() - 1
        })
    }
}

/// A material of the scene.
pub(crate) fn material(source: &SceneMaterial, images: &mut Images, packer: &mut Packer) -> json::Material {
    match source {
        SceneMaterial::Slot { name, material, textures } => {
            let mut json = plain(name, material);
            set_textures(&mut json, textures, images, packer);
            json
        }
        SceneMaterial::Own(own) => textured(own, images, packer),
    }
}

fn plain(name: &str, source: &Material) -> json::Material {
    // A whole opacity is needed where light passes by transmission: both together would count twice.
    let is_blended = source.base_color[3] < 1.0;
    json::Material {
        name: Some(name.to_owned()),
        alpha_mode: Checked::Valid(if is_blended { json::AlphaMode::Blend } else { json::AlphaMode::Opaque }),
        pbr_metallic_roughness: json::PbrMetallicRoughness {
            base_color_factor: json::PbrBaseColorFactor(source.base_color),
            metallic_factor: json::StrengthFactor(source.metallic),
            roughness_factor: json::StrengthFactor(source.roughness),
            ..Default::default()
        },
        emissive_factor: json::EmissiveFactor(source.emissive),
        extensions: extensions_of(source),
        ..Default::default()
    }
}

/// The properties that need an extension of the format.
fn extensions_of(source: &Material) -> Option<extensions::material::Material> {
    let transmission = (source.transmission > 0.0).then(|| Transmission {
        transmission_factor: TransmissionFactor(source.transmission),
        ..Default::default()
    });
    let is_brighter = source.emissive_strength != 1.0 && source.emissive != [0.0; 3];
    let emissive_strength = is_brighter
        .then_some(EmissiveStrength { emissive_strength: EmissiveStrengthFactor(source.emissive_strength) });
    let is_used = transmission.is_some() || emissive_strength.is_some();
    is_used.then_some(extensions::material::Material { transmission, emissive_strength })
}

fn textured(own: &OwnMaterial, images: &mut Images, packer: &mut Packer) -> json::Material {
    let mut material = plain(&own.name, &own.material);
    material.double_sided = own.is_double_sided;
    let (mode, cutoff) = match own.transparency {
        Transparency::Opaque => (json::AlphaMode::Opaque, None),
        Transparency::CutOut(cutoff) => (json::AlphaMode::Mask, Some(json::AlphaCutoff(cutoff))),
        Transparency::Blended => (json::AlphaMode::Blend, None),
    };
    (material.alpha_mode, material.alpha_cutoff) = (Checked::Valid(mode), cutoff);
    set_textures(&mut material, &own.textures, images, packer);
    material
}

fn set_textures(
    material: &mut json::Material,
    textures: &[(TextureUse, Texture)],
    images: &mut Images,
    packer: &mut Packer,
) {
    for (purpose, texture) in textures {
        let index = images.texture(texture, packer);
        set_texture(material, *purpose, texture, index);
    }
}

fn set_texture(
    material: &mut json::Material,
    purpose: TextureUse,
    source: &Texture,
    index: Index<texture::Texture>,
) {
    let tex_coord = u32::try_from(source.coordinate_set).expect("there are as many sets as uses at most");
    let (extensions, extras) = (None, None);
    let info = texture::Info { index, tex_coord, extensions: None, extras: None };
    match purpose {
        TextureUse::BaseColor => material.pbr_metallic_roughness.base_color_texture = Some(info),
        TextureUse::MetallicRoughness => {
            material.pbr_metallic_roughness.metallic_roughness_texture = Some(info);
        }
        TextureUse::Emissive => material.emissive_texture = Some(info),
        TextureUse::Normal => {
            let scale = source.strength;
            material.normal_texture =
                Some(json::NormalTexture { index, scale, tex_coord, extensions, extras });
        }
        TextureUse::Occlusion => {
            let (strength, extensions) = (json::StrengthFactor(source.strength), None);
            let texture = json::OcclusionTexture { index, strength, tex_coord, extensions, extras };
            material.occlusion_texture = Some(texture);
        }
    }
}
