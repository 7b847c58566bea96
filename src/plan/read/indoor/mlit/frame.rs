//! The plane of a map: its own where it is in metres, one that touches the ground where it is in degrees.

use crate::geometry::{Bounds, Point};
use crate::plan::SiteOrigin;
use crate::plan::read::footprint::{Projection, code_of};
use crate::plan::read::geojson::{Position, plane_around};
use crate::plan::units::LocalPlane;

/// The greatest longitude in degrees; what lies beyond is in metres.
const GREATEST_DEGREE: f64 = 180.0;

/// The plane of a map.
#[derive(Debug)]
pub(super) enum Frame {
    Degrees(LocalPlane),
    Metres {
        /// The name of the reference system.
        system: String,
        /// Where the frame begins.
        origin: Point,
    },
}

impl Frame {
    /// Of a map with these corners.
    ///
    /// # Errors
    /// Fact and hint.
    pub(super) fn of(system: Option<&str>, corners: &[Point]) -> Result<Self, (String, String)> {
        let is_degrees = match system {
            None => true,
            Some(name) => match code_of(name).map(Projection::of) {
                Some(Projection::Degrees) => true,
                Some(projection @ Projection::Metres(_)) if !projection.is_web_mercator() => false,
                _ => {
                    let message = format!("the reference system \"{name}\" is not read");
                    return Err((
                        message,
                        "convert the map to EPSG:6668 (degrees) or to the plane of its region".into(),
                    ));
                }
            },
        };
        let bounds = Bounds::around(corners.iter().copied());
        if let Some(system) = system.filter(|_| !is_degrees) {
            // Adding zero makes a negative zero positive.
            let origin = bounds.center().round() + Point::ZERO;
            return Ok(Self::Metres { system: system.to_owned(), origin });
        }
        let widest = bounds.size().max_element().max(bounds.center().abs().max_element());
        let plane = plane_around(corners).filter(|_| widest <= 2.0 * GREATEST_DEGREE);
        plane.map(Self::Degrees).ok_or_else(|| {
            let message = "the coordinates are no degrees, and no other reference system is named".to_owned();
            (message, "add the member \"crs\" with the reference system, as ogr2ogr writes it".into())
        })
    }

    /// A place of the map on the plane; one without two numbers is nowhere, which cleaning reports.
    pub(super) fn point(&self, position: &Position) -> Point {
        let [x, y, ..] = position[..] else { return Point::NAN };
        match self {
            Self::Degrees(plane) => plane.project(x, y),
            Self::Metres { origin, .. } => Point::new(x, y) - *origin,
        }
    }

    /// Where the plane is on the earth.
    pub(super) fn origin(&self) -> Option<SiteOrigin> {
        match self {
            Self::Degrees(plane) => {
                let at = plane.degrees(Point::ZERO);
                SiteOrigin::at(at.x, at.y, 0.0)
            }
            Self::Metres { system, origin } => SiteOrigin::of(Some(system), *origin, None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metres_are_never_taken_for_degrees() {
        let corners = [Point::new(-6240.5, -35360.0), Point::new(-6230.5, -35350.0)];
        let frame = Frame::of(Some("urn:ogc:def:crs:EPSG::6677"), &corners).unwrap();
        assert_eq!(
            frame.point(&vec![-6235.0, -35354.0, 1.0]) - frame.point(&vec![-6236.0, -35354.0]),
            Point::X
        );
        assert!(frame.origin().is_some());
        let (message, _) = Frame::of(None, &corners).unwrap_err();
        assert!(message.contains("no degrees"), "{message}");
        assert!(Frame::of(Some("EPSG:6668"), &corners).is_err());
        assert!(Frame::of(None, &[]).is_err() || Bounds::around([]).center().is_nan());
    }

    #[test]
    fn maps_in_degrees_lie_on_a_plane_of_metres() {
        let corners = [Point::new(139.767, 35.681), Point::new(139.768, 35.682)];
        let frame = Frame::of(None, &corners).unwrap();
        let size = frame.point(&vec![139.768, 35.682]) - frame.point(&vec![139.767, 35.681]);
        assert!((size.x - 90.5).abs() < 0.5 && (size.y - 111.0).abs() < 0.5, "{size}");
        let (message, _) = Frame::of(Some("EPSG:99999"), &corners).unwrap_err();
        assert!(message.contains("99999"), "{message}");
    }
}
