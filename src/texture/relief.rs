//! Turns heights into tangent-space normals.

/// Red, green, blue of each pixel's normal, from heights in metres over one square metre that repeats.
///
/// Green points up the image, as glTF 2.0 (3.9.3) wants it; the first row is the top. Each channel is rounded to
/// steps of [`STEP`], which is invisible and halves the compressed size.
pub(super) fn normals(heights: &[f64], pixels: usize) -> Vec<u8> {
    let at = |column: usize, row: usize| heights[(row % pixels) * pixels + column % pixels];
    let mut bytes = Vec::with_capacity(pixels * pixels * 3);
    let per_slope = pixels as f64 / 2.0;
    for row in 0..pixels {
        for column in 0..pixels {
            let right = (at(column + 1, row) - at(column + pixels - 1, row)) * per_slope;
            let up = (at(column, row + pixels - 1) - at(column, row + 1)) * per_slope;
            let length = (right * right + up * up + 1.0).sqrt();
            bytes.extend([-right / length, -up / length, 1.0 / length].map(channel));
        }
    }
    bytes
}

/// Steps of a channel of a normal map, of 255.
const STEP: f64 = 8.0;
/// The byte for zero: the format reads 128 as 0.0039, which tilts a level floor by a fifth of a degree.
const ZERO: f64 = 128.0;

fn channel(value: f64) -> u8 {
    (ZERO + (value * 127.0 / STEP).round() * STEP).clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_of_level_surfaces_point_up_and_of_slopes_away_from_the_rise() {
        assert_eq!(&normals(&[0.0; 16], 4)[..3], [128, 128, 255]);
        // A ramp that rises to the right: its normals lean to the left.
        let ramp: Vec<f64> = (0..64).map(|index| f64::from(index % 8) * 0.05).collect();
        let middle = &normals(&ramp, 8)[3 * (8 * 3 + 4)..][..3];
        assert!(middle[0] < 120 && middle[1] == 128, "{middle:?}");
        // One that rises towards the top of the image leans down.
        let ramp: Vec<f64> = (0..64).map(|index| f64::from(7 - index / 8) * 0.05).collect();
        let middle = &normals(&ramp, 8)[3 * (8 * 4 + 3)..][..3];
        assert!(middle[0] == 128 && middle[1] < 120, "{middle:?}");
    }
}
