//! Where buildings are: on the earth, where the site says so, else on the plane of the site.

use glam::{DMat4, DVec3, DVec4};

use crate::geometry::Point;
use crate::plan::{ECCENTRICITY_SQUARED, EQUATOR_RADIUS, SiteOrigin};

/// Metres on the plane of a site between two places by which the direction of its north is found.
const BASE_LINE: f64 = 100.0;

/// Places buildings.
pub(super) struct Placer<'a> {
    origin: Option<&'a SiteOrigin>,
    /// From the root's frame to the earth's: x and y through the equator, z through the pole, in metres.
    root: Option<DMat4>,
}

impl<'a> Placer<'a> {
    pub(super) fn new(origin: Option<&'a SiteOrigin>) -> Self {
        let root = origin.and_then(|origin| frame(origin, Point::ZERO));
        Self { origin: origin.filter(|_| root.is_some()), root }
    }

    /// From the root's frame to that of the earth; `None` where nobody says where the site is.
    pub(super) fn root(&self) -> Option<&DMat4> {
        self.root.as_ref()
    }

    /// From the frame of a building to that of the root.
    pub(super) fn building(&self, position: [f64; 2], turn: f64) -> DMat4 {
        let turned = DMat4::from_cols_array(&turn_about_z(turn));
        let place = Point::from(position);
        // Where the plane ends, the building stays on the plane of the origin.
        let on_earth = self.origin.and_then(|origin| frame(origin, place)).zip(self.root);
        let frame = match on_earth {
            Some((frame, root)) => root.inverse() * frame,
            None => DMat4::from_translation(DVec3::new(place.x, place.y, 0.0)),
        };
        frame * turned
    }
}

fn turn_about_z(angle: f64) -> [f64; 16] {
    let (sine, cosine) = libm::sincos(angle);
    [cosine, sine, 0.0, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
}

/// From the frame of the site at a place of it (x and y along its axes, z up) to the earth's.
fn frame(origin: &SiteOrigin, place: Point) -> Option<DMat4> {
    let at = origin.degrees(place)?;
    // The site's y axis on the ground: that of a plane of a reference system is not north but at its middle.
    let ahead = origin.degrees(place + Point::new(0.0, BASE_LINE))?;
    let [east, north, up] = axes(at);
    let direction = earth(ahead, origin.height) - earth(at, origin.height);
    let ahead = (direction - up * direction.dot(up)).normalize();
    debug_assert!(ahead.dot(north).abs() <= 1.0 + 1e-9 && ahead.dot(east).abs() <= 1.0 + 1e-9);
    let right = ahead.cross(up);
    let column = |axis: DVec3| axis.extend(0.0);
    let middle = earth(at, origin.height);
    Some(DMat4::from_cols(column(right), column(ahead), column(up), DVec4::from((middle, 1.0))))
}

/// East, north and up at a place in degrees.
fn axes(degrees: Point) -> [DVec3; 3] {
    let (sine_of_longitude, cosine_of_longitude) = libm::sincos(degrees.x.to_radians());
    let (sine, cosine) = libm::sincos(degrees.y.to_radians());
    let east = DVec3::new(-sine_of_longitude, cosine_of_longitude, 0.0);
    let up = DVec3::new(cosine * cosine_of_longitude, cosine * sine_of_longitude, sine);
    [east, up.cross(east), up]
}

/// A place in degrees, and metres above the ellipsoid, in the frame of the earth.
fn earth(degrees: Point, height: f64) -> DVec3 {
    let (sine_of_longitude, cosine_of_longitude) = libm::sincos(degrees.x.to_radians());
    let (sine, cosine) = libm::sincos(degrees.y.to_radians());
    let radius = EQUATOR_RADIUS / (1.0 - ECCENTRICITY_SQUARED * sine * sine).sqrt();
    let across = (radius + height) * cosine;
    DVec3::new(
        across * cosine_of_longitude,
        across * sine_of_longitude,
        (radius * (1.0 - ECCENTRICITY_SQUARED) + height) * sine,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::EarthPlace;

    fn degrees(longitude: f64, latitude: f64, heading: f64) -> SiteOrigin {
        SiteOrigin { place: EarthPlace::Degrees(Point::new(longitude, latitude)), height: 40.0, heading }
    }

    #[test]
    fn places_are_those_of_pyproj() {
        // pyproj: Transformer.from_crs(4979, 4978, always_xy=True).transform(13.41, 52.53, 40).
        let place = earth(Point::new(13.41, 52.53), 40.0);
        let known = DVec3::new(3_782_330.988_027, 901_775.980_149, 5_038_927.874_749);
        assert!((place - known).length() < 1e-5, "{place}");
        let pole = earth(Point::new(0.0, 90.0), 0.0);
        assert!((pole - DVec3::new(0.0, 0.0, 6_356_752.314_245)).length() < 1e-6, "{pole}");
        assert_eq!(earth(Point::ZERO, 0.0), DVec3::new(EQUATOR_RADIUS, 0.0, 0.0));
    }

    #[test]
    fn a_building_stands_upright_where_its_site_has_it() {
        let site = degrees(13.41, 52.53, 0.0);
        let placer = Placer::new(Some(&site));
        let root = placer.root().unwrap();
        let matrix = *root * placer.building([30.0, -40.0], std::f64::consts::FRAC_PI_2);
        let [east, north, up] = axes(Point::new(13.41, 52.53));
        let base = earth(Point::new(13.41, 52.53), 40.0);
        let middle = matrix.transform_point3(DVec3::ZERO) - base;
        assert!(
            (middle.dot(east) - 30.0).abs() < 1e-3 && (middle.dot(north) + 40.0).abs() < 1e-3,
            "{middle}"
        );
        // Its x axis, turned by a quarter, looks north.
        let ahead = matrix.transform_vector3(DVec3::X);
        assert!(ahead.dot(north) > 0.999_999 && matrix.transform_vector3(DVec3::Z).dot(up) > 0.999_999);
    }

    #[test]
    fn a_heading_turns_the_site() {
        let site = degrees(13.41, 52.53, std::f64::consts::FRAC_PI_2);
        let ahead = Placer::new(Some(&site)).root().unwrap().transform_vector3(DVec3::Y);
        assert!(ahead.dot(axes(Point::new(13.41, 52.53))[0]) > 0.999_999);
    }

    #[test]
    fn the_north_of_a_plane_is_turned_away_from_its_middle() {
        // East of the middle of a zone of UTM, the north of the grid lies east of north.
        let place = EarthPlace::Plane { code: 25833, position: Point::new(700_000.0, 5_800_000.0) };
        let site = SiteOrigin { place, height: 0.0, heading: 0.0 };
        let at = site.degrees(Point::ZERO).unwrap();
        let ahead = Placer::new(Some(&site)).root().unwrap().transform_vector3(DVec3::Y);
        let [east, north, _] = axes(at);
        let convergence = libm::atan2(ahead.dot(east), ahead.dot(north)).to_degrees();
        // tan γ = tan(λ − λ₀) · sin φ.
        let known =
            libm::atan(libm::tan((at.x - 15.0).to_radians()) * libm::sin(at.y.to_radians())).to_degrees();
        assert!((convergence.abs() - known.abs()).abs() < 0.002, "{convergence} {known}");
    }

    #[test]
    fn without_an_origin_buildings_stand_on_the_plane_of_the_site() {
        let placer = Placer::new(None);
        assert!(placer.root().is_none());
        let place = placer.building([5.0, 6.0], 0.0).transform_point3(DVec3::new(1.0, 0.0, 2.0));
        assert_eq!(place, DVec3::new(6.0, 6.0, 2.0));
    }
}
