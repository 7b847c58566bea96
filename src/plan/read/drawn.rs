//! Furniture that files draw: kept on request, and compared with what is arranged.

use crate::geometry::Point;

/// A piece of furniture in a plan, by the box around it.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPiece {
    /// Id of its building.
    pub building: String,
    /// Id of its level.
    pub level: String,
    /// The word of its format, under which `room_words.yaml` lists classes.
    pub format: &'static str,
    /// What it is, in a word of the format; empty if the format has none but the name.
    pub kind: String,
    /// As in the file.
    pub name: String,
    /// Middle of its box, in the level's frame.
    pub center: Point,
    /// Unit vector of its own x axis. Where the format says which side is the front, that is to the right of it.
    pub axis: Point,
    /// Metres along its own x and y.
    pub size: Point,
    /// Metres above the floor where it begins.
    pub bottom: f64,
}
