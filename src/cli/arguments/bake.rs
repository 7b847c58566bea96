//! The arguments of `bake`.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use super::number::whole_number;
use super::path::path_or_nothing;
use super::{FurnishArguments, SourceArguments};
use crate::batch::Shard;
use crate::output::{Format, OUTPUTS};

/// What all commands that write levels have in common.
#[derive(Clone, Debug, Args)]
pub(crate) struct RunArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Number of threads [default: one per core]. Does not change the output.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<u16>(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Folder that keeps textures and models between runs, and the places of plans, or `none`. It may be deleted at any time and
    /// does not change the output [default: roomwright/ in the system's folder for caches].
    #[arg(long, value_name = "DIR|none", env = "ROOMWRIGHT_CACHE", hide_env_values = true, value_parser = path_or_nothing())]
    pub(crate) cache: Option<PathBuf>,
    /// Overwrite files that roomwright did not write, or that were changed since.
    #[arg(long)]
    pub(crate) force: bool,
    /// Remove files of earlier bakes from the folder: those of levels and buildings that the plans no longer have, and shared
    /// files that no level uses. Files that were changed since stay.
    #[arg(long)]
    pub(crate) prune: bool,
    /// Resolution of the textures of wood, cloth, tiles and other surfaces.
    #[arg(long, value_enum, default_value = "small")]
    pub(crate) textures: TextureWord,
    /// How far doors on hinges stand open; 0 is shut [default: as far as the plan allows].
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, value_parser = whole_number::<u16>(0..=180))]
    pub(crate) door_angle: Option<u16>,
    /// Use the next seed for this room, in this run: [BUILDING/][LEVEL/]ROOM. May be repeated, also for the same room.
    #[arg(long, value_name = "ROOM")]
    pub(crate) reroll: Vec<String>,
    /// Bake share I of N, so that N machines can split the work; then join their records with `merge`.
    #[arg(long, value_name = "I/N", value_parser = parse_shard)]
    pub(crate) shard: Option<Shard>,
    /// Bake the levels of this list as share I of N, whatever else would be dealt to it. The list is what --list-levels --json
    /// prints, or a part of it.
    #[arg(long, value_name = "FILE", requires = "shard")]
    pub(crate) only_levels: Option<PathBuf>,
    /// List the levels with their rooms by type and the hash of their inputs; bake nothing. With --json as one document.
    #[arg(long, conflicts_with_all = ["shard", "only_levels"])]
    pub(crate) list_levels: bool,
    /// How to show progress on stderr.
    #[arg(long, value_enum, default_value = "auto")]
    pub(crate) progress: ProgressWord,
}

/// `bake`.
#[derive(Clone, Debug, Args)]
pub(crate) struct BakeArguments {
    #[command(flatten)]
    pub(crate) run: RunArguments,
    /// Folder to write into.
    #[arg(short, long, value_name = "DIR", default_value = "out")]
    pub(crate) out: PathBuf,
    /// Format of the files.
    #[arg(long, value_parser = formats(), default_value = Format::default().name())]
    pub(crate) format: Format,
    /// Write each model once per building, into shared-geometry/ beside its levels, instead of into each level.
    #[arg(long)]
    pub(crate) shared_library: bool,
    /// Write textures once per building, into shared-textures/ beside its levels, instead of into each level.
    #[arg(long)]
    pub(crate) shared_textures: bool,
    /// Whether files hold the normals of flat faces without textures. Without them, files are almost half as large, and viewers
    /// compute the normals [default: implied with --textures none, else written].
    #[arg(long, value_enum)]
    pub(crate) flat_normals: Option<NormalsWord>,
    /// Level of detail of the furniture.
    #[arg(long, value_enum, default_value = "full")]
    pub(crate) detail: DetailWord,
    /// How lamps give light.
    #[arg(long, value_enum, default_value = "shining")]
    pub(crate) lights: LightsWord,
    /// Whether parts share meshes, which viewers draw in half the time, or stay separate.
    #[arg(long, value_enum, default_value = "merged")]
    pub(crate) parts: PartsWord,
    /// Write all palettes, for viewers to choose one (KHR_materials_variants).
    #[arg(long)]
    pub(crate) variants: bool,
    /// For whom the files are: `web` is for clients in browsers, with few draw calls and lights. Programs that edit levels, such as
    /// Blender, lose furniture from it.
    #[arg(long, value_enum, default_value = "any", conflicts_with_all = ["format", "shared_library", "flat_normals", "parts", "variants"])]
    pub(crate) profile: ProfileWord,
    /// Bake again after every change to a plan, an edits file or the configuration, until Ctrl-C.
    #[arg(long, requires = "paths")]
    pub(crate) watch: bool,
}

/// The words of `--lights`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LightsWord {
    /// Shades of lamps emit light; looks right in all viewers at their default settings.
    Shining,
    /// Each lamp is a light in candelas as well (KHR_lights_punctual), for renderers with an exposure.
    Physical,
    /// Shades do not emit light, and the file has no lights.
    None,
}

/// The words of `--profile`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ProfileWord {
    /// Every part is a node.
    Any,
    /// Parts are merged by material, and equal furniture is drawn as instances (EXT_mesh_gpu_instancing).
    Web,
}

/// The words of `--parts`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PartsWord {
    /// One mesh for the walls of a room, and few for each object.
    Merged,
    /// A mesh for every part, and a material for every slot of the palette.
    Separate,
}

/// The words of `--format`: the table of formats.
fn formats() -> impl TypedValueParser<Value = Format> {
    let words = OUTPUTS.iter().map(|output| PossibleValue::new(output.name).help(output.about));
    PossibleValuesParser::new(words).map(|name| Format::named(&name).expect("the word is of the table"))
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
    /// Files hold the normals; every viewer shows the faces well.
    Written,
    /// Viewers compute the normals; some draw the faces unlit or round.
    Implied,
}

/// The words of `--detail`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DetailWord {
    /// Complete models.
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
    /// A line with a JSON object for each level.
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
