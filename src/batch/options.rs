//! What the caller of a bake chooses.

use crate::best::DEFAULT_EFFORT;
use crate::cache::Cache;
use crate::gltf::FlatNormals;
use crate::model::Detail;
use crate::scene::SceneOptions;
use crate::texture::TextureSize;

/// What a bake depends on besides plan and catalogue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BakeOptions {
    /// Seed of all rooms; another number gives other rooms. Default 1.
    pub seed: u64,
    /// Style for rooms whose plan names none; default the catalogue's default style.
    pub style: Option<String>,
    /// How often a room is furnished at most until the audit finds nothing; default [`DEFAULT_EFFORT`].
    pub effort: u32,
    /// Kind of file; default `.glb`.
    pub format: Format,
    /// Whether the floors of a building refer to shared files of furniture instead of carrying their own copies; default no.
    pub has_shared_library: bool,
    /// The textures of materials; default small ones inside each file.
    pub textures: TextureOptions,
    /// Whether flat faces that nothing is painted on have normals; default yes.
    pub flat_normals: FlatNormals,
    /// How finely furniture is modelled; default as the recipes draw it.
    pub detail: Detail,
    /// What levels show beyond rooms and furniture.
    pub scene: SceneOptions,
    /// Threads; more bake faster and hold more floors in memory. Never changes a byte. Default 1.
    pub threads: usize,
    /// The share of the levels to bake; default all.
    pub shard: Option<Shard>,
    /// What becomes of levels in the output folder that the plan does not have; default listed apart.
    pub unplanned: Unplanned,
    /// Where painted surfaces are kept between runs; default nowhere. Never changes a byte.
    pub cache: Option<Cache>,
}

impl Default for BakeOptions {
    fn default() -> Self {
        Self {
            seed: 1,
            style: None,
            effort: DEFAULT_EFFORT,
            format: Format::Glb,
            has_shared_library: false,
            textures: TextureOptions::default(),
            flat_normals: FlatNormals::default(),
            detail: Detail::Full,
            scene: SceneOptions::default(),
            threads: 1,
            shard: None,
            unplanned: Unplanned::default(),
            cache: None,
        }
    }
}

/// The kinds of output files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// One binary file per level.
    Glb,
    /// A `.gltf` in JSON and a `.bin` beside it.
    Gltf,
}

impl Format {
    /// The word on the command line, and the extension of the file to open.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Glb => "glb",
            Self::Gltf => "gltf",
        }
    }
}

/// Which textures there are, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextureOptions {
    /// How finely surfaces are painted; none leaves materials plain.
    pub size: Option<TextureSize>,
    /// Whether the images lie in one folder beside the floors of a building; else each file holds its own.
    pub are_shared: bool,
}

impl Default for TextureOptions {
    fn default() -> Self {
        Self { size: Some(TextureSize::Small), are_shared: false }
    }
}

/// One of several shares of the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    index: u32,
    /// Of how many; at least `index`.
    count: u32,
}

impl Shard {
    /// The share `index` of `count`, counted from 1; `None` if there is no such share.
    #[must_use]
    pub fn new(index: u32, count: u32) -> Option<Self> {
        (1..=count).contains(&index).then_some(Self { index, count })
    }

    /// Whether a job belongs to the share. Jobs are dealt like cards, so that every share gets levels of
    /// every building.
    pub(crate) fn takes(self, job: usize) -> bool {
        job % self.count as usize == (self.index - 1) as usize
    }

    /// The file that keeps the share's records until all are there.
    pub(crate) fn part_name(self) -> String {
        format!("manifest.{}-of-{}.json", self.index, self.count)
    }
}

/// What becomes of levels in the output folder that the plan does not have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unplanned {
    /// They stay listed as they are: part of the plan could not be read, so that nobody knows what it has.
    Listed,
    /// Their files stay, and the manifest lists them apart.
    #[default]
    SetApart,
    /// Their files are removed where nobody changed them.
    Removed,
}
