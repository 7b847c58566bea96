//! The plane of a map: from degrees or metres of its reference system to metres about an origin in its middle.

use std::path::Path;

use super::drawn::{Drawing, Rings};
use super::projection::{Projection, code_of};
use crate::document::Fault;
use crate::geometry::{Bounds, Point};
use crate::plan::limits::median;
use crate::plan::units::{LocalPlane, US_FOOT, degrees_of_web_mercator};
use crate::storey::Origin;

/// The name of longitude and latitude where the file has none.
const LONGITUDE_LATITUDE: &str = "EPSG:4326";
/// Origins are whole hundredths of a degree: a piece of a map has the places of the whole.
const ORIGIN_DEGREES: f64 = 0.01;
/// Origins of maps in metres are whole kilometres.
const ORIGIN_METRES: f64 = 1_000.0;
/// A map of more degrees than this has its origin where most of its buildings are, rather than in the middle of its box.
const WIDE_DEGREES: f64 = 1.0;
/// The same in metres.
const WIDE_METRES: f64 = 100_000.0;
/// Places are rounded to so many parts of a degree, a tenth of a millimetre: formats that write decimals and those that count
/// in whole numbers give the same places.
const DEGREE_PARTS: f64 = 1e9;
/// Places are whole millimetres.
const METRE_PARTS: f64 = 1_000.0;

/// The plane of a map.
#[derive(Clone, Copy, Debug)]
pub(super) enum Frame {
    /// Of a map in degrees.
    Degrees {
        /// The plane at the origin.
        plane: LocalPlane,
        /// The origin in degrees.
        origin: Point,
    },
    /// Of a map in metres, or in feet.
    Metres {
        /// The origin in the units of the map.
        origin: Point,
        /// The projection of the map, where it is known.
        projection: Option<Projection>,
    },
}

/// The map as it is read: one in the metres of the map of the web in degrees, for they are longer than metres of the ground.
pub(super) fn in_true_metres(drawing: Drawing) -> Drawing {
    let code = drawing.reference_system.as_deref().and_then(code_of);
    match code.map(Projection::of) {
        Some(projection) if projection.is_web_mercator() => {
            drawing.moved(LONGITUDE_LATITUDE, degrees_of_web_mercator)
        }
        _ => drawing,
    }
}

impl Frame {
    /// The frame of a map.
    ///
    /// # Errors
    /// Coordinates that are no degrees where nothing else is said.
    pub(super) fn of(drawing: &Drawing, file: &Path) -> Result<Self, Fault> {
        let places: Vec<Point> =
            drawing.buildings.iter().flat_map(|drawn| &drawn.areas).map(middle_of).collect();
        let code = drawing.reference_system.as_deref().and_then(code_of);
        let projection = code.map(Projection::of);
        let is_in_degrees = match (&drawing.reference_system, projection) {
            (None, _) => drawing.is_degrees_unless_said,
            (Some(_), Some(Projection::Degrees)) => true,
            (Some(_), Some(Projection::Metres(_) | Projection::Feet)) => false,
            // A reference system that is not known: metres are larger than degrees.
            (Some(_), Some(Projection::Unknown(_)) | None) => places.iter().copied().all(is_degrees),
        };
        if is_in_degrees {
            return Self::of_degrees(&places, file);
        }
        let origin = (middle(&places, WIDE_METRES) / ORIGIN_METRES).round() * ORIGIN_METRES + Point::ZERO;
        Ok(Self::Metres { origin, projection })
    }

