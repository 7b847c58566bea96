//! Names and numbers of reference systems, and what they are.

mod table;

use proj4rs::proj::Proj;
use proj4rs::transform::transform;

use crate::geometry::Point;
use table::{definition_of, is_in_feet};

/// Places in degrees are rounded to so many parts, a centimetre: the functions of the system, which PROJ uses, differ in digits far
/// behind.
const DEGREE_PARTS: f64 = 1e7;
/// Longitude and latitude on WGS 84.
const DEGREES: &str = "+proj=longlat +datum=WGS84";

/// The map of the web: the number of today, then earlier ones and those of Esri.
const WEB_MERCATOR: [u32; 5] = [3857, 900_913, 3785, 102_100, 102_113];

/// A reference system, by its number in the register of EPSG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Projection {
    /// Longitude and latitude.
    Degrees,
    /// Metres, by its number in the table.
    Metres(u32),
    /// Feet of the United States, on planes that are not in the table.
    Feet,
    /// Not in the table.
    Unknown(u32),
}

impl Projection {
    /// By its number.
    pub(crate) fn of(code: u32) -> Self {
        match code {
            4326 | 4258 | 4979 | 4937 | 6697 | 6668 | 4612 | 4269 | 4283 | 7844 | 4617 => Self::Degrees,
            _ if WEB_MERCATOR.contains(&code) => Self::Metres(WEB_MERCATOR[0]),
            _ if definition_of(code).is_some() => Self::Metres(code),
            _ if is_in_feet(code) => Self::Feet,
            _ => Self::Unknown(code),
        }
    }

    /// Whether its metres are longer than those of the ground, so that its lengths cannot be taken as they are.
    pub(crate) fn is_web_mercator(self) -> bool {
        self == Self::Metres(WEB_MERCATOR[0])
    }

    /// Longitude and latitude of a place in metres; `None` where the system is not in the table, or the place is none of it.
    pub(super) fn degrees(self, place: Point) -> Option<Point> {
        let degrees = self.exact_degrees(place)?;
        Some((degrees * DEGREE_PARTS).round() / DEGREE_PARTS + Point::ZERO)
    }

    /// The same to the last digit, which other systems' functions may have otherwise.
    pub(crate) fn exact_degrees(self, place: Point) -> Option<Point> {
        let Self::Metres(code) = self else { return None };
        let from = Proj::from_proj_string(&definition_of(code)?).ok()?;
        let to = Proj::from_proj_string(DEGREES).ok()?;
        let mut point = (place.x, place.y, 0.0);
        transform(&from, &to, &mut point).ok()?;
        let degrees = Point::new(point.0.to_degrees(), point.1.to_degrees());
        let is_place = degrees.x.abs() <= 180.0 && degrees.y.abs() <= 90.0;
        is_place.then_some(degrees)
    }
}

/// The number of a reference system by its name: `EPSG:7415`, `urn:ogc:def:crs:EPSG::7415`,
/// `https://www.opengis.net/def/crs/EPSG/0/7415`; of a compound one that of the plane. `CRS84` is longitude and latitude. Of the
/// numbers of Esri (`ESRI:102100`) those of the map of the web are known.
pub(crate) fn code_of(name: &str) -> Option<u32> {
    let name = name.to_ascii_uppercase();
    if name.contains("CRS84") {
        return Some(4326);
    }
    let number_behind = |register: &str| -> Option<u32> {
        let numbers = name[name.find(register)? + register.len()..].split(',').next()?;
        let mut numbers =
            numbers.split(|letter: char| !letter.is_ascii_digit()).filter(|part| !part.is_empty());
        numbers.next_back()?.parse().ok()
    };
    let of_esri = || number_behind("ESRI").filter(|code| WEB_MERCATOR.contains(code));
    number_behind("EPSG").or_else(of_esri)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::units::degrees_of_web_mercator;

    #[test]
    fn the_number_of_a_reference_system_is_found_in_its_name() {
        let names = [
            ("EPSG:6677", Some(6677)),
            ("epsg:4326", Some(4326)),
            ("urn:ogc:def:crs:EPSG::7415", Some(7415)),
            ("urn:ogc:def:crs:EPSG:9.9.1:7415", Some(7415)),
            ("https://www.opengis.net/def/crs/EPSG/0/32734", Some(32734)),
            ("urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783", Some(25832)),
            ("urn:ogc:def:crs:OGC:1.3:CRS84", Some(4326)),
            ("ESRI:102100", Some(102_100)),
            ("ESRI:102003", None),
            ("EPSG:", None),
            ("EPSG:99999999999", None),
            ("local", None),
        ];
        for (name, code) in names {
            assert_eq!(code_of(name), code, "{name}");
        }
    }

    #[test]
    fn known_places_have_their_degrees() {
        // Origins, whose degrees define the systems, and published points: Amersfoort, the old observatory of Bern, a point of the
        // guide of the Ordnance Survey, in WGS 84.
        let places = [
            (32633, (500_000.0, 0.0), (15.0, 0.0)),
            (25832, (500_000.0, 0.0), (9.0, 0.0)),
            (6677, (0.0, 0.0), (139.833_333, 36.0)),
            (2154, (700_000.0, 6_600_000.0), (3.0, 46.5)),
            (3857, (1_113_194.908, 0.0), (10.0, 0.0)),
            (7415, (155_000.0, 463_000.0), (5.387_206, 52.155_174)),
            (2056, (2_600_000.0, 1_200_000.0), (7.438_632, 46.951_083)),
            (2950, (304_800.0, 0.0), (-73.5, 0.0)),
            (6348, (500_000.0, 0.0), (-69.0, 0.0)),
            (2958, (500_000.0, 0.0), (-81.0, 0.0)),
            (31983, (500_000.0, 10_000_000.0), (-45.0, 0.0)),
            (27700, (651_409.903, 313_177.270), (1.716_038, 52.657_977)),
        ];
        for (code, (x, y), (longitude, latitude)) in places {
            let degrees = Projection::of(code).degrees(Point::new(x, y)).unwrap();
            let off = degrees - Point::new(longitude, latitude);
            assert!(off.abs().max_element() < 5e-5, "EPSG:{code}: {degrees}");
        }
    }

    #[test]
    fn all_definitions_are_understood() {
        let known = (1..=33_000).chain([900_913]).filter(|code| definition_of(*code).is_some());
        let mut count = 0;
        for code in known {
            assert!(Proj::from_proj_string(&definition_of(code).unwrap()).is_ok(), "EPSG:{code}");
            count += 1;
        }
        assert_eq!(count, 331);
        assert_eq!(Projection::of(2263), Projection::Feet);
        assert_eq!(Projection::of(22_263), Projection::Unknown(22_263));
    }

    #[test]
    fn the_map_of_the_web_is_known_by_all_its_numbers() {
        let place = Point::new(951_000.0, 6_003_000.0);
        for code in WEB_MERCATOR {
            assert!(Projection::of(code).is_web_mercator());
            let exact = Projection::of(code).exact_degrees(place).unwrap();
            assert!((exact - degrees_of_web_mercator(place)).abs().max_element() < 1e-9, "{exact}");
        }
        assert!(!Projection::of(25832).is_web_mercator());
    }
}
