//! Parts of a map: what all three encodings of OpenStreetMap say.

use std::collections::BTreeMap;

use crate::geometry::Point;
use crate::plan::read::rings::Rings;

/// Values of `indoor` that make a space which one can be in.
pub(super) const SPACE_WORDS: [&str; 3] = ["room", "corridor", "area"];

/// Tags by key.
pub(super) type Tags = BTreeMap<String, String>;

/// An element of the map with tags.
#[derive(Debug)]
pub(super) struct Mapped {
    /// The id with a letter for its kind, as `w123`.
    pub(super) id: String,
    /// Where it is in the file, in the file's own measure.
    pub(super) place: u64,
    pub(super) tags: Tags,
    pub(super) shape: Shape,
}

/// Where an element is, in degrees of longitude and latitude.
#[derive(Debug)]
pub(super) enum Shape {
    Point(Point),
    Line(Vec<Point>),
    Areas(Vec<Rings>),
}

impl Mapped {
    /// The value of a key; none of an empty one.
    pub(super) fn tag(&self, key: &str) -> Option<&str> {
        self.tags.get(key).map(|value| value.trim()).filter(|value| !value.is_empty())
    }

    /// Whether it is a room, a corridor or an area, whatever its shape.
    pub(super) fn is_space(&self) -> bool {
        self.tag("indoor").is_some_and(|word| SPACE_WORDS.contains(&word))
    }

    /// Whether it is the outline of a building.
    pub(super) fn is_building(&self) -> bool {
        !self.is_space() && self.tag("building").is_some_and(|word| word != "no")
    }
}

/// Whether tags make an element that plans are made of, or that is counted.
pub(super) fn is_wanted(key: &str) -> bool {
    matches!(key, "indoor" | "building" | "door" | "entrance")
}
