//! Converts foreign units to metres, and degrees of longitude and latitude to a plane; no other file converts units.

use crate::geometry::Point;

/// Metres in a centimetre.
pub(crate) const CENTIMETRE: f64 = 0.01;

/// Semi-major axis of the WGS 84 ellipsoid in metres.
pub(crate) const EQUATOR_RADIUS: f64 = 6_378_137.0;
/// Square of the ellipsoid's first eccentricity.
pub(crate) const ECCENTRICITY_SQUARED: f64 = 6.694_379_990_14e-3;

/// Metres per pixel of a scan whose scale is given as square centimetres per square pixel.
///
/// `None` unless the scale is a finite number above zero.
pub(crate) fn metres_per_pixel(square_centimetres: f64) -> Option<f64> {
    (square_centimetres.is_finite() && square_centimetres > 0.0)
        .then(|| square_centimetres.sqrt() * CENTIMETRE)
}

/// Metres in a foot of surveys in the United States; the international one is shorter by two parts in a million.
pub(crate) const US_FOOT: f64 = 1200.0 / 3937.0;
/// Metres in a foot, the international one.
pub(crate) const FOOT: f64 = 0.3048;
/// Metres in an inch.
const INCH: f64 = 0.0254;

/// Metres of a length in words, as maps write it: `12`, `12.5 m`, `12,5`, `40'`, `40'6"`, `40 ft`. A number alone is metres.
///
/// `None` for anything else, and for numbers that are not finite.
pub(crate) fn length_of_words(words: &str) -> Option<f64> {
    let words = words.trim();
    let end =
        words.find(|letter: char| !(letter.is_ascii_digit() || matches!(letter, '.' | ',' | '-' | '+')));
    let (number, unit) = words.split_at(end.unwrap_or(words.len()));
    let number = number.replace(',', ".").parse::<f64>().ok().filter(|number| number.is_finite())?;
    let unit = unit.trim();
    if let Some(inches) = unit.strip_prefix('\'').map(str::trim).filter(|rest| !rest.is_empty()) {
        let inches = inches.strip_suffix('"')?.trim().parse::<f64>().ok()?;
        return Some(number * FOOT + inches * INCH).filter(|length| length.is_finite());
    }
    let factor = match unit.to_ascii_lowercase().trim_end_matches('.') {
        "" | "m" | "meter" | "meters" | "metre" | "metres" => 1.0,
        "cm" => CENTIMETRE,
        "km" => 1000.0,
        "'" | "ft" | "foot" | "feet" => FOOT,
        "\"" | "in" | "inch" | "inches" => INCH,
        _ => return None,
    };
    Some(number * factor)
}

/// Longitude and latitude in degrees of a place on the map of the web (spherical Mercator), whose metres are those of the ground at the
/// equator alone: at 60° of latitude a metre of the ground is two of its own.
pub(crate) fn degrees_of_web_mercator(place: Point) -> Point {
    let angles = place / EQUATOR_RADIUS;
    Point::new(angles.x.to_degrees(), libm::atan(libm::sinh(angles.y)).to_degrees())
}

/// Metres of a unit as energy models name it, in the plural: `Meters`, `Millimeters`, `Feet`, `Inches`, `Centimeters`.
pub(crate) fn model_unit(word: &str) -> Option<f64> {
    match word.to_ascii_lowercase().as_str() {
        "meters" => Some(1.0),
        "millimeters" => Some(0.001),
        "feet" => Some(FOOT),
        "inches" => Some(INCH),
        "centimeters" => Some(CENTIMETRE),
        _ => None,
    }
}

/// The factor of an SI prefix, as formats spell it in capitals.
pub(crate) fn si_prefix(word: &str) -> Option<f64> {
    let power: i32 = match word {
        "EXA" => 18,
        "PETA" => 15,
        "TERA" => 12,
        "GIGA" => 9,
        "MEGA" => 6,
        "KILO" => 3,
        "HECTO" => 2,
        "DECA" => 1,
        "DECI" => -1,
        "CENTI" => -2,
        "MILLI" => -3,
        "MICRO" => -6,
        "NANO" => -9,
        "PICO" => -12,
        "FEMTO" => -15,
        "ATTO" => -18,
        _ => return None,
    };
    Some(if power < 0 { 1.0 / 10f64.powi(-power) } else { 10f64.powi(power) })
}

