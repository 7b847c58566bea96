//! The drawing of a floor: lines, holes and items in pixels of the scanned plan.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::geometry::Point;
use crate::plan::units::CENTIMETRE;

/// A drawing; keys that the plan does not need are not listed.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Drawing {
    /// Square centimetres per square pixel.
    pub(super) scale: f64,
    /// Always one, named `layer-1`.
    pub(super) layers: BTreeMap<String, Layer>,
}

/// One layer of a drawing; everything by id.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Layer {
    #[serde(default)]
    pub(super) lines: BTreeMap<String, Line>,
    #[serde(default)]
    pub(super) holes: BTreeMap<String, Hole>,
    #[serde(default)]
    pub(super) items: BTreeMap<String, Item>,
}

/// Rings of corners in pixels.
pub(super) type Rings = Vec<Vec<[f64; 2]>>;

/// A wall, railing, separator or column.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Line {
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) coordinates: Rings,
}

/// A door or window.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Hole {
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) coordinates: Rings,
    pub(super) door_sweeping_points: Option<Sweep>,
    pub(super) properties: Option<HoleProperties>,
}

/// The two ends of a leaf's swing, in pixels.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Sweep {
    /// The hinge.
    pub(super) angle_point: [f64; 2],
    /// The leaf's tip when shut.
    pub(super) closed_point: [f64; 2],
    /// The leaf's tip when open.
    pub(super) opened_point: [f64; 2],
}

/// The properties of a hole.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct HoleProperties {
    pub(super) heights: Option<HoleHeights>,
}

/// Sill and head in centimetres.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct HoleHeights {
    pub(super) lower_edge: Option<f64>,
    pub(super) upper_edge: Option<f64>,
}

/// A fixture: kitchen block, bathtub, stairs.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Item {
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) x: f64,
    pub(super) y: f64,
    /// Degrees counter-clockwise.
    #[serde(default)]
    pub(super) rotation: f64,
    pub(super) properties: ItemProperties,
}

/// The sizes of an item along its own x and y.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct ItemProperties {
    pub(super) width: Measure,
    pub(super) length: Measure,
}

/// A length with its unit, which is always centimetres.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Measure {
    pub(super) value: f64,
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
    pub(super) fn lines(&self) -> impl Iterator<Item = &Line> {
        self.layers.values().flat_map(|layer| layer.lines.values())
    }

    /// All holes with their ids, by layer and id.
    pub(super) fn holes(&self) -> impl Iterator<Item = (&String, &Hole)> {
        self.layers.values().flat_map(|layer| layer.holes.iter())
    }

    /// All fixtures, by layer and id, at this many metres per pixel.
    pub(super) fn fixtures(&self, pixel: f64) -> Vec<Fixture> {
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
pub(super) fn outer_ring(rings: &Rings, pixel: f64) -> Vec<Point> {
    rings.first().map(|ring| ring.iter().map(|&corner| metres(corner, pixel)).collect()).unwrap_or_default()
}

/// A pixel position in metres.
pub(super) fn metres(corner: [f64; 2], pixel: f64) -> Point {
    Point::from_array(corner) * pixel
}
