//! The drawing of a floor: lines, holes and items in pixels of the scanned plan.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::geometry::Point;
use crate::plan::units::CENTIMETRE;

/// A drawing; keys that the plan does not need are not listed.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Drawing {
    /// Square centimetres per square pixel.
    pub(crate) scale: f64,
    /// Always one, named `layer-1`.
    pub(crate) layers: BTreeMap<String, Layer>,
}

/// One layer of a drawing; everything by id.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Layer {
    #[serde(default)]
    pub(crate) lines: BTreeMap<String, Line>,
    #[serde(default)]
    pub(crate) holes: BTreeMap<String, Hole>,
    #[serde(default)]
    pub(crate) items: BTreeMap<String, Item>,
}

/// Rings of corners in pixels.
pub(crate) type Rings = Vec<Vec<[f64; 2]>>;

/// A wall, railing, separator or column.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Line {
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) coordinates: Rings,
}

/// A door or window.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Hole {
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) coordinates: Rings,
    pub(crate) door_sweeping_points: Option<Sweep>,
    pub(crate) properties: Option<HoleProperties>,
}

/// The two ends of a leaf's swing, in pixels.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Sweep {
    /// The hinge.
    pub(crate) angle_point: [f64; 2],
    /// The leaf's tip when shut.
    pub(crate) closed_point: [f64; 2],
    /// The leaf's tip when open.
    pub(crate) opened_point: [f64; 2],
}

/// The properties of a hole.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct HoleProperties {
    pub(crate) heights: Option<HoleHeights>,
}

/// Sill and head in centimetres.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct HoleHeights {
    pub(crate) lower_edge: Option<f64>,
    pub(crate) upper_edge: Option<f64>,
}

/// A fixture: kitchen block, bathtub, stairs.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Item {
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) x: f64,
    pub(crate) y: f64,
    /// Degrees counter-clockwise.
    #[serde(default)]
    pub(crate) rotation: f64,
    pub(crate) properties: ItemProperties,
}

/// The sizes of an item along its own x and y.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct ItemProperties {
    pub(crate) width: Measure,
    pub(crate) length: Measure,
}

/// A length with its unit, which is always centimetres.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Measure {
    pub(crate) value: f64,
}

/// A fixture as the architect drew it: what furnishing can be compared with.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fixture {
    /// The format's word: `toilet`, `kitchen`, ...
    pub(crate) kind: String,
    /// Middle, in the level's frame.
    pub(crate) center: Point,
    /// Metres along its own x and y.
    pub(crate) size: Point,
    /// Radians counter-clockwise; the axis only, the front may be on either side.
    pub(crate) rotation: f64,
}

impl Drawing {
    /// All lines, by layer and id.
    pub(crate) fn lines(&self) -> impl Iterator<Item = &Line> {
        self.layers.values().flat_map(|layer| layer.lines.values())
    }

    /// All holes with their ids, by layer and id.
    pub(crate) fn holes(&self) -> impl Iterator<Item = (&String, &Hole)> {
        self.layers.values().flat_map(|layer| layer.holes.iter())
    }

    /// All fixtures, by layer and id, at this many metres per pixel.
    pub(crate) fn fixtures(&self, pixel: f64) -> Vec<Fixture> {
        let items = self.layers.values().flat_map(|layer| layer.items.values());
        items
            .map(|item| Fixture {
                kind: item.kind.clone(),
                center: Point::new(item.x, item.y) * pixel,
                size: Point::new(item.properties.width.value, item.properties.length.value) * CENTIMETRE,
                rotation: item.rotation.to_radians(),
            })
            .collect()
    }
}

/// The outer ring in metres; nothing for a line without corners.
pub(crate) fn outer_ring(rings: &Rings, pixel: f64) -> Vec<Point> {
    rings.first().map(|ring| ring.iter().map(|&corner| metres(corner, pixel)).collect()).unwrap_or_default()
}

/// A pixel position in metres.
pub(crate) fn metres(corner: [f64; 2], pixel: f64) -> Point {
    Point::from_array(corner) * pixel
}
