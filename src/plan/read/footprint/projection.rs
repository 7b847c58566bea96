//! Names and numbers of reference systems.

use crate::geometry::Point;

/// A reference system, by its number in the list of EPSG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Projection {
    /// Longitude and latitude.
    Degrees,
    /// Another one.
    Unknown(u32),
}

impl Projection {
    /// By its number.
    pub(super) fn of(code: u32) -> Self {
        match code {
            4326 | 4258 | 4979 | 4937 | 6697 | 6668 | 4612 | 4269 | 4283 | 7844 | 4617 => Self::Degrees,
            _ => Self::Unknown(code),
        }
    }
}

/// The number of a reference system by its name: `EPSG:7415`, `urn:ogc:def:crs:EPSG::7415`,
/// `https://www.opengis.net/def/crs/EPSG/0/7415`; of a compound one that of the plane. `CRS84` is longitude and latitude.
pub(super) fn code_of(name: &str) -> Option<u32> {
    let name = name.to_ascii_uppercase();
    if name.contains("CRS84") {
        return Some(4326);
    }
    let numbers = name[name.find("EPSG")? + "EPSG".len()..].split(',').next()?;
    let mut numbers = numbers.split(|letter: char| !letter.is_ascii_digit()).filter(|part| !part.is_empty());
    numbers.next_back()?.parse().ok()
}

/// Degrees of a place in metres of a reference system.
pub(super) fn degrees_of(_projection: Projection, _place: Point) -> Option<Point> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

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
            ("EPSG:", None),
            ("EPSG:99999999999", None),
            ("local", None),
        ];
        for (name, code) in names {
            assert_eq!(code_of(name), code, "{name}");
        }
    }
}
