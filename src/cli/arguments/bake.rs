//! `bake`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::number::whole_number;
use super::{FurnishArguments, SourceArguments};
use crate::batch::Shard;

/// `bake`.
#[derive(Clone, Debug, Args)]
pub(crate) struct BakeArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Folder to write into.
    #[arg(short, long, value_name = "DIR", default_value = "out")]
    pub(crate) out: PathBuf,
    /// Threads to work with [default: one per core]. Never changes a byte of the output.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<u16>(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Folder that keeps painted surfaces and models between runs, and notes where plans lie, or `none`; it may be deleted at any time. Never changes a
    /// byte of the output [default: roomwright/ in the system's folder for caches].
    #[arg(long, value_name = "DIR|none", env = "ROOMWRIGHT_CACHE", hide_env_values = true)]
    pub(crate) cache: Option<PathBuf>,
    /// Overwrite files that roomwright did not write, or that were changed since.
    #[arg(long)]
    pub(crate) force: bool,
    /// Remove what earlier bakes left in the folder: files of levels and buildings that the plans no longer have, and shared files
    /// that no level uses. What somebody changed stays.
    #[arg(long)]
    pub(crate) prune: bool,
    /// Kind of file.
    #[arg(long, value_enum, default_value = "glb")]
    pub(crate) format: FormatWord,
    /// Keep furniture once a building, in shared-geometry/ beside its floors, a file for each model in use, instead of once in
    /// each file.
    #[arg(long)]
    pub(crate) shared_library: bool,
    /// How finely wood, cloth, tiles and other surfaces are painted: 512 or 1024 pixels a metre, or not at all.
    #[arg(long, value_enum, default_value = "small")]
    pub(crate) textures: TextureWord,
    /// Keep textures once a building, in shared-textures/ beside its floors, instead of once in each file.
    #[arg(long)]
    pub(crate) shared_textures: bool,
    /// Whether flat faces without textures have normals, or leave them to viewers, as the format allows, for almost half the
    /// space [default: implied with --textures none, else written].
    #[arg(long, value_enum)]
    pub(crate) flat_normals: Option<NormalsWord>,
    /// How finely furniture is modelled: as it is drawn, with about 30 % of the triangles, or as the boxes of its shape.
    #[arg(long, value_enum, default_value = "full")]
    pub(crate) detail: DetailWord,
    /// How lamps are lit: their shades shine, which looks right in all viewers as they are; each is a light in candelas too
    /// (KHR_lights_punctual), for viewers that are set to such light and can draw many; or not at all.
    #[arg(long, value_enum, default_value = "shining")]
    pub(crate) lights: LightsWord,
    /// Few meshes, which viewers draw in half the time: one for the walls of a room and what is fixed to them, plain parts of a
    /// piece of furniture in one; or a mesh for every part and a material for every slot of the palette.
    #[arg(long, value_enum, default_value = "merged")]
    pub(crate) parts: PartsWord,
    /// How far doors on hinges stand open: 0 is shut [default: as far as the plan lets them].
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, value_parser = whole_number::<u16>(0..=180))]
    pub(crate) door_angle: Option<u16>,
    /// Let viewers choose among all palettes (KHR_materials_variants).
    #[arg(long)]
    pub(crate) variants: bool,
    /// Draw another seed for this room, for this run: [BUILDING/][LEVEL/]ROOM. Repeated for a room, it goes on to the next.
    #[arg(long, value_name = "ROOM")]
    pub(crate) reroll: Vec<String>,
    /// Bake share I of N, so that N machines can split the work.
    #[arg(long, value_name = "I/N", value_parser = parse_shard)]
    pub(crate) shard: Option<Shard>,
    /// Bake again whenever a plan, an edits file or a file of the configuration changes, until Ctrl-C.
    #[arg(long, requires = "paths")]
    pub(crate) watch: bool,
    /// How to show progress on stderr.
    #[arg(long, value_enum, default_value = "auto")]
    pub(crate) progress: ProgressWord,
}

/// The words of `--lights`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LightsWord {
    /// Shades shine.
    Shining,
    /// Lights in candelas as well.
    Physical,
    /// Neither.
    None,
}

/// The words of `--parts`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PartsWord {
    /// Few meshes.
    Merged,
    /// One for every part.
    Separate,
}

/// Kinds of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FormatWord {
    /// One binary file per level.
    Glb,
    /// A JSON file and a binary one beside it.
    Gltf,
}

/// The words of `--textures`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TextureWord {
    /// Plain colours.
    None,
    /// 512 pixels a metre.
    Small,
    /// 1024 pixels a metre.
    Large,
}

/// The words of `--flat-normals`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NormalsWord {
    /// Every viewer draws them.
    Written,
    /// Viewers compute them.
    Implied,
}

/// The words of `--detail`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DetailWord {
    /// Everything that is drawn.
    Full,
    /// About 30 % of the triangles, for rooms seen from afar.
    Reduced,
    /// Boxes and cylinders, for rooms seen through windows.
    Boxes,
}

/// Kinds of progress reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ProgressWord {
    /// A bar on a terminal, plain lines elsewhere.
    Auto,
    /// A bar.
    Bar,
    /// A line every few seconds.
    Plain,
    /// A JSON object per line and level.
    Json,
    /// Nothing.
    None,
}

fn parse_shard(text: &str) -> Result<Shard, String> {
    let numbers =
        text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
    let (index, count) = numbers.ok_or("write it as I/N, for example 2/8")?;
    Shard::new(index, count).ok_or_else(|| format!("shares are counted from 1 to {count}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_are_counted_from_one() {
        assert!(parse_shard("2/8").is_ok());
        for wrong in ["0/8", "9/8", "2", "a/b", "1/0", "-1/2"] {
            assert!(parse_shard(wrong).is_err(), "{wrong}");
        }
    }
}
