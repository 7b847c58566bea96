//! What is known of a building before it has a plan: its outline, and what a map says of it.

use crate::geometry::{Point, Region};

/// The buildings of a map on one plane.
#[derive(Clone, Debug, Default)]
pub struct Site {
    /// Name of the reference system of the file, such as `EPSG:7415`; `EPSG:4326` for longitude and latitude.
    pub reference_system: Option<String>,
    /// Where the plane's origin is.
    pub origin: Origin,
    /// The buildings, sorted by id.
    pub footprints: Vec<Footprint>,
    /// Centre lines of streets, where the map has them: metres on the plane.
    pub streets: Vec<Vec<Point>>,
}

/// Where the origin of a plane in metres is on the earth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Origin {
    /// The origin in the units of the reference system of the file: degrees of longitude and latitude, metres, or feet.
    pub position: [f64; 2],
    /// Degrees of longitude and latitude, where the reference system is known.
    pub degrees: Option<[f64; 2]>,
    /// Whether those units are feet of surveys in the United States; the plane is in metres all the same.
    pub is_in_feet: bool,
}

/// One building as a map shows it.
#[derive(Clone, Debug)]
pub struct Footprint {
    /// Unique in the map: the id of the file, or one made from the place of the building.
    pub id: String,
    /// A name for people, if the map has one.
    pub name: Option<String>,
    /// The outer faces of the outer walls, with courtyards as holes; metres on the plane of the site.
    pub region: Region,
    /// Parts with storeys of their own, such as a tower above a lower block, from the lowest bottom up; empty for most. `region`
    /// is the outline of the whole where the map draws it, which parts may reach over, and else the ground that they cover
    /// together. Parts need not cover all of it.
    pub parts: Vec<FootprintPart>,
    /// What is known of the storeys.
    pub storeys: StoreyFacts,
    /// What the map says it is used for, most specific first: keys and words as found, in small letters (`building`, `school`).
    pub uses: Vec<(String, String)>,
    /// Number of flats, if the map says.
    pub flats: Option<u32>,
    /// Doors that the map shows on the outline.
    pub entrances: Vec<Point>,
}

/// A part of a building with storeys of its own.
#[derive(Clone, Debug)]
pub struct FootprintPart {
    /// Its outline on the plane of the site.
    pub region: Region,
    /// What is known of its storeys.
    pub storeys: StoreyFacts,
}

/// What a map says of the storeys of a building or of a part of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StoreyFacts {
    /// Storeys above the ground, as written: `1.5` has half a storey under its roof.
    pub above_ground: Option<f64>,
    /// Storeys of the roof that the map counts apart.
    pub in_roof: Option<f64>,
    /// Storeys below it that are only air: a part that begins higher up.
    pub lowest: Option<f64>,
    /// Metres from the ground to the top.
    pub height: Option<f64>,
    /// Metres from the ground to the bottom: a part that begins higher up.
    pub bottom: Option<f64>,
}
