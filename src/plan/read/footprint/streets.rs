//! Which lines are streets: fronts of buildings are found by them.

use super::facts::Tags;

/// Streets of OpenStreetMap. Ways of walkers alone are none: they run through courtyards too.
const STREETS: [&str; 15] = [
    "motorway",
    "trunk",
    "primary",
    "secondary",
    "tertiary",
    "unclassified",
    "residential",
    "living_street",
    "pedestrian",
    "service",
    "road",
    "primary_link",
    "secondary_link",
    "tertiary_link",
    "trunk_link",
];

/// Whether a line is a street above the ground.
pub(super) fn is_street(tags: &Tags) -> bool {
    let is_street = tags.text("highway").is_some_and(|highway| STREETS.contains(&highway));
    is_street && !tags.says("tunnel") && !tags.says("area")
}
