//! The structure of native plans for writing; the counterpart of `read/native/file.rs`.

use serde::{Serialize, Serializer};
use serde_saphyr::{FlowMap, FlowSeq};

use crate::geometry::{Point, Polygon};

/// Steps of a metre that lengths are rounded to.
pub(super) const ROUNDING: f64 = 1e5;
/// Largest number of which all whole neighbours exist.
const LARGEST_WHOLE: f64 = 9e15;

/// A length or angle, rounded, whole ones without a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Number(pub(super) f64);

impl Number {
    pub(super) fn rounded(self) -> f64 {
        // Adding zero makes negative zero zero.
        (self.0 * ROUNDING).round() / ROUNDING + 0.0
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rounded = self.rounded();
        if rounded.fract() == 0.0 && rounded.abs() < LARGEST_WHOLE {
            return serializer.serialize_i64(rounded as i64);
        }
        serializer.serialize_f64(rounded)
    }
}

/// `[x, y]`.
pub(super) type OutPoint = FlowSeq<[Number; 2]>;

/// Written on one line.
pub(super) fn point(point: Point) -> OutPoint {
    FlowSeq([Number(point.x), Number(point.y)])
}

/// Corners on one line.
pub(super) fn ring(polygon: &Polygon) -> FlowSeq<Vec<OutPoint>> {
    FlowSeq(polygon.corners().iter().map(|corner| point(*corner)).collect())
}

#[derive(Serialize)]
pub(super) struct OutPlan {
    pub(super) version: u32,
    pub(super) id: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) name: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) attribution: Option<String>,
    pub(super) walls: FlowMap<OutWalls>,
    pub(super) levels: Vec<OutLevel>,
}

#[derive(Serialize)]
pub(super) struct OutWalls {
    pub(super) exterior: Number,
}

#[derive(Serialize)]
pub(super) struct OutLevel {
    pub(super) id: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) name: Option<String>,
    pub(super) elevation: Number,
    pub(super) height: Number,
    pub(super) rooms: Vec<OutRoom>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) openings: Vec<FlowMap<OutOpening>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) columns: Vec<FlowMap<OutColumn>>,
}

#[derive(Serialize)]
pub(super) struct OutRoom {
    pub(super) id: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) name: Option<String>,
    #[serde(rename = "type")]
    pub(super) room_type: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) style: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) dwelling: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) household: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) number: Option<u32>,
    pub(super) height: Number,
    pub(super) outline: FlowSeq<Vec<OutPoint>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) holes: Vec<FlowSeq<Vec<OutPoint>>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) walls: Vec<FlowMap<OutWall>>,
}

#[derive(Serialize)]
pub(super) struct OutWall {
    pub(super) edge: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) tags: Vec<String>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) railing: bool,
}

#[derive(Serialize)]
pub(super) struct OutOpening {
    pub(super) id: String,
    pub(super) kind: &'static str,
    pub(super) at: OutPoint,
    pub(super) along: OutPoint,
    pub(super) rooms: FlowSeq<Vec<String>>,
    pub(super) width: Number,
    pub(super) sill: Number,
    pub(super) head: Number,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) hinge: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) opens_into: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) leaves: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) swing: Option<Number>,
}

#[derive(Serialize)]
pub(super) struct OutColumn {
    pub(super) outline: FlowSeq<Vec<OutPoint>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) height: Option<Number>,
}
