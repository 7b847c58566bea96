//! The interface of an output format.

use super::options::{IndexOptions, LevelOptions};
use crate::catalog::Catalog;
use crate::model::Detail;
use crate::scene::{LevelBounds, Parts, Scene, SceneOptions};

/// A line of the table.
pub(crate) struct OutputFormat {
    /// The word of `--format`.
    pub(crate) name: &'static str,
    /// A description of its files, for `--help`.
    pub(crate) about: &'static str,
    /// Extensions of the files of a level, the one to open first; they may hold points. The files of a level are
    /// `<level>.<extension>`.
    pub(crate) extensions: &'static [&'static str],
    /// Whether its files hold images; where they do not, scenes have no textures and each material has its own colour.
    pub(crate) shows_textures: bool,
    /// Whether images lie in one folder for all buildings, whatever the user asks for.
    pub(crate) shares_all_images: bool,
    /// Whether there are files over all levels, of which [`super::INDEX_NAME`] is the one to open.
    pub(crate) has_index: bool,
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

    /// Files over all levels, as path in the output folder and content, the one to open first: [`super::INDEX_NAME`], and others in
    /// [`super::INDEX_FOLDER`]. Called when all levels of the plan are in place, whichever runs wrote them; sorted by building and level.
    fn index(&self, _levels: &[IndexedLevel], _options: &IndexOptions) -> IndexFiles {
        Vec::new()
    }
}

/// Files over all levels: path and content.
pub(crate) type IndexFiles = Vec<(String, Vec<u8>)>;

/// A level on its way into files.
#[derive(Clone, Copy)]
pub(crate) struct LevelToWrite<'a> {
    /// The content of the level.
    pub(crate) scene: &'a Scene,
    /// The same content in another look.
    pub(crate) shown: &'a dyn Fn(SceneLook) -> Scene,
    /// `<building>/<level>` in the output folder, with `/`, without extension. Both names hold ASCII letters, digits and
    /// `. _ - % ~` only (`batch/file_name.rs`), so that files may refer to each other by them.
    pub(crate) path: &'a str,
}

/// How the same rooms are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SceneLook {
    /// How finely furniture is modelled.
    pub(crate) detail: Detail,
    /// Whether materials are plain colours and every part has its own mesh.
    pub(crate) is_plain: bool,
}

impl SceneLook {
    /// The look that the user asks for.
    pub(crate) fn of(options: &LevelOptions) -> Self {
        Self { detail: options.detail, is_plain: false }
    }

    /// The options of a scene in this look.
    pub(crate) fn options(self, options: SceneOptions) -> SceneOptions {
        let parts = if self.is_plain { Parts::Separate } else { options.parts };
        SceneOptions { parts, ..options }
    }
}

/// A level that is in place, for an index.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct IndexedLevel {
    /// Building id.
    pub(crate) building: String,
    /// Level id.
    pub(crate) level: String,
    /// Where the building stands: metres east and north of the site's origin, and radians counter-clockwise.
    pub(crate) position: [f64; 2],
    pub(crate) turn: f64,
    /// The box around it; none where it shows nothing.
    pub(crate) bounds: Option<LevelBounds>,
    /// The text by which the source of its plan asks to be named.
    pub(crate) attribution: Option<String>,
    /// Its files in the output folder.
    pub(crate) paths: Vec<String>,
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
