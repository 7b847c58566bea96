//! Where a site is on the earth.

use super::read::{Projection, code_of};
use super::units::LocalPlane;
use crate::geometry::Point;

/// Where the origin of a site is on the earth.
#[derive(Clone, Debug, PartialEq)]
pub struct SiteOrigin {
    /// The place.
    pub place: EarthPlace,
    /// Metres of the site's zero above the ellipsoid.
    pub height: f64,
    /// Radians clockwise from north, or with [`EarthPlace::Plane`] from the north of the plane, to the site's y axis.
    pub heading: f64,
}

/// A place on the earth.
#[derive(Clone, Debug, PartialEq)]
pub enum EarthPlace {
    /// Degrees of longitude and latitude on WGS 84; the site lies on a plane that touches the ground there.
    Degrees(Point),
    /// Metres on the plane of a reference system, which is the plane of the site.
    Plane {
        /// The number of the system in the register of EPSG.
        code: u32,
        /// East and north.
        position: Point,
    },
}

impl SiteOrigin {
    /// A place in degrees, and metres above the ellipsoid, whose y axis is north; `None` where a plane is no picture of the ground, or
    /// the numbers are not degrees.
    #[must_use]
    pub fn at(longitude: f64, latitude: f64, height: f64) -> Option<Self> {
        LocalPlane::at(longitude, latitude)?;
        Some(Self { place: EarthPlace::Degrees(Point::new(longitude, latitude)), height, heading: 0.0 })
    }

    /// A place in a reference system, with the same place in degrees where they are known; `None` where neither says where it is.
    pub(crate) fn of(system: Option<&str>, position: Point, degrees: Option<Point>) -> Option<Self> {
        let by_degrees = || degrees.map(EarthPlace::Degrees);
        let place = match system.and_then(code_of) {
            Some(code) => match Projection::of(code) {
                Projection::Degrees => Some(EarthPlace::Degrees(position)),
                projection if projection.exact_degrees(position).is_some() => {
                    Some(EarthPlace::Plane { code, position })
                }
                _ => by_degrees(),
            },
            None => by_degrees(),
        };
        Some(Self { place: place?, height: 0.0, heading: 0.0 })
    }

    /// Degrees of longitude and latitude of a place on the site; `None` where its plane shows no ground.
    #[must_use]
    pub fn degrees(&self, place: Point) -> Option<Point> {
        let (sine, cosine) = libm::sincos(self.heading);
        let turned = Point::new(place.x * cosine + place.y * sine, place.y * cosine - place.x * sine);
        match &self.place {
            EarthPlace::Degrees(origin) => Some(LocalPlane::at(origin.x, origin.y)?.degrees(turned)),
            EarthPlace::Plane { code, position } => Projection::of(*code).exact_degrees(*position + turned),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_in_metres_is_preferred_to_the_same_in_degrees() {
        let (position, degrees) = (Point::new(155_000.0, 463_000.0), Point::new(5.387_206, 52.155_174));
        let on_plane = SiteOrigin::of(Some("EPSG:7415"), position, Some(degrees)).unwrap();
        assert_eq!(on_plane.place, EarthPlace::Plane { code: 7415, position });
        assert!((on_plane.degrees(Point::ZERO).unwrap() - degrees).abs().max_element() < 1e-5);
        let unknown = SiteOrigin::of(Some("EPSG:99999"), position, Some(degrees)).unwrap();
        assert_eq!(unknown.place, EarthPlace::Degrees(degrees));
        assert_eq!(SiteOrigin::of(Some("local"), position, None), None);
        assert_eq!(SiteOrigin::of(None, position, None), None);
    }

    #[test]
    fn a_heading_turns_the_site_clockwise() {
        let place = EarthPlace::Degrees(Point::new(13.0, 52.0));
        let site = SiteOrigin { place, height: 0.0, heading: std::f64::consts::FRAC_PI_2 };
        // What lies ahead of the site's y axis lies east.
        let ahead = site.degrees(Point::new(0.0, 100.0)).unwrap();
        assert!(ahead.x > 13.001 && (ahead.y - 52.0).abs() < 1e-12, "{ahead}");
    }
}
