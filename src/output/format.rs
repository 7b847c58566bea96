//! The interface of an output format.

use super::options::LevelOptions;
use crate::catalog::Catalog;
use crate::scene::Scene;

/// A line of the table.
pub(crate) struct OutputFormat {
    /// The word of `--format`, and the extension of the file to open.
    pub(crate) name: &'static str,
    /// A description of its files, for `--help`.
    pub(crate) about: &'static str,
    /// Extensions of the files of a level, the one to open first. The files of a level are `<level>.<extension>`.
    pub(crate) extensions: &'static [&'static str],
    /// Whether its files hold images; where they do not, scenes have no textures and each material has its own colour.
    pub(crate) shows_textures: bool,
    /// Whether `audit`, `diff` and `edits` read its files again.
    pub(crate) is_read_back: bool,
    /// Begins a run.
    pub(crate) begin: for<'a> fn(&'a Catalog, &'a LevelOptions) -> Box<dyn Output + 'a>,
}

/// A format in a run: it may keep what several levels share. Many threads write levels at once.
pub(crate) trait Output: Sync {
    /// The files of a level.
    ///
    /// # Errors
    /// If the format cannot hold the level.
    fn level<'s>(&'s self, level: &LevelToWrite<'s>) -> Result<WrittenLevel<'s>, TooLarge>;

    /// Files over all levels, such as an index: those that levels refer to and have not given themselves. Called once, after
    /// the last level of the run.
    fn finish(&self) -> Vec<SharedFile<'_>> {
        Vec::new()
    }
}

/// A level on its way into files.
#[derive(Clone, Copy)]
pub(crate) struct LevelToWrite<'a> {
    /// The content of the level.
    pub(crate) scene: &'a Scene,
    /// `<building>/<level>` in the output folder, with `/`, without extension. Both names hold ASCII letters, digits and
    /// `. _ - % ~` only (`batch/file_name.rs`), so that files may refer to each other by them.
    pub(crate) path: &'a str,
}

impl<'a> LevelToWrite<'a> {
    /// The folder of its building in the output folder.
    pub(crate) fn folder(&self) -> &'a str {
        self.path.split_once('/').map_or("", |(folder, _)| folder)
    }
}

/// The files of a level.
#[derive(Default)]
pub(crate) struct WrittenLevel<'a> {
    /// Extension and content of each file, in the order of [`OutputFormat::extensions`].
    pub(crate) files: Vec<(&'static str, Vec<u8>)>,
    /// Files that it refers to and that other levels may refer to as well, sorted within each kind.
    pub(crate) shared: Vec<SharedFile<'a>>,
}

/// A file that several levels refer to. Equal paths have equal contents, in every process of a bake.
pub(crate) struct SharedFile<'a> {
    /// In the output folder, below a folder whose name begins with `shared-`.
    pub(crate) path: String,
    /// Makes its content; called once, by the first level that puts the file into place.
    pub(crate) content: Box<dyn Fn() -> Vec<u8> + 'a>,
}

/// A level that a format cannot hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TooLarge {
    /// Says how large it is and how large it may be.
    pub(crate) message: String,
    /// Advice for the user.
    pub(crate) hint: &'static str,
}