/// A plane in metres that touches the ellipsoid at a point: x east, y north.
///
/// Equirectangular about the point, with the ellipsoid's two radii of curvature there. Against the true
/// distances along the ellipsoid a point 200 m away at 60° latitude is off by up to 1.1 cm, at 100 m by
/// 0.3 cm (the error grows with the square of the distance and the tangent of the latitude), and all of
/// it is a smooth shear of the whole building: walls stay straight and rooms keep their sizes to 0.01 %.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LocalPlane {
    longitude: f64,
    latitude: f64,
    /// Metres per degree east and north.
    scale: Point,
}

impl LocalPlane {
    /// The plane at a place in degrees. `None` outside ±180° of longitude and ±85° of latitude, where the plane
    /// is no picture of the ground or the numbers are not degrees.
    pub(crate) fn at(longitude: f64, latitude: f64) -> Option<Self> {
        const FARTHEST: (f64, f64) = (180.0, 85.0);
        // Written so that NaN fails.
        if !(longitude.abs() <= FARTHEST.0 && latitude.abs() <= FARTHEST.1) {
            return None;
        }
        let (sine, cosine) = libm::sincos(latitude.to_radians());
        let flattening = 1.0 - ECCENTRICITY_SQUARED * sine * sine;
        let across = EQUATOR_RADIUS / flattening.sqrt();
        let along = across * (1.0 - ECCENTRICITY_SQUARED) / flattening;
        let degree = 1f64.to_radians();
        Some(Self { longitude, latitude, scale: Point::new(across * cosine, along) * degree })
    }

    /// A place in degrees on the plane.
    pub(crate) fn project(&self, longitude: f64, latitude: f64) -> Point {
        Point::new(short_way(longitude - self.longitude), latitude - self.latitude) * self.scale
    }

    /// A place on the plane in degrees: the way back.
    pub(crate) fn degrees(&self, place: Point) -> Point {
        let degrees = Point::new(self.longitude, self.latitude) + place / self.scale;
        Point::new(short_way(degrees.x), degrees.y)
    }
}

/// Degrees of longitude the short way round the earth: a town may lie on both sides of the line where 180° east is 180° west.
fn short_way(degrees: f64) -> f64 {
    if degrees.abs() > 180.0 { degrees - 360.0_f64.copysign(degrees) } else { degrees }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scale_in_square_centimetres_gives_metres() {
        assert!((metres_per_pixel(4.0).unwrap() - 0.02).abs() < 1e-15);
        for broken in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(metres_per_pixel(broken), None);
        }
    }

    #[test]
    fn a_town_may_lie_on_both_sides_of_the_line_of_the_date() {
        let plane = LocalPlane::at(179.9999, -16.8).unwrap();
        let east_of_the_line = plane.project(-179.9999, -16.8);
        assert!(
            (east_of_the_line.x - 21.3).abs() < 0.1 && east_of_the_line.y.abs() < 1e-9,
            "{east_of_the_line}"
        );
        assert!((plane.degrees(east_of_the_line).x + 179.9999).abs() < 1e-9);
    }

    #[test]
    fn lengths_in_words_have_their_units() {
        let lengths = [
            ("12", 12.0),
            (" 12.5 m", 12.5),
            ("12,5m", 12.5),
            ("40'", 12.192),
            ("40'6\"", 12.3444),
            ("40 ft", 12.192),
            ("-3", -3.0),
        ];
        for (words, metres) in lengths {
            let length = length_of_words(words).unwrap_or_else(|| panic!("{words}"));
            assert!((length - metres).abs() < 1e-9, "{words}: {length}");
        }
        for words in ["", "m", "high", "5 storeys", "1.2.3", "40'x", "40'6", "1e400", "NaN", "inf"] {
            assert_eq!(length_of_words(words), None, "{words}");
        }
    }

    #[test]
    fn degrees_have_their_known_lengths() {
        // Length of a degree on WGS 84: 111 320 m and 110 574 m at the equator, 55 800 m and 111 412 m at 60°.
        for (latitude, east, north) in [(0.0, 111_320.0, 110_574.0), (60.0, 55_800.0, 111_412.0)] {
            let plane = LocalPlane::at(10.0, latitude).unwrap();
            let there = plane.project(11.0, latitude + 1.0);
            assert!((there.x - east).abs() < 1.0, "{there}");
            assert!((there.y - north).abs() < 1.0, "{there}");
        }
    }

    #[test]
    fn metres_are_no_degrees() {
        assert!(LocalPlane::at(4000.0, 60.0).is_none());
        assert!(LocalPlane::at(30.0, 90.0).is_none());
        assert!(LocalPlane::at(f64::NAN, 0.0).is_none());
    }
}
