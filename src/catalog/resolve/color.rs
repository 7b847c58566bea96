//! Converts colours from sRGB, as people write them, to linear light.

use crate::catalog::report::{Report, Spot};

// The sRGB transfer function, IEC 61966-2-1.
const KNEE: f64 = 0.04045;
const SLOPE: f64 = 12.92;
const OFFSET: f64 = 0.055;
const EXPONENT: f64 = 2.4;

/// `#rrggbb` in sRGB as linear red, green and blue.
pub(super) fn linear_color(text: &str, spot: &Spot, report: &mut Report<'_>) -> [f32; 3] {
    let channels = text.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii());
    let channel = |digits: &str, index: usize| u8::from_str_radix(&digits[2 * index..2 * index + 2], 16).ok();
    let read = |digits| Some([channel(digits, 0)?, channel(digits, 1)?, channel(digits, 2)?]);
    // `from_str_radix` takes a sign, which is no digit of a colour.
    let read = channels.filter(|digits| digits.bytes().all(|digit| digit.is_ascii_hexdigit())).and_then(read);
    let Some(channels) = read else {
        report.error_with_hint(
            spot,
            format!("\"{text}\" is no colour"),
            "write sRGB red, green, blue: \"#b58a5a\"",
        );
        return [0.0; 3];
    };
    channels.map(|channel| srgb_linear(f64::from(channel) / f64::from(u8::MAX)) as f32)
}

/// The sRGB transfer function (IEC 61966-2-1), from encoded to linear, both 0 to 1.
pub(crate) fn srgb_linear(encoded: f64) -> f64 {
    if encoded <= KNEE { encoded / SLOPE } else { libm::pow((encoded + OFFSET) / (1.0 + OFFSET), EXPONENT) }
}

/// The sRGB transfer function the other way.
pub(crate) fn srgb_encoded(linear: f64) -> f64 {
    if linear <= KNEE / SLOPE {
        linear * SLOPE
    } else {
        libm::pow(linear, 1.0 / EXPONENT) * (1.0 + OFFSET) - OFFSET
    }
}

/// Linear red, green and blue as `#rrggbb` in sRGB.
pub(crate) fn srgb_hex(linear: [f32; 3]) -> String {
    let [red, green, blue] = linear.map(|channel| {
        (srgb_encoded(f64::from(channel)) * f64::from(u8::MAX)).round().clamp(0.0, f64::from(u8::MAX)) as u8
    });
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_survive_conversion_there_and_back() {
        for channel in 0..=u8::MAX {
            let light = srgb_linear(f64::from(channel) / f64::from(u8::MAX)) as f32;
            assert_eq!(srgb_hex([light; 3]), format!("#{channel:02x}{channel:02x}{channel:02x}"));
        }
    }

    #[test]
    fn the_transfer_function_meets_its_known_values() {
        assert!(srgb_linear(0.0).abs() < 1e-12);
        assert!((srgb_linear(1.0) - 1.0).abs() < 1e-12);
        assert!((srgb_linear(0.5) - 0.214_041).abs() < 1e-6);
        assert!((srgb_linear(0.04) - 0.04 / 12.92).abs() < 1e-12);
    }
}
