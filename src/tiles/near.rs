//! Distances as geometric errors.
//!
//! Clients do not know distances: they show a finer tile where the error of the coarser one, projected onto the screen, is more than
//! a number of pixels (3D Tiles 1.1, section 6.7.1.2). On a screen of h pixels with a vertical view of an angle f, an error e at a
//! distance d is e · h / (d · 2 · tan(f / 2)) pixels.

/// Pixels of the screen for which distances are meant.
const SCREEN_HEIGHT: f64 = 1080.0;
/// Pixels of error that clients show: the default of CesiumJS (`maximumScreenSpaceError`) and 3d-tiles-renderer (`errorTarget`).
const SHOWN_ERROR: f64 = 16.0;
/// Twice the tangent of half the vertical angle of view: that of CesiumJS, 60° across a screen of 16 : 9.
const VIEW: f64 = 2.0 * 0.577_350_269_189_625_8 * 9.0 / 16.0;

/// The errors of what is shown before boxes, before reduced and before full furniture, from the distances at which these begin.
pub(super) fn errors(near: [f64; 3]) -> [f64; 3] {
    near.map(error_at)
}

/// The error that is shown from a distance on.
fn error_at(distance: f64) -> f64 {
    distance * SHOWN_ERROR * VIEW / SCREEN_HEIGHT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hundred_metres_are_an_error_of_about_one() {
        let [boxes, reduced, full] = errors([100.0, 35.0, 12.0]);
        assert!(
            (boxes - 0.962).abs() < 1e-3 && (reduced - 0.337).abs() < 1e-3 && (full - 0.115).abs() < 1e-3
        );
    }
}
