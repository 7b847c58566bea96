//! What was typed.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use super::diff::ANY;
use super::exit::{AUDIT_EXIT_CODES, DIFF_EXIT_CODES, EXIT_CODES};
use crate::batch::Shard;
use crate::best::DEFAULT_EFFORT;
use crate::diff::{Kind, Tolerance};

/// Furnishes the rooms of building floor plans and writes one glTF file per floor.
///
/// Without a command, the built-in demo is baked into out/.
#[derive(Debug, Parser)]
#[command(version, after_help = EXIT_CODES, max_term_width = 100, subcommand_help_heading = "Commands")]
pub(crate) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    /// How to speak.
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// Options of all commands.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct Manner {
    /// Show errors only.
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,
    /// Print the result as JSON on stdout.
    #[arg(long, global = true)]
    pub(crate) json: bool,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Furnish plans and write one glTF file per level.
    #[command(after_help = EXIT_CODES)]
    Bake(BakeArguments),
    /// Read plans and configuration, report all faults, write nothing.
    #[command(after_help = EXIT_CODES)]
    Check(CheckArguments),
    /// Show what the catalogue holds.
    Catalog(CatalogArguments),
    /// Judge finished files: what is wrong with their rooms as they are now.
    #[command(after_help = AUDIT_EXIT_CODES)]
    Audit(AuditArguments),
    /// Tell what differs between two bakes or two files: rooms, furniture, openings, findings.
    #[command(after_help = DIFF_EXIT_CODES)]
    Diff(DiffArguments),
    /// Draw furnished levels as SVG.
    #[command(after_help = EXIT_CODES)]
    Draw(DrawArguments),
    /// Keep what you change by hand: moved, turned, added, removed, swapped and locked furniture, seeds of rooms.
    #[command(after_help = EXIT_CODES)]
    Edits {
        #[command(subcommand)]
        command: EditsCommand,
    },
    /// Tell why each object of a room is where it is, and why others are missing.
    #[command(after_help = EXIT_CODES)]
    Explain(ExplainArguments),
    /// Turn foreign plans into native ones.
    #[command(after_help = EXIT_CODES)]
    Import(ImportArguments),
    /// Join the records of several bakes in one folder into its manifest.
    #[command(after_help = EXIT_CODES)]
    Merge(MergeArguments),
}

/// The commands of `edits`. Each adds to the edits file and keeps what it says.
#[derive(Clone, Debug, Subcommand)]
pub(crate) enum EditsCommand {
    /// Write down what somebody changed in a floor, for example in Blender.
    Capture {
        /// The floor as it was baked.
        #[arg(value_name = "OLD")]
        old: PathBuf,
        /// The same floor, changed and exported again with its custom properties.
        #[arg(value_name = "EDITED")]
        edited: PathBuf,
        /// The edits file [default: BUILDING.edits.yaml in this folder].
        #[arg(long, value_name = "FILE")]
        edits: Option<PathBuf>,
        /// Further folders of configuration.
        #[arg(long, value_name = "DIR")]
        catalog: Vec<PathBuf>,
    },
    /// Keep furniture where it stands in a floor: the rest of the room is arranged around it.
    Lock {
        /// A floor that bake wrote, edited or not.
        #[arg(value_name = "FLOOR")]
        floor: PathBuf,
        /// Id of the room.
        #[arg(value_name = "ROOM")]
        room: String,
        /// Ids of the objects; all of the room if none is named.
        #[arg(value_name = "OBJECT")]
        objects: Vec<String>,
        /// The edits file [default: BUILDING.edits.yaml in this folder].
        #[arg(long, value_name = "FILE")]
        edits: Option<PathBuf>,
    },
    /// Give a room another seed, for this and all later bakes.
    Reroll {
        /// Its plan or project.
        #[arg(value_name = "PLAN")]
        plan: PathBuf,
        /// The room: [BUILDING/][LEVEL/]ROOM.
        #[arg(value_name = "ROOM")]
        room: String,
        /// This seed, not the next one.
        #[arg(long, value_name = "N")]
        to: Option<u64>,
        /// The edits file [default: NAME.edits.yaml beside the plan].
        #[arg(long, value_name = "FILE")]
        edits: Option<PathBuf>,
        /// Further folders of configuration.
        #[arg(long, value_name = "DIR")]
        catalog: Vec<PathBuf>,
    },
}

/// Where plans and configuration come from.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct SourceArguments {
    /// Plans, projects, folders or patterns; the built-in demo if there is none.
    #[arg(value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
    /// Further folders of configuration: classes/, rooms/, styles/, palettes/. May be repeated; later ones win.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) edits: EditArguments,
}

/// Which edits are made.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct EditArguments {
    /// Make the edits in this file too. May be repeated; later ones win. Those in NAME.edits.yaml beside a plan are made
    /// without it.
    #[arg(long = "edits", value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// Make no edits: every room as it is arranged.
    #[arg(long, conflicts_with = "files")]
    pub(crate) no_edits: bool,
}

