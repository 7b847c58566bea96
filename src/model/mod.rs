//! Makes the model of a class and variant, a mesh with materials: from the recipe of the class, or from a user's glTF.
//!
//! Later stages may rely on this: a [`ModelLibrary`] gives a [`Model`] for every class, variant and geometry set;
//! the model's box is the class's box to 1 mm, its normals are unit vectors, its indices are valid, and equal
//! requests give the same [`std::sync::Arc`].

mod detail;
mod library;
mod reduce;
mod stand_in;
mod swatches;

pub use crate::mesh::{
    Image, Model, ModelMaterial, OwnMaterial, Primitive, Texture, TextureSampler, TextureUse, Transparency,
};
pub use detail::Detail;
pub use library::ModelLibrary;
pub(crate) use reduce::reduced;
pub(crate) use stand_in::stand_in;
pub use stand_in::{distance_outside, prisms_of};
pub(crate) use swatches::SWATCHES_PER_SIDE;
pub use swatches::SwatchedModels;
