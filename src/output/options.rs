//! The options that the files of a level depend on, besides plan, edits, catalogue and program.

use serde::Serialize;

use crate::best::DEFAULT_EFFORT;
use crate::compact::Instancing;
use crate::gltf::FlatNormals;
use crate::model::Detail;
use crate::plan::SiteOrigin;
use crate::scene::SceneOptions;
use crate::texture::TextureSize;

/// What a level's files depend on besides plan, edits, catalogue and program. Whether a level is up to date is told by a hash
/// of these fields as JSON, so that none can be forgotten.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LevelOptions {
    /// Seed of all rooms; another number gives other rooms. Default 1.
    pub seed: u64,
    /// Style or building style for rooms whose plan names none; default the catalogue's default style. One that the catalogue does
    /// not have counts as none: `Project::level_options_in` refuses it.
    pub style: Option<String>,
    /// How often a room is furnished at most until the audit finds nothing; default 16. More takes longer and leaves fewer
    /// findings (`docs/figures.md`, "Effort").
    pub effort: u32,
    /// Kind of file; default `.glb`.
    pub format: Format,
    /// Whether the levels of a building refer to shared files of furniture instead of carrying their own copies; default no.
    pub has_shared_library: bool,
    /// The textures of materials; default small ones inside each file.
    pub textures: TextureOptions,
    /// Whether flat faces without a texture have normals; default yes.
    pub flat_normals: FlatNormals,
    /// How finely furniture is modelled; default as the recipes draw it.
    pub detail: Detail,
    /// The options of levels beyond rooms and furniture.
    pub scene: SceneOptions,
    /// Whether equal models are instances where a format merges meshes; default by the extension of the graphics card.
    pub instancing: Instancing,
}

/// What the files over all levels depend on besides these (`--format tiles`).
#[derive(Clone, Debug, PartialEq)]
pub struct IndexOptions {
    /// Metres from which on boxes, reduced and full furniture are shown, falling; of a view 1080 pixels high in CesiumJS.
    pub near: [f64; 3],
    /// Where the site is on the earth; none where nobody says so.
    pub origin: Option<SiteOrigin>,
}

impl Default for IndexOptions {
    fn default() -> Self {
        Self { near: [70.0, 20.0, 4.0], origin: None }
    }
}

impl LevelOptions {
    /// The same, with images and models in files of their own.
    pub(crate) fn shared(self) -> Self {
        let textures = TextureOptions { are_shared: true, ..self.textures };
        Self { has_shared_library: true, textures, ..self }
    }
}

impl Default for LevelOptions {
    fn default() -> Self {
        Self {
            seed: 1,
            style: None,
            effort: DEFAULT_EFFORT,
            format: Format::default(),
            has_shared_library: false,
            textures: TextureOptions::default(),
            flat_normals: FlatNormals::default(),
            detail: Detail::default(),
            scene: SceneOptions::default(),
            instancing: Instancing::default(),
        }
    }
}

/// A format of output files, by its name; `Format::named` knows which there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Format(pub(super) &'static str);

impl Format {
    /// The word of `--format`, and the extension of the file to open.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.0
    }
}

/// Which textures there are, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct TextureOptions {
    /// Resolution of the textures; none leaves materials plain.
    pub size: Option<TextureSize>,
    /// Whether the images lie in one folder beside the levels of a building; else each file holds its own.
    pub are_shared: bool,
}

impl Default for TextureOptions {
    fn default() -> Self {
        Self { size: Some(TextureSize::Small), are_shared: false }
    }
}
