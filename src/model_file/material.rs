//! Materials and images of a user's model.

use std::path::Path;
use std::sync::Arc;

use gltf::json::image::Image as JsonImage;
use gltf::json::material::{AlphaMode, Material as JsonMaterial};
use gltf::json::texture::{Info, Texture as JsonTexture};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};

use super::accessor::Numbers;
use super::container::Container;
use super::laying::{Laying, Layings};
use super::problem::Problem;
use crate::mesh::{Image, Material, OwnMaterial, Texture, TextureSampler, TextureUse, Transparency};

/// The format's own cutoff where the file names none.
const DEFAULT_CUTOFF: f32 = 0.5;

/// A material with the texture coordinates it wants.
#[derive(Clone, Debug)]
pub(super) struct ReadMaterial {
    /// As later stages see it.
    pub(super) material: Arc<OwnMaterial>,
    /// The ways in which its images are laid on, by the numbers of their sets of coordinates.
    pub(super) layings: Vec<Laying>,
}

/// All materials of a document in its order, and last the one of parts that name none.
pub(super) fn read_materials(file: &Path, container: &mut Container) -> Result<Vec<ReadMaterial>, Problem> {
    let stem =
        file.file_stem().map_or_else(|| "model".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let images = read_images(container)?;
    let Container { document, layings, .. } = &*container;
    let named = document.materials.iter().enumerate();
    let mut materials = named
        .map(|(index, material)| {
            let name = material.name.clone().unwrap_or_else(|| format!("{stem}.{index}"));
            let laying = |usage| layings.of(index, usage);
            read_material(name, material, document, &images, &laying)
        })
        .collect::<Result<Vec<_>, _>>()?;
    let plain = |usage| Layings::default().of(0, usage);
    materials.push(read_material(stem, &JsonMaterial::default(), document, &images, &plain)?);
    Ok(materials)
}

fn read_material(
    name: String,
    source: &JsonMaterial,
    document: &Root,
    images: &[Arc<Image>],
    laying: &dyn Fn(TextureUse) -> Laying,
) -> Result<ReadMaterial, Problem> {
    let surface = &source.pbr_metallic_roughness;
    let normal = source.normal_texture.as_ref();
    let occlusion = source.occlusion_texture.as_ref();
    let plain = |info: &Option<Info>| info.as_ref().map(|info| (info.index, 1.0));
    let infos = [
        (TextureUse::BaseColor, plain(&surface.base_color_texture)),
        (TextureUse::MetallicRoughness, plain(&surface.metallic_roughness_texture)),
        (TextureUse::Normal, normal.map(|info| (info.index, info.scale))),
        (TextureUse::Occlusion, occlusion.map(|info| (info.index, info.strength.0))),
        (TextureUse::Emissive, plain(&source.emissive_texture)),
    ];
    let mut textures = Vec::new();
    let mut layings: Vec<Laying> = Vec::new();
    for (usage, (index, strength)) in infos.into_iter().filter_map(|(usage, info)| Some((usage, info?))) {
        let laying = laying(usage);
        let coordinate_set = layings.iter().position(|known| *known == laying).unwrap_or_else(|| {
            layings.push(laying);
            layings.len() - 1
        });
        let is_possible = if usage == TextureUse::Occlusion {
            (0.0..=1.0).contains(&strength)
        } else {
            strength.is_finite()
        };
        if !is_possible {
            return Err(Problem::new(format!("material \"{name}\" has an image of the strength {strength}")));
        }
        let texture = read_texture(index, document, images)?;
        textures.push((usage, Texture { coordinate_set, strength, ..texture }));
    }
    let (opacity, transparency) = read_transparency(source);
    let [red, green, blue, _] = surface.base_color_factor.0;
    let strength = source.extensions.as_ref().and_then(|known| known.emissive_strength.as_ref());
    let transmission = source.extensions.as_ref().and_then(|known| known.transmission.as_ref());
    let material = Material {
        base_color: [red, green, blue, opacity],
        metallic: surface.metallic_factor.0,
        roughness: surface.roughness_factor.0,
        emissive: source.emissive_factor.0,
        emissive_strength: strength.map_or(1.0, |strength| strength.emissive_strength.0),
        transmission: transmission.map_or(0.0, |transmission| transmission.transmission_factor.0),
        texture: None,
        tints: Vec::new(),
    };
    check_factors(&name, &material)?;
    let material =
        OwnMaterial { name, material, is_double_sided: source.double_sided, transparency, textures };
    Ok(ReadMaterial { material: Arc::new(material), layings })
}

/// Opacity and what it means by alpha mode; what is opaque is so whatever its factor says.
fn read_transparency(source: &JsonMaterial) -> (f32, Transparency) {
    let opacity = source.pbr_metallic_roughness.base_color_factor.0[3];
    match source.alpha_mode {
        Checked::Valid(AlphaMode::Mask) => {
            let cutoff = source.alpha_cutoff.map_or(DEFAULT_CUTOFF, |cutoff| cutoff.0);
            (opacity, Transparency::CutOut(cutoff))
        }
        Checked::Valid(AlphaMode::Blend) => (opacity, Transparency::Blended),
        _ => (1.0, Transparency::Opaque),
    }
}

fn check_factors(name: &str, material: &Material) -> Result<(), Problem> {
    let shares = material.base_color.iter().chain(&material.emissive);
    let mut shares = shares.chain([&material.metallic, &material.roughness, &material.transmission]);
    if !(material.emissive_strength.is_finite() && material.emissive_strength >= 0.0) {
        let strength = material.emissive_strength;
        return Err(Problem::new(format!("material \"{name}\" gives off light of the strength {strength}")));
    }
    match shares.find(|share| !(0.0..=1.0).contains(*share)) {
        Some(share) => {
            Err(Problem::new(format!("material \"{name}\" has a factor of {share}, outside 0 to 1")))
        }
        None => Ok(()),
    }
}

fn read_texture(
    index: Index<JsonTexture>,
    document: &Root,
    images: &[Arc<Image>],
) -> Result<Texture, Problem> {
    let no_image = || Problem::new(format!("texture {} has no image", index.value()));
    let texture = document.get(index).ok_or_else(no_image)?;
    let image = images.get(texture.source.value()).cloned().ok_or_else(no_image)?;
    Ok(Texture::plain(image, read_sampler(texture, document)))
}

fn read_sampler(texture: &JsonTexture, document: &Root) -> TextureSampler {
    let Some(sampler) = texture.sampler.and_then(|index| document.get(index)) else {
        return TextureSampler::default();
    };
    TextureSampler {
        wrapping: [sampler.wrap_s, sampler.wrap_t].map(|word| valid(word).unwrap_or_default()),
        magnification: sampler.mag_filter.and_then(valid),
        minification: sampler.min_filter.and_then(valid),
    }
}

fn valid<T>(word: Checked<T>) -> Option<T> {
    match word {
        Checked::Valid(word) => Some(word),
        Checked::Invalid => None,
    }
}

fn read_images(container: &mut Container) -> Result<Vec<Arc<Image>>, Problem> {
    let Container { document, buffers, resources, .. } = container;
    let numbers = Numbers { document, buffers };
    let mut images = Vec::with_capacity(document.images.len());
    for (index, image) in document.images.iter().enumerate() {
        let bytes = match &image.uri {
            Some(uri) => resources.read_uri(uri)?,
            None => embedded(image, &numbers)
                .ok_or_else(|| Problem::new(format!("image {index} has no bytes")))?,
        };
        let mime_type = mime_type(&bytes).ok_or_else(|| {
            Problem::new(format!("image {index} is neither PNG nor JPEG"))
                .with_hint("convert its textures to PNG")
        })?;
        images.push(Arc::new(Image { name: None, mime_type: mime_type.to_owned(), bytes, uri: None }));
    }
    Ok(images)
}

fn embedded(image: &JsonImage, numbers: &Numbers) -> Option<Vec<u8>> {
    numbers.view_bytes(numbers.document.get(image.buffer_view?)?).map(<[u8]>::to_vec)
}

/// The type of an image by its first bytes, whatever the file says of it.
fn mime_type(bytes: &[u8]) -> Option<&'static str> {
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        Some("image/png")
    } else if bytes.starts_with(&[0xff, 0xd8, 0xff]) {
        Some("image/jpeg")
    } else {
        None
    }
}
