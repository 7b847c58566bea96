//! Lists the levels of an output folder from its manifest, for commands that read a bake and write nothing.

use std::path::Path;

use super::manifest::MANIFEST_NAME;
use super::sources::Sources;
use crate::document::Faults;

/// The levels that a manifest lists.
#[derive(Clone, Debug, Default)]
pub(crate) struct Listing {
    /// The file to open of each level, relative to the folder, in the order of building and level. Levels that are set apart
    /// are none of them.
    pub(crate) files: Vec<String>,
    /// Records that cannot be believed.
    pub(crate) faults: Faults,
}

/// Whether a folder holds a finished bake.
pub(crate) fn is_bake(folder: &Path) -> bool {
    folder.join(MANIFEST_NAME).is_file()
}

/// The levels that the manifest of a folder lists; `None` without a manifest of this program.
pub(crate) fn list_levels(folder: &Path) -> Option<Listing> {
    let manifest = folder.join(MANIFEST_NAME);
    manifest.symlink_metadata().ok()?;
    let sources = Sources::read(&[manifest], &[]).ok()?;
    let contents = sources.contents(false).ok()?;
    let main_files = contents.current().filter_map(|(_, found)| Some(found.head.files.first()?.path.clone()));
    let files = main_files.collect();
    Some(Listing { files, faults: contents.faults })
}
