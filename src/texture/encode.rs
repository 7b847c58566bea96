//! Pixels to PNG files.

use png::{BitDepth, ColorType, Compression, Encoder, Filter};

/// Encodes pixels of one byte per channel; `channels` is 1 for grey or 3 for red, green and blue.
pub(super) fn png(pixels: &[u8], side: usize, channels: usize) -> Vec<u8> {
    let side = u32::try_from(side).expect("a texture has thousands of pixels at most");
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, side, side);
    encoder.set_color(if channels == 1 { ColorType::Grayscale } else { ColorType::Rgb });
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(Filter::Adaptive);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(pixels));
    written.expect("memory takes all that is written, and the sizes agree");
    bytes
}
