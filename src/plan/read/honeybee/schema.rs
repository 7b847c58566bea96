//! The parts of dragonfly and honeybee models that are read, as the JSON has them (dragonfly-schema 2, honeybee-schema 2).
//!
//! Lengths are in the units of the model, angles do not occur, z is up. Programs on .NET write `null` for what is absent, so
//! that every list may be none. Keys that are not named here are passed over.

use schemars::JsonSchema;
use serde::Deserialize;

/// `Model` of either schema: dragonfly has `buildings`, honeybee `rooms`.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Model {
    #[serde(rename = "type")]
    pub(super) kind: Option<String>,
    pub(super) display_name: Option<String>,
    /// Metres if absent.
    pub(super) units: Option<String>,
    pub(super) buildings: Option<Vec<Building>>,
    pub(super) rooms: Option<Vec<Room>>,
}

/// `Building` of dragonfly.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Building {
    pub(super) identifier: String,
    pub(super) display_name: Option<String>,
    pub(super) unique_stories: Option<Vec<Story>>,
    /// Rooms that are no extruded floors.
    pub(super) room_3ds: Option<Vec<Room>>,
}

/// `Story` of dragonfly.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Story {
    pub(super) identifier: String,
    pub(super) display_name: Option<String>,
    pub(super) room_2ds: Vec<Room2d>,
    pub(super) floor_to_floor_height: Option<Length>,
    /// How many equal storeys stand on each other.
    pub(super) multiplier: Option<u32>,
    /// `Standard`, `CeilingPlenum` or `FloorPlenum`.
    pub(super) story_type: Option<String>,
}

/// A length, or an object that asks the program to work it out (`Autocalculate`).
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum Length {
    /// In the units of the model.
    Given(f64),
    /// Any object.
    Automatic {},
}

impl Length {
    /// The length that is given.
    pub(super) fn given(length: Option<&Self>) -> Option<f64> {
        match length {
            Some(Self::Given(length)) => Some(*length),
            _ => None,
        }
    }
}

/// `Room2D` of dragonfly: a floor that is extruded.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Room2d {
    pub(super) identifier: String,
    pub(super) display_name: Option<String>,
    pub(super) floor_boundary: Vec<[f64; 2]>,
    pub(super) floor_holes: Option<Vec<Vec<[f64; 2]>>>,
    pub(super) floor_height: f64,
    pub(super) floor_to_ceiling_height: f64,
    pub(super) ceiling_plenum_depth: Option<f64>,
    pub(super) floor_plenum_depth: Option<f64>,
    /// One for each edge of the boundary, then for each edge of each hole; so are the next two.
    pub(super) boundary_conditions: Option<Vec<BoundaryCondition>>,
    pub(super) window_parameters: Option<Vec<Option<WindowParameters>>>,
    pub(super) air_boundaries: Option<Vec<bool>>,
    pub(super) properties: Option<Properties>,
}

/// `Ground`, `Outdoors`, `Adiabatic`, `OtherSideTemperature`, or `Surface`: then the objects behind, of which the last is the
/// room.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct BoundaryCondition {
    pub(super) boundary_condition_objects: Option<Vec<String>>,
}

impl BoundaryCondition {
    /// The room behind.
    pub(super) fn room(&self) -> Option<&String> {
        self.boundary_condition_objects.as_ref()?.last()
    }
}

/// The window parameters of dragonfly, of all kinds together: which keys there are depends on `type`.
#[derive(Debug, Default, Deserialize, JsonSchema)]
pub(super) struct WindowParameters {
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) width: Option<f64>,
    pub(super) height: Option<f64>,
    pub(super) sill_height: Option<f64>,
    pub(super) window_area: Option<f64>,
    pub(super) window_ratio: Option<f64>,
    pub(super) window_width: Option<f64>,
    pub(super) window_height: Option<f64>,
    pub(super) horizontal_separation: Option<f64>,
    pub(super) origins: Option<Vec<[f64; 2]>>,
    pub(super) widths: Option<Vec<f64>>,
    pub(super) heights: Option<Vec<f64>>,
    /// Corners in the plane of the wall, or in space where they have three numbers.
    pub(super) polygons: Option<Vec<Vec<Vec<f64>>>>,
    pub(super) are_doors: Option<Vec<bool>>,
}

/// The properties of a room for single programs.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Properties {
    pub(super) energy: Option<EnergyProperties>,
}

/// `Room2DEnergyPropertiesAbridged`, `RoomEnergyPropertiesAbridged`.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct EnergyProperties {
    pub(super) program_type: Option<String>,
}

impl Properties {
    /// The program of a room.
    pub(super) fn program(properties: Option<&Self>) -> Option<String> {
        properties?.energy.as_ref()?.program_type.clone()
    }
}

/// `Room` of honeybee: a body of faces.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Room {
    pub(super) identifier: String,
    pub(super) display_name: Option<String>,
    pub(super) faces: Vec<Face>,
    pub(super) story: Option<String>,
    pub(super) multiplier: Option<u32>,
    pub(super) properties: Option<Properties>,
}

/// `Face` of honeybee.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Face {
    /// `Floor`, `Wall`, `RoofCeiling` or `AirBoundary`.
    pub(super) face_type: String,
    pub(super) geometry: Face3d,
    pub(super) boundary_condition: Option<BoundaryCondition>,
    pub(super) apertures: Option<Vec<SubFace>>,
    pub(super) doors: Option<Vec<SubFace>>,
}

/// `Face3D`: a plane polygon in space.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Face3d {
    pub(super) boundary: Vec<[f64; 3]>,
    pub(super) holes: Option<Vec<Vec<[f64; 3]>>>,
}

/// `Aperture` or `Door` of honeybee.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct SubFace {
    pub(super) identifier: String,
    pub(super) geometry: Face3d,
}
