//! The list of formats that are read, for people.

use schemars::JsonSchema;
use serde::Serialize;

/// A format that plans are read in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ReadFormat {
    /// The word in `room_words.yaml`; `native` and `project` have none there.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// The file or folder to name.
    pub input: &'static str,
    /// The parts of it that are read, and those that are not.
    pub content: &'static str,
}

/// All formats that are read.
pub const READ_FORMATS: &[ReadFormat] = &[
    ReadFormat {
        name: "native",
        title: "native YAML or JSON",
        input: "a file with the key `levels`; its edits lie beside it in <name>.edits.yaml",
        content: "everything; the schema is configs/schema/plan.schema.json",
    },
    ReadFormat {
        name: "project",
        title: "projects",
        input: "a file with the key `project`",
        content: "plans of any format, placed many times; the schema is configs/schema/project.schema.json",
    },
    ReadFormat {
        name: super::archilyse::NAME,
        title: "react-planner drawings with areas",
        input: "plan_N.json with areas_plan_N.json beside it or in ../areas; or a folder with \
                react_planner_projects.json, areas.json and floors.json",
        content: "areas, walls, railings, columns, doors and how they open, windows, flats; no furniture",
    },
    ReadFormat {
        name: super::imdf::NAME,
        title: "IMDF",
        input: "a folder with building.geojson, level.geojson and unit.geojson; opening, anchor and occupant where they are",
        content: "units and openings of all levels that have a building; the format has no windows and no heights",
    },
    ReadFormat {
        name: super::ifc::NAME,
        title: "IFC",
        input: "an .ifc file of IFC2X3, IFC4 or IFC4X3 in the STEP encoding",
        content: "spaces, doors and how they open, windows, columns; no bodies with curved faces, roof windows or curtain walls",
    },
];

#[cfg(test)]
mod tests {
    use super::super::readers::FOREIGN_FORMATS;
    use super::*;

    #[test]
    fn every_reader_is_in_the_table() {
        for format in FOREIGN_FORMATS {
            assert!(READ_FORMATS.iter().any(|known| known.name == format.name), "{}", format.name);
        }
    }
}
