//! The table of output formats.

use std::ffi::OsStr;
use std::path::Path;

use super::format::OutputFormat;
use super::options::Format;
use crate::{gltf, tiles};

/// All formats; the first is the default.
pub(crate) const OUTPUTS: &[OutputFormat] = &[gltf::GLB, gltf::GLTF, tiles::TILES];

/// The line of a format.
pub(crate) fn output_format(format: Format) -> &'static OutputFormat {
    let line = OUTPUTS.iter().find(|line| line.name == format.name());
    line.expect("a format is made from a line of the table")
}

/// Whether a path ends as the file to open of a format that is read back.
pub(crate) fn is_read_back(path: &Path) -> bool {
    let is_of = |line: &OutputFormat| {
        let ending = path.extension().and_then(OsStr::to_str);
        line.is_read_back && ending.is_some_and(|ending| ending.eq_ignore_ascii_case(line.name))
    };
    OUTPUTS.iter().any(is_of)
}

impl Format {
    /// The format of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        OUTPUTS.iter().find(|line| line.name == name).map(|line| Self(line.name))
    }
}

impl Default for Format {
    fn default() -> Self {
        Self(OUTPUTS[0].name)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn formats_are_known_by_their_names_and_levels_end_as_they_say() {
        let names: BTreeSet<&str> = OUTPUTS.iter().map(|line| line.name).collect();
        assert_eq!(names.len(), OUTPUTS.len());
        for line in OUTPUTS {
            let format = Format::named(line.name).unwrap();
            assert_eq!((format.name(), output_format(format).name), (line.name, line.name));
            assert!(!line.is_read_back || line.extensions[0] == line.name);
        }
        assert_eq!(Format::named("no-format"), None);
    }
}
