//! Generates the images of surfaces: wood, cloth, tiles and others, as textures that repeat.
//!
//! Later stages may rely on:
//! - every surface of [`crate::catalog::SURFACES`] covers one square metre and repeats without a seam;
//! - its colour is a shade of grey up to white, which multiplies the colour of the palette;
//! - the bytes of its images depend on surface and size alone, on no machine.

mod encode;
mod library;
mod noise;
mod relief;
mod surface;
mod swatches;

pub use library::{TextureLibrary, TextureLocation};
pub use surface::has_relief;

pub(crate) use swatches::{average_shade, swatch_textures};

/// The resolution of textures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub enum TextureSize {
    /// 512 pixels a metre: threads and pores of 2 mm.
    #[default]
    Small,
    /// 1024 pixels a metre.
    Large,
}

impl TextureSize {
    /// Pixels along a metre, and so along an image.
    #[must_use]
    pub fn pixels(self) -> usize {
        match self {
            Self::Small => 512,
            Self::Large => 1024,
        }
    }
}

/// The use of a surface, by which its resolution is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceUse {
    /// Floors, walls and what else belongs to a room: large and near.
    Room,
    /// Nothing but furniture, of which one sees small pieces.
    Furniture,
}
