//! The colours of images, for files without images: of small ones, such as swatches, the colour at each place; of others their average.

use std::collections::HashMap;
use std::io::Cursor;
use std::sync::{Arc, Mutex, PoisonError};

use png::{ColorType, Decoder, Transformations};

use crate::catalog::srgb_linear;
use crate::gltf::fingerprint;
use crate::mesh::Image;

/// Pixels along a side of the largest image whose colours are looked up.
const LARGEST_LOOKED_UP: u32 = 32;
/// Pixels of the largest image that is decoded.
const LARGEST_DECODED: usize = 64 << 20;

/// The colours of an image: linear, with opacity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ImageColors {
    /// Everywhere the same.
    Average([f32; 4]),
    /// Pixels in rows from the top, so many in each.
    Pixels { across: usize, colors: Vec<[f32; 4]> },
}

impl ImageColors {
    /// The colour at texture coordinates, which repeat.
    pub(super) fn at(&self, [u, v]: [f32; 2]) -> [f32; 4] {
        match self {
            Self::Average(color) => *color,
            Self::Pixels { across, colors } => {
                let down = colors.len() / across;
                let pixel = |place: f32, count: usize| {
                    ((place.rem_euclid(1.0) * count as f32) as usize).min(count - 1)
                };
                colors[pixel(v, down) * across + pixel(u, *across)]
            }
        }
    }
}

/// The colours of an image, if it could be decoded.
type Known = Option<Arc<ImageColors>>;

/// The colours of images that were asked for, each decoded once a run.
#[derive(Debug, Default)]
pub(crate) struct KnownImages {
    /// By length and fingerprint. Nothing is read from it in its own order.
    known: Mutex<HashMap<(usize, u64), Known>>,
}

impl KnownImages {
    /// The colours of an image; `None` where it is no PNG image or is broken.
    pub(super) fn colors(&self, image: &Image) -> Option<Arc<ImageColors>> {
        let key = (image.bytes.len(), fingerprint(&image.bytes));
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known().get(&key).cloned();
        found.unwrap_or_else(|| {
            let made = decode(&image.bytes).map(Arc::new);
            known().insert(key, made.clone());
            made
        })
    }
}

fn decode(bytes: &[u8]) -> Option<ImageColors> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().ok()?;
    let size = reader.output_buffer_size().filter(|&size| size <= LARGEST_DECODED)?;
    let mut pixels = vec![0; size];
    let info = reader.next_frame(&mut pixels).ok()?;
    let channels = info.color_type.samples();
    let color = |pixel: &[u8]| {
        let [red, green, blue] = match info.color_type {
            ColorType::Grayscale | ColorType::GrayscaleAlpha => [pixel[0]; 3],
            _ => [pixel[0], pixel[1], pixel[2]],
        };
        let opacity = match info.color_type {
            ColorType::Rgba | ColorType::GrayscaleAlpha => {
                f32::from(pixel[channels - 1]) / f32::from(u8::MAX)
            }
            _ => 1.0,
        };
        let [red, green, blue] =
            [red, green, blue].map(|channel| srgb_linear(f64::from(channel) / f64::from(u8::MAX)) as f32);
        [red, green, blue, opacity]
    };
    let colors: Vec<[f32; 4]> = pixels[..info.buffer_size()].chunks_exact(channels).map(color).collect();
    if colors.is_empty() {
        return None;
    }
    if info.width <= LARGEST_LOOKED_UP && info.height <= LARGEST_LOOKED_UP {
        return Some(ImageColors::Pixels { across: info.width as usize, colors });
    }
    let sum =
        colors.iter().fold([0.0_f64; 4], |sum, color| [0, 1, 2, 3].map(|at| sum[at] + f64::from(color[at])));
    Some(ImageColors::Average(sum.map(|channel| (channel / colors.len() as f64) as f32)))
}