/// What the furniture depends on.
#[derive(Clone, Debug, Args)]
pub(crate) struct FurnishArguments {
    /// Seed of all rooms; another number gives other rooms [default: the project's, or 1].
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Style of rooms whose plan names none [default: the project's, or `default`].
    #[arg(long, value_name = "NAME")]
    pub(crate) style: Option<String>,
    /// Furnish a room up to K times, until the audit finds nothing, and keep the best.
    #[arg(long, value_name = "K", default_value_t = DEFAULT_EFFORT, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) effort: u32,
}

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
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Folder that keeps painted surfaces and models between runs, or `none`; it may be deleted at any time. Never changes a
    /// byte of the output [default: roomwright/ in the system's folder for caches].
    #[arg(long, value_name = "DIR|none", env = "ROOMWRIGHT_CACHE", hide_env_values = true)]
    pub(crate) cache: Option<PathBuf>,
    /// Overwrite files that roomwright did not write, or that were changed since.
    #[arg(long)]
    pub(crate) force: bool,
    /// Kind of file.
    #[arg(long, value_enum, default_value = "glb")]
    pub(crate) format: FormatWord,
    /// Let floors refer to one library of furniture instead of carrying their own copies.
    #[arg(long)]
    pub(crate) shared_library: bool,
    /// How finely wood, cloth, tiles and other surfaces are painted: 512 or 1024 pixels a metre, or not at all.
    #[arg(long, value_enum, default_value = "small")]
    pub(crate) textures: TextureWord,
    /// Put the textures into each file; without it, all files share those in OUT/shared-textures.
    #[arg(long)]
    pub(crate) embed_textures: bool,
    /// Whether flat faces without textures have normals, or leave them to viewers, as the format allows, for almost half the
    /// space [default: implied with --textures none, else written].
    #[arg(long, value_enum)]
    pub(crate) flat_normals: Option<NormalsWord>,
    /// How finely furniture is modelled: as it is drawn, with about 30 % of the triangles, or as the boxes of its shape.
    #[arg(long, value_enum, default_value = "full")]
    pub(crate) detail: DetailWord,
    /// Leave out the lights of lamps (KHR_lights_punctual).
    #[arg(long)]
    pub(crate) no_lights: bool,
    /// How far doors on hinges stand open: 0 is shut [default: as far as the plan lets them].
    #[arg(long, value_name = "DEGREES", value_parser = clap::value_parser!(u16).range(0..=180))]
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
    /// How to show progress on stderr.
    #[arg(long, value_enum, default_value = "auto")]
    pub(crate) progress: ProgressWord,
}

/// `check`.
#[derive(Clone, Debug, Args)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    /// Style of rooms whose plan names none, as for `bake`.
    #[arg(long, value_name = "NAME")]
    pub(crate) style: Option<String>,
}

/// `audit`.
#[derive(Clone, Debug, Args)]
pub(crate) struct AuditArguments {
    /// Files that bake wrote (.glb, .gltf), edited or not, or folders with such files.
    #[arg(value_name = "PATH", default_value = "out")]
    pub(crate) paths: Vec<PathBuf>,
    /// Further folders of configuration, as for the bake: classes, and thresholds in audit.yaml.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Show every finding, not the first of them only.
    #[arg(long)]
    pub(crate) all: bool,
}

/// `diff`.
#[derive(Clone, Debug, Args)]
pub(crate) struct DiffArguments {
    /// Before: a folder that bake wrote, or one .glb or .gltf file.
    #[arg(value_name = "OLD")]
    pub(crate) old: PathBuf,
    /// After.
    #[arg(value_name = "NEW")]
    pub(crate) new: PathBuf,
    /// Further folders of configuration, for the findings of edited files and for pictures.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Exit with 1 if there is a difference of one of these kinds; `any` is all but seed, renumbered, settings, bytes.
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_parser = kind_words())]
    pub(crate) fail_on: Vec<String>,
    /// Metres up to which a thing has not moved, grown or shrunk.
    #[arg(long, value_name = "METRES", default_value_t = Tolerance::default().metres, value_parser = parse_tolerance)]
    pub(crate) move_tolerance: f64,
    /// Degrees up to which a thing has not turned.
    #[arg(long, value_name = "DEGREES", default_value_t = Tolerance::default().degrees, value_parser = parse_tolerance)]
    pub(crate) turn_tolerance: f64,
    /// Read every file: do not take one of the recorded length that is older than its manifest for what was recorded.
    #[arg(long)]
    pub(crate) verify: bool,
    /// Print Markdown, for a comment on a pull request.
    #[arg(long, conflicts_with = "json")]
    pub(crate) markdown: bool,
    /// Bytes of Markdown at most; what does not fit is counted. GitHub takes 65,536 characters.
    #[arg(long, value_name = "BYTES", default_value_t = 60_000, requires = "markdown")]
    pub(crate) markdown_limit: usize,
    /// Write one page with pictures of the changed rooms, before and after, that needs nothing else.
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Rooms that the page shows at most.
    #[arg(long, value_name = "N", default_value_t = 100, requires = "html")]
    pub(crate) html_rooms: usize,
    /// Write pictures of the changed rooms into this folder, before and after.
    #[arg(long, value_name = "DIR")]
    pub(crate) svg: Option<PathBuf>,
    /// Show every difference, not the first of them only.
    #[arg(long)]
    pub(crate) all: bool,
    /// Overwrite existing files.
    #[arg(long)]
    pub(crate) force: bool,
}

