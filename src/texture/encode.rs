//! Encodes pixels as PNG files.

use png::{BitDepth, ColorType, Compression, Encoder, Filter};

/// Pixels as they go into a file.
struct Layout {
    color: ColorType,
    depth: BitDepth,
    /// Red, green, blue of each entry; empty without a palette.
    palette: Vec<u8>,
    filter: Filter,
    bytes: Vec<u8>,
}

/// The most colours that an entry of one byte can name.
const MOST_ENTRIES: usize = 256;

/// Encodes pixels of one byte per channel; `channels` is 1 for grey or 3 for red, green and blue.
///
/// Images of few colours, as quantized normals and roughness are, get a palette wherever that takes fewer bits: nothing
/// is lost, and the fewer bytes there are, the faster they are compressed, which is half of the painting.
pub(super) fn png(pixels: &[u8], side: usize, channels: usize) -> Vec<u8> {
    let layout = indexed(pixels, side, channels).unwrap_or_else(|| direct(pixels, channels));
    let side = u32::try_from(side).expect("a texture has thousands of pixels at most");
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, side, side);
    encoder.set_color(layout.color);
    encoder.set_depth(layout.depth);
    encoder.set_compression(Compression::Balanced);
    encoder.set_filter(layout.filter);
    if !layout.palette.is_empty() {
        encoder.set_palette(layout.palette);
    }
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&layout.bytes));
    written.expect("memory takes all that is written, and the sizes agree");
    bytes
}

fn direct(pixels: &[u8], channels: usize) -> Layout {
    Layout {
        color: if channels == 1 { ColorType::Grayscale } else { ColorType::Rgb },
        depth: BitDepth::Eight,
        palette: Vec::new(),
        filter: Filter::Adaptive,
        bytes: pixels.to_vec(),
    }
}

/// The pixels as entries of a palette sorted by colour; `None` where that takes as many bits as the pixels do.
fn indexed(pixels: &[u8], side: usize, channels: usize) -> Option<Layout> {
    let number = |color: &[u8]| color.iter().fold(0, |number, &channel| number << 8 | u32::from(channel));
    let colors = || pixels.chunks_exact(channels).map(number);
    let mut entries: Vec<u32> = Vec::new();
    for color in colors() {
        let Err(place) = entries.binary_search(&color) else { continue };
        entries.insert(place, color);
        if entries.len() > MOST_ENTRIES {
            return None;
        }
    }
    let (depth, bits) = match entries.len() {
        0..=2 => (BitDepth::One, 1),
        3..=4 => (BitDepth::Two, 2),
        5..=16 => (BitDepth::Four, 4),
        _ => (BitDepth::Eight, 8),
    };
    if bits >= channels * 8 {
        return None;
    }
    let channels_of = |&color: &u32| match channels {
        1 => [color as u8; 3],
        _ => [(color >> 16) as u8, (color >> 8) as u8, color as u8],
    };
    let palette = entries.iter().flat_map(channels_of).collect();
    let index = |color: u32| entries.partition_point(|&entry| entry < color) as u8;
    let indices: Vec<u8> = colors().map(index).collect();
    // Each row begins with a byte of its own (PNG, 7.2), the leftmost pixel in its high bits.
    let row = |row: &[u8]| -> Vec<u8> {
        let byte = |pixels: &[u8]| {
            let place = |(at, &index): (usize, &u8)| index << (8 - bits * (at + 1));
            pixels.iter().enumerate().map(place).sum::<u8>()
        };
        row.chunks(8 / bits).map(byte).collect()
    };
    let bytes = indices.chunks(side).flat_map(row).collect();
    Some(Layout { color: ColorType::Indexed, depth, palette, filter: Filter::NoFilter, bytes })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Decodes a file to red, green, blue.
    fn decoded(file: &[u8]) -> (ColorType, Vec<u8>) {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let stored = reader.info().color_type;
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let length = reader.next_frame(&mut pixels).unwrap().buffer_size();
        pixels.truncate(length);
        (stored, pixels)
    }

    #[test]
    fn images_of_few_colors_get_a_palette_and_read_back_as_they_were() {
        // A side that fills no whole byte at two and four bits.
        const SIDE: usize = 9;
        for colors in [2, 3, 16, 17, 81] {
            let pixel = |index: usize| {
                let color = (index * 7 % colors) as u8;
                [255 - color, color * 3, 7]
            };
            let pixels: Vec<u8> = (0..SIDE * SIDE).flat_map(pixel).collect();
            let (stored, read) = decoded(&png(&pixels, SIDE, 3));
            assert_eq!((stored, read), (ColorType::Indexed, pixels), "{colors} colours");
        }
    }

    #[test]
    fn many_colors_and_many_shades_are_written_as_they_are() {
        let pixels: Vec<u8> =
            (0..20 * 20).flat_map(|index| [(index % 256) as u8, (index / 256) as u8, 9]).collect();
        assert_eq!(decoded(&png(&pixels, 20, 3)), (ColorType::Rgb, pixels));
        let shades: Vec<u8> = (0..100).map(|index| index * 2).collect();
        assert_eq!(decoded(&png(&shades, 10, 1)), (ColorType::Grayscale, shades));
    }
}