    fn of_degrees(places: &[Point], file: &Path) -> Result<Self, Fault> {
        let (near, far): (Vec<Point>, Vec<Point>) = places.iter().partition(|place| is_degrees(**place));
        let places = if near.len() < far.len().max(1) { far } else { near };
        let middle = middle(&places, WIDE_DEGREES);
        let origin = (middle / ORIGIN_DEGREES).round() / (1.0 / ORIGIN_DEGREES);
        let plane = LocalPlane::at(origin.x, origin.y).ok_or_else(|| {
            let message = format!("({:.1}, {:.1}) are no degrees of longitude and latitude", middle.x, middle.y);
            let hint = "name the reference system of the file in its \"crs\", such as EPSG:28992, or export it in \
                        degrees (EPSG:4326)";
            Fault::of_file(file, message).with_hint(hint)
        })?;
        Ok(Self::Degrees { plane, origin })
    }

    /// A place of the file on the plane, in whole millimetres.
    pub(super) fn to_plane(self, place: Point) -> Point {
        let metres = match self {
            Self::Degrees { plane, .. } => {
                let place = (place * DEGREE_PARTS).round() / DEGREE_PARTS;
                plane.project(place.x, place.y)
            }
            Self::Metres { origin, projection } => {
                let unit = if projection == Some(Projection::Feet) { US_FOOT } else { 1.0 };
                (place - origin) * unit
            }
        };
        snapped(metres)
    }

    /// The border of an area on the plane.
    pub(super) fn rings_to_plane(&self, rings: &Rings) -> Rings {
        let ring = |ring: &Vec<Point>| ring.iter().map(|place| self.to_plane(*place)).collect();
        Rings { outer: ring(&rings.outer), holes: rings.holes.iter().map(ring).collect() }
    }

    /// What has to be assumed of the map, in words.
    pub(super) fn assumed(&self, drawing: &Drawing) -> Option<String> {
        let name = match self {
            Self::Metres { projection: Some(Projection::Unknown(_)) | None, .. } => self.name_of(drawing)?,
            _ => return None,
        };
        Some(format!("{name} is not known: its lengths are taken as metres"))
    }

    /// Whether the map is in degrees.
    pub(super) fn is_degrees(&self) -> bool {
        matches!(self, Self::Degrees { .. })
    }

    /// Where the origin of the plane is.
    pub(super) fn origin(&self) -> Origin {
        match self {
            Self::Degrees { origin, .. } => {
                let position = origin.to_array();
                Origin { position, degrees: Some(position), ..Origin::default() }
            }
            Self::Metres { origin, projection } => {
                let degrees = projection.and_then(|projection| projection.degrees(*origin));
                Origin {
                    position: origin.to_array(),
                    degrees: degrees.map(|degrees| degrees.to_array()),
                    is_in_feet: *projection == Some(Projection::Feet),
                }
            }
        }
    }

    /// The name of the reference system of a map: as the file has it, with the number of EPSG where that is known.
    pub(super) fn name_of(&self, drawing: &Drawing) -> Option<String> {
        let named = drawing.reference_system.as_ref();
        let name =
            named.map(|name| code_of(name).map_or_else(|| name.clone(), |code| format!("EPSG:{code}")));
        name.or_else(|| self.is_degrees().then(|| LONGITUDE_LATITUDE.to_owned()))
    }
}

/// A place in whole millimetres.
pub(super) fn snapped(place: Point) -> Point {
    // Adding zero makes a negative zero positive.
    (place * METRE_PARTS).round() / METRE_PARTS + Point::ZERO
}

/// Whether a place may be a longitude and a latitude where there are cities.
fn is_degrees(place: Point) -> bool {
    place.x.abs() <= 180.0 && place.y.abs() <= 85.0
}

fn middle_of(rings: &Rings) -> Point {
    Bounds::around(rings.outer.iter().copied().filter(|place| place.is_finite())).center()
}

/// The middle of the box around places, or the middle of most of them where the box is wide; zero of none.
fn middle(places: &[Point], wide: f64) -> Point {
    let places = || places.iter().filter(|place| place.is_finite());
    let bounds = Bounds::around(places().copied());
    if bounds.size().max_element() <= wide {
        return bounds.center();
    }
    Point::new(median(places().map(|place| place.x)), median(places().map(|place| place.y)))
}
