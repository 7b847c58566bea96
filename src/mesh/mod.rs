//! Furniture as triangles with materials, whatever it is made from: the types that recipes' models and users' models share.

mod material;
mod model;

pub use material::Material;
pub(crate) use model::coordinate_set_count;
pub use model::{
    Image, Model, ModelMaterial, OwnMaterial, Primitive, Texture, TextureSampler, TextureUse, Transparency,
};
