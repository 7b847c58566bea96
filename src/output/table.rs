//! The table of output formats.

use std::ffi::OsStr;
use std::path::Path;

use super::format::OutputFormat;
use super::options::Format;
use crate::{compact, gltf, tiles};

/// All formats; the first is the default.
pub(crate) const OUTPUTS: &[OutputFormat] = &[gltf::GLB, gltf::GLTF, compact::WEB, tiles::TILES];

/// The line of a format.
pub(crate) fn output_format(format: Format) -> &'static OutputFormat {
    let line = OUTPUTS.iter().find(|line| line.name == format.name());
    line.expect("a format is made from a line of the table")
}

/// Whether a path ends as the file to open of a format that is read back.
pub(crate) fn is_read_back(path: &Path) -> bool {
    let Some(name) = path.file_name().and_then(OsStr::to_str).map(str::to_ascii_lowercase) else {
        return false;
    };
    let ends_with = |extension: &str| name.strip_suffix(extension).is_some_and(|stem| stem.ends_with('.'));
    let is_of = |line: &OutputFormat| line.is_read_back && ends_with(line.extensions[0]);
    // `.full.glb` ends with `.glb`, too.
    let is_of_longer = |extension: &&str| extension.contains('.') && ends_with(extension);
    let mut others = OUTPUTS.iter().filter(|line| !line.is_read_back).flat_map(|line| line.extensions);
    OUTPUTS.iter().any(is_of) && !others.any(is_of_longer)
}

/// Whether the files of a level are those of a format with files over all levels.
pub(crate) fn has_index(paths: &[&str]) -> bool {
    let ends_with = |(path, extension): (&&str, &&str)| {
        path.strip_suffix(extension).is_some_and(|stem| stem.ends_with('.'))
    };
    OUTPUTS
        .iter()
        .filter(|line| line.has_index && line.extensions.len() == paths.len())
        .any(|line| paths.iter().zip(line.extensions).all(ends_with))
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
    fn levels_are_told_from_tiles_by_their_endings() {
        let is_read = |path: &str| is_read_back(Path::new(path));
        assert!(is_read("out/a/1.glb") && is_read("1.GLTF") && is_read("full.glb") && is_read("a.b.glb"));
        assert!(
            !is_read("tiles/a/1.full.glb") && !is_read("1.boxes.GLB") && !is_read("1.bin") && !is_read("glb")
        );
    }

    #[test]
    fn levels_of_an_index_are_told_by_all_their_files() {
        assert!(has_index(&["a/1.full.glb", "a/1.reduced.glb", "a/1.boxes.glb"]));
        assert!(!has_index(&["a/1.full.glb"]) && !has_index(&["a/1.gltf", "a/1.bin"]) && !has_index(&[]));
    }

    #[test]
    fn formats_are_known_by_their_names_and_levels_end_as_they_say() {
        let names: BTreeSet<&str> = OUTPUTS.iter().map(|line| line.name).collect();
        assert_eq!(names.len(), OUTPUTS.len());
        for line in OUTPUTS {
            let format = Format::named(line.name).unwrap();
            assert_eq!((format.name(), output_format(format).name), (line.name, line.name));
            assert!(!line.extensions.is_empty());
        }
        assert_eq!(Format::named("no-format"), None);
    }
}
