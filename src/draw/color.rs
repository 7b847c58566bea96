//! One colour per class, the same in every drawing.

/// A colour as `#rrggbb`.
pub(crate) type Hex = String;

/// The light fill of a class; lines over it are readable.
pub(crate) fn class_fill(class: &str) -> Hex {
    const SATURATION: f64 = 0.5;
    const LIGHTNESS: f64 = 0.93;
    hex(f64::from(name_hash(class) % 360), SATURATION, LIGHTNESS)
}

/// FNV-1a, 32 bit (Fowler, Noll, Vo): fixed for all time, unlike the standard library's hasher.
fn name_hash(name: &str) -> u32 {
    const OFFSET: u32 = 0x811c_9dc5;
    const PRIME: u32 = 0x0100_0193;
    let hash = name.bytes().fold(OFFSET, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(PRIME));
    // The low bits of short names lie close together.
    hash ^ (hash >> 15)
}

/// Hue in degrees, saturation and lightness from 0 to 1, as CSS defines them.
fn hex(hue: f64, saturation: f64, lightness: f64) -> Hex {
    let reach = saturation * lightness.min(1.0 - lightness);
    let channel = |offset: f64| {
        let k = (offset + hue / 30.0) % 12.0;
        let value = lightness - reach * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0);
        (value * 255.0).round() as u8
    };
    format!("#{:02x}{:02x}{:02x}", channel(0.0), channel(8.0), channel(4.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primary_hues_are_those_of_css() {
        assert_eq!(hex(0.0, 1.0, 0.5), "#ff0000");
        assert_eq!(hex(120.0, 1.0, 0.5), "#00ff00");
        assert_eq!(hex(240.0, 1.0, 0.25), "#000080");
    }

    #[test]
    fn a_class_keeps_its_colour() {
        assert_eq!(class_fill("desk"), class_fill("desk"));
        assert_ne!(class_fill("desk"), class_fill("chair"));
    }
}
