//! The arguments of `audit` and `diff`.

use std::path::PathBuf;

use clap::Args;

use super::number::{degrees, metres, whole_number};
use crate::cli::diff::ANY;
use crate::diff::{Kind, Tolerance};

/// `audit`.
#[derive(Clone, Debug, Args)]
pub(crate) struct AuditArguments {
    /// Files that bake wrote (.glb, .gltf), edited or not, or folders with such files.
    #[arg(value_name = "PATH", default_value = "out")]
    pub(crate) paths: Vec<PathBuf>,
    /// Further folders of configuration, the same as for the bake: classes, and thresholds in audit.yaml.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Show all findings, not only the first ones.
    #[arg(long)]
    pub(crate) all: bool,
}

/// `diff`.
#[derive(Clone, Debug, Args)]
pub(crate) struct DiffArguments {
    /// Before: a folder that bake wrote, or one .glb or .gltf file.
    #[arg(value_name = "OLD")]
    pub(crate) old: PathBuf,
    /// After: a folder or a file, too.
    #[arg(value_name = "NEW")]
    pub(crate) new: PathBuf,
    /// Further folders of configuration, for the findings of edited files and for pictures.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Exit with 1 if there is a difference of one of these kinds; `any` is all but seed, renumbered, settings, bytes.
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_parser = kind_words())]
    pub(crate) fail_on: Vec<String>,
    /// Largest difference of places and sizes, in metres, that is not reported.
    #[arg(long, value_name = "METRES", default_value_t = Tolerance::default().metres, allow_negative_numbers = true, value_parser = metres)]
    pub(crate) move_tolerance: f64,
    /// Largest difference of turns, in degrees, that is not reported.
    #[arg(long, value_name = "DEGREES", default_value_t = Tolerance::default().degrees, allow_negative_numbers = true, value_parser = degrees)]
    pub(crate) turn_tolerance: f64,
    /// Read every file. Without this, a file older than its manifest, and of the recorded length, counts as unchanged.
    #[arg(long)]
    pub(crate) verify: bool,
    /// Print Markdown, for a comment on a pull request.
    #[arg(long, conflicts_with = "json")]
    pub(crate) markdown: bool,
    /// Bytes of Markdown at most; differences that do not fit are counted. GitHub takes 65,536 characters.
    #[arg(long, value_name = "BYTES", default_value_t = 60_000, requires = "markdown", value_parser = whole_number::<usize>(0..=u64::MAX))]
    pub(crate) markdown_limit: usize,
    /// Write one HTML page with pictures of the changed rooms, before and after; it needs no other file.
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Number of rooms that the page shows at most.
    #[arg(long, value_name = "N", default_value_t = 100, requires = "html", value_parser = whole_number::<usize>(0..=u64::MAX))]
    pub(crate) html_rooms: usize,
    /// Write pictures of the changed rooms into this folder, before and after.
    #[arg(long, value_name = "DIR")]
    pub(crate) svg: Option<PathBuf>,
    /// Show all differences, not only the first ones.
    #[arg(long)]
    pub(crate) all: bool,
    /// Overwrite existing files.
    #[arg(long)]
    pub(crate) force: bool,
}

/// The words of `--fail-on`.
fn kind_words() -> clap::builder::PossibleValuesParser {
    Kind::ALL.into_iter().map(Kind::name).chain([ANY]).collect::<Vec<_>>().into()
}
