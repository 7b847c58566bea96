//! Which areas are buildings.

use crate::plan::read::footprint::facts::Tags;

/// Keys of areas that are something else, unless they are buildings too.
const OTHER_KEYS: [&str; 11] = [
    "landuse",
    "landcover",
    "natural",
    "waterway",
    "boundary",
    "admin_level",
    "highway",
    "area:highway",
    "railway",
    "barrier",
    "leisure",
];

/// The kind of an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The file says that it is a building.
    Building,
    /// The file says that it is a part of one.
    Part,
    /// The file does not say what it is.
    Unmarked,
    /// Something else, with a word for it.
    Other(&'static str),
}

/// The kinds of areas of a file.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FileKinds {
    marks: bool,
}

impl FileKinds {
    /// Takes note of a kind.
    pub(super) fn note(&mut self, kind: Kind) {
        self.marks |= kind == Kind::Building;
    }

    /// Whether the file says of some areas that they are buildings: then the others are none.
    pub(super) fn marks_buildings(self) -> bool {
        self.marks
    }
}

/// The word for areas of a file that marks buildings, and not these.
pub(super) fn undecided() -> &'static str {
    "areas without a mark of buildings"
}

/// The kind of an area by its tags.
pub(super) fn kind_of(tags: &Tags) -> Kind {
    let indoor = tags.text("indoor").unwrap_or_default();
    if matches!(indoor, "room" | "area" | "corridor" | "wall" | "level") {
        return Kind::Other("rooms");
    }
    // Of one that says both, the whole counts: whether it lies in another is found out later.
    if tags.says("building") {
        return Kind::Building;
    }
    if tags.says("building:part") || tags.says("buildingPart") {
        return Kind::Part;
    }
    if tags.get("building").is_some() {
        return Kind::Other("areas with building=no");
    }
    let named = tags.text("type").filter(|kind| !matches!(*kind, "multipolygon" | "way" | "relation"));
    match named.unwrap_or_default().to_ascii_lowercase().as_str() {
        "building" => Kind::Building,
        "building_part" | "buildingpart" => Kind::Part,
        "site" | "district system" | "region" => Kind::Other("areas of another type"),
        _ if tags.has_any(&OTHER_KEYS) => Kind::Other("areas of another kind"),
        _ => Kind::Unmarked,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::read::footprint::facts::TagValue;

    #[test]
    fn areas_are_buildings_by_their_tags() {
        let cases = [
            (("building", "house"), Kind::Building),
            (("building", "no"), Kind::Other("areas with building=no")),
            (("building:part", "yes"), Kind::Part),
            (("buildingPart", "yes"), Kind::Part),
            (("type", "Building"), Kind::Building),
            (("type", "District System"), Kind::Other("areas of another type")),
            (("landuse", "forest"), Kind::Other("areas of another kind")),
            (("indoor", "room"), Kind::Other("rooms")),
            (("height", "12"), Kind::Unmarked),
        ];
        for ((key, value), kind) in cases {
            let mut tags = Tags::default();
            tags.add(key, TagValue::Text(value.to_owned()));
            assert_eq!(kind_of(&tags), kind, "{key}={value}");
        }
    }
}
