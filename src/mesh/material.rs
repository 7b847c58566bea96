//! The look of a surface.

/// A glTF metallic-roughness material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Linear red, green, blue and opacity, each 0 to 1.
    pub base_color: [f32; 4],
    /// 0 for everything but bare metal.
    pub metallic: f32,
    /// 0 a mirror, 1 chalk.
    pub roughness: f32,
    /// Linear light given off, each 0 to 1.
    pub emissive: [f32; 3],
    /// Multiplies the light given off where lamps are lit (`KHR_materials_emissive_strength`), from 0 on.
    pub emissive_strength: f32,
    /// Share of light that passes (`KHR_materials_transmission`); 0 for what is not glass.
    pub transmission: f32,
    /// The surface whose textures lie on it, a word of `texture:`.
    pub texture: Option<&'static str>,
    /// Further base colours, linear; an object of the palette has one of all, by seed.
    pub tints: Vec<[f32; 4]>,
}
