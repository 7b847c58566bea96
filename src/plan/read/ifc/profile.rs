//! Reads swept profiles: an outline and its holes in the plane of the profile.

use glam::{DAffine3, DVec3};

use super::curve::{Conic, DEEPEST};
use super::model::{Entity, Read};
use super::placement::Geometry;

/// Closed corners in a plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Rings {
    pub(super) outer: Vec<DVec3>,
    pub(super) holes: Vec<Vec<DVec3>>,
}

impl Rings {
    /// The same elsewhere.
    pub(super) fn moved(&self, by: &DAffine3) -> Self {
        let ring = |ring: &Vec<DVec3>| ring.iter().map(|corner| by.transform_point3(*corner)).collect();
        Self { outer: ring(&self.outer), holes: self.holes.iter().map(ring).collect() }
    }

    /// All corners.
    pub(super) fn corners(&self) -> impl Iterator<Item = DVec3> {
        self.outer.iter().chain(self.holes.iter().flatten()).copied()
    }
}

/// Metres of the thinnest leg of an angle that is a floor; thinner ones are of steel.
const WALKABLE: f64 = 0.5;

/// A trapezium in the middle of its height and of its lower side, of which the upper one begins at an offset from the lower one.
fn trapezium(lower: f64, upper: f64, height: f64, offset: f64) -> Vec<DVec3> {
    let (x, y) = (lower / 2.0, height / 2.0);
    [(-x, -y), (x, -y), (offset + upper - x, y), (offset - x, y)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()
}

/// An angle of two legs in the middle of its box: one along its left side, one along its lower side.
fn angle(width: f64, depth: f64, thickness: f64) -> Vec<DVec3> {
    let (x, y) = (width / 2.0, depth / 2.0);
    let (inner_x, inner_y) = (thickness - x, thickness - y);
    let corners = [(-x, -y), (x, -y), (x, inner_y), (inner_x, inner_y), (inner_x, y), (-x, y)];
    corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()
}

/// A rectangle around the origin.
fn rectangle(width: f64, depth: f64) -> Vec<DVec3> {
    let (x, y) = (width / 2.0, depth / 2.0);
    [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()
}

impl Geometry<'_> {
    /// The rings of a profile.
    pub(super) fn profile(&self, id: u64, depth: usize) -> Read<Rings> {
        let profile = self.model.get(id)?;
        if depth > DEEPEST {
            return Err(profile.trouble("profiles are nested too deep"));
        }
        match profile.kind.as_str() {
            "IFCARBITRARYCLOSEDPROFILEDEF" => {
                Ok(Rings { outer: self.curve(profile.reference(2)?, depth + 1)?, holes: Vec::new() })
            }
            "IFCARBITRARYPROFILEDEFWITHVOIDS" => {
                let outer = self.curve(profile.reference(2)?, depth + 1)?;
                let holes = profile.references(3)?.into_iter().map(|hole| self.curve(hole, depth + 1));
                Ok(Rings { outer, holes: holes.collect::<Read<_>>()? })
            }
            "IFCDERIVEDPROFILEDEF" => {
                let operator = self.operator(profile.reference(3)?)?;
                Ok(self.profile(profile.reference(2)?, depth + 1)?.moved(&operator))
            }
            "IFCMIRROREDPROFILEDEF" => {
                let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
                Ok(self.profile(profile.reference(2)?, depth + 1)?.moved(&mirror))
            }
            _ => self.parameterised(&profile),
        }
    }

    /// Profiles that are named by their sizes. A steel section is its bounding rectangle: people do not stand between its flanges.
    fn parameterised(&self, profile: &Entity) -> Read<Rings> {
        let length = |place: usize| Ok(profile.positive(place)? * self.units.length);
        let outer = match profile.kind.as_str() {
            "IFCCIRCLEPROFILEDEF" | "IFCCIRCLEHOLLOWPROFILEDEF" => ellipse(length(3)?, length(3)?),
            "IFCELLIPSEPROFILEDEF" => ellipse(length(3)?, length(4)?),
            "IFCRECTANGLEPROFILEDEF"
            | "IFCROUNDEDRECTANGLEPROFILEDEF"
            | "IFCRECTANGLEHOLLOWPROFILEDEF"
            | "IFCISHAPEPROFILEDEF"
            | "IFCASYMMETRICISHAPEPROFILEDEF" => rectangle(length(3)?, length(4)?),
            "IFCTRAPEZIUMPROFILEDEF" => {
                let offset = profile.value(6).number().unwrap_or(0.0) * self.units.length;
                trapezium(length(3)?, length(4)?, length(5)?, offset)
            }
            "IFCLSHAPEPROFILEDEF" if length(5).is_ok_and(|thickness| thickness >= WALKABLE) => {
                angle(length(4).or_else(|_| length(3))?, length(3)?, length(5)?)
            }
            "IFCTSHAPEPROFILEDEF" | "IFCUSHAPEPROFILEDEF" | "IFCLSHAPEPROFILEDEF" => {
                rectangle(length(4).or_else(|_| length(3))?, length(3)?)
            }
            _ => return Err(profile.trouble("profiles of this kind are not read")),
        };
        let frame = self.axes(profile.value(2))?;
        Ok(Rings { outer, holes: Vec::new() }.moved(&frame))
    }
}

fn ellipse(first: f64, second: f64) -> Vec<DVec3> {
    Conic { frame: DAffine3::IDENTITY, radii: (first, second) }.around()
}