/// `catalog`.
#[derive(Clone, Debug, Args)]
pub(crate) struct CatalogArguments {
    /// What to list: classes, rooms, styles or palettes; or an id, to see all about it.
    #[arg(value_name = "PART|ID")]
    pub(crate) what: Option<String>,
    /// One entry of that part, in full.
    #[arg(value_name = "ID")]
    pub(crate) id: Option<String>,
    /// Further folders of configuration.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Write everything as a page with a picture of each room type: catalogue.md and catalogue/ in this folder.
    #[arg(long, value_name = "DIR", conflicts_with = "what")]
    pub(crate) docs: Option<PathBuf>,
    /// Overwrite existing files.
    #[arg(long, requires = "docs")]
    pub(crate) force: bool,
}

/// `import`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ImportArguments {
    /// Foreign plans.
    #[arg(value_name = "PATH", required = true)]
    pub(crate) paths: Vec<PathBuf>,
    /// File (one building) or folder to write into.
    #[arg(short, long, value_name = "DIR|FILE")]
    pub(crate) out: PathBuf,
    /// Overwrite existing files.
    #[arg(long)]
    pub(crate) force: bool,
    /// Further folders of configuration, for their room words.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
}

/// `draw`.
#[derive(Clone, Debug, Args)]
pub(crate) struct DrawArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Draw this building only.
    #[arg(long, value_name = "ID")]
    pub(crate) building: Option<String>,
    /// Draw this level only.
    #[arg(long, value_name = "ID")]
    pub(crate) level: Option<String>,
    /// File (`.svg`, one level) or folder to write into; stdout if one level is drawn and none is given.
    #[arg(short, long, value_name = "FILE|DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Show the clearances that furniture and doors need.
    #[arg(long)]
    pub(crate) clearances: bool,
    /// Draw all levels of a building on one sheet, from below to above.
    #[arg(long)]
    pub(crate) sheet: bool,
    /// Mark what the audit finds in the plan, numbered and coloured by severity, and list it below.
    #[arg(long)]
    pub(crate) findings: bool,
    /// Overwrite existing files.
    #[arg(long)]
    pub(crate) force: bool,
}

/// `explain`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ExplainArguments {
    /// A plan, project or folder of plans.
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// The room: [BUILDING/][LEVEL/]ROOM, or its name.
    #[arg(value_name = "ROOM")]
    pub(crate) room: String,
    /// Building of the room, where several have one of that id.
    #[arg(long, value_name = "ID")]
    pub(crate) building: Option<String>,
    /// Level of the room, where several have one of that id.
    #[arg(long, value_name = "ID")]
    pub(crate) level: Option<String>,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Further folders of configuration.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) edits: EditArguments,
}

/// `merge`.
#[derive(Clone, Debug, Args)]
pub(crate) struct MergeArguments {
    /// The output folder.
    #[arg(value_name = "DIR", default_value = "out")]
    pub(crate) folder: PathBuf,
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

/// Kinds of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FormatWord {
    /// One binary file per level.
    Glb,
    /// A JSON file and a binary one beside it.
    Gltf,
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

/// Parts of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CatalogWord {
    /// Pieces of furniture.
    Classes,
    /// Room types.
    Rooms,
    /// Styles.
    Styles,
    /// Sets of materials.
    Palettes,
}

fn parse_shard(text: &str) -> Result<Shard, String> {
    let numbers =
        text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
    let (index, count) = numbers.ok_or("write it as I/N, for example 2/8")?;
    Shard::new(index, count).ok_or_else(|| format!("shares are counted from 1 to {count}"))
}

/// The words of `--fail-on`.
fn kind_words() -> clap::builder::PossibleValuesParser {
    Kind::ALL.into_iter().map(Kind::name).chain([ANY]).collect::<Vec<_>>().into()
}

fn parse_tolerance(text: &str) -> Result<f64, String> {
    let number: Option<f64> = text.parse().ok();
    number.filter(|number| (0.0..1e6).contains(number)).ok_or_else(|| "give a number from 0 on".to_owned())
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_definition_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn shards_are_counted_from_one() {
        assert!(parse_shard("2/8").is_ok());
        for wrong in ["0/8", "9/8", "2", "a/b", "1/0", "-1/2"] {
            assert!(parse_shard(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn options_of_all_commands_stand_anywhere() {
        for line in [["roomwright", "--json", "merge"], ["roomwright", "merge", "--json"]] {
            assert!(Arguments::try_parse_from(line).unwrap().manner.json);
        }
    }
}
